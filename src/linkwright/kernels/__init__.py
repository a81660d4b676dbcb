"""Kernels: programs turned into code that runs over many poses; a mechanism compiled for them."""

from linkwright.kernels import jax_kernel, numba_kernel, numpy_blocks  # noqa: F401  (register themselves)
from linkwright.kernels.compiled import Compiled, Prepared, compile_mechanism, examine, prepare
from linkwright.kernels.registry import KERNELS, Kernel
from linkwright.kernels.still import Still, examine_still

__all__ = [
    "KERNELS",
    "Compiled",
    "Kernel",
    "Prepared",
    "Still",
    "compile_mechanism",
    "examine",
    "examine_still",
    "prepare",
]
