"""Limits against closed forms: ranges, dead centres, strokes, time ratios, transmission angles, change points."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import linkwright as lw
from linkwright.graph.rows import Determinant
from linkwright.studies.limits.extremes import SignalCourse
from linkwright.studies.limits.outcome import LimitsOutcome, RunLimits
from linkwright.studies.limits.ranges import Range
from studies.models import UNITS, codes, four_bar, job_of, refused, slider_crank

EXAMPLES = Path(__file__).parents[3] / "examples"
MM, DEG = 1e-3, np.pi / 180


def limits_of(data: Mapping[str, Any], **options: Any) -> LimitsOutcome:
    job = job_of({**data, "studies": {**data.get("studies", {}), "limits": options}})
    assert all(finding.severity == "note" for finding in job.examined.findings)
    assert job.limits is not None
    return job.limits


def example(name: str, **options: Any) -> LimitsOutcome:
    document = lw.load(EXAMPLES / f"{name}.yaml")
    return limits_of(document.model_dump(by_alias=True, exclude_none=True), **options)


def only(outcome: LimitsOutcome, drive: str | None = None) -> tuple[Range, RunLimits]:
    """The one range of the one drive, or of the named one."""
    (found,) = [d for d in outcome.drives if drive in (None, d.drive)]
    (pair,) = found.ranges
    return pair


def course(stretch: RunLimits, name: str) -> SignalCourse:
    return next(c for c in stretch.courses if c.signal == name)


def place(found: Range, time: float) -> float:
    """The drive's value (rad or m) at a time of its sweep."""
    return found.sweep.origin + time


def same_angle(angle: float, wanted: float, tolerance: float = 1e-9) -> bool:
    return abs((angle - wanted + np.pi) % (2 * np.pi) - np.pi) < tolerance


def test_no_limits_are_made_up_for_a_motion_of_very_many_turns() -> None:
    """A thousand million turns: no samples show where the slider turns round in each of them, the crank alone does."""
    found = limits_of(slider_crank(studies={"cycle": {"turns": "1000000000 motor", "samples": 16}}))
    assert (found.motion, codes(found.warnings)) == (None, ["study.long-motion"])
    assert len(course(only(found)[1], "guide.s").reversals) == 2


def triangle(a: float, b: float, opposite: float) -> float:
    """The angle (rad) between two sides."""
    return float(np.arccos((a * a + b * b - opposite * opposite) / (2 * a * b)))


# Crank-rockers and other four-bars.


@st.composite
def crank_rockers(draw: st.DrawFn) -> tuple[float, float, float, float]:
    """Lengths a, b, c, d with the crank a the shortest, well inside Grashof's condition."""
    b, c, d = (draw(st.floats(60, 140)) for _ in range(3))
    most = sum((b, c, d)) - 2 * max(b, c, d)
    assume(most > 15)
    return draw(st.floats(8, min(0.9 * most, 50))), b, c, d


@settings(max_examples=15, deadline=None)
@given(crank_rockers(), st.floats(-180, 180), st.sampled_from(["60 rpm", "-60 rpm"]))
def test_a_crank_rocker_by_the_law_of_cosines(lengths: Any, start: float, speed: str) -> None:
    a, b, c, d = lengths
    drives = {"motor": {"turns": "crank", "on": "frame", "speed": speed, "start": f"{start} deg"}}
    found, stretch = only(limits_of(four_bar(a, b, c, d, drives=drives, studies={})))
    assert found.full
    rocker = course(stretch, "rocker.angle")
    # Crank and coupler in line: stretched (b + a) and folded (b - a), from O2 to B.
    ends = {}
    for reach in (b + a, b - a):
        crank = triangle(d, reach, c) + (0.0 if reach > b else np.pi)
        ends[reach] = crank, np.pi - triangle(d, c, reach)
    assert len(rocker.reversals) == 2
    for crank, angle in ends.values():
        reversal = min(rocker.reversals, key=lambda r: abs(r.value - angle))
        assert reversal.value == pytest.approx(angle, abs=1e-9)
        assert same_angle(place(found, reversal.time), crank, 1e-7)
    (out, right), (back, left) = sorted(ends.values(), key=lambda end: end[1])
    assert rocker.stroke == pytest.approx(left - right, abs=1e-9)
    rising = (back - out) % (2 * np.pi)
    rising = rising if speed[0] != "-" else 2 * np.pi - rising
    assert rocker.strokes is not None
    assert rocker.strokes.rising == pytest.approx(rising, abs=1e-6)
    assert rocker.strokes.ratio == pytest.approx(max(rising, 2 * np.pi - rising) / min(rising, 2 * np.pi - rising))
    # The transmission angle between coupler and rocker is extreme at the crank angles 0 and 180 deg.
    angles = [triangle(b, c, d - a), triangle(b, c, d + a)]
    least = min(min(angle, np.pi - angle) for angle in angles)
    (transmission,) = stretch.transmission
    assert transmission.angle == pytest.approx(least, abs=1e-9)
    (loop,) = limits_of(four_bar(a, b, c, d, studies={})).loops
    assert (loop.kind, loop.shortest, loop.fixed) == ("crank-rocker", "crank", "frame")


