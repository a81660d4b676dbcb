"""Many parameter sets at once against each of them compiled on its own from a file with those values."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from linkwright.kernels import Compiled, compile_mechanism
from linkwright.kernels.varied import Varied
from linkwright.model.document import load, replaced
from linkwright.model.findings import ModelError
from linkwright.model.mechanism import Document

Array = NDArray[np.float64]
EXAMPLES = Path(__file__).parents[2] / "examples"


def spread(nominal: Sequence[float], share: float, samples: int = 5, seed: int = 1) -> Array:
    """Values round nominal ones: (names, samples)."""
    shares = np.random.default_rng(seed).uniform(-share, share, (len(nominal), samples))
    return np.asarray(np.array(nominal)[:, None] * (1 + shares))


def alone(document: Document, values: Mapping[str, float], units: Mapping[str, str]) -> Compiled:
    """The mechanism compiled from a file with these values (SI)."""
    texts = {name: f"{value!r} {units[name]}".strip() for name, value in values.items()}
    return compile_mechanism(replaced(document, texts), EXAMPLES)


def assert_same(
    document: Document,
    units: Mapping[str, str],
    values: Array,
    signals: Sequence[str],
    t: Array,
    tolerance: float = 1e-12,
) -> None:
    """Both ways to ask give, with rates, what each sample alone gives, to a share of each row's size."""
    varied = Varied(compile_mechanism(document, EXAMPLES), list(units))
    p = varied.parameters(values)
    found = varied.evaluate(signals, p, t, rates=True)
    own = varied.at(signals, p, np.tile(t, (values.shape[1], 1)), rates=True)
    assert np.abs(own.reshape(found.shape) - found).max() <= tolerance * np.abs(found).max()
    for i, of_sample in enumerate(values.T):
        compiled = alone(document, dict(zip(units, map(float, of_sample), strict=True)), units)
        expected = compiled.evaluate(signals, t, rates=True).reshape(-1, t.size)
        scale = np.abs(expected).max(axis=1, keepdims=True) + 1e-300
        assert np.isfinite(expected).all()
        assert (np.abs(found[:, i] - expected) / scale).max() < tolerance


def test_four_bar() -> None:
    signals = ["P.x", "P.ay", "rocker.angle", "motor.torque", "force(coupler, rocker).x"]
    values = spread([0.04, 0.12, 0.08, 0.1], 0.03)
    units = dict.fromkeys("abcd", "m")
    assert_same(load(EXAMPLES / "four_bar.yaml"), units, values, signals, np.linspace(0, 0.5, 40))


def test_feeder() -> None:
    signals = ["E.x", "E.vx", "motor.torque", "shaking.x", "motor.angle"]
    names = ["AB", "BC", "CD", "DE", "AD", "AH"]
    values = spread([0.155, 0.395, 0.3, 0.5, 0.3, 0.58], 0.01)
    assert_same(
        load(EXAMPLES / "paper_feeder.yaml"), dict.fromkeys(names, "m"), values, signals, np.linspace(0, 1.5, 40)
    )


def test_an_unknown_parameter_is_refused() -> None:
    with pytest.raises(ModelError, match="unknown-parameter"):
        Varied(compile_mechanism(load(EXAMPLES / "four_bar.yaml")), ["a", "e"])
