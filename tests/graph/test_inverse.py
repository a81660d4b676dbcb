"""Mechanisms turned round: forward poses are found again by the inverse, in a branch of the same mode."""

from __future__ import annotations

import cmath
import math
import re
from itertools import product
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from helpers.compiled import compiled_from
from helpers.examples import UNITS
from helpers.reach import Chain, FiveBar, Guide, TwoCylinders, TwoSlides
from helpers.reach.mechanisms import Mechanism
from linkwright.graph.inverse import DeterminantRow, DriveValue, guided_mechanism, inverse
from linkwright.graph.rows import Determinant, Radicand
from linkwright.kernels import KERNELS, Compiled
from linkwright.structure import decompose
from linkwright.studies.workspace.sheet import ModeSheet
from studies.workspace.models import triad_turned_round

Array = NDArray[np.float64]
MM = 1e-3
FIVE_BAR = FiveBar(12.0, 30.0, 27.0, 10.0, 18.0, 14.0, 0.7)
CASES: dict[str, tuple[Mechanism, int]] = {  # with the number of the inverse's branches
    "five-bar": (FIVE_BAR, 4),
    "two cylinders": (TwoCylinders(50.0, (40.0, 70.0), (35.0, 60.0)), 1),
    "two slides": (TwoSlides(3 + 25j, (0.2, -0.4), 30.0, 31.0, 18.0, 1.1, (-40.0, 40.0), (-40.0, 40.0)), 4),
    "crank and its slide": (Guide(6.0, 4 + 3j, None, (20.0, 60.0)), 2),
    "four-bar and an arm": (Chain(15.0, 40.0, 35.0, 50.0, 20.0), 4),
}
CRANK_AND_SLIDE = {
    "linkwright": 1,
    "units": UNITS,
    "links": {
        "frame": {"points": {"A": [0, 0], "H": [0, -0.2]}},
        "crank": {"points": {"A": [0, 0], "B": [1, 0]}},
        "block": {"points": {"D": [0, 0]}},
        "first": {"points": {"B": [0, 0], "C": [3, 0]}},
        "second": {"points": {"D": [0, 0], "C": [2.5, 0], "P": [1, 1]}},
    },
    "joints": {"rail": {"prismatic": ["frame", "block"], "line": ["H at 10 deg", "D at 0 deg"]}},
    "assembly": {"C": "left of B-D"},
    "drives": {
        "motor": {"turns": "crank", "on": "frame", "speed": 1, "start": 1.0},
        "ram": {"slides": "block", "on": "frame", "position": 3.0},
    },
}


def closing(mechanism: Mechanism, count: int) -> Array:
    """Values of the drives (rad or mm) at random at which a mechanism closes in its first mode."""
    spans = np.array(mechanism.spans)[:, :, None]
    q = np.random.default_rng(5).uniform(spans[:, 0], spans[:, 1], (2, count))
    return q[:, np.isfinite(mechanism.placed(q, 0).real)]


def compiled_case(name: str) -> tuple[Compiled, Array]:
    """The mechanism of a case with some values of its drives (SI)."""
    mechanism, _ = CASES[name]
    q = closing(mechanism, 300)
    compiled = compiled_from(mechanism.document(q[:, 0]))
    turns = [bool(compiled.mechanism.prescribed(drive).turns) for drive in compiled.graph.drives]
    return compiled, q * np.where(turns, 1.0, MM)[:, None]


def rows_at(compiled: Compiled, point: str, at: Array) -> tuple[dict[Any, Array], Array]:
    """The inverse's rows at places (2, n), (branches, n) each, and its branches."""
    found = inverse(compiled.graph, point)
    assert found is not None
    branches = np.array(found.branches())
    count, n = len(branches), at.shape[1]
    x = np.concatenate([np.tile(at, count), np.repeat(branches, n, axis=0).T])
    with np.errstate(all="ignore"):
        rows = KERNELS["numpy"](found.program).run(x, compiled.parameters).reshape(-1, count, n)
    return dict(zip(found.rows, rows, strict=True)), branches


def matches(compiled: Compiled, rows: dict[Any, Array], q: Array) -> NDArray[np.bool_]:
    """In which branches the inverse's poses are those of the drives' values ``q`` (2, n): (branches, n)."""
    found = np.array(True)
    for drive, value in zip(compiled.graph.drives, q, strict=True):
        if compiled.mechanism.prescribed(drive).turns:
            off = np.abs(rows[DriveValue(drive, "cos")] + 1j * rows[DriveValue(drive, "sin")] - np.exp(1j * value))
        else:
            off = np.abs(rows[DriveValue(drive, "travel")] - value)
        found = found & (off < 1e-9)
    return found


