"""The laws of a mechanism's drives and tables, as functions of time with exact rates."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from linkwright.expressions import units as u
from linkwright.expressions.dimensions import DimensionError
from linkwright.expressions.language import Call, Name, Node, evaluate, is_signal, nodes
from linkwright.findings import Finding, ModelError
from linkwright.kernels.followers import follower_law
from linkwright.kernels.law import Array, DriveLaw, Parameters, must_be_finite
from linkwright.kernels.motion_faults import jump
from linkwright.kernels.motions import StatedMotion
from linkwright.kernels.tables import StatedTable, stated_values
from linkwright.laws import DEGREES, OutsideTable
from linkwright.model.csv_file import CsvFile, read_csv
from linkwright.model.mechanism import Table
from linkwright.model.quantities import Quantities, column_unit
from linkwright.notation import MAX_ORDER, Jet

ORDER = MAX_ORDER + 1
MAX_ROWS = 100_000


def drive_laws(
    quantities: Quantities, folder: Path | None, motions: Mapping[str, StatedMotion], named: bool = True
) -> tuple[dict[str, DriveLaw], list[Finding]]:
    """The law of each drive (value and rates, SI) over times (s), and what is wrong with them. Unless all elements are
    ``named`` rightly there is no geometry that a follower could be laid on: those are left out."""
    reader = _LawReader(quantities, folder, motions)
    laws: dict[str, DriveLaw] = {}
    m = quantities.mechanism
    for name in (*m.drives, *(m.followers if named else ())):
        law = reader.law(name) if name in m.drives else reader.follower(name, laws)
        if law is not None:
            laws[name] = law
    return laws, reader.findings


def action_tables(quantities: Quantities, folder: Path | None) -> tuple[dict[str, StatedTable], list[Finding]]:
    """The tables that are asked by what acts, and what is wrong with them."""
    m = quantities.mechanism
    acting = [*m.acting()]
    parts = (n for one in acting for part, _ in one.kind.laws(one.entry) for n in nodes(part.node))
    names = [n.name for n in parts if isinstance(n, Call)]
    names += [asked.table for one in acting for asked in one.kind.needed_tables(one.name, one.entry)]
    tables: dict[str, StatedTable] = {}
    findings: list[Finding] = []
    for name in dict.fromkeys(name for name in names if name in m.tables):
        try:
            tables[name] = read_table(quantities, name, folder)
        except ModelError as error:
            findings += error.findings
    return tables, findings


def values_at(laws: dict[str, DriveLaw], time: float) -> dict[str, float]:
    """Each drive's value (rad or m) at one time (s)."""
    return {name: float(np.asarray(law(np.array([time])).d[0]).flat[0]) for name, law in laws.items()}


class _LawReader:
    def __init__(self, quantities: Quantities, folder: Path | None, motions: Mapping[str, StatedMotion]) -> None:
        self.quantities, self.folder, self.motions = quantities, folder, motions
        self.findings: list[Finding] = []
        self.tables: dict[str, StatedTable | None] = {}

    def law(self, name: str) -> DriveLaw | None:
        """A drive's law, tried at t = 0."""
        drive = self.quantities.mechanism.drives[name]
        dimension = self.quantities.drive_dimension(name)
        turning = dimension == u.ANGLE
        if self.quantities.mechanism.path_law(name) is not None:
            return self._tried(name, ("paths", str(drive.output)), self.quantities.law(name))
        if drive.position is None:
            if drive.start is None or drive.speed is None:
                return None  # a fault that is told already
            return self._constant([self.quantities.bind(part, of) for part, of in drive.uniform(turning)])
        return self._tried(name, ("drives", name, "position"), self.quantities.bind(drive.position, dimension))

    def _tried(self, name: str, path: tuple[str, ...], node: Node) -> DriveLaw | None:
        """The law that an expression gives, tried at t = 0; ``path`` is its place in the file."""
        for part in nodes(node):
            if isinstance(part, Name | Call) and is_signal(part):
                self.findings.append(Finding("drive.signal", path, {"name": getattr(part, "text", "force")}))
                return None
            if isinstance(part, Call) and not self._has_function(part.name, path):
                return None
        law = self._expression(name, path, node)
        try:
            law(np.zeros(1))
        except ModelError as error:
            self.findings += error.findings
            return None
        return law

    def follower(self, name: str, laws: Mapping[str, DriveLaw]) -> DriveLaw | None:
        """The law of a follower, behind that of its motor."""
        follower = self.quantities.mechanism.followers[name]
        motor, path = laws.get(follower.motor), self.quantities.mechanism.path_of(name)
        if motor is None or not all(self._has_function(law, (*path, key)) for key, law in follower.laws.items()):
            return None
        return follower_law(self.quantities, name, self.motions, motor)

    def _law(self, of: Callable[[Array, Parameters, bool], Jet], *parts: Node) -> DriveLaw:
        every = [n for part in parts for n in nodes(part)]
        names = {n.text for n in every if isinstance(n, Name)}
        for n in every:
            if isinstance(n, Call) and (function := self.motions.get(n.name) or self.tables.get(n.name)) is not None:
                names |= function.names
        return DriveLaw(of, self.quantities.parameters, frozenset(names & self.quantities.parameters.keys()))

    def _constant(self, parts: list[Node]) -> DriveLaw:
        def law(t: Array, parameters: Parameters, strict: bool) -> Jet:
            with np.errstate(all="ignore"):
                return uniform(t, *(evaluate(node, lambda name: parameters[name.text]) for node in parts))

        return self._law(law, *parts)

    def _expression(self, drive: str, path: tuple[str, ...], node: Node) -> DriveLaw:
        tables, motions = self.tables, self.motions

        def law(t: Array, parameters: Parameters, strict: bool) -> Jet:
            time = Jet([t, 1.0 + 0.0 * t, *[0.0 * t] * (ORDER - 1)])

            def name_value(name: Name) -> Any:
                return time if name.text == "t" else parameters[name.text]

            def call_value(call: Call) -> Jet:
                argument = evaluate(call.args[0], name_value, call_value)
                x = argument if isinstance(argument, Jet) else Jet.constant(argument, ORDER)
                if call.name in motions:
                    return motions[call.name].at_parameters(parameters).on(x)
                table = tables[call.name]
                assert table is not None
                asked = table.at_parameters(parameters)
                return asked(x) if strict else asked.or_nan(x)

            try:
                with np.errstate(all="ignore"):
                    value = evaluate(node, name_value, call_value)
            except OutsideTable as error:
                data = {"drive": drive, "at": error.at, "low": error.low, "high": error.high}
                raise ModelError([Finding("drive.outside-table", path, data)]) from None
            except ZeroDivisionError:
                value = np.nan
            jet = value if isinstance(value, Jet) else Jet.constant(value, ORDER)
            if strict:
                must_be_finite("drive.not-finite", path, {"drive": drive}, t, jet)
            return jet

        return self._law(law, node)

    def _has_function(self, name: str, path: tuple[str | int, ...]) -> bool:
        """Whether a function that a position calls can be asked."""
        m = self.quantities.mechanism
        if name in m.laws:
            return name in self.motions and self._smooth(name, path)
        return name not in m.tables or self._table(name, path)

    def _smooth(self, name: str, path: tuple[str | int, ...]) -> bool:
        """Whether the value and velocity of a motion law run on without jumps."""
        jumps = [*jump(self.quantities, name, self.motions[name], path)]
        self.findings += jumps
        return not jumps

    def _table(self, name: str, path: tuple[str | int, ...]) -> bool:
        if name not in self.tables:
            try:
                self.tables[name] = read_table(self.quantities, name, self.folder)
            except ModelError as error:
                self.findings += error.findings
                self.tables[name] = None
        table = self.tables[name]
        if table is not None and table.degree == 1:
            self.findings.append(Finding("drive.linear-table", path, {"table": name}))
            return False
        return table is not None


