"""Values as arrays and back: the same types and bits, whatever the tree; nothing else is made of a file's content."""

from __future__ import annotations

import io
import json
import struct
import sys
from dataclasses import dataclass, field, fields, is_dataclass, make_dataclass
from typing import Any, NamedTuple

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from linkwright.blocks.packing import TREE, UnpackError, pack, unpack

PACKAGE = __name__.partition(".")[0]


@dataclass(frozen=True)
class Leaf:
    """A small one, as a certificate has many of."""

    name: str
    value: float


@dataclass(frozen=True, eq=False)
class Node:
    """One that checks itself when it is made, with an attribute that isn't a field."""

    left: Any
    right: Any
    leaves: tuple[Leaf, ...] = ()
    made: int = field(default=0, init=False)

    def __post_init__(self) -> None:
        if isinstance(self.left, str) and self.left == "refused":
            raise ValueError("not by its constructor")


@dataclass(frozen=True, slots=True)
class Slotted:
    """Without a dict of its own."""

    value: Any


class Outside:
    """What can't be packed."""


class Pair(NamedTuple):
    """A tuple of another type."""

    a: int
    b: int


def same(a: Any, b: Any) -> bool:
    """Whether two values have the same types and bits all through."""
    if type(a) is not type(b):
        return False
    if isinstance(a, float) and not isinstance(a, np.generic):
        return struct.pack("<d", a) == struct.pack("<d", b)
    if isinstance(a, np.ndarray | np.generic):
        return (a.dtype, a.shape, a.tobytes()) == (b.dtype, b.shape, b.tobytes())
    if isinstance(a, shapely.Geometry):
        return a.geom_type == b.geom_type and a.wkb == b.wkb
    if isinstance(a, tuple | list):
        return len(a) == len(b) and all(map(same, a, b))
    if isinstance(a, dict):
        return [*a] == [*b] and all(same(a[key], b[key]) for key in a)
    if is_dataclass(a):
        return all(same(getattr(a, f.name), getattr(b, f.name)) for f in fields(a))
    return bool(a == b)


def through_a_file(value: Any, **given: Any) -> Any:
    """Packed, written as ``.npz``, read without pickles, unpacked."""
    stream = io.BytesIO()
    np.savez(stream, **pack(value, given.pop("named", {})))  # type: ignore[arg-type]
    stream.seek(0)
    with np.load(stream, allow_pickle=False) as stored:
        return unpack(dict(stored), PACKAGE, given)


BITS = st.integers(0, 2**64 - 1).map(lambda bits: struct.unpack("<d", struct.pack("<Q", bits))[0])
LETTERS = st.text(st.characters(exclude_categories=()), max_size=8)  # lone surrogates too
KINDS = st.sampled_from(["f8", "f4", "i8", "u1", "?", "c16", ">f8", "<U3", "M8[s]"]).map(np.dtype)
SHAPES = arrays.array_shapes(min_dims=0, max_dims=4, min_side=0, max_side=4)
ARRAYS = KINDS.flatmap(lambda kind: arrays.arrays(kind, SHAPES))
TURNED = st.builds(
    lambda array, seed: array.transpose(np.random.default_rng(seed).permutation(array.ndim)), ARRAYS, st.integers(0, 99)
)
SCALARS = (
    st.sampled_from(["f8", "f4", "i8", "?"])
    .map(np.dtype)
    .flatmap(lambda kind: arrays.arrays(kind, ()))
    .map(lambda array: array[()])
)
PLACES = st.tuples(*[st.floats(-1e3, 1e3)] * 2)
GEOMETRIES = st.one_of(
    st.lists(PLACES, min_size=3, max_size=6).map(lambda ring: shapely.Polygon(ring)),
    st.lists(PLACES, min_size=2, max_size=6).map(shapely.LineString),
    st.lists(PLACES, max_size=4).map(shapely.MultiPoint),
    st.lists(PLACES, min_size=3, max_size=6).map(shapely.LinearRing),
    st.just(shapely.Polygon()),
    PLACES.map(lambda at: shapely.MultiPolygon([shapely.Point(at).buffer(2).difference(shapely.Point(at).buffer(1))])),
)
LEAVES = st.one_of(st.none(), st.booleans(), st.integers(), BITS, LETTERS, ARRAYS, TURNED, SCALARS, GEOMETRIES)
VALUES = st.recursive(
    LEAVES,
    lambda some: st.one_of(
        st.lists(some, max_size=3),
        st.lists(some, max_size=3).map(tuple),
        st.dictionaries(LETTERS, some, max_size=3),
        st.builds(Node, some, some, st.lists(st.builds(Leaf, LETTERS, BITS), max_size=3).map(tuple)),
        st.builds(Slotted, some),
    ),
    max_leaves=12,
)


