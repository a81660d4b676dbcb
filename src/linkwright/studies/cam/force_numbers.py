"""The numbers of a cam's forces, in SI, what is wrong with them, and which figures they give."""

from __future__ import annotations

import math
from collections.abc import Callable

from linkwright.cam.contact import ContactPlace
from linkwright.cam.disc import Disc
from linkwright.cam.hertz import STEEL, Material
from linkwright.cam.loads import FollowerLoads
from linkwright.data_classes import dataclass
from linkwright.elements.cam_contact import cam_followers
from linkwright.expressions import units as u
from linkwright.findings import Finding
from linkwright.kernels import Compiled
from linkwright.studies.cam.figures import along_lift, of_forces
from linkwright.studies.cam.force_options import CamForces, CamMaterial
from linkwright.studies.cam.stated_load import stated_load

AT = ("studies", "cam", "forces")
Number = Callable[..., float]
"""Reads the constant at a path within the options of the study."""
HARDEST = 0.5
"""Poisson's ratio of what keeps its volume."""


@dataclass(frozen=True)
class FollowerForces:
    """What acts on a follower, SI. Of the spring's ``rate`` and ``preload`` ``None`` is sized; ``loads`` has 0 there.

    ``second`` is the other side of a follower closed by form. ``speeds`` (rad/s) hold ``omega`` too.
    """

    loads: FollowerLoads
    omega: float
    speeds: tuple[float, float]
    rate: float | None = 0.0
    preload: float | None = 0.0
    contact: float = 0.0
    width: float | None = None
    cam: Material = STEEL
    follower: Material = STEEL
    hertz: float | None = None
    torque: float | None = None
    second: ContactPlace | None = None
    sprung: bool = True
    """Whether springs are looked at: not where form holds the follower and there are none."""


def read(
    compiled: Compiled, name: str, disc: Disc, o: CamForces, number: Number
) -> tuple[FollowerForces, list[Finding]]:
    """All numbers, with NaN for those that are wrong; what ``number`` has no findings for."""
    found: list[Finding] = []
    load = along_lift(disc.follower.turns)[2]
    omega = _speed(compiled, name, o, number, found)
    low, high = 0.0, omega
    if o.speeds is not None:
        low, high = (number("forces", "speeds", i) for i in range(2))
        if low > high:
            data = {"low": o.speeds[0].text[:60], "high": o.speeds[1].text[:60]}
            found.append(Finding("value.not-rising", (*AT, "speeds"), data))
    spring = o.spring
    stated: dict[str, float | None] = dict.fromkeys(("rate", "preload"), 0.0 if spring is None else None)
    for key in ("rate", "preload"):
        if spring is not None and getattr(spring, key) is not None:
            stated[key] = number("forces", "spring", key)
    process, wrong = stated_load(compiled, disc, o.load, load, (*AT, "load"), lambda: number("forces", "load"))
    found += wrong
    loads = FollowerLoads(
        number("forces", "inertia"),
        stated["rate"] or 0.0,
        stated["preload"] or 0.0,
        process.load,
        process.joins,
    )
    materials = [_material(getattr(o, key), key, number, found) for key in ("cam_material", "follower_material")]
    limits = o.limits
    if limits.hertz is not None and o.width is None:
        found.append(Finding("cam.together", AT, {"keys": "limits: hertz, width"}))
    if o.width is not None and not (disc.follower.faced or disc.follower.radius > 0):
        found.append(Finding("cam.knife", (*AT, "width")))
    asked = FollowerForces(
        loads,
        omega,
        (min(low, omega), max(high, omega)),
        stated["rate"],
        stated["preload"],
        number("forces", "contact"),
        None if o.width is None else number("forces", "width"),
        materials[0],
        materials[1],
        None if limits.hertz is None else number("forces", "limits", "hertz"),
        None if limits.torque is None else number("forces", "limits", "torque"),
        sprung="spring_preload_min" in available_figures(compiled, name, disc, o),
    )
    return asked, found


def available_figures(compiled: Compiled, name: str, disc: Disc, o: CamForces | None) -> set[str]:
    """Those that the options give."""
    if o is None:
        return set()
    closed = compiled.mechanism.cams[name].closed
    missing = {"hertz_pressure_max", "second_hertz_pressure_max"} if o.width is None else set()
    if not disc.follower.radius > 0:
        missing |= {"roller_speed_max", "second_roller_speed_max"}
    if closed not in ("conjugate", "yoke"):
        missing |= {"second_contact_force_max", "second_hertz_pressure_max", "second_roller_speed_max"}
    if closed != "force" and o.spring is None:
        missing |= {"lift_off_speed", "spring_preload_min", "spring_rate_min"}
    return of_forces(disc.follower.turns).keys() - missing


def _speed(compiled: Compiled, name: str, o: CamForces, number: Number, found: list[Finding]) -> float:
    """That of the cam, rad/s, without its sign."""
    if o.speed is not None:
        return abs(number("forces", "speed"))
    motor = cam_followers(compiled.mechanism)[name].motor
    stated = compiled.mechanism.drives[motor].speed
    speed = 0.0 if stated is None else abs(compiled.quantities.value(stated, u.OMEGA))
    if speed > 0:
        return speed
    found.append(Finding("cam.no-speed", AT, {"motor": motor}))
    return math.nan


def _material(o: CamMaterial | None, key: str, number: Number, found: list[Finding]) -> Material:
    if o is None:
        return STEEL
    modulus = number("forces", key, "modulus")
    poisson = number("forces", key, "poisson")
    if poisson > HARDEST:
        found.append(Finding("cam.poisson", (*AT, key, "poisson"), {"text": o.poisson.text[:60]}))
    return Material(modulus, poisson)
