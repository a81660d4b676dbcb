"""The laws of followers: how a cam holds its follower while a motor turns the cam; what is wrong with its lengths."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from math import pi
from typing import Any

import numpy as np

from linkwright.expressions import units as u
from linkwright.findings import Finding
from linkwright.graph.cams import Seat, followings, seat, sense, slant, whole
from linkwright.graph.geometry import Geometry
from linkwright.graph.seconds import other_side, second_seat
from linkwright.kernels.law import Array, Law, Parameters
from linkwright.kernels.motions import StatedMotion
from linkwright.kernels.seconds import largest, misplaced
from linkwright.laws import Motion
from linkwright.laws.numbers import first
from linkwright.model.cams import Following
from linkwright.model.quantities import Quantities
from linkwright.notation import Jet

SQUARE = 1e-9
"""How closely (rad) a face must be square to its slide."""
CLOSE = 1e-9


@dataclass(frozen=True)
class CamLaw(Law):
    """The law of a follower; ``ride`` gives its value from that of the motor (rad) with its rates."""

    motor: str = ""
    turned: int = 1
    ride: Callable[[Jet, Parameters], Jet] | None = None
    total: float = 0.0  # what places a second contact: see :func:`linkwright.graph.seconds.second`

    def ratio(self, angle: Any, speed: Any, parameters: Parameters) -> tuple[Any, Any]:
        """The derivative of the follower's value by the cam's angle, and its rate in time, at the motor's angle (rad)
        and speed (rad/s); these and the parameters may be duals."""
        assert self.ride is not None
        with np.errstate(all="ignore"):
            value = self.ride(Jet([angle, 1.0, 0.0]), parameters)
            return self.turned * value.d[1], self.turned * value.d[2] * speed

    def along(self, angle: float) -> tuple[float, float]:
        """The follower's value (rad or m) and its derivative by the motor's, at a value of that (rad)."""
        assert self.ride is not None
        value, slope = self.ride(Jet([angle, 1.0]), self.parameters).d
        return float(value), float(slope)

    def driven_by(self, motor: Law) -> CamLaw:
        """The same cam turned by another law of its motor."""
        ride = self.ride
        assert ride is not None

        def of(t: Array, parameters: Parameters, strict: bool) -> Jet:
            with np.errstate(all="ignore"):
                return ride(motor.of(t, parameters, strict), parameters)

        return replace(self, of=of, names=self.names | motor.names)


def follower_law(quantities: Quantities, name: str, motion: StatedMotion, motor: Law) -> CamLaw:
    """The law of the follower of a cam, by the law of its motor."""
    drive = quantities.mechanism.drives[name]
    assert isinstance(drive, Following)
    noted = Noting(quantities.parameters)
    with np.errstate(all="ignore"):  # what has no start is told by :func:`cam_faults`
        turn = whole(quantities, noted, drive)
    factor = float(sense(quantities, drive) * drive.turned)
    total = largest(drive, motion) if drive.derived else 0.0

    def ride(angle: Jet, parameters: Parameters) -> Jet:
        geometry = Geometry(quantities, parameters)
        here = seat(geometry, drive)
        lift = motion.given(parameters).on(factor * angle + geometry.number(drive.cam.phase, u.ANGLE))
        value: Jet = here.sign * lift + (here.offset + here.sign * here.start - turn)
        return value

    with np.errstate(all="ignore"):
        ride(Jet.constant(0.0, 1), noted)
    made = CamLaw(motor.of, quantities.parameters, frozenset(noted.asked), drive.motor, drive.turned, ride, total)
    return made.driven_by(motor)


def recomposed(laws: Mapping[str, Law], motors: Mapping[str, Law]) -> dict[str, Law]:
    """Other laws of the motors, and those of the followers that they move."""
    return {n: law.driven_by(motors[law.motor]) if isinstance(law, CamLaw) else motors[n] for n, law in laws.items()}


class Noting(dict[str, float]):
    """Parameters that note which of them are asked."""

    def __init__(self, parameters: Mapping[str, float]) -> None:
        super().__init__(parameters)
        self.asked: set[str] = set()

    def __getitem__(self, name: str) -> float:
        self.asked.add(name)
        return super().__getitem__(name)


def cam_faults(quantities: Quantities, motions: Mapping[str, StatedMotion], named: bool = True) -> Iterator[Finding]:
    """Followers that can't stand on the base circle, faces askew, laws that don't go over a turn, second contacts that
    can't be placed. Unless all elements are ``named`` rightly there is no geometry: of laws alone then."""
    geometry = Geometry(quantities, quantities.parameters)
    for name, drive in followings(quantities).items():
        path: tuple[str, ...] = ("cams", name)
        motion = motions.get(drive.cam.law)
        if motion is not None:
            yield from (finding for finding, _ in not_whole(quantities, drive.cam.law, motion, (*path, "law")))
        if not named:
            continue
        with np.errstate(all="ignore"):
            found = [*_askew(geometry, path, drive)]
            found += _reach(quantities, path, drive, seat(geometry, drive))
            if drive.paired and motion is not None and not found:
                found = [*_second_faults(geometry, path, drive, motion)]
            yield from found


