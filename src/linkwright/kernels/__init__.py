"""Kernels: programs turned into code that runs over many poses; a mechanism compiled for them."""

from linkwright.kernels import numpy_blocks  # noqa: F401  (registers itself)
from linkwright.kernels.compiled import Compiled, Prepared, compile_mechanism, examine, prepare
from linkwright.kernels.registry import KERNELS, Kernel

__all__ = ["KERNELS", "Compiled", "Kernel", "Prepared", "compile_mechanism", "examine", "prepare"]
