"""The cam study: what is refused and with what help, what is never written, and all that can be asked wrongly."""

from __future__ import annotations

import io
import re
import warnings
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from helpers.cams import pair
from helpers.heat_seal import NC, findings, heat_seal, performed
from helpers.workspaces import arm
from linkwright.cam.checks import undercut
from linkwright.cam.disc import TURN
from linkwright.cam.nc.posts import POSTS, Grbl, Post
from linkwright.cam.sizing import resized
from linkwright.results import Run
from linkwright.studies.cam.files import FILES
from linkwright.studies.cam.outcome import CamOutcome

SMALL = {"base": 20, "roller": 30, "sense": "counter-clockwise"}


def study(data: dict[str, Any]) -> CamOutcome:
    outcome = performed(data).cam
    assert outcome is not None
    assert all(finding.what and finding.mend for finding in outcome.failures + outcome.warnings)
    return outcome


def test_an_undercut_cam_is_refused_with_what_mends_it() -> None:
    blank = {"thickness": 12}
    outcome = study(heat_seal(SMALL, blank=blank, nc=NC))
    (finding,) = outcome.failures
    assert finding.code == "cam.undercut" and not outcome.done
    assert (
        not outcome.has_profile and not outcome.milled and not outcome.first.elements and outcome.first.volume is None
    )
    base = float(str(finding.data["base"]).split()[0])
    assert undercut(resized(outcome.disc, {"base": base / 1e3})) is None
    assert undercut(resized(outcome.disc, {"base": base / 1e3 * (1 - 1e-5)})) is not None


@pytest.mark.parametrize("base", [0.02, 0.048])
def test_a_tappet_whose_curvature_passes_through_infinity(base: float) -> None:
    """Undercut or not: no stray warning, and no round-off for a pressure angle that is zero."""
    data = pair("sliding", "face")
    data["cams"]["rider"]["base"] = base
    data["laws"]["lift"]["segments"] = [
        {"rise": 0.009, "over": 1.1, "law": "poly_4567"},
        {"fall": 0.009, "over": 1.1, "law": "poly_4567"},
        {"dwell": TURN - 2.2},
    ]
    with warnings.catch_warnings(action="error"):
        outcome = study(data | {"studies": {"cam": {}}})
    assert outcome.done == (base > 0.04)
    assert {check.value for check in outcome.first.checks if check.name.startswith("pressure")} == {0.0}


def test_a_hollow_narrower_than_the_cutter_is_refused_with_what_mends_it() -> None:
    """That of the cam that turns against the arm's swing has a radius of 243.4 mm."""
    against = {"sense": "counter-clockwise"}
    nc = NC | {"cutter": 260}
    outcome = study(heat_seal(against, nc=nc))
    assert [finding.code for finding in outcome.failures] == ["cam.hollow"]
    assert not outcome.milled and outcome.has_profile  # there is a profile, but not for this cutter
    base = float(str(outcome.failures[0].data["base"]).split()[0])
    kept = study(heat_seal(against | {"base": base}, limits={"cutter": 260}))
    assert kept.done and base > 39


def test_limits_and_requirements_that_are_not_kept() -> None:
    limits = {"pressure_rise": 29, "pressure_return": 45, "pitch_over_roller": 2.2}
    require = {"profile_radius_min": ">= 25 mm", "radius_max": "50 mm .. 56 mm"}
    job = performed(heat_seal(limits=limits, require=require, size={"base": [20, 30]}))
    assert job.exit_code == 1
    assert [f.code for f in job.found] == ["cam.limit", "cam.limit", "cam.required", "cam.no-base"]
    assert job.cam is not None and job.cam.first.smallest is None
    assert [c.passed for c in job.cam.first.checks] == [False, True, False, True]
    assert "29.0444 deg" in job.found[0].what and "90 deg" in job.found[0].what


