"""Geneva drives in sweeps and accuracy: closed forms, runs of their own, and differences of these."""

from __future__ import annotations

from math import pi, sin
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from ruamel.yaml import YAML

import linkwright as lw
from elements.geneva.drives import model
from helpers.compiled import compiled_from
from linkwright.expressions.language import Name
from linkwright.kernels.parameter_batch import Varied
from linkwright.reductions import kind_of
from linkwright.results import Run
from linkwright.studies.accuracy.derivatives import Derivatives
from linkwright.studies.accuracy.signal_sensitivities import Slopes
from linkwright.studies.batch_plan import Measuring

EXAMPLE = Path(__file__).parents[3] / "examples" / "geneva_drive.yaml"
SPEED, A = 2 * pi, 0.1
"""Of the driver (rad/s); the centre distance (m)."""


def values(job: Any) -> dict[str, float]:
    return {found.name + figure.label: figure.value for found in job.cycle.measures for figure in found.found}


def test_numbers_of_slots_are_swept() -> None:
    """Peaks by the closed form; all measures as those of files of their own."""
    document, slots = lw.load(EXAMPLE), [3, 4, 5, 6, 8]
    document = document.model_copy(update={"studies": {"cycle": document.studies["cycle"]}})
    outcome = lw.sweep(document, {"n": slots})
    assert outcome.table is not None
    assert not outcome.table.failed.any()
    size = np.sin(pi / np.array(slots))
    assert outcome.table.figures[0] == pytest.approx(SPEED * size / (1 - size), rel=1e-12)
    for k, n in [*enumerate(slots)][::2]:
        alone = list(values(lw.run(document.replace(n=n))).values())
        np.testing.assert_allclose(outcome.table.figures[:, k], alone, rtol=1e-9)


@pytest.mark.parametrize("kernel", ["numpy", "llvm"])
def test_samples_are_files_of_their_own(kernel: str) -> None:
    """Distances, a pin beside its place and the direction of the slots, at times on all stretches."""
    data = model(5, psi=-170.0, loads={"drill": {"on": "wheel", "torque": 1.5}})
    data["parameters"] = {"beside": 0, "turned": 0, "shift": 0}
    pin = data["links"]["driver"]["points"]["P1"]
    data["links"]["driver"]["points"]["P1"] = [f"{pin[0]} + beside", pin[1]]
    data["links"]["frame"]["points"]["Q"][1] = f"{data['links']['frame']['points']['Q'][1]} + shift"
    data["joints"]["indexing"]["slot"] = "17 deg + turned"
    names, t = (
        ["wheel.angle", "wheel.alpha", "indexing.force", "motor.torque", "force(frame, driver).y"],
        np.linspace(0, 2, 97),
    )
    varied = Varied(compiled_from(data), ["beside", "turned", "shift"])
    sets = np.array([[0, 0, 0], [2e-4, 0.1, -3e-4], [-1e-4, -0.2, 4e-4]]).T
    found = varied.evaluate(names, varied.parameters(sets), t, kernel=kernel)
    for k, (beside, turned, shift) in enumerate(sets.T):
        own = {**data, "parameters": {"beside": f"{beside} m", "turned": f"{turned} rad", "shift": f"{shift} m"}}
        if k:  # stated like this it would have a shock: samples may have the deviations of tolerances
            with pytest.raises(lw.ModelError) as refused:
                compiled_from(own)
            assert [finding.code for finding in refused.value.findings] == ["geneva.entry"]
        else:
            np.testing.assert_allclose(found[:, k], compiled_from(own).evaluate(names, t), rtol=1e-11, atol=1e-9)
    assert np.isfinite(found).all()


def test_a_sample_with_a_shock_fails() -> None:
    """More than a hundredth of the centre distance isn't a tolerance."""
    outcome = lw.sweep(lw.load(EXAMPLE), {"off": [-2, -0.5, 0, 0.5, 2]})
    assert outcome.table is not None
    assert outcome.table.failed.tolist() == [True, False, False, False, True]


