"""Regions against a dense sample: ``python benchmarks/workspace_samples.py [--json] [--samples N]``.

For each of the eight regions of examples/five_bar_workspace.yaml, N values of both drives at random (10^7 in all, by
default): how far the farthest place lies outside of the polygon, over the frame's length, beside the chord tolerance;
and how far the loneliest stretch of the boundary is from the nearest place, over the same.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import shapely
from figures import parser, tell
from scipy.spatial import cKDTree

import linkwright as lw

EXAMPLE = Path(__file__).resolve().parent.parent / "examples" / "five_bar_workspace.yaml"
BLOCK = 500_000
NEAR = 1e-2
"""Places this near to the boundary (share of the frame's length) are looked at for it."""


def main() -> None:
    """Sample and tell."""
    options = parser(__doc__)
    options.add_argument("--samples", type=int, default=10**7)
    given = options.parse_args()
    none = dict.fromkeys(("trajectories", "quality", "errors", "paths", "fits"))
    outcome = lw.workspace(EXAMPLE, options=none)
    regions = outcome.regions
    size = float(outcome.compiled.quantities.parameters["l5"])
    blocks = -(-given.samples // (len(regions) * BLOCK))
    figures: dict[str, float | str] = {"version": lw.__version__, "samples": float(len(regions) * blocks * BLOCK)}
    figures["chord over frame"] = outcome.chord / size
    rng, away, lone = np.random.default_rng(0), 0.0, 0.0
    for one in regions:
        shape, sheet, box = one.shape, one.region.sheet, one.region.box
        line = shapely.segmentize(shape.boundary, 1e-3 * size)
        corners = shapely.get_coordinates(line)
        core = shape.buffer(-NEAR * size)
        for polygon in (shape, core):
            shapely.prepare(polygon)
        nearest = np.full(len(corners), np.inf)
        for _ in range(blocks):
            at = sheet.place(rng.uniform(box.low, box.high, (BLOCK, 2)).T)[0]
            at = at[:, np.isfinite(at).all(axis=0)]
            at = at[:, ~shapely.contains_xy(core, *at)]
            out = at[:, ~shapely.contains_xy(shape, *at)]
            away = max(away, float(shapely.distance(shape, shapely.points(out.T)).max(initial=0.0)))
            nearest = np.minimum(nearest, cKDTree(at.T).query(corners)[0])
        lone = max(lone, float(nearest.max()))
    figures["farthest outside over frame"] = away / size
    figures["loneliest stretch over frame"] = lone / size
    tell(figures, given.json)


if __name__ == "__main__":
    main()
