"""Statics of a structure at one pose: reactions from the equilibrium of all links, and what it leaves open.

The reactions are the multipliers of the joints' constraints: with the constraint Jacobian A over the links' poses,
A^T r + w = 0 for the applied wrenches w. Its null space are states of self-stress: what it touches is statically
indeterminate. The null space of A are motions that the joints leave: a structure that has some stands only under
wrenches that do no work on them (S. Pellegrino, C. R. Calladine 1986).

Some joints exert more than their multipliers, such as teeth, which push gears apart by a share of the tangential
force's size. These forces b(r) are rows of their own below those of A, with the factor 1; where statics leaves their
multiplier open, they are open too.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.graph.constraints import Constraints
from linkwright.model.signals import Contact
from linkwright.structure import FRAME

Array = NDArray[np.float64]

TOLERANCE = 1e-9
"""Singular values below this share of the largest one count as zero; so does what a null space touches by less."""
ROUNDS = 20
"""How often forces that follow from multipliers are put into the equilibrium that gives these; mostly once is enough,
as they do no work on motions that the joints leave."""


@dataclass(frozen=True)
class ReactionComponent:
    """One component of a reaction (N or N m); ``None`` where statics doesn't determine it."""

    contact: Contact
    attribute: str
    value: float | None


@dataclass
class Statics:
    """The equilibrium of the links at a pose ``z``, over rows (x/size, y/size, angle) each.

    ``wrenches`` are what is applied to each moving link: force (N) and moment (N m) about its origin, (3,).
    """

    system: Constraints
    z: Array
    wrenches: Mapping[str, Array]

    @cached_property
    def slopes(self) -> Array:
        """A, the slopes of all constraints: (constraints, 3 links)."""
        return self.system.jacobian(self.z)

    @cached_property
    def applied(self) -> Array:
        """The applied wrenches, moments over the size: (3 links,)."""
        unit = np.array([1.0, 1.0, self.system.size])
        return np.concatenate([self.wrenches[link] / unit for link in self.system.links])

    @cached_property
    def _factors(self) -> tuple[Array, Array, Array]:
        """U, the singular values that aren't zero, V^T of A^T."""
        u, values, v = np.linalg.svd(self.slopes.T)
        return u, values[values > TOLERANCE * values.max(initial=0.0)], v

    @cached_property
    def self_stresses(self) -> Array:
        """The states of self-stress, orthonormal: (constraints, states)."""
        _, values, v = self._factors
        return v[values.size :].T

    @cached_property
    def motions(self) -> Array:
        """The motions that the joints leave, orthonormal: (3 links, motions)."""
        u, values, _ = self._factors
        return u[:, values.size :]

    def _answer(self, applied: Array) -> Array:
        """The constraints' reactions to what is applied, of all in equilibrium the smallest: (constraints,)."""
        u, values, v = self._factors
        return -v[: values.size].T @ ((u[:, : values.size].T @ applied) / values)

    @cached_property
    def _solved(self) -> tuple[Array, list[tuple[str, Array]]]:
        """The constraints' reactions, and what follows from them (:meth:`Constraints.besides`)."""
        following: list[tuple[str, Array]] = []
        answer = self._answer(self.applied)
        for _ in range(ROUNDS):
            following = self.system.besides(self.z, answer)
            before, answer = answer, self._answer(sum((own for _, own in following), self.applied))
            if np.abs(answer - before).max(initial=0.0) <= 1e-14 * np.abs(answer).max(initial=0.0):
                break
        return answer, following

    @cached_property
    def multipliers(self) -> Array:
        """The factors of all that acts between links: the constraints' reactions, then 1 for each force that follows
        from them, (actions,)."""
        answer, following = self._solved
        return np.concatenate([answer, np.ones(len(following))])

    @cached_property
    def actions(self) -> Array:
        """What a factor of 1 does to each link: A, and below it the forces that follow, (actions, 3 links)."""
        return np.concatenate([self.slopes, *(own[None] for _, own in self._solved[1])])

    @cached_property
    def acting_joints(self) -> Array:
        """Whose each of the actions is."""
        return np.array([*self.system.rows, *(joint for joint, _ in self._solved[1])])

    @cached_property
    def stresses(self) -> Array:
        """Changes of the actions' factors that leave the equilibrium as it is: (actions, states)."""
        answer, following = self._solved
        open_ = [np.concatenate([state, np.zeros(len(following))]) for state in self.self_stresses.T]
        unloaded = dict(self.system.besides(self.z, np.zeros(answer.size)))
        for k, (joint, own) in enumerate(following):
            rows = np.array(self.system.rows) == joint
            if not np.abs(self.self_stresses[rows]).max(initial=0.0) > TOLERANCE:
                continue
            changing = own - unloaded.get(joint, 0.0)  # what doesn't depend on the multiplier is known
            if np.abs(changing).any():
                open_.append(np.concatenate([self._answer(own), np.eye(len(following))[k]]))
        return np.array(open_).reshape(-1, answer.size + len(following)).T

    @property
    def relative_residual(self) -> float:
        """The largest force left on a link (N, moments over the size), over the largest one there is."""
        answer, _ = self._solved
        acting = sum((own for _, own in self.system.besides(self.z, answer)), self.applied)
        left = self.slopes.T @ answer + acting
        largest = max(np.abs(self.applied).max(initial=0.0), np.abs(answer).max(initial=0.0))
        return float(np.abs(left).max(initial=0.0) / largest) if largest else 0.0

    @property
    def moving(self) -> list[str]:
        """The links that the applied wrenches would set in motion; none where the structure stands."""
        work = self.motions.T @ self.applied
        if not np.abs(work).max(initial=0.0) > TOLERANCE * np.abs(self.applied).max(initial=0.0):
            return []
        rates = np.abs(self.motions @ work).reshape(-1, 3).max(axis=1)
        return [link for link, rate in zip(self.system.links, rates, strict=True) if rate > TOLERANCE * rates.max()]

    def component(self, row: Array) -> float | None:
        """A linear combination (actions,) of the multipliers, where they determine it."""
        open_ = np.abs(row @ self.stresses).max(initial=0.0) > TOLERANCE * np.abs(row).max(initial=0.0)
        return None if open_ else float(row @ self.multipliers) + 0.0

    # Reactions.

    def on(self, joint: str, link: str) -> Array:
        """What a joint does to a link, by the multipliers: force and moment (N, N m) about the link's origin,
        (3, actions). What it does to the frame is the opposite of what it does to all others."""
        rows = self.acting_joints == joint
        unit = np.array([1.0, 1.0, self.system.size])[:, None]
        if link != FRAME:
            return np.asarray(np.where(rows, self.actions[:, self.system.columns_of([link])].T, 0.0) * unit)
        found = np.zeros((3, rows.size))
        for other in self.system.links:
            own = self.on(joint, other)
            found -= own + np.array([np.zeros(rows.size), np.zeros(rows.size), _cross(self.origin(other), own)])
        return found

    def origin(self, link: str) -> Array:
        """Where a link's origin is (m)."""
        if link == FRAME:
            return np.zeros(2)
        return np.asarray(self.z[self.system.columns_of([link])[:2]] * self.system.size)

    def pointed(self, link: str, local: tuple[float, float]) -> tuple[Array, Array]:
        """The arm of a link's point from its origin (m), and the link's direction."""
        angle = 0.0 if link == FRAME else float(self.z[self.system.columns_of([link])[2]])
        c, s = np.cos(angle), np.sin(angle)
        return np.array([c * local[0] - s * local[1], s * local[0] + c * local[1]]), np.array([c, s])

    def reaction(self, contact: Contact) -> dict[str, Array]:
        """The force of a contact's link on what it touches, by its components over the multipliers (actions,):
        x, y, and of a slide ``normal`` and ``moment``, as signals have them."""
        if contact.on == contact.joint:  # of the link on the pin
            rows = -self.on(contact.joint, contact.link)
            return {"x": rows[0], "y": rows[1]}
        rows = self.on(contact.joint, contact.on)
        found = {"x": rows[0], "y": rows[1]}
        if contact.sliding:
            geometry, joint = self.system.geometry, self.system.topology.mechanism.joints[contact.joint]
            first, second = joint.links
            heading = geometry.line(contact.joint, first)[1]
            along, _ = self.pointed(first, (float(heading.x), float(heading.y)))
            point = geometry.line(contact.joint, second)[0]
            arm, _ = self.pointed(second, (float(point.x), float(point.y)))
            about = self.origin(second) + arm
            found["normal"] = along[0] * rows[1] - along[1] * rows[0]
            found["moment"] = rows[2] + _cross(self.origin(contact.on) - about, rows)
        return found

    def parts(self, contact: Contact) -> list[ReactionComponent]:
        """A reaction's components with their values."""
        rows = self.reaction(contact)
        return [ReactionComponent(contact, attribute, self.component(row)) for attribute, row in rows.items()]

    def across(self, contact: Contact) -> tuple[float, float] | None:
        """Where neither x nor y is determined but what lies across some direction: that normal's angle (rad, -90 to
        90 deg) and the force along it (N)."""
        rows = np.array([self.reaction(contact)[axis] for axis in "xy"])
        directions, open_, _ = np.linalg.svd(rows @ self.stresses)
        if not open_.size or np.count_nonzero(open_ > TOLERANCE * np.abs(rows).max(initial=0.0)) != 1:
            return None
        normal = directions[:, 1] * (1.0 if directions[0, 1] >= 0 else -1.0)
        value = self.component(normal @ rows)
        return None if value is None else (float(np.arctan2(normal[1], normal[0])), value)


def _cross(arm: Array, rows: Array) -> Array:
    """The moment of forces, the first two of some rows, at the end of an arm."""
    return np.asarray(arm[0] * rows[1] - arm[1] * rows[0])
