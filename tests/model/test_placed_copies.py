"""What copies stand for: against mechanisms written out, their parameters, tolerances, numbers of pages, files."""

from __future__ import annotations

import random
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from helpers.examples import four_bar
from linkwright.compilation import compile_mechanism
from linkwright.findings import ModelError
from linkwright.model.copies import with_copies
from linkwright.model.document import dump, load, read_document
from linkwright.model.live_numbers import live_numbers
from linkwright.model.named_numbers import named_numbers
from linkwright.model.number_spans import NumberRefusedError, number_spans
from linkwright.model.origin import table_hashes
from model.given import DATA
from model.test_fuzz import mutated, survives

EXAMPLES = Path(__file__).parents[2] / "examples"
WALKER = EXAMPLES / "walker_legs.yaml"
NESTED = DATA / "copies.yaml"
T = np.linspace(0.0, 1.0, 25)
LEG = """
  rod_{n}: {{points: {{A{n}: [0, 0], C{n}: [j{n}, 0]}}}}
  bar_{n}: {{points: {{A{n}: [0, 0], D{n}: [k{n}, 0]}}}}
  body_{n}: {{points: {{B{n}: [0, 0], C{n}: [b{n}, 0], E{n}: d{n} at acos((b{n}^2 + d{n}^2 - e{n}^2)/(2*b{n}*d{n}))}}}}
  hanger_{n}: {{points: {{B{n}: [0, 0], D{n}: [c{n}, 0]}}}}
  link_{n}: {{points: {{E{n}: [0, 0], F{n}: [f{n}, 0]}}}}
  foot_{n}: {{points: {{D{n}: [0, 0], F{n}: [g{n}, 0], G{n}: i{n} at acos((g{n}^2 + i{n}^2 - h{n}^2)/(2*g{n}*i{n}))}}}}
"""
NUMBERS = {
    "a": 38,
    "b": 41.5,
    "c": 39.3,
    "d": 40.1,
    "e": 55.8,
    "f": 39.4,
    "g": 36.7,
    "h": 65.7,
    "i": 49,
    "j": 50,
    "k": 61.9,
}


def test_legs_of_the_walker_are_those_written_out_by_hand() -> None:
    """Three legs without sub-assemblies, in other names: the same bits. The first is that of jansen_leg.yaml."""
    three = (1, 2, 3)
    legs = [LEG.format(n=n) for n in three]
    values = {f"{name}{n}": value for n in three for name, value in NUMBERS.items()} | {"c3": 39.5, "m": 15, "l": 7.8}
    pins = "A1: [m, 0], A2: m at 120 deg, A3: m at 240 deg"
    fixed = ", ".join(f"B{n}: [-a{n}, -l]" for n in three)
    rules = [f"  C{n}: right of A{n}-B{n}\n  D{n}: left of A{n}-B{n}\n  F{n}: left of D{n}-E{n}\n" for n in three]
    text = (
        "linkwright: 1\nunits: {length: mm, angle: deg, time: s}\n"
        f"parameters: {{{', '.join(f'{name}: {value}' for name, value in values.items())}}}\nlinks:\n"
        f"  frame: {{points: {{O: [0, 0], {fixed}}}}}\n"
        f"  crank: {{points: {{O: [0, 0], {pins}}}}}{''.join(legs)}assembly:\n{''.join(rules)}"
        "drives: {motor: {turns: crank, on: frame, speed: 60 rpm, start: 0 deg}}\n"
    )
    document, source = read_document(text.encode())
    assert document is not None, source.findings
    by_hand, walker = compile_mechanism(document), compile_mechanism(load(WALKER))
    single = compile_mechanism(load(EXAMPLES / "jansen_leg.yaml"))
    for n in (1, 2, 3):
        for point, other in (("foot", "G"), ("C", "C"), ("E", "E")):
            rows = [f"{point}.{attribute}" for attribute in ("x", "y", "vx", "ay")]
            own = walker.evaluate([f"left{n}_{row}" for row in rows], T)
            expected = by_hand.evaluate([f"{other}{n}.{row.split('.')[1]}" for row in rows], T)
            np.testing.assert_array_equal(own, expected)
            if n == 1:
                alone = single.evaluate([f"{other}.{row.split('.')[1]}" for row in rows], T)
                np.testing.assert_array_equal(own, alone)


