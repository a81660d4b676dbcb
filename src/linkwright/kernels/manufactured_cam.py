"""Cams that are cut already: how followers move on given profiles where other dimensions deviate.

The law of a cam says how it is to be cut, from the nominal dimensions. Of a cam that is cut, a deviation of the centre
distance, the arm or the roller changes the lift instead: the follower rests where its roller's centre lies on the
profile's own parallel. That is sought along the cut pitch curve, exactly, with all rates: by Newton's method on jets,
which converges in all derivatives alike. Base circle, phase and the numbers of the law belong to the cam: their
deviations are errors of its own.

A clearance is such a deviation too: of the places on the links that are put on a pin, of the slide's line. That of the
cam's own place turns with the cam: the cam's centre then lies beside its pin. On a roller's own pin it acts as a roller
of another radius.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from linkwright.data_classes import dataclass
from linkwright.elements.cam_contact import cam_followers
from linkwright.elements.cam_contact.contact import CamPair, base_circle_turns, seat, sense, slant
from linkwright.elements.cam_contact.follower import CamFollower
from linkwright.expressions import units as u
from linkwright.graph.geometry import Geometry
from linkwright.kernels.compiled import Compiled
from linkwright.kernels.followers import FollowerLaw, Noting
from linkwright.kernels.law import Parameters
from linkwright.kernels.motions import StatedMotion
from linkwright.laws import Motion
from linkwright.model.quantities import Quantities
from linkwright.notation import Jet, Pair, Scalar, Vec
from linkwright.notation.jets import call, is_zero

ORDERS = (0, 0, 0, 1, 3)
"""The orders of Newton's steps from the angle of the cam. Deviations are small, and each step squares what is left; of
derivatives it doubles the number that are right."""


def with_cut_cams(compiled: Compiled) -> Compiled:
    """The mechanism with all its cams cut as the nominal parameters ask for; other parameters leave them so."""
    if not compiled.mechanism.cams:
        return compiled
    laws = dict(compiled.laws)
    for name, drive in cam_followers(compiled.mechanism).items():
        if isinstance(law := compiled.laws[name], FollowerLaw):
            made = _Cut(compiled, drive, law)
            laws[name] = replace(made.law, follower_value=made.follower_value, plays=made.plays).driven_by(
                compiled.laws[law.motor]
            )
    return replace(compiled, laws=laws)


@dataclass(frozen=True)
class _Pose:
    """A cam pair at some angles of the motor: ``cam_angle`` is that of the cam on its carrier, ``at`` the one
    at which its law is taken; ``centre`` is that of the cam, from the place of the carrier on the shaft's pin."""

    geometry: Geometry
    motion: Motion
    here: CamPair
    cam_angle: Jet
    at: Jet
    phase: Scalar
    centre: Vec

    def from_cam(self, place: Pair) -> Vec:
        """A place of the carrier from the cam's centre."""
        return _vector(place.minus(self.here.shaft), self.at).minus(self.centre)