def not_whole(q: Quantities, law: str, motion: Motion, path: tuple[str, ...]) -> Iterator[tuple[Finding, Any]]:
    """That a law doesn't go over a turn in whole periods, and in which samples."""
    turns = 2 * pi / motion.period
    wrong = (np.abs(turns - np.round(turns)) > CLOSE * turns) | (np.round(turns) == 0)
    if np.any(wrong):
        unit, size = q.unit_of(u.ANGLE)
        period = f"{first(motion.period, wrong) / size:.6g}"
        yield Finding("cam.period", path, {"law": law, "period": period, "unit": unit}), wrong


def _second_faults(geometry: Geometry, path: tuple[str, ...], drive: Following, motion: Motion) -> Iterator[Finding]:
    """What is wrong with a second contact; the first has no fault."""
    path = path if drive.cam.second is None else (*path, "second")
    if drive.derived:
        faults = [*_reach(geometry.quantities, path, drive, second_seat(geometry, drive))]
    else:
        faults = [*_askew(geometry, path, other_side(drive))]
    yield from faults or misplaced(geometry, path, drive, motion)


def _askew(geometry: Geometry, path: tuple[str, ...], drive: Following) -> Iterator[Finding]:
    """A sliding follower's face that isn't square to the slide."""
    if drive.joint is None or drive.cam.face is None:
        return
    askew = float(slant(geometry, drive))
    if not abs(askew) < SQUARE:
        unit, size = geometry.quantities.unit_of(u.ANGLE)
        yield Finding("cam.askew", (*path, "face"), {"angle": f"{askew / size:.6g}", "unit": unit})


def _reach(q: Quantities, path: tuple[str, ...], drive: Following, here: Seat) -> Iterator[Finding]:
    """A follower that doesn't reach the base circle; what has no value is told by itself."""
    if np.isnan(here.level):
        return
    unit, size = q.unit_of(u.LENGTH)

    def told(code: str, **lengths: Any) -> Finding:
        shown = {key: f"{float(length) / size:.6g}" for key, length in lengths.items()}
        return Finding(code, path, {**shown, "unit": unit, "follower": drive.link})

    if not here.turns:
        pitch = here.base + here.roller
        if not here.faced and not abs(here.aside) < pitch:
            yield told("cam.offset", offset=abs(here.aside), limit=pitch)
        return
    if not here.distance > 0:
        yield Finding("cam.no-distance", path, {"follower": drive.link})
    elif here.faced and not abs(here.level) < 1:
        yield told("cam.face", base=here.base, face=here.reach, distance=here.distance)
    elif not here.faced and not here.reach > 0:
        yield Finding("cam.no-arm", path, {"point": drive.cam.touches})
    elif not here.faced and not abs(here.level) < 1:
        low, high = abs(here.distance - here.reach), here.distance + here.reach
        pitch = here.base + here.roller
        by = max(low - pitch, pitch - high)
        yield told("cam.reach", distance=here.distance, arm=here.reach, pitch=pitch, low=low, high=high, by=by)
