"""What calls the functions of a compiled kernel: loops over samples and blocks of poses, and a single pose.

Over many poses, rows of inputs and parameters are copied into a block and rows of outputs out of it, past the cache
where that is asked for. A single pose is a function of pointers alone.
"""

from __future__ import annotations

from collections.abc import Sequence

from linkwright.kernels.division import OWN, SCALAR, SHARED
from linkwright.kernels.listing import X
from linkwright.kernels.llvm_code import INTRINSICS
from linkwright.kernels.llvm_source import KernelSource

STORED = 8
"""Numbers of one store past the cache: a line of it."""


def text(source: KernelSource) -> str:
    """The whole text of a program."""
    code, single = source.machine.code(), source.machine.code(1)
    declared = {f"declare {c.t} @llvm.{name}.{c.suffix}({c.t})" for name in INTRINSICS for c in (code, single)}
    entry = _pose(source) if source.lanes == 1 else _run(source)
    return "\n\n".join(["\n".join(sorted(declared)), *source.text, entry]) + "\n"


def _run(source: KernelSource) -> str:
    """Loops over samples and blocks of poses."""
    code, shared = source.machine.code(), source.form[X] == SHARED
    pd, starts = code.pd, len(source.x_rows)
    rows, out = len(source.program.outputs), source.out * source.lanes
    row = {"pt": code.pt, "t": code.t, "width": code.width, "lanes": source.lanes}
    copies = _COPIES.format(
        **row, pd=pd, stored=STORED, line=f"<{STORED} x double>", pl=pd if pd == "ptr" else f"<{STORED} x double>*",
        vectors_after_whole=_VECTORS.format(**row, before="whole"),
        vectors_after_near=_VECTORS.format(**row, before="near"),
    )  # fmt: skip
    return copies + (_OVER if shared else _APART).format(
        pd=pd, lanes=source.lanes, room=source.scalars.count,
        arguments=_arguments(pd),
        scalars=_calls(source.steps[SCALAR], f"{pd} %ps, i64 %pr, {pd} %cs"),
        shared=_calls(source.steps[SHARED], f"{pd} %w, {pd} %c"),
        own=_calls(source.steps[OWN], f"{pd} %w, {pd} {'%co' if shared else '%cs'}"),
        load_x=_loads(source, "x", source.x_rows, 0, "%b" if shared else "%xb"),
        load_start=_loads(source, "x", source.start_rows, starts, "%b"),
        load_p=_loads(source, "p", source.p_rows, starts, "%b"),
        save=_SAVE.format(pd=pd, lanes=source.lanes, out=out, rows=rows, before="one" if shared else "block"),
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
    "lead": False,
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


_VECTORS = """vector:
%v = phi i64 [0, %{before}], [%v1, %vector]
%vf = getelementptr {t}, {pt} %fv, i64 %v
%vt = getelementptr {t}, {pt} %tv, i64 %v
%vx = load {t}, {pt} %vf, align 8
store {t} %vx, {pt} %vt, align 8
%v1 = add i64 %v, 1
%v2 = mul i64 %v1, {width}
%vm = icmp ult i64 %v2, {lanes}
br i1 %vm, label %vector, label %done"""
"""The lines that copy a whole row of a block, vector by vector."""
_COPIES = """define internal void @load({pd} noalias %to, {pd} noalias readonly %from, i64 %m) {{
entry:
%full = icmp eq i64 %m, {lanes}
br i1 %full, label %whole, label %part
whole:
%tv = bitcast {pd} %to to {pt}
%fv = bitcast {pd} %from to {pt}
br label %vector
{vectors_after_whole}
part:
%i = phi i64 [0, %entry], [%i1, %part]
%in = icmp ult i64 %i, %m
%k = select i1 %in, i64 %i, i64 0
%f = getelementptr double, {pd} %from, i64 %k
%t = getelementptr double, {pd} %to, i64 %i
%x = load double, {pd} %f, align 8
store double %x, {pd} %t, align 8
%i1 = add i64 %i, 1
%more = icmp ult i64 %i1, {lanes}
br i1 %more, label %part, label %done
done:
ret void
}}

define internal void @save({pd} noalias readonly %from, {pd} noalias %to, i64 %m, i1 %past) {{
entry:
%full = icmp eq i64 %m, {lanes}
%lines = and i1 %full, %past
%tv = bitcast {pd} %to to {pt}
%fv = bitcast {pd} %from to {pt}
%tl = bitcast {pd} %to to {pl}
%fl = bitcast {pd} %from to {pl}
br i1 %lines, label %line, label %near
line:
%l = phi i64 [0, %entry], [%l1, %line]
%lf = getelementptr {line}, {pl} %fl, i64 %l
%lt = getelementptr {line}, {pl} %tl, i64 %l
%lx = load {line}, {pl} %lf, align 8
store {line} %lx, {pl} %lt, align 64, !nontemporal !0
%l1 = add i64 %l, 1
%l2 = mul i64 %l1, {stored}
%lm = icmp ult i64 %l2, {lanes}
br i1 %lm, label %line, label %done
near:
br i1 %full, label %vector, label %part
{vectors_after_near}
part:
%i = phi i64 [0, %near], [%i1, %part]
%f = getelementptr double, {pd} %from, i64 %i
%t = getelementptr double, {pd} %to, i64 %i
%x = load double, {pd} %f, align 8
store double %x, {pd} %t, align 8
%i1 = add i64 %i, 1
%more = icmp ult i64 %i1, %m
br i1 %more, label %part, label %done
done:
ret void
}}

!0 = !{{i32 1}}

"""
_SAVE = """%place0 = mul i64 %s, %os
%place = add i64 %place0, %b
br label %row
row:
%k = phi i64 [0, %{before}], [%k1, %row]
%to0 = mul i64 %k, %orow
%to1 = add i64 %to0, %place
%to = getelementptr double, {pd} %out, i64 %to1
%from0 = mul i64 %k, {lanes}
%from1 = add i64 %from0, {out}
%from = getelementptr double, {pd} %w, i64 %from1
call void @save({pd} %from, {pd} %to, i64 %m, i1 %past)
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
%m0 = select i1 %short, i64 %left, i64 {lanes}
%start = icmp eq i64 %b, 0
%some = icmp ne i64 %lead, 0
%leads = and i1 %start, %some
%m = select i1 %leads, i64 %lead, i64 %m0
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
