"""The path of a cutter around a cam, as a chart."""

from __future__ import annotations

import numpy as np

from linkwright.cam.nc.swept import ROUGH
from linkwright.cam.nc.track import chains, pieces
from linkwright.drawing.charts import thinned
from linkwright.expressions import units as u
from linkwright.findings import Said
from linkwright.presentation.charts import Axis, Layer, Lines, Plane, Region
from linkwright.studies.cam.outcome import CamOutcome
from linkwright.studies.cam.plate import Plate

MOST = 1500
"""Points of a line of the cutter's path."""
FINE = 2e-4
"""Lines are rounded to this share of the disc."""


def tool_path(outcome: CamOutcome, plate: Plate) -> Plane:
    """The path of the cutter's centre at full depth, read back from the first file, around the profile, or between the
    flanks of a groove."""
    unit, size = outcome.compiled.quantities.unit_of(u.LENGTH)
    one = plate.milled[0]
    deepest = min(move.end[2] for move in one.proof.moves)
    cutting = [m for m in one.proof.moves if m.feed is not None and max(m.start[2], m.end[2]) <= deepest + 1e-6]
    lines = [line[thinned(len(line), MOST)].T / 1e3 / size for line in chains(pieces(cutting, one.job.cutter), ROUGH)]
    radius = plate.disc.follower.radius
    profile = plate.look.offset(-radius) / size
    layers: list[Layer] = [Region(Said("cam.kind.profile"), [profile])]
    if one.job.groove:
        flank = plate.look.offset(radius) / size
        layers.append(Lines(Said("cam.kind.flank"), [np.concatenate([flank, flank[:, :1]], axis=1)], 0, width=2))
    layers.append(Lines(Said("cam.kind.tool"), lines, 3))
    return Plane(Axis("x", unit), Axis("y", unit), layers, fine=FINE * float(np.ptp(profile, axis=1).max()))
