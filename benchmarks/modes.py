"""Does a group solved by Newton keep to its assembly mode: ``python benchmarks/modes.py [--count N] [--seed S]``.

Random mechanisms whose two modes come near to each other, by a share of a length from 1e-1 to 1e-6: pins on arcs,
levers with slots beside their pins, plates on three legs. The truth is a path tracker of its own, in 40 digits, on
other equations (squares of distances): Newton from the tangent, in steps that are halved until the slopes change by
less than a tenth. Each mechanism runs for a turn; pins and levers run as a sample of a nominal one, too, whose modes
are far apart.

Right is a run that agrees at all of 65 poses, stopped one that has no pose from a place on, wrong any other.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from figures import parser, tell
from mpmath import mp

from linkwright.compilation import compile_mechanism
from linkwright.findings import ModelError
from linkwright.kernels.parameter_batch import Varied
from linkwright.model.document import parse_document

mp.dps = 40
SI = {"length": "m", "angle": "rad", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"}
POSES = 65
FAR = 0.05
CLOSE = 1e-5
"""Poses that differ by less (m, or rad) are the same."""
CLOSED = 1e-9
"""What squares of legs (m2) may miss where a pose is closed."""


@dataclass
class Case:
    """A mechanism over a turn of its crank (1 rad/s, from ``start``): its file, the signals to compare, its closure in
    40 digits with coordinates ``u`` at the start, how these make the signals; and the value of the ``length`` by which
    it is nearly singular, beside that of a nominal mechanism."""

    family: str
    gap: float
    model: Callable[[float], dict[str, Any]]
    signals: list[str]
    start: float
    u: list[float]
    closure: Callable[[Sequence[Any], Any], tuple[Any, Any, Any]]
    shown: Callable[[Sequence[Any], Any], list[Any]]
    length: float
    nominal: float | None


# The truth: coordinates of a closure by a tracker in 40 digits.


def track(case: Case) -> np.ndarray:
    """The signals at all poses: (signals, poses)."""
    angle = mp.mpf(case.start)
    u = newton(case, mp.matrix(case.u), angle)
    assert u is not None
    told = [case.shown(u, angle)]
    step = 2 * mp.pi / (POSES - 1)
    for k in range(1, POSES):
        goal = mp.mpf(case.start) + k * 2 * mp.pi / (POSES - 1)
        while angle < goal:
            there = min(angle + step, goal)
            end = one_step(case, u, angle, there)
            if end is None:
                step = (there - angle) / 2
                if step < 1e-14:
                    return np.array([*told, *[[math.nan] * len(told[0])] * (POSES - k)]).T
                continue
            u, angle, step = end, there, (there - angle) * 1.5
        told.append(case.shown(u, angle))
    return np.array([[float(value) for value in row] for row in told]).T


def one_step(case: Case, u: Any, angle: Any, there: Any) -> Any:
    """The coordinates after a step, ``None`` where it isn't sure."""
    _, slopes, moved = case.closure(u, angle)
    guess = u - mp.lu_solve(slopes, moved) * (there - angle)
    end = newton(case, guess, there)
    if end is None:
        return None
    begin, last = case.closure(guess, there)[1], case.closure(end, there)[1]
    if mp.det(slopes) * mp.det(last) <= 0 or mp.det(begin) == 0:
        return None
    bend = mp.lu_solve(begin, last - begin) if len(u) == 1 else mp.inverse(begin) * (last - begin)
    return end if mp.mnorm(bend, mp.inf) < 0.1 else None


def newton(case: Case, u: Any, angle: Any) -> Any:
    """The root at a start, ``None`` if there is none near by."""
    for _ in range(12):
        gaps, slopes, _ = case.closure(u, angle)
        if mp.det(slopes) == 0:
            return None
        step = mp.lu_solve(slopes, gaps)
        u = u - step
        if mp.mnorm(step, mp.inf) < mp.mpf(10) ** -30:
            return u
    return None


# The families.


