"""The WebAssembly module of a program: its form and its memory; the bits are compared in test_emitted.py."""

from __future__ import annotations

import gzip
from typing import Any

import numpy as np
import pytest
import run

from helpers.programs import EVERY, rows_of
from linkwright.compilation import compile_mechanism
from linkwright.kernels.webassembly_code import signed, unsigned
from linkwright.kernels.webassembly_module import PAGE, webassembly
from linkwright.model.document import load


@pytest.mark.parametrize(
    ("number", "made"),
    [(0, "00"), (1, "01"), (127, "7f"), (128, "8001"), (624485, "e58e26"), (2**32 - 1, "ffffffff0f")],
)
def test_whole_numbers(number: int, made: str) -> None:
    assert unsigned(number).hex() == made


@pytest.mark.parametrize(
    ("number", "made"),
    [(0, "00"), (63, "3f"), (64, "c000"), (-1, "7f"), (-64, "40"), (-65, "bf7f"), (-123456, "c0bb78")],
)
def test_whole_numbers_with_a_sign(number: int, made: str) -> None:
    assert signed(number).hex() == made


def test_the_paper_feeder_is_small() -> None:
    program = compile_mechanism(load(run.FEEDER)).graph.program(run.OUTPUTS)
    assert len(gzip.compress(webassembly(program))) < 6000


@pytest.fixture
def instance() -> tuple[Any, Any]:
    wasmtime = pytest.importorskip("wasmtime")
    store = wasmtime.Store()
    module = wasmtime.Module(store.engine, webassembly(rows_of(*EVERY)))
    assert not module.imports
    return store, wasmtime.Instance(store, module, []).exports(store)


def test_what_a_module_gives(instance: tuple[Any, Any]) -> None:
    store, exports = instance
    assert {*exports} == {"memory", "free", "parameters", "pose", "poses"}
    assert exports["free"].value(store) % 8 == 0
    assert exports["memory"].size(store) == 1


def test_a_pose_has_room_and_nothing_else_is_written(instance: tuple[Any, Any]) -> None:
    """One set of parameters, one pose and its outputs fit into the memory that is there; the rest stays as it was."""
    store, exports = instance
    memory, free = exports["memory"], exports["free"].value(store)
    rest = bytes(range(256)) * ((PAGE - free) // 256)
    memory.write(store, rest, free)
    p, x, out = free, free + 8, free + 16
    memory.write(store, np.array([0.7, 2.0]).tobytes(), p)
    exports["parameters"](store, p)
    exports["pose"](store, x, out)
    after, end = bytes(memory.read(store, free, free + len(rest))), 16 + 8 * len(EVERY)
    assert after[end:] == rest[end:]
    assert after[16:end] != rest[16:end]
    true = rows_of(*EVERY)(np.array([2.0]), np.array([0.7]))
    np.testing.assert_allclose(np.frombuffer(after[16:end]), true, rtol=1e-14)


def test_no_pose_at_all(instance: tuple[Any, Any]) -> None:
    store, exports = instance
    free = exports["free"].value(store)
    before = bytes(exports["memory"].read(store))
    for count in (0, -1):
        exports["poses"](store, count, free, free)
    assert bytes(exports["memory"].read(store)) == before
