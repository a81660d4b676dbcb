"""Second discs and yokes in the cam study: all that is made of a second disc, what can't be made and with what mend."""

from __future__ import annotations

import csv
import io
import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
import shapely

from helpers.cams import closed_pair, pair
from helpers.compiled import compiled_from
from helpers.heat_seal import findings, performed
from helpers.shown import blocks, rows
from linkwright.app.job import Job
from linkwright.cam.cams_of_mechanism import second as second_of
from linkwright.cam.checks import undercut
from linkwright.cam.disc import TURN
from linkwright.model.document import load, plain
from linkwright.presentation.blocks import Charts, Table
from linkwright.report.build import report_data
from linkwright.report.page import page
from linkwright.results import Run
from linkwright.studies.cam.files import FILES
from linkwright.studies.cam.outcome import CamOutcome
from linkwright.studies.cam.report import report

EXAMPLE = Path(__file__).parents[3] / "examples" / "conjugate_cam.yaml"
NC = {
    "post": "grbl",
    "cutter": "8 mm",
    "depth": "12 mm",
    "tolerance": "2e-4",
    "feed": "400 mm/min",
    "speed": "6000 rpm",
}
FORCES = {"inertia": "0.012 kg*m^2", "speed": "300 rpm", "width": "10 mm"}


def study(data: dict[str, Any], **options: Any) -> Job:
    data["studies"] = {"cam": {"steps": 36, **options}}
    return performed(data)


def outcome_of(data: dict[str, Any], **options: Any) -> CamOutcome:
    found = study(data, **options).cam
    assert found is not None
    assert all(finding.what and finding.mend for finding in found.failures + found.warnings)
    return found


def figures(outcome: CamOutcome) -> dict[str, float]:
    return {figure.name: figure.value for figure in outcome.figures}


@pytest.fixture(scope="module")
def job() -> Job:
    data = closed_pair("swinging", "roller", side=-1, sense=-1)
    require = {"second_pitch_radius_min": ">= 1 m", "between": "77 deg .. 78 deg"}
    blank = {"thickness": "12 mm", "bore": "8 mm"}
    return study(data, require=require, nc=NC, blank=blank, forces=FORCES, size={"base": ["30 mm", "50 mm"]})


@pytest.fixture(scope="module")
def outcome(job: Job) -> CamOutcome:
    assert job.cam is not None
    return job.cam


def test_the_second_disc_as_drawn_is_what_the_mechanism_moves(outcome: CamOutcome) -> None:
    """The second roller seen from the cam's link, as the solved mechanism has it, is its radius off the contour; the
    second table holds the same profile."""
    run = Run(outcome.compiled, 0.0, TURN / 7.0, 36)
    x, y, turn = outcome.compiled.evaluate(["C.x", "C.y", "disc.angle"], run.t)
    seen = ((x - 0.01) + 1j * (y + 0.02)) * np.exp(-1j * turn)
    second = outcome.second
    assert second is not None and second.disc.follower.radius == 0.009
    body = shapely.Polygon([place for element in second.contour for place in _ends(element)])
    gap = shapely.distance(body, shapely.points(1e3 * seen.real, 1e3 * seen.imag))
    assert gap == pytest.approx(9.0, abs=1e-3)
    rows = list(csv.DictReader(io.StringIO(str(FILES["cam_second_profile.csv"].make(outcome)))))
    places = np.array([[float(row[f"profile {axis} [m]"]) for axis in "xy"] for row in rows])
    assert shapely.distance(body.exterior, shapely.points(1e3 * places)).max() < 2e-3
    assert second.area * 1e6 == pytest.approx(body.area, rel=1e-4)


def _ends(element: Any) -> list[tuple[float, float]]:
    """Chords of an arc, of 0.6 deg each at the most."""
    if element.centre is None:
        return [element.start]
    away = complex(*element.start) - complex(*element.centre)
    some = np.linspace(0.0, element.swept, 2 + math.ceil(element.swept / 0.01))[:-1]
    return [(z.real, z.imag) for z in complex(*element.centre) + away * np.exp(1j * element.turn * some)]


