"""The way back, against the closed-form inverse kinematics of a 5R and laws that are known beforehand."""

from __future__ import annotations

from copy import deepcopy
from functools import cache
from pathlib import Path
from typing import Any

import mpmath as mp
import numpy as np
import pytest
import shapely

from helpers.compiled import compiled_from
from linkwright.compilation import compile_mechanism
from linkwright.findings import ModelError
from linkwright.kernels import Compiled
from linkwright.model.document import load
from linkwright.studies.workspace.inverse_kinematics import Way, _turned, free, timed
from linkwright.studies.workspace.mesh import DriveBox, mesh
from linkwright.studies.workspace.path_continuation import SheetWithRates, SolutionTrack
from linkwright.studies.workspace.regions import Region
from linkwright.studies.workspace.sheet import ModeSheet
from linkwright.studies.workspace.target_path import TargetPath, from_csv, from_dxf, from_formula, path_through_points
from linkwright.studies.workspace.yaml_snippet import pasted

PAPER = Path(__file__).parents[3] / "examples" / "five_bar_workspace.yaml"
MASS = 2.0
FIVE: dict[str, Any] = {
    "linkwright": 1,
    "name": "5R of cranks 1, couplers 1.2, base 1; all mass at C",
    "units": {"length": "m", "angle": "rad", "mass": "kg", "time": "s"},
    "parameters": {"base": 1},
    "links": {
        "frame": {"points": {"A": [0, 0], "E": ["base", 0]}},
        "left": {"points": {"A": [0, 0], "B": [1, 0]}},
        "arm": {"points": {"B": [0, 0], "C": [1.2, 0]}, "mass": MASS, "com": [1.2, 0], "inertia": 0},
        "fore": {"points": {"D": [0, 0], "C": [1.2, 0]}},
        "right": {"points": {"E": [0, 0], "D": [1, 0]}},
    },
    "assembly": {"C": "right of B-D"},
    "drives": {
        "motor": {"turns": "left", "on": "frame", "speed": "1 rad/s", "start": "2 rad"},
        "servo": {"turns": "right", "on": "frame", "speed": "0 rad/s", "start": "1 rad"},
    },
    "studies": {"cycle": {"period": "1 s"}},
}
CIRCLE = "0.5 + 0.3*cos(2*pi*u)", "1.4 + 0.3*sin(2*pi*u)"
AROUND = "0.5*base + 1.45*cos(2*pi*u)", "1.45*sin(2*pi*u)"
"""A circle around both cranks, along which both turn fully."""


@cache
def five() -> Region:
    """The 5R; as shape the two rings that both its modes reach together."""
    compiled = compiled_from(FIVE)
    rings = [shapely.Point(x, 0).buffer(2.2, quad_segs=512) - shapely.Point(x, 0).buffer(0.2) for x in (0, 1)]
    return on(compiled, "C", rings[0] & rings[1])


def on(compiled: Compiled, point: str, shape: Any, box: DriveBox | None = None) -> Region:
    branches = [compiled.assembly.branches[group] for group in compiled.graph.branched]
    sheet = ModeSheet(compiled, point, ("motor", "servo"), branches)
    box = box or DriveBox((0.0, 0.0), (2 * np.pi, 2 * np.pi), (True, True))
    return Region(sheet, box, shape, (), mesh(sheet, box, 24), 24, 0.0)


def formula(x: str, y: str) -> TargetPath:
    return from_formula(five().sheet.compiled.quantities, x, y)


def codes(way: Way) -> list[str]:
    return [finding.code for finding in way.findings]


def crank(x: Any, y: Any, side: int) -> Any:
    """The angle of a crank of 1 on the origin whose coupler of 1.2 ends at (x, y)."""
    r = mp.hypot(x, y)
    return mp.atan2(y, x) + side * mp.acos((1 + r**2 - mp.mpf("1.44")) / (2 * r))


