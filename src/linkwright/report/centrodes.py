"""The centrodes of a run for the drawing: where each coupler's instant centre wanders."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwright.presentation.json_numbers import listed
from linkwright.report.data import Centrode
from linkwright.results import Result

Array = NDArray[np.float64]

FAR = 0.5
"""How far from the motion a centrode is drawn, in sizes of the motion."""


def centrodes(result: Result, size: float) -> list[Centrode]:
    """The centrodes of all links that turn, but about no fixed point; ``size`` is the length unit (m).

    ``None`` where the centre is far away, and between poses where it passes through infinity.
    """
    run = result.run
    links, links_of_points = run.compiled.structure.topology.moving, run.compiled.quantities.signals.links_of_points
    rows = [row for link in links for row in (*(f"pole({link}, frame).{axis}" for axis in "xyuv"), f"{link}.omega")]
    found = run.evaluate(rows, result.t).reshape(len(links), 5, -1)
    places = np.array([[result[f"{point}.{axis}"] for point in links_of_points] for axis in "xy"])
    low, high = np.nanmin(places, axis=(1, 2)), np.nanmax(places, axis=(1, 2))
    extent = float(np.max(high - low))
    drawn: list[Centrode] = []
    for link, (*pole, omega) in zip(links, found, strict=True):
        x, y, u, v = _cut(np.array(pole), omega, (low + high) / 2, (high - low) / 2 + FAR * extent) / size
        known = np.isfinite(x)
        if known.sum() > 1 and max(np.ptp(x[known]), np.ptp(y[known])) * size > 1e-6 * extent:
            point = next(iter(run.compiled.mechanism.links[link].points), "")
            drawn.append({"link": link, "point": point, "x": listed(x), "y": listed(y), "u": listed(u), "v": listed(v)})
    return drawn


def _cut(pole: Array, omega: Array, centre: Array, reach: Array) -> Array:
    """The pole's rows, NaN outside the reach, and at one of two poses between which it passes through infinity."""
    with np.errstate(invalid="ignore", divide="ignore"):
        away = np.abs(pole[:2] - centre[:, None]) / reach[:, None]
    away = np.nan_to_num(away, nan=np.inf, posinf=np.inf).max(axis=0)
    sign = np.sign(omega)  # of which an infinite one has its own, too
    before = np.flatnonzero(sign[:-1] * sign[1:] <= 0)
    farther = np.where(away[before] > away[before + 1], before, before + 1)
    away[farther] = np.inf
    return np.where(away <= 1, pole, np.nan)
