"""Measured outputs: a CSV file beside the model or points in it, and at which time of the run each row was taken."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions import units as u
from linkwright.expressions.dimensions import DimensionError, declared_scale
from linkwright.expressions.fields import Expression
from linkwright.expressions.language import Node
from linkwright.expressions.units import Dimension, UnitError, unit
from linkwright.expressions.unknown import near
from linkwright.expressions.unknown_units import unknown_unit
from linkwright.findings import Finding, Joined, ModelError
from linkwright.kernels import Compiled
from linkwright.model.csv_file import finite, listed, read_csv
from linkwright.results import Run
from linkwright.results.stationary import bracketed
from linkwright.studies.numbers import constant, positive
from linkwright.studies.sampling_options import of_signals, signal_faults

Array = NDArray[np.float64]
Path_ = tuple[str | int, ...]

PATH: Path_ = ("studies", "accuracy", "calibrate")
MAX_ROWS = 10_000
LOOK = 1 << 11
"""Steps of the run on which rows' places are looked for."""
SAME = 1e-7
"""Poses whose outputs differ by no more than this share of their span are one."""
_HEADER = re.compile(r"\s*(.*?)\s*(?:\[([^\[\]]*)\])?\s*", re.S)


@dataclass(frozen=True)
class MeasuredColumn:
    """What a column holds: an expression of signals or ``t``, its dimension, the SI value of its unit."""

    text: str
    tree: Node | None
    dimension: Dimension
    unit: str
    size: float


@dataclass(frozen=True, eq=False)
class MeasuredRows:
    """Rows of measurements in SI: the place of each, ``at`` (rows,), and ``values`` (outputs, rows), NaN where a cell
    is empty; ``numbers`` are those of the rows in their file."""

    place: MeasuredColumn
    outputs: tuple[MeasuredColumn, ...]
    at: Array
    values: Array
    numbers: tuple[int, ...]
    path: Path_


def driving(compiled: Compiled) -> list[str]:
    """The signals that say where a motion is: values of drives, angles of the links that they turn on the frame."""
    found = []
    for name, drive in compiled.mechanism.movers.items():
        shown = compiled.mechanism.prescribed(name)
        found.append(f"{name}.angle" if shown.turns else f"{name}.s")
        if drive.turns and drive.on == "frame":
            found.append(f"{drive.turns}.angle")
    return found


def read(
    compiled: Compiled, raw: Sequence[Mapping[str, Expression]], at: str | None
) -> tuple[MeasuredRows | None, list[Finding]]:
    """Points that stand in the model, and what is wrong with them."""
    path, names = (*PATH, "points"), list(dict.fromkeys(name for row in raw for name in row))
    place, outputs, findings = _columns(compiled, [(name, None) for name in names], at, path)
    columns = {column.text: column for column in (*outputs, *([place] if place else []))}
    rows = []
    for i, row in enumerate(raw):
        numbers = dict.fromkeys(names, np.nan)
        for name, expression in row.items():
            column = columns.get(name)
            if column is not None:
                value, wrong = constant(compiled.quantities, expression, column.dimension, (*path, i, name))
                findings += wrong
                numbers[name] = np.nan if value is None else value
        if place and place.text not in row:
            findings.append(Finding("accuracy.measured-number", (*path, i), {"row": i + 1, "name": place.text}))
        rows.append([numbers[name] for name in names])
    return _sheet(place, outputs, names, rows, range(1, len(raw) + 1), path, findings)


def read_file(
    compiled: Compiled, file: str, at: str | None, folder: Path | None
) -> tuple[MeasuredRows | None, list[Finding]]:
    """A CSV file, and what is wrong with it. Its first line names the columns, with units as in ``E.x [mm]``."""
    path = (*PATH, "file")
    try:
        measured = read_csv(file, folder, path, MAX_ROWS)
    except ModelError as error:
        return None, [*error.findings]
    matches = [(head, _HEADER.fullmatch(head)) for head in measured.heads]
    headers = [(match[1], match[2]) if match else (head, None) for head, match in matches]
    place, outputs, findings = _columns(compiled, headers, at, path)
    sizes = {column.text: column.size for column in (*outputs, *([place] if place else []))}
    rows = []
    for number, cells in measured.rows:
        row = []
        for i, (name, _) in enumerate(headers):
            cell = cells[i].strip() if i < len(cells) else ""
            value = finite(cell)
            row.append(value * sizes.get(name, 1.0))
            if (cell and np.isnan(value)) or (not cell and place and name == place.text):
                findings.append(Finding("accuracy.measured-number", path, {"row": number, "name": name[:60]}))
        rows.append(row)
    return _sheet(place, outputs, [n for n, _ in headers], rows, [n for n, _ in measured.rows], path, findings)


