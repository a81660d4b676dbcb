"""Charts of a cam over its angle: the law with its derivatives, pressure angle, curvature, error of the lift as milled;
where over two lengths the limits are kept."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

import numpy as np
from numpy.typing import NDArray

from linkwright.drawing.levels import band_stops, levels_of
from linkwright.expressions import units as u
from linkwright.findings import Said, Text
from linkwright.kernels.motions import rate_unit
from linkwright.presentation.blocks import Chart
from linkwright.presentation.charts import Axis, Field, Graph, Layer, Limit, Line, Plane, Spots
from linkwright.studies.cam.outcome import CamOutcome
from linkwright.studies.cam.picture import picture
from linkwright.studies.cam.plate import Plate
from linkwright.studies.cam.tool_path import tool_path

Array = NDArray[np.float64]

RATES = ("lift", "velocity", "acceleration", "jerk")


def charts(outcome: CamOutcome) -> list[Chart]:
    """The picture of the cam, and all charts that there are."""
    title = Said("cam.picture", name=outcome.name)
    made: list[Chart] = [Chart(title, partial(picture, outcome), hint=Said("cam.picture.turning"))]
    made += [*_rates(outcome), _pressure(outcome), *_curvatures(outcome)]
    if outcome.map is not None:
        made.append(_map(outcome))
    for plate in outcome.plates:
        if any(not one.proof.faults for one in plate.milled):
            tool = of_disc(Said("cam.chart.tool"), plate.second)
            made += [Chart(tool, shown=partial(tool_path, outcome, plate)), _error(outcome, plate)]
    return made


def of_disc(text: Text, second: bool) -> Text:
    """What something is called, of the second disc."""
    return Said("cam.of-second", what=text) if second else text


def _rates(outcome: CamOutcome) -> Iterator[Chart]:
    law = outcome.compiled.mechanism.laws[outcome.compiled.mechanism.cams[outcome.name].law]
    for order, name in enumerate(RATES):
        unit, size = rate_unit(outcome.compiled.quantities, law, order)
        values = np.broadcast_to(outcome.first.look.lift.d[order], outcome.first.theta.shape) / size
        yield over(outcome, Said(f"cam.chart.{name}"), unit, [values])


def over(
    outcome: CamOutcome,
    name: Text,
    unit: str,
    lines: Sequence[Array],
    limits: Sequence[float] = (),
    theta: Array | None = None,
    names: Sequence[Text] = (),
) -> Chart:
    """Lines over the cam angle, limits across; ``names`` of the lines, by default those of two contacts or flanks where
    there are two."""
    angle, deg = outcome.compiled.quantities.unit_of(u.ANGLE)
    x = (outcome.first.theta if theta is None else theta) / deg
    which = "flank" if outcome.stated.limits.groove else "contact"
    both = [Said(f"cam.chart.first-{which}"), Said(f"cam.chart.second-{which}")]
    called = names or (both if len(lines) > 1 else [name])

    def graph() -> Graph:
        rows = [Line(each, line, k, dash=k) for k, (each, line) in enumerate(zip(called, lines, strict=True))]
        across = [Limit(Said("cam.chart.limit"), limit) for limit in limits]
        return Graph(Axis(Said("cam.angle"), angle), x, Axis(name, unit), rows, across)

    return Chart(name, shown=graph)


def _pressure(outcome: CamOutcome) -> Chart:
    angle, deg = outcome.compiled.quantities.unit_of(u.ANGLE)
    checks = outcome.first.checks
    limits = [c.limit / deg for c in checks if c.name.startswith("pressure") and c.limit is not None]
    lines = [np.abs(np.broadcast_to(p.look.pressure.d[0], p.theta.shape)) / deg for p in outcome.plates]
    return over(outcome, Said("cam.chart.pressure"), angle, lines, limits)


def _curvatures(outcome: CamOutcome) -> Iterator[Chart]:
    """Of the pitch curves and of the profiles, with the limits of their radii."""
    unit, size = outcome.compiled.quantities.unit_of(u.LENGTH)
    per = f"1/{unit}"
    for name, own, check in (("pitch", False, "pitch_radius"), ("profile", True, "profile_radius")):
        plates = [plate for plate in outcome.plates if (plate.has_profile if own else plate.disc.follower.radius)]
        if not plates:
            continue
        limits = {size / c.limit for plate in plates for c in plate.checks if c.name == check and c.limit}
        values = [size / plate.look.radius(-plate.disc.follower.radius if own else 0.0) for plate in plates]
        yield over(outcome, Said(f"cam.chart.{name}"), per, values, sorted(limits))


def _error(outcome: CamOutcome, plate: Plate) -> Chart:
    """Made less wanted, of the file that is farthest off: at the cam's bottom and top, on both flanks of a groove."""
    one = max((m for m in plate.milled if not m.proof.faults), key=lambda m: m.proof.worst)
    unit, size = outcome.compiled.quantities.unit_of(outcome.lift_dimension)
    limit = one.job.tolerance / size
    lines = [row / size for row in one.proof.error]
    name = Said("cam.chart.error-groove" if one.job.groove else "cam.chart.error", post=one.post.name)
    sides = ("inner-bottom", "inner-top", "outer-bottom", "outer-top") if one.job.groove else ("bottom", "top")
    names = [Said(f"cam.chart.{side}") for side in sides]
    return over(outcome, of_disc(name, plate.second), unit, lines, (-limit, limit), one.proof.theta, names)


def _map(outcome: CamOutcome) -> Chart:
    """The margins of the limits over two lengths, in per cent; at zero they are just kept."""
    found = outcome.map
    assert found is not None
    unit, size = outcome.compiled.quantities.unit_of(u.LENGTH)
    margins = np.where(np.isfinite(found.margins), 100 * found.margins, np.nan)
    x, y = found.first / size, found.second / size

    def plane() -> Plane:
        levels = levels_of(margins)
        kept = [Limit(Said("cam.chart.limit"), 0.0)]
        axis = Axis(Said("cam.chart.margin"), "%")
        layers: list[Layer] = [Field(axis, x, y, margins, levels, band_stops(len(levels) + 1), kept, family=True)]
        rows, columns = np.nonzero(np.isnan(margins))
        if rows.size:
            layers.append(Spots(Said("cam.chart.nowhere"), x[columns], y[rows], colour="muted", cross=True))
        return Plane(Axis(Said("cam.base"), unit), Axis(found.names[1], unit), layers, equal=False)

    return Chart(Said("cam.chart.map", name=found.names[1]), shown=plane)
