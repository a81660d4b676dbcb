"""Faults of form: missing keys, wrong types, keys that don't go together; all at once, each told once."""

from __future__ import annotations

from typing import Any

import pytest
from pydantic import ValidationError

from linkwright.findings import Finding, ModelError
from linkwright.model.document import Document, parse_document
from linkwright.model.mechanism import Link
from model.given import FEEDER, changed, findings, four_bar


def faults(**sections: Any) -> list[Finding]:
    """What is found in the form of the four-bar with these sections."""
    try:
        parse_document(four_bar(**sections))
    except ModelError as error:
        return list(error.findings)
    return []


def one(**sections: Any) -> Finding:
    found = faults(**sections)
    assert len(found) == 1, [str(finding) for finding in found]
    return found[0]


def test_the_example_has_none() -> None:
    assert not faults()


def test_a_misspelled_key_of_a_cam_is_told_the_known_ones() -> None:
    cam = {"cam": "crank", "folower": "rocker", "on": "frame", "base": 30, "law": "lift", "knife": "B"}
    found = {finding.code: finding for finding in faults(cams={"seal": cam})}
    assert found.keys() == {"file.unknown-key"}  # that the follower is missing follows from it
    assert "'follower'" in found["file.unknown-key"].mend


@pytest.mark.parametrize(
    ("section", "entry", "code", "element"),
    [
        ("links", {"frame": {}}, "file.missing", "links.frame"),
        ("links", {"frame": {"points": {}, "mas": 1}}, "file.unknown-key", "links.frame.mas"),
        ("links", {"frame": {"points": []}}, "file.expected", "links.frame.points"),
        ("links", {"frame": {"points": [[]]}}, "file.expected", "links.frame.points"),
        ("links", {"frame": {"points": ["A", []]}}, "file.expected", "links.frame.points"),
        ("links", {"frame": {"points": [{}]}}, "file.expected", "links.frame.points"),
        ("links", {"frame": {"points": [0]}}, "file.expected", "links.frame.points"),
        ("links", {"frame": {"points": {"A": [0]}}}, "file.expected", "links.frame.points.A"),
        ("links", {"frame": {"points": {"A": [0, 0, 0]}}}, "file.expected", "links.frame.points.A"),
        ("links", {"frame": {"points": {"A": "3"}}}, "file.expected", "links.frame.points.A"),
        ("links", {"frame": {"points": {"A": [None, 0]}}}, "file.expected", "links.frame.points.A"),
        ("links", {"frame": {"points": {"A": [True, 0]}}}, "file.expected", "links.frame.points.A"),
        ("links", {"frame": {"points": {"A": ["1 +", 0]}}}, "expression.syntax", "links.frame.points.A"),
        ("links", {"frame": {"points": {"A b": [0, 0]}}}, "file.bad-name", "links.frame.points.A b"),
        ("links", {"frame": {"points": {"x" * 61: [0, 0]}}}, "file.bad-name", f"links.frame.points.{'x' * 61}"),
        ("links", {"t": {"points": {}}}, "file.reserved-name", "links.t"),
        ("links", {"1st": {"points": {}}}, "file.bad-name", "links.1st"),
        ("links", {"a\n": {"points": {}}}, "file.bad-name", "links.a"),
        ("links", [], "file.expected", "links"),
        ("links", None, "file.expected", "links"),
        ("links", {f"l{i}": {"points": {}} for i in range(300)}, "file.too-many", "links"),
        ("parameters", {"a": None}, "file.expected", "parameters.a"),
        ("parameters", {"a": [1]}, "file.expected", "parameters.a"),
        ("parameters", {"a": {"value": float("nan")}}, "file.not-finite", "parameters.a.value"),
        ("parameters", {"a": float("inf")}, "file.not-finite", "parameters.a"),
        ("parameters", {"a": "nan"}, "file.not-finite", "parameters.a"),
        ("parameters", {"a": "-inf"}, "file.not-finite", "parameters.a"),
        ("parameters", {"a": 10**400}, "file.not-finite", "parameters.a"),
        ("parameters", {"a": {"tolerance": 1}}, "file.missing", "parameters.a"),
        ("parameters", {"a": {"value": 1, "tolerance": [1]}}, "file.expected", "parameters.a.tolerance"),
        ("parameters", {"a": "x" * 2001}, "file.long", "parameters.a"),
        ("units", {"length": 5}, "file.expected", "units.length"),
        ("units", {"lenght": "mm"}, "file.unknown-key", "units.lenght"),
        ("gravity", [0], "file.expected", "gravity"),
        ("gravity", 9.81, "file.expected", "gravity"),
        ("gravity", "down", "file.expected", "gravity"),
        ("joints", {"j": {}}, "joint.kind", "joints.j"),
        ("joints", {"j": {"prismatic": ["a", "b"]}}, "joint.line", "joints.j"),
        ("joints", {"j": {"revolute": ["a", "b"]}}, "joint.at", "joints.j"),
        ("joints", {"j": {"prismatic": ["a"], "line": ["A at 0", "B at 0"]}}, "file.expected", "joints.j.prismatic"),
        (
            "joints",
            {"j": {"prismatic": ["a", 5], "line": ["A at 0", "B at 0"]}},
            "file.expected",
            "joints.j.prismatic.1",
        ),
        ("joints", {"j": {"prismatic": ["a", "b"], "line": ["A at 0", "B"]}}, "file.expected", "joints.j.line.1"),
        ("joints", {"j": {"prismatic": ["a", "b"], "line": ["A at 0"]}}, "file.expected", "joints.j.line"),
        ("assembly", {"C": "left"}, "file.expected", "assembly.C"),
        ("assembly", {"C": [1, 2, 3]}, "file.expected", "assembly.C"),
        ("drives", {"m": {"turns": "crank", "position": 1}}, "drive.on", "drives.m"),
        ("drives", {"m": {"on": "frame", "speed": 1, "start": 0}}, "drive.kind", "drives.m"),
        ("drives", {"m": {"turns": "crank", "on": "frame"}}, "drive.law", "drives.m"),
        ("drives", {"m": {"turns": "crank", "on": "frame", "speed": 1}}, "drive.start", "drives.m"),
        ("drives", {"m": {"turns": "crank", "on": "frame", "position": 1, "start": 1}}, "drive.start", "drives.m"),
        ("tables", {"c": {}}, "table.source", "tables.c"),
        ("tables", {"c": {"file": "a.csv"}}, "table.columns", "tables.c"),
        ("tables", {"c": {"points": [[0, 1]], "x": "a s"}}, "table.inline-columns", "tables.c"),
        ("tables", {"c": {"points": [[0, 1], [2]]}}, "file.expected", "tables.c.points.1"),
        ("tables", {"c": {"points": 3}}, "file.expected", "tables.c.points"),
        ("tables", {"c": {"points": [[0, 1]], "between": "nearest"}}, "file.expected", "tables.c.between"),
        ("tables", {"c": {"file": "a.csv", "x": "a furlong", "y": "b"}}, "units.unknown", "tables.c.x"),
        ("tables", {"c": {"file": "a.csv", "x": " ", "y": "b"}}, "file.expected", "tables.c.x"),
        ("tables", {"c": {"file": "../a.csv", "x": "a", "y": "b"}}, "table.place", "tables.c.file"),
        ("tables", {"c": {"file": "/etc/passwd", "x": "a", "y": "b"}}, "table.place", "tables.c.file"),
        ("tables", {"c": {"file": "C:\\a.csv", "x": "a", "y": "b"}}, "table.place", "tables.c.file"),
        ("loads", {"l": {"on": "crank"}}, "load.empty", "loads.l"),
        ("loads", {"l": {"on": "crank", "force": [1, 2]}}, "load.at", "loads.l"),
        ("loads", {"l": {"on": "crank", "at": "B", "force": 3}}, "load.direction", "loads.l"),
        ("loads", {"l": {"on": "crank", "at": "B", "force": [1, 2], "along": "s"}}, "load.direction", "loads.l"),
        ("loads", {"l": {"on": "crank", "at": "B", "force": 3, "along": "s", "in": "crank"}}, "load.in", "loads.l"),
        ("loads", {"l": {"on": "crank", "at": "B", "force": [1, 2, 3]}}, "file.expected", "loads.l.force"),
        ("loads", {"l": {"on": "crank", "at": "B", "force": {"x": 1}}}, "file.expected", "loads.l.force"),
        ("loads", {"l": {"on": "crank", "at": [1], "force": [1, 2]}}, "file.expected", "loads.l.at"),
        ("loads", {"l": {"on": "crank", "at": 7, "force": [1, 2]}}, "file.expected", "loads.l.at"),
        ("loads", {"l": {"on": "crank", "at": "A B", "force": [1, 2]}}, "file.expected", "loads.l.at"),
        ("loads", {"l": {"on": "crank", "at": "1B", "force": [1, 2]}}, "file.bad-name", "loads.l.at"),
        ("loads", {"l": {"on": "crank", "torque": 1, "in_": "frame"}}, "file.unknown-key", "loads.l.in_"),
        (
            "drives",
            {"m": {"turns": "crank", "on": "frame", "position": 1, "acceleration": 1}},
            "drive.acceleration",
            "drives.m",
        ),
        ("springs", {"s": {"from": "A", "stiffness": 1, "free": 0}}, "spring.ends", "springs.s"),
        ("springs", {"s": {"from": "A", "to": "B", "turns": "crank", "on": "frame"}}, "spring.ends", "springs.s"),
        ("springs", {"s": {"from": "A", "to": "B"}}, "spring.law", "springs.s"),
        (
            "springs",
            {"s": {"from": "A", "to": "B", "stiffness": 1, "free": 0, "force": "f"}},
            "spring.law",
            "springs.s",
        ),
        ("springs", {"s": {"from": "A", "to": "B", "stiffness": 1}}, "spring.free", "springs.s"),
        ("springs", {"s": {"from": "A", "to": "B", "gas": 1}}, "spring.gas", "springs.s"),
        ("springs", {"s": {"from": "A", "to": "B", "damping": 1, "free": 0}}, "spring.stray", "springs.s"),
        ("springs", {"s": {"turns": "crank", "on": "frame", "damping": 1, "gas": 1}}, "spring.stray", "springs.s"),
        ("springs", {"s": {"from": "A", "to": "B", "force": "20 N"}}, "file.bad-name", "springs.s.force"),
        ("counterweights", {"w": {"on": "crank", "at": "B"}}, "file.missing", "counterweights.w"),
        ("windows", {"w": [1, 2, 3]}, "file.expected", "windows.w"),
        ("windows", {"w": 3}, "file.expected", "windows.w"),
        ("windows", {"w": {}}, "window.one-signal", "windows.w"),
        ("windows", {"w": {"a.x": [0, 1], "b.x": [0, 1]}}, "window.one-signal", "windows.w"),
        ("windows", {"w": {"motor": [0, 1]}}, "window.signal", "windows.w.motor"),
        ("windows", {"w": {"motor.angle": 3}}, "file.expected", "windows.w.motor.angle"),
        ("windows", {"w": {"motor.(": [0, 1]}}, "expression.syntax", "windows.w.motor.("),
        ("measures", {"m": {}}, "measure.reduction", "measures.m"),
        ("measures", {"m": {"max": "B.x", "min": "B.x"}}, "measure.reduction", "measures.m"),
        ("measures", {"m": {"value": "B.x"}}, "measure.where", "measures.m"),
        ("measures", {"m": {"max": "B.x", "where": "start"}}, "measure.where", "measures.m"),
        ("measures", {"m": {"dwell": "B.x"}}, "measure.within", "measures.m"),
        ("measures", {"m": {"max": "B.x", "within": "1 mm"}}, "measure.within", "measures.m"),
        ("measures", {"m": {"value": "B.x", "where": "largest B.y"}}, "measure.bad-where", "measures.m.where"),
        ("measures", {"m": {"value": "B.x", "where": "max B.y +"}}, "expression.syntax", "measures.m.where"),
        ("measures", {"m": {"max": "B.x", "unit": "furlong"}}, "units.unknown", "measures.m.unit"),
        ("measures", {"m": {"max": "B.x", "wrap": 360}}, "file.expected", "measures.m.wrap"),
        ("require", {"m": 5}, "file.expected", "require.m"),
        ("require", {"m": "= 5"}, "file.expected", "require.m"),
        ("require", {"m": ">= "}, "expression.syntax", "require.m"),
        ("require", {"m": "1 .. 2 .. 3"}, "expression.syntax", "require.m"),
        ("studies", {"cycle": 5}, "file.expected", "studies.cycle"),
        ("studies", {"cycle": {"period": float("nan")}}, "file.not-finite", "studies.cycle"),
        ("studies", {"cycle": {"period": object()}}, "file.expected", "studies.cycle"),
        ("linkwright", 2, "file.version", "linkwright"),
        ("linkwright", True, "file.version", "linkwright"),
        ("linkwright", 1.0, "file.version", "linkwright"),
        ("name", 2024, "file.expected", "name"),
        ("name", "a\0b", "file.character", "name"),
        ("note", "x" * 20_001, "file.long", "note"),
        ("parameters", {"a": "\x1f1"}, "file.character", "parameters.a"),
        ("pistons", {}, "file.unknown-key", "pistons"),
    ],
)
def test_faults(section: str, entry: Any, code: str, element: str) -> None:
    """Each wrong entry gives one finding, at its place: no branch of a union tells its own story."""
    found = one(**{section: entry})
    assert (found.code, found.element) == (code, element)
    assert found.what
    assert found.mend


