"""The kernels by name: each turns a program into code that runs over arrays of poses."""

from __future__ import annotations

from typing import ClassVar, Protocol

import numpy as np
from numpy.typing import NDArray

from linkwright.graph.program import Program
from linkwright.notation.registry import Registry

Array = NDArray[np.float64]


class Kernel(Protocol):
    """What every emitter gives. A kernel runs on one thread, lets others run meanwhile, and may be called from several.

    The figures of a pose don't depend on how many others are computed with it, to the last bit.
    """

    name: ClassVar[str]
    scales: ClassVar[bool]
    """Whether several threads are sooner done than one."""
    packages: ClassVar[tuple[str, ...]]
    """Those besides NumPy that compile or run it: the bits of results depend on their versions."""
    program: Program

    def __init__(self, program: Program) -> None:
        """Raises :class:`ModelError` where a package that the kernel needs isn't installed."""

    @classmethod
    def available(cls) -> bool:
        """Whether the packages that the kernel needs are installed; nothing is imported to find out."""

    def run(self, x: Array, p: Array, out: Array | None = None) -> Array:
        """All outputs at all poses, (outputs, poses), in SI: from the per-pose inputs x (inputs, poses) and the
        parameters p, (parameters,) or (parameters, poses)."""

    def over(self, x: Array, p: Array, out: Array | None = None) -> Array:
        """All outputs of all samples at all poses, (outputs, samples, poses), in SI: from inputs x that samples share,
        (inputs, poses), or have each, (inputs, samples, poses), and parameters p (parameters, samples)."""


KERNELS: Registry[type[Kernel]] = Registry(
    {
        "jax": "linkwright.kernels.jax_kernel",
        "llvm": "linkwright.kernels.llvm_kernel",
        "numpy": "linkwright.kernels.numpy_blocks",
    }
)


def register(cls: type[Kernel]) -> type[Kernel]:
    """Register a kernel under its name; a second one of the same name is an error."""
    KERNELS[cls.name] = cls
    return cls


def flattened(kernel: Kernel, x: Array, p: Array, out: Array, block: int) -> Array:
    """What ``over`` gives, by ``run`` over all pairs of samples and poses, some ``block`` of them at a time."""
    samples, poses = out.shape[1:]
    step = max(1, block // max(poses, 1))
    for first in range(0, samples, step):
        some = slice(first, first + step)
        count = min(step, samples - first)
        inputs = np.tile(x, count) if x.ndim == 2 else x[:, some]
        parameters = np.repeat(p[:, some], poses, axis=1)
        out[:, some] = kernel.run(inputs.reshape(len(x), -1), parameters).reshape(len(out), count, poses)
    return out
