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
    """Of each set: all parameters (sets, parameters), rows (sets, rows, times), reaches (sets, groups, times), measured
    rows with their rates (sets, rows, 2, times), and why it has no motion from where on."""

    parameters: Array
    rows: Array
    reaches: Array
    measured: Array
    failures: list[dict[str, Any] | None]


def page_run(made: PagePrograms, times: Array, sets: Array) -> PageRun:
    """The page's own computation at sets of free parameters, (sets, free) in SI."""
    with tempfile.TemporaryDirectory() as folder:
        given, out = Path(folder) / "sets", Path(folder) / "out"
        np.ascontiguousarray(sets, dtype=float).tofile(given)
        answer = _asked(made, times, Path(folder), {"sets": str(given), "out": str(out)})
        count, reaches = len(made.compiled.graph.parameters), len(made.reaches)
        found = np.fromfile(out).reshape(len(answer["failures"]), -1)
    own = len(made.rows)
    rows = found[:, count:].reshape(len(found), own + reaches + 2 * len(made.measured), times.size)
    measured = rows[:, own + reaches :].reshape(len(found), -1, 2, times.size)
    return PageRun(found[:, :count], rows[:, :own], rows[:, own : own + reaches], measured, answer["failures"])


def page_drags(made: PagePrograms, drags: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Points dragged to targets: each from ``free`` parameters at a ``time`` (s), the ``point`` by its number, to a
    ``target`` (m), with the ``freedom`` that ``web/src/program/drag.ts`` describes."""
    with tempfile.TemporaryDirectory() as folder:
        found: list[dict[str, Any]] = _asked(made, np.zeros(1), Path(folder), {"drags": drags})["drags"]
        return found


def _asked(made: PagePrograms, times: Array, folder: Path, command: dict[str, Any]) -> dict[str, Any]:
    code, data = folder / "code", folder / "data"
    code.write_text(made.code(), encoding="utf-8")
    data.write_text(json.dumps({**made.data(), "times": times.tolist()}, allow_nan=False))
    answer: dict[str, Any] = asked({"code": str(code), "data": str(data), **command}, "page.mjs")
    assert "error" not in answer, answer["error"]
    return answer
