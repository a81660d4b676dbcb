"""Assembly rules: each states one mode, never by chance; what can't be settled is a finding by name."""

from __future__ import annotations

import math
import re
from typing import Any

import numpy as np
import pytest

from helpers.compiled import compiled_from
from helpers.examples import UNITS, four_bar, slider_crank
from linkwright.compilation import examine
from linkwright.findings import Finding
from linkwright.model.document import Document


def at_start(data: dict[str, Any], *names: str) -> list[float]:
    return [float(v) for v in compiled_from(data).evaluate(names, np.zeros(1))[:, 0]]


def findings_of(data: dict[str, Any]) -> list[Finding]:
    compiled, findings = examine(Document.model_validate(data))
    assert compiled is None
    assert all(str(finding) for finding in findings)
    return findings


def only(data: dict[str, Any]) -> Finding:
    findings = findings_of(data)
    assert len(findings) == 1, [f.code for f in findings]
    return findings[0]


def bar(rule: Any, start: float = 0.5, **assembly: Any) -> dict[str, Any]:
    data = four_bar(assembly={"C": rule} | assembly)
    data["drives"]["motor"]["start"] = start
    return data


@pytest.mark.parametrize(
    ("rule", "above"),
    [
        ("left of B-D", True),
        ("right of B-D", False),
        ("left of D-B", False),
        ("right of D-B", True),
        ("open", True),
        ("crossed", False),
        ([2.5, 3], True),
        ([2.5, -3], False),
        (["2500 mm", "3 m"], True),
    ],
)
def test_rules_of_two_pinned_links(rule: Any, above: bool) -> None:
    """Crank at 0.5 rad above the ground line: the open four-bar has C above, the crossed one below."""
    _, y = at_start(bar(rule), "C.x", "C.y")
    assert (y > 0) == above


@pytest.mark.parametrize(("start", "above"), [(0.5, True), (-0.5, False), (2.0, True), (4.0, False)])
def test_open_turns_with_the_crank(start: float, above: bool) -> None:
    """The open four-bar is the one whose coupler and rocker do not cross crank and ground."""
    _, y = at_start(bar("open", start), "C.x", "C.y")
    assert (y > 0) == above
    _, y = at_start(bar("crossed", start), "C.x", "C.y")
    assert (y < 0) == above


def test_a_rule_may_name_the_points_of_a_joint_of_two_names() -> None:
    data = bar("left of B-D")
    data["links"]["rocker"]["points"] = {"D": [0, 0], "C2": [3, 0]}
    data["joints"] = {"knee": {"revolute": ["coupler", "rocker"], "at": ["C", "C2"]}}
    for name in ("C", "C2", "knee"):
        data["assembly"] = {name: "left of B-D"}
        assert at_start(data, "C.y", "C2.y") == pytest.approx(at_start(bar("left of B-D"), "C.y") * 2)


@pytest.mark.parametrize(("rule", "ahead"), [("ahead of B along bore", True), ("behind B along bore", False)])
@pytest.mark.parametrize("heading", [0.0, 0.7, 3.0])
def test_ahead_and_behind_on_an_outer_slide(rule: str, ahead: bool, heading: float) -> None:
    data = slider_crank(assembly={"C": rule})
    data["joints"]["bore"]["line"] = [f"F at {heading}", f"C at {heading}"]
    cx, cy, bx, by = at_start(data, "C.x", "C.y", "B.x", "B.y")
    along = (cx - bx) * math.cos(heading) + (cy - by) * math.sin(heading)
    assert (along > 0) == ahead
    assert math.hypot(cx - bx, cy - by) == pytest.approx(3.0)
    sketched = slider_crank(assembly={"C": [cx * 1.1, cy * 1.1]}, joints=data["joints"])
    assert at_start(sketched, "C.x", "C.y") == pytest.approx([cx, cy], abs=1e-14)