@pytest.mark.parametrize("speed", [1.0, -0.7])
def test_the_servo_follows_the_closed_form(speed: float) -> None:
    """Value, speed and acceleration against the inverse kinematics in closed form, inverted and differentiated by
    mpmath."""
    way = free(five(), formula("0.2 + 0.6*u", "1.6 - 0.1*u^2"), "motor", speed)
    law = way.law
    assert law is not None
    assert law.residual < 1e-14
    with mp.workdps(30):
        start = law.motor[0, 0]

        def place(u: Any) -> tuple[Any, Any]:
            return mp.mpf("0.2") + mp.mpf("0.6") * u, mp.mpf("1.6") - mp.mpf("0.1") * u**2

        def nearest(x: Any, y: Any, value: float) -> int:
            return min((1, -1), key=lambda side: abs(mp.cos(crank(x, y, side)) - mp.cos(value)))

        x0, y0 = place(mp.mpf(float(law.u[0])))
        one, two = nearest(x0, y0, start), nearest(x0 - 1, y0, law.servo[0, 0])
        for k in (40, 300):
            guess = float(law.u[k])

            def servo(t: Any, guess: float = guess) -> Any:
                u = mp.findroot(lambda u: crank(*place(u), one) - start - speed * t, guess)
                x, y = place(u)
                return crank(x - 1, y, two)

            exact = [float(mp.diff(servo, mp.mpf(float(law.t[k])), order, h=mp.mpf("1e-9"))) for order in range(3)]
            assert law.servo[:, k] == pytest.approx(exact, rel=1e-7)
            assert law.motor[:, k] == pytest.approx([start + speed * law.t[k], speed, 0.0], abs=1e-12)


def test_both_drives_follow_a_path_in_time_with_the_torques_of_virtual_work() -> None:
    """A circle at constant speed: the mass at C is accelerated by J^-T of the torques. The coupler pulls along itself,
    so that J^-1 has the rows (C - B) / ((C - B) x (B - A)) of each side."""
    way = timed(five(), formula(*CIRCLE), "motor", 2.0, never_reverse=True)
    law = way.law
    assert law is not None
    assert law.residual < 1e-14
    assert law.period == 2.0
    w = np.pi
    out = np.stack([np.cos(w * law.t), np.sin(w * law.t)])
    force = MASS * -0.3 * w**2 * out
    speed = 0.3 * w * np.stack([-out[1], out[0]])
    rows = []
    for value, pivot in ((law.motor[0], 0.0), (law.servo[0], 1.0)):
        arm = np.stack([np.cos(value), np.sin(value)])
        rod = law.point - arm - [[pivot], [0.0]]
        rows.append(rod / (arm[0] * rod[1] - arm[1] * rod[0]))
    inverse = np.array(rows)
    assert np.stack([law.motor[1], law.servo[1]]) == pytest.approx(np.einsum("ikn,kn->in", inverse, speed), abs=1e-12)
    assert law.efforts is not None
    torque = np.linalg.solve(np.moveaxis(inverse, 2, 0).swapaxes(1, 2), force.T[:, :, None])[:, :, 0].T
    assert law.efforts.effort == pytest.approx(torque, abs=1e-9)
    assert np.abs(law.efforts.power.sum(axis=0)).max() < 1e-9  # the kinetic energy stays the same
    assert law.efforts.share == pytest.approx(law.efforts.work[1] / law.efforts.work.sum())
    # The servo turns back where the circle is tangent to its crank's circles: rod across the speed.
    assert codes(way) == ["workspace.servo-reverses"]
    assert law.reverses.size == 2
    at = law.at(law.reverses)[0]
    assert np.abs(at[1, 1]).max() < 1e-12
    assert (np.diff(np.sign(law.servo[1])) != 0).sum() == 2


def test_a_whole_turn_of_the_motor_makes_a_table_that_moves_the_file_along_the_path() -> None:
    way = free(five(), formula(*AROUND), "motor", 2.0, never_reverse=True)
    law = way.law
    assert law is not None
    assert not way.findings
    assert law.period == pytest.approx(np.pi)
    made = pasted(law, ("rad", "rad"), constant=True)
    assert made.off < 1e-8
    data = deepcopy(FIVE)
    data["tables"] = made.tables
    for name, entry in made.drives.items():
        data["drives"][name] = {k: v for k, v in data["drives"][name].items() if k in ("turns", "on")} | entry
    t = np.linspace(0.0, 5.0, 301)  # beyond the period
    (x, y) = compiled_from(data).evaluate(["C.x", "C.y"], t)
    assert np.abs(np.hypot(x - 0.5, y) - 1.45).max() < 20 * made.off
    assert made.drives["servo"]["position"].startswith("servo_law(t) + ")


