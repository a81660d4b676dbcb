"""The benchmark of random samples runs, and what it compares agrees; how fast is not asked here."""

from __future__ import annotations

import json
import sys

import monte_carlo as script
import numpy as np
import pytest


def test_figures(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(sys, "argv", ["monte_carlo.py", "--json", "--samples", "2000", "--repeats", "1"])
    monkeypatch.setattr(script, "best", lambda: "numpy")
    script.main()
    figures = json.loads(capsys.readouterr().out)
    assert {"samples", "positions", "numpy_1_threads_s", "numpy_2_threads_s", "ratio_to_numpy_loop"} <= set(figures)
    assert min(figures.values()) > 0
    for text in script.ACCURACY["outputs"]:
        assert figures[f"{text}_sigma_off_rss_in_standard_errors"] < 5
        assert figures[f"{text}_loop_off_rss_in_standard_errors"] < 5


def test_the_loop_has_the_mechanism_s_motion() -> None:
    case = script.Case(10, 0, "numpy")
    found = case.run.evaluate(script.ACCURACY["outputs"], case.run.t)
    exact = script.closed_form(0.04, 0.12, 0.08, 0.1, np.radians(40) + 4 * np.pi * case.run.t)
    np.testing.assert_allclose(found, exact, atol=1e-13)
