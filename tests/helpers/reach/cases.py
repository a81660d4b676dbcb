"""Random mechanisms with two drives, a family of them for each seed; most are five-bars made to be hard."""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.reach.circles import TURN
from helpers.reach.mechanisms import Chain, FiveBar, Guide, Mechanism, Span, TwoCylinders, TwoSlides

SHARE = 0.01
"""The least share of the drives' values at which a mechanism closes."""
CYCLE = 20
OTHERS = (6, 13, 19)
"""Seeds of a cycle that aren't five-bars."""
NEAR = 0.02
"""How near to a range's end a start doesn't lie, as a share of the range."""


@dataclass(frozen=True)
class Case:
    """A mechanism of a seed."""

    seed: int
    family: str
    mechanism: Mechanism

    @cached_property
    def document(self) -> dict[str, Any]:
        """Its model file."""
        start = _start(self.mechanism)
        assert start is not None
        return self.mechanism.document(start)


def make(seed: int) -> Case:
    """The case of a seed."""
    cycle, place = divmod(seed, CYCLE)
    if place in OTHERS:
        families, number = OTHER, cycle * len(OTHERS) + OTHERS.index(place)
    else:
        families, number = FIVE_BARS, cycle * (CYCLE - len(OTHERS)) + place - sum(other < place for other in OTHERS)
    name = [*families][number % len(families)]
    rng = random.Random(seed)
    while True:
        mechanism = families[name](rng)
        if _closes(mechanism):
            return Case(seed, name, mechanism)


def _values(mechanism: Mechanism, count: int) -> NDArray[np.float64]:
    spans = np.array(mechanism.spans)[:, :, None]
    return np.random.default_rng(3).uniform(spans[:, 0], spans[:, 1], (2, count))


def _closes(mechanism: Mechanism) -> bool:
    """Whether it does at a share of the drives' values that is worth a study, and at a start."""
    closed = np.isfinite(mechanism.placed(_values(mechanism, 20_000), 0).real)
    return bool(closed.mean() >= SHARE) and _start(mechanism) is not None


def _start(mechanism: Mechanism) -> NDArray[np.float64] | None:
    """Values of the drives at which it closes, and all around them."""
    q = _values(mechanism, 5000)
    closed = np.isfinite(mechanism.placed(q, 0).real)
    for drive, (low, high) in enumerate(mechanism.spans):
        for step in (-NEAR, NEAR):
            beside = q.copy()
            beside[drive] += step * (high - low)
            closed &= np.isfinite(mechanism.placed(beside, 0).real)
            if high - low < TURN:
                closed &= (beside[drive] > low) & (beside[drive] < high)
    return q[:, closed][:, 0] if closed.any() else None


def _length(rng: random.Random, low: float = 5, high: float = 40) -> float:
    return round(rng.uniform(low, high), 2)


def _angle(rng: random.Random) -> float:
    """A whole number of tenths of a degree."""
    return float(np.radians(round(rng.uniform(-180, 180), 1)))


def _place(rng: random.Random) -> dict[str, float]:
    return {"r": _length(rng), "angle": _angle(rng)}


def _span(rng: random.Random) -> Span:
    low, wide = rng.randrange(-180, 180), rng.randrange(30, 331)
    return float(np.radians(low)), float(np.radians(low + wide))


def any_five_bar(rng: random.Random) -> FiveBar:
    """Any lengths."""
    return FiveBar(*(_length(rng) for _ in range(5)), **_place(rng))


def nearly_equal(rng: random.Random) -> FiveBar:
    """Links B-C and D-C that differ by less than 2 % of their sum, and cranks whose pins can meet: small islands of
    positions that don't close. One in ten has equal links."""
    while True:
        l1, l2, _, l4, l5 = (_length(rng) for _ in range(5))
        share = 0.0 if rng.random() < 0.1 else rng.choice((-1, 1)) * 10 ** rng.uniform(-3, math.log10(0.02))
        l3 = round(l2 * (1 + share) / (1 - share), 2)
        if abs(l1 - l4) < l5 < l1 + l4:
            return FiveBar(l1, l2, l3, l4, l5, **_place(rng))


def near_change(rng: random.Random) -> FiveBar:
    """Link D-C so long that the rim of the closing positions nearly touches itself.

    There B-C and D-C lie in line and B and D are l2 + l3 or abs(l2 - l3) apart; with both cranks along the base B and D
    are abs(l5 +- l1 +- l4) apart. The two differ by 1e-2 to 1e-4 of the size.
    """
    while True:
        l1, l2, _, l4, l5 = (_length(rng) for _ in range(5))
        reach = abs(l5 + rng.choice((-1, 1)) * l1 + rng.choice((-1, 1)) * l4)
        off = rng.choice((-1, 1)) * 10 ** rng.uniform(-4, -2) * max(l1, l2, l4, l5)
        l3 = round(rng.choice((reach - l2, l2 - reach, l2 + reach)) + off, 4)
        if 5 <= l3 <= 60:
            return FiveBar(l1, l2, l3, l4, l5, **_place(rng))


def limited(rng: random.Random) -> FiveBar:
    """Ranges of the motor, the servo or both."""
    which = rng.randrange(1, 4)
    motor, servo = _span(rng) if which & 1 else None, _span(rng) if which & 2 else None
    return FiveBar(*(_length(rng) for _ in range(5)), **_place(rng), motor=motor, servo=servo)


def _stroke(rng: random.Random, low: float, high: float) -> Span:
    first = _length(rng, low, high)
    return first, round(first + _length(rng, 10, 80), 2)


def two_cylinders(rng: random.Random) -> TwoCylinders:
    """2-RPR."""
    return TwoCylinders(_length(rng, 20, 120), _stroke(rng, 20, 100), _stroke(rng, 20, 100))


def two_slides(rng: random.Random) -> TwoSlides:
    """PRRRP, on one line, on parallel lines or on any; P at the pin in one of three."""
    l2, l3 = _length(rng), _length(rng)
    way = rng.choice((0.0, 0.0, _angle(rng)))
    foot = complex(_length(rng, -20, 20), rng.choice((0.0, _length(rng, -20, 20))))
    place = {"r": l3, "angle": 0.0} if rng.random() < 1 / 3 else _place(rng)
    return TwoSlides(foot, (0.0, way), l2, l3, **place, first=_stroke(rng, -40, 40), second=_stroke(rng, -40, 40))


def guide(rng: random.Random) -> Guide:
    """A crank with a slide on it."""
    offset = rng.choice((0.0, _length(rng, -15, 15)))
    p = rng.choice((0j, complex(_length(rng, -20, 20), _length(rng, -20, 20))))
    return Guide(offset, p, rng.choice((None, _span(rng))), _stroke(rng, -60, 40))


def chain(rng: random.Random) -> Chain:
    """A four-bar whose rocker carries a driven arm."""
    lengths = (_length(rng) for _ in range(5))
    return Chain(*lengths, motor=rng.choice((None, _span(rng))), elbow=rng.choice((None, _span(rng))))


FIVE_BARS: dict[str, Callable[[random.Random], Mechanism]] = {
    "five-bar, nearly equal": nearly_equal,
    "five-bar, near change": near_change,
    "five-bar, limited": limited,
    "five-bar, any": any_five_bar,
}
OTHER: dict[str, Callable[[random.Random], Mechanism]] = {
    "two cylinders": two_cylinders,
    "two slides": two_slides,
    "crank with slide": guide,
    "four-bar with arm": chain,
}
FAMILIES = (*FIVE_BARS, *OTHER)
