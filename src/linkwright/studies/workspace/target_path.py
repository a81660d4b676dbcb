"""Wanted paths of the working point: places over a parameter u in 0 .. 1 with their exact derivatives.

A path comes from points, from a CSV file or a DXF drawing beside the model, or from a formula in u.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions import units as u
from linkwright.expressions.dimensions import DimensionError
from linkwright.expressions.language import (
    FUNCTIONS,
    Binary,
    Call,
    ExpressionError,
    Name,
    Negative,
    Node,
    Number,
    evaluate,
    nodes,
    parse,
)
from linkwright.expressions.units import UnitError, unit
from linkwright.findings import Finding, ModelError
from linkwright.laws import DEGREES
from linkwright.model.csv_file import read_csv
from linkwright.model.quantities import Quantities
from linkwright.notation import Jet
from linkwright.studies.workspace.dxf_file import read_curve

Array = NDArray[np.float64]
Path_ = tuple[str | int, ...]

PATH: Path_ = ("studies", "workspace", "paths")
MAX_ROWS = 100_000
SAME = 1e-9
"""Ends nearer than this share of the path's extent are one: the path is closed."""
BENT = 1e-6
"""Straight pieces that turn by more than this (rad) make a corner."""


@dataclass(frozen=True)
class TargetPath:
    """``of(u)`` gives the place (m) with its first and second derivative by u: (3, 2, n). ``corners`` are the u at
    which the direction jumps, ``path`` is its place in the file."""

    of: Callable[[Array], Array]
    closed: bool
    corners: tuple[float, ...] = ()
    path: Path_ = PATH

    def backward(self) -> TargetPath:
        """The same path run the other way."""
        sign = np.array([1.0, -1.0, 1.0])[:, None, None]
        corners = tuple(1.0 - c for c in self.corners)
        return TargetPath(lambda share: sign * self.of(1.0 - share), self.closed, corners, self.path)


def path_through_points(points: Array, between: str = "cubic", path: Path_ = PATH) -> TargetPath:
    """The path through points (n, 2) in m: a spline over the length of the chords as ``tables`` have it (linear,
    cubic, quintic), periodic where the last point is the first."""
    from scipy.interpolate import make_interp_spline

    points = np.asarray(points, dtype=float).reshape(-1, 2)
    size = float(np.ptp(points, axis=0).max(initial=0.0)) if len(points) else 0.0
    chords = np.hypot(*np.diff(points, axis=0).T)
    kept = np.concatenate([[True], chords > SAME * size])[: len(points)]
    points, chords = points[kept], chords[kept[1:]]
    degree = DEGREES[between]
    if len(points) < degree + 1 or not np.isfinite(points).all():
        raise ModelError([Finding("workspace.path-short", path, {"given": len(points), "wanted": degree + 1})])
    closed = bool(np.hypot(*(points[-1] - points[0])) <= 1e3 * SAME * size)
    if closed:
        points[-1] = points[0]
    share = np.concatenate([[0.0], np.cumsum(chords)]) / chords.sum()
    share[-1] = 1.0
    spline = make_interp_spline(share, points, k=degree, bc_type="periodic" if closed and degree > 1 else None)

    def place_and_rates(at: Array) -> Array:
        zero = np.zeros((2, np.size(at)))
        return np.stack([spline(at, nu=k).T if k <= degree else zero for k in range(3)])

    return TargetPath(place_and_rates, closed, _corners(points, share, closed) if degree == 1 else (), path)


def _corners(points: Array, share: Array, closed: bool) -> tuple[float, ...]:
    way = np.arctan2(*np.diff(points, axis=0).T[::-1])
    turned = np.diff(way, append=way[:1])
    bent = np.abs(np.mod(turned + np.pi, 2 * np.pi) - np.pi) > BENT
    bent[-1] &= closed
    return tuple(share[1:][bent].tolist())


