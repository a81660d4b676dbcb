"""What can't be solved is refused, with the code and the element that is at fault."""

from __future__ import annotations

import copy
from typing import Any

import pytest

from helpers.examples import UNITS, four_bar, slider_crank
from linkwright.compilation import examine
from linkwright.findings import Finding, Term
from linkwright.model.document import Document
from linkwright.structure import Group, decompose


def findings_of(data: dict[str, Any]) -> tuple[Finding, ...]:
    findings = decompose(Document.model_validate(data)).findings
    assert all(str(finding) for finding in findings), "each can be said in words"
    return findings


def only(data: dict[str, Any]) -> Finding:
    findings = findings_of(data)
    assert len(findings) == 1, [f.code for f in findings]
    return findings[0]


def triad() -> dict[str, Any]:
    """A plate on three rods, each on a driven crank: a group of four links (class III)."""
    links: dict[str, Any] = {"frame": {"points": {"O1": [0, 0], "O2": [4, 0], "O3": [2, 4]}}}
    drives = {}
    for i in (1, 2, 3):
        links[f"crank{i}"] = {"points": {f"O{i}": [0, 0], f"A{i}": [0.5, 0]}}
        links[f"rod{i}"] = {"points": {f"A{i}": [0, 0], f"B{i}": [1.5, 0]}}
        drives[f"m{i}"] = {"turns": f"crank{i}", "on": "frame", "speed": 1, "start": 0}
    links["plate"] = {"points": {"B1": [0, 0], "B2": [1, 0], "B3": [0.5, 1]}}
    return {"linkwright": 1, "units": UNITS, "links": links, "drives": drives}


def cylinder() -> dict[str, Any]:
    """A boom lifted by a cylinder: the drive sits between two links that are both unknown."""
    return {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"O": [0, 0], "K": [1, -1]}},
            "boom": {"points": {"O": [0, 0], "M": [2, 0]}},
            "barrel": {"points": {"K": [0, 0]}},
            "rod": {"points": {"M": [0, 0]}},
        },
        "joints": {"tube": {"prismatic": ["barrel", "rod"], "line": ["K at 0", "M at 0"]}},
        "drives": {"lift": {"slides": "rod", "on": "barrel", "speed": 0.1, "start": 1.5}},
    }


def test_a_link_that_hangs_on_nothing() -> None:
    data = four_bar()
    data["links"]["stray"] = {"points": {"Z": [0, 0]}}
    finding = only(data)
    assert (finding.code, finding.element) == ("structure.loose", "links.stray")
    assert finding.data["freedom"] == 3


def test_a_link_that_swings_freely_is_offered_a_drive() -> None:
    data = four_bar()
    data["links"]["flag"] = {"points": {"C": [0, 0], "Z": [1, 0]}}
    finding = only(data)
    assert (finding.code, finding.element) == ("structure.loose", "links.flag")
    assert finding.data["freedom"] == 1
    assert "turns: flag" in finding.data["hint"]


def test_two_loose_parts_are_two_findings() -> None:
    data = four_bar()
    data["links"]["flag"] = {"points": {"C": [0, 0]}}
    data["links"]["bob"] = {"points": {"B": [0, 0]}}
    assert {f.element for f in findings_of(data)} == {"links.flag", "links.bob"}
    assert {f.code for f in findings_of(data)} == {"structure.loose"}


def test_too_few_drives() -> None:
    """A five-bar with one drive: its other crank is loose."""
    data = four_bar()
    data["links"]["frame"]["points"]["E"] = [5, 1]
    data["links"]["rocker"] = {"points": {"D": [0, 0], "C": [2, 0]}}
    data["links"]["crank2"] = {"points": {"E": [0, 0], "D": [1, 0]}}
    del data["links"]["frame"]["points"]["D"]
    finding = only(data)
    assert (finding.code, finding.data["freedom"]) == ("structure.loose", 1)
    assert set(str(finding.data["links"]).split(", ")) == {"coupler", "rocker", "crank2"}


def test_a_drive_too_many_leaves_a_link_with_no_freedom() -> None:
    data = four_bar()
    data["drives"]["second"] = {"turns": "rocker", "on": "frame", "speed": 1, "start": 0}
    findings = findings_of(data)
    assert findings
    assert all(f.code in ("structure.overconstrained", "structure.drive-too-many") for f in findings)


