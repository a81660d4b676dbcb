"""What is built into a model beside its links and joints: springs, dampers, gas springs, counterweights."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Annotated, Any

from pydantic import Field

from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Frozen, Name
from linkwright.expressions.typed_fields import Quantity, Ref, Sign
from linkwright.expressions.units import Dimension
from linkwright.expressions.written import Fault
from linkwright.model.actions import At
from linkwright.model.parts import INERTIA, PART_LENGTH, Interval, TwoLinks

_BETWEEN_POINTS = ("from", "to", "in", "length", "force", "gas", "progression", "exponent")
_AT_JOINT = ("turns", "on", "torque")
_LINEAR, _GAS = ("free", "preload"), ("progression", "exponent")


def _end(place: int) -> Ref:
    """A point of the link that stands at this place under `in`, where that is given."""
    return Ref("point", of=lambda c: None if c.entry.in_ is None else str(c.entry.in_[place]))


def _law(linear: Dimension, torsional: Dimension, sign: Sign = Sign.NOT_NEGATIVE) -> Quantity:
    """A quantity of a spring between two points, and of a torsional one."""
    return Quantity(lambda c: torsional if c.entry.torsional else linear, sign)


_FREE = Quantity(
    lambda c: u.ANGLE if c.entry.torsional else u.LENGTH,
    lambda c: Sign.ANY if c.entry.torsional else Sign.NOT_NEGATIVE,
)


class Spring(Frozen):
    """A spring, damper or gas spring: between two points along the line that joins them, or torsional between links."""

    from_: Annotated[Name | None, _end(0)] = Field(None, alias="from", description="the point where one end is fixed")
    to: Annotated[Name | None, _end(1)] = Field(None, description="the point where the other end is fixed")
    in_: TwoLinks | None = Field(
        None, alias="in", description="the links of the two points, where a point name lies on several links"
    )
    turns: Annotated[Name | None, Ref("link")] = Field(
        None, description="torsional: the link on which the torque acts; its angle is against on"
    )
    on: Annotated[Name | None, Ref("link")] = Field(
        None, description="torsional: the other link, on which the opposite torque acts"
    )
    stiffness: Annotated[Expression | None, _law(u.STIFFNESS, u.TORSIONAL_STIFFNESS)] = Field(
        None, description="force over length, or torque over angle; with free"
    )
    free: Annotated[Expression | None, _FREE] = Field(
        None, description="length, or angle, at which the spring is relaxed"
    )
    preload: Annotated[Expression | None, _law(u.FORCE, u.TORQUE, Sign.ANY)] = Field(
        None, description="force (torque) that is there at the free length (angle) already"
    )
    damping: Annotated[Expression | None, _law(u.DAMPING, u.TORSIONAL_DAMPING)] = Field(
        None, description="force over speed, or torque over angular speed"
    )
    force: Name | None = Field(None, description="a table of the pulling force over the length")
    torque: Name | None = Field(
        None, description="a table of the torque over the angle, positive where it turns it back"
    )
    gas: Annotated[Expression | None, Quantity(u.FORCE, Sign.POSITIVE)] = Field(
        None, description="gas spring: its push at the greater length; with progression"
    )
    progression: Annotated[Expression | None, Quantity(u.PURE, Sign.NOT_NEGATIVE)] = Field(
        None, description="gas spring: push at the smaller length over that at the greater one; with length"
    )
    exponent: Annotated[Expression | None, Quantity(u.PURE, Sign.POSITIVE)] = Field(
        None, description="gas spring: polytropic exponent, 1 (slow, isothermal) unless given, 1.4 fast (adiabatic)"
    )
    length: Annotated[Interval | None, PART_LENGTH] = Field(
        None, description="[smallest, greatest] length that the part allows"
    )

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
            yield "spring.stray", {"keys": ", ".join(strays)}
        if len(laws) > 1 or not (laws or "damping" in given):
            yield "spring.law", {"given": ", ".join(laws) or "-"}
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


class Counterweight(Frozen):
    """A mass added to a link, with or without mass of its own."""

    on: Annotated[Name, Ref("link")] = Field(description="the link that carries it")
    mass: Annotated[Expression, Quantity(u.MASS, Sign.POSITIVE, "mass")] = Field(description="its mass")
    at: Annotated[At, Ref("point", of="on")] = Field(
        description="where its centre of mass is: a point of the link, [x, y] or 'r at angle' in its frame"
    )
    inertia: Annotated[Expression | None, INERTIA] = Field(
        None, description="moment of inertia about its own centre of mass; none unless given"
    )
