"""The planar Stewart platform of T. Sauer, *Numerical Analysis* (2nd ed., Pearson 2012), Reality Check 1.

Legs of lengths p1, p2, p3 from (0, 0), (x1, 0), (x2, y2) hold a triangle of sides L1, L2, L3; its poses are the roots
of a function f(theta) of the triangle's angle, which is written here as he does. Cases: the one with roots at
+-pi/4 (activity 1), those with 4 and 6 poses (activities 4 and 5), the ranges of p2 with 0, 2, 4, 6 poses
(activity 7). The book prints no digits of the roots but +-pi/4; they and the ranges are found here from sign
changes of f on a grid, closed by bisection. Tolerance 1e-11: f is smooth, and its roots are simple but at the ends of
the ranges.
"""

from __future__ import annotations

import math
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from linkwright.model.document import Document

ROOT5, ROOT2 = math.sqrt(5.0), math.sqrt(2.0)
EXAMPLES = Path(__file__).parents[2] / "examples"
Case = dict[str, float]
FIRST: Case = {"p1": ROOT5, "p2": ROOT5, "p3": ROOT5, "x1": 4, "x2": 0, "y2": 4, "L2": ROOT2, "L3": ROOT2}
FIRST["gamma"] = math.pi / 2
SECOND: Case = {"p1": 5, "p2": 5, "p3": 3, "x1": 5, "x2": 0, "y2": 6, "L2": 3 * ROOT2, "L3": 3, "gamma": math.pi / 4}


def f(theta: Any, c: Case) -> Any:
    """Sauer's function, its roots the platform's angles."""
    a2, b2 = c["L3"] * np.cos(theta) - c["x1"], c["L3"] * np.sin(theta)
    a3 = c["L2"] * np.cos(theta + c["gamma"]) - c["x2"]
    b3 = c["L2"] * np.sin(theta + c["gamma"]) - c["y2"]
    d = 2 * (a2 * b3 - b2 * a3)
    k2, k3 = c["p2"] ** 2 - c["p1"] ** 2 - a2**2 - b2**2, c["p3"] ** 2 - c["p1"] ** 2 - a3**2 - b3**2
    return (b3 * k2 - b2 * k3) ** 2 + (a2 * k3 - a3 * k2) ** 2 - c["p1"] ** 2 * d**2


def roots(c: Case, steps: int = 20_000) -> list[float]:
    """The sign changes of f over a turn, by bisection."""
    grid = np.linspace(-math.pi, math.pi, steps + 1)
    found = []
    for a, b in pairwise(grid):
        if f(a, c) * f(b, c) < 0:
            low, high = a, b
            for _ in range(60):
                middle = 0.5 * (low + high)
                low, high = (middle, high) if f(low, c) * f(middle, c) > 0 else (low, middle)
            found.append(float(low))
    return found


def platform(c: Case) -> dict[str, Any]:
    """The platform on rigid legs, as a model file's data."""
    legs = {f"leg{i}": {"points": {a: [0, 0], f"B{i}": [c[f"p{i}"], 0]}} for i, a in ((1, "O"), (2, "A2"), (3, "A3"))}
    third = [c["L2"] * math.cos(c["gamma"]), c["L2"] * math.sin(c["gamma"])]
    return {
        "units": {"length": "m", "angle": "rad", "time": "s"},
        "links": {
            "frame": {"points": {"O": [0, 0], "A2": [c["x1"], 0], "A3": [c["x2"], c["y2"]]}},
            **legs,
            "platform": {"points": {"B1": [0, 0], "B2": [c["L3"], 0], "B3": third}},
        },
    }


def angles(c: Case) -> list[float]:
    outcome = lw.modes(Document.model_validate(platform(c)))
    assert outcome.complete
    axes = [mode.bodies["platform"].axis.now for mode in outcome.modes]
    return sorted(math.atan2(axis.y, axis.x) for axis in axes)


@pytest.mark.parametrize(("case", "count"), [(FIRST, 2), (SECOND, 4), (SECOND | {"p2": 7.0}, 6)])
def test_all_poses(case: Case, count: int) -> None:
    found = angles(case)
    assert len(found) == count
    assert found == pytest.approx(roots(case), abs=1e-11)


def test_the_first_case_has_its_roots_at_45_degrees() -> None:
    assert angles(FIRST) == pytest.approx([-math.pi / 4, math.pi / 4], abs=1e-13)