def slotted_lever(rule: Any, at: str = "B", heading: float = 0.0) -> dict[str, Any]:
    """A crank pin's block slides on a lever about D."""
    return {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [3, 0]}},
            "crank": {"points": {"A": [0, 0], "B": [1, 0]}},
            "block": {"points": {"B": [0, 0], "K": [0.3, 0.1]}},
            "lever": {"points": {"D": [0, 0]}},
        },
        "joints": {"slot": {"prismatic": ["lever", "block"], "line": [f"D at {heading}", f"B at {heading}"]}},
        "assembly": {at: rule},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": 1, "start": 0.5}},
    }


@pytest.mark.parametrize(
    ("at", "rule", "travel"),
    [
        ("B", "ahead of D along slot", 1),
        ("B", "behind D along slot", -1),
        ("D", "ahead of B along slot", -1),
        ("D", "behind B along slot", 1),
    ],
)
def test_ahead_and_behind_on_an_inner_slide(at: str, rule: str, travel: int) -> None:
    """The slide's travel is from the lever's point D to the block's point B."""
    for heading in (0.0, 1.2):
        (s,) = at_start(slotted_lever(rule, at, heading), "slot.s")
        assert math.copysign(1, s) == travel
        assert abs(s) == pytest.approx(math.dist((3, 0), (math.cos(0.5), math.sin(0.5))))


def test_an_inner_slide_by_a_sketched_point() -> None:
    for rule in ("ahead of D along slot", "behind D along slot"):
        kx, ky, s = at_start(slotted_lever(rule), "K.x", "K.y", "slot.s")
        assert at_start(slotted_lever([kx + 0.05, ky - 0.05], "K"), "slot.s") == pytest.approx([s])


def test_groups_of_one_mode_want_no_rule() -> None:
    data = slider_crank(assembly={})
    data["links"]["piston"]["points"] = {"P": [0, 0]}
    del data["links"]["rod"]
    data["links"]["block"] = {"points": {"B": [0, 0]}}
    data["joints"]["slot"] = {"prismatic": ["block", "piston"], "line": ["B at pi/2", "P at pi/2"]}
    data["joints"]["bore"]["line"] = ["F at 0", "P at 0"]
    assert at_start(data, "P.x") == pytest.approx([math.cos(0.5)])


# What can't be settled.


def test_a_mode_that_is_not_stated_is_asked_for_with_the_ways_to_state_it() -> None:
    finding = only(four_bar(assembly={}))
    assert finding.code == "assembly.missing"
    assert str(finding.data["links"]) == "coupler, rocker"
    assert "C: left of B-D" in finding.data["options"]
    assert "C: right of B-D" in finding.data["options"]


def test_rules_that_contradict_each_other() -> None:
    data = bar("left of B-D")
    data["links"]["coupler"]["points"]["P"] = [1.5, 0]
    data["assembly"]["P"] = [2, -1]
    finding = only(data)
    assert finding.code == "assembly.contradiction"
    assert finding.element.startswith("assembly.")


def test_rules_that_agree_are_welcome() -> None:
    data = bar("left of B-D")
    data["links"]["coupler"]["points"]["P"] = [1.5, 0]
    data["assembly"]["P"] = [2, 1]
    assert at_start(data, "C.y")[0] > 0


def test_a_rule_that_no_group_uses() -> None:
    finding = only(bar("left of B-D", A="left of B-D"))
    assert (finding.code, finding.element) == ("assembly.unused", "assembly.A")


def test_open_speaks_of_a_four_bar_only() -> None:
    """A dyad between coupler and frame, which no pin joins to each other, closes no four-bar."""
    data = bar("left of B-D")
    data["links"]["frame"]["points"]["F"] = [4, 3]
    data["links"]["coupler"]["points"]["P"] = [1.5, 1]
    data["links"]["rod"] = {"points": {"P": [0, 0], "Q": [2, 0]}}
    data["links"]["arm"] = {"points": {"F": [0, 0], "Q": [2, 0]}}
    data["assembly"]["Q"] = "open"
    finding = only(data)
    assert (finding.code, finding.element) == ("assembly.not-four-bar", "assembly.Q")
    assert {"Q", "P", "F"} <= set(re.findall(r"\w+", finding.data["options"]))


