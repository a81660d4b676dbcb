"""The benchmark of linear systems runs, and what it times is right."""

from __future__ import annotations

import linear
import numpy as np
import pytest


@pytest.mark.parametrize("n", [2, 5])
def test_the_program_solves_the_system(n: int) -> None:
    u = np.random.default_rng(0).uniform(0.1, 1.5, (2 * n, 3))
    a, b = linear.system(n, u)
    for i in range(3):
        found = linear.program(n)(u[:, i], np.empty(0))
        assert np.allclose(a[i] @ found, b[i], rtol=0, atol=1e-12 * np.abs(found).max())


def test_every_figure_is_there(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(linear, "KERNELS", {"numpy": linear.KERNELS["numpy"], "llvm": linear.KERNELS["jax"]})
    monkeypatch.setattr(linear.KERNELS["llvm"], "available", classmethod(lambda cls: False))
    figures = linear.measure(3, 50)
    assert figures["unknowns"] == 3
    assert figures["lapack"] > 0
    assert 0 <= figures["numpy_error_over_bound"] < 100
