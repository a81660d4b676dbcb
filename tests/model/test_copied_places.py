"""Faults of sub-assemblies and copies: told once, at the right line, with the other place and the names of that."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from linkwright.findings import Finding
from linkwright.words import LANGUAGES, in_language
from model.given import DATA, findings

WALKER = (Path(__file__).parents[2] / "examples" / "walker_legs.yaml").read_text(encoding="utf-8")
NESTED = (DATA / "copies.yaml").read_text(encoding="utf-8")


def changed(old: str, new: str, text: str = WALKER) -> str:
    assert old in text, old
    return text.replace(old, new, 1)


def line_of(start: str, text: str) -> int:
    """The line of a file that begins so."""
    return next(n for n, line in enumerate(text.split("\n"), start=1) if line.strip().startswith(start))


def only(text: str) -> Finding:
    (found,) = findings(text)
    return found


IN_THE_DEFINITION = {
    "a point": ("right of pin-B", "right of pin-Bx", "name.unknown", "C: right"),
    "a parameter": ("C: [b, 0]", "C: [bb, 0]", "name.unknown-parameter", "upper_body"),
    "a signal": ("span: foot.x", "span: fot.x", "name.unknown-element", "stride"),
    "a unit": ("f: 39.4", "f: 39.4 kg", "expression.units-conflict", "link_f"),
    "a key": ("{span: foot.x}", "{spam: foot.x}", "file.unknown-key", "stride"),
    "a value in all but one": ("c: 39.3", "c: 39.3 kg", "expression.units-conflict", "hanger"),
}


@pytest.mark.parametrize("case", IN_THE_DEFINITION)
def test_a_fault_of_the_sub_assembly_is_told_once_at_its_line(case: str) -> None:
    old, new, code, start = IN_THE_DEFINITION[case]
    text = changed(old, new)
    found = only(text)
    assert (found.code, found.line) == (code, line_of(start, text))
    assert found.element.startswith("subassemblies.leg.")
    assert not re.search(r"\b(left|right)\d_", found.what + found.mend)
    if found.code != "file.unknown-key":
        assert found.other is not None
        assert (found.other.element, found.other.line) == ("copies.left1", line_of("left1: {", text))


def test_what_may_be_meant_are_names_of_the_sub_assembly() -> None:
    assert only(changed("span: foot.x", "span: fot.x")).mend == "Did you mean 'foot'?"


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_fault_of_one_copy_is_told_there_with_both_lines(language: str) -> None:
    text = changed("parameters: {c: 39.5}", "parameters: {c: 9.5}")
    with in_language(language):
        found = only(text)
        assert (found.code, found.element, found.line) == (
            "assembly.cannot-close",
            "copies.left3",
            line_of("left3", text),
        )
        assert found.other is not None
        assert (found.other.element, found.other.line) == (
            "subassemblies.leg.links.lower_rod",
            line_of("lower_rod", text),
        )
        assert "left3_hanger" in found.what
        assert str(line_of("lower_rod", text)) in str(found)
        assert found.as_dict()["other"] == {"element": found.other.element, "line": found.other.line}


def test_a_value_that_a_copy_gives_is_told_at_that_value() -> None:
    found = only(changed("parameters: {c: 39.5}", "parameters: {c: 1/0}"))
    assert found.element == "copies.left3.parameters.c"


OF_THE_USE = {
    "of": ("left1: {of: leg,", "left1: {of: legg,", "name.unknown", "copies.left1.of"),
    "target": (
        "left1: {of: leg, join: {pin: A1}",
        "left1: {of: leg, join: {pin: A9}",
        "name.unknown-element",
        "copies.left1.join.pin",
    ),
    "unjoined": ("left1: {of: leg, join: {pin: A1}", "left1: {of: leg", "subassembly.unjoined", "copies.left1"),
    "parameter": (
        "parameters: {c: 39.5}",
        "parameters: {cc: 39.5}",
        "subassembly.no-parameter",
        "copies.left3.parameters.cc",
    ),
    "tolerance": (
        "parameters: {c: 39.5}",
        "parameters: {j: 2*m}",
        "subassembly.tolerance",
        "copies.left3.parameters.j",
    ),
    "taken": (
        "  crank: {points",
        "  left1_hanger: {points: {O: [0, 0]}}\n  crank: {points",
        "subassembly.taken",
        "copies.left1",
    ),
    "circle": (
        "    assembly:\n",
        "    copies: {self: {of: leg, join: {pin: pin}}}\n    assembly:\n",
        "subassembly.circular",
        "subassemblies.leg.copies.self.of",
    ),
    "unused port": ("ports: [pin]", "ports: [pin, rod]", "subassembly.port-unused", "subassemblies.leg.ports.1"),
    "given port": (
        "B: [-a, -height]",
        "B: [-a, -height], pin: [0, 0]",
        "subassembly.port-given",
        "subassemblies.leg.links.frame.points.pin",
    ),
    "port twice": ("ports: [pin]", "ports: [pin, pin]", "subassembly.port-twice", "subassemblies.leg.ports"),
    "mass": (
        "frame: {points: {B: [-a, -height]}}",
        "frame: {points: {B: [-a, -height]}, mass: 1 kg, shape: point B}",
        "subassembly.mass",
        "subassemblies.leg.links.frame.mass",
    ),
    "sketch": (
        "    links:\n      frame: {points: {B",
        "    sketch: {B: [0, 0, 0]}\n    links:\n      frame: {points: {B",
        "subassembly.sketch",
        "subassemblies.leg.sketch.B",
    ),
    "unused": (
        "subassemblies:\n",
        "subassemblies:\n  idle: {links: {x: {points: {A: [0, 0]}}}}\n",
        "subassembly.unused",
        "subassemblies.idle",
    ),
    "position": ("left1: {of: leg,", "left1: {of: leg, at: sketch,", "file.expected", "copies.left1.at"),
}


@pytest.mark.parametrize("case", OF_THE_USE)
def test_faults_of_copies_and_ports_are_named(case: str) -> None:
    old, new, code, element = OF_THE_USE[case]
    found = findings(changed(old, new))
    assert (code, element) in [(f.code, f.element) for f in found]
    others = {f.code for f in found} - {code}
    assert others <= {"subassembly.unjoined"}  # of the other copies, where a port is added


def test_a_port_is_no_element_of_the_sub_assembly_itself() -> None:
    found = findings(
        changed("ports: [pin, lift]\n    parameters: {l", "ports: [pin, lift, guide]\n    parameters: {l", NESTED)
    )
    assert ("subassembly.port-own", "subassemblies.finger.ports.2") in [(f.code, f.element) for f in found]


def test_long_names_and_too_many_links() -> None:
    long = findings(WALKER.replace("left1", "a_name_that_is_much_longer_than_those_of_other_copies"))
    assert {f.code for f in long} == {"subassembly.long-name"}
    more = "".join(f"  more{i}: {{of: leg, join: {{pin: A1}}}}\n" for i in range(40))
    found = findings(changed("copies:\n", f"copies:\n{more}"))
    assert {f.code for f in found} >= {"subassembly.too-many"}


def test_a_doubling_chain_ends_at_the_limit() -> None:
    """Copies of copies of copies: 2^19 links would be far more than can be counted one by one."""
    chain = "".join(f"  s{i}: {{copies: {{a: {{of: s{i - 1}}}, b: {{of: s{i - 1}}}}}}}\n" for i in range(1, 20))
    text = (
        "linkwright: 1\nunits: {length: mm, angle: deg, time: s}\n"
        "subassemblies:\n  s0: {links: {x: {points: {A: [0, 0]}}}}\n"
        f"{chain}links: {{frame: {{points: {{O: [0, 0]}}}}}}\ncopies: {{all: {{of: s19}}}}\n"
    )
    assert "subassembly.too-many" in {f.code for f in findings(text)}


def test_a_fault_of_a_copy_in_another_is_told_in_the_innermost_place_that_has_it_everywhere() -> None:
    inner = only(changed("travel: {span: guide.s}", "travel: {span: gide.s}", NESTED))
    assert inner.element == "subassemblies.finger.measures.travel.span"
    given = only(changed("{c0: 0.3 N/mm}", "{c0: 0.3 kg}", NESTED))
    assert given.element.startswith("subassemblies.pair.copies.b")
    assert "'c0'" in given.what
    outer = only(changed("apart: 8, a_l: 92", "apart: 8, a_l: 2", NESTED))
    assert outer.element == "copies.two"
    assert outer.other is not None
    assert outer.other.element.startswith("subassemblies.finger.")


def test_names_of_a_copy_that_failed_are_not_told_besides() -> None:
    found = findings(changed("left1: {of: leg,", "left1: {of: legg,"))
    assert [f.code for f in found] == ["name.unknown"]


def test_all_faults_of_form_are_told_at_once() -> None:
    text = """
linkwright: 1
units: {length: mm, angle: deg, time: s}
subassemblies:
  leg:
    joints: {g: {gear: [a, b], ratio: 2}}
    links: {a: {points: {A: [0, 0]}, mss: 3}, b: 7}
    assembly: {C: links of A-B}
links: {frame: {points: {O: [0, 0]}}}
copies:
  left: leg
  right: {of: leg, join: [A]}
"""
    found = {f.element: f for f in findings(text)}
    assert [*found] == [
        "subassemblies.leg.joints.g.gear",
        "subassemblies.leg.links.a.mss",
        "subassemblies.leg.links.b",
        "subassemblies.leg.assembly.C",
        "copies.left",
        "copies.right.join",
    ]
    assert found["copies.left"].mend == "Example: copies: {left: {of: leg, join: {A: crank_pin}}}"
    assert "links: {crank" in found["subassemblies.leg.links.b"].mend
    assert [f.line for f in found.values()] == [6, 7, 7, 8, 11, 12]
