"""Symbols: scalars of which each knows the operation and the operands that made it.

Two symbols that were made alike are one object, as long as it lives: a common part is common from the start, and ``is``
tells whether two expressions are the same. Operands are simplified as :mod:`linkwright.symbols.simplification` says.
"""

from __future__ import annotations

import weakref
from collections.abc import Callable, Iterable
from math import copysign
from typing import Any

import numpy as np

from linkwright.symbols.operations import OPERATIONS

CONSTANT, FREE = "constant", "free"
"""What stands for the operation of a number, and of a symbol that has no value yet."""

Rule = Callable[..., "Symbol | None"]
SIMPLIFICATIONS: dict[str, Rule] = {}
"""By operation what gives a simpler symbol for its operands, or ``None``."""


class Symbol:
    """A scalar: the result of an operation ``op`` of ``args``; or a constant, which has its number as ``value``; or a
    free one, which has its name there."""

    __slots__ = ("__weakref__", "args", "op", "value")
    __array_ufunc__ = None  # NumPy's numbers leave mixed arithmetic to symbols

    op: str
    args: tuple[Symbol, ...]
    value: Any

    @staticmethod
    def named(name: str) -> Symbol:
        """A free one, which no other equals, whatever its name."""
        return _new(FREE, (), name)

    @staticmethod
    def several(name: str, count: int) -> list[Symbol]:
        """So many free ones."""
        return [Symbol.named(f"{name}.{i}") for i in range(count)]

    @staticmethod
    def elementary(name: str, *args: Any) -> Symbol:
        """An elementary function by its NumPy name, of symbols and numbers."""
        if name == "where":
            return choice(*args)
        return applied(_OTHER_NAMES.get(name, name), *map(as_symbol, args))

    def do(self, op: str, *others: Any) -> Symbol:
        """An operation whose first operand this is."""
        return applied(op, self, *map(as_symbol, others))

    @property
    def name(self) -> str:
        """The name of a free one."""
        assert self.op is FREE
        return str(self.value)

    def is_constant(self) -> bool:
        """Whether it is a number."""
        return self.op is CONSTANT

    def is_zero(self) -> bool:
        """Whether it is the number 0."""
        return self.op is CONSTANT and self.value == 0

    def __float__(self) -> float:
        if self.op is not CONSTANT:
            raise TypeError(f"{self!r} has no value")
        return float(self.value)

    def __bool__(self) -> bool:
        return bool(float(self))

    def __repr__(self) -> str:
        if not self.args:
            return str(self.value)
        return f"{self.op}({', '.join(arg.op if arg.args else str(arg.value) for arg in self.args)})"

    def __neg__(self) -> Symbol:
        return applied("negative", self)

    def __pos__(self) -> Symbol:
        return self

    def __abs__(self) -> Symbol:
        return applied("fabs", self)

    def __add__(self, other: Any) -> Any:
        return _of_two("add", self, other)

    def __radd__(self, other: Any) -> Any:
        return _of_two("add", other, self)

    def __sub__(self, other: Any) -> Any:
        return _of_two("subtract", self, other)

    def __rsub__(self, other: Any) -> Any:
        return _of_two("subtract", other, self)

    def __mul__(self, other: Any) -> Any:
        return _of_two("multiply", self, other)

    def __rmul__(self, other: Any) -> Any:
        return _of_two("multiply", other, self)

    def __truediv__(self, other: Any) -> Any:
        return _of_two("divide", self, other)

    def __rtruediv__(self, other: Any) -> Any:
        return _of_two("divide", other, self)

    def __pow__(self, other: Any) -> Any:
        return _of_two("power", self, other)

    def __rpow__(self, other: Any) -> Any:
        return _of_two("power", other, self)

    # Conditions. That two are the same expression is asked by ``is``; "equal" is the operation.

    def __lt__(self, other: Any) -> Any:
        return _of_two("less", self, other)

    def __le__(self, other: Any) -> Any:
        return _of_two("less_equal", self, other)

    def __gt__(self, other: Any) -> Any:
        return _of_two("less", other, self)

    def __ge__(self, other: Any) -> Any:
        return _of_two("less_equal", other, self)


