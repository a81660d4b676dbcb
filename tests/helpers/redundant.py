"""Random redundant mechanisms, and an independent solver of them: all constraints of all links at once.

Positions by Gauss-Newton steps of least squares; rates from the Jacobian and its derivative (complex steps); forces by
least squares from the equilibrium of all links, J^T r + w = 0, and which of them that determines by singular values.
There are no groups, and no joint is left out.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
UNITS = {"length": "m", "angle": "rad", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"}
G = 9.81
SPEED = 1.7


@dataclass
class Bodies:
    """A mechanism at its start pose: links by name with their pose (x, y, angle) and the places of their points then;
    the frame is at the origin."""

    poses: dict[str, Array] = field(default_factory=dict)
    places: dict[str, dict[str, Array]] = field(default_factory=dict)
    masses: dict[str, tuple[float, Array, float]] = field(default_factory=dict)
    rollers: dict[str, tuple[str, str, str, str, float | None, float]] = field(default_factory=dict)
    """Link and pin, slotted link and its point; the slot's angle in the world then, or ``None`` and the radius."""
    slides: dict[str, tuple[tuple[str, str], tuple[str, str], float]] = field(default_factory=dict)
    """Link and point of both lines, and their angle in the world then."""
    crank: str = "crank"

    def link(self, random: np.random.Generator, name: str, **places: Any) -> None:
        """Add a link with an arbitrary frame and mass."""
        self.poses[name] = np.array([*random.normal(size=2), random.uniform(-3, 3)])
        self.places[name] = {point: np.array(at, dtype=float) for point, at in places.items()}
        mass = float(random.uniform(0.5, 3))
        self.masses[name] = (mass, random.normal(size=2) * 0.3, float(random.uniform(0.05, 0.4)))

    def frame(self, **places: Any) -> None:
        self.poses.setdefault("frame", np.zeros(3))
        self.places.setdefault("frame", {}).update({p: np.array(at, dtype=float) for p, at in places.items()})

    def local(self, link: str, point: str) -> Array:
        x, y, angle = self.poses[link]
        c, s = math.cos(angle), math.sin(angle)
        return np.array([[c, s], [-s, c]]) @ (self.places[link][point] - [x, y])

    @property
    def moving(self) -> list[str]:
        return [name for name in self.poses if name != "frame"]

    @property
    def pins(self) -> dict[str, list[str]]:
        """The links on each pin."""
        found: dict[str, list[str]] = {}
        for link, points in self.places.items():
            for point in points:
                found.setdefault(point, []).append(link)
        return {point: links for point, links in found.items() if len(links) > 1}

    def document(self) -> dict[str, Any]:
        """The model file."""
        links = {}
        for name in self.places:
            entry: dict[str, Any] = {"points": {p: self.local(name, p).tolist() for p in self.places[name]}}
            if name in self.masses:
                mass, com, inertia = self.masses[name]
                entry |= {"mass": mass, "com": com.tolist(), "inertia": inertia}
            links[name] = entry
        joints: dict[str, Any] = {}
        for name, (link, pin, on, base, angle, radius) in self.rollers.items():
            slot = {"arc": {"centre": base, "radius": radius}}
            if angle is not None:
                slot = {"straight": f"{base} at {float(angle - self.poses[on][2])!r}"}
            joints[name] = {"pin_in_slot": [link, on], "pin": pin, **slot}
        for name, ((a, p), (b, q), angle) in self.slides.items():
            line = [f"{p} at {float(angle - self.poses[a][2])!r}", f"{q} at {float(angle - self.poses[b][2])!r}"]
            joints[name] = {"prismatic": [a, b], "line": line}
        known = self.places["frame"]
        sketch = {p: at.tolist() for link in self.moving for p, at in self.places[link].items() if p not in known}
        start = float(self.poses[self.crank][2])
        return {
            "units": UNITS,
            "gravity": [0, -G],
            "links": links,
            "joints": joints,
            "assembly": sketch,
            "drives": {"motor": {"turns": self.crank, "on": "frame", "speed": SPEED, "start": start}},
        }


