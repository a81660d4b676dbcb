"""The compiled twin of the moments' tally: one pass, no lock held, the same bits as the plain one.

A vector of poses is taken through the samples of a strip, one after the other; nothing is fused or reordered.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import numpy as np
from numpy.typing import NDArray

from linkwright.kernels.machine_code import Machine, MachineCode, this_machine

STRIP = 1 << 13
"""Values of a strip, which is gone through while it is in the cache."""
STATE = {
    "count": False,
    "missing": False,
    "shift": True,
    "sum": True,
    "square": True,
    "least": True,
    "least_at": False,
    "largest": True,
    "largest_at": False,
}
"""The arrays of a tally, by name: numbers, or whole numbers."""


def add(y: NDArray[np.float64], first: int, state: Sequence[NDArray[np.float64] | NDArray[np.int64]]) -> None:
    """Count in ``y`` (outputs, samples, poses), whose first sample has the number ``first``: in the arrays of
    :data:`STATE`, (outputs, poses) each, in place."""
    y = np.ascontiguousarray(y, dtype=np.float64)
    outputs, samples, poses = y.shape
    if y.size:
        rows = max(STRIP // poses, 16)
        _code().call(y.ctypes.data, outputs, samples, poses, rows, first, *(array.ctypes.data for array in state))


@cache
def _code() -> MachineCode:
    machine = this_machine()
    return MachineCode(text(machine), [True, False, False, False, False, False, *([True] * len(STATE))], machine)


def text(machine: Machine) -> str:
    """The text of the function."""
    pd, pi = ("double*", "i64*") if machine.typed else ("ptr", "ptr")
    pointers = ", ".join(f"{pd if number else pi} %{name}" for name, number in STATE.items())
    places = "\n".join(
        f"%{name}_p = getelementptr {kind}, {p} %{name}, i64 %at"
        for name, number in STATE.items()
        for kind, p in [("double", pd) if number else ("i64", pi)]
    )
    names = ", ".join(f"{pd if number else pi} %{name}_p" for name, number in STATE.items())
    declared = {f"declare {c.t} @llvm.fabs.{c.suffix}({c.t})" for c in (machine.code(), machine.code(1))}
    run = _RUN.format(pd=pd, pointers=pointers, places=places, names=names, width=machine.width)
    return "\n\n".join([*sorted(declared), *{_column(machine, width) for width in (machine.width, 1)}, run])


def _column(machine: Machine, width: int) -> str:
    """A function that takes some poses through the samples of a strip."""
    code = machine.code(width)
    t, i, b, do = code.t, code.i, code.b, code.do
    pd, pi = ("double*", "i64*") if machine.typed else ("ptr", "ptr")
    vd, vi = (f"{t}*", f"{i}*") if machine.typed else ("ptr", "ptr")

    def whole(number: int | str) -> str:
        return str(number) if width == 1 else "<" + ", ".join([f"i64 {number}"] * width) + ">"

    code.lines.append(f"%v = load {t}, {vd} %row, align 8")
    finite = do("less", do("fabs", "%v"), code.number(float("inf")))
    once = code.name(f"icmp eq {i} %count_v, {whole(0)}")
    fresh = code.name(f"and {b} {once}, {finite}")
    shift = do("select", fresh, "%v", "%shift_v")
    more = code.name(f"zext {b} {finite} to {i}")
    d = do("subtract", "%v", shift)
    lower = do("and", finite, do("less", "%v", "%least_v"))
    higher = do("and", finite, do("greater", "%v", "%largest_v"))
    new = {
        "count": code.name(f"add {i} %count_v, {more}"),
        "shift": shift,
        "sum": do("select", finite, do("add", "%sum_v", d), "%sum_v"),
        "square": do("select", finite, do("add", "%square_v", do("multiply", d, d)), "%square_v"),
        "least": do("select", lower, "%v", "%least_v"),
        "least_at": code.name(f"select {b} {lower}, {i} %number, {i} %least_at_v"),
        "largest": do("select", higher, "%v", "%largest_v"),
        "largest_at": code.name(f"select {b} {higher}, {i} %number, {i} %largest_at_v"),
    }
    loads, phis, stores = [], [], []
    for name, number in STATE.items():
        kind, p, v = (t, pd, vd) if number else (i, pi, vi)
        loads += [f"%{name}_s = bitcast {p} %{name} to {v}", f"%{name}_0 = load {kind}, {v} %{name}_s, align 8"]
        if name in new:
            phis.append(f"%{name}_v = phi {kind} [%{name}_0, %entry], [{new[name]}, %sample]")
            stores.append(f"store {kind} {new[name]}, {v} %{name}_s, align 8")
    if width == 1:
        loads.append("%number_0 = add i64 %first, 0")
    else:
        loads += [
            f"%number_1 = insertelement {i} undef, i64 %first, i32 0",
            f"%number_0 = shufflevector {i} %number_1, {i} undef, <{width} x i32> zeroinitializer",
        ]
    pointers = ", ".join(f"{pd if number else pi} noalias %{name}" for name, number in STATE.items())
    spread = _SPREAD.format(i=i, width=width) if width > 1 else "%rows_v = add i64 %rows, 0"
    return _COLUMN.format(
        width=width, pd=pd, vd=vd, t=t, i=i, pointers=pointers, loads="\n".join(loads), phis="\n".join(phis),
        lines="\n".join(code.lines), stores="\n".join(stores), one=whole(1), spread=spread, count=new["count"], vi=vi,
    )  # fmt: skip


_COLUMN = """define internal void @column{width}(
{pd} noalias readonly %y, i64 %rows, i64 %poses, i64 %first, {pointers}) {{
entry:
{loads}
br label %sample
sample:
%k = phi i64 [0, %entry], [%k1, %sample]
%number = phi {i} [%number_0, %entry], [%number_n, %sample]
{phis}
%place = mul i64 %k, %poses
%at = getelementptr double, {pd} %y, i64 %place
%row = bitcast {pd} %at to {vd}
{lines}
%number_n = add {i} %number, {one}
%k1 = add i64 %k, 1
%again = icmp ult i64 %k1, %rows
br i1 %again, label %sample, label %done
done:
{stores}
{spread}
%found = sub {i} {count}, %count_0
%lost = sub {i} %rows_v, %found
%missing_n = add {i} %missing_0, %lost
store {i} %missing_n, {vi} %missing_s, align 8
ret void
}}"""
_SPREAD = """%rows_1 = insertelement {i} undef, i64 %rows, i32 0
%rows_v = shufflevector {i} %rows_1, {i} undef, <{width} x i32> zeroinitializer"""
_RUN = """define void @run({pd} %y, i64 %outputs, i64 %samples, i64 %poses, i64 %most, i64 %first, {pointers}) {{
entry:
br label %output
output:
%o = phi i64 [0, %entry], [%o1, %outputs_next]
%o_at = mul i64 %o, %poses
%o_y = mul i64 %o_at, %samples
br label %strip
strip:
%s = phi i64 [0, %output], [%s1, %strips_next]
%left = sub i64 %samples, %s
%short = icmp ult i64 %left, %most
%rows = select i1 %short, i64 %left, i64 %most
%s_rows = mul i64 %s, %poses
%s_y = add i64 %o_y, %s_rows
%number = add i64 %first, %s
br label %pose
pose:
%j = phi i64 [0, %strip], [%j1, %poses_next]
%at = add i64 %o_at, %j
%y_at = add i64 %s_y, %j
%y_p = getelementptr double, {pd} %y, i64 %y_at
{places}
%rest = sub i64 %poses, %j
%whole = icmp uge i64 %rest, {width}
br i1 %whole, label %vector, label %one
vector:
call void @column{width}({pd} %y_p, i64 %rows, i64 %poses, i64 %number, {names})
br label %poses_next
one:
call void @column1({pd} %y_p, i64 %rows, i64 %poses, i64 %number, {names})
br label %poses_next
poses_next:
%step = phi i64 [{width}, %vector], [1, %one]
%j1 = add i64 %j, %step
%poses_more = icmp ult i64 %j1, %poses
br i1 %poses_more, label %pose, label %strips_next
strips_next:
%s1 = add i64 %s, %rows
%strips_more = icmp ult i64 %s1, %samples
br i1 %strips_more, label %strip, label %outputs_next
outputs_next:
%o1 = add i64 %o, 1
%outputs_more = icmp ult i64 %o1, %outputs
br i1 %outputs_more, label %output, label %done
done:
ret void
}}
"""
