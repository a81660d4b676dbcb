"""Carrying a motion through its change points: where they are, which branches change, how near is near.

A change point is a double root of a group's reach, to its round-off, or a pose in which its outer pins meet: a double
root of the square of their distance. There the group's two modes meet, and the smooth motion goes over from one to the
other: the root of the reach changes sign, or the direction from pin to pin does.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions import units as u
from linkwright.expressions.units import Dimension
from linkwright.findings import CLAUSES, Finding, Joined, ModelError, Text, enumerated
from linkwright.graph.rows import Apart, Named, ReachRow, change_rows
from linkwright.kernels import Compiled
from linkwright.kernels.change_points import GAP, Passage, Passages, unwrapped
from linkwright.notation.angles import wrapped
from linkwright.results import Run
from linkwright.studies.assembly_checks import TOUCH, drive_value, row_of, touching

Array = NDArray[np.float64]

WIDEST = 0.25
"""A band's poses lie within this share of the way to the next turning point of the reach, or change point."""
HALVINGS = 10
SAME = 1e-6
"""Change points of several groups nearer than this share of that way are one."""
BEGIN = 1e-9
"""A change point no later than this share of it after the start is at the start."""
MOTION = (1e-11, 1e-10, 1e-9, 1e-7)
"""How far interpolation and closed forms may differ in positions, velocities, accelerations, jerks, over their size
near by, where both are good."""
FORCE = 1e-8


@dataclass(frozen=True)
class _Touch:
    """A group's row touches zero at a time (s); to both sides of it, it grows over the ``room`` (s). Values below
    ``floor`` are zero."""

    row: ReachRow | Apart
    time: float
    at_start: bool
    room: float
    floor: float

    @property
    def group(self) -> str:
        return self.row.group


def carry_through_change_points(run: Run) -> tuple[Run, list[Finding]]:
    """The run carried through all change points that it meets, and those through which it can't be."""
    touches: list[_Touch] = []
    rows = change_rows(run.compiled.structure)
    for group in run.compiled.structure.groups:
        own = [row for row in rows if row.group == group.label]
        if own:
            here, failed = _carry_through_touches(run, touches, own)
            if failed:
                return here, failed
            touches += [touch for row in own for touch in _touches(here, row)]
    # Of reactions that aren't determined too: of their values in some state determined ones are sums.
    signals = [s.text for s in run.compiled.quantities.signals.possible() if s.attribute != "arm"]
    return _carry_through_touches(run, touches, signals)


def warnings(run: Run) -> list[Finding]:
    """What is to be known of the change points: where the start is one, and where forces grow without bound."""
    found = []
    for passage in run.compiled.passages.every:
        if passage.at_start:
            rules = [rule for g, rule in run.compiled.assembly.rules.items() if g.label in passage.groups]
            found.append(
                _finding(run, "motion.starts-at-change-point", passage, "warning", rules=Joined(rules, CLAUSES))
            )
        signals = run.compiled.quantities.signals
        poles = [name for name in passage.poles if not signals.is_undetermined(run.compiled.graph.signal(name))]
        if poles:
            found.append(_finding(run, "motion.unbounded-forces", passage, "warning", signals=_listed(poles)))
    return found


def _listed(names: list[str], most: int = 6) -> Text:
    return Joined([*names[:most], *(["..."] if len(names) > most else [])])


def _finding(run: Run, code: str, passage: Passage, severity: str, **data: object) -> Finding:
    data |= {"group": enumerated(passage.groups), "time": f"{passage.time:.6g}"}
    path = ("links", passage.groups[0].split("-")[0])
    return Finding(code, path, data | drive_value(run, passage.time), severity=severity)


def _touches(run: Run, row: ReachRow | Apart) -> list[_Touch]:
    length, found = run.stop - run.start, []
    floor = TOUCH * (float(row_of(run, row)[1].max()) if isinstance(row, Apart) else 1.0)
    for time, _ in touching(run, row):
        room, last = 1e-5 * length, 0.0
        while room < length and (least := _least(run.compiled, [row], time + np.array([-room, room]))) > last:
            room, last = 1.25 * room, least
        time = _polished(run.compiled, [row], time, room / 64)
        found.append(_Touch(row, time, time <= run.start + BEGIN * room, room, floor))
    return found


def _least(compiled: Compiled, row: list[ReachRow | Apart], t: Array) -> float:
    """The least value of a row; NaN where a law has none."""
    try:
        return float(compiled.evaluate(row, t).min())
    except ModelError:
        return float("nan")


def _polished(compiled: Compiled, row: list[ReachRow | Apart], time: float, near: float) -> float:
    """The time at which a row's rate is zero; at the ends of the run that may be a trifle outside of it."""
    from scipy.optimize import brentq

    def rate(t: float) -> float:
        return float(compiled.evaluate(row, np.array([t]), rates=True)[0, 1, 0])

    try:
        return float(brentq(rate, time - near, time + near, xtol=1e-300, rtol=1e-15))
    except (ValueError, ModelError):
        return time


