"""The kernels timed on a model: what is timed, what is told, what is refused."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner

from linkwright.app import Bench, bench_file, examine_file
from linkwright.app.bench import default_outputs
from linkwright.cli import cli
from linkwright.kernels import KERNELS, machine_code

EXAMPLES = Path(__file__).parents[2] / "examples"
FEEDER = EXAMPLES / "paper_feeder.yaml"


def bench(*words: str) -> tuple[int, str]:
    done = CliRunner().invoke(cli, ["bench", *words])
    return done.exit_code, done.output


def test_figures_of_all_kernels_as_json() -> None:
    code, text = bench(
        str(EXAMPLES / "four_bar.yaml"), "--poses", "3000", "--output", "B.x", "--output", "B.vy", "--json"
    )
    assert code == 0
    data = json.loads(text)
    installed = {name for name, kernel in KERNELS.items() if kernel.available()}
    assert set(data["kernels"]) == installed
    assert set(data["missing"]) == set(KERNELS) - installed
    assert data["outputs"] == ["B.x", "B.vy"]
    assert data["fill_ns_per_pose"] > 0
    for name, figures in data["kernels"].items():
        assert figures["outputs"] == 2
        assert figures["ns_per_pose"] > 0
        assert figures["cold_s"] > 0
        assert figures["deviation"] < 1e-12, name
    assert data["kernels"]["numpy"]["deviation"] == 0


def test_positions_rates_reactions_and_efforts_are_the_default() -> None:
    compiled = examine_file(FEEDER).compiled
    assert compiled is not None
    names = default_outputs(compiled)
    for name in ("E.x", "E.vx", "E.ax", "rocker.omega", "rocker.alpha", "force(frame, crank).x", "motor.torque"):
        assert name in names
    assert len(names) == len(set(names))
    assert not {name for name in names if name.startswith(("A.", "D.", "frame."))}  # these don't move


def test_of_many_outputs_fewer_poses_are_taken(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("linkwright.app.bench.MOST", 8 * 49 * 500)
    done = bench_file(examine_file(FEEDER), poses=10**6, kernels=["numpy"])
    assert isinstance(done, Bench)
    assert done.poses == 500


def test_the_table_says_what_was_timed() -> None:
    code, text = bench(str(FEEDER), "--poses", "1000", "--kernel", "numpy", "--threads", "2")
    assert code == 0
    assert "49 outputs" in text
    assert "1000 poses, 2 threads" in text
    assert "numpy" in text


@pytest.mark.parametrize(
    "words, wanted",
    [
        (["--output", "E.x", "--output", "E.z", "--output", "nothing"], ["'E.z'", "'nothing'", "signal.unknown"]),
        (["--kernel", "fortran"], ["'fortran'", "jax, llvm, numpy", "name.unknown-kernel"]),
    ],
)
def test_wrong_names_are_refused(words: list[str], wanted: list[str]) -> None:
    code, text = bench(str(FEEDER), *words, "--poses", "10")
    assert code == 2
    for word in wanted:
        assert word in text


def test_a_wrong_file_is_told_of(tmp_path: Path) -> None:
    code, text = bench(str(tmp_path / "none.yaml"), "--json")
    assert code == 2
    assert json.loads(text)["findings"][0]["code"] == "file.not-found"


def test_a_kernel_whose_package_is_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    machine_code.this_machine.cache_clear()
    machine_code._binding.cache_clear()
    monkeypatch.setitem(sys.modules, "llvmlite.binding", None)
    code, text = bench(str(FEEDER), "--poses", "100", "--kernel", "llvm")
    assert (code, "file.needs-package" in text) == (2, True)
