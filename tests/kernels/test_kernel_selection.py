"""The choice of a kernel by the size of the work."""

from __future__ import annotations

import pytest

from helpers.compiled import compiled_from
from helpers.examples import feeder
from linkwright.findings import ModelError
from linkwright.graph.program import Program
from linkwright.kernels import KERNELS, machine_code
from linkwright.kernels.kernel_selection import choose
from linkwright.kernels.numpy_blocks import NumpyKernel


@pytest.fixture(scope="module")
def program() -> Program:
    return compiled_from(feeder()).graph.program(["motor.torque", "E.x", "E.ax"])


def test_small_work_is_never_compiled(program: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(machine_code, "available", lambda: True)
    for poses in (1, 200, 100_000):
        choice = choose(program, poses)
        assert (choice.kernel, choice.key) == ("numpy", "kernel-small")
        assert choice.instructions == program.size and "too few" in str(choice.reason)


def test_large_work_is(program: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(machine_code, "available", lambda: True)
    assert choose(program, 10**9).kernel == "llvm"
    monkeypatch.setattr(machine_code, "available", lambda: False)
    choice = choose(program, 10**9)
    assert choice.kernel == "numpy"
    assert "linkwright[fast]" in str(choice.reason)


def test_more_work_never_goes_back(program: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(machine_code, "available", lambda: True)
    kernels = [choose(program, 10**k).kernel for k in range(12)]
    assert kernels == sorted(kernels, key=["numpy", "llvm"].index)
    assert set(kernels) == {"numpy", "llvm"}


def test_a_wish_is_granted_or_refused(program: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    assert choose(program, 10**9, wish="numpy").key == "kernel-wished"

    def missing(self: object, program: Program) -> None:
        raise ModelError([])

    monkeypatch.setattr(NumpyKernel, "__init__", missing)
    with pytest.raises(ModelError):
        choose(program, 1, wish="numpy")
    assert set(KERNELS) >= {"numpy", "llvm", "jax"}
