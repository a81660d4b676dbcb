"""What hinge designers ask of a linkage over its driving range: opening, instant centre, transmission angle, forces,
the area that the panel sweeps."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from itertools import pairwise
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from linkwright.data_classes import dataclass
from linkwright.elements.fields import PointName
from linkwright.elements.points import links_of_points
from linkwright.expressions import units as u
from linkwright.expressions.fields import Frozen, Name
from linkwright.expressions.typed_fields import Ref
from linkwright.expressions.unknown import near
from linkwright.findings import Finding, Term
from linkwright.kernels import Compiled
from linkwright.kernels.law import DriveLaw
from linkwright.kernels.laws import uniform, values_at
from linkwright.model.references import option_faults
from linkwright.presentation.json_numbers import known
from linkwright.structure import FRAME
from linkwright.studies.drive_sweep import Sweep, sweeping
from linkwright.studies.limits.extremes import Transmission, transmission

Array = NDArray[np.float64]

STILL = 1e-9
"""A handle that moves by less than this share of the linkage's size for a turn of 1 rad stands still."""


class Facts(Frozen):
    """What the sheet tells beside the joint functions."""

    panel: Annotated[Name | None, Ref("moving")] = None
    handle: PointName | None = None
    outline: tuple[PointName, ...] = Field((), max_length=200)
    samples: int = Field(180, ge=8, le=5000)


@dataclass(frozen=True)
class HingeFacts:
    """The facts at the drive's values ``value`` (poses,), in rad or m from the zero pose; all in SI.

    ``opening`` (poses,) is the panel's turn from the zero pose, positive on the way to the other stop; ``pole``
    (2, poses) its instant centre in the frame, not finite where it doesn't turn. ``hand`` (poses,) is the force at the
    handle, along its path, that holds the mechanism at rest: positive where the hand has to move the handle on, away
    from the zero pose, negative where it has to hold it back. ``springs`` (poses,) are tensions, of gas springs the
    push. ``swept`` is the area that the outline sweeps.
    """

    drive: str
    panel: str
    zero: float  # the drive's value at the zero pose less that at the start of the motion
    value: Array
    opening: Array
    pole: Array
    transmission: tuple[Transmission, ...]
    handle: str | None
    hand: Array | None
    springs: Mapping[str, Array]
    outline: Array | None  # (2, points) at the zero pose
    outline_end: Array | None  # at the other stop
    swept: Any
    units: Mapping[str, tuple[str, float]]
    """Unit and size (SI) of ``drive``, ``angle``, ``length``, ``force``."""

    @property
    def far(self) -> int:
        """The pose at the other stop: the end of the range that is farther from the zero pose."""
        return 0 if abs(self.value[0]) > abs(self.value[-1]) else -1

    def as_dict(self) -> dict[str, Any]:
        """Plain data in the file's units; ``None`` for what has no value."""
        (drive_unit, step), (angle_unit, angle) = self.units["drive"], self.units["angle"]
        (length_unit, length), (force_unit, force) = self.units["length"], self.units["force"]
        ends = slice(None, None, self.value.size - 1)
        made: dict[str, Any] = {
            "drive": {
                "name": self.drive,
                "from": self.value[0] / step,
                "to": self.value[-1] / step,
                "unit": drive_unit,
            },
            "opening": {"link": self.panel, **self._extremes(self.opening / angle, angle_unit)},
            "pole": {"ends": [[known(v / length) for v in at] for at in self.pole[:, ends].T], "unit": length_unit},
            "transmission": [
                {
                    "group": t.group,
                    "least": t.angle / angle,
                    "unit": angle_unit,
                    "at": None if t.time is None else t.time / step,
                }
                for t in self.transmission
            ],
            "springs": {name: self._extremes(row / force, force_unit) for name, row in self.springs.items()},
        }
        if self.hand is not None:
            made["hand"] = {"point": self.handle, **self._extremes(self.hand / force, force_unit)}
        if self.swept is not None:
            bounds = [edge / length for edge in self.swept.bounds]
            made["swept"] = {"bounds": bounds, "area": self.swept.area / length**2, "unit": length_unit}
        return made

    def _extremes(self, row: Array, unit: str) -> dict[str, Any]:
        """Least and greatest value with their places, of the poses."""
        step = self.units["drive"][1]
        made: dict[str, Any] = {"min": None, "min_at": None, "max": None, "max_at": None, "unit": unit}
        if np.isfinite(row).any():
            for key, pick in (("min", np.nanargmin), ("max", np.nanargmax)):
                at = int(pick(np.where(np.isfinite(row), row, np.nan)))
                made |= {key: float(row[at]), f"{key}_at": float(self.value[at] / step)}
        return made


