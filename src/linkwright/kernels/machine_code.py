"""Machine code of functions in LLVM's intermediate language, made in milliseconds and kept nowhere."""

from __future__ import annotations

import ctypes
import threading
from collections.abc import Callable, Sequence
from functools import cache
from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright._machine import needed
from linkwright.data_classes import dataclass
from linkwright.kernels.llvm_code import LlvmCode

Array = NDArray[np.float64]

EFFORT = 2
"""LLVM's level of effort in choosing instructions and registers."""
LINE = 64
"""Bytes of a line of the cache, to which arrays of a block are aligned."""
_LOCK = threading.Lock()
"""LLVM reads and compiles for one thread at a time."""


@dataclass(frozen=True)
class Machine:
    """What texts and code depend on: the lanes of a vector, whether pointers are typed (LLVM before 17), the processor
    and its features as LLVM names them."""

    width: int
    typed: bool
    processor: str
    features: str

    def code(self, width: int | None = None) -> LlvmCode:
        """Code over vectors, or over so many lanes."""
        return LlvmCode(width or self.width, self.typed)


def available() -> bool:
    """Whether LLVM is installed; nothing is imported to find out."""
    return find_spec("llvmlite") is not None


@cache
def this_machine() -> Machine:
    """This machine, with the widest vectors that its processor adds in one instruction."""
    binding = _binding()
    features = binding.get_host_cpu_features()
    width = next((width for name, width in (("avx512f", 8), ("avx", 4)) if features.get(name)), 2)
    typed = binding.llvm_version_info[0] < 17
    return Machine(width, typed, binding.get_host_cpu_name(), features.flatten())


class MachineCode:
    """The function ``run`` of a text; ``address`` is a C function of its ``arguments``: pointers (true), whole numbers.

    Calling it lets other threads run meanwhile.
    """

    def __init__(self, text: str, arguments: Sequence[bool], machine: Machine) -> None:
        binding = _binding()
        with _LOCK:
            target = binding.Target.from_triple(binding.get_process_triple()).create_target_machine(
                cpu=machine.processor, features=machine.features, opt=EFFORT, jit=True
            )
            # An engine owns the target machine it is made with, and must live as long as the code.
            self._engine = binding.create_mcjit_compiler(binding.parse_assembly(text), target)
            self._engine.finalize_object()
            self.address: int = self._engine.get_function_address("run")
        kinds = [ctypes.c_void_p if pointer else ctypes.c_int64 for pointer in arguments]
        self._function: Callable[..., None] = ctypes.CFUNCTYPE(None, *kinds)(self.address)

    def call(self, *arguments: int) -> None:
        """Run it. Whoever holds this method holds the engine, too: code that nobody else keeps, as where two threads
        made it at once, must not go while it runs."""
        self._function(*arguments)


def aligned(count: int) -> Array:
    """Room for so many numbers, from the start of a line of the cache."""
    room = np.empty(count + LINE // 8)
    first = -room.ctypes.data % LINE // 8
    return room[first : first + count]


@cache
def _binding() -> Any:
    """LLVM, ready to compile for this machine."""
    binding = needed("llvmlite.binding", "fast")
    if binding.llvm_version_info[0] < 17:  # later ones do it themselves, and refuse
        binding.initialize()
    binding.initialize_native_target()
    binding.initialize_native_asmprinter()
    return binding