def test_all_that_is_made_of_one_disc_is_made_of_both(job: Job, outcome: CamOutcome) -> None:
    assert [finding.code for finding in outcome.failures] == ["cam.required"]
    assert "second_pitch_radius_min" in outcome.failures[0].what
    assert all(one.proven for plate in outcome.plates for one in plate.milled)
    files = {name for name, file in FILES.items() if not name.endswith("step") and file.make(outcome) is not None}
    assert files >= {"cam_grbl.nc", "cam_second_grbl.nc", "cam_second_profile.csv"}
    first, second = (str(FILES[f"cam_{name}grbl.nc"].make(outcome)) for name in ("", "second_"))
    assert "SECOND DISC" in second and "SECOND" not in first
    assert ("SEEN FROM BEHIND" in first, "SEEN FROM BEHIND" in second) == (True, False)  # the first one is the mirrored
    entry = json.loads(json.dumps(job.summary["cam"], allow_nan=False))
    told = entry["second"]
    assert told["nc"]["grbl"]["written"] and told["contour"]["area"] != entry["contour"]["area"]
    assert [check["name"] for check in told["checks"]][:3] == ["pressure_rise", "pressure_return", "pitch_radius"]
    assert told["base"] == entry["figures"]["second_base"]["value"] == job.summary["measures"]["second_base"]["value"]
    assert entry["figures"]["between"] | {"value": 0} == entry["figures"]["between"] | {"value": 0, "met": True}
    assert entry["figures"]["between"]["value"] == pytest.approx(1.35)
    assert 0.03 <= told["size"]["base"] <= told["base"]
    assert job.examined.document is not None
    shown, text = report(outcome), page(report_data(job.examined.document, job.outcomes))
    (pictures,) = blocks(shown, Charts)
    assert len(pictures.charts) == 15  # two of the second disc's milling
    for chart in pictures.charts:
        assert chart.drawing in text if chart.content is None else f'data-chart="{chart.key}"' in text
    labels = [row[0] for table in blocks(shown, Table) for row in rows(table)]
    assert "grbl, second disc" in labels and "area inside the profile, second disc" in labels
    picture = str(FILES["cam.svg"].make(outcome))
    assert picture.count('circle class="follower"') == 3 and 'class="profile second"' in picture  # rollers and pivot


def test_the_drawing_has_a_layer_for_each_disc(outcome: CamOutcome) -> None:
    ezdxf = pytest.importorskip("ezdxf")
    space = ezdxf.read(io.StringIO(str(FILES["cam.dxf"].make(outcome)))).modelspace()
    layers = {line.dxf.layer: len(line) for line in space.query("LWPOLYLINE")}
    assert layers == {"PROFILE": len(outcome.first.elements), "SECOND": len(outcome.plates[1].elements)}


def test_forces_on_both_discs(outcome: CamOutcome) -> None:
    """The moment of the contact force about the pivot turns the follower; both contacts bear in turn. Hertz pressure
    for a roller of 9 mm on the profile, both of steel."""
    second, found = outcome.plates[1], figures(outcome)
    theta = np.linspace(0.0, TURN, 20_001)[:-1]
    look = second.disc.look(theta)
    turning = np.broadcast_to(look.lift.d[2], theta.shape) * 0.012 * (10 * math.pi) ** 2
    centre, along = (np.array([np.broadcast_to(c.d[0], theta.shape) for c in of]) for of in (look.centre, look.along))
    pivot = second.disc.follower.distance
    lever = (centre[0] - pivot) * along[1] - centre[1] * along[0]
    force = -turning / lever  # rises clockwise
    assert found["second_contact_force_max"] == pytest.approx(force.max(), rel=1e-5)
    assert found["contact_force_min"] == 0.0 and found["contact_force_max"] > 0
    reduced = 1 / (1 / 0.009 + 1 / look.radius(-0.009))
    modulus = 207e9 / (2 * (1 - 0.292**2))
    hertz = np.sqrt(np.maximum(force, 0.0) * modulus / (math.pi * 0.010 * reduced)).max()
    assert found["second_hertz_pressure_max"] == pytest.approx(hertz, rel=1e-5)
    assert outcome.pressed is not None
    assert found["second_roller_speed_max"] > 0 and len(outcome.pressed.forces.reversals) == 4  # rises and two falls


def test_the_mechanism_has_the_same_forces() -> None:
    """The solver's multipliers in the example, whose sley's mass is that of the study; negative on the second disc."""
    data = plain(load(EXAMPLE))
    data["studies"] = {"cam": {"steps": 36, "forces": data["studies"]["cam"]["forces"]}}
    outcome = outcome_of(data, **data["studies"]["cam"])
    run = Run(outcome.compiled, 0.0, 0.2, 360)  # 300 rpm
    force, torque = outcome.compiled.evaluate(["sley_drive.force", "shaft.torque"], run.t[:-1])
    assert outcome.pressed is not None
    told = replace(outcome.pressed.forces, theta=TURN * run.t[:-1] / 0.2)
    assert np.abs(told.contact - told.contact_second - force).max() < 1e-9 * force.max()
    assert np.abs(told.torque - torque).max() < 1e-9 * torque.max()