def from_csv(file: str, folder: Path | None = None, between: str = "cubic", path: Path_ = PATH) -> TargetPath:
    """The path through the rows of a CSV file with the columns ``x [mm]`` and ``y [mm]`` (any unit of length)."""
    rows = read_csv(file, folder, path, MAX_ROWS)
    columns, sizes = [], []
    for name in ("x", "y"):
        found = next((head for head in rows.heads if head.split("[")[0].strip() == name), name)
        columns.append(rows.column(found, f"{name} [mm]"))
        word = found.partition("[")[2].rstrip("] ")
        try:
            size, dimension = unit(word)
        except UnitError:
            size, dimension = 1.0, u.PURE
        if dimension != u.LENGTH:
            raise ModelError([Finding("workspace.path-unit", path, {"column": found[:40]})])
        sizes.append(size)
    return path_through_points(np.array(rows.numbers(columns)).reshape(-1, 2) * sizes, between, path)


def from_dxf(
    file: str, size: float, folder: Path | None = None, layer: str | None = None, path: Path_ = PATH
) -> TargetPath:
    """The one polyline, line, arc, circle, ellipse or spline of a DXF drawing (of a layer); ``size`` is its unit in m.

    Polylines stay straight pieces; arcs and splines become chords.
    """
    return path_through_points(size * read_curve(file, folder, layer, path), "linear", path)


def from_formula(
    quantities: Quantities, x: str, y: str, path: Path_ = PATH, parameters: Mapping[str, float] | None = None
) -> TargetPath:
    """The path x(u), y(u) for u in 0 .. 1: expressions of u and of the mechanism's ``parameters`` (SI, the nominal
    ones if not given), exact derivatives."""
    values = quantities.parameters if parameters is None else parameters
    trees, findings = [], []
    for name, text in (("x", x), ("y", y)):
        try:
            tree = parse(text)
            if (strange := _strange(tree, quantities)) is not None:
                findings.append(Finding("workspace.path-name", (*path, name), {"name": strange[:40]}))
                continue
            trees.append(quantities.dimensions.bind(_timed(tree), u.LENGTH))
        except ExpressionError as error:
            data = {"text": text[:60], "reason": error.reason}
            findings.append(Finding("expression.syntax", (*path, name), data))
        except DimensionError as error:
            data = {k: v.replace("t / 1 s", "u") if isinstance(v, str) else v for k, v in error.data.items()}
            findings.append(Finding(error.key, (*path, name), quantities.spelt(data)))
    if findings:
        raise ModelError(findings)

    def place_and_rates(at: Array) -> Array:
        at = np.asarray(at, dtype=float)
        jet = Jet([at, np.ones_like(at), np.zeros_like(at)])
        rows = []
        for tree in trees:
            with np.errstate(all="ignore"):
                value: Any = evaluate(tree, lambda name: jet if name.text == "t" else values[name.text])
            rows.append((value if isinstance(value, Jet) else Jet.constant(value, 2)).d)
        return np.array([[np.broadcast_to(row[k], at.shape) for row in rows] for k in range(3)], dtype=float)

    tried = place_and_rates(np.linspace(0.0, 1.0, 257))
    if not np.isfinite(tried).all():
        where = float(np.linspace(0.0, 1.0, 257)[~np.isfinite(tried).all(axis=(0, 1))][0])
        raise ModelError([Finding("workspace.path-value", path, {"u": where})])
    size = float(np.ptp(tried[0], axis=1).max())
    closed = bool(np.hypot(*(tried[0, :, -1] - tried[0, :, 0])) <= SAME * size)
    return TargetPath(place_and_rates, closed, path=path)


def _strange(node: Node, quantities: Quantities) -> str | None:
    """A name that can't stand in a path's formula."""
    for part in nodes(node):
        if isinstance(part, Name) and part.text not in ("u", "pi", *quantities.parameters):
            return part.text
        if isinstance(part, Call) and (part.attribute is not None or part.name not in FUNCTIONS):
            return part.name
    return None


def _timed(node: Node) -> Node:
    """The tree with u as a number that runs: the time in seconds."""
    if isinstance(node, Name) and node.text == "u":
        return Binary("/", Name("t"), Number(1.0, "s"))
    if isinstance(node, Negative):
        return Negative(_timed(node.of))
    if isinstance(node, Binary):
        return Binary(node.op, _timed(node.left), _timed(node.right))
    if isinstance(node, Call) and node.attribute is None:
        return Call(node.name, tuple(_timed(arg) for arg in node.args))
    return node
