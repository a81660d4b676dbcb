"""What clearances in joints do to positions: with each joint resting where its reaction presses it, and at worst.

To first order an output y deviates by c G(t) u(t) for each contact: c the clearance, u the direction of the force there
and G the derivative of y by a displacement in the joint, exact from the graph. The worst over all directions is c |G|.
Sources: docs/theory.md, Clearances in joints.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from linkwright.elements.clearance import LooseJoint
from linkwright.expressions.language import Node
from linkwright.findings import Finding, enumerated
from linkwright.kernels import Compiled
from linkwright.results import Run
from linkwright.results.quadrature import gauss_points
from linkwright.studies.accuracy.clearance_contacts import loose_joints
from linkwright.studies.accuracy.clearance_sensitivities import Gaps, Resting
from linkwright.studies.accuracy.contact import lost_contact_spans, merge_spans
from linkwright.studies.accuracy.options import AccuracyOptions
from linkwright.studies.accuracy.outcome import JointPlay, PlayEffect

Array = NDArray[np.float64]

PATH = ("studies", "accuracy", "clearances")
NO_FORCE = 1e-10
"""A joint with less than this share of the largest reaction transmits none, as far as digits tell."""
PANELS = 1 << 10
"""Panels of quadrature over the run, where the grid has fewer."""


class Plays:
    """The clearances of a mechanism over a run; ``warnings`` says of which joints it isn't known where they rest."""

    def __init__(self, compiled: Compiled, run: Run, options: AccuracyOptions) -> None:
        self.compiled, self.run, self.contact = compiled, run, options.contact
        self.warnings: list[Finding] = []
        self.held = loose_joints(compiled, options.clearances)
        self.gaps = Gaps(run, self.held)
        self.resting = Resting(self.gaps, self.loads)

    @cached_property
    def loads(self) -> list[float]:
        """The RMS of each joint's reaction over the run (N); 0 where it transmits no force."""
        run, found = self.run, []
        t, weight = self.panels(run.start, run.stop)
        contacts = self.compiled.quantities.signals.contacts
        every = [f"force({c.link}, {c.on}, {c.joint}).{axis}" for c in contacts for axis in "xy"]
        least = NO_FORCE * float(np.nan_to_num(np.abs(self.compiled.evaluate(every, t))).max(initial=0.0))
        for one, reaction in zip(self.held, self._reactions(t), strict=True):
            load = float(np.sqrt(reaction**2 @ weight / (run.stop - run.start)))
            if not load > least and not one.flank:
                self._warn("clearance.no-force" if load <= least else "clearance.undetermined", one)
            found.append(load if np.isfinite(load) and load > least else 0.0)
        return found

    def panels(self, a: float, b: float) -> tuple[Array, Array]:
        """Places and weights of quadrature over a span."""
        breaks = self.run.breaks
        return gauss_points(
            np.union1d(np.linspace(a, b, max(self.run.grid, PANELS) + 1), breaks[(a < breaks) & (breaks < b)])
        )

    def _reactions(self, t: Array) -> list[Array]:
        """What each joint transmits (N): of a guide the sum of the forces at its ends."""
        rows = {name: jet.d[0] for name, jet in self.gaps.needed_rows(t).items()}
        return [np.asarray(one.size([part for seat in one.forces(rows) for part in seat])) for one in self.held]

    def _warn(self, code: str, one: LooseJoint) -> None:
        data = {"name": one.joint, "links": enumerated(one.links)}
        self.warnings.append(Finding(code, (*PATH, one.joint), data, severity="warning"))

    def fits(self, trees: Iterable[Node]) -> bool:
        """Whether expressions hold positions only, and what drives prescribe."""
        graph, drives = self.compiled.graph, self.compiled.mechanism.movers
        for text in self.run.signals_of([*trees]):
            signal = graph.signal(text)
            drive = drives.get(signal.owners[0]) if signal.kind == "drive" else None
            prescribed = drive is not None and drive.output is None
            if not signal.kinematic or not (prescribed or graph.order([text]) == 0):
                return False
        return True

    def curve(self, tree: Node, t: Array) -> Array:
        """Shift and bound of an expression of positions (bound to SI) at times: (2, times)."""
        shift = self.resting.at([tree], t, rates=False).slope[0, 0]
        worst = self.gaps.worst(self.gaps.at([tree], t, rates=False).slope[0])
        return np.stack([shift, worst.sum(axis=0)])

    def effect(self, shifts: Array, bounds: Array) -> PlayEffect:
        """From shifts of all together and of each, and the bound of each."""
        by_joint: tuple[dict[str, float], dict[str, float]] = ({}, {})
        for one, *pair in zip(self.held, shifts[1:], bounds, strict=True):
            for known, part in zip(by_joint, pair, strict=True):
                known[one.joint] = known.get(one.joint, 0.0) + float(part)
        return PlayEffect(float(shifts[0]), float(bounds.sum()), *by_joint)

    def joints(self) -> list[JointPlay]:
        """Each joint with clearance over the run, a pin of several links once for each."""
        t, found = self.run.t, []
        rows, reactions = self.gaps.needed_rows(t), self._reactions(t)
        for one, load, reaction in zip(self.held, self.loads, reactions, strict=True):
            units = self.resting.directions(one, load, rows)
            shift = one.displacement([tuple(one.clearance * part.d[0] for part in unit) for unit in units])
            seats = range(len(units)) if load else ()
            spans = [
                span for i in seats for span in lost_contact_spans(self.run, self._force(one, i), self.contact * load)
            ]
            named = tuple((a, b, f"contact.{one.kind}-{cause}") for a, b, cause in merge_spans(spans))
            found.append(JointPlay(one.joint, one.links, one.clearance, t, reaction, np.stack(shift), named))
        return found

    def _force(self, one: LooseJoint, seat: int) -> Callable[[Array], tuple[Array, Array]]:
        """The force at a joint's contact and its rate."""

        def force_and_rate(t: Array) -> tuple[Array, Array]:
            force = one.forces(self.gaps.needed_rows(t))[seat]
            return np.stack([part.d[0] for part in force]), np.stack([part.d[1] for part in force])

        return force_and_rate
