"""Machine instructions that Numba has no words for: stores past the cache, and selects.

Stores past the cache, for rows that are longer than it, spare the memory one reading of what is overwritten (Intel 64
and IA-32 Architectures Optimization Reference Manual, non-temporal stores).
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba.core import types
from numba.extending import intrinsic

WIDTH = 8
"""Numbers in one store."""


@intrinsic  # type: ignore[untyped-decorator]
def stream(typing: Any, to: Any, place: Any, row: Any, start: Any) -> Any:
    """``to[place : place + WIDTH] = row[start : start + WIDTH]``; ``to`` has to be aligned there to 64 bytes."""

    def write(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        vector = ir.VectorType(ir.DoubleType(), WIDTH)

        def pointer(k: int) -> Any:
            data = context.make_array(signature.args[k])(context, builder, args[k]).data
            return builder.bitcast(builder.gep(data, [args[k + 1]]), vector.as_pointer())

        stored = builder.store(builder.load(pointer(2), align=8), pointer(0), align=64)
        module = builder.module
        stored.set_metadata("nontemporal", module.add_metadata([ir.Constant(ir.IntType(32), 1)]))
        return context.get_dummy_value()

    return types.void(to, types.intp, row, types.intp), write


@intrinsic  # type: ignore[untyped-decorator]
def fence(typing: Any) -> Any:
    """Let all stores be done before any later one: those past the cache have no order of their own."""

    def write(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        builder.fence("seq_cst")
        return context.get_dummy_value()

    return types.void(), write


@intrinsic  # type: ignore[untyped-decorator]
def pick(typing: Any, condition: Any, yes: Any, no: Any) -> Any:
    """``yes if condition else no`` of numbers that are there already: no branch for the compiler to see through, which
    is what takes it longest."""

    def write(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return builder.select(*args)

    return types.float64(types.boolean, types.float64, types.float64), write