class Solver:
    """All constraints over x, y, angle of each moving link; ``rows[k]`` is whose row k is: (joint, link, part)."""

    def __init__(self, bodies: Bodies) -> None:
        self.b = bodies
        self.index = {name: 3 * i for i, name in enumerate(bodies.moving)}
        self.rows: list[tuple[str, str, str]] = []
        self.gaps: list[Callable[[Any], Any]] = []
        for pin, (first, *others) in bodies.pins.items():
            for other in others:
                for k, axis in enumerate("xy"):
                    self.add((pin, other, axis), lambda q, f=first, o=other, p=pin, k=k: (
                        self.at(q, o, self.b.local(o, p))[k] - self.at(q, f, self.b.local(f, p))[k]))  # fmt: skip
        for name, (link, pin, on, base, angle, radius) in bodies.rollers.items():
            self.add((name, link, "gap"), lambda q, r=(link, pin, on, base, angle, radius): self.roller(q, *r))
        for name, ((a, p), (b, r), angle) in bodies.slides.items():
            ends = (a, p, b, r, angle)
            self.add((name, b, "across"), lambda q, e=ends: self.across(q, *e))
            self.add((name, b, "turn"), lambda q, a=a, b=b: self.angle(q, b) - self.angle(q, a))
        start = float(bodies.poses[bodies.crank][2])
        self.drive = len(self.rows)
        self.start = start
        self.add(("motor", bodies.crank, "drive"), lambda q: self.angle(q, bodies.crank))
        self.level = np.zeros(len(self.rows))
        self.level = self.residual(self.q0, 0.0).real  # differences of angles count from the start pose
        keep = [row[2] not in ("turn", "drive") for row in self.rows]
        assert np.abs(self.level[keep]).max(initial=0.0) < 1e-12
        self.level[keep] = 0.0

    def add(self, row: tuple[str, str, str], gap: Callable[[Any], Any]) -> None:
        self.rows.append(row)
        self.gaps.append(gap)

    @property
    def q0(self) -> Array:
        return np.concatenate([self.b.poses[name] for name in self.b.moving])

    def angle(self, q: Any, link: str) -> Any:
        return 0.0 if link == "frame" else q[self.index[link] + 2]

    def at(self, q: Any, link: str, local: Array) -> Any:
        if link == "frame":
            return local
        x, y, turn = q[self.index[link] : self.index[link] + 3]
        c, s = np.cos(turn), np.sin(turn)
        return np.array([x + c * local[0] - s * local[1], y + s * local[0] + c * local[1]])

    def heading(self, q: Any, link: str, angle: float) -> Any:
        turn = self.angle(q, link) + angle - self.b.poses[link][2]
        return np.array([np.cos(turn), np.sin(turn)])

    def roller(self, q: Any, link: str, pin: str, on: str, base: str, angle: float | None, radius: float) -> Any:
        away = self.at(q, link, self.b.local(link, pin)) - self.at(q, on, self.b.local(on, base))
        if angle is None:
            return np.sqrt(away[0] * away[0] + away[1] * away[1]) - radius
        u = self.heading(q, on, angle)
        return u[0] * away[1] - u[1] * away[0]

    def across(self, q: Any, a: str, p: str, b: str, r: str, angle: float) -> Any:
        away = self.at(q, b, self.b.local(b, r)) - self.at(q, a, self.b.local(a, p))
        u = self.heading(q, a, angle)
        return u[0] * away[1] - u[1] * away[0]

    def residual(self, q: Any, t: float) -> Any:
        found = np.array([gap(q) for gap in self.gaps]) - self.level
        found[self.drive] -= SPEED * t
        return found

    def jacobian(self, q: Any) -> Any:
        """By complex steps; of a complex pose by differences of these."""
        if np.iscomplexobj(q):
            h = 1e-5  # four points: exact to h^4
            return sum(
                w * (self.jacobian(q.real + k * h * q.imag) / (12 * h)) for k, w in ((-2, 1), (-1, -8), (1, 8), (2, -1))
            )
        n = q.size
        return np.array([self.residual(q + 1e-30j * e, 0.0).imag / 1e-30 for e in np.eye(n)]).T

    def pose(self, q: Array, t: float) -> Array:
        for _ in range(50):
            step = np.linalg.lstsq(self.jacobian(q), self.residual(q, t).real, rcond=1e-9)[0]
            q = q - step
            if np.abs(step).max() < 1e-15:
                break
        assert np.abs(self.residual(q, t)).max() < 1e-12
        return q

    def rates(self, q: Array) -> tuple[Array, Array]:
        j = self.jacobian(q)
        right = np.zeros(len(self.rows))
        right[self.drive] = SPEED
        v = np.linalg.lstsq(j, right, rcond=1e-9)[0]
        bent = self.jacobian(q + 1j * v) @ v  # d/dt J times v
        return v, np.linalg.lstsq(j, -bent, rcond=1e-9)[0]

    def wrenches(self, q: Array, v: Array, a: Array) -> Array:
        """Gravity and d'Alembert's forces on each link about its origin: (3 links,)."""
        found = np.zeros(q.size)
        for name, i in self.index.items():
            mass, com, inertia = self.b.masses[name]
            arm = self.at(q, name, com) - q[i : i + 2]
            at = a[i : i + 2] + a[i + 2] * np.array([-arm[1], arm[0]]) - v[i + 2] ** 2 * arm
            force = mass * (np.array([0.0, -G]) - at)
            found[i : i + 2] = force
            found[i + 2] = arm[0] * force[1] - arm[1] * force[0] - inertia * a[i + 2]
        return found

    def balance(self, q: Array, w: Array) -> tuple[Array, Array]:
        """The smallest multipliers in equilibrium, and the states of self-stress (rows, states)."""
        j = self.jacobian(q)
        u, values, _ = np.linalg.svd(j)
        rank = int((values > 1e-9 * values[0]).sum())
        return np.linalg.lstsq(j.T, -w, rcond=1e-9)[0], u[:, rank:]


