"""All assembly modes: every choice of the dyads, larger groups from many starts, and the lines that select each."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import linkwright as lw
from graph.test_higher_groups import CASES
from helpers.compiled import compiled_from, compiled_of, regular
from helpers.examples import four_bar, slider_crank
from helpers.plain import Plain, document_of
from helpers.random_mechanisms import Drawn, build, driven_elsewhere, mechanisms, sketched
from linkwright import gallery
from linkwright.graph.modes import MOST
from linkwright.model.document import Document, read_document
from linkwright.model.yaml_text import read_text
from linkwright.structure import Driven, decompose
from linkwright.studies.modes.outcome import ModesOutcome


def modes_of(data: dict[str, Any]) -> ModesOutcome:
    return lw.modes(Document.model_validate(data))


def selected(data: dict[str, Any], lines: tuple[str, ...]) -> lw.Compiled:
    """The mechanism compiled with these lines for its assembly section."""
    said = dict(line.split(": ", 1) for line in lines)
    assembly = {name: rule.strip("[]").split(", ") if "[" in rule else rule for name, rule in said.items()}
    return compiled_from(data | {"assembly": assembly})


def misses(data: dict[str, Any], outcome: ModesOutcome) -> list[float]:
    """How far the mechanism assembled by each mode's lines is from that mode (m), points of all links."""
    found = []
    for mode in outcome.modes:
        start = selected(data, mode.lines).assembly.start
        assert start is not None
        links = start.geometry.mechanism.links
        homes = ((next(link for link in links if name in links[link].points), name) for name in mode.places)
        there = [start.bodies[link].point(start.point(link, name)).now for link, name in homes]
        found.append(float(np.abs(np.array(there, dtype=float) - list(mode.places.values())).max()))
    return found


@settings(max_examples=20, deadline=None)
@given(mechanisms())
def test_the_own_mode_is_found_and_every_mode_is_selected_by_its_lines(plain: Plain) -> None:
    compiled = compiled_of(plain)
    regular(compiled, np.zeros(1), 0.05)
    data = document_of(plain)
    outcome = modes_of(data)
    assert outcome.complete
    assert outcome.own is not None
    own = outcome.modes[outcome.own]
    assert {g.label: s for g, s in compiled.assembly.branches.items()} == dict(own.branches)
    assert max(misses(data, outcome)) < 1e-9 * max(1.0, compiled.assembly.size())


@settings(max_examples=6, deadline=None)
@given(st.sampled_from(["four_bar", "slider_crank", "inverted_slider_crank", "six_bar"]), st.data())
def test_a_mechanism_driven_elsewhere_has_its_pose_among_the_modes(recipe: str, data: st.DataObject) -> None:
    """The groups are beyond the dyads there; the pose from which the mechanism was made must be found."""
    source = Drawn(data.draw)
    plain = driven_elsewhere(build(recipe, source), source)
    structure = decompose(Document.model_validate(document_of(plain)))
    assume(not structure.findings)
    moving = [link for step in structure.steps if not isinstance(step, Driven) for link in step.links]
    plain = sketched(plain, moving)
    outcome = modes_of(document_of(plain))
    assume(not any(mode.singular for mode in outcome.modes))
    goal = {f"Z{link}": plain.assembly[f"Z{link}"] for link in moving}
    away = [max(np.hypot(*np.subtract(mode.places[z], at)) for z, at in goal.items()) for mode in outcome.modes]
    assert min(away) < 1e-8


@pytest.mark.parametrize("name", CASES)
def test_lines_of_larger_groups_select_their_mode(name: str) -> None:
    data = CASES[name]()
    outcome = modes_of(data)
    assert outcome.own is not None
    assert len(outcome.modes) % 2 == 0  # real modes come in pairs
    assert max(misses(data, outcome)) < 1e-9


def test_two_modes_of_a_dyad_and_their_lines() -> None:
    outcome = modes_of(four_bar())
    assert [mode.lines for mode in outcome.modes] == [("C: left of B-D",), ("C: right of B-D",)]
    assert outcome.own == 0
    outcome = modes_of(slider_crank())
    assert [mode.lines for mode in outcome.modes] == [("C: ahead of B along bore",), ("C: behind B along bore",)]


def test_a_file_needs_no_assembly_section() -> None:
    data = four_bar()
    del data["assembly"]
    outcome = modes_of(data)
    assert len(outcome.modes) == 2
    assert outcome.own is None


def test_another_time() -> None:
    outcome = lw.modes(Document.model_validate(four_bar()), at="1 s")
    assert outcome.values["motor"] == pytest.approx(1.5)
    assert outcome.modes[0].places["B"] == pytest.approx((np.cos(1.5), np.sin(1.5)))