def test_a_drive_between_known_links_is_too_many() -> None:
    """Crank and slide both driven against the frame, and then against each other."""
    data = slider_crank()
    data["links"]["wheel"] = {"points": {"A": [0, 0]}}
    data["drives"]["first"] = {"turns": "wheel", "on": "frame", "speed": 2, "start": 0}
    data["drives"]["second"] = {"turns": "wheel", "on": "crank", "speed": 2, "start": 0}
    finding = only(data)
    assert (finding.code, finding.element) == ("structure.drive-too-many", "drives.second")


def test_two_drives_on_one_joint() -> None:
    from linkwright.compilation import examine

    data = four_bar()
    data["drives"]["second"] = {"turns": "frame", "on": "crank", "speed": 1, "start": 0}
    compiled, findings = examine(Document.model_validate(data))
    assert compiled is None
    assert [(f.code, f.element) for f in findings] == [("drive.twice", "drives.second")]


@pytest.mark.parametrize(
    ("drive", "joint"),
    [
        ({"slides": "crank", "on": "frame"}, "prismatic"),
        ({"slides": "coupler", "on": "frame"}, "prismatic"),
    ],
)
def test_a_drive_between_links_without_such_a_joint(drive: dict[str, str], joint: str) -> None:
    data = four_bar(drives={"motor": drive | {"speed": 1, "start": 0}})
    finding = only(data)
    assert (finding.code, finding.element) == ("structure.drive-no-joint", "drives.motor")
    assert str(finding.data["joint"]) == str(Term(f"kind-{joint}"))


def test_a_drive_that_could_act_at_two_joints() -> None:
    data = four_bar()
    data["links"]["crank"]["points"]["D"] = [4, 0]
    finding = only(data)
    assert (finding.code, finding.element) == ("structure.drive-two-joints", "drives.motor")
    assert str(finding.data["joints"]) == "A, D"


COUPLER_DRIVE = {"motor": {"turns": "coupler", "on": "crank", "speed": 1, "start": 0}}


def test_a_group_beyond_dyads_is_taken_whole() -> None:
    """The links that can only be placed together form one step; see tests/graph/test_higher_groups.py."""
    structure = decompose(Document.model_validate(triad()))
    assert not structure.findings
    assert len(structure.higher_groups) == 1


@pytest.mark.parametrize(
    ("make", "sides"),
    [
        (cylinder, {("barrel", "rod"), ("boom",)}),
        (lambda: four_bar(drives=COUPLER_DRIVE), {("crank", "coupler"), ("rocker",)}),
    ],
)
def test_links_that_a_drive_holds_on_each_other_are_one_side_of_a_dyad(make: Any, sides: set[tuple[str, ...]]) -> None:
    """A drive between two unknown links leaves a closed form, with the links of a side in the order of its chain."""
    structure = decompose(Document.model_validate(make()))
    assert not structure.findings
    (group,) = structure.steps
    assert isinstance(group, Group)
    assert group.signature == "RRR"
    assert set(group.sides) == sides


def test_a_third_parallel_crank_is_one_joint_too_many() -> None:
    """It moves in fact, as the cranks are parallel; no dimensions may be counted on to be exact."""
    data = four_bar(1, 4, 1, 4)
    data["links"]["frame"]["points"]["M"] = [2, 0]
    data["links"]["coupler"]["points"]["N"] = [2, 0]
    data["links"]["third"] = {"points": {"M": [0, 0], "N": [1, 0]}}
    finding = only(data)
    assert (finding.code, finding.element) == ("structure.overconstrained", "links.third")
    assert finding.data["excess"] == 1


@pytest.mark.parametrize("second", ["joint", "pin"])
def test_two_joints_between_the_same_links(second: str) -> None:
    data = slider_crank()
    if second == "joint":
        data["joints"]["bore2"] = copy.deepcopy(data["joints"]["bore"])
    else:
        data["links"]["frame"]["points"]["Q"] = [1, 0]
        data["links"]["piston"]["points"]["Q"] = [0, 0]
    finding = only(data)
    assert finding.code == "structure.overconstrained"
    assert finding.data["excess"] == 1
    assert str(finding.data["links"]) == "piston"


