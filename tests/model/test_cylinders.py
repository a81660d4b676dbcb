"""Cylinders in one line: the same mechanism as barrel, rod and slide written out; what is refused."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import linkwright as lw
from helpers.compiled import compiled_from
from linkwright.compilation import examine
from linkwright.model.builder import Builder
from linkwright.model.desugar import spell_out
from linkwright.model.document import Document, dump, load, save
from linkwright.report.structure_summary import facts
from linkwright.results import Run, certify
from linkwright.structure import Group
from linkwright.words import say
from model.given import DATA, changed, findings

LOADER = (DATA / "loader.yaml").read_text(encoding="utf-8")
T = np.linspace(0.0, 2.0, 9)


def boom(**sections: Any) -> dict[str, Any]:
    """A boom on a cylinder, without masses."""
    return {
        "linkwright": 1,
        "units": {"length": "m", "angle": "rad", "mass": "kg", "time": "s", "force": "N"},
        "gravity": [0, -9.81],
        "links": {
            "frame": {"points": {"O": [0, 0], "K": [1, -1]}},
            "boom": {"points": {"O": [0, 0], "M": [2, 0], "tip": [3, 0.2]}, "mass": 50, "shape": "rod O-tip"},
        },
        "cylinders": {"lift": {"from": "K", "to": "M"}},
        "assembly": {"M": "right of K-O"},
        "drives": {"raise": {"extends": "lift", "speed": 0.1, "start": 1.5}},
        **sections,
    }


def written_out() -> dict[str, Any]:
    """The same with masses, as two links and a slide."""
    data = boom()
    del data["cylinders"]
    data["links"]["lift_barrel"] = {"points": {"K": [0, 0]}, "mass": 4, "com": [0.3, 0], "inertia": 0.2}
    data["links"]["lift_rod"] = {"points": {"M": [0, 0], "back": [-0.8, 0]}, "mass": 3, "shape": "rod M-back"}
    data["joints"] = {"lift": {"prismatic": ["lift_barrel", "lift_rod"], "line": ["K at 0", "M at 0"]}}
    data["drives"]["raise"] = {"slides": "lift_rod", "on": "lift_barrel", "speed": 0.1, "start": 1.5}
    return data


def test_a_cylinder_is_its_links_and_their_slide() -> None:
    parts = {"barrel": {"mass": 4, "com": 0.3, "inertia": 0.2}, "rod": {"mass": 3, "com": 0.4}}
    short = compiled_from(boom(cylinders={"lift": {"from": "K", "to": "M", **parts}}))
    long = compiled_from(written_out())
    names = [s.text for s in long.quantities.signals.all() if "back." not in s.text and ".arm" not in s.text]
    assert "raise.force" in names
    assert np.abs(short.evaluate(names, T) - long.evaluate(names, T)).max() < 1e-12


def test_its_value_is_the_distance_of_the_pins() -> None:
    compiled = compiled_from(boom())
    s, v, *rest, boom_force = compiled.evaluate(["lift.s", "lift.v", "K.x", "K.y", "M.x", "M.y", "raise.force"], T)
    distance = np.hypot(rest[2] - rest[0], rest[3] - rest[1])
    assert np.abs(s - distance).max() < 1e-14
    assert np.abs(s - (1.5 + 0.1 * T)).max() < 1e-14
    assert np.abs(v - 0.1).max() < 1e-14
    assert (boom_force > 0).all()  # pushes the boom up


def test_a_driven_cylinder_closes_in_closed_form() -> None:
    structure = compiled_from(boom()).structure
    assert [type(step) for step in structure.steps] == [Group]
    assert structure.groups[0].signature == "RRR"


def test_a_cylinder_that_only_follows_keeps_its_rod_in_front() -> None:
    """Driven at the boom, the cylinder swings along: no rule is asked for, and its length is positive."""
    data = boom(assembly={}, drives={"motor": {"turns": "boom", "on": "frame", "speed": 0.2, "start": 0.1}})
    compiled = compiled_from(data)
    assert list(compiled.assembly.rules.values()) == ["M: ahead of K along lift"]
    s, mx, my = compiled.evaluate(["lift.s", "M.x", "M.y"], T)
    assert np.abs(s - np.hypot(mx - 1, my + 1)).max() < 1e-14
    data["assembly"] = {"M": "behind K along lift"}
    assert compiled_from(data).evaluate(["lift.s"], T).max() < 0


def test_a_cylinder_of_negative_length_is_no_mode() -> None:
    data = boom(assembly={}, drives={"motor": {"turns": "boom", "on": "frame", "speed": 0.2, "start": 0.1}})
    outcome = lw.modes(Document.model_validate(data))
    assert len(outcome.modes) == 1
    assert outcome.own == 0
    assert outcome.complete


def test_a_prismatic_joint_may_be_extended_too() -> None:
    data = written_out()
    data["drives"]["raise"] = {"extends": "lift", "speed": 0.1, "start": 1.5}
    names = ["M.x", "M.y", "raise.force"]
    found = compiled_from(data).evaluate(names, T) - compiled_from(written_out()).evaluate(names, T)
    assert np.abs(found).max() == 0


def test_the_loader_as_the_format_has_it() -> None:
    """Two cylinders, three closed-form dyads, and a certificate that holds."""
    compiled = compiled_from(load(DATA / "loader.yaml"))
    assert [group.signature for group in compiled.structure.groups] == ["RRR", "RRR", "RRR"]
    certificate = certify(Run(compiled, 0.0, 4.0, 40))
    assert certificate.sound(1e-12)
    assert certificate.mobility == certificate.gruebler == 2


def test_the_file_keeps_its_short_form(tmp_path: Any) -> None:
    document = load(DATA / "loader.yaml")
    save(document, tmp_path / "again.yaml")
    assert load(tmp_path / "again.yaml") == document
    assert "lift_barrel" not in dump(document)


def test_the_builder_makes_the_same() -> None:
    data = boom()
    built = (
        Builder("mechanism", length="m", angle="rad", torque=None)
        .gravity(0, -9.81)
        .frame(O=[0, 0], K=[1, -1])
        .link("boom", O=[0, 0], M=[2, 0], tip=[3, 0.2], mass=50, shape="rod O-tip")
        .cylinder("lift", "K", "M")
        .assembly("M", "right of K-O")
        .drive("raise", extends="lift", speed=0.1, start=1.5)
        .build()
    )
    assert built == Document.model_validate({**data, "name": "mechanism"})


def test_spelling_out_leaves_nothing_to_spell_out() -> None:
    mechanism = spell_out(load(DATA / "loader.yaml")).mechanism
    assert {"lift_barrel", "lift_rod", "tilt_barrel", "tilt_rod"} <= mechanism.links.keys()
    assert all(drive.extends is None for drive in mechanism.drives.values())


@pytest.mark.parametrize(
    ("change", "code", "element"),
    [
        (("from: K", "from: KK"), "name.unknown", "cylinders.lift.from"),
        (("to: M", "to: K"), "cylinder.same-point", "cylinders.lift"),
        (("extends: lift", "extends: left"), "name.unknown", "drives.raise.extends"),
        (("extends: lift,", "extends: lift, on: boom,"), "drive.on", "drives.raise"),
        (("extends: lift,", "turns: boom,"), "drive.on", "drives.raise"),
        (("length: [900, 1500]", "length: [1500, 900]"), "value.not-rising", "cylinders.lift.length"),
        (("length: [900, 1500]", "length: [-900, 1500]"), "value.too-small", "cylinders.lift.length"),
        (("barrel: {mass: 40, com: 300}", "barrel: {mass: -40, com: 300}"), "value.too-small", "cylinders.lift.barrel"),
        (("barrel: {mass: 40, com: 300}", "barrel: {mass: 40}"), "file.missing", "cylinders.lift.barrel"),
        (
            ("barrel: {mass: 40, com: 300}", "barrel: {mass: 40, com: 2 s}"),
            "expression.units-conflict",
            "cylinders.lift.barrel",
        ),
        (("  bucket: ", "  lift_rod: "), "name.taken", "cylinders.lift"),
    ],
)
def test_what_is_wrong_is_told_where_the_file_has_it(change: tuple[str, str], code: str, element: str) -> None:
    found = findings(changed(change, text=LOADER))
    told = [f for f in found if f.code == code and f.element.startswith(element)]
    assert told, [(f.code, f.element) for f in found]
    assert told[0].line is not None


def test_a_stroke_that_is_too_short_is_told() -> None:
    """The run is whole, and the finding says by how much and where; the exit code is 1."""
    data = boom(
        cylinders={"lift": {"from": "K", "to": "M", "length": [1.55, 1.65]}}, studies={"cycle": {"duration": 2}}
    )
    job = lw.run(Document.model_validate(data))
    assert job.exit_code == 1
    assert job.cycle is not None and job.cycle.result.certificate is not None
    short, long = job.found
    assert (
        (short.code, short.element) == (long.code, long.element) == ("motion.cylinder-length", "cylinders.lift.length")
    )
    assert (short.data["by"], str(short.data["end"]), short.data["time"]) == ("0.05", "shorter", "0")
    assert (long.data["by"], str(long.data["end"]), long.data["time"]) == ("0.05", "longer", "2")
    assert "0.05 m longer than possible" in long.what


def test_a_place_on_a_link_of_a_cylinder_leads_to_its_line() -> None:
    """A group that can't close is told at the cylinder."""
    data = boom(drives={"raise": {"extends": "lift", "speed": 0.1, "start": 9}})
    _, (finding,) = examine(Document.model_validate(data))
    assert finding.code == "assembly.cannot-close"
    assert finding.path in (("cylinders", "lift"), ("links", "boom"))


