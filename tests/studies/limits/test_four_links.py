"""Types of four-bars and slider-cranks, against turning them by force of numbers."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from helpers.compiled import compiled_from
from helpers.shown import blocks, tables
from linkwright.presentation.blocks import Table
from linkwright.structure.loops import loops_of_four
from linkwright.studies.limits.four_links import FourLinks, four_links
from linkwright.studies.limits.ranges import ranges
from linkwright.studies.limits.report import report
from studies.models import CRANK, UNITS, four_bar, job_of, slider_crank

ANGLES = np.exp(1j * np.linspace(0, 2 * np.pi, 2001))


def spans(distance: Any, p: float, q: float) -> bool:
    """Whether two links p and q reach over all of some distances."""
    return bool(((distance <= p + q) & (distance >= abs(p - q))).all())


def type_by_turning(a: float, b: float, c: float, d: float) -> str:
    """The type of a four-bar by trying every angle of each moving link against the ground d."""
    crank, other = (spans(abs(d - side * ANGLES), b, rest) for side, rest in ((a, c), (c, a)))
    if crank or other:
        return "double-crank" if crank and other else "crank-rocker"
    coupler = spans(abs(d - b * ANGLES), a, c)
    return "double-rocker" if coupler else "triple-rocker"


def four_bar_of(a: float, b: float, c: float, d: float) -> FourLinks:
    """The four-bar at the first angle of its crank at which it closes."""
    reach = abs(d - a * ANGLES)
    fits = np.flatnonzero((reach < 0.999 * (b + c)) & (reach > 1.001 * abs(b - c)))
    start = float(np.degrees(np.angle(ANGLES[fits[0]])))
    drives = {"motor": {**CRANK, "start": f"{start} deg"}}
    (loop,) = four_links(compiled_from(four_bar(a, b, c, d, drives=drives, studies={})))
    return loop


@settings(max_examples=60, deadline=None)
@given(*[st.floats(20, 120)] * 4)
def test_grashof_is_what_turning_shows(a: float, b: float, c: float, d: float) -> None:
    s, p, q, longest = sorted((a, b, c, d))
    margin = s + longest - p - q
    assume(abs(margin) > 0.05 and longest < 0.99 * (s + p + q))
    loop = four_bar_of(a, b, c, d)
    assert loop.kind == type_by_turning(a, b, c, d)
    assert loop.margin == pytest.approx(margin / 1000, abs=1e-12)


@pytest.mark.parametrize(
    ("lengths", "kind", "turning"),
    [
        ((40, 120, 80, 100), "crank-rocker", {"crank"}),
        ((80, 120, 40, 100), "crank-rocker", {"rocker"}),
        ((100, 90, 95, 30), "double-crank", {"crank", "rocker"}),
        ((80, 40, 90, 100), "double-rocker", {"coupler"}),
        ((60, 70, 50, 100), "triple-rocker", set()),
        ((50, 100, 50, 100), "change-point", {"crank", "rocker"}),
        ((40, 90, 80, 50), "change-point", {"crank"}),
        ((90, 80, 50, 40), "change-point", {"crank", "rocker"}),
        ((80, 40, 90, 50), "change-point", {"coupler"}),
        ((50, 90, 40, 80), "change-point", {"rocker"}),
    ],
)
def test_each_type_once(lengths: Any, kind: str, turning: set[str]) -> None:
    loop = four_bar_of(*lengths)
    assert (loop.kind, set(loop.turning)) == (kind, turning)
    assert loop.fixed == "frame"


@pytest.mark.parametrize(
    "lengths", [(50, 100, 50, 100), (100, 50, 100, 50), (40, 90, 80, 50), (60, 100, 70, 90), (50, 90, 40, 80)]
)
@pytest.mark.parametrize("more", [-1e-9, -1e-12, -1e-15, 0.0, 1e-15, 1e-12, 1e-9])
def test_types_and_ranges_agree_near_change_points(lengths: Any, more: float) -> None:
    """The crank turns fully in the list of four-bars where its range is a full turn."""
    a, b, c, d = (length * (1 + more * (length == max(lengths)) * (i == 1)) for i, length in enumerate(lengths))
    drives = {"motor": {**CRANK, "start": "70 deg"}}
    compiled = compiled_from(four_bar(a, b, c, d, drives=drives, studies={}))
    (loop,) = four_links(compiled)
    assert ("crank" in loop.turning) == any(found.full for found in ranges(compiled, "motor", None, 360))


def test_a_change_point_is_told_alike_in_both_tables() -> None:
    drives = {"motor": {**CRANK, "start": "70 deg"}}
    job = job_of(four_bar(50, 100, 50, 100, drives=drives, studies={"limits": {}}))
    assert job.limits is not None
    shown = tables(blocks(report(job.limits), Table))
    assert shown["ranges"][0][-1] == "Full rotation, through change points."
    assert shown["four_links"][0][1:3] == ["change-point", "rocker, crank, through change points"]


@pytest.mark.parametrize("driven", [True, False])
def test_a_cylinder_is_no_whitworth(driven: bool) -> None:
    """A short ground beside a long arm, which a Whitworth's slotted lever would have, and a cylinder across."""
    lift = {"extends": "lift", "position": "330 + 20*sin(180 deg*t/(1 s))"}
    data = {
        "units": UNITS,
        "links": {
            "frame": {"points": {"A": [0, 0], "K": [80, 0]}},
            "arm": {"points": {"A": [0, 0], "M": [300, 0]}},
        },
        "cylinders": {"lift": {"from": "K", "to": "M"}},
        "assembly": {"M": "left of A-K"} if driven else {},
        "drives": {"pump": lift} if driven else {"motor": {**CRANK, "turns": "arm"}},
    }
    (loop,) = four_links(compiled_from(data))
    assert (loop.kind, loop.turning) == (("driven-slide", ()) if driven else ("cylinder", ("lift_barrel", "arm")))


