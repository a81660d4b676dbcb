"""Motion that is about to start: a drive creeps, which gives every joint the sense of its motion and no more."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from linkwright.notation import Scalar

if TYPE_CHECKING:
    from linkwright.graph.graph import Graph

CREEP = 1e-170
"""The speed of the drive (rad/s or m/s): its square is zero in floating-point arithmetic, its sign isn't."""


def creeping_rates(graph: Graph, drive: str, sense: int, x: Callable[[int], Scalar]) -> dict[int, Scalar]:
    """The rates of all drives among the inputs ``x`` of a pose, by their rows: one creeps in a sense, its followers
    with it, and all others stand still."""
    found: dict[int, Scalar] = {}
    followers = graph.actions.followers
    for i, name in enumerate(graph.drives):
        first = i * graph.width + 1
        found |= dict.fromkeys(range(first, first + graph.width - 1), 0.0)
        if name == drive:
            found[first] = sense * CREEP
        elif name in followers and followers[name].motor == drive:
            # How a follower's value changes with its motor's, which counts with a sign.
            ratio = x(graph.inputs.index(f"ratio/{name}/0")) * followers[name].motor_sign
            found[first] = ratio * (sense * CREEP)
    return found
