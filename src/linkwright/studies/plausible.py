"""Notes on a motion that fits its model and yet is rarely meant: pins in one place, crossed parallelograms."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions import units as u
from linkwright.findings import Finding, Joined, Term
from linkwright.model.plausible import amount
from linkwright.results import Run
from linkwright.structure import Group
from linkwright.studies.limits.four_links import EQUAL, FourLinks, four_links

Places = dict[str, NDArray[np.complex128]]

NEAR = 1e-7
"""Points nearer than this share of the mechanism's size lie in one place."""
APART = 1e-3
"""Opposite sides of a four-bar that differ in direction by more than this share of their length aren't parallel."""


def coincident(run: Run) -> Iterator[Finding]:
    """A note for each two points of different links that aren't joined, and yet lie in one place all along."""
    signals, size = run.compiled.quantities.signals, run.compiled.assembly.size()
    pins = {point: pin for pin in signals.pins.values() for _, point in pin.members}
    links = {
        point: {*pins[point].links} if point in pins else {link} for point, link in signals.links_of_points.items()
    }
    points = list(links)
    known = np.array([*_places(run, points).values()])
    at_first = np.abs(known[:, None, 0] - known[None, :, 0]) < NEAR * size
    for i, k in np.argwhere(np.triu(at_first, 1)):
        first, second = points[i], points[k]
        if not links[first] & links[second] and np.abs(known[i] - known[k]).max() < NEAR * size:
            path = ("links", signals.links_of_points[second], "points", second)
            yield Finding("plausible.coincident", path, {"first": first, "second": second}, severity="note")


def crossed(run: Run) -> Iterator[Finding]:
    """A note for each four-bar with equal opposite sides that runs as an antiparallelogram."""
    compiled = run.compiled
    for four in (four for four in four_links(compiled) if four.family == "four-bar"):
        a, b, c, d = four.lengths
        even = EQUAL * sum(four.lengths)
        if abs(a - c) > even or abs(b - d) > even or abs(a - b) <= even:
            continue
        pins = _pins(run, four)
        places = _places(run, pins)
        p, q, r, s = (places[pin] for pin in pins)
        if float(np.median(np.abs((q - p) - (r - s)))) > APART * max(four.lengths):
            shown = Joined(amount(compiled.quantities, length, u.LENGTH) for length in (a, b))
            data = {"links": Joined(four.links), "lengths": shown, "rule": _other_rule(run, four)}
            moving = next(link for link in four.links if link in compiled.structure.topology.moving)
            yield Finding("plausible.antiparallelogram", ("links", moving), data, severity="note")


def _pins(run: Run, four: FourLinks) -> list[str]:
    """The points at the corners of a four-bar, in order round it."""
    corners = []
    for one, two in zip(four.links, four.links[1:] + four.links[:1], strict=True):
        shared = (pin for pin in run.compiled.structure.topology.pins.values() if {one, two} <= set(pin.links))
        corners.append(next(shared).point(one))
    return corners


def _other_rule(run: Run, four: FourLinks) -> Term | str:
    """The rule that puts the four-bar together the other way, where one of its groups has one."""
    for group, branch in run.compiled.assembly.branches.items():
        if isinstance(group, Group) and set(group.links) <= set(four.links):
            return Term("or-rule", rule=group.rule(-branch))
    return ""


def _places(run: Run, points: list[str]) -> Places:
    """The places of points at all sampled times, as x + i y."""
    values = run.evaluate([f"{point}.{axis}" for point in points for axis in "xy"], run.t)
    return dict(zip(points, values[::2] + 1j * values[1::2], strict=True))