class _Cut:
    """One profile, and its follower at any parameters."""

    def __init__(self, compiled: Compiled, drive: CamFollower, law: FollowerLaw) -> None:
        self.quantities, self.drive = compiled.quantities, drive
        self.motion: StatedMotion = compiled.motions[drive.cam.law]
        self.forward = sense(Geometry(self.quantities, self.quantities.parameters), drive)
        nominal = self.quantities.parameters
        noted = Noting(nominal)
        plain = Geometry(self.quantities, noted)
        self.plan = seat(plain, drive)
        self.slant = slant(plain, drive) if self.plan.faced and not self.plan.turns else 0.0
        self.turn = base_circle_turns(plain.nominal, drive)
        self.law, self.nominal = replace(law, names=law.names | noted.asked), nominal
        self.plays = frozenset(_plays(self.quantities, drive))

    def follower_value(self, angle: Jet, parameters: Parameters) -> Jet:
        """The follower's value (rad or m) from the motor's angle, at other parameters."""
        own = ((parameters[name], self.nominal[name]) for name in self.law.names if name in parameters)
        plays = {name: parameters[name] for name in self.plays if name in parameters}
        if not plays and all(isinstance(value, float) and value == planned for value, planned in own):
            assert self.law.follower_value is not None
            return self.law.follower_value(angle, parameters)
        geometry = Geometry(self.quantities, parameters, plays)
        here, phase = seat(geometry, self.drive), geometry.number(self.drive.cam.phase, u.ANGLE)
        plan = replace(self.plan, base=here.base)
        if (wider := plays.get(f"{self.drive.cam.touches}/roller")) is not None:
            here = replace(here, roller=here.roller + wider)
        cam_angle = self.drive.motor_sign * angle  # of the cam on its carrier
        at = self.forward * cam_angle + phase
        cam, point = self.drive.cam.cam, self.drive.shaft[0]
        beside = geometry.point(cam, point).minus(geometry.pinned(cam, point))
        moved = _rotated(_vector(beside, at), cam_angle)
        pose = _Pose(geometry, self.motion.at_parameters(parameters), here, cam_angle, at, phase, moved)
        found = (self.rolled if not plan.faced else self.flat_swinging if plan.turns else self.flat)(plan, pose)
        return found - self.turn

    def rolled(self, plan: CamPair, pose: _Pose) -> Jet:
        """With a roller or an edge: its centre on the parallel to the cut pitch curve."""
        here, motion, forward = pose.here, pose.motion, self.forward
        more, right = here.roller - plan.roller, Pair(here.way.y, -here.way.x)
        pivot = pose.from_cam(here.pivot)

        def spun(vector: Vec, at: Jet) -> Vec:
            """From the pose in which the law is asked at an angle to that of the cam."""
            return _rotated(vector, pose.cam_angle - forward * (at - pose.phase))

        def contact_point(at: Jet, centre: Vec, way: Vec) -> Vec:
            across = centre.plus(way.perp.times(forward))
            return spun(centre.plus(across.times(more / across.dot(across).sqrt())), at)

        def step(at: Jet) -> Jet:
            centre, way = self.centre(motion, plan, at)
            past = way.minus(centre.perp.times(forward))
            if not is_zero(more):
                bent = self.bend(motion, plan, at, centre, way).minus(way.perp.times(2 * forward)).minus(centre)
                size = past.dot(past)
                past = past.times(1.0 - (forward * more) * past.cross(bent) / (size * size.sqrt()))
            point, past = contact_point(at, centre, way), spun(past, at)
            if here.turns:
                arm = point.minus(pivot)
                off: Jet = (arm.dot(arm) - here.reach * here.reach) / (2 * arm.dot(past))
                return off
            aside: Jet = (_along(point.plus(pose.centre), right) - here.aside) / _along(past, right)
            return aside

        at = _solved(step, pose.at)
        point = contact_point(at, *self.centre(motion, plan, at))
        if not here.turns:
            height: Jet = here.sign * _along(point.plus(pose.centre), here.way) + here.offset
            return height
        angle = here.shaft_direction + here.sign * (here.start + motion.on(pose.at))
        meant, arm = Vec(angle.cos(), angle.sin()), point.minus(pivot)
        beyond: Jet = meant.cross(arm).arctan2(meant.dot(arm))
        found: Jet = beyond + angle + (here.offset - here.shaft_direction)
        return found

    def centre(self, motion: Motion, plan: CamPair, at: Jet) -> tuple[Vec, Vec]:
        """The roller's centre from the shaft as planned, in the carrier, and its derivative by the law's angle."""
        lift, slope = motion.on(at) + plan.start, motion.on(at, 1)
        if not plan.turns:
            right = Pair(plan.way.y, -plan.way.x)
            aside = _vector(Pair(plan.aside * right.x, plan.aside * right.y), at)
            return Vec(lift * plan.way.x, lift * plan.way.y).plus(aside), Vec(slope * plan.way.x, slope * plan.way.y)
        angle = plan.shaft_direction + plan.sign * lift
        arm = Vec(angle.cos(), angle.sin()).times(plan.reach)
        return _vector(plan.pivot.minus(plan.shaft), at).plus(arm), arm.perp.times(plan.sign * slope)

    def bend(self, motion: Motion, plan: CamPair, at: Jet, centre: Vec, way: Vec) -> Vec:
        """The second derivative of the roller's ``centre``, whose first one is ``way``."""
        bend = motion.on(at, 2)
        if not plan.turns:
            return Vec(bend * plan.way.x, bend * plan.way.y)
        arm = centre.minus(_vector(plan.pivot.minus(plan.shaft), at))
        return arm.perp.times(plan.sign * bend).minus(arm.times(way.dot(way) / (plan.reach * plan.reach)))

    def flat(self, plan: CamPair, pose: _Pose) -> Jet:
        """With a sliding flat face: the tangent of the profile in the face's direction."""
        here, tilt, ahead = pose.here, self.slant - slant(pose.geometry, self.drive), pose.here.way
        c, s = call("cos", tilt), call("sin", tilt)
        normal = Pair(c * ahead.x - s * ahead.y, s * ahead.x + c * ahead.y)
        askew = call("arctan2", plan.way.cross(normal), plan.way.dot(normal))
        reach = pose.motion.on(pose.at - self.forward * askew) + plan.base + _along(pose.centre, normal)
        height: Jet = here.sign * (reach + here.aside * s) / c + here.offset
        return height

    def flat_swinging(self, plan: CamPair, pose: _Pose) -> Jet:
        """With a swinging flat face: a tangent of the profile, by its distance from the shaft over its direction."""
        here, motion = pose.here, pose.motion
        away, planned = pose.from_cam(here.pivot), _vector(plan.pivot.minus(plan.shaft), pose.at)

        def swing(at: Jet) -> tuple[Jet, Jet]:
            """The face's angle as planned, and its own."""
            angle = plan.shaft_direction + plan.sign * (plan.start + motion.on(at))
            return angle, angle + pose.cam_angle - self.forward * (at - pose.phase)

        def step(at: Jet) -> Jet:
            rate = plan.sign * motion.on(at, 1)
            (height, slope), (own, tilt) = (
                self.distance(pivot, seat, angle)
                for pivot, seat, angle in zip((planned, away), (plan, here), swing(at), strict=True)
            )
            return (own - height) / (tilt * (rate - self.forward) - slope * rate)

        found: Jet = swing(_solved(step, pose.at))[1] + (here.offset - here.shaft_direction)
        return found

    def distance(self, pivot: Vec, seat: CamPair, angle: Jet) -> tuple[Jet, Jet]:
        """A face's distance from the shaft, and its derivative by the face's direction."""
        normal = Vec(-(seat.sign * angle.sin()), seat.sign * angle.cos())
        return _along(normal, pivot) + seat.reach, _along(normal.perp, pivot)


