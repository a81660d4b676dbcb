"""Friction in pins, slides and contacts: Coulomb's, of a coefficient that may follow the motion, and viscous.

Coulomb's friction follows from the reaction that it helps to make. Its size is the coefficient times the sum of the
forces with which the joint's seats press: a pin has one, which presses with the whole reaction and at the pin's radius
(the circle of friction: Beer, Johnston, Vector Mechanics for Engineers: Statics, ch. 8), a guide of length l has
its two ends, which press with N/2 + M/l and N/2 - M/l. The sum of these is the larger of |N| and 2 |M|/l. In a loop of
slides, as with wedges, statics doesn't know the moment, and the guide has one seat, which presses with N.

A moment or force is positive where it drives the first link with the motion to the positive side; friction never does.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from itertools import takewhile
from typing import Annotated, Any, ClassVar, Self

import numpy as np
from pydantic import Field

from linkwright.elements.entries import ForceEntry, NumberFault
from linkwright.elements.fields import TwoLinks
from linkwright.elements.force import (
    Array,
    Break,
    ForceContext,
    ForceKind,
    ForceReports,
    Misfit,
    Reactions,
    Resistance,
    Seats,
    SignalChart,
    register,
)
from linkwright.elements.joint import Applied, Restated
from linkwright.elements.mirror import Mirror
from linkwright.elements.pins import pins
from linkwright.elements.touch import Reacting
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Name
from linkwright.expressions.language import FUNCTIONS, Call, is_signal, nodes
from linkwright.expressions.language import Name as Signal
from linkwright.expressions.typed_fields import Context, Path, Quantity, Ref, Scope, Sign
from linkwright.expressions.units import Dimension
from linkwright.expressions.written import Fault
from linkwright.findings import Finding, Joined, Term
from linkwright.notation import Pair, Scalar, Wrench
from linkwright.notation.jets import call

_PLACES = {"pin": ("in", "radius"), "slide": ("length",), "contact": ("radius",)}
"""Where there may be friction, and the keys that go with it."""


def _sign_of_coefficient(context: Context) -> Sign:
    return _sign_of(context.entry.coefficient)


def _sign_of(coefficient: Expression) -> Sign:
    """A number mustn't be negative; what follows the motion is looked at in a run."""
    parts = [*nodes(coefficient.node)]
    follows = any(is_signal(part) or part == Signal("t") for part in parts)
    asks = any(isinstance(part, Call) and part.name not in FUNCTIONS for part in parts)
    return Sign.ANY if follows or asks else Sign.NOT_NEGATIVE


_COEFFICIENT = Quantity(u.PURE, _sign_of_coefficient, scope=Scope.LOAD)


