"""What every registered kind of joint keeps: slopes and actions follow from its closure, action is reaction."""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce
from pathlib import Path

import numpy as np
import pytest
from numpy.random import Generator

import linkwright as lw
from elements.slots import SLOTS, lever
from helpers.compiled import compiled_from
from linkwright.compilation import compile_mechanism
from linkwright.elements import (
    KINDS,
    STILL,
    Inner,
    InnerLine,
    InnerPin,
    OuterLine,
    OuterPin,
    Twist,
    register,
)
from linkwright.elements.pin_in_slot import InnerSlot
from linkwright.elements.prescribed import InnerAngle, InnerTrack, Track
from linkwright.graph.geometry import Geometry
from linkwright.notation import Body, Jet, Pair, Vec, Wrench
from linkwright.notation.planar import turning_axis, unit_vector

EXAMPLES = Path(__file__).parents[2] / "examples"
INNER: dict[str, Inner] = {
    "pin": InnerPin(Pair(0.1, 0.2), Pair(-0.3, 0.05)),
    "slide": InnerLine(Pair(0.1, 0.2), unit_vector(0.4), Pair(-0.3, 0.05), unit_vector(-1.1)),
}
for _slot in SLOTS:
    _compiled = compiled_from(lever(_slot))
    _geometry = Geometry(_compiled.quantities, _compiled.quantities.parameters)
    INNER[f"slot {_slot}"] = KINDS["pin_in_slot"].inner(_geometry, "slot", ("crank", "lever"))
INNER["prescribed angle"] = InnerAngle()
INNER["prescribed place"] = InnerTrack(Track(Pair(0.1, 0.2), Pair(-0.3, 0.05), 0.4))
COUNT = dict.fromkeys(INNER, 2)
"""Of each the number of its links."""
NEEDED = {name for name, one in KINDS.items() if one.entry is not None}
"""Kinds that come with an entry of their own: of each, every joint in the examples counts."""
for _file in sorted(EXAMPLES.glob("*.yaml")):
    _text = _file.read_text(encoding="utf-8")
    if any(f"{{{name}: " in _text for name in NEEDED):
        _compiled = compile_mechanism(lw.load(_file))
        _geometry = Geometry(_compiled.quantities, _compiled.quantities.parameters)
        for _name, _entry in _compiled.mechanism.joints_but_pins():
            if _entry.kind in NEEDED:
                INNER[f"{_file.stem}: {_name}"] = KINDS[_entry.kind].inner(_geometry, _name, _entry.links)
                COUNT[f"{_file.stem}: {_name}"] = len(_entry.links)


def body(random: Generator, order: int = 3) -> Body:
    """A link in any pose and motion."""
    place = Vec(Jet(random.normal(size=order + 1).tolist()), Jet(random.normal(size=order + 1).tolist()))
    turn = Jet(random.normal(size=order).tolist())
    angle = float(random.uniform(-3, 3))
    return Body(place, Pair(*random.normal(size=2).tolist()), turning_axis(unit_vector(angle), turn), turn, angle)


def links_of(name: str, random: Generator) -> list[Body]:
    """The links in any motion; those of pins and slides on each other, where their actions hold."""
    a, inner, rates = body(random), INNER[name], Jet(random.normal(size=3).tolist())
    if isinstance(inner, InnerPin):
        b = OuterPin(a.point(inner.first), inner.second).place_at(float(random.uniform(-3, 3)), rates)
    elif isinstance(inner, InnerLine):
        line = a.point(inner.first), a.direction(inner.first_heading), a.turn
        b = OuterLine(*line, inner.second, inner.second_heading).place_at(float(random.normal()), rates)
    else:
        return [a, *(body(random) for _ in range(COUNT[name] - 1))]
    return [a, b]


def twist(random: Generator) -> Twist:
    return Twist(float(random.integers(2)), Pair(*random.normal(size=2)), Pair(*random.normal(size=2)))


def works(wrenches: Sequence[Wrench], twists: Sequence[Twist]) -> float:
    return float(sum(t.work(w) for w, t in zip(wrenches, twists, strict=True)))


