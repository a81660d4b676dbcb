"""Springs, dampers and gas springs: between two points along the line that joins them, or torsional between links.

A force is positive in tension, a torque where it turns its link back: both work to reduce the length or angle.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from typing import Annotated, Any, ClassVar, Self

import numpy as np
from pydantic import Field

from linkwright.elements.entries import ForceEntry, NumberFault
from linkwright.elements.fields import PART_LENGTH, Interval, TwoLinks
from linkwright.elements.force import (
    Array,
    AskedTable,
    Between,
    ForceContext,
    ForceKind,
    ForceReports,
    Misfit,
    SignalChart,
    SignalLimits,
    Use,
    register,
)
from linkwright.elements.joint import Applied, Restated
from linkwright.elements.mirror import Mirror, NotMirroredError, Reflection
from linkwright.elements.points import FRAME, links_of_points
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Name
from linkwright.expressions.language import Name as Signal
from linkwright.expressions.typed_fields import Named, Path, Quantity, Ref, Scope, Sign
from linkwright.expressions.units import Dimension
from linkwright.expressions.written import Fault
from linkwright.findings import Finding, Joined, Term
from linkwright.notation import Pair, Scalar, Vec, Wrench
from linkwright.notation.jets import call

TABLE = Named("function")
_BETWEEN_POINTS = ("from", "to", "in", "length", "force", "gas", "progression", "exponent")
_AT_JOINT = ("turns", "on", "torque")
_LINEAR, _GAS = ("free", "preload"), ("progression", "exponent")


def _end_point_ref(place: int) -> Ref:
    """A point of the link that stands at this place under `in`, where that is given."""
    return Ref("point", of=lambda c: None if c.entry.in_ is None else str(c.entry.in_[place]))


def _law(linear: Dimension, torsional: Dimension, sign: Sign = Sign.NOT_NEGATIVE) -> Quantity:
    """A quantity of a spring between two points, and of a torsional one."""
    return Quantity(lambda c: torsional if c.entry.torsional else linear, sign)


_FREE = Quantity(
    lambda c: u.ANGLE if c.entry.torsional else u.LENGTH,
    lambda c: Sign.ANY if c.entry.torsional else Sign.NOT_NEGATIVE,
)


class Spring(ForceEntry):
    """A spring, damper or gas spring: between two points along the line that joins them, or torsional between links."""

    kind: ClassVar[str] = "spring"

    from_: Annotated[Name | None, _end_point_ref(0)] = Field(None, alias="from")
    to: Annotated[Name | None, _end_point_ref(1)] = None
    in_: TwoLinks | None = Field(None, alias="in")
    turns: Annotated[Name | None, Ref("link")] = None
    on: Annotated[Name | None, Ref("link")] = None
    stiffness: Annotated[Expression | None, _law(u.STIFFNESS, u.TORSIONAL_STIFFNESS)] = None
    free: Annotated[Expression | None, _FREE] = None
    preload: Annotated[Expression | None, _law(u.FORCE, u.TORQUE, Sign.ANY)] = None
    damping: Annotated[Expression | None, _law(u.DAMPING, u.TORSIONAL_DAMPING)] = None
    force: Annotated[Name | None, TABLE] = None
    torque: Annotated[Name | None, TABLE] = None
    gas: Annotated[Expression | None, Quantity(u.FORCE, Sign.POSITIVE)] = None
    progression: Annotated[Expression | None, Quantity(u.PURE, Sign.NOT_NEGATIVE)] = None
    exponent: Annotated[Expression | None, Quantity(u.PURE, Sign.POSITIVE)] = None
    length: Annotated[Interval | None, PART_LENGTH] = None

    def mirrored(self, name: str, mirror: Mirror) -> Self:
        """The same spring seen in a mirror. A torsional one turns the other way round; its table can't."""
        if not self.torsional:
            return self
        if self.torque is not None:
            raise NotMirroredError
        seen = {"free": mirror.angle(self.turns or FRAME, self.on or FRAME), "preload": Reflection(True)}
        stated = {key: value for key in seen if (value := getattr(self, key)) is not None}
        return self.model_copy(update={key: seen[key].image(value) for key, value in stated.items()})

    def number_faults(self, value: Callable[[Expression, Dimension], Any]) -> Iterator[NumberFault]:
        if self.gas is not None and self.progression is not None:
            above = value(self.progression, u.PURE) - 1.0
            yield above, Sign.POSITIVE, ("spring.progression", {}, "progression")

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        between, torsional = {"from", "to"} & set(given), {"turns", "on"} & set(given)
        if len(between) + len(torsional) != 2 or (between and torsional):
            yield "spring.ends", {}
            return
        strays = [key for key in (_AT_JOINT if between else _BETWEEN_POINTS) if key in given]
        laws = [key for key in ("stiffness", "force", "torque", "gas") if key in given and key not in strays]
        strays += [key for key in _LINEAR if key in given and "stiffness" not in given]
        strays += [key for key in _GAS if key in given and "gas" not in given and key not in strays]
        if strays:
            yield "spring.stray", {"keys": Joined(strays)}
        if len(laws) > 1 or not (laws or "damping" in given):
            yield "spring.law", {"given": Joined(laws) or "-"}
        if "stiffness" in given and "free" not in given:
            yield "spring.free", {}
        if "gas" in given and between and not {"progression", "length"} <= set(given):
            yield "spring.gas", {}

    @property
    def torsional(self) -> bool:
        """Whether it turns two links against each other, rather than pulls at two points."""
        return self.turns is not None

    @property
    def table(self) -> str | None:
        """The table of its force over the length, or of its torque over the angle."""
        return self.torque if self.torsional else self.force

    @property
    def measure(self) -> str:
        """The signal over which its law goes: ``angle`` or ``length``."""
        return "angle" if self.torsional else "length"

    @property
    def effort(self) -> str:
        """The signal of what it does: ``torque`` or ``force``."""
        return "torque" if self.torsional else "force"

    def end_points(self, mechanism: Any) -> tuple[tuple[str, str], tuple[str, str]]:
        """Link and point of each end of one between two points; a pinned point counts as its first link's."""
        points = (str(self.from_), str(self.to))
        first = links_of_points(mechanism)
        links = self.in_ or (first[points[0]], first[points[1]])
        return (links[0], points[0]), (links[1], points[1])


