"""The Numba emitter: programs compiled to machine code, kept for the next process."""

from __future__ import annotations

import threading
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from types import ModuleType
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from linkwright._machine import needed
from linkwright.graph.program import Program
from linkwright.kernels import code_cache
from linkwright.kernels.numba_source import KernelSource
from linkwright.kernels.registry import flattened, register

Array = NDArray[np.float64]

FEW = 48
"""Fewer poses than this leave most lanes of a block empty: samples and poses are run over as one list then."""
PAST = 1 << 22
"""Outputs of so many bytes and more, far over what a core's cache holds, are stored past it."""
ALIGNED = 64
_LOCK = threading.Lock()


@register
class NumbaKernel:
    """Runs a program as machine code. Each form of it (see :data:`numba_source.FORMS`) is compiled when first asked
    for, which takes seconds, or loaded from the cache."""

    name: ClassVar[str] = "numba"
    packages: ClassVar[tuple[str, ...]] = ("numba", "llvmlite")
    scales: ClassVar[bool] = True

    def __init__(self, program: Program) -> None:
        needed("numba", "fast")
        self.program = program
        self._forms: dict[str, Any] = {}

    @classmethod
    def available(cls) -> bool:
        return find_spec("numba") is not None

    def compiled(self, form: str) -> Any:
        """The machine code of a form."""
        if form not in self._forms:
            with _LOCK:
                if form not in self._forms:
                    self._forms[form] = _module(str(KernelSource.fitting(self.program, form))).run
        return self._forms[form]

    def is_cached(self, form: str = "apart") -> bool:
        """Whether a form is at hand without compiling."""
        return form in self._forms or code_cache.is_cached(str(KernelSource.fitting(self.program, form)), _about())

    def run(self, x: Array, p: Array, out: Array | None = None) -> Array:
        poses = x.shape[1]
        if out is None:
            out = np.empty((len(self.program.outputs), poses))
        self._call("apart" if p.ndim == 1 else "each", x[:, None], p if p.ndim == 2 else p[:, None], out[:, None])
        return out

    def over(self, x: Array, p: Array, out: Array | None = None) -> Array:
        poses = x.shape[-1]
        if out is None:
            out = np.empty((len(self.program.outputs), p.shape[1], poses))
        if poses < FEW:
            return flattened(self, x, p, out, 1 << 13)
        self._call("over" if x.ndim == 2 else "apart", x[:, None] if x.ndim == 2 else x, p, out)
        return out

    def _call(self, form: str, x: Array, p: Array, out: Array) -> None:
        """Run a form over inputs (inputs, samples or 1, poses), parameters (parameters, columns), outputs (outputs,
        samples, poses)."""
        samples, poses = out.shape[1:]
        if not out.size:
            return
        written = out if _even(out) else np.empty(out.shape)
        (xs, (xr, xq)), (ps, (pr,)), (ws, (wr, wq)) = _flat(x), _flat(p), _flat(written)
        past, lead = False, 0
        if written.nbytes >= PAST:
            ahead = -written.ctypes.data % ALIGNED // 8
            even = wr % 8 == 0 and (samples == 1 or (wq % 8 == 0 and not ahead))
            past, lead = even, ahead if even and samples == 1 else 0
        self.compiled(form)(xs, xr, xq, ps, pr, ws, wr, wq, samples, poses, lead, past)
        if written is not out:
            out[...] = written


def _even(array: Array) -> bool:
    """Whether the last axis is without gaps and the others can be counted in whole numbers."""
    return array.dtype == np.float64 and array.strides[-1] == 8 and all(s >= 0 and s % 8 == 0 for s in array.strides)


def _flat(array: Array) -> tuple[Array, tuple[int, ...]]:
    """An array's numbers in one row, and the steps in it along all axes but the last."""
    if not _even(array):
        array = np.ascontiguousarray(array, dtype=np.float64)
    length = 1 + sum((n - 1) * s // 8 for n, s in zip(array.shape, array.strides, strict=True)) if array.size else 0
    flat = np.lib.stride_tricks.as_strided(array, (length,), (8,))
    return flat, tuple(s // 8 for s in array.strides[:-1])


@cache
def _about() -> str:
    """What machine code depends on besides its source: the compiler, the processor, the stores that it calls."""
    import llvmlite
    import numba
    from llvmlite import binding

    stream = Path(__file__).with_name("nontemporal_stores.py").read_text(encoding="utf-8")
    cpu = f"{binding.get_host_cpu_name()} {binding.get_host_cpu_features().flatten()}"
    return "\0".join([numba.__version__, llvmlite.__version__, cpu, stream])


def _module(source: str) -> ModuleType:
    return code_cache.load(source, _about(), _read)


def _read(source: str, path: Path | None, name: str) -> ModuleType:
    """The module of a source; Numba keeps its machine code beside it, whatever folder the user has set for others."""
    import numba

    told, numba.config.CACHE_DIR = numba.config.CACHE_DIR, ""
    try:
        return code_cache.module_at(source, path, name)
    finally:
        numba.config.CACHE_DIR = told
