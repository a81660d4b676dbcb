"""How links are placed on one another: a mechanism's joints as the groups want them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, TypeVar

from linkwright.elements import Inner, JointKind, Outer
from linkwright.findings import Finding, ModelError
from linkwright.notation import Body, Jet
from linkwright.structure import Chain, Connection, Driven, LinkPlacement

if TYPE_CHECKING:
    from linkwright.graph.motion import Motion

Answer = TypeVar("Answer")


def driven_body(motion: Motion, step: Driven | LinkPlacement, law: Jet) -> tuple[Outer, Body]:
    """A link placed by a drive on a link placed before."""
    outer = outer_joint(motion, step.joint, step.link)
    return outer, outer.driven_body(motion.bodies[step.base], law if step.sign > 0 else -law)


def place_chain(motion: Motion, end: str, chain: Chain, drives: Mapping[str, Jet], body: Body) -> Body:
    """Put a link where ``body`` says, and on it the links that drives hold there; the last of them."""
    motion.bodies[end] = body
    for edge in chain:
        assert edge.drive is not None
        body = motion.bodies[edge.link] = driven_body(motion, edge, drives[edge.drive])[1]
    return body


def outer_joint(motion: Motion, connection: Connection, link: str) -> Outer:
    """The joint by which ``link`` hangs on the known link at the other end."""
    base = connection.other(link)
    return connection.kind.outer(motion.geometry, connection.joint, link, base, motion.bodies[base])


def inner_joint(motion: Motion, connection: Connection, links: Sequence[str]) -> Inner:
    """A joint as closure between its links, in this order."""
    return connection.kind.inner(motion.geometry, connection.joint, links)


def answered(
    kind: JointKind, joint: str, bodies: Mapping[str, Body], ask: Callable[[Mapping[str, Body]], Answer]
) -> Answer:
    """What a kind of joint answers of links as they lie. Raises ModelError where it needs an angle that isn't known and
    doesn't say that it ``winds``."""
    try:
        return ask(bodies)
    except TypeError:
        if kind.winds:
            raise
        ask({link: replace(body, angle=0.0) for link, body in bodies.items()})  # raises what else is wrong
        raise ModelError([Finding("joint.winds", ("joints", joint), {"kind": kind.title})]) from None
