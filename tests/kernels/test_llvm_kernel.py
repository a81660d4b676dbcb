"""The LLVM kernel's forms against the NumPy kernel, Newton included; its stores past the cache."""

from __future__ import annotations

import ctypes
import gc
import platform
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from threading import Barrier
from typing import Any

import numpy as np
import pytest

from helpers.compiled import compiled_from
from helpers.examples import heavy_four_bar
from helpers.programs import EVERY, rows_of
from linkwright.blocks import moments_code
from linkwright.compilation import compile_mechanism
from linkwright.graph.program import Program
from linkwright.kernels import Compiled
from linkwright.kernels.llvm_entries import text
from linkwright.kernels.llvm_kernel import FEW, PAST, LlvmKernel, PoseFunction
from linkwright.kernels.llvm_source import CACHED, LANES, LONGEST, KernelSource
from linkwright.kernels.machine_code import Machine, MachineCode, this_machine
from linkwright.kernels.numpy_blocks import NumpyKernel
from linkwright.kernels.threaded import EVEN, FEWEST, spread, stretches
from linkwright.model.document import load

pytest.importorskip("llvmlite")

EXAMPLES = Path(__file__).parents[2] / "examples"
NAMES = ["C.x", "rocker.angle", "rocker.alpha", "D.x", "motor.torque", "B.vx"]


@pytest.fixture(scope="module")
def four_bar() -> Compiled:
    data = heavy_four_bar(parameters={"a": 1.0, "b": 3.0, "c": 3.0, "d": 4.0, "m": 2.0})
    points = data["links"]
    points["crank"]["points"]["B"] = ["a", 0]
    points["coupler"]["points"]["C"] = ["b", 0]
    points["rocker"]["points"]["C"] = ["c", 0]
    points["frame"]["points"]["D"] = ["d", 0]
    points["coupler"]["mass"] = "m"
    return compiled_from(data)


@pytest.fixture(scope="module")
def kernel(four_bar: Compiled) -> LlvmKernel:
    return LlvmKernel(four_bar.graph.program(NAMES))


def close(found: np.ndarray, expected: np.ndarray) -> None:
    """To 1e-13 of each row's largest magnitude, or of 1."""
    axes = tuple(range(1, expected.ndim))
    assert np.array_equal(np.isnan(found), np.isnan(expected))
    scale = np.maximum(1.0, np.nanmax(np.abs(expected), axis=axes, keepdims=True))
    assert np.nanmax(np.abs(found - expected) / scale) < 1e-13


def samples(compiled: Compiled, count: int) -> np.ndarray:
    random = np.random.default_rng(3)
    return compiled.parameters[:, None] * random.uniform(0.97, 1.03, (compiled.parameters.size, count))


@pytest.mark.parametrize("poses", [1, 47, 48, LANES[0], 3 * LANES[0] + 5])
def test_samples_over_shared_poses(poses: int, four_bar: Compiled, kernel: LlvmKernel) -> None:
    x, p = four_bar.inputs(np.linspace(0.1, 6.0, poses)), samples(four_bar, 5)
    expected = NumpyKernel(kernel.program).over(x, p)
    close(kernel.over(x, p), expected)
    own = np.repeat(x[:, None], 5, axis=1)
    close(kernel.over(own, p), expected)
    close(kernel.run(own.reshape(len(x), -1), np.repeat(p, poses, axis=1)).reshape(expected.shape), expected)


def test_a_sample_is_the_same_alone(four_bar: Compiled, kernel: LlvmKernel) -> None:
    x, p = four_bar.inputs(np.linspace(0.1, 6.0, 200)), samples(four_bar, 7)
    every = kernel.over(x, p)
    for i in (0, 3, 6):
        assert np.array_equal(kernel.over(x, p[:, i : i + 1])[:, 0], every[:, i])
    assert np.array_equal(kernel.over(x[:, 50:150], p), every[:, :, 50:150])


def test_poses_that_cannot_close_are_nan(four_bar: Compiled, kernel: LlvmKernel) -> None:
    x, p = four_bar.inputs(np.linspace(0.1, 6.0, 100)), samples(four_bar, 3)
    p[1, 1] = 0.1  # a coupler too short to reach
    found = kernel.over(x, p)
    assert np.isnan(found[0, 1]).sum() > 50
    close(found, NumpyKernel(kernel.program).over(x, p))


