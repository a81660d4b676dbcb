"""The benchmark of many samples runs and gives every figure; how fast is not asked here."""

from __future__ import annotations

import math

import pytest
import samples

from linkwright.kernels import KERNELS


def test_every_figure_is_positive(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(samples, "best", lambda: "numpy")
    monkeypatch.setattr(samples, "memory", lambda count: 1.0)
    figures = samples.measure(200, 1, cluster=False)
    assert {"numpy_1_threads_s", "numpy_2_threads_s", "numpy_2_threads_ns_per_pose"} <= set(figures)
    for name, value in figures.items():
        assert math.isfinite(value), name
        assert value > 0, name


def test_the_best_kernel_is_one_that_is_installed() -> None:
    assert KERNELS[samples.best()].available()
