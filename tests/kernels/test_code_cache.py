"""Compiled kernels are kept for the next process; a damaged one is made anew, and none is needed to go on."""

from __future__ import annotations

import importlib.util
import os
import py_compile
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest

from linkwright.kernels import code_cache

pytest.importorskip("numba")

posix = pytest.mark.skipif(os.name != "posix", reason="owners, modes and links are POSIX's")

PROGRAM = """
import numpy as np, sys
from helpers.compiled import compiled_from
from helpers.examples import four_bar
from linkwright.kernels.numba_kernel import NumbaKernel
compiled = compiled_from(four_bar())
kernel = NumbaKernel(compiled.graph.program(["C.x", "C.y"]))
print(kernel.is_cached())
found = kernel.run(compiled.inputs(np.linspace(0, 6, 500)), compiled.parameters)
print(sum(kernel.compiled("apart").stats.cache_misses.values()))
print(found.tobytes().hex())
"""


def process(cache: Path) -> tuple[bool, int, str]:
    """Run a kernel in a process of its own: whether it was kept, how often Numba compiled it, the figures."""
    folders = [str(Path(__file__).parents[1]), *sys.path]
    environment = os.environ | {"LINKWRIGHT_CACHE": str(cache), "PYTHONPATH": os.pathsep.join(folders)}
    done = subprocess.run([sys.executable, "-c", PROGRAM], env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    kept, compiled, figures = done.stdout.split()
    return kept == "True", int(compiled), figures


def test_the_second_process_does_not_compile_again(tmp_path: Path) -> None:
    first, second = process(tmp_path), process(tmp_path)
    assert (first[:2], second[:2]) == ((False, 1), (True, 0))
    assert first[2] == second[2]
    assert not list(tmp_path.rglob("new-*"))


@posix
def test_a_mask_that_lets_the_group_write_is_no_hindrance(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The usual one where each user has a group; folders of earlier versions were made under it too."""
    monkeypatch.delenv("LINKWRIGHT_CACHE")
    monkeypatch.setattr(code_cache, "folder", lambda: tmp_path / "linkwright")
    made: list[Path | None] = []

    def read(source: str, path: Path | None, name: str) -> ModuleType:
        made.append(path)
        return code_cache.module_at(source, path, name)

    before = os.umask(0o002)
    try:
        (tmp_path / "linkwright").mkdir()
        for _ in range(2):
            code_cache.load("a = 1", "", read)
    finally:
        os.umask(before)
    assert [path is not None and path.parent.name.startswith("new-") for path in made] == [True, False]


@pytest.mark.parametrize("pattern", ["*.nbc", "*.nbi", "kernel.py", code_cache.SUMS])
@pytest.mark.parametrize("harm", ["cut", "flipped", "gone"])
def test_a_damaged_kernel_is_made_anew(pattern: str, harm: str, tmp_path: Path) -> None:
    """Any file of it, found out by its checksum before it is loaded."""
    place = tmp_path / "kernels" / "name"
    (place / "__pycache__").mkdir(parents=True)
    for name in ("kernel.py", "__pycache__/a.nbi", "__pycache__/a.nbc"):
        (place / name).write_bytes(bytes(range(100)))
    code_cache._write_sums(place)
    assert code_cache._sound(place)
    (file,) = place.rglob(pattern)
    data = file.read_bytes()
    if harm == "gone":
        file.unlink()
    else:
        file.write_bytes(data[:50] if harm == "cut" else data[:10] + bytes([data[10] ^ 1]) + data[11:])
    assert not code_cache._sound(place)


def test_figures_after_damage_are_the_same(tmp_path: Path) -> None:
    first = process(tmp_path)
    (machine_code,) = tmp_path.rglob("*.nbc")
    machine_code.write_bytes(machine_code.read_bytes()[:-100] + bytes(100))
    assert process(tmp_path) == (True, 1, first[2])  # there, but not sound: compiled again
    assert process(tmp_path) == (True, 0, first[2])


def test_a_cache_that_cannot_be_written_is_done_without(tmp_path: Path) -> None:
    file = tmp_path / "file"
    file.write_text("not a folder")
    assert process(file / "cache")[:2] == (False, 1)


def test_the_oldest_kernels_go(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(code_cache, "MOST", 2)
    for age in range(4):
        (tmp_path / f"k{age}").mkdir()
        os.utime(tmp_path / f"k{age}", (1000 - age, 1000 - age))
    code_cache._prune(tmp_path)
    assert sorted(place.name for place in tmp_path.iterdir()) == ["k0", "k1"]


def test_the_place_follows_the_content(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("LINKWRIGHT_CACHE", str(tmp_path))
    assert len({code_cache.name_of(*words) for words in (("a", "x"), ("b", "x"), ("a", "y"), ("a", "x"))}) == 3
    place = tmp_path / "kernels" / code_cache.name_of("a", "x")
    assert not code_cache.is_cached("a", "x")
    place.mkdir(parents=True)
    assert code_cache.is_cached("a", "x")


NOBODY = """
import pwd
def unknown(number):
    raise KeyError(number)
pwd.getpwuid = unknown
"""
NOWHERE = """
import tempfile
def unusable(*given):
    raise FileNotFoundError(2, "No usable temporary directory found")
tempfile._get_default_tempdir = unusable
"""


@posix
def test_no_home_and_no_temporary_folder(tmp_path: Path) -> None:
    """A user without a home, on a machine without a folder for temporary files: compiled, and not kept."""
    folders = [str(Path(__file__).parents[1]), *sys.path]
    environment = {name: value for name, value in os.environ.items() if name != "HOME"}
    environment |= {"LINKWRIGHT_CACHE": "", "XDG_CACHE_HOME": "", "PYTHONPATH": os.pathsep.join(folders)}
    command = [sys.executable, "-c", NOBODY + NOWHERE + PROGRAM]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert done.stdout.split()[:2] == ["False", "1"]


def read(source: str, path: Path | None, name: str) -> ModuleType:
    """What stands in for the compiler."""
    return code_cache.module_at(source, path, name)


SOURCE = "value = 1\n"


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with one kernel kept."""
    monkeypatch.setenv("LINKWRIGHT_CACHE", str(tmp_path / "cache"))
    assert code_cache.load(SOURCE, "", read).value == 1
    assert code_cache.is_cached(SOURCE, "")
    return tmp_path / "cache"


def used(source: str = SOURCE) -> bool:
    """Whether the module comes from the folder of kept kernels."""
    module = code_cache.load(source, "", read)
    assert module.value == 1
    folder = code_cache.folder()
    assert folder is not None
    place = folder / "kernels" / code_cache.name_of(source, "")
    return module.__file__ == str(place / "kernel.py")


def test_what_is_kept_is_taken(cache: Path) -> None:
    assert used()
    assert (cache.stat().st_mode & 0o777, (cache / "kernels").stat().st_mode & 0o777) == (0o700, 0o700)


@posix
@pytest.mark.parametrize("place", ["", "kernels"])
@pytest.mark.parametrize("mode", [0o770, 0o707])
def test_a_folder_that_others_may_write_to_is_not_used(cache: Path, place: str, mode: int) -> None:
    (cache / place).chmod(mode)
    before = sorted(cache.rglob("*"))
    assert not used()
    assert sorted(cache.rglob("*")) == before  # nor written to


@posix
def test_a_folder_that_others_may_replace_is_not_used(cache: Path) -> None:
    cache.parent.chmod(0o777)
    assert not used()
    cache.parent.chmod(0o1777)  # as /tmp is: only the owner may
    assert used()


@posix
@pytest.mark.parametrize("place", ["", "kernels"])
def test_a_link_is_not_used(cache: Path, place: str) -> None:
    folder = cache / place
    folder.rename(cache.parent / "elsewhere")
    folder.symlink_to(cache.parent / "elsewhere")
    assert not used()


@posix
def test_the_folder_of_another_user_is_not_used(cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(code_cache.os, "geteuid", lambda: os.getuid() + 1)
    assert not used()


@posix
def test_files_for_others_to_write_or_links_within_a_kernel_are_made_anew(cache: Path) -> None:
    (file,) = cache.rglob("kernel.py")
    file.chmod(0o666)
    assert not code_cache._sound(file.parent)
    assert not used()
    assert used()  # kept anew
    file.rename(cache / "kernel.py")
    file.symlink_to(cache / "kernel.py")
    assert not code_cache._sound(file.parent)
    assert not used()
    assert used()


@posix
def test_a_link_in_the_place_of_a_kernel_goes_and_what_it_leads_to_stays(cache: Path, tmp_path: Path) -> None:
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "file").write_text("mine")
    (place,) = (cache / "kernels").iterdir()
    place.rename(tmp_path / "away")
    place.symlink_to(tmp_path / "mine")
    assert not used()
    assert (tmp_path / "mine" / "file").read_text() == "mine"
    assert used()


def test_bytecode_is_neither_run_nor_left(cache: Path) -> None:
    """A ``.pyc`` that says another thing, with the source's time and size, as Python would take it."""
    (file,) = cache.rglob("kernel.py")
    assert not list(cache.rglob("*.pyc"))
    (file.parent / "other.py").write_text("value = 2\n")
    os.utime(file.parent / "other.py", (file.stat().st_atime, file.stat().st_mtime))
    planted = importlib.util.cache_from_source(str(file))
    py_compile.compile(str(file.parent / "other.py"), cfile=planted, dfile=str(file))
    (file.parent / "other.py").unlink()
    assert not used()
    assert used() and not list(cache.rglob("*.pyc"))


def test_the_source_is_the_one_given(cache: Path) -> None:
    """Whatever stands in the file, with checksums to fit."""
    (file,) = cache.rglob("kernel.py")
    file.write_text("value = 2\n")
    code_cache._write_sums(file.parent)
    assert used()