def test_the_places_of_the_strut_ends_in_the_first_case() -> None:
    """Figure 1.15 of the book: at -pi/4 the corners are (1, 2), (2, 1), (2, 3), at pi/4 (2, 1), (1, 2), (3, 2)."""
    outcome = lw.modes(Document.model_validate(platform(FIRST)))
    corners = [sorted(tuple(np.round(mode.places[b], 12)) for b in ("B1", "B2", "B3")) for mode in outcome.modes]
    assert sorted(corners) == [[(1.0, 2.0), (2.0, 1.0), (2.0, 3.0)], [(1.0, 2.0), (2.0, 1.0), (3.0, 2.0)]]


def sign_changes(p2: float, steps: int = 4000) -> int:
    values = f(np.linspace(-math.pi, math.pi, steps + 1), SECOND | {"p2": p2})
    return int((values[1:] * values[:-1] < 0).sum())


def count_changes() -> list[tuple[float, int]]:
    """The lengths p2 at which the number of roots of f changes, by bisection, and the number above each."""
    lengths = np.linspace(0.05, 10.0, 400)
    counts = [sign_changes(p) for p in lengths]
    found = []
    for (a, n), (b, m) in pairwise(zip(lengths, counts, strict=True)):
        if n != m:
            low, high = a, b
            while high - low > 1e-4:
                middle = 0.5 * (low + high)
                low, high = (middle, high) if sign_changes(middle, 40_000) == n else (low, middle)
            found.append((float(0.5 * (low + high)), m))
    return found


def test_ranges_of_a_strut_with_0_2_4_6_poses() -> None:
    """On both sides of each border the count of modes is that of the roots; the ranges are 0 2 4 6 4 2 0."""
    borders = count_changes()
    assert [count for _, count in borders] == [2, 4, 6, 4, 2, 0]
    below = 0
    for p2, above in borders:
        for at, count in ((p2 - 1e-3, below), (p2 + 1e-3, above)):
            try:
                found = angles(SECOND | {"p2": at})
            except lw.ModelError as error:
                assert [finding.code for finding in error.findings] == ["assembly.no-mode"]
                found = []
            assert len(found) == count, at
        below = above


def test_the_circuits_of_six_poses() -> None:
    """As p2 moves, legs 1 and 3 and the platform are a four-bar O-B1-B3-A3 of lengths 5, 3 sqrt 2, 3 on a ground of 6:
    3 + 6 < 5 + 3 sqrt 2, so it has two circuits (Grashof), told by the side of B1 of the line from B3 to O."""
    data = platform(SECOND | {"p2": 7.0})
    links = {name: link for name, link in data["links"].items() if name != "leg2"}
    links |= {"barrel": {"points": {"A2": [0, 0]}}, "rod": {"points": {"B2": [0, 0]}}}
    data |= {
        "links": links,
        "joints": {"strut": {"prismatic": ["barrel", "rod"], "line": ["A2 at 0", "B2 at 0"]}},
        "drives": {"push": {"slides": "rod", "on": "barrel", "speed": 0.1, "start": 7}},
    }
    outcome = lw.modes(Document.model_validate(data))
    assert len(outcome.modes) == 6
    assert outcome.complete
    sides: dict[int, set[bool]] = {}
    for mode, place in zip(outcome.modes, outcome.survey.places, strict=True):
        assert place is not None
        b1, b3 = (np.array(mode.places[b]) for b in ("B1", "B3"))
        side = (b1[0] - b3[0]) * -b3[1] - (b1[1] - b3[1]) * -b3[0] > 0
        sides.setdefault(place[0], set()).add(bool(side))
    assert sorted(sides.values(), key=str) == [{False}, {True}]
    assert all(circuit.closed for circuit in outcome.circuits)


def test_the_example_starts_in_the_mode_that_is_sketched(tmp_path: Path) -> None:
    job = lw.run(EXAMPLES / "sauer_platform.yaml")
    assert job.exit_code == 0
    assert job.modes is not None
    own = job.modes.modes[job.modes.own or 0]
    assert own.places["B2"] == pytest.approx((3.0, 2.0), abs=1e-12)
    text = (EXAMPLES / "sauer_platform.yaml").read_text(encoding="utf-8")
    sketch = "{B1: [2, 1], B2: [3, 2], B3: [1, 2]}"
    assert sketch in text
    (tmp_path / "other.yaml").write_text(text.replace(sketch, "{B1: [1, 2], B2: [2, 1], B3: [2, 3]}"), encoding="utf-8")
    other = lw.compile(lw.load(tmp_path / "other.yaml"))
    assert other.evaluate(["platform.angle"], np.zeros(1))[0, 0] == pytest.approx(-math.pi / 4, abs=1e-13)
