"""The laws of followers: how a cam holds its follower while a motor turns the cam; what is wrong with its lengths."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from math import pi
from typing import Any

import numpy as np

from linkwright.graph.cams import followings, seat, sense, slant, whole
from linkwright.graph.geometry import Geometry
from linkwright.kernels.law import Array, Law, Parameters
from linkwright.kernels.motions import StatedMotion
from linkwright.laws import Motion
from linkwright.laws.numbers import first
from linkwright.model import units as u
from linkwright.model.cams import Following
from linkwright.model.findings import Finding
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

    def ratio(self, angle: Any, speed: Any, parameters: Parameters) -> tuple[Any, Any]:
        """The derivative of the follower's value by the cam's angle, and its rate in time, at the motor's angle (rad)
        and speed (rad/s); these and the parameters may be duals."""
        assert self.ride is not None
        with np.errstate(all="ignore"):
            value = self.ride(Jet([angle, 1.0, 0.0]), parameters)
            return self.turned * value.d[1], self.turned * value.d[2] * speed

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
    noted = _Noting(quantities.parameters)
    with np.errstate(all="ignore"):  # what has no start is told by :func:`cam_faults`
        turn = whole(quantities, noted, drive)
    factor = float(sense(quantities, drive) * drive.turned)

    def ride(angle: Jet, parameters: Parameters) -> Jet:
        geometry = Geometry(quantities, parameters)
        here = seat(geometry, drive)
        lift = motion.given(parameters).on(factor * angle + geometry.number(drive.cam.phase, u.ANGLE))
        value: Jet = here.sign * lift + (here.offset + here.sign * here.start - turn)
        return value

    with np.errstate(all="ignore"):
        ride(Jet.constant(0.0, 1), noted)
    made = CamLaw(motor.of, quantities.parameters, frozenset(noted.asked), drive.motor, drive.turned, ride)
    return made.driven_by(motor)


def recomposed(laws: Mapping[str, Law], motors: Mapping[str, Law]) -> dict[str, Law]:
    """Other laws of the motors, and those of the followers that they move."""
    return {n: law.driven_by(motors[law.motor]) if isinstance(law, CamLaw) else motors[n] for n, law in laws.items()}


class _Noting(dict[str, float]):
    """Parameters that note which of them are asked."""

    def __init__(self, parameters: Mapping[str, float]) -> None:
        super().__init__(parameters)
        self.asked: set[str] = set()

    def __getitem__(self, name: str) -> float:
        self.asked.add(name)
        return super().__getitem__(name)


def cam_faults(quantities: Quantities, motions: Mapping[str, StatedMotion]) -> Iterator[Finding]:
    """Followers that can't stand on the base circle, faces askew, laws that don't go over a turn."""
    geometry = Geometry(quantities, quantities.parameters)
    for name, drive in followings(quantities).items():
        path = ("cams", name)
        motion = motions.get(drive.cam.law)
        if motion is not None:
            yield from (finding for finding, _ in not_whole(quantities, drive.cam.law, motion, (*path, "law")))
        with np.errstate(all="ignore"):
            if drive.joint is not None and drive.cam.face is not None:
                askew = float(slant(geometry, drive))
                if not abs(askew) < SQUARE:
                    unit, size = quantities.unit_of(u.ANGLE)
                    yield Finding("cam.askew", (*path, "face"), {"angle": f"{askew / size:.6g}", "unit": unit})
            yield from _reach(quantities, geometry, path, drive)


def not_whole(q: Quantities, law: str, motion: Motion, path: tuple[str, ...]) -> Iterator[tuple[Finding, Any]]:
    """That a law doesn't go over a turn in whole periods, and in which samples."""
    turns = 2 * pi / motion.period
    wrong = (np.abs(turns - np.round(turns)) > CLOSE * turns) | (np.round(turns) == 0)
    if np.any(wrong):
        unit, size = q.unit_of(u.ANGLE)
        period = f"{first(motion.period, wrong) / size:.6g}"
        yield Finding("cam.period", path, {"law": law, "period": period, "unit": unit}), wrong


def _reach(q: Quantities, geometry: Geometry, path: tuple[str, str], drive: Following) -> Iterator[Finding]:
    """A follower that doesn't reach the base circle."""
    here = seat(geometry, drive)
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