_OTHER_NAMES = {"abs": "fabs", "maximum": "fmax", "minimum": "fmin"}
"""The functions that have another name among NumPy's."""
_NUMBERS = (float, int, np.number, np.bool_)


def as_symbol(value: Any) -> Symbol:
    """A symbol as it is, a number as a constant. Raises TypeError for anything else."""
    if isinstance(value, Symbol):
        return value
    if isinstance(value, _NUMBERS):
        return constant(float(value))
    raise TypeError(f"{type(value).__name__} is neither a symbol nor a number")


def _of_two(op: str, x: Any, y: Any) -> Any:
    """An operation of a symbol and something else, to which it gives way where that is neither symbol nor number."""
    if type(y) is not Symbol:
        if not isinstance(y, _NUMBERS):
            return NotImplemented
        y = constant(float(y))
    elif type(x) is not Symbol:
        if not isinstance(x, _NUMBERS):
            return NotImplemented
        x = constant(float(x))
    return applied(op, x, y)


def choice(condition: Any, value: Any, other: Any) -> Symbol:
    """A value where a condition holds, another one elsewhere: a sum of both, of which one is 0. What isn't chosen may
    be NaN."""
    holds = as_symbol(condition)
    return applied("add", holds.do("if_else_zero", value), holds.do("logical_not").do("if_else_zero", other))


def applied(op: str, *args: Symbol) -> Symbol:
    """An operation of symbols, as simple as may be."""
    if args[0].op is CONSTANT and (len(args) == 1 or args[1].op is CONSTANT):
        return constant(OPERATIONS[op].number(*(arg.value for arg in args)))
    rule = SIMPLIFICATIONS.get(op)
    if rule is not None:
        simpler = rule(*args)
        if simpler is not None:
            return simpler
    return _made(op, args)


# Each is made once: a table by operation holds symbols by their operands, and lets go of one that nobody else holds.


class _Held(weakref.ref[Symbol]):
    """A symbol's place in the tables."""

    __slots__ = ("args", "op")
    op: str
    args: tuple[Any, ...]


_TABLES: dict[str, dict[tuple[Any, ...], _Held]] = {op: {} for op in (CONSTANT, *OPERATIONS)}


def _forget(held: Any) -> None:
    table = _TABLES[held.op]
    args: tuple[Any, ...] = held.args
    if table.get(args) is held:
        del table[args]


def _new(op: str, args: tuple[Symbol, ...], value: Any) -> Symbol:
    made = Symbol()
    made.op, made.args, made.value = op, args, value
    return made


def _made(op: str, args: tuple[Symbol, ...], value: float | None = None, key: tuple[Any, ...] = ()) -> Symbol:
    """The symbol of an operation as it stands, or by ``key`` that of a number."""
    key = key or args
    table = _TABLES.get(op)
    if table is None:
        raise NotImplementedError(f"symbols have no operation {op}")
    held = table.get(key)
    if held is not None:
        known = held()
        if known is not None:
            return known
    made = _new(op, args, value)
    held = _Held(made, _forget)
    held.op, held.args, table[key] = op, key, held
    return made


def constant(number: float) -> Symbol:
    """A number as a symbol; 0 and -0 are two."""
    return _made(CONSTANT, (), number, (number, copysign(1.0, number)))


def simplifies(*ops: str) -> Callable[[Rule], Rule]:
    """Enter a rule for some operations."""

    def enter(rule: Rule) -> Rule:
        SIMPLIFICATIONS.update(dict.fromkeys(ops, rule))
        return rule

    return enter


def symbols_of(values: Iterable[Any]) -> list[Symbol]:
    """Numbers and symbols as symbols."""
    return [as_symbol(value) for value in values]
