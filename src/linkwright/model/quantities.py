"""The numbers of a mechanism in SI: dimensions inferred over the whole file, parameters evaluated."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from graphlib import CycleError, TopologicalSorter
from typing import Any

from linkwright.model import units as u
from linkwright.model.dimensions import DimensionError, Dimensions
from linkwright.model.expressions import Call, Name, Node, evaluate, is_signal, nodes
from linkwright.model.fields import Expression, Position
from linkwright.model.findings import Finding
from linkwright.model.mechanism import Mechanism
from linkwright.model.signals import Signals, near
from linkwright.model.units import Dimension, UnitError, spelled, unit

Path = tuple[str | int, ...]
Place = tuple[Path, Expression, Dimension | None]


class Quantities:
    """Binds a mechanism's expressions to SI. ``findings`` says what doesn't fit; values need none of them."""

    def __init__(self, mechanism: Mechanism) -> None:
        self.mechanism = mechanism
        self.signals = Signals(mechanism)
        self.findings: list[Finding] = []
        self.declared = self._declared()
        parameters = {name: parameter.value.node for name, parameter in mechanism.parameters.items()}
        self.dimensions = Dimensions(self.declared, parameters, self._known)
        self._bound: dict[tuple[str, Dimension | None], Node] = {}
        self.order = self._order(parameters)
        self._infer()
        self.parameters: dict[str, float] = {}
        if not self.findings:
            self._evaluate_parameters()

    def _declared(self) -> dict[str, str]:
        declared = self.mechanism.units.declared
        for base, word in list(declared.items()):
            try:
                fits = unit(word)[1].physical == u.BASE_DIMENSIONS[base].physical
            except UnitError:
                fits = False
            if not fits:
                self._note("units.wrong", ("units", base), word=word, base=base)
                del declared[base]
        return declared

    def _note(self, code: str, path: Path, **data: Any) -> None:
        self.findings.append(Finding(code, path, data))

    def _known(self, node: Name | Call) -> Any:
        if is_signal(node):
            return self.signals.find(node).dimension
        if isinstance(node, Call):
            return self._table(node)
        if u.is_unit(node.text):
            raise DimensionError("expression.unit-alone", name=node.text)
        known = [*self.mechanism.parameters, "t", "pi"]
        raise DimensionError("name.unknown-parameter", name=node.text, near=near(node.text, known))

    def _table(self, node: Call) -> tuple[Dimension, Dimension]:
        table = self.mechanism.tables.get(node.name)
        if table is None:
            from linkwright.model.expressions import FUNCTIONS

            raise DimensionError(
                "expression.unknown-function", name=node.name, near=near(node.name, [*FUNCTIONS, *self.mechanism.tables])
            )
        if table.points:
            x, y = table.points[0]
            return self.dimensions.dimension(x.node), self.dimensions.dimension(y.node)
        return column_unit(table.x)[1], column_unit(table.y)[1]

    def _order(self, parameters: dict[str, Node]) -> list[str]:
        needs = {
            name: {n.text for n in nodes(node) if isinstance(n, Name) and n.text in parameters}
            for name, node in parameters.items()
        }
        try:
            return list(TopologicalSorter(needs).static_order())
        except CycleError as error:
            self._note("parameters.cycle", ("parameters", error.args[1][0]), cycle=" -> ".join(error.args[1]))
            return []

    def _infer(self) -> None:
        listed = list(places(self.mechanism))
        # Lone names and numbers first: they settle the power of angle, which later uses may only confirm.
        listed.sort(key=lambda place: not isinstance(place[1].node, Name))
        faulty = set()
        for path, expression, dimension in listed:
            if dimension is not None and not self._try(path, lambda e=expression, d=dimension: self.dimensions.use(e.node, d)):
                faulty.add(path)
        for name in self.order:
            self._try(("parameters", name), lambda n=name: self.dimensions.define(n))
        for name in self.order:
            self._try(("parameters", name), lambda n=name: self._bind_parameter(n))
        for path, expression, dimension in listed:
            if path not in faulty:
                self._try(path, lambda e=expression, d=dimension: self.bind(e, d))

    def _try(self, path: Path, action: Callable[[], object]) -> bool:
        try:
            action()
        except DimensionError as error:
            finding = Finding(error.key, path, error.data)
            if finding not in self.findings:
                self.findings.append(finding)
            return False
        return True

    def _bind_parameter(self, name: str) -> Node:
        return self.bind(self.mechanism.parameters[name].value, self.dimensions.of(name))

    def _evaluate_parameters(self) -> None:
        for name in self.order:
            try:
                value = float(evaluate(self._bind_parameter(name), lambda n: self.parameters[n.text]))
                fine = value == value and abs(value) < 1e300
            except (ArithmeticError, ValueError, TypeError):
                fine = False
            if not fine:
                self._note("parameters.value", ("parameters", name), text=self.mechanism.parameters[name].value.text)
                return
            self.parameters[name] = value

    def bind(self, expression: Expression, dimension: Dimension | None) -> Node:
        """The expression's tree with every number in SI, for a place of ``dimension`` (its own where None)."""
        key = (expression.text, dimension)
        if key not in self._bound:
            self._bound[key] = self.dimensions.bind(expression.node, dimension)
        return self._bound[key]

    def value(self, expression: Expression, dimension: Dimension | None) -> float:
        """The value in SI at the nominal parameters."""
        return float(evaluate(self.bind(expression, dimension), lambda name: self.parameters[name.text]))

    def unit_of(self, dimension: Dimension) -> tuple[str, float]:
        """The unit in which a quantity goes out, and its SI value: as declared, else SI."""
        try:
            text = spelled(dimension, self.declared, strict=False)
        except UnitError:
            text = spelled(dimension.physical, {}, strict=False) if dimension.physical == u.PURE else "SI"
            return text, 1.0
        return text, unit(text)[0] if text else 1.0


