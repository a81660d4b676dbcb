"""Whether names and numbers fit together: what is found in a well-formed model, all at once."""

from __future__ import annotations

from typing import Any

import pytest

from linkwright.compilation import examine
from linkwright.findings import Finding
from linkwright.model.check import check_names
from linkwright.model.document import Document
from linkwright.model.pins import pins
from linkwright.model.signals import Signals
from model.given import DATA, changed, findings, four_bar


def found(**sections: Any) -> list[Finding]:
    """What is found in the four-bar with these sections."""
    return examine(Document.model_validate(four_bar(**sections)), DATA)[1]


def links(**more: Any) -> dict[str, Any]:
    return {**four_bar()["links"], **more}


def crank(**more: Any) -> dict[str, Any]:
    return links(crank={"points": {"A": [0, 0], "B": [40, 0]}, **more})


RAIL = {"rail": {"prismatic": ["frame", "rocker"], "line": ["D at 0", "C at 0"]}}
PULL = {"from": "A", "to": "C", "stiffness": 2, "free": 80}
TWIST = {"turns": "crank", "on": "frame", "stiffness": 2, "free": 0}
LIFT = {"from": "A", "to": "C", "gas": 400, "progression": 1.3, "length": [50, 150]}
DRIVE = {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": 40}


@pytest.mark.parametrize("name", ["five_bar", "paper_feeder"])
def test_the_examples_are_sound(name: str) -> None:
    assert not findings((DATA / f"{name}.yaml").read_text(encoding="utf-8"))


@pytest.mark.parametrize(
    ("sections", "code", "element"),
    [
        # Links.
        ({"links": {"ground": {"points": {"A": [0, 0]}}}}, "model.no-frame", "links"),
        ({"links": {"frame": {"points": {"A": [0, 0]}}}}, "model.no-moving-link", "links"),
        ({"links": links(idle={"points": {}})}, "model.no-points", "links.idle"),
        ({"drives": {}}, "model.no-drive", "drives"),
        (
            {"links": links(frame={"points": {"A": [0, 0], "D": [100, 0]}, "mass": 1, "shape": "point A"})},
            "model.frame-mass",
            "links.frame.mass",
        ),
        ({"links": crank(mass=1, shape="rod A-Q")}, "name.unknown-point", "links.crank.shape"),
        # Names that stand for two things.
        ({"links": links(B={"points": {"A": [0, 0]}})}, "name.taken", "links.crank.points.B"),
        ({"links": links(shaking={"points": {"A": [0, 0]}})}, "name.taken", "links.shaking"),
        ({"drives": {"crank": DRIVE}}, "name.taken", "drives.crank"),
        ({"parameters": {"p": 1}, "tables": {"p": {"points": [["0 s", 1]]}}}, "name.taken", "tables.p"),
        ({"tables": {"sin": {"points": [["0 s", 1]]}}}, "name.taken", "tables.sin"),
        # Joints.
        (
            {"joints": {"rail": {"prismatic": ["frame", "guid"], "line": ["A at 0", "A at 0"]}}},
            "name.unknown",
            "joints.rail.prismatic.1",
        ),
        (
            {"joints": {"rail": {"prismatic": ["frame", "rocker"], "line": ["D at 0", "Q at 0"]}}},
            "name.unknown-point",
            "joints.rail.line.1",
        ),
        (
            {"joints": {"rail": {"prismatic": ["rocker", "rocker"], "line": ["D at 0", "C at 0"]}}},
            "joint.same-link",
            "joints.rail",
        ),
        ({"joints": {"J": {"revolute": ["crank", "rocker"], "at": ["B", "C"]}}}, "joint.pin-twice", "joints.J"),
        ({"joints": {"D": {"revolute": ["crank", "coupler"], "at": ["B", "B"]}}}, "name.taken", "joints.D"),
        # Drives.
        ({"drives": {"m": {**DRIVE, "turns": "crnk"}}}, "name.unknown", "drives.m.turns"),
        ({"drives": {"m": {**DRIVE, "on": "crank"}}}, "joint.same-link", "drives.m"),
        ({"drives": {"m": DRIVE, "n": {**DRIVE, "turns": "frame", "on": "crank"}}}, "drive.twice", "drives.n"),
        (
            {"drives": {"m": {"turns": "crank", "on": "frame", "position": "crank.angle"}}},
            "drive.signal",
            "drives.m.position",
        ),
        # Loads.
        ({"loads": {"l": {"on": "crnk", "torque": 1}}}, "name.unknown", "loads.l.on"),
        ({"loads": {"l": {"on": "crank", "at": "C", "force": [1, 2]}}}, "name.unknown-point", "loads.l.at"),
        ({"loads": {"l": {"on": "crank", "at": "B", "force": [1, 2], "in": "x"}}}, "name.unknown", "loads.l.in"),
        ({"loads": {"l": {"on": "crank", "at": "B", "force": 1, "along": "x"}}}, "name.unknown", "loads.l.along"),
        ({"loads": {"l": {"on": "crank", "torque": 1, "against": "x"}}}, "name.unknown", "loads.l.against"),
        ({"loads": {"l": {"on": "crank", "torque": 1, "against": "crank"}}}, "load.against-itself", "loads.l"),
        ({"loads": {"l": {"on": "crank", "torque": "0.1*motor.torque"}}}, "load.signal", "loads.l.torque"),
        (
            {"loads": {"l": {"on": "crank", "at": "B", "force": ["0.1*force(frame, crank).x", 0]}}},
            "load.signal",
            "loads.l.force",
        ),
        ({"loads": {"l": {"on": "crank", "torque": "1 N*m*lift(t)"}}}, "expression.unknown-function", "loads.l.torque"),
        ({"loads": {"l": {"on": "crank", "torque": "1 N*m/(1 - 1)"}}}, "value.not-finite", "loads.l.torque"),
        ({"loads": {"l": {"on": "crank", "torque": 1, "window": "w"}}}, "name.unknown", "loads.l.window"),
        (
            {
                "loads": {"l": {"on": "crank", "torque": 1, "window": "w"}},
                "windows": {"w": {"motor.power": ["0 W", "1 W"]}},
            },
            "load.signal",
            "loads.l.window",
        ),
        # Springs and counterweights.
        ({"springs": {"s": {**PULL, "to": "Q"}}}, "name.unknown", "springs.s.to"),
        ({"springs": {"s": {**PULL, "in": ["frame", "rokker"]}}}, "name.unknown", "springs.s.in.1"),
        ({"drives": {"m": {**DRIVE, "output": "frame"}}}, "drive.output", "drives.m.output"),
        ({"springs": {"s": {**PULL, "in": ["frame", "crank"]}}}, "name.unknown-point", "springs.s.to"),
        ({"springs": {"s": {**PULL, "to": "D"}}}, "spring.same-link", "springs.s"),
        ({"springs": {"s": {**TWIST, "on": "crank"}}}, "spring.same-link", "springs.s"),
        ({"springs": {"s": {**TWIST, "turns": "crnk"}}}, "name.unknown", "springs.s.turns"),
        ({"springs": {"crank": TWIST}}, "name.taken", "springs.crank"),
        ({"springs": {"s": {**PULL, "stiffness": -1}}}, "value.too-small", "springs.s.stiffness"),
        ({"springs": {"s": {**LIFT, "progression": 1}}}, "spring.progression", "springs.s.progression"),
        ({"springs": {"s": {**LIFT, "length": [2, 1]}}}, "value.not-rising", "springs.s.length"),
        ({"springs": {"s": {"from": "A", "to": "C", "force": "f"}}}, "expression.unknown-function", "springs.s.force"),
        ({"springs": {"s": {**PULL, "stiffness": "2 kg"}}}, "expression.units-conflict", "springs.s.stiffness"),
        ({"counterweights": {"w": {"on": "crnk", "mass": 1, "at": "B"}}}, "name.unknown", "counterweights.w.on"),
        ({"counterweights": {"w": {"on": "crank", "mass": 1, "at": "Q"}}}, "name.unknown-point", "counterweights.w.at"),
        ({"counterweights": {"w": {"on": "crank", "mass": 0, "at": "B"}}}, "value.too-small", "counterweights.w.mass"),
        ({"counterweights": {"w": {"on": "frame", "mass": 1, "at": "A"}}}, "model.frame-mass", "counterweights.w"),
        # Assembly.
        ({"assembly": {"C": "left of B-D", "Q": "open"}}, "name.unknown", "assembly.Q"),
        ({"assembly": {"C": "left of B-Q"}}, "name.unknown", "assembly.C"),
        ({"assembly": {"C": "ahead of B along rail"}}, "name.unknown", "assembly.C"),
        # Expressions.
        ({"parameters": {"a": "b"}}, "name.unknown-parameter", "parameters.a"),
        ({"parameters": {"a": "f(3)"}}, "expression.unknown-function", "parameters.a"),
        ({"parameters": {"a": "2*mm"}}, "expression.unit-alone", "parameters.a"),
        ({"parameters": {"a": "sin(1, 2)"}}, "expression.arguments", "parameters.a"),
        ({"parameters": {"a": "t"}}, "expression.not-constant", "parameters.a"),
        ({"parameters": {"a": "B.x"}}, "expression.not-constant", "parameters.a"),
        ({"parameters": {"a": "b", "b": "a"}}, "parameters.cycle", "parameters.a"),
        ({"parameters": {"a": "1/0"}}, "parameters.value", "parameters.a"),
        (
            {"parameters": {"a": {"value": "1 mm", "tolerance": "1 kg"}}},
            "expression.units-conflict",
            "parameters.a.tolerance",
        ),
        (
            {
                "parameters": {"AB": {"value": 40, "tolerance": "1 kg"}},
                "links": crank(com=["AB", 0], mass=1, inertia=1),
            },
            "expression.units-conflict",
            "parameters.AB.tolerance",
        ),
        ({"gravity": [0, "1/0"]}, "value.not-finite", "gravity"),
        ({"gravity": [0, "10^39*10^39"]}, "value.not-finite", "gravity"),
        # Numbers.
        ({"links": crank(mass=-1, shape="point B")}, "value.too-small", "links.crank.mass"),
        ({"links": crank(mass=1, com=[0, 0], inertia=-1)}, "value.too-small", "links.crank.inertia"),
        ({"links": crank(mass=1, shape="disc 0 at A")}, "value.too-small", "links.crank.shape"),
        ({"links": crank(mass=1, shape="rod A-A")}, "value.rod", "links.crank.shape"),
        # Signals.
        ({"measures": {"m": {"max": "Q.x"}}}, "name.unknown-element", "measures.m.max"),
        ({"measures": {"m": {"max": "B.z"}}}, "signal.no-attribute", "measures.m.max"),
        ({"measures": {"m": {"max": "force(crank, rocker).x"}}}, "signal.no-joint", "measures.m.max"),
        ({"measures": {"m": {"max": "force(crank).x"}}}, "signal.unknown", "measures.m.max"),
        ({"measures": {"m": {"max": "force(crank, coupler, B, B).x"}}}, "signal.unknown", "measures.m.max"),
        ({"measures": {"m": {"max": "com(crank).x"}}}, "signal.no-mass", "measures.m.max"),
        ({"measures": {"m": {"max": "speed(crank).x"}}}, "signal.unknown", "measures.m.max"),
        (
            {"measures": {"m": {"max": "c(t)"}}, "tables": {"c": {"points": [["0 s", 1], ["1 s", 2]]}}},
            "measure.table",
            "measures.m.max",
        ),
        # Measures.
        ({"measures": {"m": {"max": "B.x", "window": "w"}}}, "name.unknown", "measures.m.window"),
        ({"measures": {"m": {"max": "B.x", "unit": "kg"}}}, "measure.unit", "measures.m.unit"),
        ({"measures": {"m": {"max": "crank.omega", "unit": "Hz"}}}, "measure.unit", "measures.m.unit"),
        ({"measures": {"m": {"max": "B.x", "wrap": ["0 deg", 1]}}}, "expression.units-conflict", "measures.m.wrap"),
        ({"measures": {"m": {"max": "B.x", "wrap": [2, 1]}}}, "value.not-rising", "measures.m.wrap"),
        ({"measures": {"m": {"value": "B.x", "where": "max Q.x"}}}, "name.unknown-element", "measures.m.where"),
        (
            {"measures": {"m": {"value": "B.x", "where": "max B.x + 1 kg"}}},
            "expression.units-mixed",
            "measures.m.where",
        ),
        ({"require": {"m": ">= 3"}}, "name.unknown", "require.m"),
        ({"require": {"m": "2 .. 3"}}, "name.unknown", "require.m"),
        ({"measures": {"m": {"max": "B.x"}}, "require": {"m": ">= 3 kg"}}, "expression.units-conflict", "require.m"),
        ({"measures": {"m": {"max": "B.x"}}, "require": {"m": ">= B.y"}}, "expression.not-constant", "require.m"),
        ({"measures": {"m": {"max": "B.x"}}, "require": {"m": "3 .. 2"}}, "value.not-rising", "require.m"),
        # Windows.
        ({"windows": {"w": ["0 mm", 1]}}, "expression.units-conflict", "windows.w"),
        ({"windows": {"w": [1, 0]}}, "value.not-rising", "windows.w"),
        ({"windows": {"w": {"moter.angle": [0, 90]}}}, "name.unknown-element", "windows.w.moter.angle"),
        ({"windows": {"w": {"motor.angel": [0, 90]}}}, "signal.no-attribute", "windows.w.motor.angel"),
        (
            {"windows": {"w": {"motor.angle": [0, "90 mm"]}}},
            "expression.units-conflict",
            "windows.w.motor.angle",
        ),
        ({"windows": {"w": {"motor.angle": [90, 0]}}}, "value.not-rising", "windows.w.motor.angle"),
    ],
)
def test_faults(sections: dict[str, Any], code: str, element: str) -> None:
    all_found = found(**sections)
    assert (code, element) in [(finding.code, finding.element) for finding in all_found]
    for finding in all_found:
        assert finding.what
        assert finding.mend


def test_unknown_names_come_with_the_likeliest_ones() -> None:
    text = changed(
        ("D: [AD, 0]", "D: [ADD, 0]"),
        ("[frame, guide]", "[frame, giude]"),
        ("C: left of B-D", "C: left of B-DD"),
        ("turns: crank", "turns: cranck"),
        ("span: E.x", "span: EE.x"),
        ("window: feed", "window: fed"),
        ("mass: 0.6, shape: rod A-B", "mass: 0.6, shape: rod A-BB"),
    )
    assert [(f.line, f.element, f.data["name"], f.data["near"].likely[0]) for f in findings(text)] == [
        (7, "links.frame.points.D", "ADD", "AD"),
        (8, "links.crank.shape", "BB", "B"),
        (14, "joints.rail.prismatic.1", "giude", "guide"),
        (16, "assembly.C", "DD", "D"),
        (18, "drives.motor.turns", "cranck", "crank"),
        (21, "measures.stroke.span", "EE", "E"),
        (24, "measures.feed_speed_max.window", "fed", "feed"),
    ]


def test_several_unknown_names_in_one_expression_are_all_told() -> None:
    names = [f.data["name"] for f in found(measures={"m": {"max": "B.x*foo + Q.x*bar"}})]
    assert names == ["foo", "Q", "bar"]


def test_two_circles_of_parameters_are_both_told() -> None:
    parameters = {"a": "b + 1", "b": "c", "c": "a", "d": "d", "e": "a + d"}
    circles = [f.data["cycle"] for f in found(parameters=parameters)]
    assert sorted(circles) == ["a -> b -> c -> a", "d -> d"]


def test_several_pins_between_two_links() -> None:
    more = {name: {"points": {"Y": [0, 0], "Z": [9, 0]}} for name in ("plate", "twin")}
    faults = found(
        links=links(**more), measures={"m": {"max": "force(plate, twin).x"}, "n": {"max": "force(plate, twin, Y).x"}}
    )
    assert [str(f.data["joints"]) for f in faults if f.code == "signal.several-joints"] == ["Y, Z"]


def test_chinese_names_are_names() -> None:
    text = changed(text=changed()).replace("crank", "曲柄").replace("AB", "曲柄长").replace("stroke", "行程")
    assert not findings(text)


def test_pins_are_inferred_from_shared_points() -> None:
    document = Document.model_validate(four_bar())
    assert {name: pin.links for name, pin in pins(document).items()} == {
        "A": ("frame", "crank"),
        "D": ("frame", "rocker"),
        "B": ("crank", "coupler"),
        "C": ("coupler", "rocker"),
    }


def test_a_joint_ties_points_of_different_names() -> None:
    data = four_bar(joints={"J": {"revolute": ["coupler", "rocker"], "at": ["C", "K"]}}, assembly={"J": "left of B-D"})
    data["links"]["rocker"] = {"points": {"D": [0, 0], "K": [80, 0]}}
    document = Document.model_validate(data)
    assert pins(document)["J"].members == (("coupler", "C"), ("rocker", "K"))
    assert not examine(document)[1]


def test_every_signal_is_found_by_its_own_name() -> None:
    from linkwright.expressions.language import parse
    from linkwright.model.document import load

    signals = Signals(load(DATA / "paper_feeder.yaml"))
    listed = signals.all()
    assert len({signal.text for signal in listed}) == len(listed) > 80
    for signal in listed:
        node = parse(signal.text)
        assert signals.find(node) == signal  # type: ignore[arg-type]


def test_a_force_is_of_one_link_on_another_or_on_a_pin_of_three() -> None:
    from linkwright.model.document import load

    contacts = {(c.joint, c.link, c.on) for c in Signals(load(DATA / "paper_feeder.yaml")).contacts}
    assert {("A", "frame", "crank"), ("A", "crank", "frame"), ("rail", "frame", "guide")} <= contacts
    data = four_bar()
    data["links"]["extra"] = {"points": {"C": [0, 0], "Z": [1, 0]}}
    signals = Signals(Document.model_validate(data))
    assert {c.on for c in signals.contacts if c.joint == "C"} == {"C"}


def test_names_are_checked_without_a_kernel() -> None:
    assert [f.code for f in check_names(Document.model_validate(four_bar(drives={})))] == ["model.no-drive"]


RUN = {"w": [0, 1]}


def test_bounds_without_units_follow_what_they_bound() -> None:
    document = Document.model_validate(
        four_bar(
            parameters={"limit": 50, "late": 90},
            windows={"w": {"motor.angle": [0, "late"]}},
            measures={"m": {"max": "B.x"}, "phi": {"value": "crank.angle", "where": "max B.y - 2", "wrap": [0, 360]}},
            require={"m": "<= limit", "phi": "0 .. 360 deg"},
        )
    )
    compiled, faults = examine(document)
    assert not faults
    assert compiled is not None
    q = compiled.quantities
    assert q.parameters["limit"] == pytest.approx(0.05)
    assert q.parameters["late"] == pytest.approx(1.5707963267948966)


@pytest.mark.parametrize(
    ("text", "code", "hint"),
    [
        ("slot", "signal.element", "slot.s"),
        ("s(slot)", "signal.unknown", "'slot.s'"),
        ("twist(hinge)", "signal.unknown", "POINT.x"),
        ("hinge.x", "name.unknown-element", "Write one of these: frame, crank"),
    ],
)
def test_joints_of_all_kinds_are_known_by_name(text: str, code: str, hint: str) -> None:
    joints = {
        "hinge": {"revolute": ["crank", "coupler"], "at": ["B", "E"]},
        "slot": {"pin_in_slot": ["coupler", "rocker"], "pin": "C", "straight": "D at 0 deg"},
    }
    parts = crank() | {
        "coupler": {"points": {"E": [0, 0], "C": [120, 0]}},
        "rocker": {"points": {"D": [0, 0]}, "mass": 1, "com": [0, 0], "inertia": 1},
    }
    (finding,) = [f for f in found(links=parts, joints=joints, measures={"m": {"max": text}}) if "measures" in f.path]
    assert finding.code == code
    assert hint in finding.mend


def test_a_call_of_links_that_is_no_signal_is_told_once() -> None:
    """Not as an unknown table, an unknown function and an unknown parameter."""
    (finding,) = found(measures={"m": {"max": "2*moment(coupler)"}})
    assert (finding.code, finding.data["name"]) == ("signal.unknown", "moment(coupler)")
    assert {f.code for f in found(measures={"m": {"max": "frob(q)"}})} == {
        "expression.unknown-function",
        "name.unknown-parameter",
    }