def test_the_end_of_a_uniform_part_takes_no_other_s_name() -> None:
    """A point of that name would be pinned to it."""
    data = boom(cylinders={"lift": {"from": "K", "to": "M", "rod": {"mass": 3, "com": 0.4}}})
    data["links"]["boom"]["points"]["lift_rod_end"] = [1, 1]
    _, found = examine(Document.model_validate(data))
    assert [(f.code, f.element) for f in found] == [("name.taken", "cylinders.lift")]
    data["cylinders"]["lift"]["rod"]["inertia"] = 0.1
    assert examine(Document.model_validate(data))[1] == []


def test_points_that_the_file_doesn_t_have_aren_t_called_free() -> None:
    """A uniform rod's far end is made up for its inertia."""
    data = boom(cylinders={"lift": {"from": "K", "to": "M", "rod": {"mass": 3, "com": 0.4}}})
    said = {str(fact["name"]): str(fact["sentence"]) for fact in facts(compiled_from(data))}
    assert said[say("fact.lone")] == say("fact.lone.text", points="tip")


def test_what_a_run_finds_is_told_in_the_file_s_names() -> None:
    """A cylinder whose pins meet on the way, run from Python."""
    data = boom(drives={"hand": {"turns": "boom", "on": "frame", "speed": 1, "start": -1.5}})
    data["links"]["frame"]["points"]["K"] = [2, 0]
    job = lw.run(Document.model_validate(data | {"assembly": {}, "studies": {"cycle": {"duration": 2}}}))
    assert [(f.code, f.path) for f in job.found] == [("motion.singular", ("cylinders", "lift"))]