def uniform(t: Array, start: Any, speed: Any, acceleration: Any = 0.0) -> Jet:
    """A value that changes with constant acceleration; value and speed are those at t = 0."""
    zero = 0.0 * t
    value = start + speed * t + acceleration / 2 * t**2
    return Jet([value, speed + acceleration * t, zero + acceleration, *[zero] * (ORDER - 2)])


def constant_acceleration(start: float, speed: float, acceleration: float = 0.0) -> DriveLaw:
    """A drive of constant acceleration, or of constant speed; value and speed are those at t = 0."""
    return DriveLaw(lambda t, parameters, strict: uniform(t, start, speed, acceleration), {})


def read_table(quantities: Quantities, name: str, folder: Path | None) -> StatedTable:
    """A table's interpolant in SI. Raises :class:`ModelError` naming what is wrong with it."""
    table: Table = quantities.mechanism.tables[name]
    path, file = ("tables", name), None
    if table.points is not None:
        rows = [[quantities.value(value, None) for value in point] for point in table.points]
        argument = quantities.dimensions.dimension(table.points[0][0].node) if table.points else u.PURE
    else:
        file, rows, argument = _file_rows(table, name, folder)
    points = np.array(rows, dtype=float).reshape(-1, 2)
    degree = DEGREES[table.between]
    if len(points) < degree + 1:
        raise ModelError([Finding("table.short", path, {"given": len(points), "wanted": degree + 1})])
    steps = np.diff(points[:, 0])
    known = np.isfinite(points).all(axis=1)
    if not known.all() or (steps <= 0).any():
        row = int(np.argmin(known)) + 1 if not known.all() else int(np.argmax(steps <= 0)) + 2
        row = row if file is None else file.rows[row - 1][0]
        raise ModelError([Finding("table.order", path, {"row": row})])
    period = quantities.value(table.period, argument) if table.period else None
    if table.period is not None and not np.isfinite(period or 0.0):
        raise ModelError([Finding("value.not-finite", (*path, "period"), {"text": table.period.text[:60]})])
    if period is not None and period < points[-1, 0] - points[0, 0] - 1e-12 * abs(period):
        raise ModelError([Finding("table.period", path, {})])
    whole = period is not None and np.isclose(points[-1, 0] - points[0, 0], period, rtol=1e-12)
    if whole and not np.isclose(points[-1, 1], points[0, 1], rtol=1e-9, atol=1e-12 * float(np.ptp(points[:, 1]) or 1)):
        raise ModelError([Finding("table.not-closed", path, {})])
    if whole:
        points[-1, 1] = points[0, 1]
    values = stated_values(quantities, table)
    try:
        return StatedTable(points[:, 0], points[:, 1], degree, period, values, quantities.parameters)
    except np.linalg.LinAlgError:
        raise ModelError([Finding("table.uneven", path, {})]) from None


def _file_rows(table: Table, name: str, folder: Path | None) -> tuple[CsvFile, list[list[float]], u.Dimension]:
    assert table.file is not None
    path = ("tables", name, "file")
    try:
        (x_unit, argument), (y_unit, _) = column_unit(table.x), column_unit(table.y)
    except DimensionError as error:
        raise ModelError([Finding(error.key, ("tables", name), error.data)]) from None
    file = read_csv(table.file, folder, path, MAX_ROWS)
    columns = [file.column((text or "").split()[0]) for text in (table.x, table.y)]
    return file, [[x * x_unit, y * y_unit] for x, y in file.numbers(columns)], argument
