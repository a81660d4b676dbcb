"""Data classes whose making is put off, held to those of the standard library."""

from __future__ import annotations

import copy
import dataclasses
import inspect
import pickle
from collections.abc import Callable
from dataclasses import field
from functools import cached_property
from typing import Any, ClassVar

import numpy as np
import pytest

from linkwright.data_classes import dataclass

Maker = Callable[..., Any]


def classes(dataclass: Any) -> dict[str, Any]:
    """The same classes made by either decorator."""

    @dataclass(frozen=True)
    class Frozen:
        """Fields of all kinds."""

        a: int
        b: str = "b"
        c: list[int] = field(default_factory=list)
        d: float = field(default=2.0, repr=False, compare=False)
        e: dict[str, int] = field(default_factory=dict, init=False)
        shared: ClassVar[int] = 3
        f: int = field(default=5, kw_only=True)
        g: int = field(default=6, init=False)

        @cached_property
        def twice(self) -> int:
            """Kept once it was asked."""
            return 2 * self.a

    @dataclass(frozen=True)
    class Below(Frozen):
        a: int = 1
        h: int = 8

    @dataclass
    class Open:
        self_: int
        given: int = 0
        total: int = field(init=False)

        def __post_init__(self) -> None:
            self.total = self.self_ + self.given

    @dataclass(frozen=True, eq=False)
    class ByIdentity:
        a: int

    @dataclass(frozen=True)
    class OwnEq:
        a: int

        def __eq__(self, other: object) -> bool:
            return isinstance(other, OwnEq)

    @dataclass(repr=False)
    class OwnInit:
        a: int = 0

        def __init__(self) -> None:
            self.a = 7

    @dataclass(frozen=True)
    class Empty:
        pass

    return {one.__name__: one for one in (Frozen, Below, Open, ByIdentity, OwnEq, OwnInit, Empty)}


OURS, THEIRS = classes(dataclass), classes(dataclasses.dataclass)
CALLS: list[tuple[str, tuple[Any, ...], dict[str, Any]]] = [
    ("Frozen", (1,), {}),
    ("Frozen", (1, "x", [3], 4.0), {"f": 9}),
    ("Frozen", (), {"a": 1, "c": [1]}),
    ("Frozen", (1, "b", [], 3.0), {}),
    ("Frozen", (), {}),
    ("Frozen", (1, "x", [3], 4.0, {}), {}),
    ("Frozen", (1,), {"a": 2}),
    ("Frozen", (1,), {"other": 2}),
    ("Below", (), {}),
    ("Below", (1, "b", [], 2.0, 8), {}),
    ("Below", (1, "b", [], 2.0, 9), {"f": 1}),
    ("Open", (1,), {}),
    ("Open", (1, 2), {}),
    ("Open", (), {"given": 1, "self_": 2}),
    ("ByIdentity", (1,), {}),
    ("OwnEq", (1,), {}),
    ("OwnEq", (2,), {}),
    ("OwnInit", (), {}),
    ("Empty", (), {}),
]


def outcome(work: Callable[[], Any]) -> Any:
    """What a call gives, or what it raises."""
    try:
        return work()
    except Exception as error:
        return type(error), str(error)


def made(kinds: dict[str, Any]) -> list[Any]:
    """What all calls make, those that are refused left out."""
    found = (outcome(lambda call=call: kinds[call[0]](*call[1], **call[2])) for call in CALLS)
    return [one for one in found if not isinstance(one, tuple)]


@pytest.mark.parametrize("name, args, named", CALLS)
def test_objects_are_those_of_the_standard_library(name: str, args: tuple[Any, ...], named: dict[str, Any]) -> None:
    ours, theirs = (outcome(lambda kinds=kinds: kinds[name](*args, **named)) for kinds in (OURS, THEIRS))
    if isinstance(theirs, tuple):
        assert ours == theirs
        return
    assert list(vars(ours).items()) == list(vars(theirs).items())
    assert dataclasses.asdict(ours) == dataclasses.asdict(theirs)
    for work in (
        lambda one: one.__repr__() if name != "OwnInit" else "",
        lambda one: isinstance(hash(one), int),
        lambda one: delattr(one, "a"),
        lambda one: setattr(one, "a", 2),
        lambda one: dataclasses.replace(one, a=3) and None,
        lambda one: dataclasses.replace(one, other=3),
    ):
        assert outcome(lambda work=work: work(ours)) == outcome(lambda work=work: work(theirs))


def test_all_pairs_compare_as_in_the_standard_library() -> None:
    ours, theirs = ([[a == b for a in of] for b in of] for of in map(made, (OURS, THEIRS)))
    assert ours == theirs
    assert hash(Point(1.0)) == hash(Point(1.0)) != hash(Point(2.0))


@pytest.mark.parametrize("name", OURS)
def test_classes_are_described_as_in_the_standard_library(name: str) -> None:
    ours, theirs = OURS[name], THEIRS[name]
    assert str(inspect.signature(ours)) == str(inspect.signature(theirs))
    assert [str(f) for f in dataclasses.fields(ours)] == [str(f) for f in dataclasses.fields(theirs)]
    assert ours.__match_args__ == theirs.__match_args__


@dataclass(frozen=True)
class Point:
    """A class that can be pickled."""

    x: float
    y: Any = 0.0


def test_values_that_compare_otherwise_alone_than_in_a_tuple() -> None:
    @dataclass(frozen=True)
    class One:
        x: Any

    nan, array = float("nan"), np.arange(3.0)
    assert One(nan) == One(nan) and One(array) == One(array)
    with pytest.raises(ValueError, match="ambiguous"):
        assert One(array) == One(array + 1)


def test_copies_and_pickles() -> None:
    point = Point(1.0, [2.0])
    assert copy.copy(point) == copy.deepcopy(point) == pickle.loads(pickle.dumps(point)) == point
    match point:
        case Point(x, y):
            assert (x, y) == (1.0, [2.0])


def test_one_that_holds_itself_is_shown() -> None:
    held: list[Any] = []
    held.append(Point(1.0, held))
    assert repr(held[0]) == "Point(x=1.0, y=[...])" or "..." in repr(held[0])


def test_classes_of_the_standard_library_derive_from_ours_and_ours_from_theirs() -> None:
    @dataclasses.dataclass(frozen=True)
    class Above(Point):
        z: float = 0.0

    @dataclass(frozen=True)
    class Top(Above):
        w: float = 0.0

    assert Top(1.0, z=2.0) == Top(1.0, 0.0, 2.0, 0.0) != Above(1.0, 0.0, 2.0)
    for one in (Above(1.0), Top(1.0)):
        with pytest.raises(dataclasses.FrozenInstanceError):
            one.x = 2.0  # type: ignore[misc]
    with pytest.raises(TypeError, match="frozen"):
        dataclasses.dataclass(type("Loose", (Point,), {}))


def test_an_init_is_compiled_when_it_is_first_asked_for() -> None:
    @dataclass
    class Fresh:
        a: int

    @dataclass
    class Below(Fresh):
        b: int

    assert not inspect.isfunction(vars(Fresh)["__init__"])
    assert Below(1, 2).b == 2 and not inspect.isfunction(vars(Fresh)["__init__"])
    assert Fresh(1).a == 1 and inspect.isfunction(vars(Fresh)["__init__"])
    assert Fresh.__init__.__qualname__.endswith("Fresh.__init__")
