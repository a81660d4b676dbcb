"""The certificate: each claim of a run proven from what the run reports."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.elements.joint import Rate
from linkwright.elements.mover import exerted
from linkwright.findings import Joined, Term
from linkwright.kernels.kernel_selection import KernelChoice, choose
from linkwright.model.signals import BREAKAWAY
from linkwright.results.breakaway import creeping, efforts, starting
from linkwright.results.claims import Claim, claims
from linkwright.results.independent_check import Reports
from linkwright.results.margins import Nearest, nearest
from linkwright.results.quadrature import panel_points
from linkwright.results.run import Run
from linkwright.results.signal_check import SignalCheck
from linkwright.structure import FRAME

Array = NDArray[np.float64]

RESIDUALS = ("closure", "equilibrium", "power", "work", "starting", "signals")
PROVEN = 1e-9
"""A residual below this holds: far under any drawing tolerance, far over round-off."""


@dataclass(frozen=True)
class Certificate:
    """The proofs of a run; residuals are relative, and NaN where something reported is.

    closure: worst distance (or sine) by which a joint's two links miss each other, over the mechanism's size.
    equilibrium: worst force or moment left on any link, the frame too, over the largest force (or its moment).
    power: worst sum of drive, load, gravity and inertia power, over the sum of their sizes.
    work: work of drives and loads less the change of energy over the run, over the work's and energies' sizes.
    The last three are ``None`` where no link has mass and nothing loads it: there is nothing to balance.
    starting: worst force or moment left where the drives start the motion from rest by the reported efforts, and misfit
    of these, over the largest force; ``None`` without static coefficients.
    signals: the worst that a reported signal misses its formula from raw geometry by, or a rate the change of what it
    is the rate of, over the scale of its dimension.
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
    branches: dict[str, str | Term]  # the assembly rule that each group keeps; empty where it has one mode only
    changes: dict[str, tuple[float, ...]]  # of groups carried through change points: when their branch changes (s)
    followed: dict[str, tuple[int, float]]  # of groups solved by Newton: steps of the path, largest correction
    poses: int
    choice: KernelChoice  # of the kernel, and why
    redundant: int = 0  # equations that follow from others, beyond which the count's mobility is that of the rank
    starting: float | None = None
    signals: float | None = None
    signal: str = ""  # the one that misses its formula most
    measures: float | None = None  # the worst contradiction to a reported measure; None without measures

    @property
    def kernel(self) -> str:
        """The kernel's name."""
        return self.choice.kernel

    @property
    def residuals(self) -> dict[str, float]:
        """The relative residuals by name, those that say something."""
        every = {name: getattr(self, name) for name in (*RESIDUALS, "measures")}
        return {name: value for name, value in every.items() if value is not None}

    @property
    def unknown(self) -> tuple[str, ...]:
        """The residuals that aren't numbers, because something reported isn't one: these checks fail."""
        return tuple(name for name, value in self.residuals.items() if not np.isfinite(value))

    def claims(self, tolerance: float = PROVEN) -> list[Claim]:
        """All checks, and whether each holds; residuals are to be below ``tolerance``."""
        return claims(self, tolerance)

    def sound(self, tolerance: float = PROVEN) -> bool:
        """Whether every check holds, of residuals that they are below ``tolerance``."""
        return not self.unproven(tolerance)

    def unproven(self, tolerance: float = PROVEN) -> dict[str, Claim]:
        """The checks that don't hold, by name."""
        return {claim.name: claim for claim in self.claims(tolerance) if not claim.holds}


def certify(run: Run) -> Certificate:
    """Prove a run at its sampled times."""
    compiled, topology = run.compiled, run.compiled.structure.topology
    reports = Reports(compiled, run.t[compiled.passages.bounded(run.t)])
    apart = scattered(run)
    constraints = rank(Reports(compiled, apart[compiled.passages.bounded(apart)]))
    loaded = bool(reports.masses or any(one.kind.acts for one in reports.every))
    rules = compiled.assembly.rules
    missed, signal = SignalCheck(run, reports).worst()
    changes = {group.label: _changes(run, group.label) for group in compiled.structure.groups}
    return Certificate(
        closure=closure(reports),
        equilibrium=equilibrium(reports) if loaded else None,
        power=power(reports) if loaded else None,
        work=work(run, slight(reports)) if loaded else None,
        mobility=3 * len(topology.moving) - constraints,
        gruebler=topology.gruebler,
        rank=constraints,
        loops=topology.loops,
        redundant=compiled.structure.redundant,
        nearest=nearest(run),
        branches={
            **{g.label: _branch(rules.get(g, ""), changes[g.label]) for g in compiled.structure.groups},
            **{higher_group.label: "" for higher_group in compiled.structure.higher_groups},
        },
        changes={group: times for group, times in changes.items() if times},
        followed={f.higher_group.label: (len(f.path.t) - 1, f.correction) for f in compiled.followers},
        poses=reports.count,
        starting=starts(reports),
        signals=missed,
        signal=signal,
        choice=choose(compiled.graph.program(reports.names), reports.count),
    )