def test_mirrored_legs_step_as_the_others_do_half_a_turn_later() -> None:
    """The image of a leg with crank angle q is the leg with 180 deg - q, seen in the mirror."""
    walker = compile_mechanism(load(WALKER))
    x, y = walker.evaluate(["left1_foot.x", "left1_foot.y"], 0.5 - T)  # 1 turn/s: q goes to 180 deg - q
    u, v = walker.evaluate(["right1_foot.x", "right1_foot.y"], T)
    np.testing.assert_allclose(u, -x, atol=1e-12)
    np.testing.assert_allclose(v, y, atol=1e-12)


def test_each_copy_deviates_by_itself() -> None:
    """A tolerance that stands once counts for each copy: in a sum of two the worst cases add up, and the variances."""
    half = {
        "ports": ["O"],
        "parameters": {"c": {"value": 80, "tolerance": 0.1}},
        "links": {"strip": {"points": {"O": [0, 0], "E": ["c", 0]}}},
    }
    data: dict[str, Any] = {
        "linkwright": 1,
        "units": {"length": "mm", "angle": "deg", "time": "s"},
        "subassemblies": {"half": half},
        "links": {"frame": {"points": {"O": [0, 0]}}},
        "copies": {name: {"of": "half", "join": {"O": "O"}} for name in "pq"},
        "drives": {
            f"drive_{name}": {"turns": f"{name}_strip", "on": "frame", "speed": "0 rpm", "start": 0} for name in "pq"
        },
        "measures": {"sum": {"value": "p_E.x + q_E.x", "where": "start"}},
        "studies": {"cycle": {"duration": "1 s", "samples": 4}, "accuracy": {"outputs": ["sum"], "samples": 20000}},
    }
    outcome = lw.run(lw.Document.model_validate(data)).accuracy
    figure = outcome.figures["sum"]
    assert figure.nominal == pytest.approx(0.16)
    assert figure.worst == pytest.approx((-0.2e-3, 0.2e-3))
    assert figure.sigma == pytest.approx(2**0.5 * 0.1e-3 / 3)
    assert figure.monte_carlo.sigma == pytest.approx(figure.sigma, rel=0.03)
    assert figure.shares == pytest.approx([0.5, 0.5])


def test_numbers_of_pages() -> None:
    """A value of the sub-assembly is one number for all copies without one of their own; each value of a copy another;
    the changed text has the digits where they stand."""
    text = WALKER.read_text(encoding="utf-8")
    document = load(WALKER)
    named = named_numbers(document)
    by_label = {one["label"]: one for one in live_numbers(named, text)}
    shared, own = by_label["leg.c"], by_label["left3_c"]
    assert (shared["digits"], own["digits"], own["name"]) == ("39.3", "39.5", "left3_c")
    spans = number_spans(named, text)
    changed = spans.rewritten({shared["name"]: 0.0392, "left3_c": 0.0396})
    assert "      c: 39.2\n" in changed
    assert "parameters: {c: 39.6}" in changed
    again, _ = read_document(changed.encode())
    assert again is not None
    parameters = compile_mechanism(again).quantities.parameters
    assert [parameters[f"left{n}_c"] for n in (1, 2, 3)] == pytest.approx([0.0392, 0.0392, 0.0396])
    assert spans.refused["left1_c"] == "shared"
    with pytest.raises(NumberRefusedError, match="shared"):
        spans.rewritten({"left1_c": 0.04})


def test_values_of_copies_in_others_are_one_number_each() -> None:
    text = NESTED.read_text(encoding="utf-8")
    found = live_numbers(named_numbers(load(NESTED)), text)
    places = [(one["line"], one["start"]) for one in found]
    assert len(places) == len({*places})
    assert {"finger.e", "pair.apart", "pair.a.l", "pair.b.c0", "two_apart", "two_a_l"} <= {
        one["label"] for one in found
    }


@pytest.mark.parametrize("path", [WALKER, NESTED], ids=lambda path: path.stem)
def test_files_are_written_and_read_again(path: Path, tmp_path: Path) -> None:
    document = load(path)
    lw.save(document, tmp_path / "saved.yaml")
    assert load(tmp_path / "saved.yaml") == document
    assert "{value: 38}" not in dump(document)
    flat = with_copies(document).mechanism
    assert with_copies(flat).mechanism is flat
    assert not flat.copies
    assert not flat.subassemblies


