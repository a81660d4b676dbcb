"""Circuits and branches against what is known of four-bars and slider-cranks in closed form."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.optimize import brentq

import linkwright as lw
from graph.test_higher_groups import CASES
from helpers.examples import UNITS, four_bar, slider_crank
from linkwright.graph.constraints import Constraints, FollowerRelation
from linkwright.graph.geometry import Geometry
from linkwright.model.document import Document
from linkwright.model.quantities import Quantities
from linkwright.structure import decompose
from linkwright.studies.modes.outcome import ModesOutcome

LENGTH = st.floats(1.0, 4.0)


def modes_of(data: dict[str, Any]) -> ModesOutcome:
    return lw.modes(Document.model_validate(data))


def at(crank: float, *lengths: float) -> dict[str, Any]:
    data = four_bar(*lengths)
    data["drives"]["motor"]["start"] = crank
    return data


@settings(max_examples=25, deadline=None)
@given(st.tuples(LENGTH, LENGTH, LENGTH, LENGTH), st.floats(-3.1, 3.1))
def test_four_bars_have_the_circuits_of_theory(lengths: tuple[float, float, float, float], crank: float) -> None:
    """Grashof (s + l < p + q) with crank or ground shortest: the crank turns fully, each mode on its own circuit. Else
    both modes are on one, between the dead points where |b - c| or b + c spans from B to D. Of a Grashof linkage it is
    one of two mirror images, so the crank never lies along the ground; otherwise it is the only one, and does."""
    a, b, c, d = lengths
    s, p, q, longest = sorted(lengths)
    assume(abs(s + longest - p - q) > 0.05)
    reach = math.sqrt(a * a + d * d - 2 * a * d * math.cos(crank))
    assume(abs(b - c) + 0.05 < reach < b + c - 0.05)
    grashof = s + longest < p + q
    turns = grashof and s in (a, d)
    outcome = modes_of(at(crank, *lengths))
    assert all(circuit.closed and not circuit.crossings for circuit in outcome.circuits)
    if turns:
        assert outcome.survey.places == [(0, 0), (1, 0)]
        assert [circuit.turns for circuit in outcome.circuits] == [True, True]
        return
    assert outcome.survey.places == [(0, 0), (0, 1)]
    assert not outcome.circuits[0].turns
    cosines = [(a * a + d * d - r * r) / (2 * a * d) for r in (b - c, b + c)]
    for low, high in outcome.circuits[0].ranges:
        assert max(min(abs(math.cos(end) - cosine) for cosine in cosines) for end in (low, high)) < 1e-8
        assert (math.floor(low / math.pi) == math.floor(high / math.pi)) == grashof


@pytest.mark.parametrize(("rod", "e", "circuits"), [(3.0, 0.0, 2), (3.0, 1.5, 2), (0.8, 0.0, 1), (1.2, 0.7, 1)])
def test_slider_cranks(rod: float, e: float, circuits: int) -> None:
    """The crank turns fully where rod > r + |e| (two circuits); else one circuit, stopped where the rod is upright."""
    outcome = modes_of(slider_crank(1.0, rod, e))
    assert len(outcome.circuits) == circuits
    assert all(circuit.turns == (circuits == 2) for circuit in outcome.circuits)
    for circuit in outcome.circuits if circuits == 1 else []:
        ends = [math.sin(end) - e for ends in circuit.ranges for end in ends]
        assert all(abs(abs(y) - rod) < 1e-9 for y in ends)


def test_a_parallelogram_has_change_points() -> None:
    """Parallelogram and antiparallelogram cross where the crank lies along the ground, at 0 and 180 deg."""
    outcome = modes_of(at(1.0, 1.0, 3.0, 1.0, 3.0))
    assert len(outcome.circuits) == 2
    for circuit in outcome.circuits:
        assert circuit.turns
        values = sorted(value % (2 * math.pi) for value in circuit.crossings)
        around = [abs(math.remainder(value, 2 * math.pi)) for value in values]
        assert sorted(around) == pytest.approx([0.0, math.pi], abs=1e-5)


def test_nearly_a_parallelogram_is_no_change_point() -> None:
    """One part in ten thousand off: the two ways part, as circuits without a crossing or as one with dead points."""
    shorter, longer = modes_of(at(1.0, 1.0, 2.9997, 1.0, 3.0)), modes_of(at(1.0, 0.9997, 3.0, 1.0, 3.0))
    for outcome in (shorter, longer):
        assert all(not circuit.crossings for circuit in outcome.circuits)
    assert [circuit.turns for circuit in longer.circuits] == [True, True]
    assert [circuit.turns for circuit in shorter.circuits] == [False]


def test_a_mode_in_a_change_point_has_no_circuit() -> None:
    outcome = modes_of(at(0.0, 1.0, 3.0, 1.0, 3.0))
    assert outcome.survey.places == [None]
    assert outcome.modes[0].singular


def test_a_driven_slide_and_its_dead_points() -> None:
    """A slider-crank driven at the piston: from r + l to l - r and back over two branches, on both sides."""
    data = slider_crank(1.0, 3.0, 0.0)
    data["drives"] = {"ram": {"slides": "piston", "on": "frame", "speed": 0.1, "start": 3.2}}
    del data["assembly"]
    outcome = modes_of(data)
    assert len(outcome.modes) == 2
    assert len(outcome.circuits) == 1
    assert [sorted(ends) for ends in outcome.circuits[0].ranges] == [pytest.approx([2.0, 4.0], abs=1e-9)] * 2
    assert outcome.survey.places == [(0, 0), (0, 1)]


def test_an_open_circuit() -> None:
    """A wedge pushed along lifts a plunger: it goes as far as one likes, both ways."""
    links = {
        "frame": {"points": {"A": [0, 0]}},
        "wedge": {"points": {"W": [0, 0]}},
        "block": {"points": {"P": [0, 0]}},
        "plunger": {"points": {"P": [0, 0]}},
    }
    joints = {
        "row": {"prismatic": ["frame", "wedge"], "line": ["A at 0", "W at 0"]},
        "ramp": {"prismatic": ["wedge", "block"], "line": ["W at 0.5", "P at 0"]},
        "column": {"prismatic": ["frame", "plunger"], "line": ["A at 1.5", "P at 0"]},
    }
    drives = {"push": {"slides": "wedge", "on": "frame", "speed": 0.1, "start": 0.2}}
    outcome = modes_of({"units": dict(UNITS), "links": links, "joints": joints, "drives": drives})
    assert outcome.complete
    assert outcome.survey.places == [(0, 0)]
    (circuit,) = outcome.circuits
    assert not circuit.closed
    low, high = circuit.ranges[0]
    assert low < -10 < 10 < high


def test_several_drives_need_one_named() -> None:
    outcome = lw.modes(Document.model_validate(CASES["loader"]()))
    assert outcome.survey.drive is None
    assert outcome.circuits == []
    named = lw.modes(Document.model_validate(CASES["loader"]()), drive="raise")
    assert len(named.modes) == len(outcome.modes)
    assert all(place is not None for place in named.survey.places)


@pytest.mark.parametrize("name", CASES)
def test_slopes_agree_with_differences(name: str) -> None:
    """The constraint Jacobian against central differences, 1e-8 of its entries' size."""
    document = Document.model_validate(CASES[name]())
    quantities = Quantities(document)
    system = Constraints(decompose(document).topology, Geometry(quantities, quantities.parameters), 1.7)
    system.set_drive_values(dict.fromkeys(document.drives, 0.3))
    z, h = np.random.default_rng(3).uniform(-1, 1, system.width), 1e-6
    columns = [(system.residual(z + step) - system.residual(z - step)) / (2 * h) for step in h * np.eye(system.width)]
    assert np.abs(system.jacobian(z) - np.array(columns).T).max() < 1e-8
    assert len(system.rows) == system.residual(z).size


