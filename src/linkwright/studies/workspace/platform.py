"""The platform of one triad of a mechanism turned round: its poses at places, and sets that hold all over cells.

Over a cell its angles lie in stretches that hold no more than one or two each
(:mod:`linkwright.enclosures.angles`). Poses near the middle's are proven to be the only ones about
(:mod:`linkwright.enclosures.newton`). Where these are as many as a stretch can hold none is missed. Else the poses of a
stretch are taken together, by the places where two of the legs meet: as where two poses meet, and end.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from linkwright.enclosures.angles import Polynomials, Stretches, cosine_and_sine, numbered, stretches
from linkwright.enclosures.forms import TINY, UNIT, AffineForm, joined_forms
from linkwright.enclosures.newton import inverted, solved
from linkwright.enclosures.program import BOXES, Stage
from linkwright.graph.inverse import Platform
from linkwright.kernels import KERNELS
from linkwright.kernels.registry import Kernel
from linkwright.notation.angles import whole_turns
from linkwright.notation.harmonics import ANGLES, MOST, WEIGHTS
from linkwright.studies.workspace.meetings import TOUCH, meetings, zeros_between

Array = NDArray[np.float64]
Rows = NDArray[np.intp]

WIDE, FINE, PIECES = 0.2, 0.01, 8
"""Stretches of angles less wide (rad, to both sides) are cut into pieces so fine, but no more than so many."""
SETTLED, PATIENT = 2, 16
"""Steps of Newton's method from a zero of the polynomial; from one whose room is little more than round-off ..."""
NEAR, SURE = 0.05, 1e-8
"""... no longer than this (rad or m); it has come to an end where the last is shorter than that."""


