"""Which reactions of a redundant mechanism statics doesn't determine, and which sums of them it does.

A component of a reaction is determined where no state of self-stress touches it, at any of some poses along the motion.
Where a file states how stiff joints and links are, only states remain that strain none of what yields.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from linkwright.graph.constraints import Constraints
from linkwright.graph.shared_statics import SharedStatics
from linkwright.graph.statics import Statics
from linkwright.model.signals import Contact, Signals
from linkwright.structure import SelfStress
from linkwright.structure.releases import Component

Array = NDArray[np.float64]

TOUCHED = 1e-8
"""The least force, in a state of self-stress of size 1, by which a component isn't determined."""
MOST, LISTED = 40, 6
"""The most components among which sums are looked for; the most sums that are listed."""


class UndeterminedReactions:
    """What the states of self-stress of a ``system`` touch, at some poses of it."""

    def __init__(self, system: Constraints, poses: Sequence[tuple[float, Array]], signals: Signals) -> None:
        self.system, self.signals = system, signals
        # Some load on all links: forces that follow from the size of others, as of teeth, are seen only so.
        random = np.random.default_rng(0)
        load = {link: random.uniform(1.0, 2.0, 3) * [1.0, 1.0, system.size] for link in system.links}
        every = [(time, Statics(system, z, load)) for time, z in poses]
        fewest = min(one.self_stresses.shape[1] for _, one in every)
        generic = [(time, one) for time, one in every if one.self_stresses.shape[1] == fewest]
        self.times, self.statics = tuple(time for time, _ in generic), [one for _, one in generic]

    @cached_property
    def states(self) -> list[Array]:
        """At each pose the states that no stiffness determines, orthonormal: (actions, states)."""
        if not self.system.topology.mechanism.stiffness:
            return [one.stresses for one in self.statics]
        return [SharedStatics(one, self.signals).stresses for one in self.statics]

    @cached_property
    def _touched(self) -> dict[Component, list[Array]]:
        """What the states do in each component, at each pose: (states,)."""
        found: dict[Component, list[Array]] = {}
        for contact in self.signals.contacts:
            for statics, states in zip(self.statics, self.states, strict=True):
                for attribute, row in statics.reaction(contact).items():
                    found.setdefault((contact.joint, contact.link, attribute), []).append(row @ states)
        return found

    @cached_property
    def self_stress(self) -> SelfStress:
        """What the states do in the components that they touch."""
        unit = {"moment": self.system.size}
        touched = {
            name: [part.tolist() for part in parts]
            for name, parts in self._touched.items()
            if _largest(parts) > TOUCHED * unit.get(name[2], 1.0)
        }
        return SelfStress(self.times, touched)

    @property
    def components(self) -> frozenset[Component]:
        """The components that aren't determined."""
        return self.self_stress.components

    @property
    def joints(self) -> list[str]:
        """Their joints, in the order of the file."""
        return list(dict.fromkeys(c.joint for c in self.signals.contacts if self._of(c)))

    @property
    def following(self) -> list[str]:
        """The joints that redundancy loads and that exert forces by the size of others, as teeth that push gears
        apart: those aren't linear in what is shared."""
        rows = np.array(self.system.rows)
        return [
            joint
            for joint in dict.fromkeys(j for one in self.statics for j in one.acting_joints[rows.size :].tolist())
            if any(np.abs(one.self_stresses[rows == joint]).max(initial=0.0) > TOUCHED for one in self.statics)
        ]

    def _of(self, contact: Contact) -> list[str]:
        return [a for joint, link, a in sorted(self.components) if (joint, link) == (contact.joint, contact.link)]

    def sums(self) -> Iterator[str]:
        """Sums and differences of them that are determined, as expressions of a file."""
        once: dict[tuple[str, str], Contact] = {}
        for c in self.signals.contacts:
            once.setdefault((c.joint, c.link if c.on == c.joint else ""), c)
        listed = 0
        for attribute in ("x", "y"):
            found = [c for c in once.values() if (c.joint, c.link, attribute) in self.components][:MOST]
            told: set[str] = set()
            for size in (2, 3):
                for group in combinations(found, size):
                    if told & {c.joint for c in group} or listed == LISTED:
                        continue
                    if (signs := self._determined(group, attribute)) is not None:
                        told |= {c.joint for c in group}
                        listed += 1
                        yield _text(group, signs, attribute)

    def _determined(self, group: Sequence[Contact], attribute: str) -> tuple[float, ...] | None:
        """The signs with which some components make a sum that is determined."""
        touched = [self._touched[c.joint, c.link, attribute] for c in group]
        for bits in range(2 ** (len(group) - 1)):
            signs = (1.0, *(-1.0 if bits >> k & 1 else 1.0 for k in range(len(group) - 1)))
            if all(
                np.abs(sum(s * part for s, part in zip(signs, parts, strict=True))).max(initial=0.0) < TOUCHED
                for parts in zip(*touched, strict=True)
            ):
                return signs
        return None


def _largest(parts: Sequence[Array]) -> float:
    return max((float(np.abs(part).max(initial=0.0)) for part in parts), default=0.0)


def _text(group: Sequence[Contact], signs: Sequence[float], attribute: str) -> str:
    """A sum as an expression."""
    names = [f"force({c.link}, {c.on}, {c.joint}).{attribute}" for c in group]
    return names[0] + "".join(f" {'+' if s > 0 else '-'} {n}" for s, n in zip(signs[1:], names[1:], strict=True))
