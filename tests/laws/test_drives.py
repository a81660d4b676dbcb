"""Drives' laws as a model file states them: constant speed, expressions, steps, tables inline and from a file."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import linkwright as lw
from helpers.differences import derivatives

Array = NDArray[np.float64]
T = np.array([0.05, 0.31, 0.77, 1.13, 1.9])
TURNING = {"turns": "arm", "on": "frame"}
SLIDING = {"slides": "block", "on": "frame"}


def model(drive: dict[str, Any], **sections: Any) -> dict[str, Any]:
    """One link on the frame, turning or sliding by a drive; mm, degrees, seconds."""
    turning = "turns" in drive
    name = "arm" if turning else "block"
    data: dict[str, Any] = {
        "units": {"length": "mm", "angle": "deg", "time": "s"},
        "links": {
            "frame": {"points": {"O": [0, 0], "R": [0, 10]}},
            name: {"points": {"O" if turning else "Q": [0, 0]}},
        },
        "drives": {"motor": drive},
        "studies": {"cycle": {"duration": "2 s", "samples": 20}},
    }
    if not turning:
        data["joints"] = {"rail": {"prismatic": ["frame", "block"], "line": ["R at 0 deg", "Q at 0 deg"]}}
    return {**data, **sections}


def compiled(data: dict[str, Any], folder: Path | None = None) -> lw.Compiled:
    return lw.compile(lw.Document.model_validate(data), folder)


def law(data: dict[str, Any], folder: Path | None = None) -> Callable[[Array], list[Array]]:
    """The motor's value and its four rates over times."""
    motor = compiled(data, folder).laws["motor"]
    return lambda t: [np.broadcast_to(np.asarray(d, dtype=float), t.shape) for d in motor(t).d]


def check_rates(rows: Callable[[Array], list[Array]], t: Array = T, tolerance: float = 1e-7, orders: int = 4) -> None:
    """Each rate against eighth-order differences of the one below it."""
    for k in range(1, orders + 1):
        wanted = derivatives(lambda at, k=k: rows(at)[k - 1], t, 0.004)
        assert np.allclose(rows(t)[k], wanted, rtol=tolerance, atol=tolerance * max(1.0, np.abs(wanted).max())), k


def check_signals(data: dict[str, Any]) -> None:
    """The signals of drive and link are the law and its rates."""
    c = compiled(data)
    turning = c.mechanism.drives["motor"].turns is not None
    owner, names = ("arm", ("angle", "omega", "alpha", "jerk")) if turning else ("rail", ("s", "v", "a", "j"))
    rows = law(data)(T)
    for k, name in enumerate(names):
        for element in ("motor", owner):
            y = c.evaluate([f"{element}.{name}"], T, rates=True)[0]
            assert np.allclose(y[0], rows[k], rtol=1e-12, atol=1e-12 * (1 + np.abs(rows[k]).max()))
            assert np.allclose(y[1], rows[k + 1], rtol=1e-12, atol=1e-12 * (1 + np.abs(rows[k + 1]).max()))


@pytest.mark.parametrize(
    ("speed", "omega"),
    [("60 rpm", 2 * math.pi), ("-40 rpm", -4.18879020478639), ("40 r/min", 4.18879020478639), ("90 deg/s", math.pi / 2),
     ("90", math.pi / 2), ("1.5 rad/s", 1.5), ("2*360 deg/(1 s)", 4 * math.pi), ("0 rpm", 0.0)],
)  # fmt: skip
def test_constant_turning(speed: str, omega: float) -> None:
    data = model({**TURNING, "speed": speed, "start": "30 deg"})
    rows = law(data)(T)
    assert rows[0] == pytest.approx(math.pi / 6 + omega * T, rel=1e-14)
    assert rows[1] == pytest.approx(np.full(T.size, omega), rel=1e-14)
    assert np.array(rows[2:]) == pytest.approx(np.zeros((3, T.size)))
    check_signals(data)


def test_constant_sliding() -> None:
    data = model({**SLIDING, "speed": "-20 mm/s", "start": "0.5 m"})
    assert law(data)(T)[0] == pytest.approx(0.5 - 0.02 * T, rel=1e-14)
    check_signals(data)


