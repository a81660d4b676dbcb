"""Where a mechanism's expressions stand: the dimension that each place wants, and the names that may stand there."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import Enum

from linkwright.model import units as u
from linkwright.model.actions import Measure
from linkwright.model.dimensions import Wanted, argument, value
from linkwright.model.fields import Expression, FrozenDict, Position
from linkwright.model.mechanism import Mechanism, Spring
from linkwright.model.motions import ARGUMENT
from linkwright.model.pins import homes
from linkwright.model.tolerances import tolerance_parts
from linkwright.model.units import Dimension

Path = tuple[str | int, ...]


class Scope(Enum):
    """What an expression may name besides parameters and functions."""

    CONSTANT = "constant"
    LOAD = "load"
    TIME = "time"
    SIGNALS = "signals"
    FORMULA = "formula"
    TURN = "turn"


@dataclass(frozen=True)
class Place:
    """One expression of a file: its path, the dimension wanted there, and what it may name; ``names`` has what the
    place itself gives a meaning, with its dimension."""

    path: Path
    expression: Expression
    wanted: Wanted
    scope: Scope = Scope.CONSTANT
    names: Mapping[str, Dimension] = FrozenDict()


OF_FORMULA = FrozenDict({ARGUMENT: u.PURE})
"""What a motion law's formula names."""


def measured(name: str) -> Wanted:
    """The unknown dimension of a measure, which its bounds share."""
    return (f"measure {name}", 0)


FIGURES = {"path": u.LENGTH, "straightness": u.LENGTH, "dwell": u.TIME}
"""What a reduction gives where that isn't of the kind of its signal."""


def figure(name: str, measure: Measure) -> Wanted:
    """What a measure's figure is, and so its bounds, its wrap and its unit."""
    return FIGURES.get(measure.reduction) or measured(name)


def crossed(name: str) -> Wanted:
    """The unknown dimension of the signal that bounds a window."""
    return (f"window {name}", 0)


def instant(name: str) -> Wanted:
    """The unknown dimension of the expression that places a value in time."""
    return (f"where {name}", 0)


def position_parts(position: Position) -> tuple[tuple[Expression, Dimension], tuple[Expression, Dimension]]:
    """The two expressions of a position with their dimensions."""
    return (position.first, u.LENGTH), (position.second, u.ANGLE if position.polar else u.LENGTH)


def places(m: Mechanism) -> Iterator[Place]:
    """Every expression of a mechanism, the definitions of its parameters first."""
    for name, parameter in m.parameters.items():
        yield Place(("parameters", name), parameter.value, name)
        for key, part in tolerance_parts(parameter.tolerance):
            yield Place(("parameters", name, "tolerance", *key), part, _TOLERANCE.get(key, name))
    if m.plane is not None and m.plane.within is not None:
        yield Place(("plane", "within"), m.plane.within, u.LENGTH)
    for g in m.gravity.parts if m.gravity else ():
        yield Place(("gravity",), g, u.ACCELERATION)
    yield from _links(m)
    yield from _actions(m)
    yield from _elements(m)
    yield from _tables(m)
    yield from _laws(m)
    for name, window in m.windows.items():
        if isinstance(window, tuple):
            yield from (Place(("windows", name), edge, u.TIME) for edge in window)
        else:
            for signal, edges in window.items():
                at: Path = ("windows", name, signal)
                yield Place(at, Expression(signal), crossed(name), Scope.SIGNALS)
                yield from (Place(at, edge, crossed(name)) for edge in edges)
    for name, measure in m.measures.items():
        yield from _measure(m, name, measure)
        if name in m.require:
            bounds = m.require[name].bounds
            yield from (Place(("require", name), bound, figure(name, measure)) for bound in bounds)


_TOLERANCE: dict[tuple[str, ...], Wanted] = {("cp",): u.PURE, ("side",): u.LENGTH}
"""What stands in a parameter's tolerance and isn't of the parameter's own dimension."""


def _links(m: Mechanism) -> Iterator[Place]:
    for name, link in m.links.items():
        at: Path = ("links", name)
        for point, position in link.points.items():
            yield from _position((*at, "points", point), position)
        if link.com:
            yield from _position((*at, "com"), link.com)
        if link.mass is not None:
            yield Place((*at, "mass"), link.mass, u.MASS)
        if link.inertia is not None:
            yield Place((*at, "inertia"), link.inertia, u.INERTIA)
        if link.shape and link.shape.radius:
            yield Place((*at, "shape"), link.shape.radius, u.LENGTH)
    for name, joint in m.joints.items():
        for i, line in enumerate(joint.line or ()):
            yield Place(("joints", name, "line", i), line.angle, u.ANGLE)
        yield from (Place(("joints", name, "travel"), edge, u.LENGTH) for edge in joint.travel or ())
    for name, cylinder in m.cylinders.items():
        yield from (Place(("cylinders", name, "length"), edge, u.LENGTH) for edge in cylinder.length or ())
    for name, rule in m.assembly.items():
        if rule.sketch:
            yield from _position(("assembly", name), rule.sketch)


