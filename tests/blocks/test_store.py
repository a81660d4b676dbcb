"""Results in a Zarr store: the same files whoever writes them, whole or resumed, also where the disk is full."""

from __future__ import annotations

import errno
import gc
import os
import subprocess
import sys
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import linkwright
from blocks.works import CUT, Noise, files, storing, values
from linkwright.blocks import UNIT, Cluster, Cut, Threads, carry
from linkwright.blocks.store import Stored, Variable, stored_name
from linkwright.findings import ModelError

zarr = pytest.importorskip("zarr")
WORK = Noise()


@pytest.fixture(scope="module")
def expected(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    path = tmp_path_factory.mktemp("store") / "values.zarr"
    sink = storing(WORK, path)
    for atom in range(CUT.atoms):
        sink.take(atom, WORK.open().perform(atom))
    return files(path)


def test_values_are_the_works(tmp_path: Path) -> None:
    xarray = pytest.importorskip("xarray")
    path = tmp_path / "values.zarr"
    assert carry(WORK, storing(WORK, path, attributes={"title": "noise"})).done
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        data = xarray.open_zarr(path)
    assert data.attrs["title"] == "noise"
    assert data.a.dims == data.b.dims == ("sample", "pose")
    assert (data.a.units, data.b.units, data.pose.units) == ("mm", "1", "rad")
    assert np.array_equal(data.pose, np.arange(CUT.poses) / 10)
    assert (data.a.chunks[0][0], data.a.chunks[1][0]) == (UNIT, CUT.width)
    for atom in range(CUT.atoms):
        at = CUT.sample_slice(atom), CUT.pose_slice(atom)
        assert np.array_equal(np.stack([data.a[at], data.b[at]]), values(WORK, atom), equal_nan=True)


@pytest.mark.parametrize("workers", [1, 4])
@pytest.mark.parametrize("block", [1, 5])
def test_files_are_the_same_by_threads(workers: int, block: int, tmp_path: Path, expected: dict[str, bytes]) -> None:
    assert carry(WORK, storing(WORK, tmp_path / "z"), Threads(workers), block=block).done
    assert files(tmp_path / "z") == expected


def test_files_are_the_same_by_a_cluster(cluster: Any, tmp_path: Path, expected: dict[str, bytes]) -> None:
    runner = Cluster(cluster.scheduler_address)
    assert carry(WORK, storing(WORK, tmp_path / "z"), runner, block=1).done
    runner.close()
    assert files(tmp_path / "z") == expected


@pytest.mark.parametrize("stop", [0, 1, 5, 11])
def test_files_are_the_same_resumed(stop: int, tmp_path: Path, expected: dict[str, bytes]) -> None:
    """Also where an atom more was written than counted."""
    sink = storing(WORK, tmp_path / "z")
    for atom in range(stop):
        sink.take(atom, WORK.open().perform(atom))
    sink.save()
    sink.take(stop, WORK.open().perform(stop))
    again = storing(WORK, tmp_path / "z")
    assert again.next == stop
    assert carry(WORK, again).done
    assert files(tmp_path / "z") == expected
    assert carry(WORK, storing(WORK, tmp_path / "z")).poses == 0


def test_a_store_begun_twice_loses_nothing(tmp_path: Path, expected: dict[str, bytes]) -> None:
    """A second one on the same store, before the first one has counted anything, doesn't wipe its chunks."""
    first = storing(WORK, tmp_path / "z")
    for atom in range(3):
        first.take(atom, WORK.open().perform(atom))
    storing(WORK, tmp_path / "z")
    for atom in range(3, CUT.atoms):
        first.take(atom, WORK.open().perform(atom))
    first.save()
    assert files(tmp_path / "z") == expected


@pytest.mark.parametrize("harm", ["gone", "cut", "begun anew"])
def test_holes_are_found_at_the_end_and_filled(harm: str, tmp_path: Path, expected: dict[str, bytes]) -> None:
    """By the chunks' files: their values are NaN in places, and one of the atoms here has no other."""
    path, work = tmp_path / "z", WORK.open()
    sink = storing(WORK, path)
    for atom in range(CUT.atoms):
        sink.take(atom, work.perform(atom))
        if atom == 6 and harm == "begun anew":  # by this process: others are kept out
            storing(WORK, path, anew=True)
    chunk = path / "a" / "c" / "1" / "2"
    if harm == "gone":
        chunk.unlink()
    elif harm == "cut":
        chunk.write_bytes(chunk.read_bytes()[:-8])
    outcome = carry(WORK, sink)
    assert outcome.error is not None
    assert (outcome.error.code, outcome.done) == ("blocks.holes", False)
    again = storing(WORK, path)
    assert again.next == (0 if harm == "begun anew" else 5)
    assert carry(WORK, again).done
    assert files(path) == expected


def test_atoms_without_any_value_are_no_holes(tmp_path: Path) -> None:
    cut = Cut(10, 4)
    sink = Stored(tmp_path / "z", "key", cut, [Variable("a")])
    sink.take(0, {"a": np.full((10, 4), np.nan)})
    sink.save()


FILLING = """\
import sys
from pathlib import Path
from blocks.works import Noise, storing
sink = storing(Noise(), Path(sys.argv[1]))
print("ready", flush=True)
sys.stdin.read()
"""


def test_a_store_that_another_process_fills_is_refused(tmp_path: Path, expected: dict[str, bytes]) -> None:
    """Until that process ends, however it ends; afterwards no trace of the lock is left."""
    path = tmp_path / "z"
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(Path(__file__).parents[1]), *sys.path])}
    command = [sys.executable, "-c", FILLING, str(path)]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=environment) as other:
        assert other.stdout is not None
        other.stdout.readline()
        for anew in (False, True):
            with pytest.raises(ModelError) as refused:
                storing(WORK, path, anew=anew)
            assert [finding.code for finding in refused.value.findings] == ["blocks.busy"]
        other.kill()
    assert carry(WORK, storing(WORK, path)).done
    assert files(path) == expected
    assert {found.name for found in tmp_path.iterdir()} == {"z", "z.checkpoint"}


