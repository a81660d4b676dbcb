"""The JAX kernel beyond what every kernel is held to: samples, Newton, blocks, float64, what it says without JAX."""

from __future__ import annotations

import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from helpers.compiled import compiled_from
from helpers.examples import feeder, four_bar
from linkwright import _machine as machine
from linkwright.compilation import compile_mechanism
from linkwright.findings import ModelError
from linkwright.kernels import KERNELS, Compiled
from linkwright.kernels.jax_kernel import JaxKernel
from linkwright.kernels.jax_reduction import DeviceReduction
from linkwright.model.document import load

EXAMPLES = Path(__file__).parents[2] / "examples"
needs_jax = pytest.mark.skipif(not JaxKernel.available(), reason="JAX is missing")


@cache
def varied() -> tuple[Compiled, JaxKernel]:
    """A four-bar whose four lengths are parameters, and its kernel."""
    data = four_bar(parameters={"a": 1.0, "b": 3.0, "c": 3.0, "d": 4.0})
    for link, point, name in (("frame", "D", "d"), ("crank", "B", "a"), ("coupler", "C", "b"), ("rocker", "C", "c")):
        data["links"][link]["points"][point] = [name, 0]
    compiled = compiled_from(data)
    return compiled, JaxKernel(compiled.graph.program(["C.x", "rocker.alpha", "B.x", "D.x"]))


def lengths(samples: int, spread: float = 0.02) -> np.ndarray:
    """Parameters (parameters, samples) about the four-bar's."""
    nominal = varied()[0].parameters[:, None]
    return nominal * (1 + spread * np.random.default_rng(1).uniform(-1, 1, (4, samples)))


@cache
def reduction() -> DeviceReduction:
    return DeviceReduction(varied()[1])


@needs_jax
def test_samples_by_broadcasting_are_those_one_by_one() -> None:
    """``over`` with shared and with own inputs, over the edges of blocks, against NumPy's ``run`` of each sample."""
    compiled, kernel = varied()
    height, width = kernel.tile
    samples, poses = height + 3, width + 5
    p, x = lengths(samples), compiled.inputs(np.linspace(0, 6, poses))
    found = kernel.over(x, p)
    numpy = KERNELS["numpy"](kernel.program)
    for sample in (0, height - 1, height, samples - 1):
        expected = numpy.run(x, p[:, sample].copy())
        largest = np.abs(expected).max(axis=1, keepdims=True)
        assert (np.abs(found[:, sample] - expected) <= 1e-12 * largest).all()
    own = kernel.over(np.repeat(x[:, None], samples, axis=1), p)
    assert (np.abs(own - found) <= 1e-12 * np.abs(found).max(axis=(1, 2), keepdims=True)).all()


@needs_jax
def test_a_pose_does_not_depend_on_the_others() -> None:
    """To the last bit, wherever it stands in its block, alone or beside more than a block of others."""
    compiled, kernel = varied()
    height, width = kernel.tile
    p, x = lengths(height + 2), compiled.inputs(np.linspace(0, 6, width + 3))
    found = kernel.over(x, p)
    for sample, pose in ((0, 0), (7, 5), (height - 1, width - 1), (height + 1, width + 2)):
        assert np.array_equal(kernel.over(x[:, [pose]], p[:, [sample]])[:, 0, 0], found[:, sample, pose])
    many = compiled.inputs(np.linspace(0, 6, height * width + 9))
    found = kernel.run(many, compiled.parameters)
    for pose in (1, 4097, height * width - 1, height * width + 8):
        assert np.array_equal(kernel.run(many[:, [pose]], compiled.parameters)[:, 0], found[:, pose])


@needs_jax
def test_numbers_of_poses_share_what_is_compiled() -> None:
    compiled, kernel = varied()
    kernel.run(compiled.inputs(np.linspace(0, 6, 4)), compiled.parameters)
    before = kernel.compiled._cache_size()
    for poses in (1, 2, 3, 5, 100, 1000):
        kernel.run(compiled.inputs(np.linspace(0, 6, poses)), compiled.parameters)
    assert kernel.compiled._cache_size() == before


@needs_jax
def test_newton_solves_each_sample_from_shared_starts() -> None:
    """A plate on three legs: starts off by hundredths come back to the closed pose; a hopeless one is NaN alone."""
    compiled = compile_mechanism(load(EXAMPLES / "platform.yaml"))
    program = compiled.graph.program(["plate.angle", "plate.omega"], solve=True)
    assert program.solves
    x = compiled.inputs(np.linspace(0.0, 1.0, 6))
    expected = KERNELS["numpy"](program).run(x, compiled.parameters)
    rows = list(program.solves[0].rows)
    x[rows] += np.random.default_rng(3).uniform(-0.02, 0.02, (len(rows), 6))
    x[rows, 2], x[rows, 4] = 1e6, np.nan
    p = np.repeat(compiled.parameters[:, None], 2, axis=1)
    kernel = JaxKernel(program)
    found = kernel.over(x, p)
    assert np.isnan(found[..., 4]).all()
    good = [0, 1, 3, 5]
    for sample in range(2):
        assert found[:, sample, good] == pytest.approx(expected[:, good], rel=1e-12)
    again = kernel.over(x[:, good], p)
    assert np.array_equal(again, found[..., good])