def test_replaced_parameters_stand_in_the_copy() -> None:
    document = load(NESTED).replace(two_b_e=12, one_a_l=97, r=21)
    data = dump(document)
    assert "parameters: {a_l: 97}" in data
    assert "parameters: {apart: 8, a_l: 92, b_e: 12}" in data
    parameters = with_copies(document).mechanism.parameters
    assert (parameters["one_a_l"].value.raw, parameters["two_b_e"].value.raw) == (97, 12)
    assert parameters["one_a_l"].tolerance is not None
    with pytest.raises(ModelError, match="one_a_x"):
        load(NESTED).replace(one_a_x=1)


def test_a_link_that_is_a_port_gets_points() -> None:
    """A bracket with its own points on the link to which it is joined; the same as points written there."""
    expected = four_bar()
    expected["links"]["coupler"]["points"]["P"] = [1, 1]
    data = four_bar()
    data["subassemblies"] = {"eye": {"ports": ["arm"], "links": {"arm": {"points": {"P": [1, 1]}}}}}
    data["copies"] = {"e": {"of": "eye", "join": {"arm": "coupler"}, "at": [5, 5]}}
    one, other = (compile_mechanism(lw.Document.model_validate(d)) for d in (expected, data))
    np.testing.assert_array_equal(one.evaluate(["P.x", "P.ay"], T), other.evaluate(["e_P.x", "e_P.ay"], T))


def test_copies_joined_to_the_same_new_name_are_pinned_there() -> None:
    """A dyad of two copies of one link: the four-bar with sides of 3."""
    data = four_bar()
    del data["links"]["coupler"], data["links"]["rocker"]
    data["subassemblies"] = {"side": {"ports": ["P", "Q"], "links": {"bar": {"points": {"P": [0, 0], "Q": [3, 0]}}}}}
    data["copies"] = {
        "coupler": {"of": "side", "join": {"P": "B", "Q": "C"}},
        "rocker": {"of": "side", "join": {"P": "D", "Q": "C"}},
    }
    one, other = (compile_mechanism(lw.Document.model_validate(d)) for d in (four_bar(), data))
    np.testing.assert_array_equal(one.evaluate(["C.x", "C.y"], T), other.evaluate(["C.x", "C.y"], T))
    data["copies"]["rocker"]["join"]["Q"] = "D"
    found = lw.check(lw.Document.model_validate(data))
    assert "subassembly.same-point" in {f.code for f in found}


def test_a_displaced_copy_is_displaced() -> None:
    """Sketched places, frame points in polar form and by distances, approximate positions."""
    half = {
        "ports": ["A"],
        "sketch": {"A": [1, 0], "B": [2, 3], "D": "4 at 10 deg"},
        "links": {
            "frame": {"points": {"D": "sketch", "F": [6, 0], "H": {"from": {"D": 3, "F": 4}, "side": "left of D-F"}}},
            "coupler": {"points": ["A", "B"]},
            "rocker": {"points": ["D", "B"]},
        },
    }
    data = four_bar()
    data["links"] = {
        "frame": {"points": {"O": [0, 0], "M": [10, 5]}},
        "crank": {"points": {"O": [0, 0], "A": [1, 0]}},
        "other": {"points": {"M": [0, 0], "E": [1, 0]}},
    }
    del data["assembly"]
    data |= {
        "subassemblies": {"half": half},
        "copies": {
            "p": {"of": "half", "join": {"A": "A"}},
            "q": {"of": "half", "join": {"A": "E"}, "at": "hypot(10, 5) at atan2(5, 10)"},
        },
        "drives": {
            f"of_{name}": {"turns": name, "on": "frame", "speed": 1, "start": 0.1} for name in ("crank", "other")
        },
    }
    made = compile_mechanism(lw.Document.model_validate(data))
    for point in "BDFH":
        rows = [f"{{}}_{point}.x", f"{{}}_{point}.y"]
        p, q = (made.evaluate([row.format(name) for row in rows], T) for name in "pq")
        np.testing.assert_allclose(q - p, [[10.0] * len(T), [5.0] * len(T)], rtol=1e-12)
    assert {"p_AB", "q_AB"} <= made.mechanism.parameters.keys()
    data["copies"]["q"]["mirrored"] = True
    data["drives"]["of_other"] |= {"speed": -1, "start": "180 deg - 0.1"}
    made = compile_mechanism(lw.Document.model_validate(data))
    for point in "BDFH":
        x, u = made.evaluate([f"p_{point}.x", f"q_{point}.x"], T)
        y, v = made.evaluate([f"p_{point}.y", f"q_{point}.y"], T)
        np.testing.assert_allclose((u, v), (10 - x, 5 + y), rtol=1e-12)


