"""What calls the functions of a compiled kernel: loops over samples and blocks of poses, and a single pose.

Over many poses, rows of inputs and parameters are copied into a block and rows of outputs out of it
(:mod:`linkwright.kernels.llvm_copies`). A single pose is a function of pointers alone.
"""

from __future__ import annotations

from collections.abc import Sequence

from linkwright.kernels.division import OWN, SCALAR, SHARED
from linkwright.kernels.listing import X
from linkwright.kernels.llvm_code import INTRINSICS
from linkwright.kernels.llvm_copies import KEPT, copies
from linkwright.kernels.llvm_source import KernelSource


def text(source: KernelSource) -> str:
    """The whole text of a program."""
    code, single = source.machine.code(), source.machine.code(1)
    declared = {f"declare {c.t} @llvm.{name}.{c.suffix}({c.t})" for name in INTRINSICS for c in (code, single)}
    entry = _pose(source) if source.lanes == 1 else _run(source)
    return "\n\n".join(["\n".join(sorted(declared)), *source.text, entry]) + "\n"


def room(source: KernelSource) -> int:
    """The numbers for which ``run`` needs room in ``w``: rows, and of each output what waits for a full line."""
    return source.rows.count * source.lanes + KEPT * len(source.program.outputs)


def _run(source: KernelSource) -> str:
    """Loops over samples and blocks of poses."""
    code, shared = source.machine.code(), source.form[X] == SHARED
    pd, starts = code.pd, len(source.x_rows)
    rows, out = len(source.program.outputs), source.out * source.lanes
    return copies(source) + (_OVER if shared else _APART).format(
        pd=pd, lanes=source.lanes, room=source.scalars.count,
        arguments=_arguments(pd),
        scalars=_calls(source.steps[SCALAR], f"{pd} %ps, i64 %pr, {pd} %cs"),
        shared=_calls(source.steps[SHARED], f"{pd} %w, {pd} %c"),
        own=_calls(source.steps[OWN], f"{pd} %w, {pd} {'%co' if shared else '%cs'}"),
        load_x=_loads(source, "x", source.x_rows, 0, "%b" if shared else "%xb"),
        load_start=_loads(source, "x", source.start_rows, starts, "%b"),
        load_p=_loads(source, "p", source.p_rows, starts, "%b"),
        save=_SAVE.format(
            pd=pd, lanes=source.lanes, out=out, rows=rows, before="one" if shared else "block",
            kept=KEPT, room=source.rows.count * source.lanes, first="true" if shared else "%first",
            last="true" if shared else "%last",
        ),
    )  # fmt: skip


ARGUMENTS = {
    "x": True,
    "xr": False,
    "xs": False,
    "p": True,
    "pr": False,
    "out": True,
    "orow": False,
    "os": False,
    "samples": False,
    "poses": False,
    "flag": False,
    "w": True,
    "c": True,
}
"""What ``run`` is called with, by name: pointers (true) and whole numbers.

The steps from row to row of inputs, parameters and outputs, those from sample to sample of inputs and outputs; how many
samples and poses; the poses before outputs are aligned; whether outputs are stored past the cache; room for rows and
for scalars."""


def _arguments(pd: str) -> str:
    return ", ".join(f"{pd if pointer else 'i64'} %{name}" for name, pointer in ARGUMENTS.items())


def _calls(names: Sequence[str], arguments: str) -> str:
    return "\n".join(f"call void @{name}({arguments})" for name in names)


def _loads(source: KernelSource, array: str, rows: Sequence[int], first: int, place: str) -> str:
    """Copies of rows into the block, of ``array`` by its own stride, from a place on."""
    lines, pd = [], source.machine.code().pd
    for k, row in enumerate(rows, start=first):
        name = f"%{array}{k}"
        lines += [
            f"{name}a = mul i64 %{array}r, {row}",
            f"{name}b = add i64 {name}a, {place}",
            f"{name}c = getelementptr double, {pd} %{array}, i64 {name}b",
            f"{name}d = getelementptr double, {pd} %w, i64 {k * source.lanes}",
            f"call void @load({pd} {name}d, {pd} {name}c, i64 %m)",
        ]
    return "\n".join(lines)