def test_constant_acceleration() -> None:
    """q = q0 + v0 t + a t^2 / 2, its rates, and no more."""
    turning = model({**TURNING, "acceleration": "5 rad/s^2", "speed": "-60 deg/s", "start": "30 deg"})
    rows = law(turning)(T)
    omega = -math.pi / 3
    assert rows[0] == pytest.approx(math.pi / 6 + omega * T + 2.5 * T**2, rel=1e-14)
    assert rows[1] == pytest.approx(omega + 5 * T, rel=1e-14)
    assert rows[2] == pytest.approx(np.full(T.size, 5.0), rel=1e-14)
    assert np.array(rows[3:]) == pytest.approx(np.zeros((2, T.size)))
    check_signals(turning)
    sliding = model({**SLIDING, "acceleration": "-100", "speed": "0.2 m/s", "start": 10})
    assert law(sliding)(T)[0] == pytest.approx(0.01 + 0.2 * T - 0.05 * T**2, rel=1e-14)
    check_signals(sliding)


@pytest.mark.parametrize(
    ("position", "wanted"),
    [
        ("30 deg", lambda t: np.full_like(t, math.pi / 6)),
        ("30", lambda t: np.full_like(t, math.pi / 6)),
        ("90 deg + 20 deg*sin(180 deg*t/(1 s))", lambda t: math.pi / 2 + math.radians(20) * np.sin(np.pi * t)),
        ("360 deg*(t/(2 s))^2", lambda t: 2 * math.pi * (t / 2) ** 2),
        ("1 rad*exp(-t/(1 s))*cos(3*t*(1 rad/s))", lambda t: np.exp(-t) * np.cos(3 * t)),
        ("atan2(t/(1 s), 1 + t^2/(1 s^2))", lambda t: np.arctan2(t, 1 + t**2)),
        ("a*sqrt(1 + (t/(1 s))^3) - a", lambda t: math.radians(25) * (np.sqrt(1 + t**3) - 1)),
        ("1 rad*(1 + t/(1 s))^1.5", lambda t: (1 + t) ** 1.5),
        ("1 rad/(1 + t/(1 s))", lambda t: 1 / (1 + t)),
        ("asin(t/(3 s)) + acos(t/(4 s)) + atan(t/(1 s))", lambda t: np.arcsin(t / 3) + np.arccos(t / 4) + np.arctan(t)),
        ("1 rad*2^(t/(1 s))", lambda t: 2.0**t),
        ("1 rad*hypot(t/(1 s), 2)*tan(t*(0.3 rad/s))", lambda t: np.hypot(t, 2) * np.tan(0.3 * t)),
        ("1 rad*log(2 + t/(1 s))", lambda t: np.log(2 + t)),
        ("min(t, 1 s)*(10 deg/s)", lambda t: np.minimum(t, 1) * math.radians(10)),
        ("max(t, 1 s)*(10 deg/s)", lambda t: np.maximum(t, 1) * math.radians(10)),
        ("abs(t - 1 s)*(10 deg/s)", lambda t: np.abs(t - 1) * math.radians(10)),
    ],
)  # fmt: skip
def test_an_expression(position: str, wanted: Callable[[Array], Array]) -> None:
    data = model({**TURNING, "position": position}, parameters={"a": "25 deg"})
    rows = law(data)
    assert rows(T)[0] == pytest.approx(wanted(T), rel=1e-13, abs=1e-14)
    check_rates(rows)
    check_signals(data)


def test_a_sliding_expression_in_bare_numbers() -> None:
    """As the format's example writes a cylinder: 1100 + 20*t/(1 s), bare numbers in mm."""
    data = model({**SLIDING, "position": "1100 + 20*t/(1 s)"})
    assert law(data)(T)[0] == pytest.approx(1.1 + 0.02 * T, rel=1e-14)
    check_signals(data)