# Random ones.


def turned(at: Array, angle: float, length: float) -> Array:
    return at + length * np.array([math.cos(angle), math.sin(angle)])


def doubled_bar(b: Bodies, random: np.random.Generator, link: str, name: str) -> None:
    """A second link on two pins of another."""
    points = [p for p in b.places[link] if p in b.pins]
    two = random.choice(points, 2, replace=False)
    b.link(random, name, **{p: b.places[link][p] for p in two})


def arc_roller(b: Bodies, random: np.random.Generator, link: str, pivot: str, name: str) -> None:
    """A roller of a link that turns about a pivot of the frame, in an arc about that."""
    radius = float(random.uniform(0.4, 1.5))
    b.places[link][name] = turned(b.places["frame"][pivot], float(random.uniform(-3, 3)), radius)
    b.rollers[f"arc{name}"] = (link, name, "frame", pivot, None, radius)


def four_bar(random: np.random.Generator) -> tuple[Bodies, list[str], list[tuple[str, str]]]:
    """A four-bar; its bars, and its links that turn about the frame with their pivots."""
    b = Bodies()
    a0, b0 = np.zeros(2), random.normal(size=2) + np.array([3, 0])
    a, c = turned(a0, random.uniform(-3, 3), random.uniform(0.5, 1)), random.normal(size=2) * 0.7 + [1.5, 2]
    b.frame(A0=a0, B0=b0)
    b.link(random, "crank", A0=a0, A=a)
    b.link(random, "coupler", A=a, B=c)
    b.link(random, "rocker", B0=b0, B=c)
    return b, ["coupler", "rocker"], [("crank", "A0"), ("rocker", "B0")]


def slider_crank(random: np.random.Generator) -> tuple[Bodies, list[str], list[tuple[str, str]]]:
    b = Bodies()
    a0, angle = np.zeros(2), float(random.uniform(-3, 3))
    a = turned(a0, random.uniform(-3, 3), random.uniform(0.5, 0.8))
    c = turned(random.normal(size=2) * 0.2, angle, random.uniform(2.0, 3.0))
    b.frame(A0=a0, F=turned(c, angle, -1.0))
    b.link(random, "crank", A0=a0, A=a)
    b.link(random, "rod", A=a, C=c)
    b.link(random, "slider", C=c)
    b.slides["guide"] = (("frame", "F"), ("slider", "C"), angle)
    return b, ["rod"], [("crank", "A0")]


