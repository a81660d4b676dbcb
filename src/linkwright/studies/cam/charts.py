"""Charts of a cam over its angle: the law with its derivatives, pressure angle, curvature, error of the lift as milled;
where over two lengths the limits are kept."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import partial
from itertools import cycle

import numpy as np
from numpy.typing import NDArray

from linkwright.drawing.charts import Axes, named
from linkwright.expressions import units as u
from linkwright.findings import Said, Text
from linkwright.kernels.motions import rate_unit
from linkwright.presentation.blocks import Chart
from linkwright.studies.cam.outcome import CamOutcome
from linkwright.studies.cam.picture import picture, tool_path
from linkwright.studies.cam.plate import Plate

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
            made += [Chart(tool, partial(tool_path, outcome, plate)), _error(outcome, plate)]
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
    second: bool = False,
) -> Chart:
    """Lines over the cam angle, limits across; ``second``: the second line is that of a second disc or contact,
    or of the outer flank."""
    angle, deg = outcome.compiled.quantities.unit_of(u.ANGLE)
    x = (outcome.first.theta if theta is None else theta) / deg
    known = np.concatenate([*(line[np.isfinite(line)] for line in lines), np.array([*limits, 0.0])])
    axes = Axes((0.0, 2 * math.pi / deg), (float(known.min()), float(known.max())), named(Said("cam.angle"), angle))
    ends = np.array([0.0, 2 * math.pi / deg])
    shapes = [axes.line(ends, np.full(2, limit), "limit") for limit in limits]
    kinds = cycle(("mean", "shift" if second else "line"))
    shapes += [axes.line(x, line, kind) for line, kind in zip(lines, kinds, strict=False)]
    which = "flank" if outcome.stated.limits.groove else "second"
    title = named(Said(f"cam.chart.with-{which}", what=name) if second else name, unit)
    return Chart(title, partial(axes.drawing, shapes, title))


def _pressure(outcome: CamOutcome) -> Chart:
    angle, deg = outcome.compiled.quantities.unit_of(u.ANGLE)
    checks = outcome.first.checks
    limits = [c.limit / deg for c in checks if c.name.startswith("pressure") and c.limit is not None]
    lines = [np.abs(np.broadcast_to(p.look.pressure.d[0], p.theta.shape)) / deg for p in outcome.plates]
    return over(outcome, Said("cam.chart.pressure"), angle, lines, limits, second=len(lines) > 1)


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
        yield over(outcome, Said(f"cam.chart.{name}"), per, values, sorted(limits), second=len(values) > 1)


def _error(outcome: CamOutcome, plate: Plate) -> Chart:
    """Made less wanted, of the file that is farthest off: at the cam's bottom and top, on both flanks of a groove."""
    one = max((m for m in plate.milled if not m.proof.faults), key=lambda m: m.proof.worst)
    unit, size = outcome.compiled.quantities.unit_of(outcome.lift_dimension)
    limit = one.job.tolerance / size
    lines = [row / size for row in one.proof.error]
    name = Said("cam.chart.error-groove" if one.job.groove else "cam.chart.error", post=one.post.name)
    return over(outcome, of_disc(name, plate.second), unit, lines, (-limit, limit), one.proof.theta)


def _map(outcome: CamOutcome) -> Chart:
    """Where the limits are kept: a dot for each pair of lengths."""
    found = outcome.map
    assert found is not None
    unit, size = outcome.compiled.quantities.unit_of(u.LENGTH)
    x, y = np.meshgrid(found.first / size, found.second / size)
    axes = Axes((float(x.min()), float(x.max())), (float(y.min()), float(y.max())), named(Said("cam.base"), unit))
    kept = found.margins >= 0
    shapes = [*axes.dots(x[kept], y[kept], 5.0), *axes.dots(x[~kept], y[~kept], 2.0, "limit")]
    title = Said("cam.chart.map", name=found.names[1], unit=unit)
    return Chart(title, partial(axes.drawing, shapes, title))
