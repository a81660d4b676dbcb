"""Cams in a model file: what they are spelled out as, round trip, builder, refusals."""

from __future__ import annotations

from copy import deepcopy
from typing import Any

import numpy as np
import pytest

from helpers.cams import pair
from helpers.compiled import compiled_from
from linkwright.compilation import examine
from linkwright.elements.cam_contact.follower import CamFollower
from linkwright.findings import Finding, ModelError
from linkwright.model.builder import Builder
from linkwright.model.desugar import spell_out
from linkwright.model.document import Document, dump, parse_document, read_document
from linkwright.report.structure_summary import facts
from linkwright.studies.registry import read_studies


def found(data: dict[str, Any]) -> list[Finding]:
    try:
        document = parse_document(data)
        assert document is not None
        findings = examine(document)[1]
    except ModelError as error:
        findings = list(error.findings)
    assert all(finding.what and finding.mend for finding in findings)
    return findings


def codes(guide: str = "swinging", touch: str = "roller", **changes: Any) -> list[tuple[str, str]]:
    """Codes and places of what is found in a pair with changes ``section__name__key``; None takes a key out."""
    data = deepcopy(pair(guide, touch))
    for path, value in changes.items():
        *way, last = path.split("__")
        at = data
        for key in way:
            at = at.setdefault(key, {})
        at.pop(last) if value is None else at.update({last: value})
    return [(finding.code, finding.element) for finding in found(data)]


def test_a_cam_is_spelled_out_as_a_drive_of_its_name() -> None:
    mechanism = spell_out(Document.model_validate(pair("swinging", "roller"))).mechanism
    drive = mechanism.followers["rider"]
    assert isinstance(drive, CamFollower)
    assert (drive.turns, drive.on, drive.motor, drive.shaft, drive.pivot) == (
        "arm",
        "frame",
        "motor",
        ("Q", "O"),
        ("A", "A"),
    )
    assert list(mechanism.movers) == ["motor", "rider"]


def test_the_file_keeps_it(tmp_path: Any) -> None:
    document = Document.model_validate(pair("sliding", "face"))
    again, source = read_document(dump(document).encode())
    assert not source.findings
    assert again == document
    assert not document.followers


def test_the_builder_makes_the_same() -> None:
    data = pair("swinging", "roller")
    built = Builder().cam("rider", cam="disc", follower="arm", base=0.04, law="lift", phase=0.4, roller=0.012, at="B",
                          side="left of shaft-A")._data["cams"]  # fmt: skip
    assert built == data["cams"]


def test_signals_and_facts_say_that_it_is_a_cam() -> None:
    c = compiled_from(pair("swinging", "roller"))
    own = {s.attribute for s in c.quantities.signals.all() if s.owners == ("rider",)}
    assert own == {"angle", "omega", "alpha", "jerk", "force", "pressure"}
    text = " ".join(str(fact["sentence"]) for fact in facts(c))
    assert "drives: 1, followers: 1" in text
    assert "moved by rider (cam)" in text
    (wrong,) = found(pair("swinging", "roller") | {"measures": {"m": {"max": "rider.torque"}}})
    assert wrong.code == "signal.no-attribute"


def test_its_lengths_stay_live() -> None:
    """Other values of its parameters move the follower as a model with these numbers does."""
    data = pair("swinging", "roller") | {"parameters": {"rb": 0.04, "rr": 0.012, "at": 0.4}}
    data["cams"]["rider"] |= {"base": "rb", "roller": "rr", "phase": "at"}
    document = Document.model_validate(data)
    t = np.linspace(0.0, 0.8, 5)
    names = ["rider.angle", "rider.force"]
    moved = document.replace(rb=0.045, rr=0.01, at=0.5)
    other = pair("swinging", "roller")
    other["cams"]["rider"] |= {"base": 0.045, "roller": 0.01, "phase": 0.5}
    here = examine(moved)[0]
    assert here is not None
    assert here.evaluate(names, t) == pytest.approx(compiled_from(other).evaluate(names, t), rel=1e-13)


