"""The balance of power that a page computes: nothing is left of it, and it sees what is wrong with an effort."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from helpers.compiled import compiled_from
from helpers.examples import heavy_four_bar
from linkwright.compilation import compile_mechanism
from linkwright.findings import ModelError
from linkwright.graph import power_rows
from linkwright.graph.power_rows import PowerRow
from linkwright.model.document import load
from linkwright.results import Run, certify
from linkwright.results.independent_check import Reports

EXAMPLES = sorted((Path(__file__).parents[2] / "examples").glob("*.yaml"))
TIMES = np.linspace(0.013, 1.1, 37)


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_nothing_is_left(path: Path) -> None:
    """Over all kinds of joints and forces; the size is that of powers which the certificate balances."""
    try:
        compiled = compile_mechanism(load(path), path.parent)
    except ModelError:
        pytest.skip("it has no drive")
    left, size = compiled.evaluate([PowerRow(), PowerRow(True)], TIMES)
    known = np.isfinite(size)
    assert known.any()
    assert np.abs(left[known]).max() <= 1e-9 * max(size[known].max(), 1e-9)
    reports = Reports(compiled, TIMES[known])
    terms = np.array([*reports.drive_powers(), *reports.powers_of([*reports.acting(), *reports.inertia_and_gravity()])])
    if terms.size:
        assert size[known].max() <= np.abs(terms).sum(axis=0).max() * (1 + 1e-9) + 1e-12


def test_a_wrong_effort_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    """A torque that is a thousandth too large leaves a thousandth of its power."""
    compiled = compiled_from(heavy_four_bar())
    torque, omega = compiled.evaluate(["motor.torque", "motor.omega"], TIMES)
    real = power_rows.powers

    def wrong(view: Any) -> Any:
        view = replace(view)
        view.forces.efforts["motor"] = view.forces.efforts["motor"] * 1.001
        return real(view)

    monkeypatch.setattr(power_rows, "powers", wrong)
    (left,) = compiled_from(heavy_four_bar()).evaluate([PowerRow()], TIMES)
    np.testing.assert_allclose(left, 0.001 * torque * omega, rtol=1e-6, atol=1e-12)


def test_it_agrees_with_the_certificate() -> None:
    compiled = compiled_from(heavy_four_bar())
    certificate = certify(Run(compiled, 0.0, 1.0, 100))
    left, size = compiled.evaluate([PowerRow(), PowerRow(True)], np.linspace(0.0, 1.0, 101))
    assert certificate.power is not None
    assert certificate.power < 1e-12
    assert np.abs(left).max() / size.max() < 1e-12