def _actions(m: Mechanism) -> Iterator[Place]:
    for name, drive in m.drives.items():
        at: Path = ("drives", name)
        span, rate = (u.ANGLE, u.OMEGA) if m.prescribed(name).turns else (u.LENGTH, u.SPEED)
        if drive.speed is not None:
            yield Place((*at, "speed"), drive.speed, rate)
        if drive.start is not None:
            yield Place((*at, "start"), drive.start, span)
        if drive.acceleration is not None:
            yield Place((*at, "acceleration"), drive.acceleration, u.ALPHA if span == u.ANGLE else u.ACCELERATION)
        if drive.position is not None:
            yield Place((*at, "position"), drive.position, span, Scope.TIME)
    for name, cam in m.cams.items():
        at = ("cams", name)
        yield Place((*at, "phase"), cam.phase, u.ANGLE)
        for path, contact in cam.contacts(at):
            for key in ("base", "roller"):
                if (radius := getattr(contact, key)) is not None:
                    yield Place((*path, key), radius, u.LENGTH)
            if contact.face is not None:
                yield Place((*path, "face"), contact.face.angle, u.ANGLE)
    for name, load in m.loads.items():
        at = ("loads", name)
        if isinstance(load.at, Position):
            yield from _position((*at, "at"), load.at)
        for part, dimension in load.parts:
            yield Place((*at, "torque" if part is load.torque else "force"), part, dimension, Scope.LOAD)
        window = m.windows.get(load.window) if load.window else None
        for signal in window if isinstance(window, dict) else ():
            yield Place((*at, "window"), Expression(signal), crossed(str(load.window)), Scope.LOAD)


def _elements(m: Mechanism) -> Iterator[Place]:
    for name, spring in m.springs.items():
        at: Path = ("springs", name)
        for key, dimension in spring_dimensions(spring).items():
            given = getattr(spring, key)
            for part in given if isinstance(given, tuple) else (given,) if given is not None else ():
                yield Place((*at, key), part, dimension)
        if spring.table:
            # As if the table were called there, which tells the units of its columns.
            key, one, value = ("torque", "1 rad", u.TORQUE) if spring.torsional else ("force", "1 m", u.FORCE)
            yield Place((*at, key), Expression(f"{spring.table}({one})"), value, Scope.TIME)
    for name, weight in m.counterweights.items():
        at = ("counterweights", name)
        yield Place((*at, "mass"), weight.mass, u.MASS)
        if isinstance(weight.at, Position):
            yield from _position((*at, "at"), weight.at)
        if weight.inertia is not None:
            yield Place((*at, "inertia"), weight.inertia, u.INERTIA)


def spring_dimensions(spring: Spring) -> dict[str, Dimension]:
    """The dimensions of a spring's numbers by key."""
    if spring.torsional:
        return {
            "stiffness": u.TORSIONAL_STIFFNESS,
            "free": u.ANGLE,
            "preload": u.TORQUE,
            "damping": u.TORSIONAL_DAMPING,
        }
    keys = {"stiffness": u.STIFFNESS, "free": u.LENGTH, "preload": u.FORCE, "damping": u.DAMPING}
    return {**keys, "gas": u.FORCE, "progression": u.PURE, "exponent": u.PURE, "length": u.LENGTH}


def _position(path: Path, position: Position) -> Iterator[Place]:
    return (Place(path, expression, dimension) for expression, dimension in position_parts(position))


def _tables(m: Mechanism) -> Iterator[Place]:
    for name, table in m.tables.items():
        for i, (x, y) in enumerate(table.points or ()):
            yield Place(("tables", name, "points", i), x, argument(name))
            yield Place(("tables", name, "points", i), y, value(name))
        if table.period is not None:
            yield Place(("tables", name, "period"), table.period, argument(name))


def _laws(m: Mechanism) -> Iterator[Place]:
    for name, law in m.laws.items():
        at: Path = ("laws", name)
        yield from (Place((*at, *key), number, dimension) for key, number, dimension in law.numbers())
        for i, segment in enumerate(law.segments):
            if segment.formula is not None:
                yield Place((*at, "segments", i, "formula"), segment.formula, u.PURE, Scope.FORMULA, OF_FORMULA)


def _measure(m: Mechanism, name: str, measure: Measure) -> Iterator[Place]:
    at: Path = ("measures", name)
    if measure.point is None:
        banded: Wanted = (f"dwell {name}", 0)
        wanted = measured(name) if measure.within is None else banded
        yield Place((*at, measure.reduction), measure.signal, wanted, Scope.SIGNALS)
        if measure.within is not None:
            yield Place((*at, "within"), measure.within, banded)
    elif measure.point in homes(m):
        wanted = u.SPEED if measure.path else u.LENGTH
        yield Place((*at, measure.reduction), measure.signal, wanted, Scope.SIGNALS)
    yield from (Place((*at, "wrap"), edge, figure(name, measure)) for edge in measure.wrap or ())
    if (when := measure.instant) and when.expression:
        yield Place((*at, "where"), Expression(when.expression), instant(name), Scope.SIGNALS)