def test_four_bars_off_the_frame_and_over_pins_of_three_links() -> None:
    """A chain of two four-bars: frame-crank-coupler-rocker, and on coupler and rocker a second one that floats."""
    data = four_bar(studies={})
    data["links"]["coupler"]["points"] = {"A": [0, 0], "B": [120, 0], "E": [80, 40]}
    data["links"]["rocker"]["points"] = {"O4": [0, 0], "B": [80, 0], "H": [60, -50]}
    data["links"] |= {"up": {"points": {"E": [0, 0], "K": [70, 0]}}, "down": {"points": {"H": [0, 0], "K": [90, 0]}}}
    data["assembly"] = {"B": "left of A-O4", "K": "left of E-H"}
    compiled = compiled_from(data)
    assert len(loops_of_four(compiled.structure.topology)) == 2
    first, second = four_links(compiled)
    assert first.fixed == "frame"
    assert set(second.links) == {"coupler", "rocker", "up", "down"}
    assert second.fixed is None
    lengths = dict(zip(second.links, second.lengths, strict=True))
    wanted = {"coupler": np.hypot(40, 40), "rocker": np.hypot(20, 50), "up": 70, "down": 90}
    assert lengths == pytest.approx({link: length / 1000 for link, length in wanted.items()})
    s, p, q, longest = sorted(wanted.values())
    assert second.kind == ("grashof" if s + longest < p + q else "non-grashof")


@settings(max_examples=30, deadline=None)
@given(st.floats(20, 120), st.floats(20, 120), st.floats(0, 60))
def test_a_slider_crank_turns_where_its_rod_always_reaches(r: float, l: float, e: float) -> None:  # noqa: E741
    assume(abs(r + e - l) > 0.01 and r < l)
    turns = bool((abs(r * ANGLES.imag - e) <= l).all())
    start = float(np.degrees(np.arcsin(min(1.0, e / (r + l)))))
    drives = {"motor": {**CRANK, "start": f"{start} deg"}}
    (loop,) = four_links(compiled_from(slider_crank(r, l, e, drives=drives, studies={})))
    assert bool(loop.turning) == turns
    assert loop.kind == "slider-crank"


@pytest.mark.parametrize("links", [("arm", "block"), ("block", "arm")])
def test_a_slide_off_the_frame_and_its_offset(links: tuple[str, str]) -> None:
    """An arm's line 15 mm beside its pin, a block's 4 mm beside its own on the other side; either link first."""
    lines = {"arm": "P at 0 deg", "block": "L at 0 deg"}
    data = {
        "units": UNITS,
        "links": {
            "frame": {"points": {"O2": [0, 0], "O4": [100, 0]}},
            "crank": {"points": {"O2": [0, 0], "A": [40, 0]}},
            "block": {"points": {"A": [0, 0], "L": [0, -4]}},
            "arm": {"points": {"O4": [0, 0], "P": [0, 15]}},
        },
        "joints": {"slot": {"prismatic": links, "line": [lines[link] for link in links]}},
        "assembly": {"A": "ahead of O4 along slot"},
        "drives": {"motor": CRANK},
    }
    (loop,) = four_links(compiled_from(data))
    assert loop.kind == "rocking-block"
    assert loop.turning == ("crank",)
    assert sorted(loop.lengths) == pytest.approx([0.019, 0.04, 0.1])
    assert loop.margin == pytest.approx(0.04 + 0.019 - 0.1)
