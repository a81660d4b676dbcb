"""The LLVM emitter: programs as machine code, made in some ten milliseconds and kept nowhere."""

from __future__ import annotations

from dataclasses import replace
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from linkwright.graph.program import Program
from linkwright.kernels.llvm_entries import ARGUMENTS, room, text
from linkwright.kernels.llvm_source import KernelSource
from linkwright.kernels.machine_code import LINE, Machine, MachineCode, aligned, available, this_machine
from linkwright.kernels.registry import flattened, register

Array = NDArray[np.float64]

FEW = 48
"""Fewer poses than this leave most lanes of a block empty: samples and poses are run over as one list then."""
PAST = 1 << 22
"""Outputs of so many bytes and more, far over what a core's cache holds, are stored past it."""


@register
class LlvmKernel:
    """Runs a program as machine code. Each form (see :data:`division.FORMS`) is compiled when first asked for."""

    name: ClassVar[str] = "llvm"
    packages: ClassVar[tuple[str, ...]] = ("llvmlite",)
    scales: ClassVar[bool] = True

    def __init__(self, program: Program, machine: Machine | None = None) -> None:
        self.program, self.machine = program, machine or this_machine()
        self._forms: dict[str, tuple[KernelSource, MachineCode]] = {}

    def __reduce__(self) -> tuple[type[LlvmKernel], tuple[Program]]:
        return LlvmKernel, (self.program,)

    @classmethod
    def available(cls) -> bool:
        return available()

    def form(self, form: str) -> tuple[KernelSource, MachineCode]:
        """A form's text and machine code."""
        if form not in self._forms:
            source = KernelSource.fitting(self.program, form, self.machine)
            self._forms[form] = source, MachineCode(text(source), [*ARGUMENTS.values()], self.machine)
        return self._forms[form]

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
        x, p = (array if _even(array) else np.ascontiguousarray(array, dtype=np.float64) for array in (x, p))
        (xr, xq), (pr,), (wr, wq) = (tuple(s // 8 for s in array.strides[:-1]) for array in (x, p, written))
        # Samples that take turns in a block can't keep parts of lines from one block to the next.
        past = written.nbytes >= PAST and (
            form != "over" or not any(n % LINE for n in (written.ctypes.data, 8 * wr, 8 * wq))
        )
        source, compiled = self.form(form)
        rows = aligned(room(source))
        scalars = np.empty((samples, max(source.scalars.count, 1)))
        places = [array.ctypes.data for array in (x, p, written, rows, scalars)]
        compiled.call(
            places[0], xr, xq if x.shape[1] > 1 else 0, places[1], pr, places[2], wr, wq, samples, poses, past,
            *places[3:],
        )  # fmt: skip
        if written is not out:
            out[...] = written


class PoseFunction:
    """A program at one pose as a C function, ``void run(double *x, double *p, double *out, double *room)``: for
    integrators and optimisers, which call it at ``address`` without Python. ``room`` holds so many numbers.

    Its figures are those of the kernel, to the last bit.
    """

    def __init__(self, program: Program, machine: Machine | None = None) -> None:
        machine = replace(machine or this_machine(), width=1)
        source = KernelSource(program, "apart", machine, lanes=1)
        self._code = MachineCode(text(source), [True] * 4, machine)
        self.address, self.outputs = self._code.address, len(program.outputs)
        self.room = source.rows.count + source.scalars.count
        self._scratch = np.empty(self.room)

    def __call__(self, x: Array, p: Array) -> Array:
        """The outputs (outputs,) from inputs (inputs,) and parameters (parameters,), in SI; one thread at a time."""
        out = np.empty(self.outputs)
        x, p = (np.ascontiguousarray(array, dtype=np.float64) for array in (x, p))
        self._code.call(*(array.ctypes.data for array in (x, p, out, self._scratch)))
        return out


def _even(array: Array) -> bool:
    """Whether the last axis is without gaps and the others can be counted in whole numbers."""
    return array.dtype == np.float64 and array.strides[-1] == 8 and all(s >= 0 and s % 8 == 0 for s in array.strides)
