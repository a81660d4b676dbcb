"""The reactions study: a structure that nothing drives, at the one pose at which it stands.

Reactions of joints and forces of bars under loads, gravity and springs. What statics doesn't determine is named and has
no value.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Annotated

import numpy as np

from linkwright.compilation.still import examine_still
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Frozen
from linkwright.expressions.typed_fields import Quantity
from linkwright.findings import Finding, Joined, Term
from linkwright.graph.statics import Statics
from linkwright.kernels import Compiled
from linkwright.kernels.still import Still
from linkwright.model.signals import Contact
from linkwright.presentation.blocks import FileOf, StudyReport
from linkwright.studies.numbers import constant
from linkwright.studies.reactions.outcome import Reaction, ReactionsOutcome, TwoForceLink
from linkwright.studies.reactions.report import reactions_csv, report
from linkwright.studies.registry import Study, register
from linkwright.studies.run_context import NOWHERE, RunContext

PATH = ("studies", "reactions")
PROVEN = 1e-9
"""Joints that miss by less than this share of the size, and equilibria left over by less, hold."""


class ReactionsOptions(Frozen):
    """When the loads are taken."""

    at: Annotated[Expression | None, Quantity(u.TIME)] = None


@register
class Reactions(Study):
    """Reactions of a structure at its pose."""

    name = "reactions"
    example = "{}"
    options = ReactionsOptions
    rank = 6
    files = {"reactions.csv": FileOf(reactions_csv)}
    examine = staticmethod(examine_still)

    def check(self, compiled: Compiled, options: ReactionsOptions) -> list[Finding]:
        """What is wrong with the time."""
        if options.at is None:
            return []
        time, found = constant(compiled.quantities, options.at, u.TIME, path := (*PATH, "at"))
        early = time is not None and time < 0
        return [Finding("reactions.time", path, {"text": options.at.text[:60]})] if early else found

    def run(self, compiled: Compiled, options: ReactionsOptions, site: RunContext = NOWHERE) -> ReactionsOutcome:
        """Solve the equilibrium."""
        assert isinstance(compiled, Still)
        outcome = ReactionsOutcome(compiled, _time(compiled, options))
        statics = compiled.statics(outcome.time)
        assert compiled.system is not None
        outcome.closure = float(np.abs(compiled.system.residual(compiled.z)).max(initial=0.0))
        outcome.failures = list(_failures(statics))
        if outcome.failures:
            return outcome
        residual = max(outcome.closure, statics.relative_residual)
        if not residual <= PROVEN:
            outcome.failures = [Finding("reactions.unproven", PATH, {"residual": f"{residual:.1e}"})]
            return outcome
        outcome.states, outcome.motions = statics.self_stresses.shape[1], statics.motions.shape[1]
        outcome.equilibrium = statics.relative_residual
        outcome.reactions = list(_reactions(compiled, statics))
        outcome.bars = list(_bars(compiled, statics))
        outcome.warnings = list(_warnings(outcome, statics))
        return outcome

    def report(self, outcome: ReactionsOutcome) -> StudyReport:
        """Reactions and forces of bars."""
        return report(outcome)


def _time(compiled: Compiled, options: ReactionsOptions) -> float:
    return 0.0 if options.at is None else compiled.quantities.value(options.at, u.TIME)


def _failures(statics: Statics) -> Iterator[Finding]:
    if not np.isfinite(statics.applied).all():
        bad = [link for link, wrench in statics.wrenches.items() if not np.isfinite(wrench).all()]
        yield Finding("reactions.not-finite", ("loads",), {"links": Joined(bad)})
    elif moving := statics.moving:
        yield Finding("reactions.moves", ("links", moving[0]), {"links": Joined(moving)})


def _reactions(compiled: Still, statics: Statics) -> Iterator[Reaction]:
    """Each place where a reaction acts once, as the signals of forces are listed."""
    signals = compiled.quantities.signals
    seen: set[tuple[str, str]] = set()
    for contact in signals.contacts:
        if (contact.joint, contact.on) in seen and contact.on != contact.joint:
            continue
        seen.add((contact.joint, contact.link))
        called = _reaction_name(compiled, contact)
        parts = statics.parts(contact)
        for part in parts:
            dimension = u.TORQUE if part.attribute == "moment" else u.FORCE
            yield Reaction(f"{called}.{part.attribute}", contact.joint, dimension, part.value)
        if all(part.value is None for part in parts) and (found := statics.across(contact)) is not None:
            yield Reaction(called, contact.joint, u.FORCE, found[1], found[0])


def _reaction_name(compiled: Still, contact: Contact) -> str:
    """The name of a reaction; with the joint where the two links meet in several."""
    same = [c for c in compiled.quantities.signals.contacts if (c.link, c.on) == (contact.link, contact.on)]
    names = [contact.link, contact.on, *([contact.joint] if len(same) > 1 else [])]
    return f"force({', '.join(names)})"


def _bars(compiled: Still, statics: Statics) -> Iterator[TwoForceLink]:
    """The links that are pinned at two places, have no other joint, and bear no load, weight or spring."""
    topology = compiled.structure.topology
    largest = np.abs(statics.applied).max(initial=0.0)
    jointed = {link for c in topology.but_pins for link in c.links}
    for link in topology.moving:
        pins = [pin for pin in topology.pins.values() if link in pin.links]
        own = np.abs(statics.wrenches[link]).max()
        if len(pins) != 2 or link in jointed or own > PROVEN * largest:
            continue
        ends = [statics.system.geometry.point(link, pin.point(link)) for pin in pins]
        arms = [statics.pointed(link, (float(end.x), float(end.y)))[0] for end in ends]
        axis = arms[1] - arms[0]
        if math.hypot(*axis) > 0:
            pull = statics.on(pins[1].name, link)[:2]
            yield TwoForceLink(link, statics.component(axis @ pull / math.hypot(*axis)))


def _warnings(outcome: ReactionsOutcome, statics: Statics) -> Iterator[Finding]:
    m = outcome.compiled.mechanism
    if not any(wrench.any() for wrench in statics.wrenches.values()):
        yield Finding("reactions.no-load", ("loads",), severity="warning")
    shared = m.stiffness and statics.stresses.shape[1] < outcome.states
    if shared:
        equal = any(entry.equal for entry in m.stiffness.values())
        data = {"degree": outcome.states, "sharing": Term("redundant-equal" if equal else "redundant-shared")}
        yield Finding("reactions.shared", ("stiffness",), data, severity="warning")
    if outcome.states and (not shared or statics.stresses.shape[1]):
        named = dict.fromkeys(reaction.joint for reaction in outcome.reactions if reaction.value is None)
        data = {"degree": outcome.states, "joints": Joined(named)}
        yield Finding("reactions.indeterminate", ("joints",), data, severity="warning")
    if outcome.motions:
        yield Finding("reactions.neutral", ("joints",), {"motions": outcome.motions}, severity="warning")
    if m.measures:
        yield Finding("reactions.measures", ("measures",), {"names": Joined(m.measures)}, severity="warning")