def _pose(source: KernelSource) -> str:
    """One pose, by pointers to its inputs, the parameters, the outputs and room for rows and scalars."""
    code = source.machine.code(1)
    code.lines.append(f"%cs = getelementptr double, {code.pd} %w, i64 {source.rows.count}")
    code.lines += _calls(source.steps[SCALAR], f"{code.pd} %p, i64 1, {code.pd} %cs").splitlines()
    for k, row in enumerate(source.x_rows):
        code.store(code.load("%x", row), "%w", k)
    code.lines += _calls(source.steps[OWN], f"{code.pd} %w, {code.pd} %cs").splitlines()
    for k in range(len(source.program.outputs)):
        code.store(code.load("%w", source.out + k), "%out", k)
    return f"define void @run({', '.join(f'{code.pd} %{name}' for name in ('x', 'p', 'out', 'w'))}) {{\n" + "\n".join(
        [*code.lines, "ret void", "}"]
    )


_SAVE = """%place0 = mul i64 %s, %os
%place = add i64 %place0, %b
br label %row
row:
%k = phi i64 [0, %{before}], [%k1, %next]
%to0 = mul i64 %k, %orow
%to1 = add i64 %to0, %place
%to = getelementptr double, {pd} %out, i64 %to1
%from0 = mul i64 %k, {lanes}
%from1 = add i64 %from0, {out}
%from = getelementptr double, {pd} %w, i64 %from1
br i1 %past, label %streamed, label %near
streamed:
%kept0 = mul i64 %k, {kept}
%kept1 = add i64 %kept0, {room}
%kept = getelementptr double, {pd} %w, i64 %kept1
call void @stream({pd} %from, {pd} %to, i64 %m, {pd} %kept, i1 {first}, i1 {last})
br label %next
near:
call void @save({pd} %from, {pd} %to, i64 %m)
br label %next
next:
%k1 = add i64 %k, 1
%rows = icmp ult i64 %k1, {rows}
br i1 %rows, label %row, label %saved
saved:
"""
_APART = """define void @run({arguments}) {{
entry:
%past = icmp ne i64 %flag, 0
br label %sample
sample:
%s = phi i64 [0, %entry], [%s1, %sampled]
%ps = getelementptr double, {pd} %p, i64 %s
%c0 = mul i64 %s, {room}
%cs = getelementptr double, {pd} %c, i64 %c0
{scalars}
%xb0 = mul i64 %s, %xs
br label %block
block:
%b = phi i64 [0, %sample], [%b1, %saved]
%xb = add i64 %xb0, %b
%left = sub i64 %poses, %b
%short = icmp ult i64 %left, {lanes}
%m = select i1 %short, i64 %left, i64 {lanes}
%first = icmp eq i64 %b, 0
%last = icmp ule i64 %left, {lanes}
{load_x}
{load_p}
{own}
{save}
%b1 = add i64 %b, %m
%blocks = icmp ult i64 %b1, %poses
br i1 %blocks, label %block, label %sampled
sampled:
%s1 = add i64 %s, 1
%again = icmp ult i64 %s1, %samples
br i1 %again, label %sample, label %done
done:
fence seq_cst
ret void
}}"""
_OVER = """define void @run({arguments}) {{
entry:
%past = icmp ne i64 %flag, 0
br label %sample
sample:
%s0 = phi i64 [0, %entry], [%s2, %sample]
%ps = getelementptr double, {pd} %p, i64 %s0
%c1 = mul i64 %s0, {room}
%cs = getelementptr double, {pd} %c, i64 %c1
{scalars}
%s2 = add i64 %s0, 1
%all = icmp ult i64 %s2, %samples
br i1 %all, label %sample, label %block
block:
%b = phi i64 [0, %sample], [%b1, %sampled]
%left = sub i64 %poses, %b
%short = icmp ult i64 %left, {lanes}
%m = select i1 %short, i64 %left, i64 {lanes}
{load_x}
{shared}
br label %one
one:
%s = phi i64 [0, %block], [%s1, %saved]
%c0 = mul i64 %s, {room}
%co = getelementptr double, {pd} %c, i64 %c0
{load_start}
{own}
{save}
%s1 = add i64 %s, 1
%again = icmp ult i64 %s1, %samples
br i1 %again, label %one, label %sampled
sampled:
%b1 = add i64 %b, {lanes}
%blocks = icmp ult i64 %b1, %poses
br i1 %blocks, label %block, label %done
done:
fence seq_cst
ret void
}}"""
