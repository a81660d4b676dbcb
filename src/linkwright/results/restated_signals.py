"""Every reported signal once more, by a formula from raw geometry that shares nothing with the program that made it.

Places and directions come from the reported poses, which the closure proves; forces from the reported reactions, which
the equilibrium of each link proves; powers and energies are sums over links, kinds of elements restate their own. Rates
are proven by their integrals (:mod:`.reported_rates`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from linkwright.elements.force import Acting
from linkwright.elements.joint import Restated
from linkwright.model.signals import Signal
from linkwright.results.independent_check import Reports
from linkwright.structure import FRAME

Array = NDArray[np.float64]

FULL_TURN = 2 * np.pi
NO_FORCE = 1e-9
"""Below this share of its largest normal force a slide has no line of action."""


def restated(r: Reports, signal: Signal) -> Iterator[Restated]:
    """All formulas for a signal; none for a rate, which its integral proves, and for what no kind restates."""
    return FORMULAS[signal.kind](r, signal) if signal.kind in FORMULAS else _of_acting(r, signal)


def _of_point(r: Reports, signal: Signal) -> Iterator[Restated]:
    (point,) = signal.owners
    if signal.attribute in "xy":
        link = r.compiled.quantities.signals.links_of_points[point]
        yield Restated(r.point_position(link, r.geometry.point(link, point))["xy".index(signal.attribute)])


def _of_com(r: Reports, signal: Signal) -> Iterator[Restated]:
    (link,) = signal.owners
    if signal.attribute in "xy":
        yield Restated(r.point_position(link, r.centre_of_mass(link))["xy".index(signal.attribute)])


def _of_link(r: Reports, signal: Signal) -> Iterator[Restated]:
    (link,) = signal.owners
    if signal.attribute == "angle":
        x, y = r.rotated(link, (1.0, 0.0))
        yield Restated(np.arctan2(y, x), FULL_TURN)


def _of_slide(r: Reports, signal: Signal) -> Iterator[Restated]:
    (joint,) = signal.owners
    if signal.attribute == "s":
        yield Restated(_travel(r, joint))


def _of_joint(r: Reports, signal: Signal) -> Iterator[Restated]:
    (joint,) = signal.owners
    yield from _given(r.topology.kind_of(joint).restated(r, joint), signal.attribute)


def _of_drive(r: Reports, signal: Signal) -> Iterator[Restated]:
    (name,), attribute = signal.owners, signal.attribute
    mover, follower = r.mechanism.movers[name], r.mechanism.followers.get(name)
    if follower is not None:
        yield from _given(follower.restated(r, name), attribute)
    elif attribute == "power":
        done = r.powers_of(mover.applied(r, name))
        yield Restated(np.sum(done, axis=0))
    if attribute != mover.value:
        return
    yield _driven_value(r, name)
    if follower is None and mover.output is None:
        yield Restated(r.law(name))


def _driven_value(r: Reports, name: str) -> Restated:
    """The value of a drive or follower from the poses of both its links."""
    mover = r.mechanism.movers[name]
    if mover.turns:
        (c, s), (c0, s0) = (r.rotated(link, (1.0, 0.0)) for link in (mover.link, mover.on))
        return Restated(np.arctan2(s * c0 - c * s0, c * c0 + s * s0) + np.zeros(r.count), FULL_TURN)
    if mover.moves:
        point, base, angle = mover.track(r.geometry)
        away = r.point_position(mover.link, point) - r.point_position(mover.on, base)
        return Restated((away * r.rotated(mover.on, (np.cos(float(angle)), np.sin(float(angle))))).sum(axis=0))
    joint = r.joint_of(name)
    forward = mover.link == r.mechanism.joints[joint].links[1]
    return Restated(_travel(r, joint) if forward else -_travel(r, joint))


def _travel(r: Reports, joint: str) -> Array:
    """How far the second link of a slide has moved along the line of the first one (m)."""
    (start, along), (end, _) = (r.line(joint, link) for link in r.mechanism.joints[joint].links)
    return np.asarray(((end - start) * along).sum(axis=0))


def _of_force(r: Reports, signal: Signal) -> Iterator[Restated]:
    contact = r.compiled.quantities.signals.contact(signal.owners)
    force, moment = r.reaction(contact)
    if signal.attribute in "xy":
        yield Restated(np.asarray(force["xy".index(signal.attribute)]))
        return
    if signal.attribute == "moment":
        yield Restated(np.asarray(moment))
        return
    along = r.line(contact.joint, r.mechanism.joints[contact.joint].links[0])[1]
    normal = along[0] * force[1] - along[1] * force[0]
    if signal.attribute == "normal":
        yield Restated(normal)
        return
    pressed = np.abs(normal) > NO_FORCE * np.abs(normal).max(initial=0.0)
    with np.errstate(all="ignore"):
        yield Restated(np.where(pressed, moment / normal, np.nan))


def _of_shaking(r: Reports, signal: Signal) -> Iterator[Restated]:
    """What holds the frame: the sum of all that acts on it. In a loop of slides its moment isn't known."""
    if signal.attribute == "moment" and any(FRAME in r.mechanism.joints[name].links for name in r.looped):
        return
    total, moments = np.zeros((2, r.count)), np.zeros(r.count)
    for link, force, place, moment in (*r.reactions(), *r.efforts(), *r.acting()):
        if link == FRAME:
            total, moments = total + force, moments + place[0] * force[1] - place[1] * force[0] + moment
    yield Restated({"x": total[0], "y": total[1], "moment": moments}[signal.attribute])


