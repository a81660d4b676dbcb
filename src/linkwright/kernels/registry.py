"""The kernels by name: each turns a program into code that runs over arrays of poses."""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from linkwright.graph.program import Program
from linkwright.notation.registry import Registry

Array = NDArray[np.float64]


class Kernel(Protocol):
    """What every emitter gives: ``run`` over poses."""

    name: str

    def __init__(self, program: Program) -> None: ...

    def run(self, x: Array, p: Array, out: Array | None = None) -> Array:
        """All outputs (rows) at all poses (columns) from the per-pose inputs x and the parameters p, in SI."""


KERNELS: Registry[type[Kernel]] = Registry()


def register(cls: type[Kernel]) -> type[Kernel]:
    """Register a kernel under its name; a second one of the same name is an error."""
    KERNELS[cls.name] = cls
    return cls