def on_arcs(rng: np.random.Generator, gap: float) -> Case:
    """A coupler whose end runs on an arc about D."""
    while True:
        crank, ground, radius = rng.uniform([0.05, 0.2, 0.1], [0.15, 0.4, 0.5])
        least, most = ground - crank, ground + crank
        length = max(most - radius, radius - least)
        if length > 0.03 and length * (1 + FAR) < radius + least - 0.02:
            break
    coupler = length * (1 + gap)
    start, side = rng.uniform(-3, 3), rng.choice([-1.0, 1.0])

    def end(size: float) -> np.ndarray:
        b = crank * np.array([math.cos(start), math.sin(start)])
        line = b - [ground, 0]
        far = math.hypot(*line)
        along = (far**2 + radius**2 - size**2) / (2 * far)
        unit = line / far
        across = side * math.sqrt(radius**2 - along**2)
        return np.array([ground, 0]) + along * unit + across * np.array([unit[1], -unit[0]])

    def model(size: float) -> dict[str, Any]:
        return {
            "units": SI,
            "parameters": {"length": f"{float(size)!r} m"},
            "links": {
                "frame": {"points": {"A": [0, 0], "D": [ground, 0]}},
                "crank": {"points": {"A": [0, 0], "B": [crank, 0]}},
                "coupler": {"points": {"B": [0, 0], "C": ["length", 0]}},
            },
            "joints": {
                "slot": {"pin_in_slot": ["coupler", "frame"], "pin": "C", "arc": {"centre": "D", "radius": radius}}
            },
            "assembly": {"C": end(size).tolist()},
            "drives": {"motor": {"turns": "crank", "on": "frame", "speed": 1.0, "start": start}},
        }

    def place(u: Any, angle: Any) -> tuple[Any, Any]:
        return crank * mp.cos(angle) + coupler * mp.cos(u[0]), crank * mp.sin(angle) + coupler * mp.sin(u[0])

    def closure(u: Any, angle: Any) -> tuple[Any, Any, Any]:
        x, y = place(u, angle)
        x -= ground
        slope = 2 * coupler * (-x * mp.sin(u[0]) + y * mp.cos(u[0]))
        moved = 2 * crank * (-x * mp.sin(angle) + y * mp.cos(angle))
        return mp.matrix([x**2 + y**2 - mp.mpf(radius) ** 2]), mp.matrix([[slope]]), mp.matrix([moved])

    away = end(coupler) - crank * np.array([math.cos(start), math.sin(start)])
    u = [math.atan2(away[1], away[0])]
    shown = lambda u, angle: [*place(u, angle)]  # noqa: E731
    return Case("pin on an arc", gap, model, ["C.x", "C.y"], start, u, closure, shown, coupler, length * (1 + FAR))


def in_slots(rng: np.random.Generator, gap: float) -> Case:
    """A lever whose slot passes beside its own pin, and holds a crank pin."""
    while True:
        crank, ground = rng.uniform([0.05, 0.05], [0.3, 0.3])
        if abs(crank - ground) > 0.03:
            break
    most = abs(crank - ground) * rng.choice([-1.0, 1.0])
    beside = most * (1 - gap)
    start, side = rng.uniform(-3, 3), rng.choice([-1.0, 1.0])

    def turned(offset: float) -> float:
        x, y = crank * math.cos(start) - ground, crank * math.sin(start)
        along = side * math.sqrt(x**2 + y**2 - offset**2)
        return math.atan2(y, x) - math.atan2(offset, along)

    def model(offset: float) -> dict[str, Any]:
        lever = turned(offset)
        return {
            "units": SI,
            "parameters": {"length": f"{float(offset)!r} m"},
            "links": {
                "frame": {"points": {"O": [0, 0], "C": [ground, 0]}},
                "crank": {"points": {"O": [0, 0], "B": [crank, 0]}},
                "lever": {"points": {"C": [0, 0], "S": [0, "length"], "P": [0.1, 0]}},
            },
            "joints": {"slot": {"pin_in_slot": ["crank", "lever"], "pin": "B", "straight": "S at 0 rad"}},
            "assembly": {"P": [ground + 0.1 * math.cos(lever), 0.1 * math.sin(lever)]},
            "drives": {"motor": {"turns": "crank", "on": "frame", "speed": 1.0, "start": start}},
        }

    def closure(u: Any, angle: Any) -> tuple[Any, Any, Any]:
        x, y = crank * mp.cos(angle) - ground, crank * mp.sin(angle)
        cos, sin = mp.cos(u[0]), mp.sin(u[0])
        moved = crank * (mp.sin(angle) * sin + mp.cos(angle) * cos)
        return mp.matrix([-x * sin + y * cos - beside]), mp.matrix([[-x * cos - y * sin]]), mp.matrix([moved])

    shown = lambda u, angle: [ground + mp.mpf(0.1) * mp.cos(u[0]), mp.mpf(0.1) * mp.sin(u[0])]  # noqa: E731
    nominal = most * (1 - FAR)
    return Case(
        "lever with a slot", gap, model, ["P.x", "P.y"], start, [turned(beside)], closure, shown, beside, nominal
    )


