"""What a report needs to compute its mechanism itself: programs in place of tables, and the numbers that can be moved.

Where it can't, the report shows what was recorded: a sweep of a drive, a structure that stands, a motion through change
points, whose branches hold at the nominal parameters alone.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, TypedDict

import numpy as np

from linkwright.expressions.units import LENGTH
from linkwright.graph.rows import Named
from linkwright.kernels.page_programs import PagePrograms
from linkwright.presentation.json_numbers import known
from linkwright.report.data import Plot, Scene
from linkwright.results import Result
from linkwright.studies.drive_sweep import Sweep

PROBES = 7919
"""A prime: the pose at which the value of row i is compared is i times this, modulo the number of poses."""


class LiveData(TypedDict):
    """What the page's solver gets. Times in s, all values in SI.

    ``code``: the programs' text. ``program``: what joins them. ``poses``: the links whose poses come first among the
    outputs, four rows each. ``signals``: the names of the rows behind them, ``sizes`` their units in SI, ``wrapped``
    those that are angles without whole turns. ``probes``: a value of each row, which the page must find too.
    ``numbers``: what can be moved.
    """

    code: str
    program: dict[str, Any]
    times: Sequence[float]
    length: float
    poses: Sequence[str]
    signals: Sequence[str]
    sizes: Sequence[float]
    wrapped: Sequence[int]
    probes: Sequence[float | None]
    numbers: Sequence[dict[str, Any]]


def can_be_live(result: Result) -> bool:
    """Whether a page can compute what a result shows."""
    run = result.run
    return not isinstance(run, Sweep) and run.start == 0.0 < run.stop and not run.compiled.passages.every


def live_data(result: Result, scene: Scene, plots: Iterable[Plot]) -> LiveData:
    """The data of a result whose report has this scene and these plots."""
    compiled, graph = result.run.compiled, result.run.compiled.graph
    names = dict.fromkeys(f"{trace['name']}.{axis}" for trace in scene["traces"] for axis in "xy")
    names |= dict.fromkeys(series["name"] for plot in plots for series in plot["series"])
    signals = [*names]
    rows: list[Named] = [*graph.pose_rows, *signals]
    made = PagePrograms(compiled, tuple(rows))
    values = np.concatenate([compiled.evaluate(graph.pose_rows, result.t), [result[name] for name in signals]])
    poses = np.arange(len(rows)) * PROBES % result.t.size
    quantities = compiled.quantities
    return {
        "code": made.code(),
        "program": made.data(),
        "times": result.t.tolist(),
        "length": quantities.unit_of(LENGTH)[1],
        "poses": list(compiled.structure.topology.moving),
        "signals": signals,
        "sizes": [quantities.unit_of(result.dimension(name))[1] for name in signals],
        "wrapped": [i for i, name in enumerate(signals) if graph.wrapped(name)],
        "probes": [known(float(row[pose])) for row, pose in zip(values, poses, strict=True)],
        "numbers": numbers(made),
    }


def numbers(made: PagePrograms) -> list[dict[str, Any]]:
    """The free parameters, in their order: name, value and bounds (SI), unit with its size, whether it is locked."""
    quantities = made.compiled.quantities
    found = []
    for name, value in zip(made.derived.inputs, made.values, strict=True):
        unit, size = quantities.unit_of(quantities.dimensions.of(name))
        low, high = sorted((0.5 * value, 1.5 * value))
        why = made.locked.get(name)
        locked = None if why is None else why.said("what")
        found.append(
            {"name": name, "value": value, "low": low, "high": high, "unit": unit, "size": size, "locked": locked}
        )
    return found