def facts(compiled: Compiled, options: Facts, low: float, high: float, zero: float | None = None) -> HingeFacts:
    """The facts between two values of the drive (rad or m); ``zero`` is its value at the zero pose, that at the start
    unless given.

    All other drives rest at their start. The mechanism must assemble over the whole range and at the zero pose.
    """
    drive, panel = compiled.graph.drives[0], panel_of(compiled, options)
    quantities, start = compiled.quantities, values_at(compiled.laws, 0.0)[compiled.graph.drives[0]]
    zero = start if zero is None else zero
    ends = min(low, zero) - start, max(high, zero) - start
    sweep = Sweep(sweeping(compiled, drive), drive, *ends, options.samples, (None, None))
    t = np.linspace(low - start, high - start, options.samples + 1)
    t = np.unique([*t, zero - start]) if low < zero < high else t
    value = t + start - zero
    names = [f"{panel}.angle", *(f"pole({panel}, frame).{axis}" for axis in "xy")]
    angle, *pole = sweep.evaluate(names, t)
    opening = angle - sweep.evaluate(names[:1], np.array([zero - start]))[0, 0]
    corners = None
    if options.outline:
        places = [f"{point}.{axis}" for axis in "xy" for point in options.outline]
        corners = sweep.evaluate(places, t).reshape(2, len(options.outline), -1)
    near, far = int(np.argmin(np.abs(value))), 0 if abs(value[0]) > abs(value[-1]) else -1
    units = {"drive": quantities.drive_unit(drive)}
    units |= {k: quantities.unit_of(d) for k, d in (("angle", u.ANGLE), ("length", u.LENGTH), ("force", u.FORCE))}
    range_ = Sweep(sweep.compiled, drive, low - start, high - start, options.samples, (None, None))
    least = (t if t.time is None else replace(t, time=t.time + start - zero) for t in transmission(range_))
    on = 1.0 if far else -1.0
    hand = None if options.handle is None else hand_force(compiled, drive, options.handle, t)
    return HingeFacts(
        drive=drive,
        panel=panel,
        zero=zero - start,
        value=value,
        opening=opening * (np.sign(opening[far]) or 1.0),
        pole=np.array(pole),
        transmission=tuple(least),
        handle=options.handle,
        hand=None if hand is None else on * hand,
        springs=spring_forces(compiled, drive, t),
        outline=None if corners is None else corners[:, :, near],
        outline_end=None if corners is None else corners[:, :, far],
        swept=None if corners is None else swept(corners),
        units=units,
    )


def panel_of(compiled: Compiled, options: Facts) -> str:
    """The link whose opening is told."""
    point = next(iter([*options.outline, *filter(None, [options.handle])]), None)
    if options.panel is not None or point is not None:
        return options.panel or links_of_points(compiled.mechanism)[str(point)]
    topology = compiled.structure.topology
    on_frame = {link for pin in topology.pins.values() if FRAME in pin.links for link in pin.links}
    on_frame |= {
        link for _, joint in compiled.mechanism.prismatic_joints() if FRAME in joint.links for link in joint.links
    }
    parts = {link for slide in compiled.mechanism.cylinders for link in compiled.mechanism.joints[slide].links}
    free = [link for link in topology.moving if link not in parts] or topology.moving
    return next((link for link in free if link not in on_frame), free[-1])


def resting(compiled: Compiled, drive: str) -> Compiled:
    """The mechanism at rest in poses: at time t its drive stands at its start value plus t, all others at theirs."""

    def law(start: float, moves: bool) -> DriveLaw:
        return DriveLaw(lambda t, p, strict: uniform(t, start + t * moves, 0.0), {})

    return replace(compiled, laws={n: law(v, n == drive) for n, v in values_at(compiled.laws, 0.0).items()})


