"""Mobility, loops, and the groups in the order in which they are solved."""

from __future__ import annotations

from collections import Counter
from typing import Any

import pytest
from hypothesis import given, settings

from helpers.compiled import compiled_from
from helpers.examples import UNITS, feeder, four_bar, slider_crank
from helpers.plain import Plain, document_of
from helpers.random_mechanisms import DYADS, RECIPES, Seeded, Sketch, mechanisms
from linkwright.groups import REGISTRY
from linkwright.model.document import Document
from linkwright.structure import Driven, Group, Structure, decompose


def structure_of(data: dict[str, Any]) -> Structure:
    return decompose(Document.model_validate(data))


def steps_of(structure: Structure) -> list[tuple[str, ...]]:
    """Each step in short: a drive's name and link, or a group's signature and links."""
    return [
        (step.drive, step.link) if isinstance(step, Driven) else (step.signature, *step.links)
        for step in structure.steps
    ]


def test_four_bar() -> None:
    structure = structure_of(four_bar())
    assert steps_of(structure) == [("motor", "crank"), ("RRR", "coupler", "rocker")]
    assert (structure.topology.gruebler, structure.topology.loops, structure.topology.joint_count) == (1, 1, 4)
    assert structure.findings == ()


def test_slider_crank() -> None:
    assert steps_of(structure_of(slider_crank())) == [("motor", "crank"), ("RRP", "rod", "piston")]


def test_paper_feeder() -> None:
    structure = structure_of(feeder())
    assert steps_of(structure) == [
        ("motor", "crank"),
        ("RRR", "coupler", "rocker"),
        ("RPP", "slider", "guide"),
    ]
    assert (structure.topology.gruebler, structure.topology.loops) == (1, 2)


def test_joints_of_a_group_stand_in_the_order_of_its_signature() -> None:
    group = structure_of(slider_crank()).groups[0]
    assert [c.joint for c in group.joints] == ["B", "bore", "C"]
    assert group.bases == ("crank", "frame")
    assert group.label == "rod-piston"


def test_several_links_on_a_pin_count_once_each() -> None:
    """Jansen's pins B, C, D and F carry three links each, crank pin A three with the frame's aside."""
    data = four_bar()
    data["links"] |= {
        "fourth": {"points": {"C": [0, 0], "E": [2, 0]}},
        "fifth": {"points": {"D": [0, 0], "E": [2, 1]}},
    }
    data["assembly"]["E"] = "left of C-D"
    structure = structure_of(data)
    assert structure.topology.pins["C"].links == ("coupler", "rocker", "fourth")
    assert (structure.topology.joint_count, structure.topology.gruebler, structure.topology.loops) == (7, 1, 2)
    assert steps_of(structure)[-1] == ("RRR", "fourth", "fifth")


def test_a_drive_that_names_its_links_the_other_way_round() -> None:
    data = four_bar()
    data["drives"] = {"motor": {"turns": "frame", "on": "crank", "speed": 1, "start": 0.5}}
    step = structure_of(data).steps[0]
    assert isinstance(step, Driven)
    assert (step.link, step.base, step.sign) == ("crank", "frame", -1)


def test_drives_in_series_are_placed_one_after_the_other() -> None:
    data = {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"A": [0, 0]}},
            "hand": {"points": {"C": [0, 0]}},
            "forearm": {"points": {"B": [0, 0], "C": [1, 0]}},
            "arm": {"points": {"A": [0, 0], "B": [1, 0]}},
        },
        "drives": {
            "wrist": {"turns": "hand", "on": "forearm", "speed": 1, "start": 0},
            "elbow": {"turns": "forearm", "on": "arm", "speed": 1, "start": 0},
            "shoulder": {"turns": "arm", "on": "frame", "speed": 1, "start": 0},
        },
    }
    structure = structure_of(data)
    assert steps_of(structure) == [("shoulder", "arm"), ("elbow", "forearm"), ("wrist", "hand")]
    assert (structure.topology.gruebler, structure.topology.loops) == (3, 0)


@pytest.mark.parametrize("kind", DYADS)
def test_each_dyad_is_found_by_its_signature(kind: str) -> None:
    for seed in range(6):
        sketch = Sketch(Seeded(seed))
        sketch.dyad(kind, sketch.drive("R", "frame"), sketch.drive("P", "frame"))
        structure = structure_of(document_of(sketch.finish()))
        assert [group.signature for group in structure.groups] == [kind]


def test_the_random_recipes_cover_every_registered_dyad() -> None:
    kinds: Counter[str] = Counter()
    for seed in range(40):
        for recipe in RECIPES.values():
            recipe(sketch := Sketch(Seeded(seed)))
            kinds.update(sketch.kinds)
    assert set(kinds) == set(REGISTRY)


@settings(max_examples=40)
@given(mechanisms())
def test_steps_place_every_link_once_on_known_links(plain: Plain) -> None:
    structure = structure_of(document_of(plain))
    known, used = {"frame"}, Counter()
    for step in structure.steps:
        bases = (step.base,) if isinstance(step, Driven) else step.bases
        assert known.issuperset(bases)
        assert known.isdisjoint(step.links)
        known |= set(step.links)
        used.update(c.joint for c in step.joints)
        if isinstance(step, Group):
            letters = (step.outer[0].kind.letter, step.inner.kind.letter, step.outer[1].kind.letter)
            assert "".join(letters) == step.signature
    assert known == set(plain.links)
    assert used == Counter({n: len(m) - 1 for n, m in plain.pins.items()} | dict.fromkeys(plain.slides, 1))
    assert structure.topology.gruebler == len(plain.drives)
    assert structure.topology.loops == structure.topology.joint_count - len(plain.moving)


@settings(max_examples=20)
@given(mechanisms())
def test_the_same_file_gives_the_same_structure(plain: Plain) -> None:
    one, other = (steps_of(compiled_from(document_of(plain)).structure) for _ in range(2))
    assert one == other