def _sheet(
    place: MeasuredColumn | None,
    outputs: list[MeasuredColumn],
    names: list[str],
    rows: list[list[float]],
    numbers: Sequence[int],
    path: Path_,
    findings: list[Finding],
) -> tuple[MeasuredRows | None, list[Finding]]:
    if not findings and (not rows or not outputs):
        findings = [Finding("accuracy.nothing-measured", path)]
    if findings or place is None:
        return None, findings
    table = np.array(rows, dtype=float).T
    others = [i for i, name in enumerate(names) if name != place.text]
    if empty := [names[i] for i in others if np.isnan(table[i]).all()]:
        return None, [Finding("accuracy.empty-column", path, {"name": name[:60]}) for name in empty]
    return MeasuredRows(place, tuple(outputs), table[names.index(place.text)], table[others], tuple(numbers), path), []


def _columns(
    compiled: Compiled, headers: Sequence[tuple[str, str | None]], at: str | None, path: Path_
) -> tuple[MeasuredColumn | None, list[MeasuredColumn], list[Finding]]:
    """The column of places, those of outputs, and what is wrong with them."""
    names, known = [name for name, _ in headers], ["t", *driving(compiled)]
    where = at or next((name for name in names if name in known), None)
    findings: list[Finding] = []
    if where not in names or where not in known or names.count(where) > 1:
        data = {"given": listed(names), "known": Joined(known)}
        findings.append(Finding("accuracy.no-place", path, data))
    place, outputs = None, []
    for name, written in headers:
        column = (
            _time(compiled, written, path, findings)
            if name == "t"
            else _column(compiled, name, written, path, findings)
        )
        if name == where and name in known:
            place = column
        elif column is not None and name == "t":
            if where in known:  # else that is told
                findings.append(Finding("study.no-output", path, {"text": name, "near": near(name, driving(compiled))}))
        elif column is not None:
            outputs.append(column)
    return place, outputs, findings


def _time(compiled: Compiled, written: str | None, path: Path_, findings: list[Finding]) -> MeasuredColumn | None:
    return _sized(compiled, "t", None, u.TIME, written, path, findings)


def _column(
    compiled: Compiled, name: str, written: str | None, path: Path_, findings: list[Finding]
) -> MeasuredColumn | None:
    quantities = compiled.quantities
    expression: Expression | None
    try:
        expression = Expression(name)
    except ValueError:
        expression = None
    if expression is None or not of_signals(expression):
        findings.append(Finding("study.no-output", path, {"text": name[:60], "near": near(name, driving(compiled))}))
        return None
    if wrong := signal_faults(compiled, expression, path):
        findings += wrong
        return None
    tree = quantities.dimensions.bind(expression.node, None)
    dimension = quantities.dimensions.dimension(expression.node)
    return _sized(compiled, name, tree, dimension, written, path, findings)


def _sized(
    compiled: Compiled,
    name: str,
    tree: Node | None,
    dimension: Dimension,
    written: str | None,
    path: Path_,
    findings: list[Finding],
) -> MeasuredColumn | None:
    """A column with its unit: the one written in its name, else the declared one."""
    quantities = compiled.quantities
    try:
        if written is not None:
            size, own = unit(written)
            if own.physical != dimension.physical:
                data = {"name": name[:60], "unit": written[:40], "usual": quantities.unit_of(dimension)[0]}
                findings.append(Finding("accuracy.measured-unit", path, data))
                return None
            return MeasuredColumn(name, tree, dimension, written, size)
        size = declared_scale(dimension, quantities.declared)
    except UnitError as error:
        findings.append(Finding("units.unknown", path, unknown_unit(written or "", error)))
        return None
    except DimensionError as error:
        findings.append(Finding(error.key, path, quantities.spelt(error.data)))
        return None
    return MeasuredColumn(name, tree, dimension, quantities.unit_of(dimension)[0], size)


def times(run: Run, sheet: MeasuredRows) -> tuple[Array, list[Finding]]:
    """The time (s) of each row on the nominal motion, (rows,); rows without one, or with several of other outputs."""
    if sheet.place.text == "t":
        span = run.stop - run.start
        outside = (sheet.at < run.start - 1e-9 * span) | (sheet.at > run.stop + 1e-9 * span)
        findings = [_nowhere(sheet, row) for row in np.flatnonzero(outside).tolist()]
        return np.clip(sheet.at, run.start, run.stop), findings
    return _looked_up(run, sheet)