@pytest.mark.parametrize(
    ("given", "code"),
    [
        ({"com": [0, 0]}, "mass.missing"),
        ({"inertia": 1}, "mass.missing"),
        ({"shape": "rod A-B"}, "mass.missing"),
        ({"mass": 1}, "mass.incomplete"),
        ({"mass": 1, "com": [0, 0]}, "mass.incomplete"),
        ({"mass": 1, "inertia": 5}, "mass.incomplete"),
        ({"mass": 1, "shape": "rod A-B", "com": [0, 0]}, "mass.shape-and-com"),
        ({"mass": 1, "shape": "ball A"}, "file.expected"),
        ({"mass": 1, "shape": "disc at A"}, "file.expected"),
        ({"mass": 1, "shape": "disc 2 + at A"}, "expression.syntax"),
    ],
)
def test_masses(given: dict[str, Any], code: str) -> None:
    links = {"frame": {"points": {"A": [0, 0]}}, "crank": {"points": {"A": [0, 0], "B": [1, 0]}, **given}}
    assert one(links=links).code == code


def test_a_mistyped_key_is_told_with_the_likeliest_one() -> None:
    found = one(windws={})
    assert found.data["near"].likely == ("windows",)
    found = one(links={"frame": {"points": {}, "intertia": 1}})
    assert found.data["near"].likely == ("inertia",)


