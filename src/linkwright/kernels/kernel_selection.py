"""Which kernel a piece of work is given, and why: machine code from some size of the work on.

A choice depends on the size of the work and on what is installed, so that a study gives the same figures when it is run
again.
"""

from __future__ import annotations

from linkwright.data_classes import dataclass
from linkwright.findings import Term
from linkwright.graph.program import Program
from linkwright.kernels.registry import KERNELS

LARGE = 4e8
"""Instructions times poses from which compiling, some tenth of a second with LLVM's own start, takes less time than it
saves (docs/performance.md)."""


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


def choose(program: Program, poses: int, wish: str = "auto") -> KernelChoice:
    """The kernel for a program at so many poses; ``wish`` names one that is asked for.

    Raises :class:`ModelError` where the one asked for needs a package that isn't installed.
    """
    if wish != "auto":
        KERNELS[wish](program)
        return KernelChoice(wish, poses, program.size, "kernel-wished")
    if program.size * poses < LARGE:
        return KernelChoice("numpy", poses, program.size)
    from linkwright.kernels import machine_code

    if not machine_code.available():
        return KernelChoice("numpy", poses, program.size, "kernel-missing")
    return KernelChoice("llvm", poses, program.size, "kernel-large")