def _nowhere(sheet: MeasuredRows, row: int) -> Finding:
    value, column = sheet.at[row] / sheet.place.size, sheet.place
    data = {"row": sheet.numbers[row], "name": column.text, "value": f"{value:.6g}", "unit": column.unit}
    return Finding("accuracy.no-pose", sheet.path, data)


def _looked_up(run: Run, sheet: MeasuredRows) -> tuple[Array, list[Finding]]:
    name = [sheet.place.text]
    grid = np.linspace(run.start, run.stop, max(run.grid, LOOK) + 1)
    y = run.evaluate(name, grid)[0]
    turn = 2 * np.pi if sheet.place.dimension == u.ANGLE else np.inf
    low, high, near = y.min(), y.max(), 1e-9 * max(float(np.ptp(y)), 1e-30)
    rows, targets = [], []
    for row, value in enumerate(sheet.at):
        first, last = (np.ceil((low - near - value) / turn), np.floor((high + near - value) / turn))
        several = [0.0] if turn == np.inf else np.arange(first, last + 1) * turn
        rows += [row] * len(several)
        targets += [value + whole for whole in several]
    found: list[list[float]] = [[] for _ in sheet.at]
    brackets: list[tuple[int, float, float, float]] = []
    for row, target in zip(rows, targets, strict=True):
        off = y - target
        found[row] += grid[np.abs(off) <= near].tolist()
        through = (np.minimum(off[:-1], off[1:]) < -near) & (np.maximum(off[:-1], off[1:]) > near)
        brackets += [(row, target, grid[i], grid[i + 1]) for i in np.flatnonzero(through)]
    if brackets:
        owner, wanted, a, b = (np.array(part) for part in zip(*brackets, strict=True))
        roots = bracketed(lambda t, k: run.evaluate(name, t)[0] - wanted[k], np.arange(wanted.size), a, b)
        for row, root in zip(owner.tolist(), roots.tolist(), strict=True):
            found[row].append(root)
    at, findings = np.full(sheet.at.shape, np.nan), []
    for row, places in enumerate(found):
        if not places:
            findings.append(_nowhere(sheet, row))
            continue
        at[row] = places[0]
        if len(places) > 1 and not _same(run, sheet, np.array(places)):
            data: dict[str, Any] = {
                "row": sheet.numbers[row],
                "name": name[0],
                "times": Joined(f"{t:.6g} s" for t in places[:5]),
            }
            findings.append(Finding("accuracy.several-poses", sheet.path, data))
    return at, findings


def _same(run: Run, sheet: MeasuredRows, t: Array) -> bool:
    """Whether all outputs are the same at some times."""
    every = np.concatenate([t, run.t])
    for column in sheet.outputs:
        assert column.tree is not None
        values = run.jets(column.tree, every).d[0]
        off = values[: t.size] - values[0]
        if column.dimension == u.ANGLE:
            off = (off + np.pi) % (2 * np.pi) - np.pi
        if not (np.abs(off) <= SAME * max(float(np.ptp(values)), 1e-30)).all():
            return False
    return True


def sigmas(compiled: Compiled, sheet: MeasuredRows, given: Mapping[str, Expression]) -> tuple[Array, list[Finding]]:
    """The standard deviation of each output in SI, NaN where none is given, and what is wrong with them."""
    found, findings = _sigmas(compiled, sheet.outputs, given)
    return found, [*_unknown(sheet, given), *findings]


def check_sigmas(compiled: Compiled, given: Mapping[str, Expression]) -> list[Finding]:
    """What is wrong with the standard deviations of a file's columns before it is read; that tells their units too."""
    outputs = _columns(compiled, [(name, None) for name in given], None, (*PATH, "sigma"))[1]
    return _sigmas(compiled, outputs, given)[1]


def _sigmas(
    compiled: Compiled, outputs: Sequence[MeasuredColumn], given: Mapping[str, Expression]
) -> tuple[Array, list[Finding]]:
    found, findings = np.full(len(outputs), np.nan), list[Finding]()
    for i, column in enumerate(outputs):
        if (expression := given.get(column.text)) is None:
            continue
        path, text = (*PATH, "sigma", column.text), expression.text[:40]
        value, wrong = positive(compiled.quantities, expression, column.dimension, path, "accuracy.sigma", sigma=text)
        findings += wrong
        found[i] = np.nan if value is None else value
    return found, findings


def _unknown(sheet: MeasuredRows, given: Mapping[str, Expression]) -> Iterator[Finding]:
    known = [column.text for column in sheet.outputs]
    for name in given:
        if name not in known:
            yield Finding("accuracy.not-measured", (*PATH, "sigma", name), {"name": name[:60], "known": Joined(known)})
