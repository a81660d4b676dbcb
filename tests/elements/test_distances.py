"""Points of links by two distances: the triangle by mpmath, exact derivatives, what is refused, pages, any mutation."""

from __future__ import annotations

import random
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
import yaml

from helpers.compiled import compiled_from
from linkwright.compilation import examine
from linkwright.elements.distances import ByDistances
from linkwright.expressions.fields import Position
from linkwright.model.builder import Builder
from linkwright.model.document import Document, read_document
from linkwright.model.live_numbers import live_numbers
from linkwright.model.named_numbers import named_numbers
from linkwright.notation import Pair
from linkwright.notation.duals import Dual
from linkwright.symbols import ExpressionStage, Symbol, jacobian
from model.given import findings, four_bar
from model.test_fuzz import every_one_survives, mutated

EXAMPLE = Path(__file__).parents[2] / "examples" / "ternary_links.yaml"
TEXT = EXAMPLE.read_text(encoding="utf-8")


def corner(a: Any, b: Any, sign: int, start: Pair, end: Pair) -> Pair:
    """The third corner of a triangle, as the product has it."""
    at = ByDistances.model_validate({"from": {"A": 1, "B": 2}, "side": f"{'left' if sign > 0 else 'right'} of A-B"})
    sides = {id(at.from_["A"]): a, id(at.from_["B"]): b}
    return at.coordinates(lambda e, _: sides[id(e)], {"A": start, "B": end}.__getitem__)


def exactly(a: float, b: float, sign: int, start: Pair, end: Pair) -> tuple[Any, Any]:
    """The same by intersecting two circles, in 50 digits, by angles: not by Heron's formula."""
    with mpmath.workprec(max(170, mpmath.mp.prec)):  # where derivatives are taken, more
        x, y = (mpmath.mpf(q) - mpmath.mpf(p) for p, q in zip(start, end, strict=True))
        c, heading = mpmath.hypot(x, y), mpmath.atan2(y, x)
        a, b = mpmath.mpf(a), mpmath.mpf(b)
        turn = heading + sign * mpmath.acos((a * a + c * c - b * b) / (2 * a * c))
        return start.x + a * mpmath.cos(turn), start.y + a * mpmath.sin(turn)


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("seed", range(20))
def test_the_corner_is_that_of_two_circles(seed: int, sign: int) -> None:
    made = np.random.default_rng(seed)
    start, end = Pair(*made.normal(size=2)), Pair(*made.normal(size=2))
    c = float(np.hypot(end.x - start.x, end.y - start.y))
    a = float(made.uniform(0.3, 2) * c)
    b = float(made.uniform(abs(a - c), a + c))
    if seed == 0:  # a needle
        a, b = 0.5 * c, 0.5 * c * (1 + 1e-6)
    found, wanted = corner(a, b, sign, start, end), exactly(a, b, sign, start, end)
    near = 1e-10 if seed == 0 else 1e-13
    assert np.abs(np.array([float(found.x - wanted[0]), float(found.y - wanted[1])])).max() < near * (a + b + c)


def test_derivatives_by_the_sides_are_exact_at_all_orders() -> None:
    start, end = Pair(0.1, -0.2), Pair(0.9, 0.3)
    for side in "ab":
        sides = {"a": 0.7, "b": 0.6}
        found = corner(*(Dual(q, 1.0 if key == side else 0.0) for key, q in sides.items()), 1, start, end)
        for i, part in enumerate(found):

            def moved(q: Any, i: int = i, side: str = side) -> Any:
                return exactly(**{"a": 0.7, "b": 0.6, side: q}, sign=1, start=start, end=end)[i]

            with mpmath.workdps(50):
                assert abs(part.slope - float(mpmath.diff(moved, sides[side]))) < 1e-12
    a, b = Symbol.several("sides", 2)
    x = corner(a, b, 1, start, end).x
    for order in (1, 2, 3):
        ((x,),) = jacobian([x], [a])
        with mpmath.workdps(50):
            known = mpmath.diff(lambda q: exactly(q, 0.6, 1, start, end)[0], 0.7, order)
        assert ExpressionStage([a, b], [], [x]).numbers([0.7, 0.6], [])[0] == pytest.approx(float(known), rel=1e-10)


