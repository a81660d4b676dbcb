"""The packaging paper feeder against its paper, and against a computation of its own in 50 digits.

The source, its figures and their signs stand in data/paper_feeder.json, the discussion in
docs/validation/paper_feeder.md. Run as a script, this file prints the tables of that page.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mpmath import mp, mpf

import linkwright as lw

ROOT = Path(__file__).resolve().parents[2]
FEEDER = ROOT / "examples" / "paper_feeder.yaml"
DWELL = FEEDER.with_name("paper_feeder_dwell.yaml")
PAGE = ROOT / "docs" / "validation" / "paper_feeder.md"
DATA: dict[str, Any] = json.loads((Path(__file__).parent / "data" / "paper_feeder.json").read_text(encoding="utf-8"))

WINDOWS = tuple(DATA["windows_s"])
SIGNALS = {
    "F61x": "force(frame, crank).x",
    "F61y": "force(frame, crank).y",
    "F32x": "force(rocker, coupler).x",
    "F32y": "force(rocker, coupler).y",
    "M0": "-motor.torque",
}
ROWS = [(name, window, i, label) for window in WINDOWS for name in SIGNALS for i, label in enumerate(("min", "max"))]
row = pytest.mark.parametrize(("name", "window", "i", "label"), ROWS)


# linkwright's side.


@cache
def job() -> Any:
    """The example, run."""
    return lw.run(FEEDER)


@cache
def compiled() -> Any:
    return lw.compile(lw.load(FEEDER))


def edited() -> dict[str, Any]:
    """The example as plain data, to be changed."""
    return lw.load(FEEDER).model_dump(by_alias=True, exclude_none=True, mode="json")


def measures(done: Any) -> dict[str, Any]:
    return {measure.name: measure for measure in done.cycle.measures}


def ours(name: str, window: str, label: str) -> float:
    """An extreme as linkwright has it (N, N m)."""
    return float(measures(job())[f"{name}_{window}"].shown(label))


def values(names: list[str], t: list[float], mechanism: Any = None) -> dict[str, np.ndarray[Any, Any]]:
    """Signals in SI at times t (s)."""
    run = lw.Run(mechanism or compiled(), 0.0, 1.5, 200)
    return dict(zip(names, run.evaluate(names, np.array(t)), strict=True))


# A computation of its own: the paper's closed positions, differences in 50 digits, its equations of equilibrium.

DIGITS = 50
MASSES = {1: "0.6", 2: "1.5", 3: "2", 4: "1", 5: "3"}
STEP = mpf("1e-12")  # s: the differences below are good to some 20 digits
XY = list[Any]


def positions(t: Any) -> tuple[dict[str, XY], dict[int, XY]]:
    """Points, and centre and angle of each link, in m and rad; the paper's equations (6), (7), (11) and (12)."""
    l1, l2, l3, arm, l6, l5 = (mpf(mm) / 1000 for mm in (155, 395, 500, 300, 300, 580))
    theta1 = mp.atan2(mpf("61.78"), mpf("142.16")) - 40 * 2 * mp.pi / 60 * t
    a, b = l6 - l1 * mp.cos(theta1), -l1 * mp.sin(theta1)
    c = (a**2 + b**2 + arm**2 - l2**2) / (2 * arm)
    theta3 = 2 * mp.atan((b + mp.sqrt(a**2 + b**2 - c**2)) / (a - c))
    theta2 = mp.atan2(b + arm * mp.sin(theta3), a + arm * mp.cos(theta3))
    points = {
        "A": [mpf(0), mpf(0)],
        "B": [l1 * mp.cos(theta1), l1 * mp.sin(theta1)],
        "C": [l6 + arm * mp.cos(theta3), arm * mp.sin(theta3)],
        "D": [l6, mpf(0)],
        "E": [l6 + l3 * mp.cos(theta3), l3 * mp.sin(theta3)],
    }
    points["G"] = [points["E"][0], l5]

    def middle(p: str, q: str, angle: Any) -> XY:
        return [(points[p][0] + points[q][0]) / 2, (points[p][1] + points[q][1]) / 2, angle]

    links = {
        1: middle("A", "B", theta1),
        2: middle("B", "C", theta2),
        3: middle("D", "E", theta3),
        4: [*points["E"], mpf(0)],
        5: [*points["G"], mpf(0)],
    }
    return points, links