class Friction(ForceEntry):
    """Friction in a pin, slide or contact: Coulomb's with a coefficient, viscous, or both."""

    kind: ClassVar[str] = "friction"

    pin: Annotated[Name | None, Ref("pin")] = None
    slide: Annotated[Name | None, Ref("slide")] = None
    contact: Annotated[Name | None, Ref("touching")] = None
    in_: TwoLinks | None = Field(None, alias="in")
    radius: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE)] = None
    length: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE)] = None
    coefficient: Annotated[Expression | None, _COEFFICIENT] = None
    static: Annotated[Expression | None, Quantity(u.PURE, Sign.NOT_NEGATIVE)] = None
    viscous: Annotated[
        Expression | None,
        Quantity(lambda c: u.DAMPING if c.entry.pin is None else u.TORSIONAL_DAMPING, Sign.NOT_NEGATIVE),
    ] = None

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        places = [place for place in _PLACES if place in given]
        if len(places) != 1:
            yield "friction.place", {}
            return
        others = {key: None for keys in _PLACES.values() for key in keys if key not in _PLACES[places[0]]}
        if strays := [key for key in others if key in given]:
            yield "friction.stray", {"keys": Joined(strays)}
        if "coefficient" not in given and "viscous" not in given:
            yield "friction.law", {}
        if "static" in given and "coefficient" not in given:
            yield "friction.static", {}
        if "coefficient" in given and "pin" in given and "radius" not in given:
            yield "friction.size", {"key": "radius"}

    def number_faults(self, value: Callable[[Expression, Dimension], Any]) -> Iterator[NumberFault]:
        """That it resists no less at the start of a motion than in it, where both are numbers."""
        constant = self.coefficient is not None and _sign_of(self.coefficient) is Sign.NOT_NEGATIVE
        if self.static is not None and self.coefficient is not None and constant:
            more = value(self.static, u.PURE) - value(self.coefficient, u.PURE)
            data = {"static": self.static.text[:40], "coefficient": self.coefficient.text[:40]}
            yield more, Sign.NOT_NEGATIVE, ("friction.static-less", data, "static")

    def mirrored(self, name: str, mirror: Mirror) -> Self:
        """The same friction seen in a mirror: it works against the motion either way."""
        if self.coefficient is None:
            return self
        return self.model_copy(update={"coefficient": mirror.expression(self.coefficient)})

    @property
    def turns(self) -> bool:
        """Whether it is in a pin, and a moment."""
        return self.pin is not None

    @property
    def rate(self) -> str:
        """The signal of the speed against which it works: ``omega`` or ``v``."""
        return "omega" if self.turns else "v"

    @property
    def effort(self) -> str:
        """The signal of what it does: ``moment`` or ``force``."""
        return "moment" if self.turns else "force"

    @property
    def joint(self) -> str:
        """The pin, slide or contact."""
        return str(self.pin or self.slide or self.contact)

    def rubs_like(self, other: Friction) -> bool:
        """Whether another entry is of the same place, between the same links."""
        own, others = ((one.pin, one.slide, one.contact) for one in (self, other))
        return own == others and (self.in_ is None or other.in_ is None or {*self.in_} == {*other.in_})

    def links(self, mechanism: Any) -> tuple[str, str]:
        """The link that moves and the one against which: of a pin the two of ``in``, else the last and the first
        on it; of a slide the second and the first; of a contact those that touch."""
        if self.in_ is not None:
            return self.in_
        if self.contact is not None:
            found = (mechanism.followers.get(self.contact) or mechanism.joints[self.contact]).touching
            return str(found[0]), str(found[1])
        links = pins(mechanism)[self.joint].links if self.turns else mechanism.joints[self.joint].links
        return links[1], links[0]


PIN_SIGNALS = {"omega": u.OMEGA, "moment": u.TORQUE, "power": u.POWER}
LOOP_SIGNALS = {"v": u.SPEED, "force": u.FORCE, "normal": u.FORCE, "power": u.POWER}
CONTACT_SIGNALS = {"v": u.SPEED, "force": u.FORCE, "power": u.POWER}
SLIDE_SIGNALS = {"v": u.SPEED, "force": u.FORCE, "ahead": u.FORCE, "behind": u.FORCE, "power": u.POWER}
SEATS = {"normal": 0, "ahead": 0, "behind": 1}
"""The seat of a slide that a signal is of."""
VAGUE = 1e-9
"""A speed below this share of the largest one has a sign that round-off may decide: there the report is believed."""
NONE = 1e-9
"""A reported effort below this share of what its law makes of the reaction is none, as at rest."""


