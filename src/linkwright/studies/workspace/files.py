"""The files of a workspace study: GeoJSON, SVG, the boundaries as CSV, DXF."""

from __future__ import annotations

import io
import json
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright._machine import needed
from linkwright.drawing.tiled import tiled
from linkwright.escape import json_text, layer_name
from linkwright.expressions import units as u
from linkwright.findings import Said
from linkwright.model.csv_text import cell, head, table_text
from linkwright.presentation.blocks import FileOf
from linkwright.studies.workspace.mesh import DriveBox
from linkwright.studies.workspace.outcome import Reached, Workspace, WorkspaceOutcome
from linkwright.studies.workspace.parts_report import FILES as PARTS
from linkwright.studies.workspace.parts_report import section_documents as parts
from linkwright.studies.workspace.picture import pictures
from linkwright.studies.workspace.shapes import pieces
from linkwright.studies.workspace.trajectories_report import trajectories_svg

Array = NDArray[np.float64]

ZOOM = 2
"""Pixels of a PNG to each of the SVG's."""


def geojson(outcome: WorkspaceOutcome) -> str | None:
    """All regions, and what all modes together reach, as GeoJSON (RFC 7946, but for plane coordinates)."""
    if not outcome.regions:
        return None
    unit, size = outcome.compiled.quantities.unit_of(u.LENGTH)
    features = []
    for one in outcome.workspaces:
        told = {"point": outcome.point, "values": outcome.values_in_units(one), "unit": unit}
        for reached in one.regions:
            told_region = {"kind": "region", "mode": reached.mode, **told, "area": reached.figures.area / size**2}
            features.append(_feature(reached.shape, told_region, size))
        area = float(one.union.area) / size**2
        features.append(_feature(one.union, {"kind": "union", **told, "area": area}, size))
    for part in parts(outcome):
        told = {"point": outcome.point, "unit": unit}
        features += [_feature(shape, {**told, **own}, size) for shape, own in part.shapes(outcome)]
    note = str(Said("workspace.note", unit=unit))
    collection = {"type": "FeatureCollection", "note": note, "features": features}
    return json_text(json.dumps(collection, ensure_ascii=False)) + "\n"


def _feature(shape: Any, properties: dict[str, Any], size: float) -> dict[str, Any]:
    from shapely.geometry.polygon import orient

    rings = [
        [[[x / size, y / size] for x, y in ring.coords] for ring in (turned.exterior, *turned.interiors)]
        for turned in map(orient, pieces(shape))
    ]
    geometry = {"type": "MultiPolygon", "coordinates": rings}
    return {"type": "Feature", "properties": properties, "geometry": geometry}


def svg(outcome: WorkspaceOutcome) -> str | None:
    """The pictures of all workspaces, beside each other."""
    if not outcome.workspaces:
        return None
    return tiled(pictures(outcome))


def png(text: str | None, renderer: Any) -> bytes | None:
    """An SVG's pictures in pixels, by the package ``resvg_py``."""
    return None if text is None else bytes(renderer.svg_to_bytes(svg_string=text, zoom=ZOOM))


def boundary_csv(outcome: WorkspaceOutcome) -> str | None:
    """Each point of each boundary: where, the drives' values that reach it, the kind of curve it lies on."""
    if not outcome.workspaces:
        return None
    quantities = outcome.compiled.quantities
    unit, size = quantities.unit_of(u.LENGTH)
    names = [*outcome.options.for_]
    drives = [(drive, *quantities.drive_unit(drive)) for drive in outcome.compiled.graph.drives]
    heads = [head(n, quantities.unit_of(quantities.dimensions.of(n))[0]) for n in names]
    heads += ["mode", "part", "ring", head("x", unit), head("y", unit), *(head(d, w) for d, w, _ in drives), "kind"]
    sizes = [scale for _, _, scale in drives]
    return table_text(heads, _rows(outcome, names, size, sizes))


def _rows(outcome: WorkspaceOutcome, names: list[str], size: float, sizes: list[float]) -> Iterator[list[str]]:
    for one in outcome.workspaces:
        values = outcome.values_in_units(one)
        front = [cell(values[name]) for name in names]
        for mode, part, ring, at, q, kinds in _rings(one, outcome.box):
            for place, drive, kind in zip((at / size).T.tolist(), q.T.tolist(), kinds, strict=True):
                back = [cell(v / scale) for v, scale in zip(drive, sizes, strict=True)]
                yield [*front, mode, str(part), str(ring), *map(cell, place), *back, kind]


Ring = tuple[str, int, int, Array, Array, list[str]]