def test_tables_in_sub_assemblies_are_part_of_the_origin(tmp_path: Path) -> None:
    (tmp_path / "pull.csv").write_text("t,f\n0,0\n1,1\n2,1\n3,0\n", encoding="utf-8")
    data = four_bar()
    table = {"file": "pull.csv", "x": "t s", "y": "f N"}
    data["subassemblies"] = {"s": {"tables": {"pull": table}, "links": {"x": {"points": {"Q": [0, 0]}}}}}
    assert [*table_hashes(lw.Document.model_validate(data), tmp_path)] == ["pull.csv"]


def test_a_builder_makes_the_same_file() -> None:
    leg = lw.Builder("no matter", length="m").frame(B=[-38, -8]).link("rod", pin=[0, 0], C=["j", 0])
    leg.parameter("j", 50, tolerance=0.1).link("body", B=[0, 0], C=[42, 0]).assembly("C", "right of pin-B")
    built = lw.Builder("walker").frame(O=[0, 0]).link("crank", O=[0, 0], A1=[15, 0], A2=[-15, 0])
    built.subassembly("leg", leg, ports=["pin"], note="a leg")
    built.copy("front", of="leg", join={"pin": "A1"}, mirrored=True).copy(
        "rear", of="leg", join={"pin": "A2"}, parameters={"j": {"value": 51, "tolerance": "none"}}, at=[2, 0]
    )
    document = built.drive("motor", turns="crank", speed="60 rpm", start=0).build()
    text = """
linkwright: 1
name: walker
units: {length: mm, angle: deg, mass: kg, time: s, force: N, torque: N*m}
subassemblies:
  leg:
    note: a leg
    ports: [pin]
    parameters: {j: {value: 50, tolerance: 0.1}}
    links:
      frame: {points: {B: [-38, -8]}}
      rod: {points: {pin: [0, 0], C: [j, 0]}}
      body: {points: {B: [0, 0], C: [42, 0]}}
    assembly: {C: right of pin-B}
links:
  frame: {points: {O: [0, 0]}}
  crank: {points: {O: [0, 0], A1: [15, 0], A2: [-15, 0]}}
copies:
  front: {of: leg, join: {pin: A1}, mirrored: true}
  rear: {of: leg, join: {pin: A2}, parameters: {j: {value: 51, tolerance: none}}, at: [2, 0]}
drives: {motor: {turns: crank, on: frame, speed: 60 rpm, start: 0}}
"""
    read, _ = read_document(text.encode())
    assert read == document
    assert with_copies(document).mechanism.parameters["rear_j"].tolerance is None
    assert with_copies(document).mechanism.parameters["front_j"].tolerance is not None
    with pytest.raises(ModelError, match=r"subassemblies\.leg"):
        lw.Builder().subassembly("leg", lw.Builder().study("cycle")).build()
    twice = lw.Builder().link("a", P=[0, 0]).link("a", P=[0, 0])
    with pytest.raises(ModelError, match=r"subassemblies\.leg\.links\.a"):
        lw.Builder().subassembly("leg", twice).build()


@pytest.mark.parametrize("seed", range(3))
def test_mutated_files(seed: int) -> None:
    """What is left of the walker and of nested copies ends in findings or a mechanism, and so do their numbers."""
    random_ = random.Random(seed)
    for _ in range(60):
        text = mutated(random_, random_.choice([WALKER, NESTED]).read_text(encoding="utf-8"))
        try:
            if survives(text.encode()):
                document, _ = read_document(text.encode())
                assert document is not None
                live_numbers(named_numbers(document), text)
                assert read_document(dump(document).encode())[0] == document
        except Exception as error:
            raise AssertionError(f"{type(error).__name__} for the file:\n{text}") from error