@register
class Frictions(ForceKind[Friction]):
    """Friction in pins and slides."""

    name = "friction"
    section = "friction"
    entry = Friction
    usual = True
    resists = True
    order = 2
    orders = {"omega": 1, "v": 1}
    charts = (
        SignalChart("friction_moment", "force", "moment"),
        SignalChart("friction_force", "force", "force"),
    )

    def signals(self, entry: Friction) -> Mapping[str, Dimension]:
        if entry.contact is not None:
            return CONTACT_SIGNALS
        if entry.slide is not None and entry.length is None:
            return LOOP_SIGNALS
        return PIN_SIGNALS if entry.turns else SLIDE_SIGNALS

    def effort(self, entry: Friction) -> str:
        return entry.effort

    def faults(self, mechanism: Any, path: Path, entry: Friction) -> Iterator[Finding]:
        before = takewhile(lambda name: name != path[-1], mechanism.friction)
        twice = next((name for name in before if mechanism.friction[name].rubs_like(entry)), None)
        if twice is not None:
            yield Finding("friction.twice", path, {"other": twice, "joint": entry.joint})
        if entry.contact is not None:
            rolls = getattr(mechanism.followers.get(entry.contact), "roller", None) is not None
            if entry.radius is not None and not rolls:
                yield Finding("friction.no-roller", (*path, "radius"), {"name": entry.contact})
            elif rolls and entry.radius is None and entry.coefficient is not None:
                yield Finding("friction.roller", path, {"name": entry.contact})
        if entry.turns and entry.joint in (known := pins(mechanism)):
            links = known[entry.joint].links
            data = {"pin": entry.joint, "links": Joined(links)}
            if entry.in_ is None and len(links) > 2:
                yield Finding("friction.pin-links", path, data)
            elif entry.in_ is not None and not {*entry.in_} <= {*links}:
                yield Finding("friction.not-on-pin", (*path, "in"), data)
            elif entry.in_ is not None and entry.in_[0] == entry.in_[1]:
                yield Finding("friction.same-link", (*path, "in"), {"name": entry.in_[0]})

    def laws(self, entry: Friction) -> tuple[tuple[Expression, Dimension], ...]:
        return () if entry.coefficient is None else ((entry.coefficient, u.PURE),)

    def breaks(self, name: str, entry: Friction, bind: Any) -> Iterator[Break]:
        if entry.coefficient is not None:
            yield Break(Signal(f"{name}.{entry.rate}"), jumps=True)
            ends = ("normal",) if entry.length is None else ("ahead", "behind")
            forces = [f"{name}.{end}" for end in ends if entry.slide is not None]
            forces += [f"{entry.contact}.force"] if entry.contact is not None else []
            for force in forces:
                yield Break(Signal(force), jumps=False)

    # What it does.

    def at_start(self, entry: Friction) -> Friction:
        """With the static coefficient."""
        return entry if entry.static is None else entry.model_copy(update={"coefficient": entry.static, "static": None})

    def rubs_in(self, entry: Friction) -> str:
        return entry.joint

    def moment_faults(self, path: Path, entry: Friction, known: bool) -> Iterator[Finding]:
        if entry.slide is None:
            return
        if not known and entry.length is not None:
            yield Finding("friction.loop", (*path, "length"), {"joint": entry.joint})
        elif known and entry.length is None and entry.coefficient is not None:
            yield Finding("friction.size", path, {"key": "length"})

    def resistance(self, context: ForceContext, name: str, entry: Friction) -> Resistance:
        speed = _speed(context, entry)
        factor: Scalar = 0.0
        if entry.coefficient is not None:
            coefficient = context.value(entry.coefficient, u.PURE)
            factor = -call("sign", speed) * coefficient * _arm(context.geometry, entry, coefficient)
        return Resistance(factor, 0.0 if entry.viscous is None else -_number(context, entry, "viscous") * speed)

    def seats(self, context: ForceContext, name: str, entry: Friction, reactions: Reactions) -> Seats:
        mechanism = context.geometry.mechanism
        wrench = reactions(entry.joint, entry.links(mechanism)[0])
        if entry.turns:
            return [(wrench.force.x, wrench.force.y)]
        if entry.contact is not None:
            return [(context.touch(entry.contact).normal.dot(wrench.force),)]
        first = mechanism.joints[entry.joint].links[0]
        across = context.bodies[first].direction(context.geometry.line(entry.joint, first)[1]).perp.now
        if entry.length is None:
            return [(across.dot(wrench.force),)]
        half, turning = across.dot(wrench.force) * 0.5, wrench.moment / _number(context, entry, "length")
        return [(half + turning,), (half - turning,)]

    def unit_wrenches(self, context: ForceContext, name: str, entry: Friction) -> Iterator[tuple[str, Wrench]]:
        geometry, bodies = context.geometry, context.bodies
        link, on = entry.links(geometry.mechanism)
        if entry.turns:
            unit = Wrench(Pair(0.0, 0.0), 1.0, bodies[on].point(geometry.pin_point(entry.joint, on)).now)
        elif entry.contact is not None:
            touch = context.touch(entry.contact)
            unit = Wrench(touch.along, 0.0, touch.place)
        else:
            place = bodies[link].point(geometry.line(entry.joint, link)[0]).now
            unit = Wrench(bodies[on].direction(geometry.line(entry.joint, on)[1]).now, 0.0, place)
        yield link, unit
        yield on, unit.opposite

    def wrenches(self, context: ForceContext, name: str, entry: Friction) -> Iterator[tuple[str, Wrench]]:
        effort = context.effort(name)
        for link, unit in self.unit_wrenches(context, name, entry):
            yield link, unit.times(effort)

    def signal(self, context: ForceContext, name: str, entry: Friction, attribute: str) -> Scalar:
        if attribute == entry.rate:
            return _speed(context, entry)
        if attribute in SEATS:
            return self.seats(context, name, entry, context.reaction)[SEATS[attribute]][0]
        effort = context.effort(name)
        return effort * _speed(context, entry) if attribute == "power" else effort

    # The proof: the law of friction once more, in plain NumPy, from reported reactions, poses and rates.

    def reported(self, entry: Friction) -> tuple[str, ...]:
        return (entry.effort,)

    def applied(self, reports: ForceReports, name: str, entry: Friction) -> list[Applied]:
        link, on = entry.links(reports.geometry.mechanism)
        effort = _resisting(reports, name, entry)
        if entry.turns:
            nothing = np.zeros((2, reports.count))
            return [(link, nothing, nothing, effort), (on, nothing, nothing, -effort)]
        place, along = _reported_sliding(reports, entry)
        return [(link, effort * along, place, 0.0), (on, -effort * along, place, 0.0)]

    def misfits(self, reports: ForceReports, name: str, entry: Friction) -> list[Misfit]:
        told = reports.rows[f"{name}.{entry.effort}"]
        return [Misfit(told - _resisting(reports, name, entry), not entry.turns)]

    def restated(self, reports: ForceReports, name: str, entry: Friction) -> dict[str, Restated]:
        """The speed from the velocities of both links, the forces of its seats from the reported reaction, the rest by
        the law of friction."""
        speed, _ = _reported_speed(reports, entry)
        effort = _resisting(reports, name, entry)
        found = {entry.rate: speed, entry.effort: effort, "power": effort * speed}
        if entry.slide is not None:
            normal, moment = _reported_seats(reports, entry)
            found["normal"] = normal
            if entry.length is not None:
                turning = moment / float(reports.geometry.number(entry.length, u.LENGTH))
                found |= {"ahead": normal / 2 + turning, "behind": normal / 2 - turning}
        return {attribute: Restated(value) for attribute, value in found.items()}

    # What is told of it.

    def sentence(self, name: str, entry: Friction, effort: float, shown: Any) -> Term:
        size = shown(abs(effort), u.TORQUE if entry.turns else u.FORCE)
        return Term("friction-in", name=name, joint=entry.joint, effort=size)


