"""What isn't a finite number ends in a finding that names it, never in an error of JSON."""

from __future__ import annotations

import json
from dataclasses import fields, replace
from typing import Any

import numpy as np
import pytest

from helpers.compiled import compiled_from
from helpers.examples import heavy_four_bar
from linkwright.app.job import summary_text
from linkwright.presentation.json_numbers import finite
from linkwright.results import Result
from linkwright.results.certificate import RESIDUALS, Certificate, certify
from linkwright.results.margins import Nearest
from linkwright.results.run import Run
from linkwright.studies.cycle.report import certificate_entry
from linkwright.studies.cycle.study import unproven

NO_NUMBERS = [np.nan, np.inf, float("nan"), np.float64("inf")]


@pytest.fixture(scope="module")
def result() -> Result:
    run = Run(compiled_from(heavy_four_bar()), 0.0, 1.0, 12)
    return Result(run, certificate=certify(run))


def spoilt(certificate: Certificate, name: str, value: float) -> Certificate:
    """The certificate with a figure that is no number, wherever it holds one."""
    if name == "nearest":
        return replace(certificate, nearest=Nearest("group", value, 0.0))
    if name == "followed":
        return replace(certificate, followed={"group": (3, value)})
    return replace(certificate, **{name: value})


@pytest.mark.parametrize("value", NO_NUMBERS)
@pytest.mark.parametrize("name", [*RESIDUALS, "measures", "nearest", "followed"])
def test_no_figure_of_a_certificate_reaches_json_as_no_number(result: Result, name: str, value: float) -> None:
    assert result.certificate is not None
    doubtful = replace(result, certificate=spoilt(result.certificate, name, value))
    entry = certificate_entry(doubtful, 1.0, "s")
    assert entry is not None and {*RESIDUALS, "measures"} <= {*entry}
    json.dumps(entry, allow_nan=False)
    assert ("not_numbers" in entry) == (name in (*RESIDUALS, "measures"))
    assert not doubtful.certificate.sound() or (name == "nearest" and value > 0)  # type: ignore[union-attr]
    assert len(unproven(doubtful)) == len(doubtful.certificate.unproven())  # type: ignore[union-attr]


def test_all_figures_of_a_certificate_are_covered() -> None:
    """A new figure that may be no number belongs to the test above."""
    numbers = {one.name for one in fields(Certificate) if "float" in str(one.type)}
    assert numbers == {*RESIDUALS, "measures", "changes", "followed"}


def test_the_finding_names_the_signal_and_the_time(result: Result, monkeypatch: pytest.MonkeyPatch) -> None:
    assert result.certificate is not None
    doubtful = replace(result, certificate=replace(result.certificate, power=np.nan))
    (finding,) = unproven(doubtful)
    assert finding.code == "motion.unknown-between"
    compiled = result.run.compiled
    rows = compiled.possible_rows

    def without_one(names: Any, t: Any, rates: bool = False) -> Any:
        values = np.array(rows(names, t, rates))
        if "motor.torque" in names:
            values[[*names].index("motor.torque"), 3] = np.nan
        return values

    monkeypatch.setattr(compiled, "possible_rows", without_one)
    (finding,) = unproven(doubtful)
    assert finding.code == "motion.unknown-value"
    assert "motor.torque" in finding.what and "t = 0.25 s" in finding.what


def test_a_summary_holds_finite_numbers_alone() -> None:
    data = {"a": np.nan, "b": [1.0, {"c": np.inf}], "d": (2, "x", None, True)}
    assert finite(data) == {"a": None, "b": [1.0, {"c": None}], "d": [2, "x", None, True]}
    assert json.loads(summary_text(data))["b"][1]["c"] is None