def test_a_path_of_the_papers_five_bar_gives_its_law_again() -> None:
    """Points that the example's working point passes (l1 8, l2 26, l3 28, l4 10, l5 30, r2 20, alpha 60 deg) before it
    meets a singular curve; the spline through them is off by less than 1e-9 of the lengths."""
    compiled = compile_mechanism(load(PAPER))
    t = np.linspace(0.0, 0.28, 141)
    points = compiled.evaluate(["P.x", "P.y"], t).T
    region = on(compiled, "P", shapely.Point(0, 0).buffer(0.1))
    way = free(region, path_through_points(points, "quintic"), "motor", np.pi)
    law = way.law
    assert law is not None
    assert law.t[-1] == pytest.approx(0.28, abs=1e-7)
    given = compiled.laws["servo"](law.t).d
    for k, close in ((0, 1e-6), (1, 1e-4), (2, 1e-2)):
        assert law.servo[k] == pytest.approx(np.asarray(given[k]), abs=close * np.pi**k)
    assert law.efforts is not None
    assert law.efforts.share is None  # no masses, no loads


def test_limit_positions_are_passed_where_the_path_touches_the_edge_of_a_sheet() -> None:
    """The paper's five-bar: as crank1 is shorter than link2, each turn of the motor lays them in line twice, where it
    moves P no more. The path of a law with four dead positions gives that law again; without leave it ends at one."""
    region = on(compile_mechanism(load(PAPER)), "P", shapely.Point(0, 0).buffer(0.1))

    def given(t: Any) -> Any:
        return np.stack([np.pi * t, np.pi / 2 + np.pi * t - np.radians(40) * np.cos(np.pi * t)])

    t = np.linspace(0.0, 2.0, 201)
    look = region.sheet.look(given(t))
    passed = np.flatnonzero(np.diff(np.sign(look.determinant)))
    path = path_through_points(look.at.T, "quintic")
    way = free(region, path, "motor", np.pi, never_reverse=True)
    law = way.law
    assert law is not None
    assert codes(way) == ["workspace.path-dead"]
    assert law.limit_positions == pytest.approx((t[passed] + t[passed + 1]) / 2, abs=t[1] / 2)
    assert (law.period, law.determinant) == (pytest.approx(2.0), 0.0)
    assert law.residual < 1e-6 * 0.03
    assert law.servo[0] == pytest.approx(given(law.t)[1], abs=1e-6)
    assert law.servo[1] == pytest.approx(np.pi + np.radians(40) * np.pi * np.sin(np.pi * law.t), abs=2e-4)
    assert law.at(law.limit_positions)[1] == pytest.approx(np.interp(law.limit_positions, law.t, law.u), abs=1e-4)
    assert codes(timed(region, path, "motor", 2.0, off=0.0)) == ["workspace.path-singular"]
    away = path_through_points((look.at - np.array([[0.0], [1e-5]])).T, "quintic")  # 0.01 mm
    assert free(region, away, "motor", np.pi).law is None
    near = free(region, away, "motor", np.pi, off=3e-5).law
    assert near is not None
    assert 1e-6 < near.residual < 3e-5
    assert np.abs(near.servo[0] - given(near.t)[1]).max() < np.sqrt(1e-5 / 0.02)  # of r2 = 20 mm