def _changes(run: Run, group: str) -> tuple[float, ...]:
    passages = [p for p in run.compiled.passages.of_group(group) if not p.at_start]
    return tuple(p.time for p in passages if run.start <= p.time <= run.stop)


def _branch(rule: str, times: tuple[float, ...]) -> str | Term:
    """The rule that a group keeps, and when its branch changes."""
    listed = Joined(f"{time:.6g}" for time in times)
    return Term("branch-changes", rule=rule, times=listed) if times else rule


def closure(r: Reports) -> float:
    """The worst miss of a joint, a slide's direction or a unit vector, over the mechanism's size or 1."""
    misses, size = [0.0], r.size()
    for name, (kind, links) in (r.topology.joints | r.topology.equations).items():
        misses += [_worst(miss.value) / (size if miss.length else 1.0) for miss in kind.misses(r, name, links)]
    for name, follower in r.mechanism.followers.items():
        misses += [_worst(miss.value) / (size if miss.length else 1.0) for miss in follower.misses(r, name)]
    misses += [_worst(np.hypot(*r.rotated(link, (1.0, 0.0))) - 1.0) for link in r.topology.moving]
    return float(np.max(misses))


def equilibrium(r: Reports) -> float:
    """The worst force or moment left on a link under its reactions, efforts, loads, gravity and inertia.

    The frame is held by the reported shaking force and moment. Links in a loop of slides, between which any moments
    may pass, balance in moments together.
    """
    forces = {link: np.zeros((2, r.count)) for link in r.mechanism.links}
    part_of = loops_of_slides(r)
    moments = {link: np.zeros(r.count) for link in r.mechanism.links}
    origin, shaking = np.zeros((2, r.count)), r.vector("shaking.")
    held = (FRAME, -shaking, origin, -r.rows["shaking.moment"])
    # In the bands of change points forces are interpolated: where all of them are zero, their round-off is that of the
    # inertia forces that cancel, and doesn't balance.
    largest = r.centrifugal() if r.compiled.passages.every else 0.0
    largest = max(largest, 1e-300)
    applied = [*r.acting(), *r.inertia_and_gravity()]
    for link, force, place, moment in (*r.reactions(), *r.efforts(), *applied, held):
        forces[link] += force
        moments[part_of[link]] += _cross(place, force) + moment
        largest = max(largest, _worst(np.hypot(*force)), _worst(moment) / r.size())
    rests = [max(_worst(forces[link]), _worst(moments[link]) / r.size()) for link in r.mechanism.links]
    rests += [_worst(misfit.value) / (1.0 if misfit.force else r.size()) for misfit in r.misfits()]
    return float(np.max(rests)) / largest


def starts(r: Reports) -> float | None:
    """The worst of both senses of all drives: the equilibrium of the creeping mechanism, whose joints rub with the
    static coefficients, by its own reports; and by what its efforts miss those that are reported."""
    rests: list[float] = []
    for drive in starting(r.compiled):
        effort = r.mechanism.drives[drive].effort
        for sense, reported in zip(BREAKAWAY.values(), efforts(r.compiled, drive, r.t), strict=False):
            if not np.isfinite(reported).any():
                continue
            crept = Reports(creeping(r.compiled, drive, sense), r.t[np.isfinite(reported)])
            needed, told = crept.rows[f"{drive}.{effort}"], reported[np.isfinite(reported)]
            rests += [equilibrium(crept), _worst(needed - told) / max(_worst(needed), 1e-300)]
    return max(rests, default=None)


def loops_of_slides(r: Reports) -> dict[str, str]:
    """By link the one that stands for its loop of slides: the link itself where it is in none."""
    part_of = {link: link for link in r.mechanism.links}
    for name in r.looped:
        a, b = (part_of[link] for link in r.mechanism.joints[name].links)
        part_of = {link: a if part == b else part for link, part in part_of.items()}
    return part_of


def power(r: Reports) -> float:
    """The worst rest of the power balance at a pose, over the largest sum of its terms' sizes."""
    terms = np.array([*r.drive_powers(), *r.powers_of([*r.acting(), *r.inertia_and_gravity()])])
    size = max(_worst(np.abs(terms).sum(axis=0)), slight(r))
    return 0.0 if size == 0 else _worst(terms.sum(axis=0)) / size


def slight(r: Reports) -> float:
    """A millionth of the largest force times the largest speed: powers (W) below it may be all round-off."""
    forces = [_worst(np.hypot(*force)) for _, force, _, _ in (*r.reactions(), *r.acting())]
    links = r.topology.moving
    speeds = [_worst(r.vector(f"{r.some_point(n)}.v")) + _worst(r.rows[f"{n}.omega"]) * r.size() for n in links]
    return 1e-6 * max(forces, default=0.0) * max(speeds, default=0.0)


