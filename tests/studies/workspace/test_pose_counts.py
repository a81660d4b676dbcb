"""Curves against the number of poses on their sides: those that are missing or false are found."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import shapely
from numpy.typing import NDArray

from helpers.reach import FiveBar, TwoSlides
from helpers.reach.mechanisms import Mechanism
from linkwright.studies.workspace.curves import Segments, refined
from linkwright.studies.workspace.places import ModePlaces
from linkwright.studies.workspace.pose_counts import LATTICE, DrivePaths, contradiction
from studies.workspace.made_up import CHORD, Drawn, drawn

Array = NDArray[np.float64]
MECHANISMS: dict[str, Mechanism] = {
    "whole turns": FiveBar(18.0, 30.0, 27.0, 20.0, 22.0, 14.0, 0.7),
    "ranges": FiveBar(18.0, 30.0, 27.0, 20.0, 22.0, 14.0, 0.7, motor=(0.5, 3.0), servo=(-1.0, 2.5)),
    "two slides": TwoSlides(3 + 25j, (0.2, -0.4), 30.0, 31.0, 18.0, 1.1, (-40.0, 40.0), (-40.0, 40.0)),
}


@pytest.fixture(scope="module", params=MECHANISMS)
def one(request: pytest.FixtureRequest) -> Drawn:
    return drawn(MECHANISMS[request.param])


def paths(places: ModePlaces, segments: list[Segments]) -> DrivePaths:
    return DrivePaths.of(places.sheet, segments)


def lines(some: DrivePaths) -> shapely.Geometry:
    return shapely.multilinestrings(shapely.linestrings(np.stack([some.a, some.b]).transpose(2, 0, 1)))


def test_whole_curves_fit_the_number_of_poses(one: Drawn) -> None:
    every = paths(one.places, one.segments)
    assert len(set(every.kind.tolist())) == (2 if one.places.box.turns == (True, True) else 3)
    assert contradiction(one.places, every, CHORD) is None


@pytest.mark.parametrize("kind", ["singular", "modes", "limit"])
def test_a_curve_that_is_missing_is_found(one: Drawn, kind: str) -> None:
    """All of a kind, so that lattice ways pass where they were."""
    kept = [some for some in one.segments if some.kind != kind]
    gone = lines(paths(one.places, [some for some in one.segments if some.kind == kind]))
    wrong = contradiction(one.places, paths(one.places, kept), CHORD)
    if gone.length == 0:
        assert wrong is None
        return
    assert wrong is not None
    step = np.ptp(np.array(one.shape.bounds).reshape(2, 2), axis=0).max() / LATTICE
    assert shapely.distance(gone, shapely.Point(wrong.at)) < 2 * step
    assert wrong.length > 0.3 * gone.length


def test_a_curve_that_is_false_is_found(one: Drawn) -> None:
    """A straight line between drive values within the ranges is no fold."""
    low, high = np.array(one.places.box.low), np.array(one.places.box.high)
    rng = np.random.default_rng(3)
    while True:  # one along which the mechanism closes
        a, b = (low + (high - low) * rng.uniform(0.1, 0.9, 2) for _ in range(2))
        if (one.places.sheet.place(a[:, None] + (b - a)[:, None] * np.linspace(0, 1, 50))[1] > 1e-3).all():
            break
    false = refined(one.places.sheet, "limit", (a[:, None], b[:, None]), CHORD, None)
    wrong = contradiction(one.places, paths(one.places, [*one.segments, replace(false, kind="singular")]), CHORD)
    assert wrong is not None
    way = lines(paths(one.places, [false]))
    assert shapely.distance(way, shapely.Point(wrong.at)) < CHORD
    assert 0.5 * way.length < wrong.length < 1.1 * way.length


def test_no_curves_are_contradicted_by_nothing(one: Drawn) -> None:
    assert contradiction(one.places, paths(one.places, []), CHORD) is None
