"""What every registered kind of force element keeps: action is reaction, its power is what it stores and loses, and its
proof finds what it does."""

from __future__ import annotations

import copy
import pickle
from functools import partial
from typing import Any

import numpy as np
import pytest

from helpers.compiled import compiled_from
from linkwright.elements import FORCES, ForceKind
from linkwright.elements.entries import ENTRIES
from linkwright.elements.force import NOUNS, Acting
from linkwright.elements.force import register as register_force
from linkwright.graph.rows import effort
from linkwright.graph.view import View
from linkwright.kernels import Compiled
from linkwright.model.document import Document, plain
from linkwright.results.independent_check import Reports
from linkwright.symbols import ExpressionStage, as_symbol, derivatives_along
from linkwright.words import catalogue, say

MODEL: dict[str, Any] = {
    "linkwright": 1,
    "units": {"length": "m", "angle": "rad", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"},
    "links": {
        "frame": {"points": {"O": [0, 0], "D": [2, 0], "F": [1, -1.3]}},
        "crank": {"points": {"O": [0, 0], "B": [0.6, 0]}, "mass": 1, "shape": "rod O-B"},
        "coupler": {"points": {"B": [0, 0], "C": [1.8, 0], "E": [1, 0.7]}},
        "rocker": {"points": {"D": [0, 0], "C": [1.5, 0]}},
        "block": {"points": {"G": [0, 0]}},
    },
    "joints": {"rail": {"prismatic": ["rocker", "block"], "line": ["D at 0.1 rad", "G at 0.4 rad"]}},
    "assembly": {"C": "left of B-D"},
    "drives": {
        "motor": {"turns": "crank", "on": "frame", "position": "0.4 + 5*t/(1 s) + 0.3*sin(4*t/(1 s))"},
        "lift": {"slides": "block", "on": "rocker", "position": "0.5 m + 0.2 m*sin(3*t/(1 s))"},
    },
    "tables": {
        "pulls": {"points": [["-5 m", "-90 N"], ["0 m", "-40 N"], ["1 m", "20 N"], ["2 m", "35 N"], ["4 m", "90 N"]]},
        "turns": {"points": [["-50 rad", "-3 N*m"], ["0 rad", "5 N*m"], ["60 rad", "7 N*m"], ["90 rad", "9 N*m"]]},
    },
    "windows": {"early": ["0.2 s", "0.6 s"], "low": {"E.y": ["0 m", "1 m"]}},
}
"""A four-bar with a block that slides on its rocker."""
BETWEEN, AT_JOINT = {"from": "E", "to": "F"}, {"turns": "coupler", "on": "rocker"}
GAS = {"gas": 80, "progression": 1.6, "length": [0.2, 3.5]}
CASES: dict[str, list[dict[str, Any]]] = {
    "spring": [
        {**BETWEEN, "stiffness": 30, "free": 0.7, "preload": 4, "damping": 2},
        {**BETWEEN, "damping": 7},
        {**BETWEEN, "force": "pulls", "damping": 1},
        {**BETWEEN, **GAS},
        {**BETWEEN, **GAS, "exponent": 1.3},
        {"from": "G", "to": "C", "in": ["block", "rocker"], "stiffness": 12, "free": 0.2},
        {**AT_JOINT, "stiffness": 4, "free": 0.3, "preload": -1, "damping": 0.4},
        {**AT_JOINT, "torque": "turns"},
    ],
    "load": [
        {"on": "coupler", "at": "E", "force": [3, -7]},
        {"on": "coupler", "at": [0.3, 0.2], "force": ["3*t/(1 s)", "-7*E.y/(1 m)"], "in": "rocker", "torque": 2},
        {"on": "block", "at": "G", "force": "12", "along": "rail", "against": "rocker"},
        {"on": "rocker", "against": "crank", "torque": "pulls(E.x) * 1 m", "window": "early"},
        {"on": "coupler", "at": "C", "force": [1, 2], "window": "low"},
    ],
    "friction": [
        {"pin": "C", "radius": 0.05, "coefficient": 0.2},
        {"pin": "B", "radius": 0.04, "coefficient": "0.1 + 0.05*abs(own.omega)/(1 rad/s)", "viscous": 0.3},
        {"pin": "D", "in": ["rocker", "frame"], "viscous": 2},
        {"slide": "rail", "length": 0.3, "coefficient": 0.15},
        {"slide": "rail", "viscous": 5},
    ],
    "counterweight": [{"on": "crank", "mass": 2, "at": "0.3 at 3 rad", "inertia": 0.1}],
}
EVERY = [(name, i) for name, entries in CASES.items() for i in range(len(entries))]
T = np.linspace(0.05, 1.9, 41)


def file(name: str, which: int) -> dict[str, Any]:
    """The mechanism with one element."""
    loaded = (
        {"loads": {"push": {"on": "coupler", "at": "E", "force": [3, -7]}, "twist": {"on": "block", "torque": 4}}}
        if FORCES[name].resists
        else {}
    )
    return {**copy.deepcopy(MODEL), **loaded, FORCES[name].section: {"own": CASES[name][which]}}


def made(name: str, which: int) -> tuple[Compiled, Acting, Reports]:
    compiled = compiled_from(file(name, which))
    (one,) = (one for one in compiled.mechanism.acting() if one.name == "own")
    return compiled, one, Reports(compiled, T)


def evaluated(compiled: Compiled, view: View, rows: list[Any]) -> Any:
    """Expressions of a view at the times: (rows, times)."""
    stage = ExpressionStage(view.x, view.p, rows)
    x = compiled.inputs(T)
    return np.array([stage.numbers(column, compiled.parameters) for column in x.T]).T


def view_of(compiled: Compiled) -> View:
    return View.build(compiled.graph, 3, compiled.graph.inputs)


def wrenches(compiled: Compiled, one: Acting) -> list[tuple[str, Any]]:
    """What it does to links: force, moment about the frame's origin (3, times)."""
    view = view_of(compiled)
    found = [*one.kind.wrenches(view, one.name, one.entry)]
    parts = [(w.force.x, w.force.y, w.moment + w.about.x * w.force.y - w.about.y * w.force.x) for _, w in found]
    if not parts:
        return []
    rows = evaluated(compiled, view, [part for three in parts for part in three]).reshape(-1, 3, T.size)
    return list(zip([link for link, _ in found], rows, strict=True))


def moments(applied: Any) -> list[tuple[str, Any]]:
    """The same of what a proof says is done."""
    found = []
    for link, (x, y), place, moment in applied:
        rows = (x, y, place[0] * y - place[1] * x + moment)
        found.append((link, np.array([np.broadcast_to(row, T.shape) for row in rows])))
    return found


def total(parts: Any) -> dict[str, Any]:
    """By link the sum of its wrenches."""
    found: dict[str, Any] = {}
    for link, rows in parts:
        found[link] = found.get(link, 0.0) + rows
    return found


def power(reports: Reports, parts: Any) -> Any:
    """Of wrenches about the frame's origin on links."""
    done = np.zeros(T.size)
    for link, (x, y, moment) in parts:
        vx, vy = reports.velocity(link, np.zeros((2, T.size)))
        done += x * vx + y * vy + moment * reports.omega(link)
    return done


def test_every_kind_has_its_cases() -> None:
    assert {*CASES} == {*FORCES}
    assert {kind.section for kind in FORCES.values()} == {*NOUNS}


@pytest.mark.parametrize(("name", "which"), EVERY)
def test_the_proof_finds_what_it_does(name: str, which: int) -> None:
    compiled, one, reports = made(name, which)
    here, proven = total(wrenches(compiled, one)), total(moments(one.kind.applied(reports, one.name, one.entry)))
    assert here.keys() == proven.keys()
    assert bool(here) == one.kind.acts
    for link, rows in here.items():
        assert np.abs(rows).max() > 0
        assert rows == pytest.approx(proven[link], abs=1e-9)
    for misfit in one.kind.misfits(reports, one.name, one.entry):
        assert np.abs(misfit.value).max() < 1e-9


@pytest.mark.parametrize(("name", "which"), EVERY)
def test_action_is_reaction(name: str, which: int) -> None:
    compiled, one, _ = made(name, which)
    found = wrenches(compiled, one)
    if len(found) > 1:
        assert sum(rows for _, rows in found) == pytest.approx(np.zeros((3, T.size)), abs=1e-10)


@pytest.mark.parametrize(("name", "which"), EVERY)
def test_its_power_is_what_it_stores_and_loses(name: str, which: int) -> None:
    """The rate of the energy comes from the program's derivative in time."""
    compiled, one, reports = made(name, which)
    view = view_of(compiled)
    energy = as_symbol(one.kind.energy(view, one.name, one.entry))
    stored, rate = evaluated(compiled, view, [energy, *derivatives_along([energy], compiled.graph.flow(view))])
    assert bool(np.abs(stored).max()) <= one.kind.stores
    lost = power(reports, moments(one.kind.dissipative_forces(reports, one.name, one.entry)))
    done = power(reports, wrenches(compiled, one))
    near = partial(pytest.approx, abs=1e-9 * max(1.0, np.abs(done).max()))
    assert done == near(lost - rate)
    if "power" in one.kind.signals(one.entry):
        assert compiled.evaluate([f"{one.name}.power"], T)[0] == near(done)


@pytest.mark.parametrize(("name", "which"), EVERY)
def test_its_signals_are_those_that_it_names(name: str, which: int) -> None:
    compiled, one, _ = made(name, which)
    signals = one.kind.signals(one.entry)
    own = {signal.attribute: signal for signal in compiled.quantities.signals.all() if signal.owners == (one.name,)}
    assert {attribute: signal.dimension for attribute, signal in own.items()} == dict(signals)
    assert np.isfinite(compiled.evaluate([signal.text for signal in own.values()], T)).all()
    told = [*one.kind.reported(one.entry), one.kind.effort(one.entry), one.kind.distance(one.entry)]
    assert {*filter(None, told)} <= signals.keys()
    if one.kind.acts:
        assert np.isfinite(compiled.evaluate([effort(one)], T)).all()


@pytest.mark.parametrize(("name", "which"), EVERY)
def test_its_entry_goes_round(name: str, which: int) -> None:
    document = Document.model_validate(file(name, which))
    assert Document.model_validate(plain(document)) == document
    assert pickle.loads(pickle.dumps(document)) == document


@pytest.mark.parametrize("kind", FORCES.values(), ids=FORCES)
def test_a_kind_is_registered_once_and_has_its_words(kind: ForceKind[Any]) -> None:
    assert pickle.loads(pickle.dumps(kind)) is kind
    assert str(kind.title) == say(f"term.kind-{kind.name}")
    assert f"term.a-{NOUNS[kind.section]}" in catalogue()
    assert all(f"plot.{chart.title}" in catalogue() for chart in kind.charts)
    assert kind.usual != (kind.name in ENTRIES[kind.section])
    before = dict(FORCES)
    with pytest.raises(ValueError, match=kind.name):
        register_force(type(kind))
    assert before == FORCES