def test_a_store_names_the_versions_that_wrote_it_and_others_are_refused(tmp_path: Path) -> None:
    sink = storing(WORK, tmp_path / "z", versions={"kernel": "abacus 1"})
    sink.take(0, WORK.open().perform(0))
    sink.save()
    attributes = zarr.open_group(tmp_path / "z", mode="r").attrs.asdict()
    assert attributes == {"linkwright": linkwright.__version__, "kernel": "abacus 1"}
    with pytest.raises(ModelError) as refused:
        storing(WORK, tmp_path / "z", versions={"kernel": "abacus 2"})
    (finding,) = refused.value.findings
    assert finding.code == "blocks.other-version"
    assert "started with kernel abacus 1; this is kernel abacus 2" in finding.what
    assert storing(WORK, tmp_path / "z", versions={"kernel": "abacus 2"}, anew=True).next == 0


def test_a_store_that_was_half_made_is_made_again(
    tmp_path: Path, expected: dict[str, bytes], monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(path: Path) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(zarr, "consolidate_metadata", interrupted)
        with pytest.raises(KeyboardInterrupt):
            storing(WORK, tmp_path / "z")
    assert carry(WORK, storing(WORK, tmp_path / "z")).done
    assert files(tmp_path / "z") == expected


# A full disk.


class Full:
    """Stands before an array of the store; a write after so many bytes finds no space."""

    def __init__(self, array: Any, space: int) -> None:
        self.array, self.space = array, space

    def __setitem__(self, at: Any, value: Any) -> None:
        self.space -= value.nbytes
        if self.space < 0:
            raise OSError(errno.ENOSPC, "No space left on device")
        self.array[at] = value


def test_a_disk_that_fills_up(tmp_path: Path, expected: dict[str, bytes]) -> None:
    sink = storing(WORK, tmp_path / "z")
    sink._arrays["b"] = Full(sink._arrays["b"], 3_000_000)
    outcome = carry(WORK, sink, every=1000.0)
    assert outcome.error is not None
    assert outcome.error.code == "blocks.no-space"
    assert outcome.atoms == 3
    again = storing(WORK, tmp_path / "z")
    assert again.next == 3
    assert carry(WORK, again).done
    assert files(tmp_path / "z") == expected


@pytest.fixture
def small(tmp_path: Path) -> Iterator[Path]:
    """A file system of 4 MB, where one may be mounted."""
    folder = tmp_path / "small"
    folder.mkdir()
    try:
        made = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=4m", "tmpfs", str(folder)], capture_output=True)
    except OSError:
        pytest.skip("there is no mount")
    if made.returncode:
        pytest.skip("no file system may be mounted here")
    yield folder
    gc.collect()  # what holds a file open there keeps it busy
    subprocess.run(["umount", str(folder)], check=True)


def test_a_file_system_that_fills_up(small: Path, expected: dict[str, bytes]) -> None:
    """Every atom that was written counts; after space is made (a larger size), the rest follows."""
    outcome = carry(WORK, storing(WORK, small / "z"), every=1000.0)
    assert outcome.error is not None
    assert outcome.error.code == "blocks.no-space"
    assert os.strerror(errno.ENOSPC) in outcome.error.what
    again = storing(WORK, small / "z")
    assert again.next == outcome.atoms == 2  # 1.6 MB each
    assert not carry(WORK, again).done
    subprocess.run(["mount", "-o", "remount,size=40m", str(small)], check=True)
    again = storing(WORK, small / "z")
    assert again.next == 2
    assert carry(WORK, again).done
    assert files(small / "z") == expected


# Stores that are something else.


def code(path: Path, work: Noise = WORK, **options: Any) -> str:
    with pytest.raises(ModelError) as caught:
        storing(work, path, **options)
    return caught.value.findings[0].code


def test_what_is_there_already_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "z").mkdir()
    (tmp_path / "z" / "diary").write_text("mine")
    assert code(tmp_path / "z") == "file.exists"
    assert (tmp_path / "z" / "diary").read_text() == "mine"


