"""Regions against closed forms, and against the mechanism itself looked at in many places."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import shapely

from linkwright.compilation import compile_mechanism
from linkwright.kernels.parameter_batch import Varied
from linkwright.model.document import load
from linkwright.studies.workspace.mesh import DriveBox, found_pits
from linkwright.studies.workspace.region_search import searched
from linkwright.studies.workspace.regions import Region, region
from linkwright.studies.workspace.sheet import ModeSheet
from linkwright.studies.workspace.solving import reaches
from studies.workspace.models import arm, five_bar

EXAMPLES = Path(__file__).parents[3] / "examples"
TURNS = DriveBox((0.0, 0.0), (2 * np.pi, 2 * np.pi), (True, True))


def lens(one: float, other: float, apart: float) -> float:
    """The area that two discs share (Weisstein, Circle-circle intersection)."""
    if apart >= one + other:
        return 0.0
    if apart <= abs(one - other):
        return float(np.pi * min(one, other) ** 2)
    angles = [r * r * np.arccos((apart**2 + r * r - s * s) / (2 * apart * r)) for r, s in ((one, other), (other, one))]
    a, b, c, d = -apart + one + other, apart + one - other, apart - one + other, apart + one + other
    return float(sum(angles) - np.sqrt(a * b * c * d) / 2)


@pytest.fixture(scope="module")
def symmetric() -> list[Region]:
    """Both assemblies of a five-bar with cranks 1, couplers 1.2 and base 1."""
    compiled = five_bar(1, 1.2, 1.2, 1, 1)
    chord = 2e-7
    return [region(ModeSheet(compiled, "C", ("motor", "servo"), (sign,)), TURNS, chord) for sign in (1.0, -1.0)]


def test_both_assemblies_reach_what_both_arms_do(symmetric: list[Region]) -> None:
    """The intersection of two annuli (radii 0.2 and 2.2 about either crank's pin), with two holes: 10.5921588."""
    union = symmetric[0].shape.union(symmetric[1].shape)
    expected = lens(2.2, 2.2, 1.0) - 2 * lens(2.2, 0.2, 1.0) + lens(0.2, 0.2, 1.0)
    assert expected == pytest.approx(10.5921588, abs=1e-7)
    assert union.area == pytest.approx(expected, abs=1e-6)
    assert union.geom_type == "Polygon"
    assert len(union.interiors) == 2


def test_one_assembly_alone_reaches_less(symmetric: list[Region]) -> None:
    for one in symmetric:
        assert one.shape.area == pytest.approx(10.549, abs=5e-4)
        assert len(one.shape.interiors) == 2


def test_where_the_cranks_meet_the_couplers_may_point_anywhere(symmetric: list[Region]) -> None:
    pits = found_pits(symmetric[0].sheet, TURNS)
    np.testing.assert_allclose(np.degrees(np.sort(pits, axis=1)), [[60, 300], [120, 240]], atol=1e-8)
    for steps in (30, 64):
        np.testing.assert_allclose(np.sort(found_pits(symmetric[0].sheet, TURNS, steps)), np.sort(pits), atol=1e-9)


def test_an_arm_reaches_an_annulus_and_a_part_of_it() -> None:
    compiled = arm(1.0, 0.6)
    whole = region(ModeSheet(compiled, "P", ("shoulder", "elbow"), ()), TURNS, 1e-6)
    assert whole.shape.area == pytest.approx(np.pi * (1.6**2 - 0.4**2), rel=1e-6)
    assert len(whole.shape.interiors) == 1
    quarter = DriveBox((0.0, np.pi / 6), (np.pi / 2, np.pi / 2))
    part = region(ModeSheet(compiled, "P", ("shoulder", "elbow"), ()), quarter, 1e-6)
    outer, inner = (1 + 0.36 + 1.2 * np.cos(elbow) for elbow in quarter.low[1:] + quarter.high[1:])
    assert part.shape.area == pytest.approx(np.pi / 4 * (outer - inner), rel=1e-6)


@pytest.fixture(scope="module", params=[(90, 1.0)])
def paper(request: pytest.FixtureRequest) -> Region:
    """The five-bar of Peng and Zi (2010)."""
    alpha, sign = request.param
    compiled = compile_mechanism(load(EXAMPLES / "five_bar_workspace.yaml"))
    p = Varied(compiled, ["alpha"]).parameters(np.array([[np.radians(alpha)]]))[:, 0]
    return region(ModeSheet(compiled, "P", ("motor", "servo"), (sign,), p), TURNS, 3e-8)


def test_all_that_is_reached_lies_inside(paper: Region) -> None:
    """Within the chord tolerance, a millionth of the frame's 30 mm."""
    q = 2 * np.pi * np.random.default_rng(1).random((2, 40_000))
    at = paper.sheet.place(q)[0]
    away = shapely.distance(paper.shape, shapely.points(at.T))
    assert away.max() <= 3e-8
    assert paper.shape.geom_type == "Polygon"


def test_what_is_searched_for_agrees_with_what_is_enclosed(paper: Region) -> None:
    """Faces between curves in the drives' plane, against cells in the plane of the working point."""
    other = searched(paper.sheet, TURNS.askew(), 3e-8)
    assert not other.faults
    assert other.shape.area == pytest.approx(paper.shape.area, rel=2e-6)
    assert other.shape.symmetric_difference(paper.shape).area < 6e-8 * paper.shape.length
    low, high = paper.certificate.area
    assert low <= other.shape.area <= high and high - low < 1e-3 * low
    assert paper.certificate.certified and paper.certificate.parts and paper.certificate.holes


def test_the_boundary_is_singular_and_what_lies_beyond_is_not_reached(paper: Region) -> None:
    edge = shapely.get_coordinates(paper.shape.boundary)[::20]
    paths = [np.stack([paper.sheet.place(part)[0].T for part in (s.a, s.b)], axis=1) for s in paper.segments]
    lines = shapely.multilinestrings(shapely.linestrings(np.concatenate(paths)))
    assert shapely.distance(lines, shapely.points(edge)).max() <= 6e-8  # both are drawn within 3e-8
    for one in paper.segments:
        if one.kind == "singular" and one.a.size:
            here = paper.sheet.look(one.a)
            size = np.abs(here.jacobian).max(axis=(0, 1)) ** 2 * np.abs(here.closure)
            assert (np.abs(here.numerator) <= 1e-6 * size).mean() > 0.999
    outside = shapely.get_coordinates(paper.shape.buffer(2e-4).boundary)[::25]
    inside = shapely.get_coordinates(paper.shape.buffer(-2e-4).boundary)[::25]
    assert not reaches(paper.sheet, TURNS, paper.mesh, outside.T, 1e-9)[0].any()
    found, values = reaches(paper.sheet, TURNS, paper.mesh, inside.T, 1e-9)
    assert found.all()
    np.testing.assert_allclose(paper.sheet.place(values)[0], inside.T, atol=1e-9)


def test_assemblies_mirror_each_other_with_the_assembly_angle() -> None:
    """The region of one assembly at alpha is that of the other at -alpha, upside down; so at 0, and only there, the two
    of one angle are mirror images."""
    compiled = compile_mechanism(load(EXAMPLES / "five_bar_workspace.yaml"))
    p = Varied(compiled, ["alpha"]).parameters(np.radians([[60.0, -60.0, 0.0]]))
    one, other, apart, left, right = (
        region(ModeSheet(compiled, "P", ("motor", "servo"), (sign,), p[:, k]), TURNS, 1e-5).shape
        for k, sign in ((0, 1.0), (1, -1.0), (0, -1.0), (2, 1.0), (2, -1.0))
    )
    for first, second in ((one, other), (left, right)):
        upside_down = shapely.transform(second, lambda at: at * [1.0, -1.0])
        assert first.symmetric_difference(upside_down).area < 1e-6 * first.area + 2e-5 * first.length
        assert first.geom_type == second.geom_type == "Polygon"
    assert apart.area < 0.8 * one.area


@pytest.mark.parametrize(
    ("lengths", "alpha", "holes"),
    [
        ((9.56, 39.97, 28.88, 15.5, 21.92, 39.17), 5.06539, 1),  # a rim that crosses the ends of a drive's turn
        ((22.35, 33.57, 33.57, 22.35, 33.6, 33.57), 0.0, 1),  # two pits, one of them hard to find
    ],
)
def test_no_face_is_left_open(lengths: tuple[float, ...], alpha: float, holes: int) -> None:
    """All that the drives' values reach at random lies inside, but for what the chords leave open."""
    compiled = compile_mechanism(load(EXAMPLES / "five_bar_workspace.yaml"))
    values = np.array([*np.array(lengths) / 1000, alpha])[:, None]
    p = Varied(compiled, ["l1", "l2", "l3", "l4", "l5", "r2", "alpha"]).parameters(values)[:, 0]
    found = region(ModeSheet(compiled, "P", ("motor", "servo"), (1.0,), p), TURNS, 3e-7)
    at = found.sheet.place(2 * np.pi * np.random.default_rng(2).random((2, 20_000)))[0]
    at = at[:, np.isfinite(at).all(axis=0)]
    away = shapely.distance(found.shape, shapely.points(at.T))
    assert (away > 6e-7).sum() == 0
    assert len(found.shape.interiors) == holes