@pytest.mark.parametrize(
    ("path", "code", "ends"),
    [
        (("-0.3 + 2*u", "1.5"), "workspace.path-outside", ((np.sqrt(2.2**2 - 1.5**2) + 0.3) / 2, 1.0)),
        (("0.5", "1.2 - 2.4*u"), "workspace.path-modes", None),
        (("0.5", "5 + 1*u"), "workspace.path-outside", (0.0, 1.0)),
    ],
)
def test_what_cannot_be_followed_is_told(path: tuple[str, str], code: str, ends: tuple[float, float] | None) -> None:
    way = timed(five(), formula(*path), "motor", 1.0)
    assert way.law is None
    assert codes(way) == [code]
    (stretch,) = way.stretches
    if ends:
        assert (stretch.start, stretch.stop) == pytest.approx(ends, abs=1e-5)
    if path[1] == "5 + 1*u":
        assert stretch.by == pytest.approx(6 - np.sqrt(2.2**2 - 0.25), abs=1e-4)
    assert " nan" not in str(way.findings[0]).lower()


def test_a_motor_that_would_turn_back_and_a_servo_at_its_end() -> None:
    way = free(five(), formula(*CIRCLE), "motor", 1.0)
    assert codes(way) == ["workspace.path-turns"]
    whole = timed(five(), formula(*CIRCLE), "motor", 1.0).law
    assert whole is not None
    (stretch,) = way.stretches
    inner = stretch.start if stretch.stop == 1.0 else stretch.stop
    rate = np.interp(inner, whole.u, whole.motor[1])
    assert abs(rate) < 1e-3 * np.abs(whole.motor[1]).max()
    servo = whole.servo[0]
    limit = float(servo[0]) + 0.5 * float((servo - servo[0]).max())
    low = float(servo.min()) - 1.0
    box = DriveBox((-np.pi, low), (np.pi, limit), (True, False))
    narrow = timed(on(five().sheet.compiled, "C", five().shape, box), formula(*CIRCLE), "motor", 1.0)
    assert codes(narrow) == ["workspace.path-limit"]
    assert narrow.stretches[0].drive == "servo"
    assert np.interp(narrow.stretches[0].start, whole.u, servo) == pytest.approx(limit, abs=1e-3)


def test_paths_from_points_files_and_drawings(tmp_path: Path) -> None:
    (tmp_path / "path.csv").write_text("x [mm],y [cm]\n0,0\n1000,50\n2000,20\n3000,10\n", encoding="utf-8")
    cubic = from_csv("path.csv", tmp_path)
    assert cubic.of(np.array([0.0, 1.0]))[0] == pytest.approx(np.array([[0.0, 3.0], [0.0, 0.1]]))
    u = np.array([0.3, 0.6])
    assert (cubic.of(u + 1e-6)[0] - cubic.of(u - 1e-6)[0]) / 2e-6 == pytest.approx(cubic.of(u)[1], rel=1e-6)
    assert cubic.backward().of(u)[1] == pytest.approx(-cubic.of(1 - u)[1])
    square = path_through_points(np.array([[0, 0], [2, 0], [2, 1], [0, 1], [0, 0]], dtype=float), "linear")
    assert (square.closed, square.corners) == (True, pytest.approx((1 / 3, 1 / 2, 5 / 6, 1.0)))
    ezdxf = pytest.importorskip("ezdxf")
    drawing = ezdxf.new()
    drawing.modelspace().add_circle((500, 0), 300)
    drawing.saveas(tmp_path / "path.dxf")
    drawn = from_dxf("path.dxf", 1e-3, tmp_path)
    assert drawn.closed
    assert np.hypot(*(drawn.of(np.linspace(0, 1, 777))[0] - [[0.5], [0.0]])) == pytest.approx(0.3, abs=1e-4)


@pytest.mark.parametrize(
    ("make", "code"),
    [
        (lambda: formula("0.2 + v", "1"), "workspace.path-name"),
        (lambda: formula("0.2 + C.x", "1"), "workspace.path-name"),
        (lambda: formula("1/u", "1"), "workspace.path-value"),
        (lambda: formula("1 kg", "1"), "expression.units-conflict"),
        (lambda: formula("1 +", "1"), "expression.syntax"),
        (lambda: path_through_points(np.zeros((5, 2))), "workspace.path-short"),
        (lambda: from_csv("nowhere.csv"), "table.unreadable"),
    ],
)
def test_bad_paths_are_findings(make: Any, code: str) -> None:
    with pytest.raises(ModelError) as error:
        make()
    assert [finding.code for finding in error.value.findings] == [code]


