"""Kernels: programs turned into code that runs over many poses; a compiled mechanism, which asks them."""

from linkwright.kernels.compiled import Compiled
from linkwright.kernels.registry import KERNELS, Kernel

__all__ = ["KERNELS", "Compiled", "Kernel"]
