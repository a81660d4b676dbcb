"""A run's reports looked at anew, in plain NumPy: poses, rates, reactions and efforts at some times.

Nothing here uses the graph's formulas; the proofs work on what is reported and on the model's own numbers.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.elements.force import Misfit
from linkwright.elements.joint import Applied
from linkwright.elements.touch import ReportedTouch
from linkwright.expressions.fields import Expression
from linkwright.expressions.units import Dimension
from linkwright.graph.geometry import Geometry
from linkwright.graph.rows import BodyPlace, Named, WindowRow
from linkwright.kernels import Compiled
from linkwright.kernels.combined import combined
from linkwright.kernels.motions import StatedMotion
from linkwright.notation import Jet
from linkwright.notation.angles import wrapped
from linkwright.structure import FRAME

Array = NDArray[np.float64]

PART_OF_TURN = 1.0
"""Between two times at which turns are counted a link turns by no more than this (rad) ..."""
HALVINGS, MOST_TIMES = 4, 1 << 18
"""... which is looked at so often, with so many times at most."""


class Reports:
    """What a compiled mechanism reports at times ``t`` (s), in SI; vectors have shape (2, times)."""

    def __init__(self, compiled: Compiled, t: Array) -> None:
        self.compiled, self.t, self.count = compiled, t, t.size
        self.mechanism, self.topology = compiled.mechanism, compiled.structure.topology
        self.geometry = Geometry(compiled.quantities, compiled.quantities.parameters)
        self.contacts, self.looped = compiled.quantities.signals.contacts, compiled.quantities.signals.looped
        self.every = [*self.mechanism.acting()]
        self.names = self._names()
        self.rows: dict[Named, Array] = dict(zip(self.names, compiled.possible_rows(self.names, t), strict=True))

    def _names(self) -> list[Named]:
        moving, movers = self.topology.moving, self.mechanism.movers
        names: list[Named] = [*self.compiled.graph.pose_rows]
        names += [f"{link}.{rate}" for link in moving for rate in ("omega", "alpha")]
        names += [f"com({link}).{rate}{axis}" for link in self.masses for rate in ("", "v", "a") for axis in "xy"]
        names += [f"{self.some_point(link)}.v{axis}" for link in moving for axis in "xy"]
        names += [self.force_name(c, a) for c in self.contacts for a in "xy"]
        names += [
            self.force_name(c, "moment")
            for c in self.contacts
            if "moment" in self.compiled.quantities.signals.of_contact(c)
        ]
        names += [f"{n}.{a}" for n, d in movers.items() for a in (d.effort, d.rate)]
        names += [f"{f.motor}.{movers[f.motor].value}" for f in self.mechanism.followers.values()]
        names += [f"{name}.{attribute}" for name, f in self.mechanism.followers.items() for attribute in f.reported]
        names += [s.text for s in self.compiled.graph.actions.signals]
        names += [WindowRow(name) for name in self.compiled.graph.actions.windows]
        names += [f"{one.name}.{a}" for one in self.every for a in one.kind.reported(one.entry)]
        names += ["shaking.x", "shaking.y", "shaking.moment"]
        return list(dict.fromkeys(names))

    def force_name(self, contact: Any, attribute: str) -> str:
        """The signal of a contact's reaction."""
        return f"force({contact.link}, {contact.on}, {contact.joint}).{attribute}"

    @property
    def masses(self) -> list[str]:
        """The moving links that have mass."""
        return [link for link in self.topology.moving if self.mechanism.has_mass(link)]

    def mass(self, link: str) -> tuple[float, float]:
        """A link's mass (kg) and its moment of inertia about the centre of that (kg m^2)."""
        mass, _, inertia = self.geometry.mass(link)
        return float(mass), float(inertia)

    def centre_of_mass(self, link: str) -> Any:
        """Its centre of mass in its own axes (m)."""
        return self.geometry.mass(link)[1]

    def some_point(self, link: str) -> str:
        """Some point of a link."""
        return next(iter(self.mechanism.links[link].points))

    def vector(self, name: str) -> Array:
        """The signals ``name`` x and ``name`` y as a vector."""
        return np.array([self.rows[f"{name}{axis}"] for axis in "xy"])

    def of_body(self, link: str, *parts: str) -> Array:
        """Parts of a moving link's pose: (parts, times)."""
        return np.array([self.rows[BodyPlace(link, part)] for part in parts])

    # Places.

    def rotated(self, link: str, local: Any) -> Array:
        """A vector fixed in a link, in the frame."""
        c, s = (np.ones(self.count), np.zeros(self.count)) if link == FRAME else self.of_body(link, "cos", "sin")
        return np.array([c * local[0] - s * local[1], s * local[0] + c * local[1]])

    def point_position(self, link: str, local: Any) -> Array:
        """A link's point in the frame (m)."""
        rotated = self.rotated(link, local)
        return rotated if link == FRAME else self.of_body(link, "x", "y") + rotated

    def line(self, joint: str, link: str) -> tuple[Array, Array]:
        """Point and direction of a prismatic joint's line on one of its links."""
        point, heading = self.geometry.line(joint, link)
        return self.point_position(link, point), self.rotated(link, heading)

    @property
    def motions(self) -> dict[str, StatedMotion]:
        """The motion laws by name."""
        return self.compiled.motions

    def number(self, expression: Expression, dimension: Dimension) -> float:
        """The value of an expression of the model (SI)."""
        return self.compiled.quantities.value(expression, dimension)

    def size(self) -> float:
        """The mechanism's extent over all poses (m)."""
        return self._size

    @cached_property
    def _size(self) -> float:
        links = self.mechanism.links.items()
        points = [
            self.point_position(link, self.geometry.point(link, point))
            for link, entry in links
            for point in entry.points
        ]
        every = np.concatenate(points, axis=1)
        return float(np.hypot(*np.ptp(every, axis=1))) or 1.0

    def velocity(self, link: str, place: Array) -> Array:
        """The velocity of a link where it is at ``place``, from that of one of its points and its omega."""
        if link == FRAME:
            return np.zeros((2, self.count))
        point = self.some_point(link)
        arm = place - self.point_position(link, self.geometry.point(link, point))
        return np.asarray(self.vector(f"{point}.v") + self.rows[f"{link}.omega"] * np.array([-arm[1], arm[0]]))

    # Forces.

    def inertia_and_gravity(self) -> list[Applied]:
        """Gravity and d'Alembert's forces on each link with mass."""
        g = np.array(self.geometry.gravity(), dtype=float)[:, None]
        found: list[Applied] = []
        for link in self.masses:
            mass, centre, inertia = self.geometry.mass(link)
            force = float(mass) * (g - self.vector(f"com({link}).a"))
            found.append((link, force, self.point_position(link, centre), -float(inertia) * self.rows[f"{link}.alpha"]))
        return found

    def centrifugal(self) -> float:
        """The largest of m v^2 and I omega^2 over the mechanism's size (N): the scale of what cancels where links with
        mass turn evenly."""
        largest = 0.0
        for link in self.masses:
            mass, _, inertia = self.geometry.mass(link)
            speed, omega = np.hypot(*self.vector(f"com({link}).v")), self.rows[f"{link}.omega"]
            energy = np.maximum(float(mass) * speed**2, float(inertia) * omega**2)
            largest = max(largest, float(energy.max(initial=0.0)))
        return largest / self.size()

    def acting(self) -> list[Applied]:
        """What springs, loads and the like do to all their links, from the reported poses and rates."""
        return [found for one in self.every for found in one.kind.applied(self, one.name, one.entry)]

    def dissipative_forces(self) -> list[Applied]:
        """The part of that whose work no energy keeps."""
        return [found for one in self.every for found in one.kind.dissipative_forces(self, one.name, one.entry)]

    def misfits(self) -> list[Misfit]:
        """By what they report of themselves misses what the motion makes of them."""
        found = [found for one in self.every for found in one.kind.misfits(self, one.name, one.entry)]
        joints = self.topology.joints.items()
        return [*found, *(Misfit(miss, True) for name, (kind, _) in joints for miss in kind.misfits(self, name))]

    def omega(self, link: str) -> Array:
        """A link's angular velocity (rad/s)."""
        return np.zeros(self.count) if link == FRAME else np.asarray(self.rows[f"{link}.omega"])

    def turned(self, link: str) -> Array:
        """A link's angle (rad) over all turns since the first time: the reported rates tell the turns, the reported
        directions the rest."""
        if link == FRAME:
            x, y = self.rotated(link, (1.0, 0.0))
            return np.asarray(np.arctan2(y, x) + np.zeros(self.count))
        t, at = self._between(link)
        c, s, omega, alpha = self.compiled.possible_rows(
            [BodyPlace(link, "cos"), BodyPlace(link, "sin"), f"{link}.omega", f"{link}.alpha"], t
        )
        angle, step = np.arctan2(s, c), np.diff(t)
        # Euler and Maclaurin's rule: the trapezium less its error by the slopes at its ends.
        about = step * (omega[1:] + omega[:-1]) / 2 - step**2 * np.diff(alpha) / 12
        about = np.where(np.isfinite(about), about, 0.0)
        turned = about + wrapped(np.diff(angle) - about)
        return np.asarray(angle[:1] + np.concatenate([[0.0], np.cumsum(turned)]))[at]

    def _between(self, link: str) -> tuple[Array, NDArray[np.intp]]:
        """Times (s) so close that a link turns by no more than a part of a turn from one to the next, and which of them
        are those of the reports."""
        t, whole = self.t, np.arange(self.count)
        for _ in range(HALVINGS):
            omega = np.abs(self.compiled.possible_rows([f"{link}.omega"], t)[0])
            far = np.diff(t) * np.fmax(omega[1:], omega[:-1])
            parts = np.ceil(np.where(np.isfinite(far), far, 0.0) / PART_OF_TURN).astype(int)
            if parts.max(initial=0) <= 1 or t.size + parts.sum() > MOST_TIMES:
                break
            middles = [
                np.linspace(a, b, count + 1)[1:-1]
                for a, b, count in zip(t[:-1], t[1:], parts, strict=True)
                if count > 1
            ]
            t = np.unique(np.concatenate([t, *middles]))
            whole = np.searchsorted(t, self.t)
        return t, whole

    def table(self, name: str, argument: Array) -> Array:
        """What a table says of arguments; NaN outside of it."""
        return np.asarray(self.compiled.tables[name].or_nan(Jet([argument])).d[0])

    def table_area(self, name: str, argument: Array) -> Array:
        """The integral of a table from its first point to arguments, by Gauss quadrature between its knots."""
        knots, period = self.compiled.tables[name].powers()[0], self.compiled.tables[name].period
        nodes, weights = np.polynomial.legendre.leggauss(4)

        def areas(lows: Array, highs: Array) -> Array:
            places = lows[:, None] + (highs - lows)[:, None] * (nodes + 1) / 2
            return np.asarray((self.table(name, places.ravel()).reshape(places.shape) @ weights) * (highs - lows) / 2)

        passed = np.concatenate([[0.0], np.cumsum(areas(knots[:-1], knots[1:]))])
        periods = np.zeros_like(argument) if period is None else np.floor((argument - knots[0]) / period)
        inside = argument if period is None else argument - periods * period
        piece = np.clip(np.searchsorted(knots, inside, side="right") - 1, 0, knots.size - 2)
        return np.asarray(periods * passed[-1] + passed[piece] + areas(knots[piece], inside))

    def value(self, expression: Expression, dimension: Dimension) -> Array:
        """An expression in parameters, the time, tables and reported signals."""
        node = self.compiled.quantities.bind(expression, dimension)
        rows = {name: (row,) for name, row in self.rows.items() if isinstance(name, str)}
        return np.asarray(combined(self.compiled, node, self.t, rows, 0).d[0])

    def inside(self, window: str) -> Array:
        """Whether a window holds. At its edges, where round-off decides, the report is believed."""
        stated = self.compiled.quantities.window(window)
        value = self.t if stated.signal is None else self.rows[self.compiled.graph.signal(stated.signal).text]
        low, high = (self.compiled.quantities.value(end, stated.dimension) for end in stated.ends)
        slack = 1e-9 * max(high - low if high - low < 1e9 else 0.0, float(np.abs(value).max(initial=0.0)))
        over = value - low
        if stated.turning:
            over = np.mod(over + slack, 2 * np.pi) - slack
        vague = (np.abs(over) < slack) | (np.abs(over - (high - low)) < slack)
        return np.where(vague, self.rows[WindowRow(window)] != 0, (over >= 0) & (over <= high - low))

    def reactions(self) -> list[Applied]:
        """What joints do to links, from the reported reactions; the moments of slides in loops of slides are unknown
        and left out."""
        return [self.topology.kind_of(c.joint).applied(self, c) for c in self.contacts]

    def reaction(self, contact: Any) -> tuple[Array, Array | float]:
        """The reported force of a contact's link on the other side, and its moment; 0 where none is reported."""
        force = np.array([self.rows[self.force_name(contact, axis)] for axis in "xy"])
        return force, self.rows.get(self.force_name(contact, "moment"), 0.0)

    def contact(self, joint: str, link: str) -> Any:
        """The contact of a link in a joint."""
        found: Any = next(c for c in self.contacts if (c.joint, c.link) == (joint, link))
        return found

    def law(self, drive: str) -> Array:
        """What a drive prescribes (rad or m), by its law alone."""
        return np.asarray(self.compiled.laws[drive](self.t).d[0]) + np.zeros(self.count)

    def touch(self, joint: str) -> ReportedTouch:
        """Where the links of a contact touch, and the force there."""
        follower = self.mechanism.followers.get(joint)
        if follower is not None:
            return follower.reported_touch(self, joint)
        return self.topology.kind_of(joint).reported_touch(self, joint)

    def joint_of(self, mover: str) -> str:
        """The joint at which a drive or follower moves its link."""
        return self.topology.acting(mover)[0].joint

    def efforts(self) -> list[Applied]:
        """What drives do to both their links, and followers to theirs."""
        return [one for name, mover in self.mechanism.movers.items() for one in mover.applied(self, name)]

    # Power.

    def drive_powers(self) -> list[Array]:
        """Effort times rate of each drive (W). A follower passes power on; it gives none of its own."""
        drives = self.mechanism.drives.items()
        return [self.rows[f"{name}.{drive.effort}"] * self.rows[f"{name}.{drive.rate}"] for name, drive in drives]

    def powers_of(self, applied: list[Applied]) -> list[Array]:
        """The power of each force's components and moment (W)."""
        found: list[Array] = []
        for link, force, place, moment in applied:
            if link == FRAME:
                continue
            velocity = self.velocity(link, place)
            found += [force[0] * velocity[0], force[1] * velocity[1], moment * self.rows[f"{link}.omega"]]
        return found
