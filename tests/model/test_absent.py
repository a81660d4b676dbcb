"""Elements that there aren't are refused by their names, once each, with what can be written instead."""

from __future__ import annotations

import re
from typing import Any

import pytest
from ruamel.yaml import YAML

import linkwright as lw
from helpers.examples import slider_crank
from linkwright.findings import ModelError
from linkwright.model.absent import CODES
from linkwright.model.document import parse_document
from linkwright.model.mechanism import Mechanism
from linkwright.words import catalogue


def refused(**sections: Any) -> list[tuple[str, str]]:
    with pytest.raises(ModelError) as caught:
        parse_document(slider_crank(**sections))
    return [(finding.code, finding.element) for finding in caught.value.findings]


@pytest.mark.parametrize("word", sorted(CODES.keys() - Mechanism.model_fields.keys()))
def test_every_word_as_a_section(word: str) -> None:
    if CODES[word] == "element.limits":  # a study is called so
        assert refused(**{word: {}}) == [("file.unknown-key", word)]
    else:
        assert refused(**{word: {}}) == [(CODES[word], word)]


@pytest.mark.parametrize(
    "joint",
    [
        {"gear": ["crank", "rod"], "ratio": 2},
        {"type": "Gear", "links": ["crank", "rod"]},
        {"kind": "gear-pair"},
        "gear",
    ],
)
def test_as_a_kind_of_joint_told_once(joint: Any) -> None:
    """The kind that is missing isn't told besides, nor the keys that belong to it."""
    ((code, element),) = refused(joints={"g": joint})
    assert (code, element.split(".")[:2]) == ("element.gear", ["joints", "g"])


def test_beside_what_is_right_and_what_else_is_wrong() -> None:
    bore = {"prismatic": ["frame", "piston"], "line": ["F at 0", "C at 0"], "friction": 0.1, "travel": [1]}
    found = refused(joints={"bore": bore}, colour=3)
    assert sorted(found) == [
        ("element.friction", "joints.bore.friction"),
        ("file.expected", "joints.bore.travel"),
        ("file.unknown-key", "colour"),
    ]


def test_near_misses_stay_near_misses() -> None:
    with pytest.raises(ModelError) as caught:
        parse_document(slider_crank(sprins={}, joint={}))
    assert {f.data["near"].likely for f in caught.value.findings} == {("springs",), ("joints",)}


@pytest.mark.parametrize(
    ("joint", "key", "likely"),
    [
        ({"geneva": ["crank", "rod"], "centres": ["A", "B"], "pin": ["B"], "slots": 4, "arc": 20}, "pin", "pins"),
        ({"pin": ["crank", "rod"]}, "pin", None),  # it is a key of another kind: not itself
    ],
)
def test_keys_of_kinds(joint: dict[str, Any], key: str, likely: str | None) -> None:
    """The plural of a key of a kind that is clear is meant, and no key is said to mean itself."""
    with pytest.raises(ModelError) as caught:
        parse_document(slider_crank(joints={"g": joint}))
    (near,) = (f.data["near"] for f in caught.value.findings if f.element == f"joints.g.{key}")
    assert key not in near.likely
    assert likely is None or near.likely == (likely,)


def test_the_friction_that_is_proposed_works() -> None:
    """A load of 100 N along the bore: the drive gives what friction takes."""
    mend = re.search(r"'(friction: .*)'; ", catalogue()["element.friction.mend"].format())
    assert mend is not None
    friction = YAML(typ="safe").load(mend[1].replace("guide", "bore"))
    assert friction["friction"].pop("seat")["contact"] == "valve"  # here is no cam
    push = {"on": "piston", "at": "C", "along": "bore", "force": "100 N"}
    powers = {"given": {"mean": "motor.power"}, "lost": {"mean": "bearing_A.power + rail.power"}}
    data = slider_crank(loads={"push": push}, measures=powers) | friction
    data["studies"] = {"cycle": {"turns": "1 motor", "samples": 400}}
    job = lw.run(lw.Document.model_validate(data))
    assert job.cycle is not None
    given, lost = (measure.shown() for measure in job.cycle.measures)
    assert given == pytest.approx(-lost, rel=1e-9)
    assert given > 0
