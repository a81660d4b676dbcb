"""A run's reports looked at anew, in plain NumPy: poses, rates, reactions and efforts at some times.

Nothing here uses the graph's formulas; the proofs work on what is reported and on the model's own numbers.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.graph.geometry import Geometry
from linkwright.kernels import Compiled
from linkwright.structure import FRAME

Array = NDArray[np.float64]
Applied = tuple[str, Array, Array, Array | float]
"""A force (2, times) on a link at a place (2, times), with a moment (times,): (link, force, place, moment)."""


class Reports:
    """What a compiled mechanism reports at times ``t`` (s), in SI; vectors have shape (2, times)."""

    def __init__(self, compiled: Compiled, t: Array) -> None:
        self.compiled, self.count = compiled, t.size
        self.mechanism, self.topology = compiled.mechanism, compiled.structure.topology
        self.geometry = Geometry(compiled.quantities, compiled.quantities.parameters)
        self.contacts = compiled.quantities.signals.contacts
        names = self._names()
        self.rows: dict[str, Array] = dict(zip(names, compiled.evaluate(names, t), strict=True))

    def _names(self) -> list[str]:
        moving, drives = self.topology.moving, self.mechanism.drives
        names = [f"{link}:{row}" for link in moving for row in ("x", "y", "cos", "sin")]
        names += [f"{link}.{rate}" for link in moving for rate in ("omega", "alpha")]
        names += [f"com({link}).{rate}{axis}" for link in self.masses for rate in ("", "v", "a") for axis in "xy"]
        names += [f"{self.home(link)}.v{axis}" for link in moving for axis in "xy"]
        names += [self.force_name(c, a) for c in self.contacts for a in (("x", "y", "moment") if c.sliding else "xy")]
        names += [f"{n}.{a}" for n, d in drives.items() for a in (("torque", "omega") if d.turns else ("force", "v"))]
        names += ["shaking.x", "shaking.y", "shaking.moment"]
        return list(dict.fromkeys(names))

    def force_name(self, contact: Any, attribute: str) -> str:
        """The signal of a contact's reaction."""
        return f"force({contact.link}, {contact.on}, {contact.joint}).{attribute}"

    @property
    def masses(self) -> list[str]:
        """The moving links that have mass."""
        return [link for link in self.topology.moving if self.mechanism.links[link].mass is not None]

    def home(self, link: str) -> str:
        """Some point of a link."""
        return next(iter(self.mechanism.links[link].points))

    def vector(self, name: str, axes: tuple[str, str] = ("x", "y")) -> Array:
        """Two rows as a vector."""
        return np.array([self.rows[f"{name}{axis}"] for axis in axes])

    # Places.

    def turned(self, link: str, local: Any) -> Array:
        """A vector fixed in a link, in the frame."""
        c, s = (np.ones(self.count), np.zeros(self.count)) if link == FRAME else self.vector(link, (":cos", ":sin"))
        return np.array([c * local[0] - s * local[1], s * local[0] + c * local[1]])

    def at(self, link: str, local: Any) -> Array:
        """A link's point in the frame (m)."""
        turned = self.turned(link, local)
        return turned if link == FRAME else self.vector(link, (":x", ":y")) + turned

    def pinned(self, link: str, pin: str) -> Array:
        """A link's point on a pin."""
        return self.at(link, self.geometry.point(link, self.topology.pins[pin].point(link)))

    def line(self, joint: str, link: str) -> tuple[Array, Array]:
        """Point and direction of a prismatic joint's line on one of its links."""
        point, heading = self.geometry.line(joint, link)
        return self.at(link, point), self.turned(link, heading)

    def size(self) -> float:
        """The mechanism's extent over all poses (m)."""
        links = self.mechanism.links.items()
        points = [self.at(link, self.geometry.point(link, point)) for link, entry in links for point in entry.points]
        every = np.concatenate(points, axis=1)
        return float(np.hypot(*np.ptp(every, axis=1))) or 1.0

    def velocity(self, link: str, place: Array) -> Array:
        """The velocity of a link where it is at ``place``, from that of one of its points and its omega."""
        point = self.home(link)
        arm = place - self.at(link, self.geometry.point(link, point))
        return np.asarray(self.vector(f"{point}.v") + self.rows[f"{link}.omega"] * np.array([-arm[1], arm[0]]))

    # Forces.

    def inertia_and_gravity(self) -> list[Applied]:
        """Gravity and d'Alembert's forces on each link with mass."""
        g = np.array(self.geometry.gravity(), dtype=float)[:, None]
        found: list[Applied] = []
        for link in self.masses:
            mass, centre, inertia = self.geometry.mass(link)
            force = float(mass) * (g - self.vector(f"com({link}).a"))
            found.append((link, force, self.at(link, centre), -float(inertia) * self.rows[f"{link}.alpha"]))
        return found

    def loads(self) -> list[Applied]:
        """The loads of the model."""
        found: list[Applied] = []
        for load in self.mechanism.loads.values():
            turns_with, local = load.in_ or FRAME, np.array(self.geometry.force(load), dtype=float)
            if load.along:
                turns_with = self.mechanism.joints[load.along].links[0]
                local = local[0] * np.array(self.geometry.line(load.along, turns_with)[1], dtype=float)
            place = self.at(load.on, self.geometry.load_point(load))
            found.append((load.on, self.turned(turns_with, local), place, float(self.geometry.torque(load))))
        return found

    def reactions(self) -> list[Applied]:
        """What joints do to links, from the reported reactions."""
        found: list[Applied] = []
        for c in self.contacts:
            force = np.array([self.rows[self.force_name(c, axis)] for axis in "xy"])
            if c.sliding:
                place, _ = self.line(c.joint, self.mechanism.joints[c.joint].links[1])
                found.append((c.on, force, place, self.rows[self.force_name(c, "moment")]))
            else:
                # Reported is the force of the link on the pin; the pin answers with the opposite.
                found.append((c.link, -force, self.pinned(c.link, c.joint), 0.0))
        return found

    def efforts(self) -> list[Applied]:
        """What drives do to both their links."""
        found: list[Applied] = []
        for name, drive in self.mechanism.drives.items():
            if drive.turns:
                torque, nowhere = self.rows[f"{name}.torque"], np.zeros((2, self.count))
                found += [(drive.link, nowhere, nowhere, torque), (drive.on, nowhere, nowhere, -torque)]
            else:
                place, along = self.line(self.topology.acting(name)[0].joint, drive.on)
                force = self.rows[f"{name}.force"] * along
                found += [(drive.link, force, place, 0.0), (drive.on, -force, place, 0.0)]
        return found

    # Power.

    def drive_powers(self) -> list[Array]:
        """Effort times rate of each drive (W)."""
        pairs = [(n, ("torque", "omega") if d.turns else ("force", "v")) for n, d in self.mechanism.drives.items()]
        return [self.rows[f"{name}.{effort}"] * self.rows[f"{name}.{rate}"] for name, (effort, rate) in pairs]

    def powers_of(self, applied: list[Applied]) -> list[Array]:
        """The power of each force's components and moment (W)."""
        found: list[Array] = []
        for link, force, place, moment in applied:
            velocity = self.velocity(link, place)
            found += [force[0] * velocity[0], force[1] * velocity[1], moment * self.rows[f"{link}.omega"]]
        return found
