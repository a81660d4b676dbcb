"""An independent oracle: constraint equations of all links, and the full Newton-Euler system of 3 n equations.

Coordinates are x, y and the angle of every moving link's origin (after Nikravesh, *Computer-Aided Analysis of
Mechanical Systems*, 1988, ch. 4 and 9; Haug 1989, ch. 3): Newton's method on all constraints at once, rates from
the constraint Jacobian, reactions and efforts from 3 n linear equations. No groups, no closed forms, no branches:
the pose is followed from the one given at t = 0.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.plain import FRAME, Plain, PlainDrive, PlainSlide

Array = NDArray[np.float64]


def perp(v: Array) -> Array:
    return np.array([-v[1], v[0]])


def cross(a: Array, b: Array) -> float:
    return float(a[0] * b[1] - a[1] * b[0])


@dataclass(frozen=True)
class State:
    """Coordinates of all moving links and their rates at one instant: three entries a link."""

    t: float
    q: Array
    v: Array
    a: Array


@dataclass(frozen=True)
class Reactions:
    """``reactions[joint, link]`` is the force of the joint on the link and its moment about the pin, or about the
    second link's point of a line, of constraints besides about the link's origin; ``efforts`` each drive's;
    ``shaking`` force and moment on the frame's origin."""

    reactions: dict[tuple[str, str], Array]
    efforts: dict[str, float]
    shaking: Array


FIRST = ((1, 3 / 4), (2, -3 / 20), (3, 1 / 60))
SECOND = ((1, 3 / 2), (2, -3 / 20), (3, 1 / 90))
"""Weights of differences of the sixth order, by steps."""
Extra = Callable[["Oracle", State], list[tuple[str, Array, Array, float]]]
"""What acts besides: (link, force, where, moment) in a state."""


Gap = Callable[["Oracle", Array], float]
"""A constraint beyond pins and slides: what coordinates miss by (m or rad), smooth near them."""


