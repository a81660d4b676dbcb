"""Regions of two-drive mechanisms other than the five-bar, against closed forms and against their own inverses.

The inverse of each mechanism is written out with circles and lines in complex numbers (mm): given a place of the
working point, it says whether some values within the drives' ranges put it there in a mode. Of random places the region
must hold those that the inverse does, but for some within a few chords of its boundary.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely
from numpy.typing import NDArray

import linkwright as lw
from helpers.workspaces import arm, findings, performed
from linkwright.studies.workspace.outcome import Workspace
from studies.workspace.test_regions import lens

Places = NDArray[np.complex128]
Mask = NDArray[np.bool_]
Reaches = Callable[[Places, float], Mask]
Pair = tuple[float, float]
EXAMPLES = Path(__file__).parents[3] / "examples"
MM2 = 1e6
PLACES = 20_000


def made(links: Any, joints: Any, assembly: Any, moved: Any, **options: Any) -> dict[str, Any]:
    parts = {"parameters": {}, "links": links, "joints": joints, "assembly": assembly, "drives": moved}
    return arm() | parts | {"studies": {"workspace": {"chord": 1e-4, **options}}}


def turned(link: str) -> dict[str, Any]:
    return {"turns": link, "on": "frame", "speed": "60 rpm", "start": "30 deg"}


def workspace_of(data: dict[str, Any], reaches: Reaches) -> Workspace:
    """The workspace, each of its regions held to the inverse."""
    outcome = performed(data).workspace
    assert outcome is not None and outcome.done and not outcome.warnings
    (one,) = outcome.workspaces
    for region in one.regions:
        low, high = np.array(region.shape.bounds).reshape(2, 2)
        margin = (high - low) / 10
        at = np.random.default_rng(0).uniform(low - margin, high + margin, (PLACES, 2))
        with np.errstate(invalid="ignore"):
            expected = reaches((at[:, 0] + 1j * at[:, 1]) * 1e3, region.signs[0])
        wrong = shapely.contains_xy(region.shape, *at.T) != expected
        assert expected.sum() > PLACES / 20
        near = shapely.distance(region.shape.boundary, shapely.points(at[wrong]))
        assert (near <= 3 * outcome.chord).all(), (region.mode, wrong.sum())
    return one


def within(value: Any, ends: Pair) -> Mask:
    return np.asarray((value >= ends[0]) & (value <= ends[1]))


def on_side(of: Places, start: Any, stop: Any, sign: float) -> Mask:
    """Whether places are to the left of start-stop (sign 1) or to the right."""
    return np.asarray((np.conj(stop - start) * (of - start)).imag * sign > 0)


def two_cylinders(base: float, left: Pair, right: Pair, tool: Pair | None = None) -> tuple[dict[str, Any], Reaches]:
    """Cylinders from A and, so far beside it, B to P; T is fixed to the first one's rod, whose x axis is A-P."""
    data = made(
        {
            "frame": {"points": {"A": [0, 0], "B": [base, 0]}},
            "barrel": {"points": {"A": [0, 0]}},
            "rod": {"points": {"P": [0, 0], **({"T": [*tool]} if tool else {})}},
        },
        {"left": {"prismatic": ["barrel", "rod"], "line": ["A at 0", "P at 0"]}},
        {"P": "left of A-B"},
        {"first": {"extends": "left", "position": left[1]}, "second": {"extends": "right", "position": right[1]}},
        point="T" if tool else "P",
        chord=1e-4 if tool else 1e-5,
        drives={"first": [*left]},
    )
    data["cylinders"] = {"right": {"from": "B", "to": "P", "length": [*right]}}
    x, y = tool or (0.0, 0.0)

    def reaches(z: Places, sign: float) -> Mask:
        found = np.zeros(z.shape, dtype=bool)
        for root in (1, -1):
            length = root * np.sqrt(np.abs(z) ** 2 - y * y) - x
            p = length * z / (length + x + 1j * y)
            found |= within(length, left) & within(np.abs(p - base), right) & on_side(p, 0, base, sign)
        return found

    return data, reaches


def annuli(base: float, left: Pair, right: Pair) -> float:
    """The area that two rings share."""
    discs = [(one * other, left[one > 0], right[other > 0]) for one in (1, -1) for other in (1, -1)]
    return sum(sign * lens(a, b, base) for sign, a, b in discs)


@pytest.mark.parametrize(
    ("base", "left", "right"),
    [(50, (40, 70), (35, 60)), (50, (20, 45), (20, 45)), (20, (40, 70), (40, 70))],
    ids=["apart", "to the base", "around both feet"],
)
def test_two_cylinders_reach_what_both_rings_share(base: float, left: Pair, right: Pair) -> None:
    one = workspace_of(*two_cylinders(base, left, right))
    above, below = one.regions
    expected = annuli(base, left, right) / 2
    for region in one.regions:
        assert region.figures.area * MM2 == pytest.approx(expected, rel=1e-5)
    assert above.figures.bounds[3] == pytest.approx(-below.figures.bounds[1]) and above.figures.bounds[1] >= -1e-8
    assert one.union.area * MM2 == pytest.approx(2 * expected, rel=1e-5)
    holes = sum(len(part.interiors) for part in shapely.get_parts(one.union))
    assert holes == (base == 20)  # around the feet neither rod can be short enough