def between_two(**sections: Any) -> dict[str, Any]:
    """A pin P that only two cylinders carry, 1.3 m and 1.5 m long, 1 m apart."""
    return {
        **boom(),
        "links": {"frame": {"points": {"O": [0, 0], "K": [1, 0]}}},
        "cylinders": {"left": {"from": "O", "to": "P"}, "right": {"from": "K", "to": "P"}},
        "assembly": {"P": "left of O-K"},
        "drives": {
            "first": {"extends": "left", "speed": 0, "start": 1.3},
            "second": {"extends": "right", "speed": 0, "start": 1.5},
        },
        **sections,
    }


def test_cylinders_may_share_a_pin_that_no_other_link_has() -> None:
    x, y = compiled_from(between_two()).evaluate(["P.x", "P.y"], T[:1])[:, 0]
    assert (np.hypot(x, y), np.hypot(x - 1, y)) == pytest.approx((1.3, 1.5)) and y > 0
    drawn = between_two(sketch={"O": [0, 0], "K": [1, 0], "P": [0.2, 1.1]})
    drawn["links"]["frame"]["points"] = ["O", "K"]
    for drive in drawn["drives"].values():
        drive["start"] = "sketch"
    assert compiled_from(drawn).evaluate(["P.x", "P.y"], T[:1])[:, 0] == pytest.approx([0.2, 1.1])


def test_a_pin_of_one_cylinder_alone_is_a_slip() -> None:
    wrong = between_two(cylinders={"left": {"from": "O", "to": "P"}, "right": {"from": "K", "to": "Q"}})
    told = [(f.code, f.element) for f in examine(Document.model_validate(wrong))[1]]
    assert told[:2] == [("name.unknown", "cylinders.left.to"), ("name.unknown", "cylinders.right.to")]