SIGNALS = {"length": u.LENGTH, "v": u.SPEED, "force": u.FORCE, "power": u.POWER, "energy": u.ENERGY}
QUADRATURE = 32
"""The points at which the force of a gas is asked on its way."""
TORSION_SIGNALS = {"angle": u.ANGLE, "omega": u.OMEGA, "torque": u.TORQUE, "power": u.POWER, "energy": u.ENERGY}


@register
class Springs(ForceKind[Spring]):
    """Springs, dampers and gas springs."""

    name = "spring"
    section = "springs"
    entry = Spring
    usual = True
    stores = True
    orders = {"length": 0, "angle": 0, "energy": 0}
    charts = (
        SignalChart("spring_length", "motion", "length"),
        SignalChart("spring_force", "force", "force"),
        SignalChart("spring_torque", "force", "torque"),
    )

    def signals(self, entry: Spring) -> Mapping[str, Dimension]:
        return TORSION_SIGNALS if entry.torsional else SIGNALS

    def effort(self, entry: Spring) -> str:
        return entry.effort

    def faults(self, mechanism: Any, path: Path, entry: Spring) -> Iterator[Finding]:
        points = links_of_points(mechanism)
        ends: tuple[str | None, str | None] = (entry.turns, entry.on)
        if not entry.torsional:
            ends = entry.in_ or (points.get(str(entry.from_)), points.get(str(entry.to)))
        if ends[0] is not None and ends[0] == ends[1]:
            yield Finding("spring.same-link", path, {"name": ends[0]})

    def implied_expressions(self, mechanism: Any, entry: Spring) -> Iterator[Use]:
        if entry.table:
            key, one, value = ("torque", "1 rad", u.TORQUE) if entry.torsional else ("force", "1 m", u.FORCE)
            yield Use(key, Expression(f"{entry.table}({one})"), value, Scope.TIME)

    def needed_tables(self, name: str, entry: Spring) -> tuple[AskedTable, ...]:
        argument = Signal(f"{name}.{entry.measure}")
        return tuple(AskedTable(entry.table, argument, integral) for integral in (False, True)) if entry.table else ()

    def counted_angle(self, entry: Spring) -> tuple[str, str] | None:
        return (str(entry.turns), str(entry.on)) if entry.torsional else None

    def start_angle(
        self, entry: Spring, value: Callable[[Expression, Dimension], Any], middle: Callable[[str], float]
    ) -> Any:
        if entry.table:
            return middle(entry.table)
        return 0.0 if entry.free is None else value(entry.free, u.ANGLE)

    def wrenches(self, context: ForceContext, name: str, entry: Spring) -> Iterator[tuple[str, Wrench]]:
        force = _effort(context, name, entry)
        if entry.torsional:
            for link, moment in ((entry.turns, -force), (entry.on, force)):
                about = context.bodies[str(link)].anchor.now
                yield str(link), Wrench(Pair(0.0, 0.0), moment, about)
            return
        start, end = _places(context, entry)
        gap, length = end.minus(start).now, _stretch(context, name, entry, 0)
        (a, _), (b, _) = entry.end_points(context.geometry.mechanism)
        pull = Pair(force * gap.x / length, force * gap.y / length)
        yield a, Wrench(pull, 0.0, start.now)
        yield b, Wrench(Pair(-pull.x, -pull.y), 0.0, end.now)

    def energy(self, context: ForceContext, name: str, entry: Spring) -> Scalar:
        return _elastic(context, name, entry)[1]

    def signal(self, context: ForceContext, name: str, entry: Spring, attribute: str) -> Scalar:
        if attribute == "energy":
            return self.energy(context, name, entry)
        if attribute == entry.effort:
            return _effort(context, name, entry)
        if attribute == "power":
            return -_effort(context, name, entry) * _stretch(context, name, entry, 1)
        return _stretch(context, name, entry, int(attribute != entry.measure))

    # The proof: the law of the spring once more, in plain NumPy, from reported poses and rates.

    def reported(self, entry: Spring) -> tuple[str, ...]:
        return entry.measure, entry.effort

    def applied(self, reports: ForceReports, name: str, entry: Spring) -> list[Applied]:
        x, rate, _, _ = _reported_state(reports, name, entry)
        return _pulled(reports, name, entry, _elastic_force(reports, entry, x) + _damping_force(reports, entry, rate))

    def dissipative_forces(self, reports: ForceReports, name: str, entry: Spring) -> list[Applied]:
        return _pulled(reports, name, entry, _damping_force(reports, entry, _reported_state(reports, name, entry)[1]))

    def misfits(self, reports: ForceReports, name: str, entry: Spring) -> list[Misfit]:
        x, rate, _, _ = _reported_state(reports, name, entry)
        force = _elastic_force(reports, entry, x) + _damping_force(reports, entry, rate)
        return [Misfit(reports.rows[f"{name}.{entry.effort}"] - force, not entry.torsional)]

    def restated(self, reports: ForceReports, name: str, entry: Spring) -> dict[str, Restated]:
        """Length and rate from the places and velocities of both ends, the rest by its law there."""
        x, rate, _, _ = _reported_state(reports, name, entry)
        force = _elastic_force(reports, entry, x) + _damping_force(reports, entry, rate)
        return {
            entry.measure: Restated(x),
            "omega" if entry.torsional else "v": Restated(rate),
            entry.effort: Restated(force),
            "power": Restated(-force * rate),
            "energy": Restated(self.stored(reports, name, entry)),
        }

    def stored(self, reports: ForceReports, name: str, entry: Spring) -> Array:
        """The work that stretches it from where it stores nothing: of a straight line of force half the sum of its
        ends, of a table its area, of a gas the work of an adiabatic change by quadrature."""
        x, _, _, _ = _reported_state(reports, name, entry)
        if entry.table:
            return reports.table_area(entry.table, x)
        if entry.gas is not None:
            assert entry.length is not None
            long = float(reports.geometry.number(entry.length[1], u.LENGTH))
            nodes, weights = np.polynomial.legendre.leggauss(QUADRATURE)
            places = long + (x - long)[:, None] * (nodes + 1) / 2
            forces = _elastic_force(reports, entry, places)
            return np.asarray((forces * weights).sum(axis=1) * (x - long) / 2)
        ends = _elastic_force(reports, entry, x) + _stated_number(reports, entry, "preload")
        return np.asarray(ends / 2 * (x - _stated_number(reports, entry, "free")))

    # What is told of it.

    def limits(self, entry: Spring) -> SignalLimits | None:
        return None if entry.length is None else SignalLimits("length", entry.length)

    def distance(self, entry: Spring) -> str:
        return "" if entry.torsional else "length"

    def pull(self, entry: Spring) -> tuple[str, int] | None:
        return None if entry.torsional else ("force", 1 if entry.gas is None else -1)

    def outline(self, mechanism: Any, entry: Spring) -> Between | None:
        if entry.torsional:
            return None
        links, points = zip(*entry.end_points(mechanism), strict=True)
        return Between(links, points, "coil" if entry.stiffness or entry.table else "strut")

    def sentence(
        self, name: str, entry: Spring, effort: float, shown: Callable[[float, Dimension], str]
    ) -> Term | None:
        form, ends = ("torsional", (entry.turns, entry.on)) if entry.torsional else ("between", (entry.from_, entry.to))
        sense = "none" if not math.isfinite(effort) else "pull" if effort >= 0 else "push"
        size = shown(abs(effort), u.TORQUE if entry.torsional else u.FORCE) if sense != "none" else ""
        does = Term(f"spring-{form}-{sense}", effort=size, link=entry.turns)
        return Term(f"spring-{form}", name=name, start=ends[0], end=ends[1], does=does)