def _rings(one: Workspace, box: DriveBox | None) -> Iterator[Ring]:
    """Each ring: mode, number of the part, number of the ring (0 is the outer one), places, drive values, kinds."""
    for reached in one.regions:
        reaching = Reaching(reached, box or reached.region.box)
        for part, polygon in enumerate(pieces(reached.shape), start=1):
            for ring, line in enumerate((polygon.exterior, *polygon.interiors)):
                at = np.array(line.coords).T
                yield reached.mode, part, ring, at, *reaching.drives_at(at)
    for curve in one.curves:
        for part, stretch in enumerate(curve.stretches, start=1):
            yield curve.mode, part, 0, stretch.at, stretch.q[None], ["path"] * stretch.q.size


class Reaching:
    """The drive values that reach points of a region's boundary, on the pieces of its curves; whole turns within the
    ranges of ``box``."""

    def __init__(self, reached: Reached, box: DriveBox) -> None:
        import shapely

        self.box = box
        sheet, segments = reached.region.sheet, reached.region.segments
        self.a, self.b = (np.concatenate([getattr(one, end) for one in segments], axis=1) for end in "ab")
        self.kinds = [one.kind for one in segments for _ in range(one.a.shape[1])]
        self.ends = sheet.place(np.stack([self.a, self.b], axis=1).reshape(2, -1))[0].reshape(2, 2, -1)
        self.tree = shapely.STRtree(shapely.linestrings(np.moveaxis(self.ends, (0, 1, 2), (2, 1, 0))))

    def drives_at(self, places: Array) -> tuple[Array, list[str]]:
        """Drive values (2, n) and kinds at places (2, n)."""
        import shapely

        nearest = np.asarray(self.tree.nearest(shapely.points(places.T)))
        start, way = self.ends[:, 0, nearest], self.ends[:, 1, nearest] - self.ends[:, 0, nearest]
        square = (way * way).sum(axis=0)
        along = ((places - start) * way).sum(axis=0) / np.where(square > 0, square, 1.0)
        share = np.clip(along, 0.0, 1.0)
        a, b = self.a[:, nearest], self.b[:, nearest]
        return self.box.wrapped(a + share * (b - a)), [self.kinds[i] for i in nearest.tolist()]


def has_workspace(outcome: WorkspaceOutcome) -> bool:
    """Whether there is a region or curve to draw."""
    return bool(outcome.workspaces)


def dxf(outcome: WorkspaceOutcome) -> str | None:
    """The rings as closed polylines, a layer for each mode and its values; nothing where none was computed."""
    if not has_workspace(outcome):
        return None
    ezdxf, units = needed("ezdxf", "cad"), needed("ezdxf.units", "cad")

    unit, size = outcome.compiled.quantities.unit_of(u.LENGTH)
    drawing: Any = ezdxf.new("R2010")
    drawing.units = {"mm": units.MM, "cm": units.CM, "m": units.M, "in": units.IN, "ft": units.FT}.get(unit, 0)
    space = drawing.modelspace()
    for one in outcome.workspaces:
        text = outcome.values_text(one)
        for number, reached in enumerate(one.regions, start=1):
            layer = _layer(drawing, f"{number} {reached.mode} {text}", number)
            for polygon in pieces(reached.shape):
                for ring in (polygon.exterior, *polygon.interiors):
                    _polyline(space, np.array(ring.coords)[:-1] / size, layer, close=True)
        for number, curve in enumerate(one.curves, start=1):
            layer = _layer(drawing, f"{number} {curve.mode} {text}", number)
            for stretch in curve.stretches:
                _polyline(space, stretch.at.T / size, layer)
    stream = io.StringIO()
    drawing.write(stream)
    return stream.getvalue()


def _polyline(space: Any, corners: Array, layer: str, close: bool = False) -> None:
    """A polyline through corners (n, 2), set at once: ezdxf copies all that are there for each that it adds."""
    from ezdxf.entities.lwpolyline import LWPolylinePoints

    drawn = space.add_lwpolyline((), close=close, dxfattribs={"layer": layer})
    drawn.lwpoints = LWPolylinePoints(np.pad(corners, ((0, 0), (0, 3))).tolist())  # widths and bulge: none


def _layer(drawing: Any, text: str, number: int) -> str:
    """A layer's name in the drawing."""
    name = layer_name(text)
    if name not in drawing.layers:
        drawing.layers.add(name, color=1 + (number - 1) % 6)
    return name


_RESVG = ("resvg_py", "png")


def _png(drawn: Callable[[WorkspaceOutcome], str | None]) -> FileOf:
    """A picture that is written as SVG, as pixels."""
    return FileOf(lambda outcome: png(drawn(outcome), needed(*_RESVG)), "png", asked=True, needs=_RESVG)


FILES = {
    "workspace.geojson": FileOf(geojson),
    "workspace.svg": FileOf(svg),
    "workspace_boundary.csv": FileOf(boundary_csv),
    "workspace.dxf": FileOf(dxf, "dxf", needs=("ezdxf", "cad"), due=has_workspace),
    **{name: FileOf(make) for name, make in PARTS.items()},
    "workspace.png": _png(svg),
    "workspace_trajectories.png": _png(trajectories_svg),
}
"""By name."""