def accelerations(t: Any) -> dict[int, XY]:
    """Of each link's centre and angle, by second differences."""
    before, now, after = (positions(t + k * STEP)[1] for k in (-1, 0, 1))
    return {i: [(p + q - 2 * m) / STEP**2 for p, m, q in zip(before[i], now[i], after[i], strict=True)] for i in now}


def equilibrium(t: Any) -> dict[str, Any]:
    """The paper's equations (24) to (37): two forces and a moment about the centre on each link, 14 unknowns.

    F12x is the x component of the force of link 1 on link 2; link 6 is the ground.
    """
    points, links = positions(t)
    pins = [(6, 1, "A"), (1, 2, "B"), (3, 2, "C"), (6, 3, "D"), (4, 3, "E")]
    forces = [(i, j, axis, at, f"F{i}{j}{'xy'[axis]}") for i, j, at in pins for axis in (0, 1)]
    forces += [(5, 4, 0, "E", "F54x"), (6, 5, 1, "G", "F65y")]
    rows = {key: k for k, key in enumerate((i, part) for i in links for part in range(2 if i == 4 else 3))}
    names = [name for *_, name in forces] + ["M65", "M1"]
    matrix, right = mp.zeros(14), mp.zeros(14, 1)
    for column, (i, j, axis, at, _) in enumerate(forces):
        for link, sign in ((i, -1), (j, 1)):
            if link == 6:
                continue
            dx, dy = points[at][0] - links[link][0], points[at][1] - links[link][1]
            matrix[rows[link, axis], column] += sign
            if (link, 2) in rows:
                matrix[rows[link, 2], column] += sign * (dx if axis else -dy)
    matrix[rows[5, 2], 12] = matrix[rows[1, 2], 13] = 1
    inertias = {i: mpf(MASSES[i]) * mpf(length) ** 2 / 12 for i, length in ((1, "0.155"), (2, "0.395"), (3, "0.5"))}
    for i, (ax, ay, alpha) in accelerations(t).items():
        mass = mpf(MASSES[i])
        right[rows[i, 0]], right[rows[i, 1]] = mass * ax, mass * (ay + mpf("9.80665"))
        if i in inertias:
            right[rows[i, 2]] = inertias[i] * alpha
    found = dict(zip(names, mp.lu_solve(matrix, right), strict=True))
    return {**found, "M0": -found["M1"]}


@cache
def own(t: Any) -> dict[str, Any]:
    with mp.workdps(DIGITS):
        return equilibrium(t)


def own_extreme(name: str, window: str, label: str) -> tuple[Any, Any]:
    """An extreme and its time: the best of a grid of 2.5 ms, then golden sections in the steps beside it."""
    with mp.workdps(DIGITS):
        sign = 1 if label == "max" else -1
        start, stop = (mpf(str(edge)) for edge in DATA["windows_s"][window])
        count = int(mp.nint((stop - start) * 400))
        grid = [start + mpf(k) / 400 for k in range(count + 1)]
        best = max(range(count + 1), key=lambda k: sign * own(grid[k])[name])
        low, high = grid[max(best - 1, 0)], grid[min(best + 1, count)]
        t = _golden(lambda at: sign * own(at)[name], low, high)
        return max(((own(at)[name], at) for at in (t, grid[best])), key=lambda pair: sign * pair[0])


def _golden(f: Callable[[Any], Any], low: Any, high: Any) -> Any:
    """Where f is largest in low .. high, to 1e-8 s."""
    ratio = (mp.sqrt(5) - 1) / 2
    a, b = high - ratio * (high - low), low + ratio * (high - low)
    while high - low > mpf("1e-8"):
        if f(a) > f(b):
            high, a, b = b, b - ratio * (b - low), a
        else:
            low, a, b = a, b, a + ratio * (high - a)
    return (low + high) / 2


# The paper.


@row
def test_tables_2_and_3(name: str, window: str, i: int, label: str) -> None:
    """0.6 %: the paper reads its figures off 200 steps, of links that aren't quite slender rods (next test)."""
    assert ours(name, window, label) == pytest.approx(DATA["tables"][window][name][i], rel=6e-3)


