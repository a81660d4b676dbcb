"""Faults in mid-study: what comes out is complete and equal, or the error is clear and nothing saved is lost."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from blocks.works import Noise, bits, files, folding, storing
from linkwright.blocks import Cluster, Threads, carry
from linkwright.blocks import cluster as cluster_module

TESTS = Path(__file__).parents[1]
PAUSE = 0.1


@pytest.fixture(scope="module")
def expected() -> dict[str, bytes]:
    sink = folding(Noise())
    assert carry(Noise(), sink).done
    return bits(sink.results())


# A worker dies.


def test_a_worker_killed_in_mid_study(cluster: Any, expected: dict[str, bytes]) -> None:
    """Its atoms go to another worker, and so does the work itself; the figures are the same."""
    runner, sink = Cluster(cluster.scheduler_address), folding(Noise())
    work = Noise(pause=PAUSE)
    pids = runner.client.run(os.getpid)

    def kill(done: int, total: int) -> None:
        if done and pids:
            os.kill(pids.popitem()[1], signal.SIGKILL)
            pids.clear()

    outcome = carry(work, sink, runner, kill, block=1)
    runner.close()
    assert outcome.done, outcome
    assert not pids
    assert bits(sink.results()) == expected


def test_a_worker_that_dies_over_an_atom(cluster: Any, tmp_path: Path, expected: dict[str, bytes]) -> None:
    fault = tmp_path / "fault"
    fault.touch()
    work = Noise(fault=fault, at=5)
    runner, sink = Cluster(cluster.scheduler_address), folding(work)
    outcome = carry(work, sink, runner, block=2)
    runner.close()
    assert outcome.done, outcome
    assert not fault.exists()
    assert bits(sink.results()) == expected


def test_atoms_that_kill_every_worker(cluster: Any, tmp_path: Path) -> None:
    """After a few deaths Dask gives up: a finding names atoms (those, or some that were beside them)."""
    fault = tmp_path / "fault"
    fault.touch()
    work = Noise(fault=fault, at=5, always=True)
    runner, sink = Cluster(cluster.scheduler_address), folding(work, tmp_path / "state")
    outcome = carry(work, sink, runner, block=1)
    runner.close()
    assert outcome.error is not None
    assert outcome.error.code == "blocks.workers-died"
    assert f"{outcome.atoms} to {outcome.atoms}" in outcome.error.what
    assert folding(work, tmp_path / "state").next == outcome.atoms <= 5


# The scheduler is lost, or was never there.


def test_a_scheduler_lost_in_mid_study(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("distributed")
    program = "import sys; from distributed import LocalCluster\n"
    program += "if __name__ == '__main__':\n"
    program += "    c = LocalCluster(n_workers=1, threads_per_worker=1, processes=False, dashboard_address=':0',"
    program += " protocol='tcp', host='127.0.0.1')\n"
    program += "    print(c.scheduler_address, flush=True)\n    sys.stdin.read()\n"
    with _process("-c", program, stdin=subprocess.PIPE) as scheduler:
        assert scheduler.stdout is not None
        runner = Cluster(scheduler.stdout.readline().strip())
        work = Noise(pause=PAUSE)
        told: list[int] = []

        def kill(done: int, total: int) -> None:
            told.append(done)
            if len(told) == 4:
                scheduler.kill()

        outcome = carry(work, folding(work, tmp_path / "state"), runner, kill, block=1)
        runner.close()
    assert outcome.error is not None
    assert outcome.error.code == "blocks.cluster-lost"
    assert not outcome.interrupted
    assert folding(work, tmp_path / "state").next == outcome.atoms >= 3
    assert carry(work, folding(work, tmp_path / "state")).done
    assert "Traceback" not in capfd.readouterr().err


@pytest.mark.parametrize("address", ["tcp://127.0.0.1:1", "nonsense", "carrier-pigeon://x:1", "tcp://", ""])
def test_no_scheduler_at_an_address(address: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("distributed")
    monkeypatch.setattr(cluster_module, "PATIENCE", 0.3)
    outcome = carry(Noise(), folding(Noise()), Cluster(address))
    assert outcome.error is not None
    assert outcome.error.code == "blocks.cluster-unreachable"
    assert outcome.error.data["address"] == address
    assert outcome.atoms == 0


def test_a_scheduler_without_workers(monkeypatch: pytest.MonkeyPatch) -> None:
    distributed = pytest.importorskip("distributed")
    monkeypatch.setattr(cluster_module, "IDLE", 0.2)
    monkeypatch.setattr(cluster_module, "RECOUNT", 0.0)
    empty = distributed.LocalCluster(
        n_workers=0, processes=False, dashboard_address=":0", protocol="tcp", host="127.0.0.1"
    )
    runner = Cluster(empty.scheduler_address)
    outcome = carry(Noise(), folding(Noise()), runner)
    runner.close()
    empty.close(timeout=5)
    assert outcome.error is not None
    assert outcome.error.code == "blocks.cluster-idle"


# The process is killed or interrupted.


def _process(*words: Any, **options: Any) -> subprocess.Popen[str]:
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(TESTS), *sys.path])}
    return subprocess.Popen(
        [sys.executable, *map(str, words)], stdout=subprocess.PIPE, encoding="utf-8", env=environment, **options
    )


def _until(process: subprocess.Popen[str], atoms: int) -> None:
    """Wait until so many atoms are taken: a line each, after one at the start."""
    assert process.stdout is not None
    seen = -1
    while seen < atoms:
        line = process.stdout.readline()
        assert line, "the process ended"
        seen += line.startswith("done")


def _complete(folder: Path, expected: dict[str, bytes]) -> None:
    """Resume in this process; everything is equal to what an undisturbed study gives."""
    work = Noise(pause=PAUSE)
    sink, store = folding(work, folder / "state"), storing(work, folder / "values.zarr")
    assert 0 < sink.next < 12
    assert carry(work, sink, Threads(4)).done
    assert carry(work, store, Threads(4)).done
    assert bits(sink.results()) == expected
    plain = storing(Noise(), folder / "plain.zarr")
    assert carry(Noise(), plain).done
    assert files(folder / "values.zarr") == files(folder / "plain.zarr")


def test_a_killed_process_is_resumed(tmp_path: Path, expected: dict[str, bytes]) -> None:
    with _process("-m", "blocks.process", tmp_path, PAUSE) as process:
        _until(process, 4)
        process.kill()
    _complete(tmp_path, expected)


@pytest.mark.skipif(os.name != "posix", reason="sends SIGINT")
def test_an_interrupt_finishes_what_is_at_work_and_saves(tmp_path: Path, expected: dict[str, bytes]) -> None:
    with _process("-m", "blocks.process", tmp_path, PAUSE, stderr=subprocess.PIPE) as process:
        _until(process, 4)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=20)
    outcome = json.loads(out.splitlines()[-1])
    assert (process.returncode, err) == (0, "")
    assert outcome["interrupted"]
    assert not outcome["done"]
    assert folding(Noise(pause=PAUSE), tmp_path / "state").next == outcome["atoms"]
    _complete(tmp_path, expected)


@pytest.mark.skipif(os.name != "posix", reason="sends SIGINT")
def test_an_interrupt_of_a_cluster_study(cluster: Any, tmp_path: Path, expected: dict[str, bytes]) -> None:
    """The rest is taken back from the cluster, which stays fit for the next study."""
    runner, work, count = Cluster(cluster.scheduler_address), Noise(pause=PAUSE), 0

    def interrupt(done: int, total: int) -> None:
        nonlocal count
        count += 1
        if count == 4:
            os.kill(os.getpid(), signal.SIGINT)

    outcome = carry(work, folding(work, tmp_path / "state"), runner, interrupt, block=1)
    assert outcome.interrupted
    assert outcome.error is None
    assert 3 <= outcome.atoms < 12
    sink = folding(work, tmp_path / "state")
    assert sink.next == outcome.atoms
    assert carry(work, sink, runner, block=1).done
    runner.close()
    assert bits(sink.results()) == expected


@pytest.mark.skipif(os.name != "posix", reason="sends SIGINT")
def test_a_second_interrupt_leaves_with_what_was_saved(tmp_path: Path) -> None:
    work = Noise()
    sink = folding(work, tmp_path / "state")
    sink.take(0, work.open().perform(0))
    sink.save()

    def twice(done: int, total: int) -> None:
        if done > 300_000:
            os.kill(os.getpid(), signal.SIGINT)
            os.kill(os.getpid(), signal.SIGINT)

    outcome = carry(work, sink, Threads(1), twice)
    assert outcome.interrupted
    assert folding(work, tmp_path / "state").next == 1
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