def add_guide(b: Bodies, random: np.random.Generator, name: str) -> None:
    """One more guide of the slider: a roller in a slot along its line, or a slide."""
    angle = b.slides["guide"][2]
    at = b.places["slider"]["C"] + random.normal(size=2)
    b.places["slider"][f"P{name}"] = at
    b.frame(**{f"F{name}": turned(at, angle, float(random.uniform(-1, 1)))})
    if random.random() < 0.6:
        b.rollers[f"roller{name}"] = ("slider", f"P{name}", "frame", f"F{name}", angle, 0.0)
    else:
        b.slides[f"slide{name}"] = (("frame", f"F{name}"), ("slider", f"P{name}"), angle)


def parallelogram(random: np.random.Generator, cranks: int) -> Bodies:
    """Parallel cranks under one coupler, some of them with a roller in a slot of the coupler beside."""
    b = Bodies()
    angle, length = float(random.uniform(0.4, 1.2)), float(random.uniform(0.5, 1.0))
    roots = [np.zeros(2), *(random.normal(size=2) + np.array([1.5 * i, 0]) for i in range(1, cranks))]
    b.frame(**{f"A{i}": at for i, at in enumerate(roots)})
    tips = {f"B{i}": turned(at, angle, length) for i, at in enumerate(roots)}
    b.link(random, "crank", A0=roots[0], B0=tips["B0"])
    for i in range(1, cranks):
        b.link(random, f"crank{i}", **{f"A{i}": roots[i], f"B{i}": tips[f"B{i}"]})
    b.link(random, "coupler", **tips)
    return b


def scissor(random: np.random.Generator) -> Bodies:
    """Two equal arms crossed in their middles, a platform on them, guided upright; the first one is turned."""
    b = Bodies()
    size, angle = float(random.uniform(1, 2)), float(random.uniform(0.4, 1.1))
    c, s = size * math.cos(angle), size * math.sin(angle)
    b.frame(A0=[0, 0], R=[0, 0], H=[0, 0])
    b.link(random, "crank", A0=[0, 0], M=[c / 2, s / 2], B1=[c, s])
    b.link(random, "down", B0=[c, 0], M=[c / 2, s / 2], A1=[0, s])
    b.link(random, "platform", A1=[0, s], S=[0.3 * c, s], P=[-0.2, s + 0.3])
    b.places["frame"]["H"] = np.array([-0.2, 0.1])
    b.rollers["rail"] = ("down", "B0", "frame", "R", 0.0, 0.0)
    b.rollers["top"] = ("crank", "B1", "platform", "S", 0.0, 0.0)
    if random.random() < 0.5:
        b.rollers["upright"] = ("platform", "P", "frame", "H", math.pi / 2, 0.0)
    else:
        b.slides["upright"] = (("frame", "H"), ("platform", "P"), math.pi / 2)
    return b


def random_redundant(seed: int) -> Bodies:
    """A mechanism with one to three constraints too many, away from singular poses."""
    for attempt in range(200):
        random = np.random.default_rng([seed, attempt])
        family = seed % 4
        if family == 0:
            b = parallelogram(random, int(random.integers(3, 6)))
        elif family == 1:
            b = scissor(random)
            if random.random() < 0.5:
                doubled_bar(b, random, "down", "twin")
        else:
            b, bars, turning = (four_bar if family == 2 else slider_crank)(random)
            for k in range(int(random.integers(1, 4))):
                way = random.integers(0, 3 if family == 3 else 2)
                if way == 0:
                    doubled_bar(b, random, str(random.choice(bars)), f"twin{k}")
                elif way == 1:
                    link, pivot = turning[int(random.integers(len(turning)))]
                    arc_roller(b, random, link, pivot, f"R{k}")
                else:
                    add_guide(b, random, str(k))
        solver = Solver(b)
        j = solver.jacobian(solver.q0)
        values = np.linalg.svd(j, compute_uv=False)
        if values[0] / values[j.shape[1] - 1] < 60 and j.shape[0] > j.shape[1]:
            return b
    raise AssertionError(seed)