def on_three_legs(rng: np.random.Generator, gap: float) -> Case | None:
    """A plate on three legs, one on a crank; the third leg is nearly as long as a turn allows."""
    spread = lambda *at: np.array(at) + rng.uniform(-0.4, 0.4, 2)  # noqa: E731
    crank, start = rng.uniform(0.15, 0.4), rng.uniform(-3, 3)
    pivots = [np.zeros(2), spread(4, 0.5), spread(3, 4)]
    corners = [spread(0.6, 1.4), spread(2.6, 0.8), spread(2.4, 2.3)]
    first = crank * np.array([math.cos(start), math.sin(start)])
    legs = [math.dist(corners[0], first), math.dist(corners[1], pivots[1]), math.dist(corners[2], pivots[2])]
    axis = (corners[1] - corners[0]) / math.dist(corners[0], corners[1])
    local = [
        np.array([axis @ (c - corners[0]), axis[0] * (c - corners[0])[1] - axis[1] * (c - corners[0])[0]])
        for c in corners
    ]
    turned = math.atan2(axis[1], axis[0])

    def pose(third: float) -> np.ndarray:
        """The plate at the start: from the drawn leg to the third one in small steps."""
        u = np.array([*corners[0], turned])
        for size in np.linspace(legs[2], third, 200):
            for _ in range(6):
                gaps, slopes = np.zeros(3), np.zeros((3, 3))
                for i, (foot, leg) in enumerate(zip([first, *pivots[1:]], [*legs[:2], size], strict=True)):
                    arm = turn(u[2]) @ local[i]
                    away = u[:2] + arm - foot
                    gaps[i] = away @ away - leg**2
                    slopes[i] = [*(2 * away), 2 * (away[1] * arm[0] - away[0] * arm[1])]
                u = u - np.linalg.solve(slopes, gaps)
        return u

    def model(third: float) -> dict[str, Any]:
        sizes, plate = [*legs[:2], third], pose(third)
        drawn = [plate[:2] + turn(plate[2]) @ local[i] for i in range(3)]
        return {
            "units": SI,
            "links": {
                "frame": {"points": {"O": [0, 0], "A2": pivots[1].tolist(), "A3": pivots[2].tolist()}},
                "crank": {"points": {"O": [0, 0], "A1": [crank, 0]}},
                **{f"leg{i + 1}": {"points": {f"A{i + 1}": [0, 0], f"B{i + 1}": [sizes[i], 0]}} for i in range(3)},
                "plate": {"points": {f"B{i + 1}": local[i].tolist() for i in range(3)}},
            },
            "assembly": {f"B{i + 1}": drawn[i].tolist() for i in range(3)},
            "drives": {"motor": {"turns": "crank", "on": "frame", "speed": 1.0, "start": start}},
        }

    def turns(third: float) -> bool:
        found = run(model(third), ["B1.x"])
        return found is not None and bool(np.isfinite(found).all())

    # The longest third leg with which the crank turns fully, by bisection.
    low, high = legs[2], legs[2] * 1.02
    if not turns(low):
        return None
    while turns(high):
        low, high = high, high * 1.02
        if high > 3 * legs[2]:
            return None
    while high - low > 1e-3 * gap * low:
        middle = (low + high) / 2
        low, high = (middle, high) if turns(middle) else (low, middle)
    third = low * (1 - gap)
    sizes = [*legs[:2], third]

    def at(u: Any, i: int) -> tuple[Any, Any, Any, Any]:
        cos, sin = mp.cos(u[2]), mp.sin(u[2])
        x, y = local[i].tolist()
        arm = cos * x - sin * y, sin * x + cos * y
        return u[0] + arm[0], u[1] + arm[1], *arm

    def closure(u: Any, angle: Any) -> tuple[Any, Any, Any]:
        gaps, slopes, moved = mp.matrix(3, 1), mp.matrix(3, 3), mp.matrix(3, 1)
        for i in range(3):
            x, y, ax, ay = at(u, i)
            foot = (crank * mp.cos(angle), crank * mp.sin(angle)) if i == 0 else pivots[i].tolist()
            x, y = x - foot[0], y - foot[1]
            gaps[i] = x**2 + y**2 - mp.mpf(sizes[i]) ** 2
            slopes[i, 0], slopes[i, 1], slopes[i, 2] = 2 * x, 2 * y, 2 * (-x * ay + y * ax)
            if i == 0:
                moved[i] = 2 * crank * (x * mp.sin(angle) - y * mp.cos(angle))
        return gaps, slopes, moved

    begun = pose(third)
    # Near a singular pose the way from the drawn leg may have ended beside every pose: then there is no case.
    if max(abs(gap) for gap in closure(mp.matrix(begun.tolist()), mp.mpf(start))[0]) > CLOSED:
        return None
    shown = lambda u, angle: [value for i in range(3) for value in at(u, i)[:2]]  # noqa: E731
    signals = [f"B{i + 1}.{axis}" for i in range(3) for axis in "xy"]
    return Case("plate on three legs", gap, model, signals, start, begun.tolist(), closure, shown, third, None)