def held(compiled: Compiled, point: str, q: Array) -> int:
    """Poses of all modes at ``q``, found again in just one branch each, where the roots are real and the closures have
    the signs of the forward determinants; how many."""
    graph, total = compiled.graph, 0
    labels = [group.label for group in graph.branched]
    first, second = graph.drives
    for signs in product((-1.0, 1.0), repeat=len(labels)):
        sheet = ModeSheet(compiled, point, (first, second), signs)
        at, reach = sheet.place(q)
        # Near a meeting of branches round-off grows by its root.
        here = sheet.look(q)
        good = np.isfinite(at).all(axis=0) & (reach > 1e-3) & (np.abs(here.numerator) > 1e-3 * graph.size**2)
        rows, _ = rows_at(compiled, point, at[:, good])
        same = matches(compiled, rows, q[:, good])
        for label in labels:
            program = graph.program([Determinant(label)])
            forward = KERNELS["numpy"](program).run(sheet.inputs(q[:, good]), compiled.parameters)[0]
            same &= rows[DeterminantRow(label)] * forward > 0
        for what, row in rows.items():
            same &= (row > 0) | (not isinstance(what, Radicand))
        assert (same.sum(axis=0) == 1).all()
        total += int(good.sum())
    return total


@pytest.mark.parametrize("name", CASES)
def test_poses_are_found_again_in_one_branch_of_their_mode(name: str) -> None:
    compiled, q = compiled_case(name)
    assert held(compiled, "P", q) > 100


@pytest.mark.parametrize("name", CASES)
def test_each_dyad_with_a_root_doubles_the_branches(name: str) -> None:
    """But for cylinders: their lengths aren't negative."""
    compiled, _ = compiled_case(name)
    found = inverse(compiled.graph, "P")
    assert found is not None
    branches = found.branches()
    assert len(branches) == len(set(branches)) == CASES[name][1]
    assert all(len(one) == len(found.groups) and {*one} <= {1.0, -1.0} for one in branches)


def test_a_crank_and_a_slide() -> None:
    compiled = compiled_from(CRANK_AND_SLIDE)
    random = np.random.default_rng(2)
    assert held(compiled, "P", np.stack([random.uniform(-3, 3, 300), random.uniform(-2, 5, 300)])) > 100


@settings(max_examples=8, deadline=None)
@given(
    st.tuples(*[st.floats(0.5, 4)] * 6),
    st.floats(-3.1, 3.1),
    st.integers(0, 2**20),
)
def test_any_five_bar(lengths: tuple[float, ...], angle: float, seed: int) -> None:
    l1, l2, l3, l4, l5, r = lengths
    tool = cmath.rect(r, angle)
    bar = FiveBar(l1, l2, l3, l4, l5, r, angle)
    start = closing(bar, 200)
    assume(start.shape[1] > 20)
    data = bar.document(start[:, 0]) | {"units": UNITS}
    data["links"]["link3"]["points"]["P"] = [tool.real, tool.imag]
    held(compiled_from(data), "P", np.random.default_rng(seed).uniform(-np.pi, np.pi, (2, 100)))


def test_slopes_are_the_derivatives() -> None:
    compiled, q = compiled_case("five-bar")
    found = inverse(compiled.graph, "P")
    assert found is not None
    at = ModeSheet(compiled, "P", ("motor", "servo"), (1.0,)).place(q[:, :5])[0]
    x = np.concatenate([at, np.full((len(found.groups), at.shape[1]), 1.0)])
    rows, slopes = (KERNELS["numpy"](one) for one in (found.program, found.slopes))
    step = 1e-7
    with np.errstate(all="ignore"):
        told = slopes.run(x, compiled.parameters).reshape(2, len(found.rows), -1)
        for k in range(2):
            up, down = x.copy(), x.copy()
            up[k] += step
            down[k] -= step
            expected = (rows.run(up, compiled.parameters) - rows.run(down, compiled.parameters)) / (2 * step)
            known = np.isfinite(expected) & np.isfinite(told[k])
            assert known.mean() > 0.5
            np.testing.assert_allclose(told[k][known], expected[known], rtol=1e-4, atol=1e-4 * np.nanmax(np.abs(told)))


def test_what_turns_into_a_higher_group_has_no_inverse() -> None:
    """Forward there are dyads alone; with the point held none is left."""
    compiled = compiled_from(triad_turned_round())
    assert not compiled.structure.higher_groups
    turned = decompose(guided_mechanism(compiled.mechanism, "P"))
    assert not turned.findings and turned.higher_groups
    assert inverse(compiled.graph, "P") is None
    assert inverse(compiled.graph, "C") is not None


