"""Sweeps by other runners, other kernels and in other ranges of poses: the same figures."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from linkwright.app.single_study import altered
from linkwright.kernels.registry import KERNELS
from linkwright.studies.sampling_task import SampleWork
from linkwright.studies.sweep.outcome import SweepOutcome
from studies.models import slider_crank

EXAMPLES = Path(__file__).parents[3] / "examples"
VARY = {"r": {"normal": 50, "sigma": 0.5}, "l": {"uniform": [150, 170]}}
MANY: dict[str, Any] = {"vary": VARY, "outputs": ["stroke", "C.x", "motor.torque"], "samples": 4500, "poses": 30}


def document() -> lw.Document:
    studies = {"cycle": {"turns": "1 motor", "samples": 24}}
    return lw.Document.model_validate(slider_crank(measures={"stroke": {"span": "guide.s"}}, studies=studies))


@pytest.fixture(scope="module")
def whole() -> SweepOutcome:
    return lw.sweep(document(), **MANY)


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None) as cluster:
        yield cluster.scheduler_address


def test_a_cluster_gives_the_same_bits(whole: SweepOutcome, address: str) -> None:
    outcome = lw.sweep(document(), **MANY, cluster=address)
    assert outcome.table is not None
    assert whole.table is not None
    np.testing.assert_array_equal(outcome.table.figures, whole.table.figures)
    for text, band in whole.bands.items():
        np.testing.assert_array_equal(outcome.bands[text].mean, band.mean)
        np.testing.assert_array_equal(outcome.bands[text].deviation, band.deviation)


@pytest.mark.parametrize("kernel", KERNELS)
def test_every_kernel_gives_the_same_to_round_off(whole: SweepOutcome, kernel: str) -> None:
    if not KERNELS[kernel].available():
        pytest.skip(f"{kernel} isn't installed")
    outcome = lw.sweep(document(), **MANY, kernel=kernel)
    assert outcome.kernel == kernel
    for text, band in whole.bands.items():
        size = np.abs(band.largest).max()
        np.testing.assert_allclose(outcome.bands[text].mean, band.mean, atol=1e-12 * size, rtol=0)
        np.testing.assert_allclose(outcome.bands[text].largest, band.largest, atol=1e-12 * size, rtol=0)


@pytest.mark.parametrize(
    ("name", "parameter", "signal"),
    [("four_bar", "a", "rocker.angle"), ("crank_cylinder", "AB", None), ("slider_crank_gas", "r", "engine.torque")],
)
def test_ranges_of_poses_are_parts_of_the_whole(name: str, parameter: str, signal: str | None) -> None:
    """An atom computes a range of a sample's poses: what Newton follows comes to the same pose in any, to round-off."""
    given = lw.load(EXAMPLES / f"{name}.yaml")
    compiled = lw.compile(given, EXAMPLES)
    signal = signal or f"{compiled.structure.topology.moving[-1]}.angle"
    value, unit = compiled.quantities.parameters[parameter], compiled.quantities.dimensions.of(parameter)
    size = compiled.quantities.unit_of(unit)[1]
    vary = {parameter: {"normal": value / size, "sigma": abs(value) / size / 1000}}
    files = tuple((path.name, path.read_bytes()) for path in EXAMPLES.glob("*.csv"))
    options = {"vary": vary, "outputs": [signal], "samples": 5, "poses": 60}
    task = SampleWork(altered(given, "sweep", options, ("plan", "samples")), files, "numpy", "sweep").open()
    p = task.varied.parameters(task.plan.values(0))
    every = task.signals.values(p, slice(0, 61))
    assert np.isfinite(every).all()
    for poses in (slice(0, 20), slice(20, 41), slice(41, 61)):
        part = task.signals.values(p, poses)
        np.testing.assert_allclose(part, every[..., poses], rtol=1e-13, atol=1e-13 * np.abs(every).max())