@pytest.mark.parametrize("name", INNER)
@pytest.mark.parametrize("seed", range(20))
def test_slopes_and_actions_follow_from_the_closure(name: str, seed: int) -> None:
    """The slope to a motion is the gap's rate under it; by duality the actions' power is the multipliers times that.
    The sum of the actions is no force and no moment."""
    random, inner = np.random.default_rng(seed), INNER[name]
    bodies = links_of(name, random)
    twists = [twist(random) for _ in bodies]
    slopes = np.array(inner.rates(bodies, twists), dtype=float)
    derived = np.array(Inner.rates(inner, bodies, twists), dtype=float)
    assert slopes == pytest.approx(derived, rel=1e-12, abs=1e-12)
    multipliers = random.normal(size=len(inner.rates(bodies, twists))).tolist()
    actions = inner.actions(bodies, multipliers)
    power = works(actions, twists)
    assert power == pytest.approx(float(np.dot(multipliers, np.array(inner.rates(bodies, twists)))), rel=1e-9, abs=1e-9)
    total = reduce(Wrench.plus, actions)
    assert (total.force.x, total.force.y, total.moment) == pytest.approx((0, 0, 0), abs=1e-9)
    for own, other in zip(actions, Inner.actions(inner, bodies, multipliers), strict=True):
        moved = other.at(own.about)
        assert (own.force.x, own.force.y) == pytest.approx((moved.force.x, moved.force.y), rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("name", [name for name in INNER if name not in ("slide", "slot curve")])
def test_rates_of_the_gap_are_its_derivatives(name: str) -> None:
    """Each order against a difference of the one before, where the links move on by their own rates. The gaps of slides
    and of curves are equations of closed joints, whose rates aren't those of one function."""
    random, inner, h = np.random.default_rng(5), INNER[name], 1e-6
    bodies = [body(random) for _ in range(COUNT[name])]

    def later(one: Body, time: float) -> Body:
        powers = np.array([1.0, time, time**2 / 2, time**3 / 6])

        def on(jet: Jet) -> Jet:
            d = np.array([*jet.d, *[0.0] * 4])
            return Jet([float(d[k : k + 4] @ powers) for k in range(len(jet.d))])

        turn = on(one.turn)
        assert one.angle is not None
        angle = one.angle + float(np.array([*one.turn.d]) @ powers[1:])
        place = Vec(on(one.anchor.x), on(one.anchor.y))
        return Body(place, one.local, turning_axis(unit_vector(angle), turn), turn, angle)

    first, second = (inner.gap(*(later(one, t) for one in bodies)) for t in (-h, h))
    for before, after, now in zip(first, second, inner.gap(*bodies), strict=True):
        for k in range(2):
            assert now.d[k + 1] == pytest.approx((after.d[k] - before.d[k]) / (2 * h), rel=1e-5, abs=1e-5)


@pytest.mark.parametrize("name", INNER)
@pytest.mark.parametrize("factor", [2.0, -2.0])
def test_what_comes_beside_is_in_balance(name: str, factor: float) -> None:
    """Forces beside the multipliers cancel among the links, and their part that follows from the multipliers grows with
    their size."""
    random, inner = np.random.default_rng(8), INNER[name]
    bodies = links_of(name, random)
    multipliers = random.normal(size=len(inner.gap(*bodies))).tolist()
    still, beside, more = (inner.besides(bodies, [k * m for m in multipliers]) for k in (0.0, 1.0, factor))
    for wrenches in (still, beside):
        total = reduce(Wrench.plus, wrenches, Wrench.zero(bodies[0].anchor.now))
        assert (total.force.x, total.force.y, total.moment) == pytest.approx((0, 0, 0), abs=1e-9)
    for at_rest, once, twice in zip(still, beside, more, strict=True):
        for axis in "xy":
            constant, one, two = (float(getattr(w.force, axis)) for w in (at_rest, once, twice))
            assert two - constant == pytest.approx(abs(factor) * (one - constant), rel=1e-9, abs=1e-12)


def test_every_kind_is_covered() -> None:
    """A kind with an entry of its own needs an example to be among these."""
    covered = {type(inner) for inner in INNER.values()}
    assert len(covered) > 3
    files = " ".join(path.read_text(encoding="utf-8") for path in EXAMPLES.glob("*.yaml"))
    assert all(f"{{{name}: " in files for name in NEEDED)


def test_a_kind_registers_once() -> None:
    for name, kind in KINDS.items():
        assert kind.name == name
        assert kind.rows == len(kind.row_units)
        with pytest.raises(ValueError, match=name):
            register(type("Second", (type(kind),), {}))
        assert KINDS[name] is kind


def test_lower_pairs_state_what_the_base_derives() -> None:
    """Pins and slides state slopes and actions for speed and bits; slots leave them to the base."""
    assert InnerPin.rates is not Inner.rates
    assert InnerLine.actions is not Inner.actions
    assert InnerSlot.rates is Inner.rates
    assert InnerSlot.actions is Inner.actions
    assert STILL.velocity(Pair(1.0, 2.0)) == Pair(0.0, 0.0)
