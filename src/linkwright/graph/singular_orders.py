"""Instant centres."""

from __future__ import annotations

from typing import TYPE_CHECKING

from linkwright.model.signals import Signal
from linkwright.notation import Pair, Scalar
from linkwright.symbols import as_symbol

if TYPE_CHECKING:
    from linkwright.graph.view import View

INFINITE = 1e9
"""Beyond so many times the mechanism's size an instant centre lies at infinity."""
ROUND_OFF = 1e-13
"""A turning of two links against each other below this share of their motion is none."""


def pole(view: View, signal: Signal) -> Scalar:
    """The point where two links have one velocity: from a's anchor P, perp(v)/omega with the velocity v of P
    and the turning omega of a, both as seen from b."""
    place, step = view.shared(signal, lambda: _place_and_step(view, signal))
    if signal.attribute in ("x", "y"):
        return getattr(place, signal.attribute) + getattr(step, signal.attribute)
    a = view.motion.bodies[signal.owners[0]]
    inside = step.rotated_back(a.axis.now)
    return a.local.x + inside.x if signal.attribute == "u" else a.local.y + inside.y


def _place_and_step(view: View, signal: Signal) -> tuple[Pair, Pair]:
    """P, and the step from there to the pole."""
    a, b = (view.motion.bodies[link] for link in signal.owners)
    place, size = a.anchor.now, view.graph.size
    carried = b.velocity(place)
    own = Pair(a.anchor.x.d[1], a.anchor.y.d[1])
    speed, omega = own.minus(carried), as_symbol(a.turn.d[0] - b.turn.d[0])
    whole = own.dot(own) + carried.dot(carried) + size**2 * (a.turn.d[0] ** 2 + b.turn.d[0] ** 2)
    # At infinity and at rest this is zero, and what is divided by it is neither finite nor has a finite rate.
    turns = (size * omega) ** 2 > speed.dot(speed) / INFINITE**2 + whole * ROUND_OFF**2
    omega, beyond = omega * turns, 1 / turns - 1
    return place, Pair(beyond - speed.y / omega, beyond + speed.x / omega)
