"""Compiled kernels are kept for the next process; a damaged one is made anew, and none is needed to go on."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from linkwright.kernels import code_cache

pytest.importorskip("numba")

PROGRAM = """
import numpy as np, sys
from helpers.compiled import compiled_from
from helpers.examples import four_bar
from linkwright.kernels.numba_kernel import NumbaKernel
compiled = compiled_from(four_bar())
kernel = NumbaKernel(compiled.graph.program(["C.x", "C.y"]))
print(kernel.kept())
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
    places = {code_cache.kept(*words) for words in (("a", "x"), ("b", "x"), ("a", "y"))}
    assert len(places) == 3
    assert code_cache.kept("a", "x") in places
    assert all(place.parent == tmp_path / "kernels" for place in places)