@cache
def as_the_paper_read_them() -> dict[tuple[str, str, int], float]:
    """The extremes among the paper's 200 steps, with the fitted moments of inertia."""
    data = edited()
    for link, (mass, half) in {"coupler": (1.5, "BC/2"), "rocker": (2, "DE/2")}.items():
        share = DATA["inertia_shares"][link]
        entry = data["links"][link]
        del entry["shape"]
        entry["com"], entry["inertia"] = [half, 0], f"{share}*{mass} kg*(2*{half})^2/12"
    mechanism = lw.compile(lw.Document.model_validate(data))
    t = np.linspace(0.0, 1.5, 201)
    names = [text.removeprefix("-") for text in SIGNALS.values()]
    found = values(names, list(t), mechanism)
    result = {}
    for name, window, i, _ in ROWS:
        low, high = DATA["windows_s"][window]
        inside = (t > low - 1e-9) & (t < high + 1e-9)
        signal = SIGNALS[name].removeprefix("-")
        y = found[signal][inside] * (-1 if SIGNALS[name] != signal else 1)
        result[name, window, i] = float((np.min, np.max)[i](y))
    return result


def test_tables_2_and_3_as_read_off_200_steps() -> None:
    """With the coupler's and the rocker's inertia a little below a slender rod's, all 20 rows at once.

    0.06 %: the figures below 10 are printed to 0.05 to 0.1 % only; the others hold to 0.04 %.
    """
    found = as_the_paper_read_them()
    for name, window, i, _ in ROWS:
        assert found[name, window, i] == pytest.approx(DATA["tables"][window][name][i], rel=6e-4), (name, window, i)


def test_table_1() -> None:
    """The points at the start, to the digits printed (0.01 mm)."""
    points = DATA["table_1_mm"]
    names = [f"{point}.{axis}" for point in points for axis in "xy"]
    found = values(names, [0.0])
    for point, at in points.items():
        for axis, printed in zip("xy", at, strict=True):
            assert round(1e3 * float(found[f"{point}.{axis}"][0]), 2) == pytest.approx(printed, abs=1e-9)


def test_stroke_limits_and_speed() -> None:
    """The limits follow from triangles: crank and coupler in line give x = 640 5/18 and -40 mm, to round-off."""
    found, second = measures(job()), DATA["second"]["limits"]
    assert found["stroke"].shown() == pytest.approx(680 + 5 / 18, abs=1e-9)
    assert found["stroke"].shown() == pytest.approx(680.2778, abs=5e-5)
    assert found["stroke"].shown() == pytest.approx(second["stroke_mm"], abs=3e-5)
    assert found["right_limit_angle"].shown() == pytest.approx(np.degrees(np.arccos(550 / 600)), abs=1e-6)
    assert found["left_limit_angle"].shown() == pytest.approx(np.degrees(np.arccos(240 / 600)) + 180, abs=1e-6)
    assert found["right_limit_angle"].shown() == pytest.approx(second["right_limit_deg"], abs=5e-5)
    assert found["left_limit_angle"].shown() == pytest.approx(second["left_limit_deg"], abs=5e-5)
    assert found["feed_speed_max"].shown() == pytest.approx(second["feed_speed_mm_s"], abs=5e-3)


def test_kinematics_as_printed() -> None:
    """The paper reads stroke and speed off 200 steps (0.03 mm, 0.02 mm/s) and rounds the angles to degrees."""
    found, paper = measures(job()), DATA["kinematics"]
    assert found["stroke"].shown() == pytest.approx(paper["stroke_mm"], abs=0.03)
    assert found["feed_speed_max"].shown() == pytest.approx(paper["feed_speed_mm_s"], abs=0.03)
    assert round(found["right_limit_angle"].shown()) == paper["right_limit_deg"]
    assert round(found["left_limit_angle"].shown()) == paper["left_limit_deg"]


def test_times_of_return_and_feed() -> None:
    """The slider reverses at 0.5711 s: the paper's return window holds 29 ms of the feed."""
    found, second = measures(job()), DATA["second"]["limits"]
    left, right = (found[f"{side}_limit_angle"].found[0].time for side in ("left", "right"))
    assert left == pytest.approx(0.5711, abs=5e-5)
    assert left - (right - 1.5) == pytest.approx(second["return_s"], abs=5e-5)
    assert right - left == pytest.approx(second["feed_s"], abs=5e-5)


# The computations.

