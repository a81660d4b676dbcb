"""The NumPy kernel, and every other, against the evaluation of the same program step by step, and its blocks."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings

from helpers.compiled import compiled_from, compiled_of, regular
from helpers.examples import feeder, four_bar, heavy_four_bar
from helpers.kernels import every, examples
from helpers.random_mechanisms import DURATION, mechanisms
from linkwright.compilation import compile_mechanism
from linkwright.graph.rows import Determinant, Named, ReachRow, Strength, WindowRow
from linkwright.kernels import KERNELS, Compiled
from linkwright.kernels.numpy_blocks import BLOCK
from linkwright.kernels.registry import register
from linkwright.model.document import load

T = np.linspace(0.0, DURATION, 5)


def all_names(compiled: Compiled) -> list[Named]:
    names: list[Named] = [signal.text for signal in compiled.quantities.signals.all() if signal.attribute != "arm"]
    for group in compiled.structure.groups:
        names += [Determinant(group.label), ReachRow(group.label)]
    return names


@pytest.mark.parametrize("kernel", every())
def test_kernel_agrees_with_the_reference(kernel: str) -> None:
    """Every signal and its rate, at every pose, to round-off: 1e-13 of the row's size or of 1."""

    @settings(max_examples=examples(kernel))
    @given(mechanisms())
    def check(plain: Any) -> None:
        compiled = compiled_of(plain)
        regular(compiled, T)
        program = compiled.graph.program(all_names(compiled), rates=True)
        x, p = compiled.inputs(T), compiled.parameters
        found = KERNELS[kernel](program).run(x, p)
        expected = np.array([program(x[:, i], p) for i in range(T.size)]).T
        scale = np.maximum(1.0, np.abs(expected).max(axis=1, keepdims=True))
        assert (np.abs(found - expected) / scale).max() < 1e-12

    check()


@pytest.mark.parametrize("kernel", every())
def test_kernel_agrees_with_the_reference_on_loads_and_springs(kernel: str) -> None:
    """Windows, tables, whole turns, functions: to 1e-12 of the row's size or of 1."""
    compiled = compile_mechanism(load(Path(__file__).parents[1] / "model" / "data" / "sprung.yaml"))
    t = np.linspace(0.003, 0.79, 40)
    rows = [*map(WindowRow, compiled.graph.actions.windows), *(Strength("loads", name) for name in "abc")]
    program = compiled.graph.program([*all_names(compiled), *rows], rates=True)
    x, p = compiled.inputs(t), compiled.parameters
    found = KERNELS[kernel](program).run(x, p)
    expected = np.array([program(x[:, i], p) for i in range(t.size)]).T
    scale = np.maximum(1.0, np.abs(expected).max(axis=1, keepdims=True))
    assert (np.abs(found - expected) / scale).max() < 1e-12


@pytest.fixture(scope="module")
def loaded() -> Compiled:
    return compiled_from(feeder())


def program_and_inputs(compiled: Compiled, poses: int) -> tuple[Any, np.ndarray, np.ndarray]:
    names = ["E.x", "E.ax", "rocker.alpha", "force(frame, crank).x", "motor.torque", "shaking.moment"]
    t = 1.5 * np.arange(poses) / (2 * BLOCK + 3)
    return compiled.graph.program(names), compiled.inputs(t), compiled.parameters