@pytest.mark.parametrize("base", ["frame", "crank"])
def test_a_link_pinned_to_two_known_places(base: str) -> None:
    data = four_bar()
    data["links"]["frame"]["points"]["U"] = [0, 1]
    data["links"][base]["points"]["V"] = [1, 1]
    data["links"]["bar"] = {"points": {"U": [0, 0], "V": [1, 0]}}
    finding = only(data)
    assert (finding.code, finding.element) == ("structure.overconstrained", "links.bar")


def test_a_joint_between_links_that_others_have_placed() -> None:
    data = four_bar()
    data["links"]["coupler"]["points"]["X"] = [3, 1]
    data["links"]["rocker"]["points"]["X"] = [3, 1]
    finding = only(data)
    assert (finding.code, finding.element) == ("structure.redundant", "joints.X")
    assert set(str(finding.data["links"]).split(", ")) == {"coupler", "rocker"}


def test_three_slides_in_a_loop_move() -> None:
    """Three translating links have a mobility that the plain count does not see; see tests/graph/test_wedges.py."""
    data = {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"O": [0, 0]}},
            "wedge": {"points": {"P": [0, 0]}},
            "lifter": {"points": {"Q": [0, 0]}},
        },
        "joints": {
            "bed": {"prismatic": ["frame", "wedge"], "line": ["O at 0", "P at 0"]},
            "face": {"prismatic": ["wedge", "lifter"], "line": ["P at 1", "Q at 1"]},
            "column": {"prismatic": ["frame", "lifter"], "line": ["O at 1.5", "Q at 1.5"]},
        },
        "drives": {"push": {"slides": "wedge", "on": "frame", "speed": 1, "start": 0}},
    }
    assert not findings_of(data)
    del data["joints"]["column"]
    assert only(data).code == "structure.loose"


def test_slides_that_can_only_be_placed_all_at_once_are_named() -> None:
    """Three links on one known link each, and a slide between any two: none of them has two slides on known links."""
    names = ("a", "b", "c", "d")
    links = {name: {"points": {name.upper(): [0, 0]}} for name in names}
    pairs = ["frame a", "frame b", "frame c", "a d", "b c", "c d", "b d"]
    joints = {}
    for i, pair in enumerate(pairs):
        ends = pair.split()
        line = [f"{'O' if end == 'frame' else end.upper()} at {i / 4}" for end in ends]
        joints["_".join(ends)] = {"prismatic": ends, "line": line}
    data = {
        "linkwright": 1,
        "units": UNITS,
        "links": {"frame": {"points": {"O": [0, 0]}}, **links},
        "joints": joints,
        "drives": {"push": {"slides": "a", "on": "frame", "speed": 1, "start": 0}},
    }
    finding = only(data)
    assert finding.code == "structure.loop-of-slides"
    assert set(str(finding.data["links"]).split(", ")) == {"b", "c", "d"}


def test_a_loose_end_on_an_overconstrained_link_is_not_a_higher_group() -> None:
    """Freedoms of one link do not make up for those missing in another."""
    data = four_bar()
    data["links"]["frame"]["points"] |= {"U": [0, 1], "V": [1, 1]}
    data["links"]["bar"] = {"points": {"U": [0, 0], "V": [1, 0], "W": [2, 0]}}
    data["links"]["flag"] = {"points": {"W": [0, 0]}}
    codes = {f.code for f in findings_of(data)}
    assert "structure.higher-group" not in codes


def test_one_drive_too_many_is_named() -> None:
    """A four-bar with a motor on crank and rocker: the drive is at fault, not the coupler between them."""
    second = {"turns": "rocker", "on": "frame", "speed": 1, "start": 0}
    finding = only(four_bar(drives={**four_bar()["drives"], "second": second}))
    assert (finding.code, finding.element) == ("structure.drive-too-many", "drives.second")


def test_a_structure_without_drives_is_refused_for_its_mobility() -> None:
    """Two links on a slide and two pins: 3 * 2 - 2 * 3 = 0. A four-bar without drives lacks a drive."""
    data = slider_crank(drives={}, assembly={})
    del data["links"]["rod"]
    data["links"]["crank"]["points"] = {"A": [0, 0], "C": [3, 0]}
    (finding,) = examine(Document.model_validate(data))[1]
    assert (finding.code, finding.data["mobility"]) == ("model.no-freedom", 0)
    assert [f.code for f in examine(Document.model_validate(four_bar(drives={})))[1]] == ["model.no-drive"]