def test_all_faults_at_once_with_lines() -> None:
    """Also faults of the keys together where a value of the same entry is wrong by itself."""
    text = changed(
        ("linkwright: 1\n", ""),
        ("AB: 155", "AB: [1]"),
        ("points: {A: [0, 0], B: [AB, 0]}, mass: 0.6, shape: rod A-B", "points: {A: [0]}, mass: 0.6"),
        ("mass: 1.5", "mass: 1.5 +"),
        ("joints:", "join:"),
        ("start:", "strat:"),
        ("window: feed", "windw: feed"),
    )
    assert [(f.line, f.element, f.code) for f in findings(text)] == [
        (1, "", "file.version"),
        (4, "parameters.AB", "file.expected"),
        (7, "links.crank", "mass.incomplete"),
        (7, "links.crank.points.A", "file.expected"),
        (8, "links.coupler.mass", "expression.syntax"),
        (12, "join", "file.unknown-key"),
        (17, "drives.motor.strat", "file.unknown-key"),
        (23, "measures.feed_speed_max.windw", "file.unknown-key"),
    ]


def test_many_faults_are_cut_short_with_their_count() -> None:
    text = FEEDER + "require:\n" + "".join(f"  r{i}: 5\n" for i in range(80))
    found = findings(text)
    assert len(found) == 51
    assert (found[-1].code, found[-1].data["count"]) == ("file.more", 30)


def test_what_isn_t_given_may_be_null() -> None:
    """A key with nothing behind it is as good as left out, where it may be left out."""
    assert not faults(gravity=None, links={**four_bar()["links"], "crank": {"points": {"A": [0, 0]}, "mass": None}})


def test_parts_validate_themselves_in_python_too() -> None:
    with pytest.raises(ValidationError, match=r"mass.missing"):
        Link.model_validate({"points": {}, "shape": "rod A-B"})
    with pytest.raises(ValidationError):
        Document.model_validate({})
    link = Link.model_validate({"points": {"A": [0, 0]}})
    assert Link.model_validate(link) is link