def test_steps_one_after_another() -> None:
    """The feeder's dwells: rest, move, rest, move back."""
    data = model({**TURNING, "position": "step5(t, 0.25 s, 0 deg, 0.75 s, 90 deg) + step5(t, 1 s, 0, 1.5 s, -60 deg)"})
    rows = law(data)
    t = np.array([0.0, 0.2, 0.25, 0.5, 0.75, 0.9, 1.0, 1.25, 1.5, 2.0])
    assert np.degrees(rows(t)[0]) == pytest.approx([0, 0, 0, 45, 90, 90, 90, 60, 30, 30], abs=1e-12)
    dwell = (t <= 0.25) | ((t >= 0.75) & (t <= 1.0)) | (t >= 1.5)
    for k in (1, 2):
        assert rows(t)[k][dwell] == pytest.approx(np.zeros(dwell.sum()), abs=1e-9)
    assert rows(t)[1][3] == pytest.approx(15 / 8 * math.pi / 2 / 0.5, rel=1e-12)
    check_rates(rows, np.array([0.1, 0.4, 0.6, 0.9, 1.2, 1.8]), 1e-6)
    check_signals(data)


# Tables.

POINTS = [[0.0, 0.0], [0.5, 12.0], [1.0, 30.0], [1.4, 34.0], [2.0, 10.0]]


def inline(unit_x: str = "s", unit_y: str = "deg", **entry: Any) -> dict[str, Any]:
    return {"move": {"points": [[f"{x} {unit_x}", f"{y} {unit_y}"] for x, y in POINTS], **entry}}


@pytest.mark.parametrize("points", [inline(), inline("s", "deg", between="cubic")])
def test_an_inline_table(points: dict[str, Any]) -> None:
    from scipy.interpolate import CubicSpline

    data = model({**TURNING, "position": "move(t)"}, tables=points)
    rows = law(data)
    x, y = np.array(POINTS).T
    spline = CubicSpline(x, np.radians(y), bc_type="not-a-knot")
    for k in range(4):
        assert rows(T)[k] == pytest.approx(spline(T, k), rel=1e-9, abs=1e-10)
    check_rates(rows, orders=3)
    check_signals(data)


def test_a_quintic_table_keeps_a_polynomial() -> None:
    x = np.linspace(0.0, 2.0, 7)
    points = [[f"{a!r} s", f"{10 * a**5 - 20 * a**3!r} mm"] for a in x.tolist()]
    data = model({**SLIDING, "position": "move(t) + 5 mm"}, tables={"move": {"points": points, "between": "quintic"}})
    rows = law(data)(T)
    for k, wanted in enumerate((10 * T**5 - 20 * T**3 + 5, 50 * T**4 - 60 * T**2, 200 * T**3 - 120 * T)):
        assert rows[k] == pytest.approx(wanted / 1000, rel=1e-9, abs=1e-11)
    check_rates(law(data))


def test_a_table_within_an_expression() -> None:
    """Its argument may run at its own pace, and its value go through more arithmetic."""
    data = model({**TURNING, "position": "2*move(1 s + 0.4 s*sin(t*(2 rad/s)))^2/(1 deg)"}, tables=inline())
    check_rates(law(data), tolerance=1e-6)


def test_units_of_a_table() -> None:
    """The same points in other units are the same law."""
    reference = law(model({**TURNING, "position": "move(t)"}, tables=inline()))(T)
    points = [[f"{x * 1000!r} ms", f"{math.radians(y)!r} rad"] for x, y in POINTS]
    other = law(model({**TURNING, "position": "move(t)"}, tables={"move": {"points": points}}))(T)
    for k in range(5):
        assert other[k] == pytest.approx(reference[k], rel=1e-9, abs=1e-9)


# Tables in a file beside the model.


def written(folder: Path, text: str, name: str = "lift.csv", **entry: Any) -> dict[str, Any]:
    (folder / name).write_text(text, "utf-8")
    return {"lift": {"file": name, "x": "angle deg", "y": "lift mm", **entry}}


def cam(count: int, closed: bool) -> str:
    """A rise and fall of 12 mm over a turn, as columns among others."""
    angles = np.linspace(0, 360, count + 1)[: count + closed]
    rows = [f"{i},{a!r},x,{6 - 6 * math.cos(math.radians(a))!r}" for i, a in enumerate(angles.tolist())]
    return "\n".join(["no,angle,remark,lift", *rows]) + "\n"


