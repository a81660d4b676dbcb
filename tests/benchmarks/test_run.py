"""The benchmark runs and gives every figure; how fast is not asked here."""

from __future__ import annotations

import importlib.util
import json
import math
import sys
from pathlib import Path
from types import ModuleType

import pytest

SCRIPT = Path(__file__).parents[2] / "benchmarks" / "run.py"


@pytest.fixture(scope="module")
def benchmark() -> ModuleType:
    spec = importlib.util.spec_from_file_location("linkwright_benchmark", SCRIPT)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def figures(benchmark: ModuleType) -> dict[str, float]:
    once = benchmark.median
    benchmark.median = lambda action, times: once(action, 1)
    return benchmark.measure(poses=1000)  # type: ignore[no-any-return]


def test_every_figure_is_positive(figures: dict[str, float]) -> None:
    assert figures
    for name, value in figures.items():
        assert math.isfinite(value), name
        assert value > 0, name


def test_the_figures_that_the_documents_speak_of(figures: dict[str, float]) -> None:
    wanted = {"compile_ms", "poses_200_full_ms", "numpy_ns_per_pose", "fill_ns_per_pose", "numpy_over_fill"}
    assert wanted | {"help_s", "run_with_report_s"} <= figures.keys()
    ratio = figures["numpy_ns_per_pose"] / figures["fill_ns_per_pose"]
    assert figures["numpy_over_fill"] == pytest.approx(ratio)


@pytest.mark.parametrize("words", [[], ["--json"]])
def test_it_prints_a_table_or_json(
    benchmark: ModuleType, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], words: list[str]
) -> None:
    monkeypatch.setattr(benchmark, "measure", lambda poses: {"one_ms": 1.5, "poses": float(poses)})
    monkeypatch.setattr(sys, "argv", ["run.py", *words, "--poses", "7"])
    benchmark.main()
    text = capsys.readouterr().out
    if words:
        assert json.loads(text) == {"one_ms": 1.5, "poses": 7.0}
    else:
        assert "one_ms" in text
        assert "1.5" in text