def _of_energy(r: Reports, signal: Signal) -> Iterator[Restated]:
    yield Restated(ENERGIES[signal.attribute](r))


def _kinetic(r: Reports) -> Array:
    total = np.zeros(r.count)
    for link in r.masses:
        mass, inertia = r.mass(link)
        total += mass / 2 * (r.vector(f"com({link}).v") ** 2).sum(axis=0) + inertia / 2 * r.omega(link) ** 2
    return total


def _potential(r: Reports) -> Array:
    """The work against gravity from the frame's origin."""
    g, total = np.array(r.geometry.gravity(), dtype=float), np.zeros(r.count)
    for link in r.masses:
        total -= r.mass(link)[0] * (g @ r.point_position(link, r.centre_of_mass(link)))
    return total


def _elastic(r: Reports) -> Array:
    stored = [one.kind.stored(r, one.name, one.entry) for one in r.every if one.kind.stores]
    return np.asarray(sum(stored, np.zeros(r.count)))


def _stored(r: Reports) -> Array:
    return _kinetic(r) + _potential(r) + _elastic(r)


def _supplied(r: Reports) -> Array:
    done = [power for name, drive in r.mechanism.drives.items() for power in r.powers_of(drive.applied(r, name))]
    return np.asarray(sum(done, np.zeros(r.count)))


def _dissipated(r: Reports) -> Array:
    return np.asarray(-sum(r.powers_of(r.dissipative_forces()), np.zeros(r.count)))


ENERGIES: dict[str, Callable[[Reports], Array]] = {
    "kinetic": _kinetic,
    "potential": _potential,
    "elastic": _elastic,
    "stored": _stored,
    "supplied": _supplied,
    "dissipated": _dissipated,
}


def _of_power(r: Reports, signal: Signal) -> Iterator[Restated]:
    (name,) = signal.owners
    (one,) = r.compiled.quantities.signals.powered[name]
    if one is None:
        done = r.powers_of(r.mechanism.drives[name].applied(r, name))
        yield Restated(np.asarray(sum(done, np.zeros(r.count))))
    elif signal.attribute == "supplied":
        yield Restated(np.asarray(sum(r.powers_of(one.kind.applied(r, one.name, one.entry)), np.zeros(r.count))))
    else:
        lost = r.powers_of(one.kind.dissipative_forces(r, one.name, one.entry))
        yield Restated(np.asarray(-sum(lost, np.zeros(r.count))))


def _of_acting(r: Reports, signal: Signal) -> Iterator[Restated]:
    one: Acting = r.compiled.quantities.signals.acting[signal.owners[0]]
    yield from _given(one.kind.restated(r, one.name, one.entry), signal.attribute)


def _given(every: Mapping[str, Restated], attribute: str) -> Iterator[Restated]:
    if attribute in every:
        yield every[attribute]


FORMULAS: dict[str, Callable[[Reports, Signal], Iterator[Restated]]] = {
    "point": _of_point,
    "com": _of_com,
    "link": _of_link,
    "slide": _of_slide,
    "joint": _of_joint,
    "drive": _of_drive,
    "force": _of_force,
    "shaking": _of_shaking,
    "energy": _of_energy,
    "power": _of_power,
}
"""By the kind of element that a signal belongs to; the rest are of what acts on links."""