def test_an_undercut_second_disc_is_refused_with_what_mends_it() -> None:
    """By its base circle, or by the place of its contact."""
    data = closed_pair("swinging", "roller")
    data["cams"]["rider"]["second"] = {"base": 0.008, "roller": 0.04}
    outcome = outcome_of(data)
    (finding,) = outcome.failures
    assert finding.code == "cam.undercut" and finding.element == "cams.rider.second" and "second disc" in finding.what
    second = outcome.second
    assert second is not None and not second.has_profile and outcome.has_profile  # the first one is sound
    assert FILES["cam_second_profile.csv"].make(outcome)
    told = finding.data["base"].data
    data["cams"]["rider"]["second"]["base"] = told["base"]
    mended = outcome_of(data)
    assert mended.done and figures(mended)["between"] == pytest.approx(float(told["between"].split()[0]), rel=1e-5)
    data["cams"]["rider"]["second"]["base"] = float(told["base"].split()[0]) * (1 - 1e-4)
    assert undercut(second_of(compiled_from(data), "rider").disc) is not None


def test_limits_hold_for_both_discs() -> None:
    data = closed_pair("swinging", "roller")
    limits = {"pressure_rise": 0.05, "profile_radius": "1 m"}
    outcome = outcome_of(data, limits=limits)
    codes = [(finding.code, "second" in finding.what) for finding in outcome.failures]
    assert codes == [("cam.limit", False)] * 2 + [("cam.limit", True)] * 2


def test_what_is_wrong_is_said_at_once() -> None:
    data = closed_pair("swinging", "roller")
    require = {"yoke_span_max": ">= 1 m", "second_base": ">= 1 kg", "second_contact_force_max": "<= 1 N"}
    data["studies"] = {"cam": {"tolerance": 0, "limits": {"play": "1 mm"}, "require": require}}
    found = findings(data)
    assert all(finding.what and finding.mend for finding in found)
    assert {".".join(map(str, finding.path[2:])): finding.code for finding in found} == {
        "tolerance": "cam.not-positive",
        "limits.play": "cam.together",
        "require.yoke_span_max": "cam.no-figure",
        "require.second_base": "expression.units-conflict",
        "require.second_contact_force_max": "cam.no-figure",
    }


@pytest.mark.parametrize(("key", "second"), [("second", {"base": "1/0"}), ("second", {"at": "C", "roller": "1/0"})])
def test_what_has_no_value_is_told_alone(key: str, second: dict[str, Any]) -> None:
    data = closed_pair("swinging", "roller")
    data["cams"]["rider"][key] = second
    assert [finding.code for finding in findings(data)] == ["value.not-finite"]
    data = closed_pair("swinging", "roller")
    data["cams"]["rider"]["base"] = "1/0"
    assert [finding.code for finding in findings(data)] == ["value.not-finite"]


def yoked(touch: str, fall: float = math.pi) -> dict[str, Any]:
    data = pair("sliding", touch, closed="yoke")
    rise, back = ({key: 0.008, "over": over, "law": "poly_345"} for key, over in (("rise", math.pi), ("fall", fall)))
    data["laws"]["lift"]["segments"] = [rise, back] + ([{"dwell": math.pi - fall}] if fall < math.pi else [])
    return data


@pytest.mark.parametrize("touch", ["roller", "face"])
def test_a_yoke_fits_where_opposite_lifts_add_up(touch: str) -> None:
    """A return half a turn after the rise by the same law: the span is that of both starts and the stroke."""
    outcome = outcome_of(yoked(touch), forces={"inertia": "2 kg", "speed": "300 rpm"})
    assert outcome.done and not outcome.warnings
    found, start = figures(outcome), outcome.disc.follower.start
    assert found["play"] == pytest.approx(0.0, abs=1e-15)
    assert found["yoke_span_min"] == pytest.approx(found["yoke_span_max"]) == pytest.approx(2 * start + 0.008)
    assert found["second_contact_force_max"] == pytest.approx(found["contact_force_max"])  # a mirror image in time
    assert outcome.pressed is not None and len(outcome.pressed.forces.reversals) == 2
    ElementTree.fromstring(str(FILES["cam.svg"].make(outcome)))
    assert not any("second" in name for name, file in FILES.items() if file.make(outcome) is not None)


def test_a_yoke_with_play() -> None:
    """The extremes of both lifts' sum against a dense sampling."""
    data = yoked("face", 2.2)
    loose = outcome_of(data)
    (warning,) = loose.warnings
    assert loose.done and warning.code == "cam.play" and warning.severity == "warning"
    lift = loose.disc.look(np.linspace(0.0, TURN, 40_001)[:-1]).lift.d[0]
    both = lift + np.roll(lift, 20_000)
    assert figures(loose)["play"] == pytest.approx(np.ptp(both), rel=1e-6)
    kept = outcome_of(data, limits={"play": "20 mm"}, require={"play": "<= 20 mm"})
    assert kept.done and not kept.warnings
    tight = outcome_of(data, limits={"play": "0.1 mm"})
    assert [(finding.code, finding.element) for finding in tight.failures] == [("cam.play", "cams.rider.closed")]