def test_a_tool_on_a_rod_that_retracts_behind_the_foot() -> None:
    workspace_of(*two_cylinders(50, (20, 45), (20, 45), (-30, 20)))


@pytest.mark.filterwarnings("error")
def test_cylinders_that_get_to_their_feet() -> None:
    data, reaches = two_cylinders(50, (0, 75), (0, 75))
    data["studies"]["workspace"]["modes"] = "own"
    (region,) = workspace_of(data, reaches).regions
    assert region.figures.area * MM2 == pytest.approx(lens(75, 75, 50) / 2, rel=1e-5)


def test_the_example_of_two_cylinders() -> None:
    outcome = lw.workspace(EXAMPLES / "two_cylinder_workspace.yaml")
    expected = annuli(500, (400, 700), (350, 600)) / 2
    assert [region.mode for region in outcome.regions] == ["P: left of A-B", "P: right of A-B"]
    for region in outcome.regions:
        assert region.figures.area * MM2 == pytest.approx(expected, rel=1e-5)
        assert {one.kind for one in region.region.segments if one.a.size} == {"limit"}


def test_two_slides_on_two_rails() -> None:
    """PRRRP, one rail 25 mm above the other; the point lies beside the second link."""
    height, arm_, ends = 25, complex(10, 15), (-40.0, 40.0)
    links = {
        "frame": {"points": {"A": [0, 0], "H": [0, height]}},
        "one": {"points": {"B": [0, 0]}},
        "two": {"points": {"D": [0, 0]}},
        "first": {"points": {"B": [0, 0], "C": [30, 0]}},
        "second": {"points": {"D": [0, 0], "C": [30, 0], "P": [arm_.real, arm_.imag]}},
    }
    lower = {"prismatic": ["frame", "one"], "line": ["A at 0", "B at 0"]}
    upper = {"prismatic": ["frame", "two"], "line": ["H at 0", "D at 0"]}
    drives = {"m": {"extends": "lower", "position": "-20 mm"}, "n": {"extends": "upper", "position": "20 mm"}}
    limits = {"m": [*ends], "n": [*ends]}
    data = made(links, {"lower": lower, "upper": upper}, {"C": "left of B-D"}, drives, point="P", drives=limits)

    def reaches(z: Places, sign: float) -> Mask:
        found = np.zeros(z.shape, dtype=bool)
        for i in (1, -1):
            n = z.real + i * np.sqrt(abs(arm_) ** 2 - (z.imag - height) ** 2)
            d = n + 1j * height
            c = d + 30 * (z - d) / arm_
            for k in (1, -1):
                m = c.real + k * np.sqrt(30**2 - c.imag**2)
                found |= within(m, ends) & within(n, ends) & on_side(c, m, d, sign)
        return found

    one = workspace_of(data, reaches)
    assert one.regions[0].figures.area != pytest.approx(one.regions[1].figures.area, rel=0.1)


def met(centre: Any, radius: float, other: Places, reach: float) -> list[Places]:
    """Where circles meet."""
    away = other - centre
    along = (radius**2 - reach**2 + np.abs(away) ** 2) / (2 * np.abs(away))
    return [centre + away / np.abs(away) * (along + side * 1j * np.sqrt(radius**2 - along**2)) for side in (1, -1)]


def test_a_crank_and_a_slide() -> None:
    ends = (20.0, 60.0)
    links = {
        "frame": {"points": {"A": [0, 0], "H": [0, -5]}},
        "crank": {"points": {"A": [0, 0], "B": [10, 0]}},
        "block": {"points": {"D": [0, 0]}},
        "first": {"points": {"B": [0, 0], "C": [30, 0]}},
        "second": {"points": {"D": [0, 0], "C": [25, 0]}},
    }
    rail = {"prismatic": ["frame", "block"], "line": ["H at 0", "D at 0"]}
    drives = {"motor": turned("crank"), "ram": {"extends": "rail", "position": "40 mm"}}
    limits = {"ram": [*ends]}
    data = made(links, {"rail": rail}, {"C": "left of B-D"}, drives, point="C", modes="own", drives=limits)

    def reaches(z: Places, sign: float) -> Mask:
        found = np.zeros(z.shape, dtype=bool)
        for b in met(0, 10, z, 30):
            for k in (1, -1):
                d = z.real + k * np.sqrt(25**2 - (z.imag + 5) ** 2) - 5j
                found |= np.isfinite(b) & within(d.real, ends) & on_side(z, b, d, sign)
        return found

    workspace_of(data, reaches)