def test_laws_that_jump() -> None:
    """A constant velocity has no cam; a parabola's acceleration and a cycloid's jerk jump, which a limit refuses."""
    data = heat_seal(limits={"continuity": 2}, require={"profile_radius_min": ">= 0 mm"})
    assert study(data).done
    data["laws"]["swing"]["segments"][0]["law"] = "parabolic"
    assert [finding.code for finding in study(data).failures] == ["cam.rough"] * 3
    data["laws"]["swing"]["segments"][0] = {"rise": 12, "over": 90, "formula": "u"}
    assert {finding.code for finding in findings(data)} == {"drive.law-jumps"}
    assert len(study(heat_seal(limits={"continuity": 3})).failures) == 4


@pytest.mark.parametrize("guide", ["swinging", "sliding"])
def test_an_edge_is_proven_too(guide: str) -> None:
    """A follower without a radius rests between the contour's points."""
    data = pair(guide, "knife", side=-1)
    sizes = {"cutter": 0.006, "depth": 0.011, "feed": 0.01, "speed": 600, "spring": False}
    tolerance = 1e-4 if guide == "swinging" else 1e-5
    data["studies"] = {"cam": {"steps": 90, "nc": {"post": "fanuc", "tolerance": tolerance, **sizes}}}
    outcome = study(data)
    assert outcome.done and 0 < outcome.milled[0].proof.worst < tolerance


def shifted(text: str) -> str:
    """By a tenth of a millimetre along x."""
    return re.sub(r"X(-?[0-9.]+)", lambda found: f"X{float(found[1]) + 0.1:.4f}", text)


@pytest.mark.parametrize(("drawing", "kind"), [("arcs", "LWPOLYLINE"), ("splines", "SPLINE")])
def test_the_drawing_of_a_groove_has_both_flanks(drawing: str, kind: str) -> None:
    ezdxf = pytest.importorskip("ezdxf")
    job = performed(heat_seal({"closed": "groove"}, drawing=drawing))
    assert job.cam is not None
    space = ezdxf.read(io.StringIO(FILES["cam.dxf"].make(job.cam))).modelspace()
    reach = {}
    for layer in ("PROFILE", "FLANK"):
        some = space.query(f'{kind}[layer=="{layer}"]')
        corners = [p for one in some for p in (one.get_points("xy") if kind == "LWPOLYLINE" else one.control_points)]
        reach[layer] = max(np.hypot(p[0], p[1]) for p in corners)
    assert reach["FLANK"] - reach["PROFILE"] == pytest.approx(40.0, abs=0.2)  # a roller's width apart


@pytest.mark.parametrize(
    ("change", "code"),
    [
        (shifted, "nc.off"),
        (lambda text: text.replace("M30", f"({'x' * 99})\nM30"), "nc.long-line"),
        (lambda text: text.replace("M30", ""), "nc.no-end"),
    ],
    ids=["shifted", "long", "endless"],
)
def test_a_wrong_file_is_never_written(monkeypatch: pytest.MonkeyPatch, change: Any, code: str) -> None:
    monkeypatch.setattr(Grbl, "text", lambda *given: change(Post.text(*given)))
    outcome = study(heat_seal(nc=NC, steps=180))
    assert [finding.code for finding in outcome.failures] == [code]
    assert [one.proven for one in outcome.milled] == [False]
    assert FILES["cam_grbl.nc"].make(outcome) is None


def test_the_cam_in_its_link_is_what_the_mechanism_moves() -> None:
    """The follower's roller seen from the cam's link, as the solved mechanism has it, lies on the pitch curve: for a
    mirrored cam with a phase, whose shaft isn't the link's origin."""
    data = pair("swinging", "roller", side=-1, sense=-1)
    data["studies"] = {"cam": {"steps": 36}}
    outcome = study(data)
    run = Run(outcome.compiled, 0.0, TURN / 7.0, 36)
    x, y, turn = outcome.compiled.evaluate(["B.x", "B.y", "disc.angle"], run.t)
    shaft = np.array([[0.01], [-0.02]])
    c, s = np.cos(turn), np.sin(turn)
    away = np.stack([x, y]) - shaft
    seen = np.stack([c * away[0] + s * away[1], c * away[1] - s * away[0]])
    pitch = outcome.first.points_along_link(outcome.disc.look(np.linspace(0, TURN, 20_001)).offset(0.0))
    nearest = np.hypot(*(seen[:, :, None] - pitch[:, None, :])).min(axis=1)
    assert nearest.max() < 1e-5
    corners = np.array([element.start for element in outcome.first.contour])
    area = np.sum(corners[:, 0] * np.roll(corners[:, 1], -1) - corners[:, 1] * np.roll(corners[:, 0], -1)) / 2
    assert area * 1e-6 == pytest.approx(outcome.area, rel=2e-2)  # counter-clockwise though mirrored


