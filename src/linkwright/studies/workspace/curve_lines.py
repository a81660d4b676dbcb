"""The curves of a region as lines of a picture."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np
from numpy.typing import NDArray

from linkwright.drawing.charts import points
from linkwright.drawing.plane import PicturePlane
from linkwright.studies.workspace.curves import Segments
from linkwright.studies.workspace.sheet import ModeSheet

Array = NDArray[np.float64]


def places(sheet: ModeSheet, segments: Iterable[Segments], kind: str, fine: float, size: float) -> Iterator[Array]:
    """The curves of a kind as lines (2, n) in units of ``size`` m, joined, thinned within ``fine`` (m)."""
    import shapely

    for one in segments:
        if one.kind != kind or not one.a.shape[1]:
            continue
        ends = sheet.place(np.stack([one.a, one.b], axis=1).reshape(2, -1))[0].reshape(2, 2, -1)
        kept = np.isfinite(ends).all(axis=(0, 1)) & (ends[:, 0] != ends[:, 1]).any(axis=0)
        lines = shapely.linestrings(np.moveaxis(ends[:, :, kept], (0, 1, 2), (2, 1, 0)))
        merged = shapely.line_merge(shapely.multilinestrings(shapely.set_precision(lines, 1e-9 * size)))
        for line in shapely.get_parts(shapely.simplify(merged, fine)):
            if not line.is_empty:
                yield np.array(line.coords).T / size


def lines(sheet: ModeSheet, segments: Iterable[Segments], kind: str, plane: PicturePlane, size: float) -> Iterator[str]:
    """The same in a picture, as its SVG has them."""
    for line in places(sheet, segments, kind, 0.1 / plane.scale * size, size):
        yield points(*plane.to_picture(*line))