def chain(count: int) -> dict[str, Any]:
    """A crank and as many dyads as asked for, each on the last one and the frame."""
    data = four_bar()
    frame = data["links"]["frame"]["points"]
    for i in range(1, count):
        joint = "C" if i == 1 else f"P{i - 1}"
        frame[f"F{i}"] = [4 + 3 * i, 0]
        data["links"][f"rod{i}"] = {"points": {joint: [0, 0], f"P{i}": [4, 0]}}
        data["links"][f"arm{i}"] = {"points": {f"F{i}": [0, 0], f"P{i}": [3, 0]}}
    return data


def test_dyads_in_a_row_double_the_modes_as_long_as_they_close() -> None:
    counts = [len(modes_of(chain(n)).modes) for n in (1, 2, 3)]
    assert counts[0] == 2
    assert all(a <= b <= 2 * a for a, b in pairwise(counts))


def test_more_modes_than_are_listed_are_told() -> None:
    """Seven rockers on the crank: 2^7 modes."""
    data = four_bar()
    del data["assembly"]
    for i in range(6):
        data["links"]["frame"]["points"][f"D{i}"] = [4, 0.1 * i]
        data["links"][f"coupler{i}"] = {"points": {"B": [0, 0], f"C{i}": [3, 0]}}
        data["links"][f"rocker{i}"] = {"points": {f"D{i}": [0, 0], f"C{i}": [3, 0]}}
    outcome = modes_of(data)
    assert len(outcome.modes) == MOST
    assert outcome.survey.found.cut
    assert not outcome.complete
    assert outcome.survey.untold


def test_modes_that_no_point_tells_apart_have_no_lines() -> None:
    """A barrel with a pin only may be turned round: its rod then comes out of the other end."""
    data = CASES["coupler_drive"]()
    data["links"]["sleeve"] = {"points": {"K": [0, 0]}}
    data["links"]["frame"]["points"]["K"] = [1, -2]
    data["links"]["bar"] = {"points": {"P": [0, 0]}}
    data["links"]["crank"]["points"]["P"] = [0.5, 0.1]
    data["joints"] = {"slot": {"prismatic": ["sleeve", "bar"], "line": ["K at 0", "P at 0"]}}
    outcome = modes_of(data)
    assert all(mode.lines for mode in outcome.modes)  # a dyad's rule tells them apart all the same


def test_nothing_fits() -> None:
    data = four_bar()
    data["links"]["coupler"]["points"]["C"] = [0.1, 0]
    with pytest.raises(lw.ModelError) as error:
        modes_of(data)
    assert [finding.code for finding in error.value.findings] == ["assembly.no-mode"]


def test_a_group_that_closes_in_no_way_ends_the_search_at_once() -> None:
    """Thirty rockers, the last out of reach: not 2^29 tries to find out."""
    data = four_bar()
    del data["assembly"]
    for i in range(29):
        data["links"]["frame"]["points"][f"D{i}"] = [4 if i < 28 else 40, 0.1 * i]
        data["links"][f"coupler{i}"] = {"points": {"B": [0, 0], f"C{i}": [3, 0]}}
        data["links"][f"rocker{i}"] = {"points": {f"D{i}": [0, 0], f"C{i}": [3, 0]}}
    with pytest.raises(lw.ModelError) as error:
        modes_of(data)
    assert [finding.code for finding in error.value.findings] == ["assembly.no-mode"]


def test_a_later_group_may_close_behind_some_choices_only() -> None:
    """A dyad between the rocker's end and a far pin closes for one of the two modes before it."""
    data = chain(2)
    data["links"]["frame"]["points"]["F1"] = [5, 6.5]
    outcome = modes_of(data)
    assert [mode.branches["coupler-rocker"] for mode in outcome.modes] == [1.0, 1.0]
    assert outcome.complete


def test_a_dyad_whose_outer_pins_meet_is_told() -> None:
    """Peaucellier's rhombus folded to one side: its far links turn freely about both pins, which is no single mode."""
    document = Document.model_validate(read_text(gallery.text("peaucellier").encode()).data)
    outcome = lw.modes(document)
    assert len(outcome.modes) == 4
    assert outcome.survey.found.free_groups == {"far1-far2"}
    assert not outcome.complete
    assert all(np.isfinite(list(mode.places.values())).all() for mode in outcome.modes)
    assert all(outcome.survey.places)


def test_links_that_lie_on_each_other_are_no_mode() -> None:
    """Peaucellier's two arms on one side: A and B meet, and the two bars to R turn about them freely."""
    document, _ = read_document(gallery.text("peaucellier").encode())
    assert document is not None
    outcome = lw.modes(document)
    assert len(outcome.modes) == 4
    for mode in outcome.modes:
        assert np.hypot(*np.subtract(mode.places["A"], mode.places["B"])) > 0.1
    assert [len(circuit.ranges) for circuit in outcome.circuits] == [2, 2]