def codes(**options: Any) -> dict[str, str]:
    return {".".join(map(str, f.path[2:])): f.code for f in findings(heat_seal(**options))}


def test_what_is_wrong_is_said_at_once() -> None:
    nc = NC | {"feed": "0 mm/min", "tolerance": "1 mm", "lead": -1}
    blank = {"thickness": 12, "bore": 10, "hub": 9, "height": 3}
    found = codes(
        tolerance=0, nc=nc, blank=blank, limits={"pressure_rise": "3 mm"}, require={"weight": ">= 1"},
        size={"base": [40, 20], "against": {"face": [1, 2]}},
    )  # fmt: skip
    assert found == {
        "tolerance": "cam.not-positive",
        "nc.feed": "cam.not-positive",
        "nc.lead": "cam.not-positive",
        "nc.tolerance": "expression.units-conflict",
        "blank.hub": "cam.hub",
        "limits.pressure_rise": "expression.units-conflict",
        "require.weight": "name.unknown",
        "size.base": "value.not-rising",
        "size.against.face": "name.unknown",
    }
    signs = findings(heat_seal(size={"base": [-1, 20]}, forces={"inertia": "-1 kg*m^2"}))
    assert [one.what for one in signs] == [
        "base is -1; it must be more than 0.",
        "inertia is -1 kg*m^2; it must be 0 or more.",
    ]
    keyway = {"thickness": 12, "bore": 10, "key_width": 20, "key_depth": 3}
    assert codes(blank=keyway) == {"blank.key_width": "cam.keyway"}
    assert codes(blank={"thickness": 12, "key_width": 3}) == {"blank": "cam.together"}
    (posts,) = findings(heat_seal(nc=NC | {"post": ["grbl", "heidenhain", "fanuk"]}))
    assert posts.code == "study.choice" and "heidenhain, fanuk" in posts.what
    assert codes(nc=NC | {"depth": "1 m", "step": "1 um"}) == {"nc.step": "cam.passes"}
    other, bare = heat_seal(), arm()
    other["studies"]["cam"]["cam"] = "other"
    assert [f.code for f in findings(other)] == ["name.unknown"]
    bare["studies"] = {"cam": {}}
    assert [f.code for f in findings(bare)] == ["cam.none"]


@pytest.mark.parametrize(
    ("options", "codes"),
    [
        ({"blank": {"thickness": 12, "hub": 40, "height": 8}}, ["cam.blank"]),
        ({"tolerance": "1e-14 mm"}, ["cam.sharp"]),
        ({"nc": NC | {"start": "45 deg"}, "steps": 36}, ["nc.no-dwell"]),
    ],
)
def test_what_turns_out_only_in_the_work(options: dict[str, Any], codes: list[str]) -> None:
    outcome = study(heat_seal(**options))
    assert [finding.code for finding in outcome.failures + outcome.warnings] == codes


def test_a_proof_is_taken_over_by_the_same_motions_only() -> None:
    outcome = study(heat_seal(nc=NC | {"post": [*POSTS]}, steps=180))
    first, *others = outcome.milled
    assert all(one.proof.error is first.proof.error and one.proven for one in others)
    assert replace(first, job=replace(first.job, tolerance=first.proof.worst * 0.99)).proven is False


def test_what_only_a_study_uses_takes_its_unit_from_there() -> None:
    """A bare parameter is an angle in degrees in a limit of one, in turn with what it is made of; a second use as
    something else is told."""
    sections = {"parameters": {"half": 20, "most": "2*half + 5", "near": 3}}
    limits = {"pressure_rise": "most", "profile_radius": "near"}
    outcome = study(heat_seal(limits=limits) | sections)
    assert outcome.stated.limits.pressure_rise == pytest.approx(np.radians(45), rel=1e-15)
    assert outcome.stated.limits.profile_radius == pytest.approx(3e-3, rel=1e-15)
    (finding,) = findings(heat_seal(limits=limits, period="near") | sections)
    assert finding.code == "expression.units-conflict" and finding.path[2:] == ("period",)


