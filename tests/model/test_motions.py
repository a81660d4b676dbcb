"""Motion laws in model files: what is wrong with them, units, parameters, round trip."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from linkwright import Builder
from linkwright.compilation import examine
from linkwright.findings import Finding
from linkwright.kernels import Compiled
from linkwright.model.document import Document, dump, read_document
from linkwright.model.schema import json_schema
from model.given import codes, four_bar

CYCLOID = {"rise": 12, "over": 90, "law": "cycloidal"}
REST = {"dwell": 270}
BACK = [{"dwell": 180}, {"fall": 12, "over": 90, "law": "cycloidal"}]
ANGLES = {"over": "angle", "of": "angle"}
TIMES = {"over": "time", "of": "angle"}


def document(*segments: Any, position: str = "law(15 deg*t/(1 s))", more: Any = None, **law: Any) -> Document:
    drives = {"motor": {"turns": "crank", "on": "frame", "position": position}}
    laws = {"law": {**ANGLES, "segments": list(segments), **law}}
    return Document.model_validate(four_bar(laws=laws, drives=drives, **(more or {})))


def examined(*segments: Any, **law: Any) -> tuple[Compiled | None, list[Finding]]:
    return examine(document(*segments, **law))


def found(*segments: Any, **law: Any) -> list[tuple[str, tuple[str | int, ...]]]:
    findings = examined(*segments, **law)[1]
    assert all(finding.what and finding.mend for finding in findings)
    return [(finding.code, finding.path) for finding in findings]


def text(laws: str, position: str = "0 deg", parameters: str = "{}") -> str:
    return f"""linkwright: 1
units: {{length: mm, angle: deg, time: s}}
parameters: {parameters}
links: {{frame: {{points: {{A: [0, 0]}}}}, arm: {{points: {{A: [0, 0], B: [90, 0]}}}}}}
laws:
  {laws}