def turn(angle: float) -> np.ndarray:
    """The matrix that turns by an angle (rad)."""
    return np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])


FAMILIES = *[on_arcs, in_slots] * 4, on_three_legs
"""In turn; plates take longest."""


# What is tried, and how it is judged.


def run(model: dict[str, Any], signals: list[str]) -> np.ndarray | None:
    """The signals of a model over a turn: (signals, poses); ``None`` where it is refused."""
    try:
        document = parse_document(model)
        assert document is not None
        return compile_mechanism(document).evaluate(signals, times())
    except ModelError:
        return None


def sample(case: Case) -> np.ndarray | None:
    """The same of a sample of the nominal mechanism."""
    assert case.nominal is not None
    document = parse_document(case.model(case.nominal))
    assert document is not None
    varied = Varied(compile_mechanism(document), ["length"])
    found = varied.evaluate(case.signals, varied.parameters(np.array([[case.length]])), times())
    return np.asarray(found[:, 0])


def times() -> np.ndarray:
    return np.linspace(0.0, 2 * math.pi, POSES)


def judged(found: np.ndarray | None, truth: np.ndarray) -> str:
    """Right, stopped or wrong."""
    if found is None:
        return "stopped"
    known = np.isfinite(found).all(axis=0)
    with np.errstate(invalid="ignore"):
        off = np.abs(found - truth)[:, known]
    if not (off < CLOSE).all():
        return "wrong"
    return "right" if known.all() or np.isnan(truth[0, ~known]).all() else "stopped"


def cases(count: int, seed: int) -> Iterator[Case]:
    """So many random cases, of all families in turn."""
    made, tried = 0, 0
    while made < count:
        rng = np.random.default_rng([seed, tried])
        tried += 1
        gap = 10.0 ** rng.uniform(-6, -1)
        if (case := FAMILIES[made % len(FAMILIES)](rng, gap)) is not None:
            made += 1
            yield case


def measure(count: int, seed: int, verbose: bool = False) -> dict[str, float | str]:
    """The number of cases by family and judgement."""
    counts: Counter[str] = Counter()
    for case in cases(count, seed):
        truth = track(case)
        verdicts = {case.family: judged(run(case.model(case.length), case.signals), truth)}
        if case.nominal is not None:
            verdicts[f"{case.family}, as a sample"] = judged(sample(case), truth)
        for family, verdict in verdicts.items():
            counts[f"{family}: {verdict}"] += 1
            if verbose and verdict != "right":
                print(f"{family}: {verdict} at a gap of {case.gap:.3g}", flush=True)
    return {name: float(number) for name, number in sorted(counts.items())}


def main() -> None:
    options = parser(__doc__)
    options.add_argument("--count", type=int, default=100)
    options.add_argument("--seed", type=int, default=1)
    given = options.parse_args()
    tell(measure(given.count, given.seed, not given.json), given.json)


if __name__ == "__main__":
    main()