def work(run: Run, slight: float) -> float:
    """Work of drives and loads against the change of energy, by Gauss quadrature on panels halved until each stands.

    ``slight`` is the power (W) that may be all round-off.
    """
    names = [f"energy.{kind}" for kind in run.compiled.quantities.signals.energies]
    energy = run.compiled.evaluate(names, np.array([run.start, run.stop]))
    change = float(energy.sum(axis=0) @ np.array([-1.0, 1.0]))
    least = slight * (run.stop - run.start)
    edges = np.union1d(np.linspace(run.start, run.stop, min(run.grid, MAX_PANELS) + 1), run.breaks)
    lows, highs = edges[:-1], edges[1:]
    total, here, panels = np.zeros(2), worked(run, lows, highs), lows.size
    while lows.size:
        middle = (lows + highs) / 2
        halves = worked(run, np.append(lows, middle), np.append(middle, highs))
        sums, panels = halves[:, : lows.size] + halves[:, lows.size :], panels + 2 * lows.size
        size = max(float(total[1] + sums[1].sum() + np.abs(energy).sum()), least)
        stands = ~(np.abs(sums[0] - here[0]) > SETTLED * size) | (panels >= MAX_PANELS)
        total += sums[:, stands].sum(axis=1)
        more = np.tile(~stands, 2)
        lows, highs = np.append(lows, middle)[more], np.append(middle, highs)[more]
        here = halves[:, more]
    return 0.0 if size == 0 else abs(float(total[0]) - change) / size


def worked(run: Run, lows: Array, highs: Array) -> Array:
    """Work of drives, loads and dampers on each panel, and the sum of its terms' sizes: (2, panels)."""
    t, weight = panel_points(lows, highs)
    r = Reports(run.compiled, t)
    terms = np.array([*r.drive_powers(), *r.powers_of([*r.dissipative_forces()])])
    rates = np.array([terms.sum(axis=0), np.abs(terms).sum(axis=0)]) * weight
    return np.asarray(rates.reshape(2, lows.size, -1).sum(axis=2))


SETTLED, MAX_PANELS = 1e-14, 1 << 14
GOLDEN = (np.sqrt(5.0) - 1) / 2
SCATTERED = 7
"""The poses at which the rank of the constraints is taken."""


def scattered(run: Run) -> Array:
    """A few times (s) that share no step with the motion: equal steps may all meet the same singular pose."""
    return np.asarray(run.start + (run.stop - run.start) * np.mod(GOLDEN * np.arange(1, SCATTERED + 1), 1.0))


def rank(r: Reports) -> int:
    """The rank of the constraint Jacobian of joints and followers, at that of the poses where it is largest."""
    joints = r.topology.joints.items()
    rows = [row for name, (kind, links) in joints for row in kind.constraints(r, name, links)]
    followed = follower_rows(r)
    every = [np.vstack([jacobian(r, rows, pose), followed[:, :, pose]]) for pose in range(r.count)]
    matrices = [matrix for matrix in every if np.isfinite(matrix).all()]
    return max((int(np.linalg.matrix_rank(matrix, tol=1e-9)) for matrix in matrices), default=0)


def jacobian(r: Reports, constraints: list[list[Rate]], pose: int) -> Array:
    """Constraint velocities over (vx, vy, omega size) of each moving link's origin: (constraints, 3 links)."""
    index = {link: 3 * i for i, link in enumerate(r.topology.moving)}
    size, rows = r.size(), np.zeros((len(constraints) + 1, 3 * len(index)))
    for row, rates in zip(rows, constraints, strict=False):
        for rate in rates:
            if rate.link == FRAME:
                continue
            own = row[index[rate.link] : index[rate.link] + 3]
            if rate.place is None or rate.direction is None:
                own[2] += rate.factor
                continue
            x, y = rate.factor * rate.direction[:, pose]
            arm = (rate.place - r.point_position(rate.link, (0.0, 0.0)))[:, pose] / size
            own += [x, y, y * arm[0] - x * arm[1]]
    return rows


def follower_rows(r: Reports) -> Array:
    """What each follower constrains, over the same velocities: (followers, 3 links, poses).

    Its joint moves with the ratio of the reported rates, as if an effort there and that of the motor did no work.
    """
    index = {link: 3 * i for i, link in enumerate(r.topology.moving)}
    movers, size = r.mechanism.movers, r.size()
    rows = np.zeros((len(r.mechanism.followers), 3 * len(index), r.count))
    for row, (name, follower) in zip(rows, r.mechanism.followers.items(), strict=True):
        motor = movers[follower.motor]
        rate, motor_rate = r.rows[f"{name}.{follower.rate}"], r.rows[f"{follower.motor}.{motor.rate}"]
        ratio = np.divide(rate, motor_rate, out=np.zeros(r.count), where=motor_rate != 0.0)
        applied = exerted(follower, r, name, np.ones(r.count))
        applied += exerted(motor, r, follower.motor, -ratio)
        for link, force, place, moment in applied:
            if link == FRAME:
                continue
            arm = place - r.point_position(link, (0.0, 0.0))
            turning = force[1] * arm[0] - force[0] * arm[1] + moment
            row[index[link] : index[link] + 3] += [*force, turning / size]
    return np.asarray(rows / np.maximum(np.linalg.norm(rows, axis=1, keepdims=True), 1e-300))


def _cross(a: Array, b: Array) -> Array:
    return np.asarray(a[0] * b[1] - a[1] * b[0])


def _worst(values: Array | float) -> float:
    return float(np.max(np.abs(values), initial=0.0))
