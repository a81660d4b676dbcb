"""Kernels: programs turned into code that runs over many poses; a mechanism compiled for them."""

from linkwright.kernels import numpy_blocks  # noqa: F401  (registers itself)
from linkwright.kernels.compiled import Compiled, compile_mechanism, examine
from linkwright.kernels.registry import KERNELS, Kernel

__all__ = ["KERNELS", "Compiled", "Kernel", "compile_mechanism", "examine"]