def test_every_pose_of_a_curve_fulfils_the_joints() -> None:
    from linkwright.graph.circuits import Tracer
    from linkwright.graph.modes import Explorer

    document = Document.model_validate(at(1.2, 3.0, 1.0, 3.4, 3.6))
    quantities, structure = Quantities(document), decompose(document)
    explorer = Explorer(quantities, structure, {"motor": 1.2})
    mode = explorer.run().modes[0]
    system = Constraints(structure.topology, explorer.geometry, explorer.size)
    curve = Tracer(system, "motor").follow(system.pose(dict(mode.bodies)))
    assert curve is not None
    assert max(np.abs(system.residual(z)).max() for z in curve.poses) < 1e-11


def on_a_cam(rod: float, sense: str = "counter-clockwise") -> dict[str, Any]:
    """A four-bar whose crank swings on a cam, 0.3 rad and back from where it stands 1.9 rad to the ground."""
    length, away = 1.0, 1.5
    pitch = math.sqrt(length**2 + away**2 - 2 * length * away * math.cos(math.pi - 1.9))
    data = four_bar(length, rod, 1.4, 2.0)
    data["links"]["frame"]["points"]["O"] = [-away, 0]
    data["links"]["disc"] = {"points": {"O": [0, 0]}}
    rise = {"over": 1.2, "law": "cycloidal"}
    segments = [{"rise": 0.3, **rise}, {"dwell": 1}, {"fall": 0.3, **rise}, {"dwell": 2 * math.pi - 3.4}]
    data["laws"] = {"lift": {"over": "angle", "of": "angle", "segments": segments}}
    data["drives"] = {"motor": {"turns": "disc", "on": "frame", "speed": 1.0, "start": 0.0}}
    cam = {"cam": "disc", "follower": "crank", "on": "frame", "base": pitch, "knife": "B", "law": "lift"}
    data["cams"] = {"rider": cam | {"side": "left of O-A", "phase": 2 * math.pi - 0.5, "sense": sense}}
    return data


