"""Runs a mechanism as a page does, by Node.js."""

from __future__ import annotations

import json
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from helpers.emitted import asked
from linkwright.kernels.page_programs import PagePrograms

Array = np.ndarray


@dataclass
class PageRun:
    """Of each set: all parameters (sets, parameters), rows (sets, rows, times), reaches (sets, groups, times), and why
    it has no motion from where on."""

    parameters: Array
    rows: Array
    reaches: Array
    failures: list[dict[str, Any] | None]


def page_run(made: PagePrograms, times: Array, sets: Array) -> PageRun:
    """The page's own computation at sets of free parameters, (sets, free) in SI."""
    with tempfile.TemporaryDirectory() as folder:
        paths = {name: Path(folder) / name for name in ("code", "data", "sets", "out")}
        paths["code"].write_text(made.code(), encoding="utf-8")
        paths["data"].write_text(json.dumps({**made.data(), "times": times.tolist()}, allow_nan=False))
        np.ascontiguousarray(sets, dtype=float).tofile(paths["sets"])
        answer = asked({name: str(path) for name, path in paths.items()}, "page.mjs")
        assert "error" not in answer, answer["error"]
        count, reaches = len(made.compiled.graph.parameters), len(made.reaches)
        found = np.fromfile(paths["out"]).reshape(len(answer["failures"]), -1)
    rows = found[:, count:].reshape(len(found), len(made.rows) + reaches, times.size)
    return PageRun(found[:, :count], rows[:, : len(made.rows)], rows[:, len(made.rows) :], answer["failures"])