def _number(context: ForceContext, entry: Spring, key: str, default: float = 0.0) -> Scalar:
    """One of a spring's numbers (SI)."""
    given = getattr(entry, key)
    return default if given is None else context.geometry.number(given, entry.dimension(key))


def _places(context: ForceContext, entry: Spring) -> tuple[Vec, Vec]:
    """The places of its two ends."""
    geometry = context.geometry
    (a, p), (b, q) = entry.end_points(geometry.mechanism)
    return context.bodies[a].point(geometry.point(a, p)), context.bodies[b].point(geometry.point(b, q))


def _stretch(context: ForceContext, name: str, entry: Spring, order: int) -> Scalar:
    """Length (m) or angle (rad), or its rate (order 1)."""
    if not entry.torsional:
        start, end = _places(context, entry)
        gap = end.minus(start)
        return gap.dot(gap).sqrt().d[order]
    turned, base = (context.bodies[str(link)] for link in (entry.turns, entry.on))
    if order:
        return turned.turn.d[0] - base.turn.d[0]
    return turned.heading - base.heading + 2 * math.pi * context.turns(name)


def _column(stroke: Scalar, progression: Scalar, exponent: Scalar) -> Scalar:
    """The length of the gas column of an extended gas spring, from p V^n = constant (Bauer 2011, ch. 2)."""
    return stroke / (1 - progression ** (-1 / exponent))