@settings(max_examples=15, deadline=None)
@given(st.floats(55, 90), st.floats(55, 90), st.floats(55, 90), st.floats(100, 150))
def test_dead_points_of_a_crank_that_rocks(a: float, b: float, c: float, d: float) -> None:
    """Triple-rockers: crank limits where coupler and rocker are stretched, or folded on the other side."""
    shortest, longest = min(a, b, c), d
    assume(shortest + longest > a + b + c + d - shortest - longest + 3)
    assume(d + a > b + c + 2 and abs(d - a) > abs(b - c) + 2)
    limit = triangle(a, d, b + c)
    start = 0.3 * limit
    drives = {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": f"{start / DEG} deg"}}
    found, stretch = only(limits_of(four_bar(a, b, c, d, drives=drives, studies={})))
    assert not found.full
    assert (found.low.kind, found.high.kind) == ("group", "group")
    assert found.high.group == "coupler-rocker"
    assert found.low.value == pytest.approx(-limit, abs=1e-12)
    assert found.high.value == pytest.approx(limit, abs=1e-12)
    assert found.high.beyond is not None
    assert found.high.beyond.code == "motion.cannot-assemble"
    worst = a + d - (b + c)
    assert f"{worst:.4g} mm more than the links can span" in found.high.beyond.what
    # The rocker stands along the coupler there.
    tip = a * np.exp(1j * limit) - d
    run = found.sweep
    angle = run.settled(["rocker.angle"], 1)[0, 0]
    assert same_angle(angle, float(np.angle(tip)), 1e-11)
    (transmission,) = stretch.transmission
    assert transmission.angle == 0.0


def test_the_limit_positions_of_the_paper_feeder() -> None:
    """As printed: right 23.5565 deg, left 246.4218 deg, stroke 680.2778 mm (see tests/validation)."""
    found, stretch = only(example("paper_feeder", signals=["E.x"]))
    assert found.full
    for name in ("E.x", "rail.s"):
        slide = course(stretch, name)
        assert slide.stroke == pytest.approx(0.6802777777777778, abs=1e-14)
        places = {r.top: place(found, r.time) / DEG for r in slide.reversals}
        assert places[True] == pytest.approx(23.5565, abs=5e-5)
        assert places[False] == pytest.approx(246.4218, abs=5e-5)
        assert slide.strokes is not None
        # Crank and coupler in line at both ends: the angle between them from the lengths alone.
        between = np.pi + triangle(240, 300, 300) - triangle(550, 300, 300)
        assert slide.strokes.ratio == pytest.approx(between / (2 * np.pi - between), rel=1e-12)


def test_a_drag_link_turns_its_output_fully() -> None:
    found, stretch = only(limits_of(four_bar(100, 90, 95, 30, studies={})))
    assert found.full
    follower = course(stretch, "rocker.angle")
    assert (follower.turns, follower.reversals, follower.strokes) == (1, (), None)


def test_two_ranges_of_one_turn() -> None:
    """A centric slider-crank with a long crank r and a short rod l: |sin| <= l / r, about 0 and about 180 deg."""
    data = slider_crank(160, 50, 0, studies={})
    (limits,) = limits_of(data).drives
    limit = np.arcsin(50 / 160)
    ends = [(found.low.value, found.high.value) for found, _ in limits.ranges]
    np.testing.assert_allclose(ends, [(-limit, limit), (np.pi - limit, np.pi + limit)], atol=1e-12)


# Slider-cranks and quick returns.


@settings(max_examples=15, deadline=None)
@given(st.floats(20, 60), st.floats(110, 200), st.floats(0, 40))
def test_an_offset_slider_crank(r: float, l: float, e: float) -> None:  # noqa: E741
    _, stretch = only(limits_of(slider_crank(r, l, e, studies={})))
    slide = course(stretch, "guide.s")
    assert slide.stroke == pytest.approx((np.sqrt((l + r) ** 2 - e**2) - np.sqrt((l - r) ** 2 - e**2)) * MM, abs=1e-13)
    outer, inner = np.arcsin(e / (l + r)), np.pi + np.arcsin(e / (l - r))
    assert slide.strokes is not None
    assert len(slide.reversals) == 2  # the start is a dead centre where e = 0
    assert slide.strokes.ratio == pytest.approx((inner - outer) / (2 * np.pi - inner + outer), abs=1e-6)
    (transmission,) = stretch.transmission
    assert np.sin(transmission.angle) == pytest.approx(np.sqrt(1 - ((r + e) / l) ** 2), abs=1e-12)
    (loop,) = limits_of(slider_crank(r, l, e, studies={})).loops
    assert loop.kind == "slider-crank"
    assert loop.turning == ("crank",)
    assert loop.margin == pytest.approx((r + e - l) * MM, abs=1e-15)
    assert loop.lengths == pytest.approx((r * MM, l * MM, e * MM))


def test_a_dead_centre_right_at_the_start() -> None:
    found, stretch = only(limits_of(slider_crank(50, 160, 0, studies={})))
    slide = course(stretch, "guide.s")
    assert [(r.top, r.value) for r in slide.reversals] == [
        (True, pytest.approx(0.21, abs=1e-15)),
        (False, pytest.approx(0.11, abs=1e-15)),
    ]
    assert [place(found, r.time) for r in slide.reversals] == pytest.approx([0.0, np.pi], abs=1e-9)
    assert slide.strokes is not None
    assert slide.strokes.ratio == pytest.approx(1.0, abs=1e-9)


def quick_return(r: float, d: float) -> dict[str, Any]:
    """A crank r at the height d over the pin of an arm that its block slides on; a rod of 300 mm drives a slider
    along the line through the arm's pin."""
    return {
        "units": UNITS,
        "links": {
            "frame": {"points": {"O2": [0, d], "O4": [0, 0]}},
            "crank": {"points": {"O2": [0, 0], "A": [r, 0]}},
            "block": {"points": {"A": [0, 0]}},
            "arm": {"points": {"O4": [0, 0], "P": [60, 0]}},
            "rod": {"points": {"P": [0, 0], "Q": [300, 0]}},
            "ram": {"points": {"Q": [0, 0]}},
        },
        "joints": {
            "slot": {"prismatic": ["arm", "block"], "line": ["O4 at 0 deg", "A at 0 deg"]},
            "guide": {"prismatic": ["frame", "ram"], "line": ["O4 at 0 deg", "Q at 0 deg"]},
        },
        "assembly": {"A": "ahead of O4 along slot", "Q": "ahead of P along guide"},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": "10 deg"}},
    }


@pytest.mark.parametrize(("r", "d"), [(40, 100), (30, 120)])
def test_the_crank_shaper_in_closed_form(r: float, d: float) -> None:
    """The arm swings by asin(r/d) each way: time ratio (180 deg + swing) / (180 deg - swing)."""
    found, stretch = only(limits_of(quick_return(r, d)))
    arm, swing = course(stretch, "arm.angle"), 2 * np.arcsin(r / d)
    assert arm.stroke == pytest.approx(swing, abs=1e-14)
    assert arm.strokes is not None
    assert arm.strokes.ratio == pytest.approx((np.pi + swing) / (np.pi - swing), rel=1e-10)
    loop = next(loop for loop in limits_of(quick_return(r, d)).loops if "block" in loop.links)
    assert (loop.kind, loop.turning) == ("rocking-block", ("crank",))
    # The block's force is normal to the arm, whose point there moves along it: 90 deg throughout.
    transmission = next(t for t in stretch.transmission if t.group == "block-arm")
    assert transmission.angle == pytest.approx(np.pi / 2)
    assert transmission.time is None
    assert found.full


@pytest.mark.parametrize(("r", "d"), [(100, 40), (120, 30)])
def test_the_whitworth_quick_return_in_closed_form(r: float, d: float) -> None:
    """The ram turns where the arm lies along its line, as high as O4: the crank pin is d below O2 there."""
    _, stretch = only(limits_of(quick_return(r, d)))
    arm, ram = course(stretch, "arm.angle"), course(stretch, "guide.s")
    assert arm.turns == 1
    assert ram.stroke == pytest.approx(0.12, abs=1e-14)
    half = np.arccos(d / r)
    assert ram.strokes is not None
    assert ram.strokes.ratio == pytest.approx((np.pi - half) / half, rel=1e-10)
    loop = next(loop for loop in limits_of(quick_return(r, d)).loops if "block" in loop.links)
    assert loop.kind == "turning-block"
    assert set(loop.turning) == {"crank", "arm"}


# Sliding drives.


@pytest.fixture
def driven_slider() -> dict[str, Any]:
    data = slider_crank(50, 160, 0, studies={})
    data["drives"] = {"ram": {"slides": "slider", "on": "frame", "speed": "10 mm/s", "start": 150}}
    return {**data, "assembly": {"B": "left of A-C"}}


def test_a_sliding_drive_goes_as_far_as_the_links_let_it(driven_slider: Any) -> None:
    found, stretch = only(limits_of(driven_slider))
    assert (found.low.value, found.high.value) == pytest.approx((0.11, 0.21), abs=1e-14)
    assert found.low.kind == found.high.kind == "group"
    crank = course(stretch, "crank.angle")
    assert crank.low.value == pytest.approx(0.0, abs=1e-13)
    assert crank.high.value == pytest.approx(np.pi, abs=1e-13)


def test_a_given_range_holds_all_that_assembles(driven_slider: Any) -> None:
    (limits,) = limits_of(driven_slider, ranges={"ram": [-300, 180]}).drives
    ends = [(found.low.value, found.high.value) for found, _ in limits.ranges]
    np.testing.assert_allclose(ends, [(-0.21, -0.11), (0.11, 0.18)], atol=1e-14)
    assert limits.ranges[1][0].high.kind == "window"


def test_a_slide_that_runs_away() -> None:
    """An arm at the angle phi moves a bar at the height h by h / tan(phi): no limit towards 0 and 180 deg."""
    data = {
        "units": UNITS,
        "links": {
            "frame": {"points": {"O": [0, 0], "H": [0, 100]}},
            "arm": {"points": {"O": [0, 0]}},
            "block": {"points": {"P": [0, 0]}},
            "bar": {"points": {"P": [0, 0]}},
        },
        "joints": {
            "slot": {"prismatic": ["arm", "block"], "line": ["O at 0 deg", "P at 0 deg"]},
            "rail": {"prismatic": ["frame", "bar"], "line": ["H at 0 deg", "P at 0 deg"]},
        },
        "drives": {"motor": {"turns": "arm", "on": "frame", "speed": "10 deg/s", "start": "45 deg"}},
    }
    (limits,) = limits_of(data).drives
    ends = [(found.low.value, found.high.value) for found, _ in limits.ranges]
    np.testing.assert_allclose(ends, [(0, np.pi), (np.pi, 2 * np.pi)], atol=1e-12)
    found, stretch = limits.ranges[0]
    assert (found.low.kind, found.high.kind) == ("pole", "pole")
    bar = course(stretch, "rail.s")
    assert (bar.high.value, bar.low.value) == (np.inf, -np.inf)
    slot = course(stretch, "slot.s")
    assert slot.low.value == pytest.approx(0.1, abs=1e-14)
    assert slot.high.value == np.inf


# Groups beyond dyads.


def test_the_ends_of_a_cylinder_under_a_boom() -> None:
    """The pins of frame and boom in line with the hinge: OM - OK and OK + OM, to round-off."""
    data = lw.load(EXAMPLES / "boom_cylinder.yaml").model_dump(by_alias=True, exclude_none=True)
    del data["cylinders"]["lift"]["length"]
    found, stretch = only(limits_of(data))
    base, arm = np.hypot(0.3, 0.9), np.hypot(1.3, 0.1)
    assert (found.low.kind, found.high.kind) == ("group", "group")
    assert found.low.value == pytest.approx(arm - base, abs=1e-12)
    assert found.high.value == pytest.approx(arm + base, abs=1e-12)
    # From folded to stretched the boom turns by half a turn.
    assert course(stretch, "boom.angle").stroke == pytest.approx(np.pi, abs=1e-6)


def test_a_cylinder_moves_over_its_stroke() -> None:
    """The boom's angle at both ends by the law of cosines; other ranges are there for the asking."""
    outcome = example("boom_cylinder")
    found, stretch = only(outcome)
    assert (found.low.kind, found.high.kind, found.low.dead) == ("stroke", "stroke", False)
    assert (found.low.value, found.high.value) == pytest.approx((0.9, 1.5), abs=1e-14)
    base, arm = np.hypot(0.3, 0.9), np.hypot(1.3, 0.1)
    swing = triangle(base, arm, 1.5) - triangle(base, arm, 0.9)
    assert course(stretch, "boom.angle").stroke == pytest.approx(swing, abs=1e-12)
    assert outcome.warnings == []
    wide, _ = only(example("boom_cylinder", ranges={"raise": [800, 1600]}))
    assert (wide.low.kind, wide.high.value) == ("window", pytest.approx(1.6, abs=1e-14))


def test_a_drive_is_told_of_the_cylinders_that_it_takes_too_far() -> None:
    """A damper from the rocker to the frame: its length follows the crank, whose turn it would not allow."""
    data = four_bar(40, 120, 80, 100, studies={})
    data["links"]["frame"]["points"]["G"] = [190, 60]
    data["cylinders"] = {"damper": {"from": "G", "to": "B", "length": [60, 90]}}
    outcome = limits_of(data)
    found, stretch = only(outcome)
    assert found.full
    ends = course(stretch, "damper.s")
    assert ends.low.value < 0.06
    assert ends.high.value > 0.09
    assert codes(outcome.warnings) == ["study.cylinder-length"] * 2
    assert {w.severity for w in outcome.warnings} == {"warning"}
    for warning, end in zip(outcome.warnings, (ends.low, ends.high), strict=True):
        assert float(warning.data["length"]) == pytest.approx(end.value / MM, rel=1e-4)
        assert float(warning.data["value"]) == pytest.approx(place(found, end.time) / DEG, abs=1e-3)
        assert warning.path == ("cylinders", "damper", "length")


P, B, Q = (np.array(place) / 1000 for place in ((55, 40), (60, 120), (180, 90)))
"""Pins of examples/crank_cylinder.yaml: those of the cylinder, and that of its two links."""


def test_the_ends_of_a_higher_groups_path_both_ways() -> None:
    """Cylinder between crank and coupler: its pins in line with theirs, which dyads could not tell."""
    found, _ = only(example("crank_cylinder"))
    bp, bq = np.hypot(*(P - B)), np.hypot(*(Q - B))
    assert (found.low.kind, found.high.kind) == ("cluster", "cluster")
    assert found.low.value == pytest.approx(bq - bp, abs=3e-8)
    assert found.high.value == pytest.approx(bp + bq, abs=3e-8)
    assert found.low.value > bq - bp


def test_a_sweep_of_a_higher_group_meets_the_law_of_cosines_all_over() -> None:
    found, _ = only(example("crank_cylinder"))
    t = np.linspace(found.sweep.start, found.sweep.stop, 41)[1:-1]
    crank, coupler = found.sweep.evaluate(["crank.angle", "coupler.angle"], t)
    bp, bq, length = np.hypot(*(P - B)), np.hypot(*(Q - B)), found.sweep.origin + t
    at_pin = np.arccos((bp**2 + bq**2 - length**2) / (2 * bp * bq))
    turned = (coupler - crank) - (coupler - crank)[20]
    np.testing.assert_allclose(turned, at_pin - at_pin[20], atol=1e-10)


def test_a_platform_turns_fully_and_swings_as_its_cycle_does() -> None:
    found, stretch = only(outcome := example("platform"))
    assert found.full
    assert outcome.motion is not None
    for name in ("leg2.angle", "leg3.angle"):
        alone, along = course(stretch, name), course(outcome.motion, name)
        assert alone.stroke == pytest.approx(along.stroke, abs=1e-12)
        assert alone.strokes is not None


# Several drives.


def test_each_drive_alone_and_the_motion() -> None:
    outcome = example("five_bar", signals=["P.x"])
    assert [limits.drive for limits in outcome.drives] == ["motor", "servo"]
    for drive, crank in (("motor", 8), ("servo", 10)):
        found, stretch = only(outcome, drive)
        assert found.full
        assert course(stretch, "P.x").stroke > 0
        # The other crank stands still at its start: at O4 + 10j, or at 8.
        fixed = 30 + 10j if drive == "motor" else 8 + 0j
        pivot = 0j if drive == "motor" else 30 + 0j
        gap = abs(fixed - pivot)
        angles = [triangle(26, 28, distance) for distance in (gap - crank, gap + crank)]
        least = min(min(angle, np.pi - angle) for angle in angles)
        assert stretch.transmission[0].angle == pytest.approx(least, abs=1e-9)
    assert outcome.motion is not None
    document = lw.load(EXAMPLES / "five_bar.yaml")
    reach_x = next(m for m in lw.run(document).cycle.measures if m.name == "reach_x")  # type: ignore[union-attr]
    along = course(outcome.motion, "P.x")
    assert [along.low.value, along.high.value] == pytest.approx([f.value for f in reach_x.found], abs=1e-12)


def test_one_drive_of_several() -> None:
    assert [limits.drive for limits in example("five_bar", drives=["servo"]).drives] == ["servo"]


# Change points.


def test_a_parallelogram_has_its_change_points_and_no_dead_centre_there() -> None:
    data = four_bar(50, 100, 50, 100, studies={})
    data["drives"] = {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": "40 deg"}}
    found, stretch = only(outcome := limits_of(data))
    assert [place(found, touch.time) for touch in stretch.touches] == pytest.approx([np.pi, 2 * np.pi], abs=1e-7)
    assert {touch.group for touch in stretch.touches} == {"coupler-rocker"}
    rocker = course(stretch, "rocker.angle")
    assert rocker.reversals == ()
    assert rocker.low.value == pytest.approx(0.0, abs=1e-7)
    assert rocker.high.value == pytest.approx(np.pi, abs=1e-7)
    assert stretch.transmission[0].angle == 0.0
    assert outcome.loops[0].kind == "change-point"


def test_outer_pins_that_meet() -> None:
    """A crank as long as its ground: at 270 deg the block passes the arm's pin, and the arm may point anywhere."""
    found, stretch = only(limits_of(quick_return(50, 50)))
    meeting = [touch for touch in stretch.touches if touch.group == "block-arm"]
    assert [place(found, touch.time) for touch in meeting] == pytest.approx([3 * np.pi / 2], abs=1e-6)


# Signals and their rates.


def test_a_rate_is_that_at_unit_speed() -> None:
    """guide.v of a centric slider-crank at 1 rad/s: ds/dphi, whose largest value r and l give."""
    _, stretch = only(limits_of(slider_crank(50, 160, 0, studies={}), signals=["guide.v"]))
    angle = np.linspace(0, 2 * np.pi, 200_001)
    rate = -0.05 * np.sin(angle) - 0.05**2 * np.sin(angle) * np.cos(angle) / np.sqrt(
        0.16**2 - (0.05 * np.sin(angle)) ** 2
    )
    assert course(stretch, "guide.v").high.value == pytest.approx(rate.max(), rel=1e-9)


def test_a_rate_has_no_limit_at_a_dead_point() -> None:
    data = four_bar(60, 70, 50, 100, studies={})
    _, stretch = only(limits_of(data, signals=["rocker.omega", "hypot(B.x, B.y)"]))
    rate = course(stretch, "rocker.omega")
    assert rate.high.value == np.inf or rate.low.value == -np.inf
    assert course(stretch, "hypot(B.x, B.y)").stroke < 0.1


# Transmission angles are what they are said to be.


def test_the_transmission_angle_is_that_of_force_and_motion() -> None:
    """The rocker's load comes through a massless coupler: at B, |F . v| over |F| |v| is the angle's sine."""
    data = four_bar(studies={"cycle": {"turns": "1 motor", "samples": 90}})
    for link in data["links"].values():
        link.pop("mass", None)
        link.pop("shape", None)
    data.pop("gravity")
    data["loads"] = {"work": {"on": "rocker", "torque": -1}}
    result = job_of(data).cycle.result  # type: ignore[union-attr]
    names = ("force(coupler, rocker).x", "force(coupler, rocker).y", "B.vx", "B.vy")
    fx, fy, vx, vy = (result[name] for name in names)
    sine = np.abs(fx * vx + fy * vy) / np.hypot(fx, fy) / np.hypot(vx, vy)
    determinant = np.abs(result.run.compiled.evaluate([Determinant("coupler-rocker")], result.t)[0])
    np.testing.assert_allclose(sine, determinant, atol=1e-9)


@pytest.mark.parametrize("offset", [0, 15])
def test_the_transmission_angle_of_sliding_groups(offset: float) -> None:
    """The same where a block drives an arm (RPR) and where a rod drives a ram (RRP)."""
    data = quick_return(40, 100)
    data["joints"]["slot"]["line"] = ["P at 0 deg", "A at 0 deg"]
    data["links"]["arm"]["points"]["P"] = [60, offset]
    data["loads"] = {"work": {"on": "ram", "at": "Q", "along": "guide", "force": -100}}
    data["studies"] = {"cycle": {"turns": "1 motor", "samples": 90}}
    result = job_of(data).cycle.result  # type: ignore[union-attr]
    compiled, t = result.run.compiled, result.t
    # RRP: the rod's force on the ram, which moves along x.
    fx, fy = result["force(rod, ram).x"], result["force(rod, ram).y"]
    rows = compiled.evaluate([Determinant("rod-ram"), Determinant("block-arm")], t)
    np.testing.assert_allclose(np.abs(fx) / np.hypot(fx, fy), np.abs(rows[0]), atol=1e-9)
    # RPR: the block's force on the arm acts through A, where the arm moves across A - O4.
    fx, fy = result["force(block, arm).x"], result["force(block, arm).y"]
    x, y = result["A.x"], result["A.y"]
    sine = np.abs(-fx * y + fy * x) / np.hypot(fx, fy) / np.hypot(x, y)
    np.testing.assert_allclose(sine, np.abs(rows[1]), atol=1e-9)


def on_rail(bodies: dict[str, Any], joints: dict[str, Any]) -> dict[str, Any]:
    """A crank of 50 mm about O; a bar on a level rail 100 mm up, pushed by 20 N."""
    return {
        "units": UNITS,
        "links": {
            "frame": {"points": {"O": [0, 0], "H": [0, 100]}},
            "crank": {"points": {"O": [0, 0], "E": [50, 0]}},
            "block": {"points": {"E": [0, 0]}},
            "bar": {"points": {"P": [0, 0]}},
            **bodies,
        },
        "joints": {"rail": {"prismatic": ["frame", "bar"], "line": ["H at 0 deg", "P at 0 deg"]}, **joints},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": "10 deg/s", "start": "60 deg"}},
        "loads": {"work": {"on": "bar", "at": "P", "along": "rail", "force": -20}},
        "studies": {"cycle": {"duration": "5 s", "samples": 40}},
    }


@pytest.mark.parametrize(
    ("signature", "data"),
    [
        # A block on the crank itself, pinned to the bar.
        (
            "PRP",
            on_rail(
                {"block": {"points": {"P": [0, 0]}}},
                {"slot": {"prismatic": ["crank", "block"], "line": ["E at 0 deg", "P at 0 deg"]}},
            ),
        ),
        # A block on the crank's pin, in a slot of the bar at 70 deg.
        (
            "RPP",
            on_rail({}, {"slot": {"prismatic": ["bar", "block"], "line": ["P at 70 deg", "E at 0 deg"]}}),
        ),
    ],
)
def test_the_transmission_angle_of_groups_with_one_mode(signature: str, data: Any) -> None:
    """The bar moves along x: the share of the block's force in x is the sine."""
    result = job_of(data).cycle.result  # type: ignore[union-attr]
    (group,) = result.run.compiled.structure.groups
    assert group.signature == signature
    fx, fy = result["force(block, bar).x"], result["force(block, bar).y"]
    rows = result.run.compiled.evaluate([Determinant(group.label)], result.t)
    np.testing.assert_allclose(np.abs(fx) / np.hypot(fx, fy), np.abs(rows[0]), atol=1e-12)
    (angle,) = only(limits_of(data, ranges={"motor": [60, 110]}))[1].transmission
    assert angle.angle == pytest.approx(np.arcsin(np.abs(rows[0]).min()), abs=1e-6)


# Beside a cycle; options.


def test_a_motion_that_stops_is_a_warning_here() -> None:
    data = four_bar(60, 70, 50, 100, studies={"cycle": {"turns": "1 motor"}})
    outcome = limits_of(data)
    assert outcome.motion is None
    assert {(f.code, f.severity) for f in outcome.warnings} == {("motion.cannot-assemble", "warning")}
    assert outcome.done


@pytest.mark.parametrize(
    ("options", "code"),
    [
        ({"drives": ["moto"]}, "name.unknown"),
        ({"ranges": {"moto": [0, 90]}}, "name.unknown"),
        ({"ranges": {"motor": [90, 0]}}, "value.not-rising"),
        ({"ranges": {"motor": [0, "5 mm"]}}, "expression.units-conflict"),
        ({"ranges": {"motor": [0, "1e9 deg"]}}, "study.wide-range"),
        ({"ranges": {"motor": [0, "1/0"]}}, "value.not-finite"),
        ({"ranges": {"motor": [0, "x"]}}, "name.unknown-parameter"),
        ({"ranges": {"motor": [0]}}, "file.expected"),
        ({"signals": ["rocker.angel"]}, "signal.no-attribute"),
        ({"signals": ["Q.x"]}, "name.unknown-element"),
        ({"signals": ["motor.torque"]}, "study.not-in-sweep"),
        ({"signals": ["2*force(frame, crank).x"]}, "study.not-in-sweep"),
        ({"signals": ["energy.kinetic"]}, "study.not-in-sweep"),
        ({"signals": ["B.x*t"]}, "study.not-in-sweep"),
        ({"signals": ["B.x + rocker.angle"]}, "expression.units-mixed"),
        ({"signals": ["B.x +"]}, "expression.syntax"),
        ({"samples": 3}, "study.options"),
        ({"sample": 300}, "file.unknown-key"),
    ],
)
def test_wrong_options(options: dict[str, Any], code: str) -> None:
    assert codes(refused(four_bar(studies={"limits": options}))) == [code]


def test_an_output_that_stands_at_zero_to_round_off_has_no_dead_centres() -> None:
    """Crank and rod of one length, folded: the slider stands on the crank's axis, its place 1e-17 of their length."""
    data = slider_crank(r=300, l=300, e=0, assembly={"C": "behind B along guide"})
    data["drives"] = {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": "30 deg"}}
    outcome = limits_of({**data, "studies": {}}, ranges={"motor": ["10 deg", "60 deg"]})
    guide = course(only(outcome)[1], "guide.s")
    assert abs(guide.high.value - guide.low.value) < 1e-15
    assert guide.reversals == ()


def test_a_signal_with_a_pole_inside_the_range_is_unbounded_in_both_directions() -> None:
    """Transmission ratio of a crank-rocker: at the rocker's two ends it passes through infinity."""
    outcome = limits_of(four_bar(), signals=["crank.omega/rocker.omega"])
    ratio = course(outcome.drives[0].ranges[0][1], "crank.omega/rocker.omega")
    assert (ratio.low.value, ratio.high.value) == (-np.inf, np.inf)
