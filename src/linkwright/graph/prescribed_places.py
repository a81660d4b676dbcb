"""Places that drives prescribe for a point beyond what the links between it and a known pin can span.

Whatever the angles, a chain of rigid segments spans at most the sum of their lengths, and at least what its longest
exceeds the others by. Where a place lies beyond these, the distances say why no assembly is found.
"""

from __future__ import annotations

import heapq
import math
from collections.abc import Mapping
from itertools import combinations
from typing import NamedTuple

from linkwright.graph.motion import Motion
from linkwright.notation import Jet, Pair
from linkwright.notation.planar import unit_vector
from linkwright.structure import Connection, HigherGroup

ROUND_OFF = 1e-9
"""Shares of a length, or sines of angles, below this are none."""


class OutOfReach(NamedTuple):
    """A place (m) that is prescribed for a point: its ``distance`` (m) from a known pin, and the ``limit`` that the
    links between both can span; one of the drives that prescribe it."""

    drive: str
    point: str
    pin: str
    links: list[str]
    distance: float
    limit: float


class _Chain(NamedTuple):
    """Segments from a point to a pin on a known link: their lengths (m), the links that they are of."""

    pin: str
    known: str
    lengths: list[float]
    links: list[str]


def out_of_reach(motion: Motion, group: HigherGroup, drives: Mapping[str, Jet]) -> OutOfReach | None:
    """The first place that is out of reach of a group's links."""
    for first, second in combinations([c for c in group.closures if c.kind.prescribed], 2):
        target = _prescribed(motion, group, (first, second), drives)
        if target is None:
            continue
        mover = motion.geometry.mechanism.prescribed(first.joint)
        assert mover.at is not None
        for chain in _chains(motion, group, mover.link, mover.at):
            pin = motion.structure.topology.pins[chain.pin]
            point = next(point for link, point in pin.members if link == chain.known)
            apart = motion.bodies[chain.known].point(motion.point(chain.known, point)).now.minus(target)
            distance, most = float(apart.length), sum(chain.lengths)
            least = 2.0 * max(chain.lengths) - most
            limit = most if distance > most * (1.0 + ROUND_OFF) else least
            if limit is most or distance < least * (1.0 - ROUND_OFF):
                return OutOfReach(first.joint, mover.at, chain.pin, list(dict.fromkeys(chain.links)), distance, limit)
    return None


def _prescribed(
    motion: Motion, group: HigherGroup, both: tuple[Connection, Connection], drives: Mapping[str, Jet]
) -> Pair | None:
    """The place (m) that two drives prescribe for a point, in the frame; ``None`` where they don't prescribe one."""
    geometry = motion.geometry
    movers = [geometry.mechanism.prescribed(connection.joint) for connection in both]
    if any(mover.moves is None for mover in movers):
        return None
    (link, on), (other, beside) = ((mover.link, mover.on) for mover in movers)
    at = {mover.at for mover in movers}
    if link != other or on != beside or len(at) > 1 or on in group.links or on not in motion.bodies:
        return None
    tracks = [mover.track(geometry) for mover in movers]
    ways = [unit_vector(track.angle) for track in tracks]
    # The point's coordinates along both lines, from the origin of their link.
    along = [
        float(track.base.dot(way) + drives[connection.joint].d[0])
        for track, way, connection in zip(tracks, ways, both, strict=True)
    ]
    sine = float(ways[0].x * ways[1].y - ways[0].y * ways[1].x)
    if abs(sine) < ROUND_OFF:
        return None
    x = (along[0] * ways[1].y - along[1] * ways[0].y) / sine
    y = (along[1] * ways[0].x - along[0] * ways[1].x) / sine
    return motion.bodies[on].point(Pair(x, y)).now


def _chains(motion: Motion, group: HigherGroup, link: str, at: str) -> list[_Chain]:
    """The shortest chains of segments of a group's links from a point of one of them to each pin on a known link."""
    pins = motion.structure.topology.pins
    places = {one: {pin.name: point for pin in pins.values() for owner, point in pin.members if owner == one}
              for one in group.links}  # fmt: skip
    found: list[_Chain] = []
    done: set[str] = set()
    waiting: list[tuple[float, str, str, list[float], list[str]]] = [(0.0, "", link, [], [])]
    while waiting:
        total, node, _, lengths, links = heapq.heappop(waiting)
        if node in done:
            continue
        done.add(node)
        members = dict(pins[node].members) if node else {link: at}
        known = next((one for one in members if one in motion.bodies and one not in group.links), None)
        if known is not None and lengths:
            found.append(_Chain(node, known, lengths, links))
            continue
        for own in (one for one in members if one in places):
            start = motion.point(own, members[own])
            for name, point in places[own].items():
                length = float(motion.point(own, point).minus(start).length)
                if name not in done and math.isfinite(length):
                    heapq.heappush(waiting, (total + length, name, own, [*lengths, length], [*links, own]))
    return found