@pytest.mark.parametrize("closed", [False, True], ids=["open end", "end repeated"])
@pytest.mark.parametrize(("between", "tolerance"), [("cubic", 1e-4), ("quintic", 1e-7)])
def test_a_periodic_table_from_a_file(tmp_path: Path, closed: bool, between: str, tolerance: float) -> None:
    tables = written(tmp_path, cam(36, closed), period="360 deg", between=between)
    data = model({**SLIDING, "position": "lift(180 deg*t/(1 s) + 90 deg)"}, tables=tables)
    rows = law(data, tmp_path)
    angle = np.pi * T + np.pi / 2
    assert rows(T)[0] == pytest.approx(0.006 - 0.006 * np.cos(angle), abs=tolerance * 0.006)
    assert rows(T)[1] == pytest.approx(0.006 * np.pi * np.sin(angle), abs=tolerance * 0.2)
    between_knots = (10 * np.array([1, 5, 11, 20, 30]) + 5) / 180
    check_rates(rows, between_knots, orders=3)
    turns = np.array([0.3, 2.3, 40.3, -7.7])
    assert np.ptp(rows(turns)[0]) < 1e-14


def test_a_file_is_looked_for_beside_the_model(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = tmp_path / "models"
    folder.mkdir()
    tables = written(folder, cam(36, True), period="360 deg")
    data = model({**SLIDING, "position": "lift(180 deg*t/(1 s))"}, tables=tables)
    data["links"]["block"] |= {"mass": "1 kg", "shape": "point Q"}
    lw.save(lw.Document.model_validate({**data, "gravity": [0, "-9.81 m/s^2"]}), folder / "cam.yaml")
    monkeypatch.chdir(tmp_path)
    job = lw.run(Path("models") / "cam.yaml")
    assert job.exit_code == 0
    assert job.cycle is not None
    assert job.cycle.result.shown("rail.s")[0].max() == pytest.approx(12.0, rel=1e-4)


def test_the_file_may_have_a_mark_blank_lines_and_other_line_ends(tmp_path: Path) -> None:
    text = "\ufeff" + cam(36, True).replace("\n", "\r\n") + "\r\n\r\n"
    (tmp_path / "lift.csv").write_bytes(text.encode("utf-8"))
    tables = {"lift": {"file": "lift.csv", "x": "angle deg", "y": "lift mm", "period": 360}}
    data = model({**SLIDING, "position": "lift(180 deg*t/(1 s))"}, tables=tables)
    assert law(data, tmp_path)(T)[0] == pytest.approx(0.006 - 0.006 * np.cos(np.pi * T), abs=1e-6)


def findings(data: dict[str, Any], folder: Path) -> list[lw.Finding]:
    path = folder / "model.yaml"
    path.write_text(json.dumps({"linkwright": 1, **data}, indent=1), "utf-8")  # JSON is YAML too
    return lw.check(path)


GOOD = "angle,lift\n0,0\n90,6\n180,12\n270,6\n360,0\n"


@pytest.mark.parametrize(
    ("text", "entry", "code"),
    [
        ("phase,lift\n0,0\n", {}, "table.no-column"),
        (GOOD.replace("180,12", "180,twelve"), {}, "table.not-number"),
        (GOOD.replace("180,12", "180"), {}, "table.not-number"),
        (GOOD.replace("180,12", "80,12"), {}, "table.order"),
        (GOOD.replace("180,12", "90,12"), {}, "table.order"),
        (GOOD.replace("180,12", "180,nan"), {}, None),
        (GOOD.replace("180,12", "180,inf"), {}, None),
        ("angle,lift\n0,0\n90,6\n180,12\n", {}, "table.short"),
        (GOOD, {"between": "quintic"}, "table.short"),
        ("angle,lift\n", {}, "table.short"),
        ("", {}, "table.empty"),
        (GOOD, {"period": "180 deg"}, "table.period"),
        (GOOD.replace("360,0", "360,1"), {"period": "360 deg"}, "table.not-closed"),
        (GOOD, {"x": "angle furlong"}, None),
        (GOOD, {"x": "angle mm"}, None),
        (GOOD, {"period": "360 mm"}, None),
        (GOOD, {"file": "nowhere.csv"}, "table.unreadable"),
        (GOOD, {"file": "."}, "file.irregular"),
    ],
)
def test_a_file_that_can_not_be_used_is_named(
    tmp_path: Path, text: str, entry: dict[str, Any], code: str | None
) -> None:
    tables = written(tmp_path, text)
    tables["lift"] |= entry
    found = findings(model({**SLIDING, "position": "lift(90 deg*t/(1 s))"}, tables=tables), tmp_path)
    assert found
    assert all(f.path[:2] in (("tables", "lift"), ("drives", "motor")) for f in found)
    assert all(f.line and f.what and f.mend for f in found)
    if code:
        assert {f.code for f in found} == {code}


def test_a_file_of_too_many_rows_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The line of column names isn't one of them."""
    data = model({**SLIDING, "position": "lift(90 deg*t/(1 s))"}, tables=written(tmp_path, GOOD))
    monkeypatch.setattr("linkwright.kernels.laws.MAX_ROWS", 5)
    assert not findings(data, tmp_path)
    monkeypatch.setattr("linkwright.kernels.laws.MAX_ROWS", 4)
    (finding,) = findings(data, tmp_path)
    assert (finding.code, finding.path, finding.data["limit"]) == ("table.long", ("tables", "lift", "file"), 4)


@pytest.mark.parametrize("value", ["nan", "inf", "-inf"])
def test_a_number_that_is_none_is_found_in_its_row(tmp_path: Path, value: str) -> None:
    tables = written(tmp_path, GOOD.replace("180,12", f"180,{value}"))
    (finding,) = findings(model({**SLIDING, "position": "lift(90 deg*t/(1 s))"}, tables=tables), tmp_path)
    assert finding.data["row"] == 4


def test_a_binary_file_is_refused(tmp_path: Path) -> None:
    tables = written(tmp_path, GOOD)
    (tmp_path / "lift.csv").write_bytes(bytes(range(256)) * 4)
    found = findings(model({**SLIDING, "position": "lift(90 deg*t/(1 s))"}, tables=tables), tmp_path)
    assert [f.code for f in found] == ["table.not-text"]


def test_a_table_never_called_is_no_matter(tmp_path: Path) -> None:
    """Nor is it an error to keep one; but its points must still be numbers."""
    data = model({**SLIDING, "position": "10 mm"}, tables=inline())
    assert not findings(data, tmp_path)


# What a law may not be.


@pytest.mark.parametrize(
    ("drive", "tables"),
    [
        ({**TURNING, "position": "arm.angle"}, {}),
        ({**TURNING, "position": "move(motor.angle)"}, inline("deg", "deg")),
        ({**TURNING, "position": "move(t)"}, inline(between="linear")),
        ({**TURNING, "position": "move(t)"}, inline("s", "mm")),
        ({**TURNING, "position": "move(t)"}, inline("mm", "deg")),
        ({**TURNING, "position": "move(t, t)"}, inline()),
        ({**TURNING, "position": "shift(t)"}, inline()),
        ({**TURNING, "position": "10 mm"}, {}),
        ({**TURNING, "position": "t"}, {}),
        ({**TURNING, "position": "q*t/(1 s)"}, {}),
        ({**TURNING, "speed": "10 mm/s", "start": 0}, {}),
        ({**TURNING, "speed": "60 rpm", "start": "0 mm"}, {}),
        ({**TURNING, "speed": "t*(1 rad/s^2)", "start": 0}, {}),
        ({**TURNING, "speed": "60 rpm", "start": "t*(1 rad/s)"}, {}),
        ({**TURNING, "speed": "1 rad/s/0", "start": 0}, {}),
        ({**TURNING, "speed": "60 rpm", "start": "step5(1, 2, 0 deg, 2, 5 deg)"}, {}),
    ],
    ids=str,
)
def test_a_law_that_is_none_is_a_finding(tmp_path: Path, drive: dict[str, Any], tables: dict[str, Any]) -> None:
    found = findings(model(drive, tables=tables), tmp_path)
    assert found
    assert all(f.path[:2] in (("drives", "motor"), ("tables", "move")) for f in found)
