"""Which kernel a piece of work is given, and why: the one that should be done first, what it costs to compile included.

A choice depends on the size of the work and on what is installed, not on what happens to be compiled already, so that
a study gives the same figures when it is run again.
"""

from __future__ import annotations

from dataclasses import dataclass

from linkwright.findings import Term
from linkwright.graph.program import Program
from linkwright.kernels.registry import KERNELS

NUMPY = 0.45e-9
"""Seconds of an instruction at a pose, by NumPy over blocks (docs/performance.md, as the next two)."""
NUMBA = 0.06e-9
"""The same of machine code on one thread."""
START, COMPILE = 1.5, 5e-3
"""Seconds to load the compiler, and of an instruction to be compiled."""


@dataclass(frozen=True)
class KernelChoice:
    """A kernel's name and why it was chosen: the key of a phrase of the catalogue, with its data.

    ``poses`` counts samples times poses; ``instructions`` are those of the program.
    """

    kernel: str
    poses: int
    instructions: int
    key: str = "kernel-small"

    @property
    def reason(self) -> Term:
        """Why."""
        return Term(self.key, kernel=self.kernel, poses=f"{self.poses:.4g}", instructions=self.instructions)


def choose(program: Program, poses: int, workers: int = 1, wish: str = "auto") -> KernelChoice:
    """The kernel for a program at so many poses on so many threads; ``wish`` names one that is asked for.

    Raises :class:`ModelError` where the one asked for needs a package that isn't installed.
    """
    size = program.size
    if wish != "auto":
        KERNELS[wish](program)
        return KernelChoice(wish, poses, size, "kernel-wished")
    plain = NUMPY * size * poses
    compiled = START + COMPILE * size + NUMBA * size * poses / max(workers, 1)
    if plain <= compiled:
        return KernelChoice("numpy", poses, size)
    if not KERNELS["numba"].available():
        return KernelChoice("numpy", poses, size, "kernel-missing")
    return KernelChoice("numba", poses, size, "kernel-large")