def test_where_the_pins_of_a_slide_meet_the_rod_may_point_anywhere() -> None:
    """A rod pinned to one crank slides through a swivel on the other; their circles cross in two places."""
    tool = complex(3, 2)
    links = {
        "frame": {"points": {"A": [0, 0], "F": [15, 0]}},
        "crank": {"points": {"A": [0, 0], "B": [10, 0]}},
        "other": {"points": {"F": [0, 0], "D": [10, 0]}},
        "rod": {"points": {"B": [0, 0], "P": [tool.real, tool.imag]}},
        "swivel": {"points": {"D": [0, 0]}},
    }
    guide = {"prismatic": ["rod", "swivel"], "line": ["B at 0", "D at 0"]}
    drives = {"motor": turned("crank"), "servo": turned("other")}
    data = made(links, {"guide": guide}, {"D": "ahead of B along guide"}, drives, point="P", modes="own")

    def reaches(z: Places, sign: float) -> Mask:
        """D lies on the rod's line through B, ahead or behind, where that line meets the second crank's circle."""
        found = np.zeros(z.shape, dtype=bool)
        for b in met(0, 10, z, abs(tool)):
            way = (z - b) / tool
            along = (np.conj(way) * (b - 15)).real
            for side in (1, -1):
                travel = -along + side * np.sqrt(along**2 - np.abs(b - 15) ** 2 + 100)
                found |= np.isfinite(b) & (travel * sign > 0)
        return found

    one = workspace_of(data, reaches)
    assert any(curve.kind == "pins" and curve.a.size for curve in one.regions[0].region.segments)
    assert one.regions[0].figures.holes == 1


def coaxial(second: float, **options: Any) -> dict[str, Any]:
    """A leg of two cranks on one axis, 10 long, and couplers of 12 and so much (mm)."""
    links = {
        "frame": {"points": {"A": [0, 0]}},
        "left": {"points": {"A": [0, 0], "B": [10, 0]}},
        "right": {"points": {"A": [0, 0], "D": [10, 0]}},
        "first": {"points": {"B": [0, 0], "C": [12, 0]}},
        "second": {"points": {"D": [0, 0], "C": [second, 0]}},
    }
    drives = {"motor": turned("left"), "servo": turned("right") | {"start": "120 deg"}}
    return made(links, {}, {"C": "left of B-D"}, drives, point="C", **options)


def test_pins_that_meet_along_a_curve_or_at_an_end_are_told() -> None:
    (found,) = findings(coaxial(12))
    assert found.code == "workspace.pins-meet"
    (found,) = findings(coaxial(12, drives={"motor": [0, 90], "servo": [90, 180]}))
    assert found.code == "workspace.pins-meet" and str(found.data["at"]) == "motor = 90 deg, servo = 90 deg"
    assert findings(coaxial(12, drives={"motor": [0, 80], "servo": [90, 180]})) == []


def test_a_leg_of_unequal_links_reaches_a_ring() -> None:
    """Straight and folded legs: C is nowhere nearer to the axis than 10 mm less the shorter link."""
    outcome = performed(coaxial(11, modes="own")).workspace
    assert outcome is not None and outcome.done
    (region,) = outcome.regions
    assert region.figures.bounds[2] * 1e3 == pytest.approx(21, abs=0.01)


def crossing_guides(**options: Any) -> dict[str, Any]:
    """Two guides that turn about A and, 50 mm beside it, F: P is where they cross."""
    links: dict[str, Any] = {"frame": {"points": {"A": [0, 0], "F": [50, 0]}}}
    links |= {name: {"points": {point: [0, 0]}} for name, point in (("one", "A"), ("two", "F"), ("b", "P"), ("d", "P"))}
    joints = {
        "first": {"prismatic": ["one", "b"], "line": ["A at 0", "P at 0"]},
        "second": {"prismatic": ["two", "d"], "line": ["F at 0", "P at 0"]},
    }
    drives = {"motor": turned("one"), "servo": turned("two") | {"start": "120 deg"}}
    return made(links, joints, {}, drives, point="P", **options)


def test_a_point_that_runs_away_is_told() -> None:
    assert [found.code for found in findings(crossing_guides())] == ["workspace.unbounded"]


def test_guides_that_cross_bound_a_quadrangle() -> None:
    """Lines through A at 40 and 80 deg, through F at 100 and 140 deg."""
    outcome = performed(crossing_guides(drives={"motor": [40, 80], "servo": [100, 140]})).workspace
    assert outcome is not None
    (region,) = outcome.regions

    def crossing(one: float, two: float) -> complex:
        """By the rule of sines in the triangle A-F-P."""
        a, b = np.radians([one, two])
        return complex(50 * np.sin(b) / np.sin(b - a) * np.exp(1j * a))

    corners = [crossing(*at) for at in ((40, 100), (80, 100), (80, 140), (40, 140))]
    expected = shapely.Polygon([(p.real, p.imag) for p in corners])
    assert region.figures.area * MM2 == pytest.approx(expected.area, rel=1e-6)