def _number(context: ForceContext, entry: Friction, key: str) -> Scalar:
    """One of its numbers (SI)."""
    return context.geometry.number(getattr(entry, key), entry.dimension(key))


def _arm(geometry: Any, entry: Friction, coefficient: Any) -> Any:
    """By what the coefficient counts: the radius (m) of a pin. A roller is turned by the force T on its rim, against
    the moment mu r sqrt(N^2 + T^2) of its pin: T = t N/sqrt(1 - t^2), with t = mu r over the roller's radius."""
    if entry.radius is None:
        return 1.0
    radius = geometry.number(entry.radius, u.LENGTH)
    if entry.contact is None:
        return radius
    share = radius / geometry.number(geometry.mechanism.followers[entry.contact].roller, u.LENGTH)
    return share / call("sqrt", 1.0 - (coefficient * share) * (coefficient * share))


def _speed(context: ForceContext, entry: Friction) -> Scalar:
    """The speed of its first link against the second (rad/s, or m/s along the line)."""
    geometry, bodies = context.geometry, context.bodies
    link, on = entry.links(geometry.mechanism)
    if entry.turns:
        return bodies[link].turn.d[0] - bodies[on].turn.d[0]
    if entry.contact is not None:
        return context.touch(entry.contact).sliding(bodies[link], bodies[on])
    (second, _), (first, heading) = geometry.line(entry.joint, link), geometry.line(entry.joint, on)
    between = bodies[link].point(second).minus(bodies[on].point(first))
    return between.dot(bodies[on].direction(heading)).d[1]