def platform() -> dict[str, Any]:
    """A platform on two driven legs and a bar: its three legs close together."""
    links: dict[str, Any] = {
        "frame": {"points": {"A1": [0, 0], "A2": [4, 0], "A3": [2, 4]}},
        "platform": {"points": {"C1": [0, 0], "C2": [1, 0], "C3": [0.5, 0.8], "P": [0.4, 0.3]}},
        "crank1": {"points": {"A1": [0, 0], "B1": [1, 0]}},
        "crank2": {"points": {"A2": [0, 0], "B2": [1, 0]}},
        "rod1": {"points": {"B1": [0, 0], "C1": [2, 0]}},
        "rod2": {"points": {"B2": [0, 0], "C2": [2, 0]}},
        "rod3": {"points": {"A3": [0, 0], "C3": [0.8, 0]}},
    }
    drives = {
        "one": {"turns": "crank1", "on": "frame", "speed": 1, "start": 1.2},
        "two": {"turns": "crank2", "on": "frame", "speed": 1, "start": 1.9},
    }
    assembly = {"C1": [1.5, 2.6], "C2": [2.5, 2.6], "C3": [2.0, 3.4]}
    return {"linkwright": 1, "units": UNITS, "links": links, "drives": drives, "assembly": assembly}


def test_what_closes_as_a_higher_group_has_no_inverse() -> None:
    compiled = compiled_from(platform())
    assert compiled.structure.higher_groups
    assert inverse(compiled.graph, "P") is None


def test_names_that_are_taken_are_left_alone() -> None:
    """Points foot and seat, links along_x and along_y and a joint at_x, as what carries the point is called."""
    names = {"F": "foot", "D": "seat", "link2": "along_x", "slider1": "along_y", "rail1": "at_x"}
    mechanism, _ = CASES["two slides"]
    plain = mechanism.document(closing(mechanism, 50)[:, 0])
    data = renamed(plain, names)
    one, other = compiled_from(plain), compiled_from(data)
    turned = guided_mechanism(other.mechanism, "P")
    for kind in ("links", "joints"):
        before, after = getattr(other.mechanism, kind), getattr(turned, kind)
        assert {*before} < {*after} and len(after) == len(before) + 2
    at = np.random.default_rng(4).uniform(-0.05, 0.05, (2, 50))
    first, second = rows_at(one, "P", at)[0], rows_at(other, "P", at)[0]
    for drive in one.graph.drives:
        travel = DriveValue(drive, "travel")
        np.testing.assert_array_equal(first[travel], second[travel])
    assert np.isfinite(first[DriveValue("first", "travel")]).sum() > 10


def renamed(data: Any, names: dict[str, str]) -> Any:
    """A file's data with points, links and joints of other names."""
    if isinstance(data, dict):
        return {names.get(key, key): renamed(value, names) for key, value in data.items()}
    if isinstance(data, str):
        return re.sub("[A-Za-z0-9_]+", lambda word: names.get(word[0], word[0]), data)
    return [renamed(one, names) for one in data] if isinstance(data, list) else data


def test_angles_between_branches_mirror_each_other() -> None:
    """An arm's two poses are mirror images in the line from its foot to the point."""
    data = {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"O": [0, 0]}},
            "upper": {"points": {"O": [0, 0], "A": [1, 0]}},
            "fore": {"points": {"A": [0, 0], "P": [0.7, 0]}},
        },
        "drives": {
            "shoulder": {"turns": "upper", "on": "frame", "speed": 1, "start": 0},
            "elbow": {"turns": "fore", "on": "upper", "speed": 1, "start": 1.0},
        },
    }
    rows, branches = rows_at(compiled_from(data), "P", np.array([[0.9], [0.8]]))
    assert len(branches) == 2
    shoulder = np.arctan2(*(rows[DriveValue("shoulder", part)] for part in ("sin", "cos")))[:, 0]
    elbow = np.arctan2(*(rows[DriveValue("elbow", part)] for part in ("sin", "cos")))[:, 0]
    far = math.hypot(0.9, 0.8)
    bent = math.acos((far**2 - 1 - 0.49) / 1.4)  # the rule of cosines
    aside = math.acos((1 + far**2 - 0.49) / (2 * far))
    np.testing.assert_allclose(np.sort(elbow), [-bent, bent], atol=1e-12)
    np.testing.assert_allclose(np.sort(shoulder - math.atan2(0.8, 0.9)), [-aside, aside], atol=1e-12)
    assert (np.sign(elbow) != np.sign(shoulder - math.atan2(0.8, 0.9))).all()