def _carry_through_touches(run: Run, touches: list[_Touch], names: Sequence[Named]) -> tuple[Run, list[Finding]]:
    """The run through some touches, and the passages in whose bands the rows of some names can't be told."""
    if not touches:
        return run, []
    order = [group.label for group in run.compiled.structure.groups]
    places: list[list[_Touch]] = []
    for touch in sorted(touches, key=lambda touch: touch.time):
        if places and touch.time - places[-1][0].time < SAME * min(touch.room, places[-1][0].room):
            places[-1].append(touch)
        else:
            places.append([touch])
    passages = []
    for i, place in enumerate(places):
        place.sort(key=lambda touch: order.index(touch.group))
        others = [abs(place[0].time - p[0].time) for p in (*places[:i], *places[i + 1 :])]
        groups = tuple(touch.group for touch in place)
        width = WIDEST * min([touch.room for touch in place] + others)
        passages.append(Passage(place[0].time, groups, width, place[0].at_start))
    failed = []
    for i in range(len(passages)):
        for halving in range(HALVINGS):
            tried = replace(passages[i], width=passages[i].width / 2**halving)
            compiled = run.compiled.with_passages(Passages((*passages[:i], tried, *passages[i + 1 :])))
            poles = _settled(compiled, tried, places[i], names)
            if poles is not None:
                passages[i] = replace(tried, poles=poles)
                break
        else:
            failed.append(_finding(run, "motion.cannot-carry", passages[i], "error"))
    compiled = run.compiled.with_passages(Passages(tuple(passages)))
    return Run(compiled, run.start, run.stop, run.steps), failed


def _settled(
    compiled: Compiled, passage: Passage, touches: Sequence[_Touch], names: Sequence[Named]
) -> dict[str, int] | None:
    """The signals that grow without bound and the power by which; ``None`` where the band doesn't hold."""
    t = passage.time + GAP * passage.width * np.array([-1.0, -0.5, 0.5, 1.0])
    try:
        roots = compiled.closed_form_rows([touch.row for touch in touches], t)
        if not (roots.min(axis=1) > [touch.floor for touch in touches]).all():
            return None
        growth = np.log2(roots[:, [0, 3]] / roots[:, [1, 2]])  # fourfold at twice the time
        if np.abs(growth - 2).max() > 0.5:
            return None
        return _proven(compiled, passage, names, len(passage.groups))
    except ModelError:  # a law has no value there
        return None


def _proven(compiled: Compiled, passage: Passage, names: Sequence[Named], most: int) -> dict[str, int] | None:
    """The powers of the signals that grow without bound; ``None`` where some aren't told by the poses around."""
    t = passage.proof
    angles = [i for i, name in enumerate(names) if compiled.graph.wrapped(name)]
    values, exact = (
        unwrapped(compiled.closed_form_rows(names, passage.nodes), angles),
        compiled.closed_form_rows(names, t),
    )
    signals = compiled.graph.signals(names)
    dimensions = [u.PURE if signal is None else signal.dimension for signal in signals]
    allowed = _allowed(compiled, passage, dimensions, np.abs(values).max(axis=1))
    poles: dict[str, int] = {}
    left = np.arange(len(names))
    for power in range(most + 1):
        off = passage.between(t, values[left], power) - exact[left]
        turning = np.isin(left, angles)
        off[turning] = wrapped(off[turning])
        size = np.maximum(allowed[left, None], FORCE * np.abs(exact[left]) if power else 0.0)
        bad = ~(np.abs(off) <= size).all(axis=1)
        poles |= {compiled.graph.row(names[i]).label: power for i in left[~bad] if power}
        left = left[bad]
        # Forces may grow without bound, motion never.
        if not all(dimensions[i] in (u.FORCE, u.TORQUE, u.POWER) for i in left):
            return None
    return None if left.size else poles


def _allowed(compiled: Compiled, passage: Passage, dimensions: Sequence[Dimension], largest: Array) -> Array:
    """How far each row's interpolation may be off, from the largest values near by."""
    size, rate = compiled.assembly.size(), 0.4 / passage.width
    moving = {u.LENGTH: (size, 0), u.SPEED: (size, 1), u.ACCELERATION: (size, 2), u.JERK: (size, 3)}
    moving |= {u.ANGLE: (1.0, 0), u.OMEGA: (1.0, 1), u.ALPHA: (1.0, 2), u.ANGULAR_JERK: (1.0, 3)}
    loads = {u.FORCE: 1.0, u.TORQUE: size, u.POWER: size * rate, u.ENERGY: size}
    most = max((v / loads[d] for d, v in zip(dimensions, largest, strict=True) if d in loads), default=0.0)
    found = []
    for dimension, value in zip(dimensions, largest, strict=True):
        if dimension in loads:
            found.append(FORCE * most * loads[dimension])
        else:
            unit, order = moving.get(dimension, (1.0, 0))
            found.append(MOTION[order] * max(value, unit * rate**order))
    return np.array(found)