def test_what_no_control_would_take_is_told_before_the_run() -> None:
    """Once for all controls; what is the cam's own fault is left to the run, which knows what mends it."""
    nc = NC | {"post": ["grbl", "fanuc"], "compensation": True, "decimals": 6, "lead": 7}
    assert [one.code for one in findings(heat_seal(nc=nc))] == [
        "nc.no-compensation",
        "nc.short-lead",
        "nc.decimals",
        "nc.decimals",
    ]
    assert [
        one.code
        for one in findings(heat_seal(nc=NC | {"post": ["fanuc", "grbl"], "decimals": 2, "tolerance": "1e-4 deg"}))
    ] == ["nc.fine"]
    assert findings(heat_seal(SMALL, nc=NC)) == []
    (finding,) = findings(heat_seal(nc=NC | {"post": []}))
    assert finding.code == "nc.no-post" and "grbl" in finding.mend


def test_what_is_kept_over_a_dwell_is_placed_at_its_start() -> None:
    outcome = study(heat_seal())
    places = {figure.name: np.degrees(figure.theta) for figure in outcome.figures}
    assert places["radius_max"] == pytest.approx(90) and places["radius_min"] == pytest.approx(345)


@pytest.mark.parametrize(("contact", "said"), [("roller", True), ("face", False)])
def test_an_undercut_flat_cam_has_no_roller_to_be_smaller(contact: str, said: bool) -> None:
    data = pair("sliding", contact)
    data["cams"][next(iter(data["cams"]))]["base"] = 1e-3
    data["studies"] = {"cam": {}}
    codes = {finding.code: finding.mend for finding in study(data).failures}
    assert ("roller" in codes["cam.undercut"]) == said


def test_a_key_wrong_in_form_hides_no_other() -> None:
    """Those that hang on it aren't judged: a figure of forces that can't be read isn't unknown besides."""
    wrong = {"steps": "many", "forces": {"contact": "5 N"}, "nc": NC | {"tool": 0}, "colour": "red"}
    sound = {"limits": {"pressure_rise": "45 mm"}, "period": "0 s", "require": {"contact_force_min": ">= 1 N"}}
    told = {one.path[2]: one.code for one in findings(heat_seal(**wrong, **sound))}
    other = {"limits": "expression.units-conflict", "period": "cam.not-positive"}
    assert told == other | {
        "steps": "study.options",
        "forces": "file.missing",
        "nc": "study.options",
        "colour": "file.unknown-key",
    }
    data = heat_seal(**sound)
    data["studies"]["cam"]["cam"] = 3  # of which cam should it be true?
    assert {one.path[2] for one in findings(data)} == {"cam"}


@pytest.mark.parametrize(("guide", "sense"), [("sliding", 1), ("sliding", -1), ("swinging", 1)])
def test_between_which_places_a_face_is_touched(guide: str, sense: int) -> None:
    """In closed form: on a slide s' to the right of the shaft's line where the cam turns counter-clockwise."""
    data = pair(guide, "face", sense=sense) | {"studies": {"cam": {}}}
    outcome = study(data)
    found = {figure.name: figure for figure in outcome.figures}
    look = outcome.disc.look(np.linspace(0, TURN, 7201))
    if guide == "sliding":
        place = sense * np.broadcast_to(look.lift.d[1], look.theta.shape) * -1.0
    else:
        follower: Any = outcome.disc.follower
        psi = follower.start + look.lift.d[0]
        place = follower.distance * np.cos(psi) / (1 + outcome.disc.sense * look.lift.d[1])
    assert found["face_near"].value == pytest.approx(place.min(), abs=1e-7)
    assert found["face_far"].value == pytest.approx(place.max(), abs=1e-7)
    data["studies"]["cam"]["require"] = {"face_far": "<= 1 m", "pitch_radius_min": ">= 1 mm"}
    (finding,) = findings(data)
    assert (finding.code, finding.path[-1]) == ("cam.no-figure", "pitch_radius_min")
