"""Runs a mechanism as a page does, by Node.js."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Mapping
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
    rows with their rates (sets, rows, 2, times), why it has no motion from where on, and when it ends
    (s)."""

    parameters: Array
    rows: Array
    reaches: Array
    measured: Array
    failures: list[dict[str, Any] | None]
    ends: list[float]


def page_run(made: PagePrograms, times: Array, sets: Array) -> PageRun:
    """The page's own computation at sets of free parameters, (sets, free) in SI."""
    return run_data(made.code(), made.data(), times, sets)


def run_data(code: str, data: Mapping[str, Any], times: Array, sets: Array) -> PageRun:
    """The same by what the page gets."""
    with tempfile.TemporaryDirectory() as folder:
        given, out = Path(folder) / "sets", Path(folder) / "out"
        np.ascontiguousarray(sets, dtype=float).tofile(given)
        answer = _asked(code, data, times, Path(folder), {"sets": str(given), "out": str(out)})
        count, reaches, own = data["parameters"], len(data["groups"]), data["outputs"]
        found = np.fromfile(out).reshape(len(answer["failures"]), -1)
    rows = found[:, count:].reshape(len(found), own + reaches + 2 * data["measured"], times.size)
    measured = rows[:, own + reaches :].reshape(len(found), -1, 2, times.size)
    return PageRun(
        found[:, :count], rows[:, :own], rows[:, own : own + reaches], measured, answer["failures"], answer["ends"]
    )


def page_drags(made: PagePrograms, drags: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Points dragged to targets: each from ``free`` parameters at a ``time`` (s), the ``point`` by its number, to a
    ``target`` (m), with the ``freedom`` that ``web/src/program/drag.ts`` describes."""
    with tempfile.TemporaryDirectory() as folder:
        answer = _asked(made.code(), made.data(), np.zeros(1), Path(folder), {"drags": drags})
        found: list[dict[str, Any]] = answer["drags"]
        return found


def _asked(code: str, data: Mapping[str, Any], times: Array, folder: Path, command: dict[str, Any]) -> dict[str, Any]:
    paths = {name: folder / name for name in ("code", "data")}
    paths["code"].write_text(code, encoding="utf-8")
    paths["data"].write_text(json.dumps({**data, "times": times.tolist()}, allow_nan=False))
    answer: dict[str, Any] = asked({name: str(path) for name, path in paths.items()} | command, "page.mjs")
    assert "error" not in answer, answer["error"]
    return answer