POSES = ["0", "0.0776", "0.0977", "0.15", "0.2065", "0.2306", "0.45", "0.6", "0.8568", "1.1793", "1.4188"]
EVERY = {
    "F61x": "force(frame, crank).x",
    "F61y": "force(frame, crank).y",
    "F12x": "force(crank, coupler).x",
    "F12y": "force(crank, coupler).y",
    "F32x": "force(rocker, coupler).x",
    "F32y": "force(rocker, coupler).y",
    "F63x": "force(frame, rocker).x",
    "F63y": "force(frame, rocker).y",
    "F43x": "force(slider, rocker).x",
    "F43y": "force(slider, rocker).y",
    "F54x": "force(guide, slider).x",
    "F65y": "force(frame, guide).y",
    "M65": "force(frame, guide).moment",
    "M1": "motor.torque",
}


@pytest.mark.parametrize("t", POSES)
def test_all_reactions_against_50_digits(t: str) -> None:
    """1e-9: double precision keeps some 13 digits, the 50-digit differences 20; below 1 N, 1 N m it is absolute."""
    found, expected = values(list(EVERY.values()), [float(t)]), own(mpf(float(t)))
    for name, signal in EVERY.items():
        assert float(found[signal][0]) == pytest.approx(float(expected[name]), rel=1e-9, abs=1e-9), name


@row
def test_extremes_against_50_digits(name: str, window: str, i: int, label: str) -> None:
    """1e-9, and the time to 1 us: linkwright finds it as a root of the exact rate."""
    value, at = own_extreme(name, window, label)
    assert ours(name, window, label) == pytest.approx(float(value), rel=1e-9)
    time = next(f.time for f in measures(job())[f"{name}_{window}"].found if f.label == label)
    assert time == pytest.approx(float(at), abs=1e-6)


# Rows of the second computation that aren't those of its stated g.
OTHER = [
    ("F61y", "return", 0, "min"),
    ("F61y", "return", 1, "max"),
    ("F32x", "return", 0, "min"),
    ("F32x", "return", 1, "max"),
    ("F32y", "return", 0, "min"),
    ("F61y", "feed", 1, "max"),
    ("F32y", "feed", 0, "min"),
]


def last_digit(text: str) -> float:
    """One unit of the last digit printed."""
    return float(10.0 ** -len(text.partition(".")[2]))


@row
def test_second_computation(name: str, window: str, i: int, label: str) -> None:
    """Half a unit of its last digit, or 0.03 N for the seven rows that are another g's (next test)."""
    text = DATA["second"][window][name][i]
    tolerance = 0.03 if (name, window, i, label) in OTHER else 0.5 * last_digit(text) + 1e-9
    assert ours(name, window, label) == pytest.approx(float(text), abs=tolerance)


@cache
def with_old_gravity() -> dict[str, Any]:
    """The measures with g = 9.8 m/s^2."""
    data = edited()
    data["gravity"] = [0, "-9.8 m/s^2"]
    return measures(lw.run(lw.Document.model_validate(data)))


@pytest.mark.parametrize(("name", "window", "i", "label"), [key for key in OTHER if key[:3] != ("F32x", "return", 1)])
def test_rows_of_another_gravity(name: str, window: str, i: int, label: str) -> None:
    """Six of the seven are those of g = 9.8 m/s^2, to one unit of the last digit; by the stated g they are further off.

    The seventh, 511.09 for 511.098, is neither's, but it is the stated g's with its digits cut off.
    """
    text = DATA["second"][window][name][i]
    old = with_old_gravity()[f"{name}_{window}"].shown(label)
    assert old == pytest.approx(float(text), abs=last_digit(text))
    assert abs(ours(name, window, label) - float(text)) > abs(old - float(text))


def test_certificate() -> None:
    certificate = job().cycle.result.certificate
    assert certificate.sound(1e-12)
    assert (certificate.mobility, certificate.gruebler, certificate.rank, certificate.loops) == (1, 1, 14, 2)
    assert job().exit_code == 0


# The real cycle, with dwells.


def test_dwell_cycle() -> None:
    """2 s with 0.25 s at rest in each limit: the same stroke, the same ends, reached and held exactly."""
    done = lw.run(DWELL)
    found = measures(done)
    assert found["stroke"].shown() == pytest.approx(680 + 5 / 18, abs=1e-6)
    assert found["left_end"].shown() == pytest.approx(-40.0, abs=1e-6)
    t, x, v = done.cycle.result.t, done.cycle.result["E.x"], done.cycle.result["E.vx"]
    back = 1.5 * (np.arccos(550 / 600) + np.pi - np.arccos(240 / 600)) / (2 * np.pi)  # the return's time
    left, right = -0.04, 0.64 + 5e-3 / 18
    for rest, end in (((t > back) & (t < back + 0.25), left), (t > 1.75, right), (t == 0, right)):
        assert rest.any()
        assert x[rest] == pytest.approx(end, abs=1e-9)
        assert v[rest] == pytest.approx(0.0, abs=1e-9)
    assert done.cycle.result.certificate.sound(1e-9)


