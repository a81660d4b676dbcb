"""The evaluator of motors' texts takes what is in the dialect, and nothing else."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from linkwright.formulas.evaluate import DialectError, value


@pytest.mark.parametrize(
    "text", ["", "1e-5", "2t", "t^^2", "exp(t)", "log(t)", "sin t", "(t", "t)", "x", "--t", "1,5", "pi*t", "t*-2"]
)
def test_the_evaluator_refuses_what_is_not_in_the_dialect(text: str) -> None:
    with pytest.raises(DialectError):
        value(text, np.zeros(1), degrees=True)


def test_the_evaluator() -> None:
    t: NDArray[np.float64] = np.array([0.5, 2.0])
    assert value("-2^2*t - 4/2/t + (t - 3)^2", t, degrees=True) == pytest.approx([-2 - 4 + 6.25, -8 - 1 + 1])
    assert value("sin(60*t) + asin(t/2)", t, degrees=True) == pytest.approx([0.5 + 14.4775121859, 3**0.5 / 2 + 90])
    assert value("cos(t) + ln(t)*sqrt(t)", t, degrees=False) == pytest.approx(np.cos(t) + np.log(t) * np.sqrt(t))