def test_a_rule_between_the_wrong_pins() -> None:
    codes = {f.code: f for f in findings_of(bar("left of A-D"))}
    assert codes["assembly.wrong-pins"].element == "assembly.C"
    assert "B-D" in codes["assembly.wrong-pins"].data["options"]


def test_open_is_ambiguous_where_the_crank_lies_on_the_ground_line() -> None:
    assert only(bar("open", 0.0)).code == "assembly.ambiguous"


def test_a_sketched_point_as_near_to_one_mode_as_to_the_other() -> None:
    assert only(bar([2.5, 0], 0.0)).code == "assembly.ambiguous"


@pytest.mark.parametrize(
    ("data", "by", "way"),
    [
        (four_bar(1, 1, 1, 4), math.dist((math.cos(0.5), math.sin(0.5)), (4, 0)) - 2, "wide"),
        (four_bar(1, 9, 3, 4), 6 - math.dist((math.cos(0.5), math.sin(0.5)), (4, 0)), "narrow"),
        (slider_crank(1, 1.5, 4), 4 - math.sin(0.5) - 1.5, "wide"),
    ],
)
def test_a_group_that_cannot_close_says_by_how_much(data: dict[str, Any], by: float, way: str) -> None:
    finding = only(data)
    assert finding.code == "assembly.cannot-close"
    assert float(finding.data["by"]) == pytest.approx(by, rel=1e-3)
    assert (finding.data["short"].key, finding.data["unit"]) == (f"term.gap-{way}", "m")


def trammel(heading: float) -> dict[str, Any]:
    """Two links on lines of crank and frame, pinned to each other (PRP)."""
    return {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [4, 0]}},
            "crank": {"points": {"A": [0, 0], "B": [1, 0]}},
            "one": {"points": {"E": [0, 0.3], "C": [1, 0]}},
            "two": {"points": {"G": [0, 0], "C": [1, 2]}},
        },
        "joints": {
            "s": {"prismatic": ["crank", "one"], "line": ["B at 0", "E at 0"]},
            "q": {"prismatic": ["frame", "two"], "line": [f"D at {heading}", "G at 0"]},
        },
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": 1, "start": 0}},
    }


def yoke(heading: float) -> dict[str, Any]:
    """A block in a slot that is parallel to its bed (RPP)."""
    data = slider_crank(assembly={})
    data["links"]["piston"]["points"] = {"P": [0, 0]}
    del data["links"]["rod"]
    data["links"]["block"] = {"points": {"B": [0, 0]}}
    data["joints"]["slot"] = {"prismatic": ["block", "piston"], "line": [f"B at {heading}", f"P at {heading}"]}
    data["joints"]["bore"]["line"] = ["F at 0", "P at 0"]
    return data


DEGENERATE = {
    "outer pins of two pinned links coincide": four_bar(
        4, 3, 3, 4, drives={"motor": {"turns": "crank", "on": "frame", "speed": 1, "start": 0}}
    ),
    "outer pins of a lever and its block coincide": slotted_lever("ahead of D along slot")
    | {"links": slotted_lever("")["links"] | {"frame": {"points": {"A": [0, 0], "D": [math.cos(0.5), math.sin(0.5)]}}}},
    "parallel lines of two pinned sliders": trammel(0.0),
    "a slot parallel to its bed": yoke(0.0),
}


@pytest.mark.parametrize("case", DEGENERATE)
def test_a_start_in_which_a_group_has_no_place_of_its_own(case: str) -> None:
    """Nothing is divided by zero: the finding names the group's links."""
    finding = only(DEGENERATE[case])
    assert finding.code in ("assembly.degenerate", "assembly.cannot-close")
    assert finding.path[0] == "links"


@pytest.mark.parametrize(("data", "angle"), [(trammel(0.5), 0.0), (yoke(1.0), 0.0)])
def test_the_same_away_from_it(data: dict[str, Any], angle: float) -> None:
    assert at_start(data, "crank.angle") == pytest.approx([data["drives"]["motor"]["start"] + angle])
