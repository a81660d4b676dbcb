"""Samples whose two assembly modes come as near to each other as is wished: each keeps to its own, by closed forms.

They jumped in silence, up to all of them, where the modes came nearer than 1e-5 of the crank.
"""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from helpers.compiled import compiled_from
from kernels.test_continuation import CRANK, GAPS, GROUND, SPEED, on_arc, pin_in_straight_slot, pin_on_arc
from linkwright.kernels.parameter_batch import Varied

Array = NDArray[np.float64]
SAMPLES = 40


def arcs(gap: float) -> tuple[Varied, Array]:
    """Four-bars whose rocker is an arc, with cranks and couplers of a spread that leaves the modes apart."""
    model = pin_on_arc(gap * CRANK)
    model["parameters"] = {"crank": f"{CRANK} m", "coupler": f"{CRANK * (1 + gap)!r} m"}
    model["links"]["crank"]["points"]["B"] = ["crank", 0]
    model["links"]["coupler"]["points"]["C"] = ["coupler", 0]
    nominal = np.array([[CRANK], [CRANK * (1 + gap)]])
    off = np.random.default_rng(1).uniform(-0.2, 0.2, (2, SAMPLES)) * abs(gap) * CRANK
    return Varied(compiled_from(model), ["crank", "coupler"]), nominal + off


def arc_right(values: Array, t: Array) -> Array:
    """C of each sample by the closed form: (2, samples, times)."""
    turned = 1.0 + SPEED * t
    every = [
        on_arc(crank * np.array([np.cos(turned), np.sin(turned)]), coupler, np.ones(t.size))
        for crank, coupler in values.T
    ]
    return np.stack(every, axis=1)


@pytest.mark.parametrize("gap", GAPS)
def test_pins_on_arcs_keep_to_their_side(gap: float) -> None:
    varied, values = arcs(gap)
    t = np.linspace(0.0, 3.3, 101)
    found = varied.evaluate(["C.x", "C.y"], varied.parameters(values), t)
    assert np.abs(found - arc_right(values, t)).max() < 1e-9


@pytest.mark.parametrize("gap", GAPS)
def test_levers_turn_on_where_their_slots_nearly_pass_their_pins(gap: float) -> None:
    model = pin_in_straight_slot(gap * CRANK)
    model["parameters"] = {"crank": f"{CRANK * (1 + gap)!r} m"}
    model["links"]["crank"]["points"]["B"] = ["crank", 0]
    varied = Varied(compiled_from(model), ["crank"])
    crank = CRANK * (1 + gap) + 0.4 * gap * CRANK * np.random.default_rng(1).uniform(-1, 1, (1, SAMPLES))
    t = np.linspace(0.0, 4.0, 101)
    angle, travel = varied.evaluate(["lever.angle", "slot.s"], varied.parameters(crank), t)
    turned = 0.5 + SPEED * t
    x, y = crank.T * np.cos(turned), crank.T * np.sin(turned) + CRANK
    assert np.abs(travel - np.hypot(x, y)).max() < 1e-9
    assert np.abs(np.exp(1j * angle) - np.exp(1j * np.arctan2(y, x))).max() < 1e-9


@pytest.mark.parametrize("gap", [-1e-2, -1e-4, -1e-6, -1e-7, -1e-8, -1e-9])
def test_samples_whose_modes_meet_end_there(gap: float) -> None:
    """With couplers that are too short the modes meet in a fold: the sample has no value from there on, and none of
    the other mode."""
    varied, values = arcs(gap)
    t = np.linspace(0.0, 3.3, 401)
    p = varied.parameters(values)
    found = varied.evaluate(["C.x", "C.y"], p, t)
    with np.errstate(invalid="ignore"):
        right = arc_right(values, t)
    # B is then as far from D as the arc and the coupler reach.
    crank, coupler = values
    fold = np.arccos((GROUND**2 + crank**2 - (GROUND + coupler) ** 2) / (2 * GROUND * crank))
    known = np.isfinite(found[0])
    assert np.abs(found - right)[:, known].max() < 1e-7
    assert np.array_equal(known, t < (fold[:, None] - 1.0) / SPEED)
    assert np.isfinite(varied.failures(p, t).time).all()


def test_a_sample_does_not_depend_on_others() -> None:
    varied, values = arcs(1e-5)
    t = np.linspace(0.0, 3.3, 101)
    every = varied.evaluate(["C.x"], varied.parameters(values), t)
    alone = varied.evaluate(["C.x"], varied.parameters(values[:, 7:8]), t)
    assert np.array_equal(every[:, 7:8], alone)