def test_the_store_of_another_work(tmp_path: Path) -> None:
    carry(WORK, storing(WORK, tmp_path / "z"))
    assert code(tmp_path / "z", Noise(seed=9)) == "blocks.other-work"
    assert carry(Noise(seed=9), storing(Noise(seed=9), tmp_path / "z", anew=True)).poses > 0


def test_a_store_gone_or_damaged_beside_its_checkpoint(tmp_path: Path) -> None:
    carry(WORK, storing(WORK, tmp_path / "z"))
    (tmp_path / "z" / "zarr.json").write_text("{")
    assert code(tmp_path / "z") == "blocks.corrupt"
    (tmp_path / "z").rename(tmp_path / "elsewhere")
    assert code(tmp_path / "z") == "blocks.corrupt"


def test_a_place_that_cannot_be_written(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    assert code(tmp_path / "file" / "z") == "blocks.unwritable"


def test_samples_have_coordinates_of_their_own(tmp_path: Path) -> None:
    """Given by the first range of poses of each unit; names that no file may have are spelled out."""
    xarray = pytest.importorskip("xarray")
    cut = Cut(UNIT + 3, 40)
    names = [Variable("AB/CD", ("sample",), "m", coordinate=True), Variable("curve 曲")]
    sink = Stored(tmp_path / "z", "key", cut, names)
    for atom in range(cut.atoms):
        drawn = np.arange(cut.sample_slice(atom).start, cut.sample_slice(atom).stop, dtype=float)
        poses = cut.pose_slice(atom)
        result = {"curve 曲": np.outer(drawn, np.arange(poses.start, poses.stop))}
        sink.take(atom, result if cut.range(atom) else {**result, "AB/CD": drawn})
    data = xarray.open_zarr(tmp_path / "z")
    assert stored_name("AB/CD") == "AB_u002fCD"
    assert np.array_equal(data.coords["AB_u002fCD"], np.arange(UNIT + 3))
    assert data["curve_u0020曲"].attrs["long_name"] == "curve 曲"
    assert np.array_equal(data["curve_u0020曲"], np.outer(np.arange(UNIT + 3), np.arange(40)))