def test_the_motor_turns_with_the_followers_of_its_cams() -> None:
    """A rod that reaches over the whole lift: both modes go all the way round."""
    outcome = modes_of(on_a_cam(1.9))
    assert outcome.survey.drive == "motor"  # the only one that isn't a follower
    assert outcome.survey.places == [(0, 0), (1, 0)]
    assert all(c.turns and c.closed and not c.crossings for c in outcome.circuits)


@pytest.mark.parametrize("sense", ["counter-clockwise", "clockwise"])
def test_dead_points_of_a_motor_with_a_cam(sense: str) -> None:
    """The coupler and the rocker are in line where the crank's lift u - sin(2 pi u)/(2 pi) reaches a height: there the
    motor turns back, once on the rise and once on the return."""
    # |BD| = sqrt(1 + 4 - 4 cos(1.9 - lift)) = |1.4 - rod| at a lift of 0.2
    rod = 1.4 + math.sqrt(5 - 4 * math.cos(1.7))
    outcome = modes_of(on_a_cam(rod, sense))
    u = float(brentq(lambda u: 0.3 * (u - math.sin(2 * math.pi * u) / (2 * math.pi)) - 0.2, 0, 1, xtol=1e-14))
    rising, falling = 0.5 + 1.2 * u, 0.5 + 2.2 + 1.2 * (1 - u) - 2 * math.pi
    wanted = [falling, rising] if sense == "counter-clockwise" else [-rising, -falling]
    assert outcome.survey.places == [(0, 0), (0, 1)]
    (circuit,) = outcome.circuits
    assert [list(ends) for ends in circuit.ranges] == [pytest.approx(wanted, abs=1e-7)] * 2


def test_a_follower_alone_has_no_circuits() -> None:
    with pytest.raises(lw.ModelError) as caught:
        lw.modes(Document.model_validate(on_a_cam(1.9)), drive="rider")
    (finding,) = caught.value.findings
    assert (finding.code, finding.data["motor"]) == ("study.follower", "motor")


def test_slopes_agree_with_differences_where_followers_ride() -> None:
    data = slider_crank(1.0, 3.0, 0.0)
    data["drives"]["ram"] = {"slides": "piston", "on": "frame", "speed": 0.1, "start": 3.2}
    document = Document.model_validate(data)
    quantities = Quantities(document)
    system = Constraints(decompose(document).topology, Geometry(quantities, quantities.parameters), 1.7)
    system.set_drive_values(
        {}, {"ram": FollowerRelation("motor", lambda q: (math.sin(2 * q), 2 * math.cos(2 * q)), 0.1)}
    )
    z, h = np.random.default_rng(3).uniform(-1, 1, system.width), 1e-6
    columns = [(system.residual(z + step) - system.residual(z - step)) / (2 * h) for step in h * np.eye(system.width)]
    assert np.abs(system.jacobian(z) - np.array(columns).T).max() < 1e-8
    assert system.rows[-1] == "ram"