@given(VALUES)
@settings(max_examples=300, deadline=None)
def test_what_is_unpacked_has_the_types_and_bits_of_what_was_packed(value: Any) -> None:
    assert same(through_a_file(value), value)


@pytest.mark.parametrize("order", [(0, 1, 2), (2, 1, 0), (1, 2, 0), (0, 2, 1)])
def test_axes_keep_their_order_in_memory(order: tuple[int, ...]) -> None:
    """Of a slice the gaps close, and its sums run in the same order."""
    whole = np.random.default_rng(3).normal(size=(7, 40, 50)).transpose(order)
    for array in (whole, whole[::2, 1:, ::3]):
        found = through_a_file(array)
        assert np.argsort(found.strides).tolist() == np.argsort(array.strides).tolist()
        for axis in (None, 0, 1, 2):
            assert found.sum(axis=axis).tobytes() == array.sum(axis=axis).tobytes()


def test_what_its_constructor_would_refuse_or_change_is_restored() -> None:
    node = Node(1, 2)
    object.__setattr__(node, "left", "refused")
    object.__setattr__(node, "made", 7)
    assert same(through_a_file(node), node)


def test_what_is_not_packed_is_given() -> None:
    one, other = Outside(), Outside()
    found = through_a_file((Leaf("a", 1.0), Slotted(one)), named={Outside: "it"}, it=other)
    assert found[1].value is other
    with pytest.raises(UnpackError):
        unpack(pack(one, {Outside: "it"}), PACKAGE)


@pytest.mark.parametrize(
    ("value", "place"),
    [
        (Node(1, (2, Outside())), r"value\.right\[1\]: a Outside"),
        ({"a": [Pair(1, 2)]}, r"value\['a'\]\[0\]: a Pair"),
        ({1: 2}, "value: a dict"),
        (np.array([None]), "value: an array of objects"),
        (make_dataclass("Local", ["a"], namespace={"__qualname__": "f.<locals>.Local"})(1), "value: a Local"),
        ({1, 2}, "value: a set"),
        (b"bytes", "value: a bytes"),
    ],
)
def test_what_cannot_be_packed_is_told_with_its_place(value: Any, place: str) -> None:
    with pytest.raises(TypeError, match=place):
        pack(value)


def test_a_class_that_has_changed_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """A field more, one less, one of another name, no dataclass, no class at all."""
    packed = pack(Leaf("a", 1.0))
    module = sys.modules[__name__]
    for changed in (["name", "value", "more"], ["name"], ["name", "other"]):
        monkeypatch.setattr(module, "Leaf", make_dataclass("Leaf", changed))
        with pytest.raises(UnpackError, match="Leaf"):
            unpack(packed, PACKAGE)
    for changed_to in (Outside, len, None):
        monkeypatch.setattr(module, "Leaf", changed_to)
        with pytest.raises(UnpackError, match="Leaf"):
            unpack(packed, PACKAGE)
    monkeypatch.delattr(module, "Leaf")
    with pytest.raises(UnpackError, match="Leaf"):
        unpack(packed, PACKAGE)


@pytest.mark.parametrize(
    "tree",
    [
        ["dataclass", "os:system", {}],
        ["dataclass", "subprocess:Popen", {"args": "true"}],
        ["dataclass", f"{__name__}:Outside", {}],
        ["dataclass", f"{PACKAGE}.nowhere:Leaf", {}],
        ["dataclass", 5, {}],
        ["array", "7"],
        ["array", "0", 3],
        ["scalar", TREE, 1],
        ["geometry", "Point", "0"],
        ["outside", "it"],
        ["float", "00"],
        ["float", "xyz"],
        ["other", 1],
        ["dict", ["a"]],
        [],
        [[]],
        {"a": 1, "b": ["other"]},
    ],
)
def test_other_content_is_refused(tree: Any) -> None:
    made = {TREE: np.frombuffer(json.dumps(tree).encode(), np.uint8), "0": np.arange(6.0).reshape(2, 3)}
    if isinstance(tree, dict):  # no node is an object of JSON's
        made[TREE] = made[TREE][:-1]
    with pytest.raises(UnpackError):
        unpack(made, PACKAGE)


def test_no_tree_is_refused() -> None:
    for content in ({}, {TREE: np.array([])}, {TREE: np.array("[]")}, {TREE: np.array(5)}):
        with pytest.raises(UnpackError):
            unpack(content, PACKAGE)
