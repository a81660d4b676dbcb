"""Every runner, size of block and interruption gives the same bits."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any
from uuid import uuid4

import numpy as np
import pytest

from blocks.works import CUT, REDUCTIONS, Noise, bits, folding, values
from linkwright._machine import processors
from linkwright.blocks import Cluster, Cut, Folding, Threads, Together, carry
from linkwright.blocks.loop import suited
from linkwright.blocks.runners import RUNNERS, Runner, opened, register
from linkwright.findings import Finding, ModelError

WORK = Noise()


@pytest.fixture(scope="module")
def expected() -> dict[str, bytes]:
    """The figures of a plain loop."""
    sink, task = folding(WORK), WORK.open()
    for atom in range(task.atoms):
        sink.take(atom, task.perform(atom))
    return bits(sink.results())


def carried(work: Noise, runner: Runner | None = None, **options: Any) -> dict[str, bytes]:
    sink = folding(work)
    outcome = carry(work, sink, runner, **options)
    assert outcome.done, outcome
    assert (outcome.atoms, outcome.total, outcome.poses) == (12, 12, CUT.samples * CUT.poses)
    assert outcome.seconds > 0
    return bits(sink.results())


@pytest.mark.parametrize("workers", [None, 1, 2, 4])
@pytest.mark.parametrize("block", [None, 1, 5, 100])
def test_threads(workers: int | None, block: int | None, expected: dict[str, bytes]) -> None:
    assert carried(WORK, Threads(workers), block=block) == expected


@pytest.mark.parametrize("block", [None, 1, 5])
def test_cluster(cluster: Any, block: int | None, expected: dict[str, bytes]) -> None:
    runner = Cluster(cluster.scheduler_address)
    assert carried(WORK, runner, block=block) == expected
    runner.close()
    runner.close()


def test_figures_are_those_of_all_samples(expected: dict[str, bytes]) -> None:
    """Folded over units and put together over ranges: the figures of the whole array of values."""
    y = np.full((2, CUT.samples, CUT.poses), np.inf)
    for atom in range(CUT.atoms):
        y[:, CUT.sample_slice(atom), CUT.pose_slice(atom)] = values(WORK, atom)
    mean, least = (np.frombuffer(expected[f"m.{key}"]).reshape(2, CUT.poses) for key in ("mean", "least"))
    deviation = np.frombuffer(expected["m.deviation"]).reshape(2, CUT.poses)
    assert np.allclose(mean, np.nanmean(y, axis=1), rtol=1e-12, atol=1e-14)
    assert np.allclose(deviation, np.nanstd(y, axis=1, ddof=1), rtol=1e-12)
    assert np.array_equal(least, np.nanmin(y, axis=1))
    at = np.frombuffer(expected["m.least_at"], np.int64).reshape(2, CUT.poses)
    assert np.array_equal(at, np.nanargmin(y, axis=1))


@pytest.mark.parametrize("stop", range(12))
def test_a_study_resumed_at_any_atom(stop: int, tmp_path: Path, expected: dict[str, bytes]) -> None:
    path = tmp_path / "state"
    first, task = folding(WORK, path), opened(WORK)
    for atom in range(stop):
        first.take(atom, task.perform(atom))
    first.save()
    second = folding(WORK, path)
    assert second.next == stop
    outcome = carry(WORK, second)
    assert outcome.poses == sum(map(CUT.size, range(stop, 12)))
    assert bits(second.results()) == expected
    again = folding(WORK, path)
    assert carry(WORK, again).poses == 0
    assert bits(again.results()) == expected


def test_progress_is_told_from_where_the_work_stands(tmp_path: Path) -> None:
    sink = folding(WORK, tmp_path / "state")
    sink.take(0, opened(WORK).perform(0))
    told: list[tuple[int, int]] = []
    carry(WORK, sink, progress=lambda done, total: told.append((done, total)))
    total = CUT.samples * CUT.poses
    assert told[0] == (CUT.size(0), total)
    assert told[-1] == (total, total)
    assert len(told) == 12
    assert told == sorted(told)


def test_saves_come_by_the_clock_and_at_the_end(tmp_path: Path) -> None:
    class Counting(Folding):
        saves = 0

        def save(self) -> None:
            self.saves += 1

    often, seldom = Counting(CUT, REDUCTIONS), Counting(CUT, REDUCTIONS)
    carry(WORK, often, every=0.0)
    carry(WORK, seldom, every=1000.0)
    assert often.saves > 2
    assert seldom.saves == 1


@pytest.mark.parametrize("runner", [Threads(2), None], ids=["threads", "cluster"])
def test_few_atoms_are_under_way(runner: Runner | None, cluster: Any, tmp_path: Path) -> None:
    """A slow sink holds the workers back, so that memory stays flat."""
    runner = runner or Cluster(cluster.scheduler_address)
    begun = tmp_path / "begun"
    begun.mkdir()
    work = Touching(seed=5, fault=begun)
    most = 0
    results = runner.results(work, opened(work), range(12), 1, lambda: False)
    for atom, _ in results:
        most = max(most, len(list(begun.iterdir())) - atom)
    assert most <= 2 * 2 + 1
    runner.close()


class Touching(Noise):
    """Leaves a file for each atom begun."""

    def open(self) -> Any:
        task, folder = super().open(), self.fault

        class Task:
            atoms, poses = task.atoms, task.poses

            def perform(self, atom: int) -> Any:
                (folder / str(atom)).touch()
                return {}

        return Task()


def test_a_fault_of_the_work_itself_is_raised_and_the_rest_saved(tmp_path: Path) -> None:
    class Faulty(Noise):
        def open(self) -> Any:
            task = super().open()

            class Task:
                atoms, poses = task.atoms, task.poses

                def perform(self, atom: int) -> Any:
                    if atom == 7:
                        raise ZeroDivisionError
                    return task.perform(atom)

            return Task()

    work = Faulty(seed=2)
    with pytest.raises(ZeroDivisionError):
        carry(work, folding(work, tmp_path / "state"), Threads(2))
    assert folding(work, tmp_path / "state").next == 7


def test_a_finding_of_the_work_is_the_outcome(tmp_path: Path) -> None:
    class Refused(Noise):
        def open(self) -> Any:
            raise ModelError([Finding("file.needs-package", (), {"package": "x", "extra": "y"})])

    outcome = carry(Refused(seed=3), folding(Noise(seed=3)))
    assert not outcome.done
    assert outcome.error is not None
    assert outcome.error.code == "file.needs-package"


def test_sinks_together_go_on_each_where_it_stands(tmp_path: Path, expected: dict[str, bytes]) -> None:
    ahead, behind = folding(WORK), folding(WORK)
    for atom in range(4):
        ahead.take(atom, opened(WORK).perform(atom))
    both = Together([ahead, behind])
    assert both.next == 0
    assert carry(WORK, both).done
    assert bits(ahead.results()) == bits(behind.results()) == expected


def test_no_work_is_done_at_once() -> None:
    work = Noise(cut=Cut(0, 5))
    outcome = carry(work, folding(work))
    assert outcome.done
    assert outcome.total == 0


def test_figures_before_the_first_unit_is_done() -> None:
    sink = folding(WORK)
    sink.take(0, opened(WORK).perform(0))
    with pytest.raises(ValueError, match="without a sample"):
        sink.results()


def test_blocks_grow_with_the_work_but_keep_all_busy() -> None:
    def work(atoms: int, poses: int) -> Any:
        return type("T", (), {"atoms": atoms, "poses": lambda self, atom: poses})()

    assert suited(work(1000, 1 << 20), range(1000), Threads(2)) == 1
    assert suited(work(100_000, 4096), range(100_000), Threads(2)) == 256
    assert suited(work(80, 1), range(80), Threads(2)) == 10
    assert suited(work(3, 1), range(3), Threads(2)) == 1


def test_runners_by_name() -> None:
    assert {"threads": Threads, "cluster": Cluster} == RUNNERS
    with pytest.raises(ValueError, match="threads"):
        register(Threads)
    assert Threads().workers == processors() >= 1
    with pytest.raises(ValueError, match="worker"):
        Threads(0)


def test_a_task_is_opened_once_and_the_last_few_kept() -> None:
    count = 0

    class Once(Noise):
        def open(self) -> Any:
            nonlocal count
            count += 1
            return super().open()

    assert opened(Once(seed=100)) is opened(Once(seed=100))
    assert count == 1
    for seed in range(101, 105):
        opened(Once(seed=seed))
    opened(Once(seed=100))
    assert count == 6


class Opening(Noise):
    """Leaves a file each time it is opened."""

    def open(self) -> Any:
        assert self.fault is not None
        (self.fault / f"{os.getpid()}-{uuid4()}").touch()
        return super().open()


def test_a_worker_opens_a_work_once(cluster: Any, tmp_path: Path) -> None:
    work = Opening(fault=tmp_path)
    runner = Cluster(cluster.scheduler_address)
    assert carry(work, folding(work), runner, block=1).done
    pids = [path.name.split("-")[0] for path in tmp_path.iterdir()]
    assert 2 <= len(pids) == len(set(pids)) <= 1 + len(runner.client.nthreads())
    runner.close()