CONJUGATE = {"cams__rider__closed": "conjugate"}
REFUSED: list[tuple[dict[str, Any], list[tuple[str, str]]]] = [
    ({"cams__rider__knife": "B"}, [("cam.contact", "cams.rider")]),
    ({"cams__rider__at": None}, [("cam.contact", "cams.rider")]),
    ({"cams__rider__follower": "disc"}, [("cam.same-link", "cams.rider")]),
    ({"cams__rider__cam": "disk", "cams__rider__law": "rise"},
     [("name.unknown", "cams.rider.law"), ("name.unknown", "cams.rider.cam")]),
    ({"cams__rider__at": "X", "cams__rider__side": None},
     [("name.unknown-point", "cams.rider.at"), ("cam.side", "cams.rider.side")]),
    ({"cams__rider__side": "left of B-A"}, [("cam.side", "cams.rider.side")]),
    ({"cams__rider__side": "open"}, [("cam.side", "cams.rider.side")]),
    ({"drives__motor__turns": "arm"}, [("cam.no-motor", "cams.rider")]),
    ({"drives__rider": {"turns": "arm", "on": "frame", "speed": 1, "start": 0}}, [("name.taken", "cams.rider")]),
    ({"drives__other": {"turns": "arm", "on": "frame", "speed": 1, "start": 0}}, [("drive.twice", "cams.rider")]),
    ({"laws__lift__of": "length"}, [("cam.law", "cams.rider.law")]),
    ({"laws__lift__beyond": "hold"}, [("cam.law", "cams.rider.law")]),
    ({"laws__lift__segments": [{"rise": 0.1, "over": 2, "law": "poly_345"},
      {"fall": 0.1, "over": 2, "law": "poly_345"}],
      "laws__lift__period": 4}, [("cam.period", "cams.rider.law")]),
    ({"laws__lift__segments": [{"rise": 0.1, "over": 3, "law": "parabolic"}, {"dwell": 6.283185307179586 - 3}],
      "laws__lift__beyond": "repeat"}, [("law.not-closed", "laws.lift")]),
    ({"cams__rider__base": 0}, [("value.too-small", "cams.rider.base")]),
    ({"cams__rider__roller": "-2 mm"}, [("value.too-small", "cams.rider.roller")]),
    ({"cams__rider__base": 0.2}, [("cam.reach", "cams.rider")]),
    ({"links__frame__points__A": [0.01, -0.02]}, [("cam.no-distance", "cams.rider")]),
    ({"cams__rider__at": "A"}, [("cam.no-arm", "cams.rider")]),
    ({"cams__rider__closed": "form"}, [("file.expected", "cams.rider.closed")]),
    ({"cams__rider__closed": "yoke"}, [("cam.yoke", "cams.rider.closed")]),
    ({"cams__rider__second": {}}, [("cam.second", "cams.rider")]),
    (CONJUGATE | {"cams__rider__second": {"at": "X", "roller": 0}},
     [("name.unknown-point", "cams.rider.second.at"), ("value.too-small", "cams.rider.second.roller")]),
    (CONJUGATE | {"cams__rider__second": {"base": 0}}, [("value.too-small", "cams.rider.second.base")]),
    (CONJUGATE | {"cams__rider__second": {"at": "T", "base": 0.04}}, [("cam.second-twice", "cams.rider.second")]),
    (CONJUGATE | {"cams__rider__second": {"face": "T at 1"}}, [("cam.second-other", "cams.rider")]),
    (CONJUGATE | {"cams__rider__second": {"at": "T"}}, [("cam.second-side", "cams.rider.second")]),
    (CONJUGATE | {"cams__rider__second": {"at": "A"}}, [("cam.no-arm", "cams.rider.second")]),
    (CONJUGATE | {"cams__rider__second": {"base": 0.2}}, [("cam.reach", "cams.rider.second")]),
    (CONJUGATE | {"cams__rider__second": {"at": "C", "roller": 0.07}, "links__arm__points__C": [0, 0.08]},
     [("cam.second-base", "cams.rider.second")]),
    (CONJUGATE | {"cams__rider__base": 0.158}, [("cam.second-side", "cams.rider")]),
    ({"cams__rider__base": "40 N"}, [("expression.units-conflict", "cams.rider.base")]),
]  # fmt: skip


@pytest.mark.parametrize(("changes", "wanted"), REFUSED)
def test_refusals_stand_at_the_cam(changes: dict[str, Any], wanted: list[tuple[str, str]]) -> None:
    assert codes(**changes) == wanted


def test_refusals_of_other_followers() -> None:
    assert codes("sliding", "face", cams__rider__face="B at 0.7") == [("cam.askew", "cams.rider.face")]
    assert codes("sliding", "roller", cams__rider__base=0.001, cams__rider__roller=0.001) == [
        ("cam.offset", "cams.rider")
    ]
    assert codes("sliding", "knife", cams__rider__closed="groove") == [("cam.groove", "cams.rider")]
    sliding = {"cams__rider__closed": "conjugate"}
    for touch, second, code in (
        ("roller", {"at": "T"}, "cam.second-height"),
        ("roller", {"base": 0.001, "roller": 0.001}, "cam.offset"),
        ("face", {"face": "T at 2.2707963267948966"}, "cam.second-height"),
    ):
        assert codes("sliding", touch, **sliding, cams__rider__second=second) == [(code, "cams.rider.second")]
    assert codes("sliding", "face", **sliding, cams__rider__second={"face": "T at 1"}) == [
        ("cam.askew", "cams.rider.second.face")
    ]
    assert codes("swinging", "face", cams__rider__base=0.2) == [("cam.face", "cams.rider")]
    assert codes("sliding", "knife", joints__guide=None)[0] == ("cam.no-guide", "cams.rider")
    assert codes(joints__shaft=None)[0] == ("cam.no-shaft", "cams.rider")


def test_a_guide_on_a_point_that_is_not_there() -> None:
    """That is told; no follower is laid on such a guide."""
    data = deepcopy(pair("sliding", "roller"))
    (guide,) = [joint for joint in data["joints"].values() if "line" in joint]
    guide["line"] = ["Nowhere at 90 deg", guide["line"][1]]
    assert [finding.code for finding in found(data)] == ["name.unknown-point"]


def test_how_far_an_arm_misses() -> None:
    (finding,) = found(
        pair("swinging", "roller") | {"cams": {"rider": {**pair("swinging", "roller")["cams"]["rider"], "base": 0.2}}}
    )
    away, arm = np.hypot(0.08, 0.03), np.hypot(0.08, 0.028)
    assert float(finding.data["by"]) == pytest.approx(0.212 - away - arm, rel=1e-5)


def test_studies_that_move_drives_singly() -> None:
    """The limits look at the motor alone, with which the follower moves; a workspace has no second drive."""
    data = pair("swinging", "roller") | {"studies": {"limits": {}}}
    document = Document.model_validate(data)
    c, _ = examine(document)
    assert c is not None
    (task,), _ = read_studies(document.studies)
    outcome = task.study.run(c, task.options)
    assert [drive.drive for drive in outcome.drives] == ["motor"]
    (task,), findings = read_studies({"workspace": {"point": "B"}})
    assert not findings
    assert [finding.code for finding in task.study.check(c, task.options)] == ["study.cams"]