def column_unit(text: str | None) -> tuple[float, Dimension]:
    """The unit of ``'COLUMN UNIT'``: its SI value and dimension."""
    words = (text or "").split(None, 1)
    try:
        return unit(words[1]) if len(words) == 2 else (1.0, u.PURE)
    except UnitError as error:
        raise DimensionError("table.unit", text=text or "", unit=str(error)) from None


def position_parts(position: Position) -> tuple[tuple[Expression, Dimension], tuple[Expression, Dimension]]:
    """The two expressions of a position with their dimensions."""
    return (position.first, u.LENGTH), (position.second, u.ANGLE if position.polar else u.LENGTH)


def places(m: Mechanism) -> Iterator[Place]:
    """Every expression of a mechanism with its path and the dimension wanted there."""
    if m.gravity:
        yield from (((("gravity", i), g, u.ACCELERATION)) for i, g in enumerate(m.gravity))
    for name, link in m.links.items():
        at: Path = ("links", name)
        for point, position in link.points.items():
            yield from _position((*at, "points", point), position)
        if link.com:
            yield from _position((*at, "com"), link.com)
        if link.mass is not None:
            yield (*at, "mass"), link.mass, u.MASS
        if link.inertia is not None:
            yield (*at, "inertia"), link.inertia, u.INERTIA
        if link.shape and link.shape.radius:
            yield (*at, "shape"), link.shape.radius, u.LENGTH
    for name, joint in m.joints.items():
        for i, line in enumerate(joint.line or ()):
            yield ("joints", name, "line", i), line.angle, u.ANGLE
    for name, rule in m.assembly.items():
        if rule.sketch:
            yield from _position(("assembly", name), rule.sketch)
    for name, drive in m.drives.items():
        value, rate = (u.ANGLE, u.OMEGA) if drive.turns else (u.LENGTH, u.SPEED)
        for key, dimension in (("speed", rate), ("start", value), ("position", value)):
            if (expression := getattr(drive, key)) is not None:
                yield ("drives", name, key), expression, dimension
    for name, load in m.loads.items():
        at = ("loads", name)
        if isinstance(load.at, Position):
            yield from _position((*at, "at"), load.at)
        forces = load.force if isinstance(load.force, tuple) else (load.force,) if load.force else ()
        yield from (((*at, "force"), force, u.FORCE) for force in forces)
        if load.torque is not None:
            yield (*at, "torque"), load.torque, u.TORQUE
    yield from _table_places(m)
    yield from _measure_places(m)


def _position(path: Path, position: Position) -> Iterator[Place]:
    yield from ((path, expression, dimension) for expression, dimension in position_parts(position))


def _table_places(m: Mechanism) -> Iterator[Place]:
    for name, table in m.tables.items():
        for i, (x, y) in enumerate(table.points or ()):
            yield ("tables", name, "points", i), x, None
            yield ("tables", name, "points", i), y, None


def _measure_places(m: Mechanism) -> Iterator[Place]:
    for name, window in m.windows.items():
        if isinstance(window, tuple):
            yield from ((("windows", name), edge, u.TIME) for edge in window)
    for name, measure in m.measures.items():
        yield ("measures", name, measure.reduction), measure.signal, None