def _reported_sliding(reports: ForceReports, entry: Friction) -> tuple[Array, Array]:
    """Where it acts in a slide or contact, and the direction of sliding, from reported poses."""
    if entry.contact is not None:
        touch = reports.touch(entry.contact)
        return touch.place, touch.along
    link, on = entry.links(reports.geometry.mechanism)
    return reports.line(entry.joint, link)[0], reports.line(entry.joint, on)[1]


def _reported_seats(reports: ForceReports, entry: Friction) -> tuple[Array, Array | float]:
    """Of one in a slide the reported normal force (N) and moment (N m) of its first link on the second."""
    link, on = entry.links(reports.geometry.mechanism)
    force, moment = reports.reaction(Reacting(entry.joint, link, on))
    along = reports.line(entry.joint, on)[1]
    return np.asarray(along[0] * force[1] - along[1] * force[0]), moment


def _pressing(reports: ForceReports, entry: Friction) -> Array:
    """The sum of the forces (N) of its seats, from the reported reaction."""
    if entry.contact is not None:
        return np.asarray(np.abs(reports.touch(entry.contact).force))
    mechanism = reports.geometry.mechanism
    if entry.turns:
        link, on = entry.links(mechanism)
        alone = len(pins(mechanism)[entry.joint].links) == 2
        force, _ = reports.reaction(Reacting(entry.joint, link, on if alone else entry.joint))
        return np.asarray(np.hypot(*force))
    normal, moment = _reported_seats(reports, entry)
    if entry.length is None:
        return np.asarray(np.abs(normal))
    length = float(reports.geometry.number(entry.length, u.LENGTH))
    return np.asarray(np.maximum(np.abs(normal), 2 * np.abs(moment) / length))


def _reported_speed(reports: ForceReports, entry: Friction) -> tuple[Array, Array]:
    """The speed of its first link against the second (rad/s, m/s), and the sum of the sizes of both."""
    link, on = entry.links(reports.geometry.mechanism)
    if entry.turns:
        turning = [reports.omega(one) for one in (link, on)]
        return turning[0] - turning[1], np.abs(turning[0]) + np.abs(turning[1])
    place, along = _reported_sliding(reports, entry)
    velocities = [reports.velocity(one, place) for one in (link, on)]
    speed = ((velocities[0] - velocities[1]) * along).sum(axis=0)
    return speed, sum((np.hypot(*one) for one in velocities), np.zeros(reports.count))


def _friction_coefficient(reports: ForceReports, entry: Friction) -> Array:
    """The moment or force of Coulomb's friction over the force with which the joint presses: the coefficient; of a pin
    times its radius; of a roller, which the rim's force turns against its pin, the tangent of the angle by which the
    force leaves the normal, so that it touches the circle of friction."""
    coefficient = reports.value(entry.coefficient, u.PURE) if entry.coefficient is not None else np.zeros(reports.count)
    if entry.radius is None:
        return coefficient
    circle = coefficient * float(reports.geometry.number(entry.radius, u.LENGTH))
    if entry.contact is None:
        return circle
    roller = reports.geometry.mechanism.followers[entry.contact].roller
    with np.errstate(invalid="ignore"):
        return np.asarray(np.tan(np.arcsin(circle / float(reports.geometry.number(roller, u.LENGTH)))))


def _resisting(reports: ForceReports, name: str, entry: Friction) -> Array:
    """Its moment (N m) or force (N) on its first link by its law; at rest in the reported sense."""
    speed, largest = _reported_speed(reports, entry)
    effort = np.zeros(reports.count)
    if entry.viscous is not None:
        effort = effort - float(reports.geometry.number(entry.viscous, entry.dimension("viscous"))) * speed
    if entry.coefficient is None:
        return effort
    resisting = _friction_coefficient(reports, entry) * _pressing(reports, entry)
    told = reports.rows[f"{name}.{entry.effort}"] - effort
    vague = np.abs(speed) <= VAGUE * largest.max(initial=0.0)
    believed = np.where(np.abs(told) > NONE * np.abs(resisting), np.sign(told), 0.0)
    sense = np.where(vague, believed, -np.sign(speed))
    return np.asarray(effort + sense * resisting)
