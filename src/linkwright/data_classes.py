"""Data classes whose making is put off: as those of the standard library, at a tenth of the cost of defining them.

The standard library compiles six functions for each frozen class when it's defined, half a millisecond, and hundreds
are defined for one command. Here all classes share comparison, hash and text, which read the fields; ``__init__`` is
compiled when an object of the class is first made.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from functools import cache
from operator import attrgetter
from reprlib import recursive_repr
from threading import Lock
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from dataclasses import dataclass as dataclass
else:

    def dataclass(cls: type | None = None, /, *, frozen: bool = False, eq: bool = True, repr: bool = True) -> Any:
        """:func:`dataclasses.dataclass` with these of its options. Of a frozen class, no attribute can be set, those
        that aren't fields included."""
        return _made(cls, frozen, eq, repr) if cls is not None else lambda cls: _made(cls, frozen, eq, repr)


_ONE_AT_A_TIME = Lock()


def _made(cls: type, frozen: bool, eq: bool, repr: bool) -> type:
    own = vars(cls)
    if not cls.__doc__:
        cls.__doc__ = cls.__name__  # else the signature would be taken for it, and compiled for that
    _collect_fields(cls, frozen)
    given: dict[str, Any] = {} if "__init__" in own else {"__init__": _Pending(cls, frozen)}
    if repr and "__repr__" not in own:
        given["__repr__"] = _repr
    if eq:
        if own.get("__hash__") is None:  # so it is, too, where a class states __eq__ alone
            given["__hash__"] = _hash if frozen else None
        if "__eq__" not in own:
            given["__eq__"] = _eq
    if frozen:
        given |= {"__setattr__": _no_setting, "__delattr__": _no_deleting}
    for name, thing in given.items():
        setattr(cls, name, thing)
    return cls


def _collect_fields(cls: Any, frozen: bool) -> None:
    """Have the standard library find the fields. It would refuse this to one that's open below a frozen one, and would
    compile two functions for a frozen one: so all are open to it meanwhile."""
    with _ONE_AT_A_TIME:
        bases = [vars(base).get("__dataclass_params__") for base in cls.__mro__[1:]]
        closed = [said for said in bases if said and said.frozen]
        try:
            for said in closed:
                said.frozen = False
            dataclasses.dataclass(init=False, repr=False, eq=False)(cls)
            cls.__dataclass_params__.frozen = frozen
        finally:
            for said in closed:
                said.frozen = True


class _Factory:
    """Stands in signatures for what a factory makes."""

    def __repr__(self) -> str:
        return "<factory>"


class _Pending:
    """An ``__init__`` that isn't compiled yet."""

    def __init__(self, cls: type, frozen: bool) -> None:
        self.cls, self.frozen = cls, frozen

    def __get__(self, one: Any, cls: type | None = None) -> Any:
        if isinstance(vars(self.cls)["__init__"], _Pending):
            setattr(self.cls, "__init__", _init(self.cls, self.frozen))  # noqa: B010  (mypy knows that it's a method)
        return vars(self.cls)["__init__"].__get__(one, cls)


def _init(cls: type, frozen: bool) -> Callable[..., None]:
    """The ``__init__`` of a class: its fields in their order, those by keyword last."""
    names: dict[str, Any] = {"_given_": _Factory(), "_put_": object.__setattr__}
    ordered, by_keyword, lines = ["self"], ["*"], []
    for field in dataclasses.fields(cls):
        name, value, default = field.name, field.name, ""
        if field.default_factory is not dataclasses.MISSING:
            names[f"new_{name}"], default = field.default_factory, "=_given_"
            value = f"new_{name}() if {name} is _given_ else {name}" if field.init else f"new_{name}()"
        elif field.default is not dataclasses.MISSING:
            names[f"default_{name}"], default = field.default, f"=default_{name}"
        if field.init:
            (by_keyword if field.kw_only else ordered).append(name + default)
        elif field.default_factory is dataclasses.MISSING:
            continue  # the class has its value, or it's set later
        lines.append(f"_put_(self, {name!r}, {value})" if frozen else f"self.{name} = {value}")
    if hasattr(cls, "__post_init__"):
        lines.append("self.__post_init__()")
    arguments = ", ".join(ordered + by_keyword * (len(by_keyword) > 1))
    text = f"def __init__({arguments}):\n " + "\n ".join(lines or ["pass"])
    exec(text, names)
    made: Callable[..., None] = names["__init__"]
    made.__qualname__, made.__module__ = f"{cls.__qualname__}.__init__", cls.__module__
    made.__annotations__ = {f.name: f.type for f in dataclasses.fields(cls) if f.init} | {"return": None}
    return made


@cache
def _compared(cls: type) -> Callable[[Any], Any]:
    """The values of an object by which it's compared."""
    names = [field.name for field in dataclasses.fields(cls) if field.compare]
    if len(names) < 2:  # one value alone would be told equal otherwise than in a tuple: arrays, nan
        return lambda one: tuple(getattr(one, name) for name in names)
    return attrgetter(*names)


def _eq(self: Any, other: object) -> Any:
    values = _compared(self.__class__)
    if self.__class__ is not other.__class__:
        return NotImplemented
    return self is other or values(self) == values(other)


def _hash(self: Any) -> int:
    return hash(_compared(self.__class__)(self))


@recursive_repr()
def _repr(self: Any) -> str:
    shown = ", ".join(f"{f.name}={getattr(self, f.name)!r}" for f in dataclasses.fields(self) if f.repr)
    return f"{self.__class__.__qualname__}({shown})"


def _no_setting(self: Any, name: str, value: Any) -> None:
    raise dataclasses.FrozenInstanceError(f"cannot assign to field {name!r}")


def _no_deleting(self: Any, name: str) -> None:
    raise dataclasses.FrozenInstanceError(f"cannot delete field {name!r}")