@pytest.mark.parametrize("kernel", every())
@pytest.mark.parametrize("poses", [1, 2, BLOCK - 1, BLOCK, BLOCK + 1, 2 * BLOCK, 2 * BLOCK + 3])
def test_blocks_do_not_show(kernel: str, poses: int, loaded: Compiled) -> None:
    """The figures of a pose do not depend on how many others are computed with it, to the last bit."""
    program, x, p = program_and_inputs(loaded, poses)
    engine = KERNELS[kernel](program)
    found = engine.run(x, p)
    whole = engine.run(program_and_inputs(loaded, 2 * BLOCK + 3)[1], p)
    assert found.shape == (len(program.outputs), poses)
    assert np.array_equal(found, whole[:, :poses])
    for i in {0, poses // 2, poses - 1}:
        assert np.array_equal(engine.run(x[:, i : i + 1], p)[:, 0], found[:, i])


@pytest.mark.parametrize("kernel", every())
def test_out_is_written_and_returned(kernel: str, loaded: Compiled) -> None:
    program, x, p = program_and_inputs(loaded, BLOCK + 7)
    out = np.full((len(program.outputs), BLOCK + 7), np.nan)
    kept = x.copy()
    engine = KERNELS[kernel](program)
    found = engine.run(x, p, out=out)
    assert found is out
    assert np.array_equal(out, engine.run(x, p))
    assert np.array_equal(x, kept)


@pytest.mark.parametrize("kernel", every())
def test_out_may_be_part_of_a_larger_array(kernel: str, loaded: Compiled) -> None:
    program, x, p = program_and_inputs(loaded, 50)
    large = np.zeros((len(program.outputs) + 2, 120))
    engine = KERNELS[kernel](program)
    engine.run(x, p, out=large[1:-1, 10:110:2])
    assert np.array_equal(large[1:-1, 10:110:2], engine.run(x, p))
    assert not large[0].any()
    assert not large[:, :10].any()
    assert not large[:, 11:110:2].any()


@pytest.mark.parametrize("kernel", every())
def test_no_poses_give_no_figures(kernel: str, loaded: Compiled) -> None:
    program, x, p = program_and_inputs(loaded, 4)
    assert KERNELS[kernel](program).run(x[:, :0], p).shape == (len(program.outputs), 0)


@pytest.mark.parametrize("kernel", every())
def test_one_kernel_serves_other_parameters(kernel: str) -> None:
    """What depends on the parameters alone is kept between runs, and made anew when they change."""
    data = four_bar(parameters={"r": 1.0})
    data["links"]["crank"]["points"]["B"] = ["r", 0]
    compiled = compiled_from(data)
    engine = KERNELS[kernel](compiled.graph.program(["B.x", "C.x", "C.y"]))
    t = np.linspace(0, 1, 5)
    x = compiled.inputs(t)
    first = engine.run(x, np.array([1.0]))
    other = engine.run(x, np.array([0.8]))
    again = engine.run(x, np.array([1.0]))
    assert np.array_equal(first, again)
    assert other[0] == pytest.approx(0.8 * np.cos(0.5 + t), abs=1e-14)
    assert np.abs(first - other).max() > 0.01


@pytest.mark.parametrize("kernel", every())
def test_a_pose_that_cannot_close_is_nan_alone(kernel: str) -> None:
    """A rocker too short to be reached: NaN there and a negative reach, no warning, other poses untouched."""
    compiled = compiled_from(four_bar(2, 3, 1.2, 4))
    names = ["C.x", "rocker.omega", ReachRow("coupler-rocker"), "B.x"]
    t = np.linspace(0.0, 2 * np.pi, 200)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        engine = KERNELS[kernel](compiled.graph.program(names))
        found = engine.run(compiled.inputs(t), compiled.parameters)
    bad = found[2] < 0
    assert 0 < bad.sum() < t.size
    assert np.isnan(found[:2, bad]).all()
    assert np.isfinite(found[:, ~bad]).all()
    assert np.isfinite(found[3]).all()


@pytest.mark.parametrize("kernel", every())
def test_constant_outputs_fill_their_rows(kernel: str) -> None:
    compiled = compiled_from(heavy_four_bar())
    found = KERNELS[kernel](compiled.graph.program(["A.x", "D.x", "A.vx", "motor.alpha"])).run(
        compiled.inputs(np.linspace(0, 1, 7)), compiled.parameters
    )
    assert np.array_equal(found, np.array([[0.0], [4.0], [0.0], [0.0]]) * np.ones(7))


def test_a_second_kernel_of_one_name_is_refused() -> None:
    with pytest.raises(ValueError, match="registered twice"):
        register(KERNELS["numpy"])