drives: {{m: {{turns: arm, on: frame, position: "{position}"}}}}
"""


@pytest.mark.parametrize(
    ("segment", "wanted"),
    [
        ("{rise: 12, over: 90, law: cycloid}", ["law.unknown"]),
        ("{rise: 12, over: 90, law: cycloidal, powers: [3]}", ["law.way"]),
        ("{rise: 12, over: 90}", ["law.way"]),
        ("{fall: 12, over: 90, match: jerk}", ["law.keys", "law.way"]),
        ("{dwell: 20, fall: 2}", ["law.segment"]),
        ("{over: 20}", ["law.segment"]),
        ("{dwell: 20, law: cycloidal}", ["law.keys"]),
        ("{rise: 3, law: poly_345, degree: 3}", ["law.keys", "law.no-over"]),
        ("{rise: 3, over: 20, powers: [3, 4], skew: 0.3}", ["law.keys"]),
        ("{rise: 3, over: 20, powers: []}", ["file.expected"]),
        ("{rise: 3, over: 20, powers: [0]}", ["file.expected"]),
        ("{rise: 3, over: 20, fractions: 1}", ["file.expected"]),
        ("{rise: 3, over: 20, via: 1}", ["file.expected"]),
        ("{rise: 3, over: 20, lawn: cycloidal}", ["file.unknown-key"]),
    ],
)
def test_wrong_keys(segment: str, wanted: list[str]) -> None:
    law = f"a: {{over: angle, of: angle, segments: [{segment}]}}"
    assert sorted(codes(text(law))) == wanted


def test_all_at_once_each_at_its_line() -> None:
    raw = text("a: {over: angle, of: angle, segments: [{rise: 1, over: 9, law: x}]}\n  b: {over: angle, segments: []}")
    _, source = read_document(raw.encode())
    assert [(f.code, f.line) for f in source.findings] == [
        ("law.unknown", 6), ("file.missing", 7), ("file.expected", 7),
    ]  # fmt: skip
    near = codes(text("a: {over: angle, of: angle, segmnts: [{dwell: 1}]}"))
    assert near == ["file.unknown-key"]


SEGMENT = ("laws", "law", "segments", 0)


@pytest.mark.parametrize(
    ("segments", "more", "wanted"),
    [
        ([CYCLOID, {"dwell": 260}, *BACK[1:]], {}, [("law.period", SEGMENT[:2])]),
        ([CYCLOID, REST], {}, [("law.not-closed", SEGMENT[:2])]),
        ([{**CYCLOID, "over": 0}, REST], {}, [("law.over", SEGMENT)]),
        ([{"rise": 1, "over": 90, "match": "velocity"}, {"rise": -1, "over": 270, "match": "velocity"}], {},
         [("law.open-end", (*SEGMENT[:3], i)) for i in (0, 0, 1, 1)]),
        ([{**CYCLOID, "law": "eighth_degree"}, *BACK], {}, [("law.end-acceleration", SEGMENT)]),
        ([{**CYCLOID, "skew": 1}, *BACK], {}, [("law.skew", SEGMENT)]),
        ([{"rise": 12, "over": 90, "fractions": [0.5, 0.5, 0.5, 0]}, *BACK], {}, [("law.fractions", SEGMENT)]),
        ([{"rise": 12, "over": 90, "fractions": [1e-300, 0.5, 0.5, 0]}, *BACK], {}, [("law.fractions", SEGMENT)]),
        ([{"rise": 12, "over": 90, "fractions": [0, 0, 0, 1]}, *BACK], {}, [("law.fractions", SEGMENT)]),
        ([{"rise": 12, "over": 90, "powers": [3, 3, 4]}, *BACK], {}, [("law.powers", SEGMENT)]),
        ([{"rise": 0, "over": 360, "via": [[20, 3], [10, 2]]}], {}, [("law.via", SEGMENT)]),
        ([{"rise": 0, "over": 360, "via": [[k, 1] for k in range(1, 20)]}], {}, [("law.conditions", SEGMENT)]),
        ([{"rise": 0, "over": 360, "via": [[9, 1]], "spline": "quintic"}], {}, [("law.end-rates", SEGMENT)]),
        ([{"control": [0, 1, 0], "over": 360}], {}, [("law.control", SEGMENT)]),
        ([{"rise": 12, "over": 90, "formula": "u + 1"}, *BACK], {}, [("law.not-normal", SEGMENT)]),
        ([{"rise": 12, "over": 90, "formula": "sqrt(u)"}, *BACK], {}, [("law.not-smooth", SEGMENT)]),
        ([{"rise": 12, "over": 90, "formula": "u + t/(1 s)"}, *BACK], {}, [("law.formula", (*SEGMENT, "formula"))]),
        ([{"rise": 12, "over": 90, "formula": "u^2*(3 - 2*u)"}, *BACK], {"more": {"parameters": {"u": 3}}},
         [("law.argument-taken", SEGMENT)]),
        ([{**CYCLOID, "law": "constant_velocity"}, *BACK], {}, [("drive.law-jumps", ("drives", "motor", "position"))]),
        ([CYCLOID, *BACK], {"position": "law(t)"}, [("expression.units-conflict", ("drives", "motor", "position"))]),
        ([CYCLOID, *BACK], {"more": {"parameters": {"law": 3}}}, [("name.taken", ("laws", "law"))]),
        ([{**CYCLOID, "rise": "12 mm"}, *BACK], {}, [("expression.units-conflict", (*SEGMENT, "rise"))]),
        ([{**CYCLOID, "rise": "1/0"}, *BACK], {}, [("value.not-finite", (*SEGMENT, "rise"))]),
        ([CYCLOID, *BACK], {"more": {"measures": {"m": {"max": "law(crank.angle)"}}}},
         [("law.place", ("measures", "m", "max"))]),
    ],
)  # fmt: skip
def test_wrong_laws(segments: list[Any], more: dict[str, Any], wanted: list[Any]) -> None:
    assert found(*segments, **more) == wanted


def test_units_parameters_and_rates() -> None:
    """Bare numbers in the file's units; rates by the axis; expressions of parameters; u a pure number."""
    compiled, findings = examined(
        {"rise": "h", "over": 90, "to": ["2*h/(90 deg)"], "from": [0]},
        {"rise": "2*h", "over": 90, "law": "constant_velocity"},
        {"rise": "-3*h", "over": "pi", "match": "acceleration"},
        more={"parameters": {"h": "10 deg"}},
    )
    assert not findings
    assert compiled is not None
    motion = compiled.motions["law"]
    assert motion.at(np.radians([90, 135, 180])) == pytest.approx(np.radians([10, 20, 30]))
    assert motion.at(np.radians([90, 180]), 1) == pytest.approx([2 / 9, 2 / 9])
    assert motion.continuity == 1
    timed, findings = examined(
        {"rise": "20", "over": 2, "from": ["5 deg/s", 3]}, {"rise": -20, "over": "4 s", "match": "velocity", "to": [5]},
        **TIMES, position="law(t)",
    )  # fmt: skip
    assert not findings
    assert timed is not None
    assert timed.motions["law"].at([0, 0], 1) == pytest.approx(np.radians([5, 5]))
    assert timed.motions["law"].at(0.0, 2) == pytest.approx(math.radians(3))
    mixed, findings = examined(
        {"rise": 30, "over": 180, "formula": "a*u^2 - 2*u^3 + 2*u^k*0 + 0*sin(360 deg*u)"},
        {"rise": -30, "over": 180, "law": "poly_23"}, more={"parameters": {"a": 3, "k": 4}},
    )  # fmt: skip
    assert not findings
    assert mixed is not None
    assert mixed.motions["law"].at(math.pi / 3, 2) == pytest.approx(math.radians(30) / math.pi**2 * (6 - 12 / 3))


def test_every_kind_of_segment_comes_back_and_fits_the_schema() -> None:
    jsonschema = pytest.importorskip("jsonschema")
    given = document(
        {"rise": "5 deg", "over": 40, "law": "modified_sine", "skew": 0.4},
        {"fall": 5, "over": 40, "fractions": [0.1, 0.1, 0.1, 0.2, 0.2, 0.1, 0.2]},
        {"rise": 3, "over": 40, "powers": [3, 4, 5]}, {"rise": 1, "over": 40, "formula": "u"},
        {"rise": 3, "over": 40, "match": "jerk", "from": ["1/2"], "via": [[20, "2 deg"]]},
        {"rise": -7, "over": 40, "via": [[10, 1], [20, 0]], "spline": "cubic", "match": "velocity"},
        {"control": [0, 0, 0, 2, 3, 3], "over": 40, "degree": 3}, {"harmonics": [[1, 0], ["2 deg", 0]], "over": 40},
        {"dwell": 40}, start="2 deg", period="360 deg", beyond="advance",
    )  # fmt: skip
    again, source = read_document(dump(given).encode())
    assert not source.findings
    assert again == given
    jsonschema.Draft202012Validator(json_schema()).validate(source.data)


def test_the_builder() -> None:
    built = Builder("one")
    built.link("frame", {"A": [0, 0]}).link("arm", {"A": [0, 0], "B": [1, 0]})
    built.law("law", [CYCLOID, *BACK], over="angle", of="angle", start="5 deg")
    built.drive("m", turns="arm", position="law(2 rad/s*t)")
    compiled, findings = examine(built.build())
    assert not findings
    assert compiled is not None
    assert compiled.laws["m"](np.array([math.pi / 2])).d[0] == pytest.approx(math.radians(17))