def _plays(quantities: Quantities, drive: CamFollower) -> Iterator[str]:
    """The offsets of the joints that guide a cam and its follower, and of the roller's radius (m)."""
    if drive.cam.roller is not None:
        yield f"{drive.cam.touches}/roller"
    at = [(drive.cam.cam, drive.shaft[0]), (drive.on, drive.shaft[1])]
    at += [] if drive.pivot is None else [(drive.link, drive.pivot[0]), (drive.on, drive.pivot[1])]
    for pin in quantities.signals.pins.values():
        yield from (f"{pin.name}/{link}/{axis}" for link, point in at if (link, point) in pin.members for axis in "xy")
    if drive.joint is not None:
        yield from (f"{drive.joint}/normal", f"{drive.joint}/tilt")


def _solved(step: Callable[[Jet], Jet], guess: Jet) -> Jet:
    """The root to which Newton's steps lead, with all its derivatives."""
    at = Jet(guess.d[:1])
    for order in ORDERS:
        at = Jet([*at.d, *guess.d[len(at.d) : order + 1]])
        at = at - step(at)
    return at


def _along(vector: Vec, axis: Pair | Vec) -> Jet:
    found: Jet = vector.x * axis.x + vector.y * axis.y
    return found


def _vector(pair: Pair, like: Jet) -> Vec:
    return Vec.constant(pair, like.order)


def _rotated(vector: Vec, angle: Jet) -> Vec:
    c, s = angle.cos(), angle.sin()
    return Vec(c * vector.x - s * vector.y, s * vector.x + c * vector.y)
