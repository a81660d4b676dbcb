"""Varying loads and springs on random mechanisms, against the Newton-Euler system and differences."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from helpers.acting import acting, apart
from helpers.compiled import compiled_from, regular
from helpers.differences import misfit
from helpers.expected import expected_forces, oracle_states, worst
from helpers.plain import document_of
from helpers.random_mechanisms import DURATION, RECIPES, Seeded, build, mechanisms
from linkwright.results import Run, certify

T = np.linspace(0.0, DURATION, 6)[1:]


def merged(document: dict[str, Any], sections: dict[str, Any]) -> dict[str, Any]:
    """A file's data with more entries in its sections."""
    return document | {name: {**document.get(name, {}), **more} for name, more in sections.items()}


@pytest.mark.parametrize("recipe", RECIPES)
@settings(max_examples=6)
@given(data=st.data())
def test_forces_solve_newton_and_euler(recipe: str, data: Any) -> None:
    """All reactions and efforts to 1e-9 of the largest force; the certificate's three balances below 1e-9."""
    seed = data.draw(st.integers(0, 10**6))
    plain = build(recipe, Seeded(seed))
    sections, extra, ends = acting(plain, Seeded(seed + 1))
    compiled = compiled_from(merged(document_of(plain), sections))
    regular(compiled, np.linspace(0.0, DURATION, 9))
    oracle, states = oracle_states(plain, T, extra)
    assume(apart(oracle, states, ends) > 0.05)
    rows = expected_forces(oracle, states)
    error, name = worst(compiled.evaluate(list(rows), T), rows, 1e-3)
    assert error < 1e-9, name
    certificate = certify(Run(compiled, 0.0, DURATION, 20))
    assert certificate.sound(1e-9), certificate.residuals


@settings(max_examples=12)
@given(st.integers(0, 10**6))
def test_rates_are_those_of_the_motion(seed: int) -> None:
    """Exact rates of efforts, reactions and spring forces against central differences."""
    plain = build("six_bar", Seeded(seed))
    sections, _, _ = acting(plain, Seeded(seed + 1))
    # Kinks and jumps are no matter for differences: smooth tables, no windows, smooth functions.
    for table in sections.get("tables", {}).values():
        table["between"] = "cubic"
    for load in sections["loads"].values():
        load.pop("window", None)
        assume("abs" not in load["force"][0])
    compiled = compiled_from(merged(document_of(plain), sections))
    regular(compiled, np.linspace(0.0, DURATION, 9))
    names = [s.text for s in compiled.quantities.signals.all() if not s.kinematic or s.kind == "spring"]
    names = [name for name in names if not name.endswith(".arm")]
    values, exact = np.moveaxis(compiled.evaluate(names, T, rates=True), 1, 0)
    errors = misfit(lambda t: compiled.evaluate(names, t), exact, T)
    assert (errors <= 1e-6 * (np.abs(exact).max() + np.abs(values).max())).all()


@settings(max_examples=10)
@given(mechanisms("four_bar"))
def test_a_zero_load_changes_nothing(plain: Any) -> None:
    document = document_of(plain)
    compiled = compiled_from(document)
    regular(compiled, T)
    link, point = plain.moving[0], next(iter(plain.links[plain.moving[0]].points))
    more = {"loads": {"Z": {"on": link, "at": point, "force": ["0 N/s*t", f"0 N/m*{point}.x"]}}}
    names = [s.text for s in compiled.quantities.signals.all()]
    assert np.array_equal(
        compiled_from(merged(document, more)).evaluate(names, T), compiled.evaluate(names, T), equal_nan=True
    )
