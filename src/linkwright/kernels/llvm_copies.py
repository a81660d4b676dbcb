"""Copies of rows into and out of a block of a compiled kernel, in LLVM's intermediate language.

A row of outputs longer than the cache is stored past it, in whole lines: a store of part of a line, or one through the
cache, waits for the line to be read, which takes far longer where many rows are written in turn. As a block may end
within a line, its last numbers are kept for the first line of the next block. Only the row's first and last line,
where they are parts, go through the cache.
"""

from __future__ import annotations

from linkwright.kernels.llvm_source import KernelSource

STORED = 8
"""Numbers of one store past the cache: a line of it."""
KEPT = 2 * STORED
"""Numbers kept of each row: the last of a block and the first of the next one."""


def copies(source: KernelSource) -> str:
    """The functions ``load`` (a row into the block), ``save`` (one out of it) and ``stream`` (past the cache).

    ``stream`` has the row's KEPT numbers, and whether the block is the row's first and its last.
    """
    code = source.machine.code()
    row = {"pt": code.pt, "t": code.t, "width": code.width, "lanes": source.lanes}
    line = f"<{STORED} x double>"
    return _COPIES.format(
        **row, pd=code.pd, stored=STORED, line=line, pl=code.pd if code.pd == "ptr" else f"{line}*",
        vectors_after_whole=_VECTORS.format(**row, before="whole"),
        vectors_after_entry=_VECTORS.format(**row, before="entry"),
        over=STORED - 1, lines=source.lanes // STORED, end=source.lanes // STORED - 1,
    )  # fmt: skip


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

define internal void @single({pd} noalias readonly %from, {pd} noalias %to, i64 %m) {{
entry:
%any = icmp ne i64 %m, 0
br i1 %any, label %part, label %done
part:
%i = phi i64 [0, %entry], [%i1, %part]
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

define internal void @save({pd} noalias readonly %from, {pd} noalias %to, i64 %m) {{
entry:
%full = icmp eq i64 %m, {lanes}
%tv = bitcast {pd} %to to {pt}
%fv = bitcast {pd} %from to {pt}
br i1 %full, label %vector, label %part
{vectors_after_entry}
part:
call void @single({pd} %from, {pd} %to, i64 %m)
br label %done
done:
ret void
}}

define internal void @stream(
  {pd} noalias readonly %from, {pd} noalias %to, i64 %m, {pd} noalias %kept, i1 %first, i1 %last
) {{
entry:
%address = ptrtoint {pd} %to to i64
%eighths = lshr i64 %address, 3
%h = and i64 %eighths, {over}
%short = sub i64 {stored}, %h
%back = sub i64 0, %h
%before = getelementptr double, {pd} %to, i64 %back
%start = getelementptr double, {pd} %from, i64 %back
%old = getelementptr double, {pd} %kept, i64 %short
%new = getelementptr double, {pd} %kept, i64 {stored}
%held = select i1 %first, i64 0, i64 %h
%full = icmp eq i64 %m, {lanes}
br i1 %full, label %whole, label %part
whole:
%tl = bitcast {pd} %before to {pl}
%fl = bitcast {pd} %start to {pl}
%ol = bitcast {pd} %old to {pl}
%nl = bitcast {pd} %new to {pl}
%kl = bitcast {pd} %kept to {pl}
%bl = bitcast {pd} %from to {pl}
%head = load {line}, {pl} %bl, align 64
store {line} %head, {pl} %nl, align 64
%lone = icmp ne i64 %h, %held
br i1 %lone, label %some, label %joined
some:
call void @single({pd} %from, {pd} %to, i64 %short)
br label %line
joined:
%join = load {line}, {pl} %ol, align 8
store {line} %join, {pl} %tl, align 64, !nontemporal !0
br label %line
line:
%l = phi i64 [1, %some], [1, %joined], [%l1, %line]
%lf = getelementptr {line}, {pl} %fl, i64 %l
%lt = getelementptr {line}, {pl} %tl, i64 %l
%lx = load {line}, {pl} %lf, align 8
store {line} %lx, {pl} %lt, align 64, !nontemporal !0
%l1 = add i64 %l, 1
%lm = icmp ult i64 %l1, {lines}
br i1 %lm, label %line, label %keep
keep:
%el = getelementptr {line}, {pl} %bl, i64 {end}
%end = load {line}, {pl} %el, align 64
store {line} %end, {pl} %kl, align 64
%left = select i1 %last, i64 %h, i64 0
%done = sub i64 {lanes}, %left
%rest = getelementptr double, {pd} %from, i64 %done
%there = getelementptr double, {pd} %to, i64 %done
call void @single({pd} %rest, {pd} %there, i64 %left)
ret void
part:
call void @single({pd} %old, {pd} %before, i64 %held)
call void @single({pd} %from, {pd} %to, i64 %m)
ret void
}}

!0 = !{{i32 1}}

"""
