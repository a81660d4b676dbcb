"""The certificate: each claim of a run recomputed from what it reports, in plain NumPy.

Nothing here uses the graph's formulas: closure, equilibrium and power are checked on the reported poses, rates,
reactions and efforts, link by link, from the model's own numbers.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.graph.geometry import Geometry
from linkwright.results.run import Run
from linkwright.results.stationary import stationary
from linkwright.structure import FRAME

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Nearest:
    """The group nearest to a singular pose: its normalised determinant (0 singular, 1 best) and the time (s)."""

    group: str
    determinant: float
    time: float


@dataclass(frozen=True)
class Certificate:
    """The proofs of a run; residuals are relative, with the size that they are relative to in their docstrings.

    closure: worst distance (or sine) by which a joint's two links miss each other, over the mechanism's size.
    equilibrium: worst force or moment left on any link, the frame too, over the largest force (or its moment).
    power: worst sum of drive, load, gravity and inertia power, over the sum of their sizes.
    work: work of drives and loads less the change of energy over the run, over the work's and energies' sizes.
    The last three are ``None`` where no link has mass and nothing loads it: there is nothing to balance.
    """

    closure: float
    equilibrium: float | None
    power: float | None
    work: float | None
    mobility: int
    gruebler: int
    rank: int
    loops: int
    nearest: Nearest | None
    branches: dict[str, str]  # the assembly rule that each group keeps; empty where it has one mode only
    poses: int
    kernel: str

    @property
    def residuals(self) -> dict[str, float]:
        """The relative residuals by name, those that say something."""
        every = {name: getattr(self, name) for name in ("closure", "equilibrium", "power", "work")}
        return {name: value for name, value in every.items() if value is not None}

    def sound(self, tolerance: float = 1e-9) -> bool:
        """Whether every residual is below ``tolerance``."""
        return max(self.residuals.values()) < tolerance


def certify(run: Run) -> Certificate:
    """Prove a run at its sampled times."""
    return _Prover(run).prove()


class _Prover:
    def __init__(self, run: Run) -> None:
        self.run, self.compiled = run, run.compiled
        self.structure = self.compiled.structure
        self.topology = self.structure.topology
        self.mechanism = self.compiled.mechanism
        self.geometry = Geometry(self.compiled.quantities, self.compiled.quantities.parameters)
        self.g = np.array(self.geometry.gravity(), dtype=float)

    def prove(self) -> Certificate:
        t = self.run.t
        self.look(t)
        rank = self.rank()
        loaded = bool(self.masses or self.mechanism.loads)
        topology = self.topology
        return Certificate(
            closure=self.closure(),
            equilibrium=self.equilibrium() if loaded else None,
            power=self.power() if loaded else None,
            work=self.work() if loaded else None,
            mobility=3 * len(topology.moving) - rank,
            gruebler=topology.gruebler,
            rank=rank,
            loops=topology.loops,
            nearest=self.nearest(),
            branches=self.branches(),
            poses=t.size,
            kernel=self.compiled.kernel,
        )

    # What a run reports, read once.

    def look(self, t: Array) -> None:
        names = [row for link in self.topology.moving for row in _pose_rows(link)]
        names += [f"{link}.{a}" for link in self.topology.moving for a in ("omega", "alpha")]
        names += [f"com({link}).{a}" for link in self.masses for a in ("x", "y", "vx", "vy", "ax", "ay")]
        self.contacts = self.compiled.quantities.signals.contacts
        for c in self.contacts:
            names += [self.force_name(c, a) for a in (("x", "y", "moment") if c.sliding else ("x", "y"))]
        for name, drive in self.mechanism.drives.items():
            names += [f"{name}.{a}" for a in (("torque", "omega") if drive.turns else ("force", "v"))]
        names += ["shaking.x", "shaking.y", "shaking.moment"]
        self.rows = dict(zip(names, self.compiled.evaluate(names, t), strict=True))
        self.count = t.size

    def force_name(self, contact: Any, attribute: str) -> str:
        return f"force({contact.link}, {contact.on}, {contact.joint}).{attribute}"

    @property
    def masses(self) -> list[str]:
        return [link for link in self.topology.moving if self.mechanism.links[link].mass is not None]

    def axis(self, link: str) -> Array:
        """The unit vector of a link's x axis: (2, poses)."""
        if link == FRAME:
            return np.tile([[1.0], [0.0]], self.count)
        return np.array([self.rows[f"{link}:cos"], self.rows[f"{link}:sin"]])

    def turned(self, link: str, local: Any) -> Array:
        """A vector fixed in a link, in the frame: (2, poses)."""
        c, s = self.axis(link)
        return np.array([c * local[0] - s * local[1], s * local[0] + c * local[1]])

    def at(self, link: str, local: Any) -> Array:
        """A link's point in the frame: (2, poses)."""
        start = (
            np.zeros((2, 1)) if link == FRAME else np.array([self.rows[f"{link}:x"], self.rows[f"{link}:y"]])
        )
        return start + self.turned(link, local)

    def pinned(self, link: str, pin: str) -> Array:
        return self.at(link, self.geometry.point(link, self.topology.pins[pin].point(link)))

    # Closure.

    def closure(self) -> float:
        misses, size = [0.0], self.size()
        for pin in self.topology.pins.values():
            here = self.pinned(pin.links[0], pin.name)
            misses += [_worst(self.pinned(link, pin.name) - here) / size for link in pin.links[1:]]
        for name, joint in self.mechanism.prismatic_joints():
            a, b = joint.links
            (pa, ha), (pb, hb) = (self.geometry.line(name, link) for link in (a, b))
            along, other = self.turned(a, ha), self.turned(b, hb)
            misses.append(_worst(_cross(self.at(b, pb) - self.at(a, pa), along)) / size)
            misses.append(_worst(other - along))
        for link in self.topology.moving:
            misses.append(_worst(np.hypot(*self.axis(link)) - 1.0))
        return max(misses)

    def size(self) -> float:
        """The mechanism's extent at the sampled poses (m)."""
        points = [
            self.at(link, self.geometry.point(link, point))
            for link, entry in self.mechanism.links.items()
            for point in entry.points
        ]
        every = np.concatenate([np.broadcast_to(p, (2, self.count)) for p in points], axis=1)
        return float(np.hypot(*(np.nanmax(every, axis=1) - np.nanmin(every, axis=1)))) or 1.0

    # Equilibrium.

    def equilibrium(self) -> float:
        """Force and moment left on each link, from the reported reactions alone."""
        forces = {link: np.zeros((2, self.count)) for link in self.mechanism.links}
        moments = {link: np.zeros(self.count) for link in self.mechanism.links}
        largest = np.zeros(self.count)

        def push(link: str, force: Array, at: Array, moment: Array | float = 0.0) -> None:
            nonlocal largest
            forces[link] += force
            moments[link] += _cross(at, force) + moment
            largest = np.maximum(largest, np.hypot(*force))

        for c in self.contacts:
            force = np.array([self.rows[self.force_name(c, a)] for a in ("x", "y")])
            if c.sliding:
                second = self.mechanism.joints[c.joint].links[1]
                at = self.at(second, self.geometry.line(c.joint, second)[0])
                push(c.on, force, at, self.rows[self.force_name(c, "moment")])
            else:
                # The reported force is of a link on the pin; what the pin does to the link is the opposite.
                push(c.link, -force, self.pinned(c.link, c.joint))
        for name, drive in self.mechanism.drives.items():
            effort = self.rows[f"{name}.{'torque' if drive.turns else 'force'}"]
            if drive.turns:
                moments[drive.link] += effort
                moments[drive.on] -= effort
            else:
                joint = self.topology.driven(name)[0].joint
                point, heading = self.geometry.line(joint, drive.on)
                force = effort * self.turned(drive.on, heading)
                push(drive.link, force, self.at(drive.on, point))
                push(drive.on, -force, self.at(drive.on, point))
        for link, force, at, moment in self.applied():
            push(link, force, at, moment)
        shaking = np.array([self.rows["shaking.x"], self.rows["shaking.y"]])
        forces[FRAME] -= shaking
        moments[FRAME] -= self.rows["shaking.moment"]
        scale = max(float(np.nanmax(largest, initial=0.0)), 1e-300)
        arm = self.size()
        return max(max(_worst(forces[n]), _worst(moments[n]) / arm) / scale for n in self.mechanism.links)

    def applied(self) -> list[tuple[str, Array, Array, Any]]:
        """Gravity and inertia of each link, and the loads: (link, force, where, moment)."""
        found: list[tuple[str, Array, Array, Any]] = []
        for link in self.masses:
            mass, centre, inertia = self.geometry.mass(link)
            acceleration = np.array([self.rows[f"com({link}).{a}"] for a in ("ax", "ay")])
            force = float(mass) * (self.g[:, None] - acceleration)
            found.append((link, force, self.at(link, centre), -float(inertia) * self.rows[f"{link}.alpha"]))
        return found + self.loads()

    def loads(self) -> list[tuple[str, Array, Array, Any]]:
        found = []
        for load in self.mechanism.loads.values():
            force, turn = self.geometry.force(load), load.in_ or FRAME
            local = np.array(force, dtype=float)
            if load.along:
                turn = self.mechanism.joints[load.along].links[0]
                local = local[0] * np.array(self.geometry.line(load.along, turn)[1], dtype=float)
            at = np.broadcast_to(self.at(load.on, self.geometry.load_point(load)), (2, self.count))
            found.append((load.on, self.turned(turn, local), at, float(self.geometry.torque(load))))
        return found

    # Power and work.

    def powers(self) -> tuple[Array, Array]:
        """The power of all drives, applied and inertia forces, and the sum of its terms' sizes: (poses,) each."""
        terms = [self.drive_power(name) for name in self.mechanism.drives]
        for link, force, at, moment in self.applied():
            velocity = self.velocity(link, at)
            terms += [force[0] * velocity[0], force[1] * velocity[1], moment * self.rows[f"{link}.omega"]]
        return sum(terms, np.zeros(self.count)), sum(map(np.abs, terms), np.zeros(self.count))

    def drive_power(self, name: str) -> Array:
        drive = self.mechanism.drives[name]
        effort, rate = ("torque", "omega") if drive.turns else ("force", "v")
        return np.asarray(self.rows[f"{name}.{effort}"] * self.rows[f"{name}.{rate}"])

    def velocity(self, link: str, at: Array) -> Array:
        """The velocity of a link's point, from the velocity of its centre of mass, else of its origin."""
        if link in self.masses:
            known = np.array([self.rows[f"com({link}).{a}"] for a in ("vx", "vy")])
            centre = np.array([self.rows[f"com({link}).{a}"] for a in ("x", "y")])
        else:
            point = next(iter(self.mechanism.links[link].points))
            known = self.compiled.evaluate([f"{point}.vx", f"{point}.vy"], self.run.t)
            centre = self.at(link, self.geometry.point(link, point))
        arm = at - centre
        omega = self.rows[f"{link}.omega"]
        return np.asarray(known + omega * np.array([-arm[1], arm[0]]))

    def power(self) -> float:
        total, size = self.powers()
        top = float(np.nanmax(size, initial=0.0))
        return float(np.nanmax(np.abs(total)) / top) if top > 0 else 0.0

    def work(self) -> float:
        """Work of drives and loads by Gauss quadrature between the samples, against the change of energy."""
        nodes, weights = np.polynomial.legendre.leggauss(8)
        t, h = self.run.t, np.diff(self.run.t)
        at = (t[:-1, None] + h[:, None] * (nodes + 1) / 2).ravel()
        weight = (h[:, None] * weights / 2).ravel()
        kept = self.rows, self.count, self.run
        self.look(at)
        power = sum((self.drive_power(name) for name in self.mechanism.drives), np.zeros(self.count))
        inner = Run(self.compiled, self.run.start, self.run.stop, self.run.steps)
        inner.__dict__["t"] = at
        self.run = inner
        for link, force, where, moment in self.loads():
            velocity = self.velocity(link, where)
            power = power + (force * velocity).sum(axis=0) + moment * self.rows[f"{link}.omega"]
        self.rows, self.count, self.run = kept
        energy = self.compiled.evaluate(["energy.kinetic", "energy.potential"], t[[0, -1]])
        change = float(energy.sum(axis=0) @ np.array([-1.0, 1.0]))
        size = float(np.abs(power) @ weight) + float(np.abs(energy).sum())
        return abs(float(power @ weight) - change) / size if size > 0 else 0.0

    # Structure at the poses.

    def rank(self) -> int:
        """The rank of the joints' constraint Jacobian at the sampled pose where it is largest."""
        index = {link: 3 * i for i, link in enumerate(self.topology.moving)}
        poses = np.unique(np.linspace(0, self.count - 1, 5).astype(int))
        return max(int(np.linalg.matrix_rank(self.jacobian(index, pose), tol=1e-9)) for pose in poses)

    def jacobian(self, index: dict[str, int], pose: int) -> Array:
        """Rows of constraint velocities over (vx, vy, omega) of each link's origin; lengths over the size."""
        size, rows = self.size(), []

        def velocity(link: str, at: Array) -> Array:
            row = np.zeros((2, 3 * len(index)))
            if link != FRAME:
                arm = (at - self.at(link, (0.0, 0.0))[:, pose]) / size
                row[:, index[link] : index[link] + 3] = [[1, 0, -arm[1]], [0, 1, arm[0]]]
            return row

        def turning(link: str) -> Array:
            row = np.zeros(3 * len(index))
            if link != FRAME:
                row[index[link] + 2] = 1.0
            return row

        for pin in self.topology.pins.values():
            first = pin.links[0]
            at = np.broadcast_to(self.pinned(first, pin.name), (2, self.count))[:, pose]
            rows += [velocity(link, at) - velocity(first, at) for link in pin.links[1:]]
        for name, joint in self.mechanism.prismatic_joints():
            a, b = joint.links
            along = self.turned(a, self.geometry.line(name, a)[1])[:, pose]
            at = np.broadcast_to(self.at(b, self.geometry.line(name, b)[0]), (2, self.count))[:, pose]
            normal = np.array([-along[1], along[0]])
            rows += [(normal @ (velocity(b, at) - velocity(a, at)))[None], (turning(b) - turning(a))[None]]
        return np.concatenate(rows) if rows else np.zeros((1, 3 * len(index)))

    def nearest(self) -> Nearest | None:
        """The smallest normalised determinant over the run, root-found between the samples."""
        groups = self.structure.groups
        if not groups:
            return None
        names = [f"determinant:{group.label}" for group in groups]

        def rates(t: Array) -> tuple[Array, Array]:
            # Of the magnitude, so that a passage through zero is a turning point too.
            y = self.compiled.evaluate(names, t, rates=True)
            return np.abs(y[:, 0]), np.sign(y[:, 0]) * y[:, 1]

        found = []
        turning = stationary(rates, self.run.start, self.run.stop, self.run.steps)
        for i, group in enumerate(groups):
            times = np.concatenate([turning[i], [self.run.start, self.run.stop]])
            values = np.abs(self.compiled.evaluate([names[i]], times)[0])
            found.append(Nearest(group.label, float(values.min()), float(times[values.argmin()])))
        return min(found, key=lambda nearest: nearest.determinant)

    def branches(self) -> dict[str, str]:
        branches = self.compiled.assembly.branches
        return {group.label: group.rule(branches.get(group, 1.0)) for group in self.structure.groups}


def _pose_rows(link: str) -> list[str]:
    return [f"{link}:{row}" for row in ("x", "y", "cos", "sin")]


def _cross(a: Array, b: Array) -> Array:
    return np.asarray(a[0] * b[1] - a[1] * b[0])


def _worst(values: Array) -> float:
    return float(np.nanmax(np.abs(values), initial=0.0))