def _elastic(context: ForceContext, name: str, entry: Spring) -> tuple[Scalar, Scalar]:
    """The force or torque that its length or angle makes, and the energy stored (N, J or N m, J)."""
    x = _stretch(context, name, entry, 0)
    if entry.table:
        argument = Signal(f"{name}.{entry.measure}")
        return context.lookup(entry.table, argument), context.lookup(entry.table, argument, integral=True)
    if entry.gas is not None:
        assert entry.length is not None
        push, n = _number(context, entry, "gas"), _number(context, entry, "exponent", 1.0)
        short, long = (context.geometry.number(edge, u.LENGTH) for edge in entry.length)
        h = _column(long - short, _number(context, entry, "progression"), n)
        grown = call("log", h / (h - (long - x)))  # NaN where it is pushed in past its gas
        stored = h * grown
        if not (isinstance(n, float) and n == 1):
            other = h / (n - 1) * (call("exp", (n - 1) * grown) - 1)
            stored = call("where", abs(n - 1) < 1e-9, stored, other)
        return -push * call("exp", n * grown), push * stored
    k, preload = _number(context, entry, "stiffness"), _number(context, entry, "preload")
    if entry.stiffness is None:
        return 0.0, 0.0
    over = x - _number(context, entry, "free")
    return preload + k * over, (preload + k * over / 2) * over


