"""The curves of a region as lines of a picture."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from linkwright.drawing.charts import points
from linkwright.drawing.plane import PicturePlane
from linkwright.studies.workspace.curves import Segments
from linkwright.studies.workspace.sheet import ModeSheet


def lines(sheet: ModeSheet, segments: Iterable[Segments], kind: str, plane: PicturePlane, size: float) -> Iterator[str]:
    """The curves of a kind, joined and thinned."""
    import shapely

    for one in segments:
        if one.kind != kind or not one.a.shape[1]:
            continue
        ends = sheet.place(np.stack([one.a, one.b], axis=1).reshape(2, -1))[0].reshape(2, 2, -1)
        kept = np.isfinite(ends).all(axis=(0, 1)) & (ends[:, 0] != ends[:, 1]).any(axis=0)
        lines = shapely.linestrings(np.moveaxis(ends[:, :, kept], (0, 1, 2), (2, 1, 0)))
        merged = shapely.line_merge(shapely.multilinestrings(shapely.set_precision(lines, 1e-9 * size)))
        for line in shapely.get_parts(shapely.simplify(merged, 0.1 / plane.scale * size)):
            if not line.is_empty:
                yield points(*plane.to_picture(*(np.array(line.coords).T / size)))