@needs_jax
@pytest.mark.parametrize("n", [1, 2, 3, 5])
def test_newtons_steps_are_those_of_a_solve(n: int) -> None:
    """Small systems whose pivots have to be sought, against NumPy; singular and unknown ones give NaN."""
    import jax

    from linkwright.kernels.jax_trace import _steps

    random = np.random.default_rng(n)
    slope, gap = random.normal(size=(50, n, n)), random.normal(size=(50, n))
    slope[:, 0, 0] = 0.0 if n > 1 else slope[:, 0, 0]
    expected = np.linalg.solve(slope, gap[..., None])[..., 0]
    slope[3], slope[4, 0, 0], gap[5, 0] = 0.0, np.inf, np.nan
    with jax.enable_x64(True):
        found = np.asarray(_steps(jax.numpy, slope.transpose(1, 2, 0), gap.T)).T
    assert np.isnan(found[3:6]).all()
    known = np.r_[0:3, 6:50]
    worst = np.linalg.cond(slope[known])[:, None] * np.abs(expected[known]).max(axis=1, keepdims=True)
    assert (np.abs(found[known] - expected[known]) <= 1e-15 * n * worst).all()


@needs_jax
def test_float64_stays_inside() -> None:
    import jax

    compiled, kernel = varied()
    assert kernel.run(compiled.inputs(np.zeros(1)), compiled.parameters).dtype == np.float64
    assert jax.numpy.ones(1).dtype == np.float32
    assert not jax.config.jax_enable_x64


@needs_jax
@pytest.mark.parametrize(("samples", "poses"), [(1, 1), (700, 40)])
def test_reduced_on_the_device(samples: int, poses: int) -> None:
    """Against NumPy over all values; some rockers are too short at some poses, and don't count there."""
    compiled, kernel = varied()
    p, x = lengths(samples, 0.2), compiled.inputs(np.linspace(0.0, 6.0, poses))
    found = reduction()(x, p)
    values = KERNELS["numpy"](kernel.program).over(x, p)
    count = (~np.isnan(values)).sum(axis=1)
    assert np.array_equal(found["count"], count)
    if samples > 1:
        assert (count[0] < samples).any()
    largest = np.nanmax(np.abs(values), axis=(1, 2))[:, None]
    mean = np.nanmean(values, axis=1)
    assert (np.abs(found["mean"] - mean) <= 1e-12 * largest).all()
    squares = np.nansum((values - mean[:, None]) ** 2, axis=1)
    assert (np.abs(found["squares"] - squares) <= 1e-12 * samples * largest**2).all()
    assert (np.abs(found["least"] - np.nanmin(values, axis=1)) <= 1e-12 * largest).all()
    assert (np.abs(found["most"] - np.nanmax(values, axis=1)) <= 1e-12 * largest).all()


@needs_jax
def test_what_never_closes_counts_nothing() -> None:
    compiled, _ = varied()
    p = lengths(5, 0.0)
    p[compiled.graph.parameters.index("c")] = 0.05
    found = reduction()(compiled.inputs(np.zeros(2)), p)
    assert (found["count"][0] == 0).all()
    assert all(np.isnan(found[name][0]).all() for name in ("mean", "least", "most"))
    assert (found["count"][2] == 5).all()


def test_without_jax_a_finding_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing(name: str) -> Any:
        raise ImportError(name)

    monkeypatch.setattr(machine, "import_module", missing)
    program = compiled_from(feeder()).graph.program(["E.x"])
    with pytest.raises(ModelError) as caught:
        JaxKernel(program)
    assert [f.code for f in caught.value.findings] == ["file.needs-package"]
    assert 'pip install "linkwright[gpu]"' in str(caught.value)


def test_the_kernels_are_known_without_importing_their_packages() -> None:
    text = "import sys; from linkwright.kernels import KERNELS; [k.available() for k in KERNELS.values()]"
    check = f"{text}; assert 'jax' in KERNELS; assert not {{'jax', 'llvmlite'}} & {{*sys.modules}}"
    subprocess.run([sys.executable, "-c", check], check=True)


@needs_jax
def test_threads_share_a_kernel() -> None:
    compiled, kernel = varied()
    p, x = lengths(600), compiled.inputs(np.linspace(0, 6, 40))
    expected = kernel.over(x, p)
    with ThreadPoolExecutor(3) as pool:
        for found in pool.map(lambda _: kernel.over(x, p), range(6)):
            assert np.array_equal(found, expected, equal_nan=True)