def _effort(context: ForceContext, name: str, entry: Spring) -> Scalar:
    """Its force (N, positive in tension) or torque (N m, positive where it turns back), damping included."""
    force = _elastic(context, name, entry)[0]
    if entry.damping is None:
        return force
    return force + _number(context, entry, "damping") * _stretch(context, name, entry, 1)


def _stated_number(reports: ForceReports, entry: Spring, key: str, default: float = 0.0) -> float:
    """One of its numbers (SI)."""
    given = getattr(entry, key)
    return default if given is None else float(reports.geometry.number(given, entry.dimension(key)))


def _elastic_force(reports: ForceReports, entry: Spring, x: Array) -> Array:
    """Force (N, positive in tension) or torque (N m, positive where it turns back) at lengths (m) or angles (rad)."""
    if entry.table:
        return reports.table(entry.table, x)
    if entry.gas is not None:
        assert entry.length is not None
        short, long = (float(reports.geometry.number(edge, u.LENGTH)) for edge in entry.length)
        n = _stated_number(reports, entry, "exponent", 1.0)
        # The pressure falls as the volume rises; volumes over the rod's section, extended 1.
        filled = 1 - _stated_number(reports, entry, "progression") ** (-1 / n)
        with np.errstate(invalid="ignore", divide="ignore"):
            volume = 1 - filled * (long - x) / (long - short)
            return np.asarray(-_stated_number(reports, entry, "gas") * np.exp(-n * np.log(volume)))
    if entry.stiffness is None:
        return np.zeros_like(x)
    over = x - _stated_number(reports, entry, "free")
    return _stated_number(reports, entry, "preload") + _stated_number(reports, entry, "stiffness") * over


def _damping_force(reports: ForceReports, entry: Spring, rate: Array) -> Array:
    """The force or torque of its damping at rates (m/s, rad/s)."""
    return _stated_number(reports, entry, "damping") * rate


def _reported_state(
    reports: ForceReports, name: str, entry: Spring
) -> tuple[Array, Array, Array, list[tuple[str, Array]]]:
    """Its length or angle, the rate of that, its direction, and link and place of each end.

    Of an angle only the whole turns are taken from the report.
    """
    if not entry.torsional:
        geometry = reports.geometry
        ends = [
            (link, reports.point_position(link, geometry.point(link, p)))
            for link, p in entry.end_points(geometry.mechanism)
        ]
        (a, start), (b, end) = ends
        gap = end - start
        length = np.hypot(*gap)
        with np.errstate(invalid="ignore", divide="ignore"):
            along = gap / length
        rate = ((reports.velocity(b, end) - reports.velocity(a, start)) * along).sum(axis=0)
        return length, rate, along, ends
    nowhere = np.zeros((2, reports.count))
    links = [str(entry.turns), str(entry.on)]
    (c, s), (c0, s0) = (reports.rotated(link, (1.0, 0.0)) for link in links)
    angle = np.arctan2(s * c0 - c * s0, c * c0 + s * s0)
    turns = np.round((reports.rows[f"{name}.angle"] - angle) / (2 * np.pi))
    omega, omega0 = (reports.omega(link) for link in links)
    return angle + 2 * np.pi * turns, omega - omega0, nowhere, [(link, nowhere) for link in links]


def _pulled(reports: ForceReports, name: str, entry: Spring, force: Array) -> list[Applied]:
    """What a force along its direction, or a torque, does to both its links."""
    _, _, along, ends = _reported_state(reports, name, entry)
    found: list[Applied] = []
    for (link, place), sign in zip(ends, (1.0, -1.0), strict=True):
        if entry.torsional:
            found.append((link, np.zeros((2, reports.count)), place, -sign * force))
        else:
            found.append((link, sign * force * along, place, 0.0))
    return found