MEASURES = {
    "rms": {"rms": "wheel.alpha", "window": "some"},
    "taken": {"mean": "indexing.engaged", "window": "some"},
    "torque": {"mean": "abs(motor.torque)"},
    "peak": {"max": "wheel.alpha"},
    "speed": {"min": "wheel.omega"},
    "force": {"max": "indexing.force"},
    "turned": {"value": "wheel.angle", "where": "min wheel.omega"},
}
PARAMETERS = {"beside": 0, "shift": 0, "begin": "-95 deg", "rate": "50 deg/s", "turned": "17 deg"}
OFFSETS, WEIGHTS = np.array([-2, -1, 1, 2]), np.array([1, -8, 8, -1]) / 12  # differences of fourth order


def deviating() -> Any:
    """A drive in which everything that moves its stretches in time deviates, and the radius of the pin."""
    data = model(5, loads={"drill": {"on": "wheel", "torque": 4.0}}, windows={"some": ["0.3 s", "4.4 s"]})
    data |= {"parameters": PARAMETERS, "measures": MEASURES}
    (x, y), q = data["links"]["driver"]["points"]["P1"], data["links"]["frame"]["points"]["Q"]
    data["links"]["driver"]["points"]["P1"] = [f"{x} + beside*cos(40 deg)", f"{y} + beside*sin(40 deg)"]
    data["links"]["frame"]["points"]["Q"] = [q[0], f"{q[1]} + shift"]
    data["joints"]["indexing"]["slot"] = "turned"
    data["drives"]["motor"] |= {"speed": "rate", "start": "begin"}
    return compiled_from(data)


def test_derivatives_of_measures_cross_the_ends_of_stretches() -> None:
    """Where the acceleration jumps, means change with the times at which pins enter and leave, too; by differences."""
    base, names = deviating(), [*PARAMETERS]
    run, varied = Run(base, 0.0, 5.0, 200), Varied(base, names)
    start = np.array([base.quantities.parameters[name] for name in names])
    rows = [base.graph.parameters.index(name) for name in names]
    exact = Derivatives(run, Slopes(run, np.eye(len(base.parameters))[:, rows]))
    sizes = np.array([1e-2, 1e-1, 1.0, 1.0, 1.0])
    steps = 2e-4 * sizes
    shifts = (steps[:, None] * OFFSETS)[None] * np.eye(len(names))[:, :, None]
    many = Measuring(varied, run).evaluate(varied.parameters((start[:, None, None] + shifts).reshape(len(names), -1)))
    for name, measure in base.mechanism.measures.items():
        for derivative, label in zip(exact.of(name), kind_of(measure).labels, strict=True):
            figure = many.figures[name][label].values
            wanted = figure.reshape(len(names), -1) @ WEIGHTS / steps
            assert derivative.places.shape[0] == 1, name
            assert derivative.places[0] * sizes == pytest.approx(wanted * sizes, abs=5e-6 * np.abs(figure).max()), name


def test_derivatives_are_those_of_closed_forms() -> None:
    """Of the peak lambda/(1 - lambda) by the pin's radius and the centre distance; of the wheel's angle beta while a
    pin pushes it, and none while it stands."""
    base = compiled_from(yaml_of(EXAMPLE))
    run, size = Run(base, 0.0, 1.0, 200), sin(pi / 4)
    rows = [base.graph.parameters.index(name) for name in ("r", "c")]
    slopes = Slopes(run, np.eye(len(base.parameters))[:, rows])
    (peak,) = Derivatives(run, slopes).of("fastest")
    gain = SPEED / (1 - size) ** 2 / A
    assert peak.places[0] == pytest.approx([gain, -size * gain], rel=1e-10)
    t = np.array([0.05, 0.2, 0.4, 0.45, 0.55, 0.9])
    psi = 2 * pi * t - pi
    found = slopes.at([Name("table.angle")], t).slope[0]
    inside = np.abs(psi) < pi / 4
    wanted = np.where(inside, -np.sin(psi) / (1 - 2 * size * np.cos(psi) + size**2) / A, 0.0)
    assert found[0] == pytest.approx(wanted, rel=1e-11, abs=1e-12)
    assert found[1] == pytest.approx(-size * wanted, rel=1e-11, abs=1e-12)


def yaml_of(path: Path) -> dict[str, Any]:
    found: dict[str, Any] = YAML(typ="safe").load(path.read_text(encoding="utf-8"))
    return found
