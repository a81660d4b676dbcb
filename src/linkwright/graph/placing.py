"""How links are placed on one another: a mechanism's joints as the groups want them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from linkwright.graph.geometry import unit_vector
from linkwright.groups import InnerLine, InnerPin, OuterLine, OuterPin
from linkwright.groups.joints import Inner, Outer
from linkwright.notation import Body, Jet
from linkwright.structure import Chain, Connection, Driven, Edge

if TYPE_CHECKING:
    from linkwright.graph.motion import Motion


def driven_body(motion: Motion, step: Driven | Edge, law: Jet) -> tuple[Outer, Body]:
    """A link placed by a drive on a link placed before."""
    base = motion.bodies[step.base]
    outer = outer_joint(motion, step.joint, step.link)
    q = law if step.sign > 0 else -law
    if isinstance(outer, OuterPin):
        turn = base.turn + q.rate() if q.order else base.turn
        body = outer.place(base.axis.now.turned(unit_vector(q.d[0])), turn)
        known = None if base.angle is None else base.angle + q.d[0]
        body = Body(body.anchor, body.local, body.axis, body.turn, known)
    else:
        body = outer.place(q.d[0], q.rate())
    return outer, body


def carried(motion: Motion, end: str, chain: Chain, drives: Mapping[str, Jet], body: Body) -> Body:
    """Put a link where ``body`` says, and on it the links that drives hold there; the last of them."""
    motion.bodies[end] = body
    for edge in chain:
        assert edge.drive is not None
        body = motion.bodies[edge.link] = driven_body(motion, edge, drives[edge.drive])[1]
    return body


def outer_joint(motion: Motion, connection: Connection, link: str) -> Outer:
    """The joint by which ``link`` hangs on the known link at the other end."""
    base_name = connection.other(link)
    base, geometry = motion.bodies[base_name], motion.geometry
    if connection.letter == "R":
        pin = motion.structure.topology.pins[connection.joint]
        at = base.point(geometry.pivot(connection.joint, base_name, pin.point(base_name)))
        return OuterPin(at, geometry.pivot(connection.joint, link, pin.point(link)))
    base_point, base_heading, base_angle = geometry.seat(connection.joint, base_name)
    foot, heading, own_angle = geometry.seat(connection.joint, link)
    angle = None if base.angle is None else base.angle + base_angle - own_angle
    return OuterLine(base.point(base_point), base.direction(base_heading), base.turn, foot, heading, angle)


def inner_joint(motion: Motion, connection: Connection, links: tuple[str, str]) -> Inner:
    """A joint as closure between two links, in this order."""
    a, b = links
    geometry, joint = motion.geometry, connection.joint
    if connection.letter == "R":
        pin = motion.structure.topology.pins[joint]
        return InnerPin(geometry.pivot(joint, a, pin.point(a)), geometry.pivot(joint, b, pin.point(b)))
    return InnerLine(*geometry.seat(joint, a)[:2], *geometry.seat(joint, b)[:2])
