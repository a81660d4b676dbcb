"""A mechanism that stands at one pose, as the graph of its signals: all rates are zero.

Its reactions come from statics (:mod:`linkwright.graph.statics`), which may leave some undetermined. On this graph they
are symbols without a value, so that every row that depends on one can be recognised (:meth:`StillGraph.of_reactions`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.graph.actions import wrenches
from linkwright.graph.forces import Forces, own_wrench
from linkwright.graph.geometry import ZERO, Geometry
from linkwright.graph.graph import Graph
from linkwright.graph.motion import Motion
from linkwright.graph.program import Program
from linkwright.graph.rows import Named
from linkwright.graph.view import View
from linkwright.notation import MAX_ORDER, Body, Jet, Pair, Vec, Wrench
from linkwright.structure import FRAME
from linkwright.symbols import ExpressionStage, Symbol, as_symbol, depend_on


class _FreeReactions(dict[tuple[str, str], Wrench]):
    """By joint and link a wrench of three symbols of its own, made where it is asked for."""

    def __missing__(self, key: tuple[str, str]) -> Wrench:
        x, y, moment = (Symbol.named(f"reaction/{'/'.join(key)}/{part}") for part in ("x", "y", "moment"))
        self[key] = Wrench(Pair(x, y), moment, ZERO)
        return self[key]

    @property
    def symbols(self) -> list[Symbol]:
        """All symbols made so far."""
        return [part for one in self.values() for part in (*one.force, one.moment)]


@dataclass
class StillView(View):
    """The expressions of a mechanism at rest, with reactions that are symbols."""

    free: _FreeReactions = field(default_factory=_FreeReactions)

    @cached_property
    def forces(self) -> Forces:
        return Forces(self.free, shaking=self.free[FRAME, FRAME])


Pose = Mapping[str, NDArray[np.float64]]
"""By moving link the place of its origin and its angle (m, m, rad)."""


@dataclass
class StillGraph(Graph):
    """The graph of a mechanism at a ``pose``; loads may depend on the time."""

    pose: Pose = field(default_factory=dict)

    def motion(self) -> Motion:
        """All links at rest."""
        motion = Motion(self.structure, Geometry(self.quantities, self.quantities.parameters), MAX_ORDER + 1)
        motion.bodies[FRAME] = Body.fixed(motion.order)
        for link, (x, y, angle) in self.pose.items():
            axis = Vec.constant(Pair(float(np.cos(angle)), float(np.sin(angle))), motion.order)
            at = Vec.constant(Pair(float(x), float(y)), motion.order)
            known = float(angle) if link in self.structure.topology.wound else None
            motion.bodies[link] = Body(at, ZERO, axis, Jet.constant(0.0, motion.order - 1), known)
        return motion

    @cached_property
    def _still(self) -> StillView:
        given = {name: Symbol.named(name) for name in self.inputs}
        parameters = Symbol.several("p", len(self.parameters))
        return StillView(self, list(given.values()), parameters, self.motion(), {}, given, [])

    def _view(self, order: int) -> View:
        return self._still

    def of_reactions(self, named: Named) -> bool:
        """Whether a row depends on reactions, to which statics alone can give a value."""
        expression = as_symbol(self._still.row(named))
        return depend_on([expression], self._still.free.symbols)

    @property
    def _bare(self) -> View:
        return self._view(0)

    @cached_property
    def _at_rest(self) -> Motion:
        return self.motion()

    def wraps(self, owner: str) -> bool:
        """Asked of the pose alone: what the inputs are depends on it, and the view on the inputs."""
        return self._at_rest.bodies[owner].angle is None

    def wrapped(self, named: Named) -> bool:
        """No angle jumps where nothing moves."""
        return False

    def applied(self) -> Program:
        """The program of what gravity and acting elements do to each link, the frame too: force (N) and moment (N m)
        about its origin, link by link."""
        view = self._view(0)
        links = {link: own_wrench(view.motion, link, body) for link, body in view.motion.bodies.items()}
        for link, wrench in wrenches(view):
            links[link] = links[link].plus(wrench)
        rows: list[Any] = []
        for link, wrench in links.items():
            found: Wrench = wrench.at(view.motion.bodies[link].anchor.now)
            rows += [found.force.x, found.force.y, found.moment]
        names = tuple(f"{link}:{k}" for link in links for k in range(3))
        return Program((), ExpressionStage(view.x, view.p, rows), self.inputs, self.parameters, names)