# The page.


def table(*header: str, rows: list[list[str]]) -> Iterator[str]:
    for cells in (list(header), ["---"] * len(header), *rows):
        yield f"| {' | '.join(cells)} |"


def page_tables() -> Iterator[str]:
    """The page's tables, line by line, in the order in which they stand there."""
    found, paper = measures(job()), DATA["kinematics"]
    places = [(f"{point}.x", f"{point}.y") for point in DATA["table_1_mm"]]
    at = {name: 1e3 * float(value[0]) for name, value in values([n for pair in places for n in pair], [0.0]).items()}
    yield from table(
        "point at t = 0, mm",
        "paper",
        "linkwright",
        rows=[
            [point, f"{printed[0]}, {printed[1]}", f"{at[x]:.4f}, {at[y]:.4f}"]
            for (point, printed), (x, y) in zip(DATA["table_1_mm"].items(), places, strict=True)
        ],
    )
    yield ""
    limits = {
        "stroke, mm": ("stroke", "stroke_mm", "680 5/18"),
        "right limit, crank angle, deg": ("right_limit_angle", "right_limit_deg", "acos(550/600) = 23.5565"),
        "left limit, crank angle, deg": ("left_limit_angle", "left_limit_deg", "180 + acos(240/600) = 246.4218"),
        "largest feed speed, mm/s": ("feed_speed_max", "feed_speed_mm_s", ""),
    }
    rows = [[text, str(paper[key]), f"{found[name].shown():.4f}", exact] for text, (name, key, exact) in limits.items()]
    yield from table("quantity", "paper", "linkwright", "closed form", rows=rows)
    yield ""
    rows = []
    for name, window, i, label in ROWS:
        printed, value = DATA["tables"][window][name][i], ours(name, window, label)
        time = next(f.time for f in found[f"{name}_{window}"].found if f.label == label)
        star = "*" if (name, window, i, label) in OTHER else ""
        cells = [f"{printed:.2f}", f"{value:.3f}", f"{100 * (value / printed - 1):+.2f} %", f"{time:.4f}"]
        rows.append([f"{name}_{window} {label}", *cells, DATA["second"][window][name][i] + star])
    yield from table("row", "paper", "linkwright", "difference", "at t, s", "second computation", rows=rows)
    yield ""
    rows = [
        [
            f"{n}_{w} {k}",
            DATA["second"][w][n][i],
            f"{ours(n, w, k):.4f}",
            f"{with_old_gravity()[f'{n}_{w}'].shown(k):.4f}",
        ]
        for n, w, i, k in OTHER
    ]
    yield from table("row", "second computation", "g = 9.80665", "g = 9.8", rows=rows)
    yield ""
    t, read, result, rows = np.linspace(0.0, 1.5, 201), as_the_paper_read_them(), job().cycle.result, []
    for name, window, i, label in ROWS:
        low, high = DATA["windows_s"][window]
        y = result[SIGNALS[name]][(t > low - 1e-9) & (t < high + 1e-9)]
        printed = DATA["tables"][window][name][i]
        both = (float((np.min, np.max)[i](y)), read[name, window, i])
        cells = [f"{v:.2f} ({100 * (v / printed - 1):+.2f} %)" for v in both]
        rows.append([f"{name}_{window} {label}", f"{printed:.2f}", *cells])
    yield from table("row", "paper", "200 steps, slender rods", "200 steps, fitted inertias", rows=rows)
    yield ""
    rows = []
    for m in lw.run(DWELL).cycle.measures:
        rows.append([m.name, ", ".join(f"{f.label} {m.shown(f.label):.2f}".strip() for f in m.found), m.unit])
    yield from table("measure", "value", "unit", rows=rows)


def test_page() -> None:
    """The page shows these tables."""
    lines = PAGE.read_text(encoding="utf-8").splitlines()
    assert [line for line in page_tables() if line not in lines] == []


if __name__ == "__main__":
    print("\n".join(page_tables()))
