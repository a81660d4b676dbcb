"""Cams that are cut already: how followers move on given profiles where other dimensions deviate.

The law of a cam says how it is to be cut, from the nominal dimensions. Of a cam that is cut, a deviation of the centre
distance, the arm or the roller changes the lift instead: the follower rests where its roller's centre lies on the
profile's own parallel. That is sought along the cut pitch curve, exactly, with all rates: by Newton's method on jets,
which converges in all derivatives alike. Base circle, phase and the numbers of the law belong to the cam: their
deviations are errors of its own.
"""

from __future__ import annotations

from dataclasses import replace

from linkwright.graph.cams import Seat, followings, seat, sense, whole
from linkwright.graph.geometry import Geometry
from linkwright.kernels.cams import CamLaw
from linkwright.kernels.compiled import Compiled
from linkwright.kernels.law import Parameters
from linkwright.kernels.motions import StatedMotion
from linkwright.laws import Motion
from linkwright.model import units as u
from linkwright.model.cams import Following
from linkwright.notation import Jet, Pair, Scalar, Vec
from linkwright.notation.jets import call, is_zero

STEPS = 4
"""Newton's steps from the angle of the cam: deviations are small, and each step squares what is left."""


def cut(compiled: Compiled) -> Compiled:
    """The mechanism with all its cams cut as the nominal parameters ask for; other parameters leave them so."""
    if not compiled.mechanism.cams:
        return compiled
    drives = followings(compiled.quantities)
    laws = {
        name: replace(law, ride=_Cut(compiled, drives[name], law).ride).driven_by(compiled.laws[law.motor])
        if isinstance(law, CamLaw)
        else law
        for name, law in compiled.laws.items()
    }
    return replace(compiled, laws=laws)


class _Cut:
    """One profile, and its follower at any parameters."""

    def __init__(self, compiled: Compiled, drive: Following, law: CamLaw) -> None:
        self.quantities, self.drive = compiled.quantities, drive
        self.motion: StatedMotion = compiled.motions[drive.cam.law]
        self.forward = sense(self.quantities, drive)
        nominal = self.quantities.parameters
        self.plan = seat(Geometry(self.quantities, nominal), drive)
        self.turn = whole(self.quantities, nominal, drive)
        self.law, self.nominal = law, nominal

    def ride(self, angle: Jet, parameters: Parameters) -> Jet:
        """The follower's value (rad or m) from the motor's angle, at other parameters."""
        own = ((parameters[name], self.nominal[name]) for name in self.law.names if name in parameters)
        if all(isinstance(value, float) and value == planned for value, planned in own):
            assert self.law.ride is not None
            return self.law.ride(angle, parameters)
        geometry = Geometry(self.quantities, parameters)
        here, phase = seat(geometry, self.drive), geometry.number(self.drive.cam.phase, u.ANGLE)
        plan = replace(self.plan, base=here.base)
        turned = self.drive.turned * angle  # of the cam on its carrier
        at = self.forward * turned + phase
        motion = self.motion.given(parameters)
        found = (self.faced if plan.faced else self.rolled)(motion, plan, here, turned, at, phase)
        return found - self.turn

    def rolled(self, motion: Motion, plan: Seat, here: Seat, turned: Jet, at: Jet, phase: Scalar) -> Jet:
        """With a roller or an edge: its centre on the parallel to the cut pitch curve."""
        more, forward, start = here.roller - plan.roller, self.forward, at
        pivot, right = here.pivot.minus(here.shaft), Pair(here.way.y, -here.way.x)
        for step in range(STEPS + 1):
            centre, way, bend = self.centre(motion, plan, at)
            across = centre.plus(way.perp.times(forward))
            parallel = centre.plus(across.times(more / across.dot(across).sqrt()))
            past = way.minus(centre.perp.times(forward))
            if not is_zero(more):
                bent = bend.minus(way.perp.times(2 * forward)).minus(centre)
                size = past.dot(past)
                past = past.times(1.0 - (forward * more) * past.cross(bent) / (size * size.sqrt()))
            spin = turned - forward * (at - phase)
            point, past = _turned(parallel, spin), _turned(past, spin)
            if step == STEPS:
                break
            if here.turns:
                arm = point.minus(_vector(pivot, at))
                at = at - (arm.dot(arm) - here.reach * here.reach) / (2 * arm.dot(past))
            else:
                at = at - (_along(point, right) - here.aside) / _along(past, right)
        if not here.turns:
            height: Jet = here.sign * _along(point, here.way) + here.offset
            return height
        angle = here.home + here.sign * (here.start + motion.on(start))
        meant, arm = Vec(angle.cos(), angle.sin()), point.minus(_vector(pivot, at))
        beyond: Jet = meant.cross(arm).arctan2(meant.dot(arm))
        found: Jet = beyond + angle + (here.offset - here.home)
        return found

    def centre(self, motion: Motion, plan: Seat, at: Jet) -> tuple[Vec, Vec, Vec]:
        """The roller's centre from the shaft as planned, in the carrier, and its derivatives by the law's angle."""
        lift, slope, bend = motion.on(at) + plan.start, motion.on(at, 1), motion.on(at, 2)
        if not plan.turns:
            right = Pair(plan.way.y, -plan.way.x)
            aside = _vector(Pair(plan.aside * right.x, plan.aside * right.y), at)
            along = [Vec(part * plan.way.x, part * plan.way.y) for part in (lift, slope, bend)]
            return along[0].plus(aside), along[1], along[2]
        angle = plan.home + plan.sign * lift
        arm = Vec(angle.cos(), angle.sin()).times(plan.reach)
        bent = arm.perp.times(plan.sign * bend).minus(arm.times(slope * slope))
        return _vector(plan.pivot.minus(plan.shaft), at).plus(arm), arm.perp.times(plan.sign * slope), bent

    def faced(self, motion: Motion, plan: Seat, here: Seat, turned: Jet, at: Jet, phase: Scalar) -> Jet:
        """With a flat face: a tangent of the profile, by its distance from the shaft over its direction."""
        if not plan.turns:
            way, near = here.way, plan.way
            askew = call("arctan2", near.cross(way), near.dot(way))
            height: Jet = here.sign * (motion.on(at - self.forward * askew) + plan.base) + here.offset
            return height
        away, planned = here.pivot.minus(here.shaft), plan.pivot.minus(plan.shaft)
        for step in range(STEPS + 1):
            swing = plan.home + plan.sign * (plan.start + motion.on(at))
            rate = plan.sign * motion.on(at, 1)
            angle = swing + turned - self.forward * (at - phase)
            if step == STEPS:
                break
            height, slope = self.distance(planned, plan, swing)
            own, tilt = self.distance(away, here, angle)
            at = at - (own - height) / (tilt * (rate - self.forward) - slope * rate)
        found: Jet = angle + (here.offset - here.home)
        return found

    def distance(self, pivot: Pair, seat: Seat, angle: Jet) -> tuple[Jet, Jet]:
        """A face's distance from the shaft, and its derivative by the face's direction."""
        normal = Vec(-(seat.sign * angle.sin()), seat.sign * angle.cos())
        return _along(normal, pivot) + seat.reach, _along(normal.perp, pivot)


def _along(vector: Vec, axis: Pair) -> Jet:
    found: Jet = vector.x * axis.x + vector.y * axis.y
    return found


def _vector(pair: Pair, like: Jet) -> Vec:
    return Vec.constant(pair, like.order)


def _turned(vector: Vec, angle: Jet) -> Vec:
    c, s = angle.cos(), angle.sin()
    return Vec(c * vector.x - s * vector.y, s * vector.x + c * vector.y)