class Oracle:
    """Motion and kinetostatics of a plain mechanism; ``extra`` functions give forces that vary, ``gaps`` constraints
    besides, of which differences are taken."""

    def __init__(self, plain: Plain, extra: Sequence[Extra] = (), gaps: Mapping[str, Gap] | None = None) -> None:
        self.plain, self.extra, self.gaps = plain, extra, gaps or {}
        self.index = {name: 3 * i for i, name in enumerate(plain.moving)}
        self.size = 3 * len(self.index)
        self.turns: dict[str, float] = {}
        q = np.array([value for name in plain.moving for value in plain.start[name]], dtype=float)
        self.turns = {name: self._whole_turns(q, name) for name in (*plain.slides, *plain.drives)}
        self.first = self.settle(q, 0.0)

    # Places.

    def pose(self, q: Array, link: str) -> Array:
        """x, y, angle of a link's origin."""
        return np.zeros(3) if link == FRAME else q[self.index[link] : self.index[link] + 3]

    def arm(self, q: Array, link: str, local: Any) -> Array:
        """From a link's origin to its point, in the frame's directions."""
        c, s = math.cos(self.pose(q, link)[2]), math.sin(self.pose(q, link)[2])
        return np.array([c * local[0] - s * local[1], s * local[0] + c * local[1]])

    def at(self, q: Array, link: str, local: Any) -> Array:
        return np.asarray(self.pose(q, link)[:2] + self.arm(q, link, local))

    def point(self, q: Array, link: str, name: str) -> Array:
        return self.at(q, link, self.plain.links[link].points[name])

    def velocity(self, state: State, link: str, local: Any) -> Array:
        vx, vy, omega = self.pose(state.v, link)
        return np.array([vx, vy]) + omega * perp(self.arm(state.q, link, local))

    def acceleration(self, state: State, link: str, local: Any) -> Array:
        arm, omega, (ax, ay, alpha) = (
            self.arm(state.q, link, local),
            self.pose(state.v, link)[2],
            self.pose(state.a, link),
        )
        return np.asarray(np.array([ax, ay]) + alpha * perp(arm) - omega**2 * arm)

    # Constraints beyond pins and slides: differences of the sixth order.

    def gap_slope(self, gap: Gap, q: Array) -> Array:
        """The slope of a gap to the coordinates."""
        found = np.zeros(self.size)
        for i in range(self.size):
            step = np.zeros(self.size)
            step[i] = 1e-3
            found[i] = sum(w * (gap(self, q + k * step) - gap(self, q - k * step)) for k, w in FIRST) / 1e-3
        return found

    def gap_turn(self, gap: Gap, q: Array, v: Array) -> float:
        """The second derivative of a gap along rates."""
        h = 1e-3 / max(float(np.abs(v).max()), 1e-3)
        both = sum(w * (gap(self, q + k * h * v) + gap(self, q - k * h * v)) for k, w in SECOND)
        return float(both - 49 / 18 * gap(self, q)) / h**2

    # Constraints: values, Jacobian, and the right-hand sides of velocity and acceleration.

    def _whole_turns(self, q: Array, name: str) -> float:
        """The offset in whole turns by which an angle equation holds at the start."""
        slide = self.plain.slides.get(name)
        if slide is None:
            drive = self.plain.drives[name]
            if drive.kind == "slides":
                return 0.0
            angle = self.pose(q, drive.link)[2] - self.pose(q, drive.on)[2] - drive.law(0.0)
        else:
            a, b = slide.links
            angle = self.pose(q, b)[2] + slide.angles[1] - self.pose(q, a)[2] - slide.angles[0]
        return 2 * math.pi * round(angle / (2 * math.pi))

    def slide_of(self, drive: PlainDrive) -> PlainSlide:
        if drive.track is not None:
            point, base, angle = drive.track
            return PlainSlide((drive.on, drive.link), (base, point), (angle, 0.0))
        return next(s for s in self.plain.slides.values() if set(s.links) == {drive.link, drive.on})

    def constraints(self, q: Array, v: Array, t: float) -> tuple[Array, Array, Array, Array]:
        """Values, Jacobian, velocity side and acceleration side (gamma) of all constraints."""
        rows: list[tuple[float, Array, float, float]] = []

        def spread(*parts: tuple[str, Any]) -> Array:
            row = np.zeros(self.size)
            for link, entries in parts:
                if link != FRAME:
                    row[self.index[link] : self.index[link] + 3] += entries
            return row

        def omega(link: str) -> float:
            return float(self.pose(v, link)[2])

        def apart(a: str, pa: str, b: str, pb: str) -> tuple[Array, Array, Array]:
            """From a's point to b's: arms, and the part of the second derivative that is quadratic in rates."""
            sa, sb = (
                self.arm(q, a, self.plain.links[a].points[pa]),
                self.arm(q, b, self.plain.links[b].points[pb]),
            )
            return sa, sb, -sb * omega(b) ** 2 + sa * omega(a) ** 2

        for members in self.plain.pins.values():
            a, pa = members[0]
            for b, pb in members[1:]:
                sa, sb, quadratic = apart(a, pa, b, pb)
                d = self.pose(q, b)[:2] + sb - self.pose(q, a)[:2] - sa
                for k in (0, 1):
                    unit = np.eye(2)[k]
                    row = spread((b, [*unit, perp(sb)[k]]), (a, [*-unit, -perp(sa)[k]]))
                    rows.append((d[k], row, 0.0, -quadratic[k]))

        def along(a: str, pa: str, angle: float, b: str, pb: str, turn: float) -> tuple[float, Array, float]:
            """The gap's component along a direction fixed in a (``turn`` beyond ``angle``), its gradient and -gamma."""
            sa, sb, quadratic = apart(a, pa, b, pb)
            d = self.pose(q, b)[:2] + sb - self.pose(q, a)[:2] - sa
            d_rate = self.pose(v, b)[:2] + omega(b) * perp(sb) - self.pose(v, a)[:2] - omega(a) * perp(sa)
            heading = self.pose(q, a)[2] + angle + turn
            e = np.array([math.cos(heading), math.sin(heading)])
            row = spread((b, [*e, e @ perp(sb)]), (a, [*-e, -e @ perp(sa) + perp(e) @ d]))
            second = -(omega(a) ** 2) * (e @ d) + 2 * omega(a) * (perp(e) @ d_rate) + e @ quadratic
            return float(e @ d), row, float(second)

        for name, s in self.plain.slides.items():
            (a, b), (pa, pb), (angle_a, angle_b) = s.links, s.points, s.angles
            value, row, second = along(a, pa, angle_a, b, pb, math.pi / 2)
            rows.append((value, row, 0.0, -second))
            turn = self.pose(q, b)[2] + angle_b - self.pose(q, a)[2] - angle_a - self.turns.get(name, 0.0)
            rows.append((turn, spread((b, [0, 0, 1]), (a, [0, 0, -1])), 0.0, 0.0))
        for name, drive in self.plain.drives.items():
            law = drive.law
            if drive.kind == "turns":
                turn = self.pose(q, drive.link)[2] - self.pose(q, drive.on)[2] - law(t) - self.turns.get(name, 0.0)
                row = spread((drive.link, [0, 0, 1]), (drive.on, [0, 0, -1]))
                rows.append((turn, row, law(t, 1), law(t, 2)))
            else:
                s = self.slide_of(drive)
                place = {link: (p, angle) for link, p, angle in zip(s.links, s.points, s.angles, strict=True)}
                base, base_angle = place[drive.on]
                value, row, second = along(drive.on, base, base_angle, drive.link, place[drive.link][0], 0.0)
                rows.append((value - law(t), row, law(t, 1), law(t, 2) - second))
        others = self.gaps.values()
        rows += [(gap(self, q), self.gap_slope(gap, q), 0.0, -self.gap_turn(gap, q, v)) for gap in others]
        values, jacobian, speeds, gammas = zip(*rows, strict=True)
        return np.array(values), np.array(jacobian), np.array(speeds), np.array(gammas)

    # Motion.

    def settle(self, q: Array, t: float) -> State:
        """Newton's method on all constraints from a pose nearby, then the rates."""
        v = np.zeros(self.size)
        q = q.copy()
        for _ in range(30):
            values, jacobian, _, _ = self.constraints(q, v, t)
            step = np.linalg.solve(jacobian, values)
            q -= step
            if np.abs(step).max() < 1e-14 * max(1.0, np.abs(q).max()):
                break
        _, jacobian, speeds, _ = self.constraints(q, v, t)
        v = np.linalg.solve(jacobian, speeds)
        _, jacobian, _, gammas = self.constraints(q, v, t)
        return State(t, q, v, np.linalg.solve(jacobian, gammas))

    def follow(self, times: Any, largest: float = 0.1) -> list[State]:
        """The states at increasing times from 0, in steps in which no coordinate moves more than ``largest``.

        Raises LinAlgError where a singular pose stops it.
        """
        here, found, steps = self.first, [], 0
        for t in times:
            while here.t < t:
                rate = max(float(np.abs(here.v).max()), math.sqrt(largest * float(np.abs(here.a).max())), 1e-300)
                step, steps = min(t - here.t, largest / rate), steps + 1
                if not rate < 1e4 or steps > 5000:
                    raise np.linalg.LinAlgError("singular pose")
                target = t if step == t - here.t else here.t + step
                foretold = here.q + step * here.v + 0.5 * step**2 * here.a
                here = self.settle(foretold, target)
                if not np.abs(here.q - foretold).max() < largest:  # no pose is near: Newton has gone to another
                    raise np.linalg.LinAlgError("singular pose")
            found.append(here)
        return found

    def regularity(self, state: State) -> float:
        """The smallest singular value of the constraint Jacobian, its rows made unit vectors: 0 in a singular pose."""
        jacobian = self.constraints(state.q, state.v, state.t)[1]
        unit = jacobian / np.linalg.norm(jacobian, axis=1, keepdims=True)
        return float(np.linalg.svd(unit, compute_uv=False)[-1])

    # Forces.

    def forces(self, state: State) -> Reactions:
        """All reactions and efforts from three equations of motion a moving link, solved at once."""
        plain, q = self.plain, state.q
        matrix, right = np.zeros((self.size, self.size)), np.zeros(self.size)
        columns = 0

        def push(link: str, column: int, force: Array, at: Array, moment: float = 0.0) -> None:
            """A unit unknown acts on a link by a force at a place and a moment: about the link's origin."""
            if link != FRAME:
                i = self.index[link]
                matrix[i : i + 2, column] += force
                matrix[i + 2, column] += cross(at - q[i : i + 2], force) + moment

        pins: dict[tuple[str, str], tuple[int, ...]] = {}
        for name, members in plain.pins.items():
            first, point = members[0]
            at = self.point(q, first, point)
            for link, _ in members[1:]:
                for k in (0, 1):
                    push(link, columns + k, np.eye(2)[k], at)
                    push(first, columns + k, -np.eye(2)[k], at)
                pins[name, link] = (columns, columns + 1)
                columns += 2
        lines: dict[str, tuple[int, Array]] = {}
        for name, s in plain.slides.items():
            (a, b), pb = s.links, s.points[1]
            heading = self.pose(q, a)[2] + s.angles[0]
            normal = np.array([-math.sin(heading), math.cos(heading)])
            at = self.point(q, b, pb)
            for link, sign in ((b, 1.0), (a, -1.0)):
                push(link, columns, sign * normal, at)
                push(link, columns + 1, np.zeros(2), at, sign)
            lines[name] = (columns, normal)
            columns += 2
        drives: dict[str, int] = {}
        for name, drive in plain.drives.items():
            if drive.kind == "turns":
                for link, sign in ((drive.link, 1.0), (drive.on, -1.0)):
                    push(link, columns, np.zeros(2), np.zeros(2), sign)
            else:
                s = self.slide_of(drive)
                k = s.links.index(drive.on)
                heading = self.pose(q, drive.on)[2] + s.angles[k]
                e = np.array([math.cos(heading), math.sin(heading)])
                at = (
                    self.point(q, drive.on, s.points[k])
                    if drive.track is None
                    else self.point(q, drive.link, s.points[1])
                )
                for link, sign in ((drive.link, 1.0), (drive.on, -1.0)):
                    push(link, columns, sign * e, at)
            drives[name] = columns
            columns += 1
        multipliers: dict[str, tuple[int, Array]] = {}
        for name, other in self.gaps.items():
            slope = self.gap_slope(other, q)
            matrix[:, columns] += slope
            multipliers[name] = (columns, slope)
            columns += 1
        assert columns == self.size

        shaking = np.zeros(3)
        for link, force, at, moment in self.applied(state):
            if link != FRAME:
                i = self.index[link]
                right[i : i + 2] -= force
                right[i + 2] -= cross(at - q[i : i + 2], force) + moment
            shaking += [*force, cross(at, force) + moment]
        scale = np.abs(matrix).max(axis=0)
        unknowns = np.linalg.solve(matrix / scale, right) / scale

        reactions: dict[tuple[str, str], Array] = {}
        for name, members in plain.pins.items():
            total = np.zeros(3)
            for link, _ in members[1:]:
                force = np.array([*unknowns[list(pins[name, link])], 0.0])
                reactions[name, link] = force
                total -= force
            reactions[name, members[0][0]] = total
        for name, (column, normal) in lines.items():
            on_second = np.array([*(unknowns[column] * normal), unknowns[column + 1]])
            a, b = plain.slides[name].links
            reactions[name, b], reactions[name, a] = on_second, -on_second
        for name, (column, slope) in multipliers.items():
            for link in plain.moving:  # about the link's origin
                reactions[name, link] = unknowns[column] * self.pose(slope, link)
        return Reactions(reactions, {name: float(unknowns[c]) for name, c in drives.items()}, shaking)

    def applied(self, state: State) -> list[tuple[str, Array, Array, float]]:
        """Gravity, inertia and loads: (link, force, where, moment)."""
        plain, q = self.plain, state.q
        found: list[tuple[str, Array, Array, float]] = []
        g = np.array(plain.gravity or (0.0, 0.0))
        for link in plain.moving:
            mass, centre, inertia = plain.mass(link)
            force = mass * (g - self.acceleration(state, link, centre))
            found.append((link, force, self.at(q, link, centre), -inertia * self.pose(state.a, link)[2]))
        for load in plain.loads.values():
            local = plain.links[load.on].points[load.at] if isinstance(load.at, str) else load.at or (0.0, 0.0)
            if load.along is not None:
                s = plain.slides[load.along]
                heading = self.pose(q, s.links[0])[2] + s.angles[0]
                force = float(load.force) * np.array([math.cos(heading), math.sin(heading)])  # type: ignore[arg-type]
            elif load.force is None:
                force = np.zeros(2)
            else:
                force = self.arm(q, load.turns_with or FRAME, load.force)
            place, torque = self.at(q, load.on, local), load.torque or 0.0
            found.append((load.on, force, place, torque))
            if load.against is not None:
                found.append((load.against, -force, place, -torque))
        return [*found, *(applied for more in self.extra for applied in more(self, state))]