def hand_force(compiled: Compiled, drive: str, handle: str, t: Array) -> Array | None:
    """The force (N) along the handle's path that holds the mechanism at rest with the drive at its start value plus
    ``t``; positive where it acts in the direction of the path as t grows. By virtual work it is the drive's effort
    times its rate over the handle's speed. ``None`` where no forces are stated or where they depend on the time; NaN
    where the handle stands still."""
    m = compiled.mechanism
    forces = any(one.kind.acts for one in m.acting()) or (m.gravity is not None and any(map(m.has_mass, m.links)))
    if not forces or compiled.graph.actions.timed or compiled.structure.higher_groups:
        return None
    entry = m.movers[drive]
    moving = sweeping(compiled, drive)
    effort = resting(compiled, drive).evaluate([f"{drive}.{entry.effort}"], t)[0]
    rate, vx, vy = moving.evaluate([f"{drive}.{entry.rate}", f"{handle}.vx", f"{handle}.vy"], t)
    speed = np.hypot(vx, vy)
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(speed > STILL * compiled.assembly.size(), effort * rate / speed, np.nan)


def spring_forces(compiled: Compiled, drive: str, t: Array) -> dict[str, Array]:
    """The tension (N) of each spring between points, at rest; of gas springs the push. ``t`` as for the hand."""
    every = ((one.name, one.kind.pull(one.entry)) for one in compiled.mechanism.acting())
    pulls = {name: pull for name, pull in every if pull is not None}
    if not pulls or compiled.structure.higher_groups:
        return {}
    rows = resting(compiled, drive).evaluate([f"{name}.{attribute}" for name, (attribute, _) in pulls.items()], t)
    return {name: sign * row for (name, (_, sign)), row in zip(pulls.items(), rows, strict=True)}


def swept(corners: Array) -> Any:
    """The area (m²) that a polygon sweeps; ``corners`` (2, corners, poses). Between two poses its edges sweep the
    convex hulls of where they were and are: that is off by no more than the sagitta of a corner's path in a step."""
    import shapely

    rings = np.moveaxis(corners, (0, 1, 2), (2, 1, 0))  # (poses, corners, 2)
    rings = rings[np.isfinite(rings).all(axis=(1, 2))]
    if not len(rings):
        return None
    edges = np.stack([rings, np.roll(rings, -1, axis=1)], axis=2)  # (poses, edges, 2, 2)
    parts = [shapely.polygons(rings)]
    for before, after in pairwise(edges):
        parts.append(shapely.convex_hull(shapely.multipoints(np.concatenate([before, after], axis=1))))
    return shapely.union_all(np.concatenate([np.atleast_1d(part) for part in parts]))


def check_facts(compiled: Compiled, options: Facts, path: tuple[str | int, ...]) -> list[Finding]:
    """What is wrong with the options, which stand at ``path`` in the file."""
    m, points = compiled.mechanism, links_of_points(compiled.mechanism)
    if found := option_faults(m, options, path):
        return found
    if options.handle and points[options.handle] == FRAME:
        found.append(Finding("export.handle", (*path, "handle"), {"name": options.handle}))
    panel = panel_of(compiled, options)
    for name in dict.fromkeys(options.outline):
        if name not in m.links[panel].points:
            data = {"link": panel, "name": name, "near": near(name, list(m.links[panel].points))}
            found.append(Finding("name.unknown-point", (*path, "outline"), data))
    if options.outline and not found and (why := _crossed(compiled, options.outline)) is not None:
        found.append(Finding("export.outline", (*path, "outline"), {"reason": why}))
    return found


def _crossed(compiled: Compiled, outline: tuple[str, ...]) -> Term | None:
    """Why some points make no outline."""
    import shapely

    if len({*outline}) < 3 or len({*outline}) < len(outline):
        return Term("outline-few")
    rows = [f"{point}.{axis}" for point in outline for axis in "xy"]
    places = compiled.evaluate(rows, np.zeros(1))[:, 0].reshape(-1, 2)
    shape = shapely.Polygon(places)
    return None if shape.is_valid and shape.area > 0 else Term("outline-crossed")