def test_angles_too_large_to_be_reduced_are_nan(four_bar: Compiled, kernel: LlvmKernel) -> None:
    x = four_bar.inputs(np.array([0.1, 0.2]))
    x[0, 1] = 2e8
    found = kernel.run(x, four_bar.parameters)
    assert np.isfinite(found[:, 0]).all()
    assert np.isnan(found[0, 1])


@pytest.mark.parametrize("step", [0, 3])
@pytest.mark.parametrize("offset", [0, 1, 5])
@pytest.mark.parametrize("more", [0, 1, 8, LANES[0] - 3])
def test_stores_past_the_cache(more: int, offset: int, step: int, four_bar: Compiled, kernel: LlvmKernel) -> None:
    """Large outputs: the same bits as small ones, and nothing beside them. Rows begin at full lines of the cache or
    each at another part of one; the last block is full, nearly, or has one pose."""
    poses = -(-PAST // (8 * len(NAMES)) // LANES[0]) * LANES[0] + more
    x = np.tile(four_bar.inputs(np.linspace(0.1, 6.0, 1000)), -(-poses // 1000))[:, :poses]
    room = np.full((len(NAMES), -(-poses // 8) * 8 + 16 + step), 7.0)
    out = room[:, offset : offset + poses]
    assert out.nbytes >= PAST
    kernel.run(x, four_bar.parameters, out)
    small = kernel.run(np.ascontiguousarray(x[:, :1000]), four_bar.parameters)
    assert np.array_equal(out, np.tile(small, -(-poses // 1000))[:, :poses])
    assert (room[:, :offset] == 7.0).all()
    assert (room[:, offset + poses :] == 7.0).all()


@pytest.mark.parametrize("poses", [FEW, 2 * LANES[0], 3 * LANES[0] + 5])
@pytest.mark.parametrize("shared", [True, False])
def test_samples_are_stored_past_the_cache(shared: bool, poses: int, four_bar: Compiled, kernel: LlvmKernel) -> None:
    """The same of many samples, each of which begins at a place of its own."""
    count = -(-PAST // (8 * len(NAMES) * poses)) + 1
    x, p = four_bar.inputs(np.linspace(0.1, 6.0, poses)), np.tile(samples(four_bar, 7), -(-count // 7))[:, :count]
    out = kernel.over(x if shared else np.repeat(x[:, None], count, axis=1), p)
    assert out.nbytes >= PAST
    assert np.array_equal(out, np.tile(kernel.over(x, p[:, :7]), (1, -(-count // 7), 1))[:, :count])


@pytest.mark.parametrize("workers", [1, 2, 3])
def test_threads_give_the_same_bits(workers: int, four_bar: Compiled, kernel: LlvmKernel) -> None:
    x = four_bar.inputs(np.linspace(0.1, 60.0, 3 * FEWEST + 17))
    assert np.array_equal(spread(kernel, x, four_bar.parameters, workers=workers), kernel.run(x, four_bar.parameters))


def test_code_stays_while_it_is_called() -> None:
    """Its call alone keeps the engine, without the object or what caches it."""
    text_ = "define void @run(i64 %a) {\nentry:\nret void\n}\n"
    call = MachineCode(text_, [False], this_machine()).call
    gc.collect()
    for _ in range(3):
        MachineCode(text_, [False], this_machine())  # would take the same place
    call(1)
    assert isinstance(call.__self__, MachineCode)  # type: ignore[attr-defined]


def test_moments_made_by_several_threads_at_once() -> None:
    """Each thread may find that none is there and make its own, of which one stays."""
    y = np.random.default_rng(0).standard_normal((2, 40, 50))

    def counted(_: int) -> Any:
        state = [np.zeros((2, 50), dtype=np.float64 if number else np.int64) for number in moments_code.STATE.values()]
        waiting.wait()
        moments_code.add(y, 0, state)
        return state

    for _ in range(5):
        moments_code._code.cache_clear()
        waiting = Barrier(4)
        with ThreadPoolExecutor(4) as pool:
            first, *others = pool.map(counted, range(4))
        assert all(np.array_equal(a, b) for other in others for a, b in zip(first, other, strict=True))


@pytest.mark.parametrize("poses", [0, 1, FEWEST - 1, 2 * FEWEST, 10 * FEWEST + 3])
def test_stretches_cover_the_poses(poses: int) -> None:
    for workers in (1, 2, 5):
        parts = stretches(poses, workers)
        assert len(parts) <= workers
        assert [i for part in parts for i in range(poses)[part]] == list(range(poses))
        assert all(part.start % EVEN == 0 for part in parts)


def chain(dyads: int) -> dict[str, Any]:
    """Four-bars one after another: the rocker of each drives the next."""
    data = heavy_four_bar()
    points, rocker = data["links"]["frame"]["points"], "rocker"
    for k in range(dyads - 1):
        x = 4 + 4.0 * (k + 1)
        points[f"G{k}"] = [x, 0]
        data["links"][rocker]["points"][f"E{k}"] = [0.9, 0.3]
        data["links"][f"bar{k}"] = {"points": {f"E{k}": [0, 0], f"F{k}": [4, 0]}, "mass": 1, "shape": f"rod E{k}-F{k}"}
        data["links"][f"arm{k}"] = {
            "points": {f"G{k}": [0, 0], f"F{k}": [1.5, 0]},
            "mass": 1,
            "shape": f"rod G{k}-F{k}",
        }
        data["assembly"][f"F{k}"] = f"left of E{k}-G{k}"
        rocker = f"arm{k}"
    return data


def test_long_programs_are_split() -> None:
    """Functions of at most some 500 instructions, whose values pass over rows that are used again."""
    compiled = compiled_from(chain(8))
    program = compiled.graph.program(["motor.torque", "F6.x", "arm6.alpha"])
    source = KernelSource.fitting(program, "apart", this_machine())
    assert source.lanes < LANES[0]
    assert source.rows.count * source.lanes <= CACHED
    functions = [part for part in text(source).split("define ") if "@block_own" in part.splitlines()[0]]
    assert len(functions) > 1
    arithmetic = [sum(part.count(word) for word in (" = fadd", " = fsub", " = fmul", " = fdiv")) for part in functions]
    assert max(arithmetic) < LONGEST + 100  # the elementary functions are written out
    t = np.linspace(0.1, 6.0, 300)
    x = compiled.inputs(t)
    close(LlvmKernel(program).run(x, compiled.parameters), NumpyKernel(program).run(x, compiled.parameters))


def solving(name: str) -> tuple[Compiled, Program, list[int], np.ndarray]:
    """An example with a group beyond the dyads, the program that solves it, its rows, inputs solved already."""
    compiled = compile_mechanism(load(EXAMPLES / f"{name}.yaml"))
    program = compiled.graph.solving(compiled.structure.higher_groups[0])
    rows = list(program.solves[0].rows)
    return compiled, program, rows, compiled.inputs(np.linspace(0.0, 0.7, 300))


@pytest.mark.parametrize("name", ["sauer_platform", "class_four"])
def test_newton_in_the_kernel(name: str) -> None:
    """From starts that are 0.1 % off to the solution; what can't be solved is NaN; no pose has a say in another."""
    compiled, program, rows, solved = solving(name)
    random, scale = np.random.default_rng(0), np.array(program.solves[0].scale)[:, None]
    x = solved.copy()
    x[rows] += 1e-3 * scale * random.standard_normal((len(rows), x.shape[1]))
    x[rows[0], 7], x[rows[0], 9] = np.nan, np.inf
    kernel, plain = LlvmKernel(program), NumpyKernel(program)
    found, p = kernel.run(x, compiled.parameters), compiled.parameters
    expected = plain.run(x, p)
    assert np.isnan(found[:, [7, 9]]).all()
    assert np.isnan(expected[:, [7, 9]]).all()
    others = np.delete(np.arange(x.shape[1]), [7, 9])
    assert np.abs((found - solved[rows])[:, others] / scale).max() < 1e-12
    assert np.abs((expected - solved[rows])[:, others] / scale).max() < 1e-12
    assert np.array_equal(kernel.run(x[:, 20:60], p), found[:, 20:60])
    assert np.array_equal(plain.run(x[:, 20:60], p), expected[:, 20:60])
    # Samples share the starts and are solved each for its own parameters.
    both = np.stack([p, p * (1 + 1e-4)], axis=1)
    over, twin = kernel.over(x[:, 10:], both), plain.over(x[:, 10:], both)
    assert np.array_equal(over[:, 0], found[:, 10:])
    assert np.abs((over - twin) / scale[:, None]).max() < 1e-12


@pytest.mark.parametrize("form", ["run", "each", "over"])
def test_every_instruction(form: str) -> None:
    """All that a program may hold, in all forms, against CasADi's own evaluation: to 4 units in the last place."""
    program = rows_of(*EVERY)
    kernel = LlvmKernel(program)
    x = np.array([[-7.5, -3.0, -1.0, -0.25, 1e-3, 0.5, 1.0, 2.0, 3.25, 8.0] * 6])
    p = np.array([[2.0, 0.7]])
    expected = np.array([[program(x[:, i], p[:, s]) for i in range(x.shape[1])] for s in range(2)]).transpose(2, 0, 1)
    if form == "run":
        found = np.stack([kernel.run(x, p[:, s]) for s in range(2)], axis=1)
    elif form == "over":
        found = kernel.over(x, p)
    else:
        flat = kernel.run(np.tile(x, 2), np.repeat(p, x.shape[1], axis=1))
        found = flat.reshape(len(expected), 2, -1)
    assert np.array_equal(np.isnan(found), np.isnan(expected))
    assert np.isnan(expected).any()
    known = np.isfinite(expected)
    assert np.array_equal(found[~known], expected[~known], equal_nan=True)
    assert (np.abs(found[known] - expected[known]) <= 4 * np.spacing(np.abs(expected[known]))).all()


def narrower() -> list[Machine]:
    """This machine, and what it would be with less: vectors of 4, of 2, and single numbers."""
    here = this_machine()
    if platform.machine() not in ("x86_64", "AMD64"):
        return [here, replace(here, width=1)]
    wide = [Machine(4, here.typed, "x86-64-v3", ""), Machine(2, here.typed, "x86-64", "")]
    return [here, *(each for each in wide if each.width < here.width), replace(here, width=1)]


@pytest.mark.parametrize("poses", [1, 31, 128, 300])
def test_bits_do_not_depend_on_the_width_of_vectors(poses: int) -> None:
    """Every instruction at any width, without fused operations or with, in any block, and a pose alone."""
    program = rows_of(*EVERY)
    random = np.random.default_rng(5)
    x, p = random.normal(0.0, 3.0, (1, poses)), np.array([1.3])
    every = [LlvmKernel(program, machine).run(x, p) for machine in narrower()]
    for found in every[1:]:
        assert found.tobytes() == every[0].tobytes()
    alone = PoseFunction(program)
    assert np.array([alone(pose, p) for pose in x.T]).T.tobytes() == every[0].tobytes()


@pytest.mark.parametrize("name", ["sauer_platform", "class_four"])
def test_newton_gives_the_same_bits_at_any_width(name: str) -> None:
    compiled, program, rows, solved = solving(name)
    x, p = solved[:, :77].copy(), compiled.parameters
    x[rows] += 1e-4
    every = [LlvmKernel(program, machine).run(x, p) for machine in narrower()]
    assert all(found.tobytes() == every[0].tobytes() for found in every[1:])
    alone = PoseFunction(program)
    assert all(
        alone(pose, p).tobytes() == column.tobytes() for pose, column in zip(x.T, every[0].T.copy(), strict=True)
    )


def test_two_kernels_at_once_and_one_that_travels(four_bar: Compiled, kernel: LlvmKernel) -> None:
    """Threads that compile and run at the same time; a kernel is sent as its program."""
    x, p = four_bar.inputs(np.linspace(0.1, 6.0, 400)), four_bar.parameters
    expected = kernel.run(x, p)

    def fresh(_: int) -> bytes:
        return LlvmKernel(kernel.program).run(x, p).tobytes()

    with ThreadPoolExecutor(4) as pool:
        assert set(pool.map(fresh, range(8))) == {expected.tobytes()}
    function, arguments = kernel.__reduce__()
    assert function(*arguments).run(x, p).tobytes() == expected.tobytes()


def test_the_c_function_of_a_pose_is_called_by_its_address(four_bar: Compiled, kernel: LlvmKernel) -> None:
    """As an integrator would, with pointers alone."""
    made, x = PoseFunction(kernel.program), four_bar.inputs(np.array([1.7]))[:, 0].copy()
    out, room, p = np.empty(made.outputs), np.empty(made.room), four_bar.parameters
    call = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * 4)(made.address)
    call(x.ctypes.data, p.ctypes.data, out.ctypes.data, room.ctypes.data)
    assert out.tobytes() == kernel.run(x[:, None], p)[:, 0].tobytes()