def test_bad_files_are_findings(tmp_path: Path) -> None:
    for text, code in (
        ("x [mm],z [mm]\n0,0\n", "table.no-column"),
        ("x [mm],y [kg]\n0,0\n", "workspace.path-unit"),
        ("x [mm],y [mm]\n0,a\n", "table.not-number"),
    ):
        (tmp_path / "path.csv").write_text(text, encoding="utf-8")
        with pytest.raises(ModelError) as error:
            from_csv("path.csv", tmp_path)
        assert error.value.findings[0].code == code
    ezdxf = pytest.importorskip("ezdxf")
    ezdxf.new().saveas(tmp_path / "empty.dxf")
    with pytest.raises(ModelError) as error:
        from_dxf("empty.dxf", 1e-3, tmp_path)
    assert error.value.findings[0].code == "workspace.path-drawing"


def test_a_sliding_servo_with_gravity() -> None:
    """The right crank replaced by a slider on y = 0: its place is x + sqrt(1.2² - y²). The efforts are those of a run
    of the file with the pasted law."""
    data = deepcopy(FIVE)
    del data["links"]["right"]
    data["gravity"] = [0, -9.81]
    data["links"]["frame"]["points"] = {"A": [0, 0], "F": [0, 0]}
    data["links"]["block"] = {"points": {"D": [0, 0]}, "mass": 1, "com": [0, 0], "inertia": 0}
    data["joints"] = {"rail": {"prismatic": ["frame", "block"], "line": ["F at 0 deg", "D at 0 deg"]}}
    data["assembly"] = {"C": "left of B-D"}
    data["drives"]["motor"]["start"] = "1 rad"
    data["drives"]["servo"] = {"slides": "block", "on": "frame", "position": "1.8 m + 0*t/(1 s)*1 m"}
    compiled = compiled_from(data)
    region = on(compiled, "C", shapely.box(-3, -3, 3, 3), DriveBox((0.0, 0.2), (2 * np.pi, 2.6), (True, False)))
    way = free(region, formula("0.8 + 0.2*u", "0.9 - 0.1*u"), "motor", -1.5)
    law = way.law
    assert law is not None
    x, y = law.point
    assert law.servo[0] == pytest.approx(x + np.sqrt(1.44 - y**2), abs=1e-12)
    assert law.efforts is not None
    made = pasted(law, ("rad", "m"), constant=True, close=1e-10)
    data["tables"] = made.tables
    for name, entry in made.drives.items():
        data["drives"][name] = {k: v for k, v in data["drives"][name].items() if k in ("turns", "slides", "on")} | entry
    ran = compiled_from(data).evaluate(["motor.torque", "servo.force", "motor.power", "servo.power"], law.t[5:-5])
    found = np.concatenate([law.efforts.effort, law.efforts.power])[:, 5:-5]
    assert found == pytest.approx(ran, abs=1e-4 * np.abs(ran).max())


def test_a_path_that_rests_is_told() -> None:
    way = free(five(), formula("0.2 + 0.6*u^2", "1.6"), "motor", 1.0)
    assert codes(way) == ["workspace.path-rests"]


def test_corners_are_told() -> None:
    way = timed(five(), path_through_points(np.array([[0.3, 1.5], [0.7, 1.5], [0.7, 1.7]]), "linear"), "motor", 1.0)
    assert codes(way) == ["workspace.path-corner"]
    assert way.law is not None
    assert way.law.residual < 1e-13


def test_a_solution_that_ends_where_it_begins() -> None:
    """At the edge of a region, from where the path leads out of it: the motor gets nowhere."""
    wanted = path_through_points(np.array([[0.03, 0.03], [0.036, 0.036]]), "linear")
    track = SolutionTrack(SheetWithRates(five().sheet), wanted, np.zeros(1), np.zeros((3, 2, 1)), "singular")
    assert _turned(track, 0, 1.0) == 0.0
