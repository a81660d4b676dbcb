"""What was understood of drives, acting elements and gravity: sentences with values and units, for `check` and the
report."""

from __future__ import annotations

import math
from functools import partial

import numpy as np

from linkwright.elements.drive import Drive
from linkwright.elements.entries import NOUNS
from linkwright.elements.mover import Mover
from linkwright.elements.points import AXES
from linkwright.expressions import units as u
from linkwright.expressions.units import Dimension
from linkwright.findings import Joined, ModelError, Said, Text
from linkwright.graph.geometry import Geometry
from linkwright.kernels import Compiled
from linkwright.model.plausible import amount

LONGEST = 60
"""The text of a longer law isn't shown."""
ROUND_OFF = 1e-13
"""A speed this small relative to those of its law is round-off: it is 0."""
INSTANTS = 73
"""So many instants of a revolution show how fast a follower is."""


def drives(compiled: Compiled) -> list[Said]:
    """Each drive: what it moves, by which law, from where; then the followers."""
    return [
        Said("fact.drive", name=name, subject=_subject(compiled, name, drive), motion=_motion(compiled, name))
        for name, drive in compiled.mechanism.movers.items()
    ]


def acting(compiled: Compiled) -> dict[str, list[Text]]:
    """What acts on links or weighs, by section: what it is, what it does at the start of the motion."""
    every = [*compiled.mechanism.acting()]
    rows = [f"{one.name}.{effort}" for one in every if (effort := one.kind.effort(one.entry))]
    efforts = dict(zip(rows, compiled.evaluate(rows, np.zeros(1))[:, 0].tolist(), strict=True)) if rows else {}
    found: dict[str, list[Text]] = {section: [] for section in NOUNS}
    for one in every:
        effort = efforts.get(f"{one.name}.{one.kind.effort(one.entry)}", math.nan)
        said = one.kind.sentence(one.name, one.entry, effort, partial(amount, compiled.quantities))
        if said is not None:
            found[one.section].append(said)
    return found


def gravity(compiled: Compiled) -> Said:
    """Its size and direction; or that there is none."""
    if compiled.mechanism.gravity is None:
        return Said("fact.gravity.none")
    parts = [compiled.quantities.value(part, u.ACCELERATION) for part in compiled.mechanism.gravity.parts]
    size = math.hypot(*parts)
    if size == 0:
        return Said("fact.gravity.none")
    x, y = (part / size for part in parts)
    axes = {(0.0, -1.0): "-y", (0.0, 1.0): "+y", (-1.0, 0.0): "-x", (1.0, 0.0): "+x"}
    axis = axes.get((x, y), f"[{x:.6g}, {y:.6g}]")
    return Said("fact.gravity.text", size=f"{size:.6g} m/s²", direction=axis)


def _subject(compiled: Compiled, name: str, drive: Mover) -> Said:
    """What a drive moves against what."""
    m = compiled.mechanism
    if (follower := m.followers.get(name)) is not None:
        return Said("fact.drive.follower", link=drive.link, on=drive.on, motor=follower.motor, kind=follower.title)
    if name in m.drives and (path := m.path_law(name)) is not None:
        said = {"point": path.at, "moved": path.moves, "path": drive.output}
        return Said("fact.drive.path", link=drive.link, on=drive.on, **said)
    if drive.output is not None:
        return Said("fact.drive.output", link=drive.link, on=drive.on, output=drive.output)
    if isinstance(drive, Drive) and drive.moves and drive.at and drive.along:
        return Said(
            "fact.drive.point",
            point=drive.at,
            link=drive.link,
            on=drive.on,
            line=f"{drive.along.point} at {drive.along.angle.text}",
        )
    cylinders = [c.joint for c in compiled.structure.topology.acting(name) if c.joint in m.cylinders]
    if drive.slides and cylinders:
        return Said("fact.drive.cylinder", cylinder=cylinders[0])
    return Said("fact.drive.links", link=drive.link, on=drive.on)


def _motion(compiled: Compiled, name: str) -> Said:
    """The law of a drive: its speed (and in rpm), its start; of other laws their text, and the speed at the start."""
    q, turning = compiled.quantities, bool(compiled.mechanism.prescribed(name).turns)
    value, rate, change = (u.ANGLE, u.OMEGA, u.ALPHA) if turning else (u.LENGTH, u.SPEED, u.ACCELERATION)
    at = _at_start(compiled, name)
    speed = at[1] if abs(at[1]) > ROUND_OFF * _speed_scale(compiled, name, at) else 0.0
    said = {"start": amount(q, at[0], value), "speed": _speed(compiled, speed, rate)}
    if (follower := compiled.mechanism.followers.get(name)) is not None:
        if (own := follower.sentence(Geometry(compiled.quantities, compiled.quantities.parameters))) is not None:
            return Said("fact.law.own", law=own, **said)
        laws = Joined(follower.laws.values())
        return Said("fact.law.follower", law=laws, **said) if laws else Said("fact.law.given", **said)
    drive = compiled.mechanism.drives[name]
    if compiled.mechanism.path_law(name) is not None:
        across = compiled.mechanism.path_drives(str(drive.output)).index(name) > 0
        return Said("fact.law.path", axis=AXES[across], **said)
    if drive.position is not None:
        law = drive.position.text
        return Said("fact.law.position", law=law, **said) if len(law) <= LONGEST else Said("fact.law.given", **said)
    if drive.acceleration is not None:
        return Said("fact.law.accelerated", acceleration=amount(q, at[2], change), **said)
    if at[1] == 0:
        return Said("fact.law.still", **said)
    if turning:
        return Said("fact.law.turning", period=amount(q, 2 * math.pi / abs(at[1]), u.TIME), **said)
    return Said("fact.law.constant", **said)


def _at_start(compiled: Compiled, name: str) -> list[float]:
    """The value of a law (rad or m) at t = 0, and its rates."""
    return [float(np.asarray(d).flat[0]) for d in compiled.laws[name](np.zeros(1)).d]


def _drive_scale(at: list[float]) -> float:
    """A speed of the size that a law has, from its value and rates at the start, of which the lower ones may be zero:
    x^(1 - 1/k) times the k-th rate to the power of 1/k."""
    sizes = [abs(at[0]) ** (1.0 - 1.0 / k) * abs(rate) ** (1.0 / k) for k, rate in enumerate(at[2:], start=2)]
    return float(max(sizes))


def _speed_scale(compiled: Compiled, name: str, at: list[float]) -> float:
    """The same of any mover; of a follower, which may begin with a dwell, the maximum speed over a revolution of its
    motor, if that turns as motion starts."""
    scale = _drive_scale(at)
    if (follower := compiled.mechanism.followers.get(name)) is None:
        return scale
    motor = _at_start(compiled, follower.motor)
    if abs(motor[1]) <= ROUND_OFF * _drive_scale(motor):
        return scale
    t = np.linspace(0.0, 2 * math.pi / abs(motor[1]), INSTANTS)
    try:
        return float(np.fmax.reduce(np.abs(np.ravel(compiled.laws[name](t).d[1])), initial=scale))
    except ModelError:  # the motor's law doesn't last for a revolution
        return scale


def _speed(compiled: Compiled, speed: float, rate: Dimension) -> str:
    """A speed in the model's unit, of a rotation in rpm too."""
    text = amount(compiled.quantities, speed, rate)
    return text if rate != u.OMEGA or speed == 0 else f"{text} = {speed * 30 / math.pi:.6g} rpm"