def test_a_chain_of_corners_is_the_link_by_coordinates() -> None:
    by = four_bar()
    points = {"B": [0, 0], "C": [120, 0], "Q": {"from": {"P": 50, "C": 100}, "side": "right of C-P"}}
    points["P"] = {"from": {"B": 90, "C": 70}, "side": "left of B-C"}  # after the one that needs it
    by["links"]["coupler"]["points"] = points
    short = compiled_from(by)
    p = Pair(*exactly(90, 70, 1, Pair(0, 0), Pair(120, 0)))
    q = exactly(100, 50, -1, Pair(120, 0), p)
    by["links"]["coupler"]["points"] = {"B": [0, 0], "C": [120, 0], "Q": [*map(float, q)], "P": [*map(float, p)]}
    long = compiled_from(by)
    names = [f"{point}.{rate}" for point in "PQ" for rate in ("x", "y", "vx", "vy", "ax", "ay", "jx", "jy")]
    t = np.linspace(0, 1, 13)
    one, other = short.evaluate(names, t), long.evaluate(names, t)
    assert np.abs(one - other).max() < 1e-12 * np.abs(other).max()


IMPOSSIBLE = {"from": {"B": 20, "C": 30}, "side": "left of B-C"}


@pytest.mark.parametrize(
    ("place", "code"),
    [
        (IMPOSSIBLE, "triangle.impossible"),
        ({"from": {"B": 50, "C": 70}, "side": "left of B-C"}, "triangle.impossible"),  # flat
        ({"from": {"B": -90, "C": 70}, "side": "left of B-C"}, "value.too-small"),
        ({"from": {"B": 90}, "side": "left of B-C"}, "triangle.two"),
        ({"from": {"B": 90, "C": 70, "D": 3}, "side": "left of B-C"}, "triangle.two"),
        ({"from": {"B": 90, "C": 70}, "side": "left of B-D"}, "triangle.side"),
        ({"from": {"B": 90, "C": 70}, "side": "left"}, "file.expected"),
        ({"from": {"B": 90, "C": 70}}, "file.missing"),
        ({"from": {"B": 90, "CC": 70}, "side": "left of B-CC"}, "name.unknown-point"),
        ({"from": {"B": 90, "P": 70}, "side": "left of B-P"}, "triangle.circular"),
        ({"from": {"B": 90, "C": "70 kg"}, "side": "left of B-C"}, "expression.units-conflict"),
        ({"x": 90, "y": 70}, "file.expected"),
    ],
)
def test_what_is_refused(place: dict[str, Any], code: str) -> None:
    data = four_bar()
    data["links"]["coupler"]["points"]["P"] = place
    found = findings(yaml.safe_dump(data, sort_keys=False))
    assert code in [finding.code for finding in found]
    assert all(finding.line for finding in found)


def test_an_impossible_triangle_is_told_with_its_numbers() -> None:
    data = four_bar()
    data["links"]["coupler"]["points"]["P"] = IMPOSSIBLE
    _, found = examine(Document.model_validate(data))
    (told,) = found
    assert told.path == ("links", "coupler", "points", "P")
    assert "P-B = 20 mm, P-C = 30 mm, B-C = 120 mm" in told.what
    assert "-70" in told.what


def test_the_builder_writes_the_same() -> None:
    place = {"from": {"B": 90, "C": 70}, "side": "left of B-C"}
    built = Builder("b").frame(A=[0, 0]).link("arm", A=[0, 0], B=[9, 0], C=[50, 5], P=place)
    built.drive("motor", turns="arm", speed="1 rpm", start=0)
    document = built.build()
    at = document.links["arm"].points["P"]
    assert isinstance(at, ByDistances)
    assert at.raw == place
    assert isinstance(document.links["arm"].points["B"], Position)


def test_both_distances_are_live_numbers() -> None:
    document, _ = read_document(TEXT.encode())
    assert document is not None
    numbers = {tuple(one["path"]): one for one in live_numbers(named_numbers(document), TEXT)}
    for point, length in (("A", 0.150), ("D", 0.110)):
        one = numbers["links", "frame", "points", "F", "from", point]
        assert one["value"] == pytest.approx(length, rel=1e-15)
        assert one["low"] > 0
    assert {("parameters", "BP"), ("parameters", "CP")} <= numbers.keys()


@pytest.mark.parametrize("seed", range(60))
def test_mutated_examples_end_in_findings(seed: int) -> None:
    every_one_survives([mutated(random.Random(seed), TEXT)])
