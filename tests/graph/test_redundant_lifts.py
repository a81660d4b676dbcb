"""Scissor lifts of many stages with a guided platform, in closed form: the guide is named, whatever is driven."""

from __future__ import annotations

import numpy as np
import pytest

from helpers.lifts import LENGTH, angle, effort, lift
from linkwright.compilation import examine
from linkwright.model.document import Document
from linkwright.results.certificate import certify
from linkwright.results.run import Run

T = np.linspace(0.0, 1.0, 5)
MANY = [pytest.param(of, n, marks=pytest.mark.long) for of in ("foot", "arm") for n in (12, 30, 60)]
FEW = [(of, n) for n in (1, 2, 4) for of in ("foot", "arm", "platform")]


@pytest.mark.parametrize(("driven", "stages"), [*FEW, *MANY, pytest.param("platform", 10, marks=pytest.mark.long)])
def test_a_guided_lift_of_many_stages(driven: str, stages: int) -> None:
    compiled, (finding,) = examine(Document.model_validate(lift(stages, driven)))
    assert compiled is not None
    assert (finding.code, finding.path, finding.data["states"]) == (
        "structure.redundant-joints",
        ("joints", "guide"),
        1,
    )
    alpha, _ = angle(driven, T)
    for k in {1, stages}:
        p = compiled.evaluate([f"P{k}.x", f"P{k}.y", f"Q{k}.x", f"Q{k}.y"], T)
        height = k * LENGTH * np.sin(alpha)
        np.testing.assert_allclose(p, [0 * T, height, LENGTH * np.cos(alpha), height], atol=1e-10 * stages)
    name = "torque" if driven == "arm" else "force"
    np.testing.assert_allclose(compiled.evaluate([f"ram.{name}"], T)[0], effort(stages, driven, T), rtol=1e-9)
    if stages < 5:
        assert certify(Run(compiled, 0.0, 1.0, 10)).sound()