class OnePlatform:
    """One platform, after those that it hangs on."""

    def __init__(self, platform: Platform, parameters: Array) -> None:
        self.platform, self.parameters = platform, parameters

    @cached_property
    def _kernels(self) -> dict[str, Kernel]:
        return {name: KERNELS["numpy"](getattr(self.platform, name)) for name in ("polynomial", "misses")}

    def _run(self, name: str, x: Array, *pose: Array | float) -> Array:
        whole = np.zeros((len(self.platform.misses.inputs), x.shape[1]))
        whole[: len(x)] = x
        for row, value in enumerate(pose, len(x)):
            whole[row] = value
        with np.errstate(all="ignore"):
            return np.asarray(self._kernels[name].run(whole, self.parameters))

    def poses(self, x: Array) -> tuple[Array, Array]:
        """Cosines, sines, x and y of all poses, (4, n * MOST), those of a place next to each other; and the rooms."""
        values = [self._run("polynomial", x, np.cos(phi), np.sin(phi))[0] for phi in ANGLES]
        angle, rooms, places = zeros_between(WEIGHTS @ values)
        phi, room, which = angle.T.ravel(), rooms.T.ravel(), places.T.ravel()
        found, some = np.full((3, phi.size), np.nan), np.flatnonzero(np.isfinite(phi))
        found[:, some] = self.settled(x[:, some // MOST], phi[some], which[some])
        # What an extremum near zero leaves is little more than round-off: whether there is a pose the equations tell.
        some = some[np.abs(room[some]) < TOUCH]
        found[:, some], sure = self._newton(x[:, some // MOST], found[:, some], PATIENT)
        room[some] = np.where(sure, 1.0, -1.0) * np.maximum(np.abs(room[some]), TINY)
        return np.stack([np.cos(found[0]), np.sin(found[0]), *found[1:]]), room[None]

    def settled(self, x: Array, phi: Array, which: Rows) -> Array:
        """Angle and place, (3, n), of platforms at zeros of their polynomials, begun where two legs meet: in that place
        of both ``which`` is given, or that the third leg misses least (-1)."""
        places = self._meetings(x, phi)[1]
        misses = [np.abs(self._run("misses", x, np.cos(phi), np.sin(phi), *place)[:3]).sum(axis=0) for place in places]
        second = np.where(which < 0, ~(misses[0] <= misses[1]), which == 1)
        return self._newton(x, np.stack([phi, *np.where(second, places[1], places[0])]), SETTLED)[0]

    def _newton(self, x: Array, pose: Array, steps: int) -> tuple[Array, NDArray[np.bool_]]:
        """Angle and place, (3, n), after some steps of Newton's method; and where these have come to an end."""
        pose, turn = pose.copy(), np.full(pose.shape[1], np.inf)
        for _ in range(steps):
            found = self._run("misses", x, np.cos(pose[0]), np.sin(pose[0]), *pose[1:])
            with np.errstate(all="ignore"):
                step = (inverted(found[3:].reshape(3, 3, -1)) * found[:3]).sum(axis=1)
            turn = np.where(np.isfinite(step).all(axis=0), np.abs(step).max(axis=0), np.inf)
            pose[:, turn < NEAR] -= step[:, turn < NEAR]
        return pose, turn < SURE

    def _meetings(self, x: Array, phi: Array) -> tuple[Rows, list[Array]]:
        """Which two legs tell most of the platform's place at angles (n,), (2, n), and both places where they meet."""
        found = self._run("misses", x, np.cos(phi), np.sin(phi), 0.0, 0.0)
        return meetings(found[:3], found[3:].reshape(3, 3, -1)[:, 1:], self.platform.circles)

    @cached_property
    def _stages(self) -> dict[str, Stage]:
        programs = {name: getattr(self.platform, name) for name in ("polynomial", "slope", "place", "rooms", "misses")}
        return {
            name: Stage(one.block, self.parameters, range(len(one.outputs)), BOXES) for name, one in programs.items()
        }

    def _over(self, name: str, x: list[AffineForm], which: Rows | None, *pose: AffineForm) -> list[AffineForm]:
        """A program's rows over some of the cells."""
        some = x if which is None else [one.select(which) for one in x]
        return self._stages[name]([*some, *pose].__getitem__)

    def sets(self, x: list[AffineForm]) -> tuple[Rows, Rows, list[AffineForm], AffineForm]:
        """Sets of poses over cells, in pieces: of which cell each piece is, of which set; cosine, sine, x and y, which
        hold all of its poses; the set's room.

        Where as many poses are proven in a stretch of angles as it can hold they are sets by themselves.
        """
        values = [self._over("polynomial", x, None, *_axis(phi))[0] for phi in ANGLES]
        polynomials = Polynomials(values, lambda which, phi: self._over("slope", x, which, *_axis(phi)))
        told = stretches(polynomials)
        of, phi, pose, most, proven = self._proven(x, polynomials.value)
        stretch = _stretch_of(told, of, phi, proven)
        number = np.bincount(stretch[stretch >= 0], minlength=told.of.size)
        complete = (number == told.most) & (number > 0) & ~_shared(stretch, most, told.of.size)
        own = in_whole(stretch, complete)
        rest = told.select(~complete)
        piece, others = self._pieces_of_poses(x, rest)
        sets = [joined_forms([one.select(own), other]) for one, other in zip(pose, others, strict=True)]
        which, room = np.append(np.arange(own.size), own.size + piece), rest.room.select(piece)
        return np.append(of[own], rest.of[piece]), which, sets, joined_forms([AffineForm(np.ones(own.size)), room])

    def _proven(
        self, x: list[AffineForm], coefficients: Array
    ) -> tuple[Rows, Array, list[AffineForm], tuple[Array, Array], NDArray[np.bool_]]:
        """Poses near those in the middles of cells, where the polynomials have coefficients (7, n): of which cell each
        is, its angle there, its forms, its bounds of angle, x and y, and whether it is the only one within these."""
        phi, _, which = zeros_between(coefficients)
        slot, of = np.nonzero(np.isfinite(phi))
        pose = self.settled(_middles(x)[:, of], phi[slot, of], which[slot, of])

        def posed(off: list[AffineForm]) -> list[AffineForm]:
            return [
                *cosine_and_sine(pose[0], off[0]),
                *(AffineForm(row) + more for row, more in zip(pose[1:], off[1:], strict=True)),
            ]

        away, proven = solved(lambda off: self._over("misses", x, of, *posed(off)), 3, of.size)
        ends = np.array([one.bounds for one in away]) + pose[:, None]
        return of, pose[0], posed(away), (ends[:, 0], ends[:, 1]), proven

    def _pieces_of_poses(self, x: list[AffineForm], told: Stretches) -> tuple[Rows, list[AffineForm]]:
        """Pieces of all poses in stretches of angles: of which stretch each is, and its forms. Two legs meet in two
        places at an angle; the third may leave both."""
        count = np.where(told.half < WIDE, np.clip(np.ceil(told.half / FINE), 1, PIECES), 1).astype(int)
        stretch, part = np.repeat(np.arange(told.of.size), count), numbered(count)
        half = (told.half / count)[stretch]
        phi = told.middle[stretch] + half * (2 * part + 1 - count[stretch])
        rooms = self._over(
            "rooms", x, told.of[stretch], *cosine_and_sine(phi, AffineForm(np.zeros(phi.size), rest=half))
        )
        some = np.all([np.ones(phi.size, dtype=bool), *(one.bounds[1] >= 0 for one in rooms)], axis=0)
        stretch, phi, half = stretch[some], phi[some], half[some]
        of, axis = told.of[stretch], cosine_and_sine(phi, AffineForm(np.zeros(phi.size), rest=half))
        # By Cramer's rule: without bound where both places may be poses.
        only = self._over("place", x, of, *axis)
        legs, starts = self._meetings(_middles(x)[:, of], phi)
        found, which = [], []
        for start in starts:
            place = self._about(x, of, axis, legs, start, only)
            misses = self._over("misses", x, of, *axis, *place)[:3]
            zero = np.all([(one.bounds[0] <= 0) & (one.bounds[1] >= 0) for one in misses], axis=0)
            kept = np.flatnonzero(zero & _overlap(place, only) & np.isfinite(start[0]))
            found.append([one.select(kept) for one in (*axis, *place)])
            which.append(stretch[kept])
        return np.concatenate(which), [joined_forms(list(pair)) for pair in zip(*found, strict=True)]

    def _about(
        self,
        x: list[AffineForm],
        of: Rows,
        axis: tuple[AffineForm, ...],
        legs: Rows,
        start: Array,
        only: list[AffineForm],
    ) -> list[AffineForm]:
        """The place where two legs meet near a start; where that isn't proven, what is known besides."""

        def posed(off: list[AffineForm]) -> list[AffineForm]:
            return [AffineForm(row) + more for row, more in zip(start, off, strict=True)]

        def equations(off: list[AffineForm]) -> list[AffineForm]:
            found = self._over("misses", x, of, *axis, *posed(off))
            rows = [found[:3], found[4::3], found[5::3]]  # what the legs miss, its slopes by x and by y
            miss, *slopes = ([_chosen(row, leg) for leg in legs] for row in rows)
            return [*miss, *(slope[k] for k in range(2) for slope in slopes)]

        away, proven = solved(equations, 2, of.size)
        return [
            AffineForm(*np.where(proven, one.parts(of.size), other.parts(of.size)))
            for one, other in zip(posed(away), only, strict=True)
        ]


def _axis(phi: Array | float) -> list[AffineForm]:
    """Cosine and sine."""
    return [AffineForm(part, rest=UNIT) for part in (np.cos(phi), np.sin(phi))]


def _chosen(forms: list[AffineForm], which: Rows) -> AffineForm:
    """Of forms (n,) one each."""
    parts = np.stack([one.parts(which.size) for one in forms])
    return AffineForm(*parts[which, :, np.arange(which.size)].T)


def _middles(x: list[AffineForm]) -> Array:
    return np.stack([np.broadcast_to(one.value, x[0].value.shape) for one in x])


def _overlap(place: list[AffineForm], other: list[AffineForm]) -> NDArray[np.bool_]:
    """Where enclosures of x and y have something in common."""
    ends = [(a.bounds, b.bounds) for a, b in zip(place, other, strict=True)]
    return np.asarray(np.all([(a[0] <= b[1]) & (b[0] <= a[1]) for a, b in ends], axis=0))


def in_whole(stretch: Rows, complete: NDArray[np.bool_]) -> Rows:
    """Which poses are in a stretch whose poses are all proven; those numbered -1 are in none, and there may be none."""
    inside = np.flatnonzero(stretch >= 0)
    return inside[complete[stretch[inside]]]


def _stretch_of(told: Stretches, of: Rows, phi: Array, proven: NDArray[np.bool_]) -> Rows:
    """In which stretch each proven pose lies, by its cell and angle: (n,), -1 where in none."""
    order = np.argsort(told.of, kind="stable")
    first = np.searchsorted(told.of[order], of)
    count = np.searchsorted(told.of[order], of, side="right") - first
    found = np.full(of.size, -1)
    for k in range(int(count.max(initial=0))):
        row = order[np.minimum(first + k, order.size - 1)]
        within = (phi - told.low[row]) % (2 * np.pi) <= told.high[row] - told.low[row]
        found[proven & (k < count) & within] = row[proven & (k < count) & within]
    return found


def _shared(stretch: Rows, bounds: tuple[Array, Array], count: int) -> NDArray[np.bool_]:
    """In which of some stretches poses may be the same one, as their bounds overlap: (count,)."""
    found = np.zeros(count, dtype=bool)
    order, (low, high) = np.argsort(stretch, kind="stable"), bounds
    for step in range(1, MOST):
        one, other = order[:-step], order[step:]
        turns = np.zeros((3, one.size))
        turns[0] = 2 * np.pi * whole_turns(low[0, other], low[0, one])
        both = (stretch[one] == stretch[other]) & (stretch[one] >= 0)
        meet = (low[:, one] <= high[:, other] + turns) & (low[:, other] + turns <= high[:, one])
        found[stretch[one][both & meet.all(axis=0)]] = True
    return found
