"""Higher groups: Assur groups of class III and higher, solved by Newton on the same closure equations as dyads.

The links of a higher group form a tree: each is placed on an earlier one by a joint, which has one unknown coordinate
if no drive holds it. The joints that are left close the loops; each gives closure equations, as many in all as there
are coordinates. The coordinates come in as numbers or symbols, solved elsewhere. Rates and equilibrium then follow
from the closure just as for a dyad, by linear systems with a matrix of more than two rows.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from enum import Enum
from functools import partial
from itertools import islice, product
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.elements import STILL, Inner, Twist
from linkwright.graph.geometry import extent
from linkwright.graph.placing import answered, driven_body, inner_joint, outer_joint
from linkwright.groups.linear import Factor
from linkwright.notation import Body, Jet, Pair, Scalar, Vec, Wrench
from linkwright.notation.jets import call
from linkwright.notation.planar import unit_vector
from linkwright.structure import FRAME, Connection, HigherGroup, LinkPlacement

if TYPE_CHECKING:
    from linkwright.graph.motion import Motion, Unknowns


class Beside(Enum):
    """Which forces that come beside the multipliers of closures (:meth:`Inner.besides`) are counted: all, those that
    are there without multipliers, or none, where all forces must be linear."""

    ALL = "all"
    CONSTANT = "constant"
    NONE = "none"


class Balanced(NamedTuple):
    """What a closure does: the wrenches on its links, and the multipliers of its equations (N, of an angle N m)."""

    actions: list[Wrench]
    multipliers: list[Scalar]


@dataclass(frozen=True)
class SolvedHigherGroup:
    """A higher group at its coordinates: what the closures miss, the factored matrix of their slopes, first rates.

    ``fields[i]`` is the motion that a unit rate of coordinate i gives each link; ``twists`` the freedom of each
    link on its own joint.
    """

    gaps: list[Scalar]
    slopes: list[list[Scalar]]
    factor: Factor
    rates: list[list[Scalar]]
    fields: list[dict[str, Twist]]
    twists: dict[str, Twist]
    closures: Closures
    bodies: dict[str, Body]

    def margin(self) -> Scalar:
        """The margin to a singular pose, with the determinant's sign: 0 singular, 1 best; undefined where an equation
        has no slope at all.

        It is sqrt(n) over the Frobenius norm of the inverse of the matrix whose columns have the length 1: a reciprocal
        condition, which passes through zero as the determinant does. Of two equations it is the determinant itself
        (Hadamard's, over the product of its columns' lengths); that of many equations shrinks with their number,
        although no pose is near. One equation alone has no other to be measured against: see :meth:`_alone`.
        """
        n = len(self.slopes)
        if n == 1:
            return self._alone()
        lengths = [sum((row[i] * row[i] for row in self.slopes), 0.0) for i in range(n)]
        determinant = self.factor.determinant()
        if isinstance(determinant, float) and determinant == 0.0:
            return 0.0  # numbers have no inverse there; symbols have one that isn't finite
        inverse: Scalar = 0.0
        for k in range(n):
            answer = self.factor.solve([1.0 if i == k else 0.0 for i in range(n)])
            inverse = inverse + sum((one * one * size for one, size in zip(answer, lengths, strict=True)), 0.0)
        return call("sign", determinant) * math.sqrt(n) / call("sqrt", inverse)

    def _alone(self) -> Scalar:
        """The margin of one equation: the power of its forces on the motion of its coordinate, over that which they
        would have if each pointed the way its place moves. That is the sine of a transmission angle."""
        ((slope,),), ((c, inner),) = self.slopes, self.closures
        most: Scalar = 0.0
        bodies = [self.bodies[link] for link in c.links]
        place = inner.place(bodies)
        for link, anchored in zip(c.links, inner.actions(bodies, [1.0]), strict=True):
            if (twist := self.fields[0].get(link)) is None:
                continue
            wrench = anchored if place is None else anchored.at(place)
            velocity = twist.velocity(wrench.about)
            most = most + call("sqrt", wrench.force.dot(wrench.force) * velocity.dot(velocity))
            most = most + call("abs", wrench.moment * twist.turn)
        return slope / most

    def balance(self, wrenches: dict[str, Wrench], bodies: dict[str, Body], beside: Beside) -> list[Balanced]:
        """Of each closure what keeps all links in equilibrium."""
        multipliers = self._answer(wrenches)
        found = self._actions(multipliers, bodies)
        # Forces that follow from the multipliers and do no work leave these as they are; other closures answer them.
        left, more = multipliers, []
        for c, inner in self.closures:
            follows = left[: c.rows] if beside is Beside.ALL else [0.0] * c.rows
            more.append([] if beside is Beside.NONE else inner.besides([bodies[link] for link in c.links], follows))
            left = left[c.rows :]
        if not any(more):
            return self._balanced(found, multipliers)
        extras: dict[str, Wrench] = {}
        for (c, _), extra in zip(self.closures, more, strict=True):
            for link, wrench in zip(c.links, extra, strict=False):
                extras[link] = extras[link].plus(wrench) if link in extras else wrench
        answering = self._answer(extras)
        answers, total = self._actions(answering, bodies), [a + b for a, b in zip(multipliers, answering, strict=True)]
        actions = [
            [own.plus(answer).plus(extra[k]) if extra else own.plus(answer) for k, (own, answer) in enumerate(pairs)]
            for pairs, extra in (
                (list(zip(a, b, strict=True)), e) for a, b, e in zip(found, answers, more, strict=True)
            )
        ]
        return self._balanced(actions, total)

    def _balanced(self, actions: list[list[Wrench]], left: list[Scalar]) -> list[Balanced]:
        found = []
        for (c, _), wrenches in zip(self.closures, actions, strict=True):
            found.append(Balanced(wrenches, left[: c.rows]))
            left = left[c.rows :]
        return found

    def _answer(self, wrenches: dict[str, Wrench]) -> list[Scalar]:
        """The multipliers of all equations that keep the links in equilibrium under wrenches."""
        works = [
            sum((field[link].work(wrench) for link, wrench in wrenches.items() if link in field), 0.0)
            for field in self.fields
        ]
        return [-m for m in self.factor.solve(works, transposed=True)]

    def _actions(self, left: list[Scalar], bodies: dict[str, Body]) -> list[list[Wrench]]:
        found = []
        for c, inner in self.closures:
            found.append(inner.actions([bodies[link] for link in c.links], left[: c.rows]))
            left = left[c.rows :]
        return found


def solve_higher_group(motion: Motion, step: HigherGroup, drives: dict[str, Jet], unknowns: Unknowns) -> None:
    """Place a higher group's links at its coordinates with all rates."""
    closures = [(c, inner_joint(motion, c, c.links)) for c in step.closures]
    starts = dict(zip(step.free, unknowns(step), strict=True))
    rates: dict[LinkPlacement, list[Scalar]] = {edge: [] for edge in step.free}

    def place_links(next_rate: list[Scalar]) -> None:
        """Place all links in order with the rates known so far."""
        for edge in step.edges:
            if edge.drive is not None:
                motion.bodies[edge.link] = driven_body(motion, edge, drives[edge.drive])[1]
            else:
                motion.bodies[edge.link] = _free(motion, edge, starts[edge], Jet([*rates[edge], *next_rate]))

    # Step 1: place the links at the given coordinates, without rates.
    place_links([])
    # Step 2: how each coordinate moves the links, and from that the matrix of the closure equations. It is factored
    # once and serves all rates, the equilibrium and Newton.
    fields, twists = _fields(motion, step)
    gaps = [gap.d[0] for gap in _gaps(motion, closures, drives)]
    slopes = _slopes(motion, closures, fields)
    factor = Factor(slopes)
    # Step 3: each time derivative of the closure is linear in the highest rates with this same matrix. Set these to
    # zero, see what the equations miss, and solve for them.
    for k in range(1, motion.order + 1):
        place_links([0.0])
        rest = [gap.d[k] for gap in _gaps(motion, closures, drives)]
        for edge, q in zip(step.free, factor.solve(rest), strict=True):
            rates[edge].append(-q)
    # Step 4: place the links once more with all rates.
    place_links([])
    motion.higher_groups[step] = SolvedHigherGroup(
        gaps,
        slopes,
        factor,
        [rates[edge] for edge in step.free],
        fields,
        twists,
        closures,
        {link: motion.bodies[link] for c, _ in closures for link in c.links},
    )


Closures = list[tuple[Connection, Inner]]


def _gaps(motion: Motion, closures: Closures, drives: Mapping[str, Jet]) -> list[Jet]:
    """What the equations of closures miss, with all rates of the bodies."""
    return [gap for c, inner in closures for gap in _gap(motion, c, inner, drives)]


def _gap(motion: Motion, c: Connection, inner: Inner, drives: Mapping[str, Jet]) -> Sequence[Jet]:
    if c.kind.prescribed:
        ((value,), angle) = inner.gap(*(motion.bodies[link] for link in c.links)), c.kind.row_units[0] == "angle"
        missed = value - drives[c.joint]
        if angle and any(motion.bodies[link].angle is None for link in c.links):
            # Of such links the direction alone is known: whole turns don't count.
            turned = missed.d[0]
            missed = Jet([call("arctan2", call("sin", turned), call("cos", turned)), *missed.d[1:]])
        return (missed,)
    return answered(c.kind, c.joint, motion.bodies, lambda bodies: inner.gap(*(bodies[link] for link in c.links)))


def _free(motion: Motion, edge: LinkPlacement, start: Scalar, rates: Jet) -> Body:
    return outer_joint(motion, edge.joint, edge.link).place_at(start, rates)


def _fields(motion: Motion, step: HigherGroup) -> tuple[list[dict[str, Twist]], dict[str, Twist]]:
    """The motion of all links per unit rate of each coordinate; the freedom of each link on its own joint.

    A coordinate on a pin is the link's angle in the frame, so links pinned farther out keep theirs; links on a
    line, or held by a drive, turn with their base.
    """
    twists = {e: outer_joint(motion, e.joint, e.link).twist(motion.bodies[e.link]) for e in step.edges}
    fields: list[dict[str, Twist]] = []
    # Walk along the tree from the known links outward; only links beyond the moved joint move.
    for own in step.free:
        field: dict[str, Twist] = {}
        for edge in step.edges:
            base, anchor = field.get(edge.base, STILL), motion.bodies[edge.link].anchor.now
            # A free pin keeps its link's angle in the frame; a link on a slide or held by a drive turns with its
            # base.
            turn = 0.0 if edge.joint.kind.angular and edge.drive is None else base.turn
            along = base.velocity(anchor)
            # The joint's own freedom comes on top of what its base does.
            if edge is own:
                freedom = twists[edge]
                turn += freedom.turn
                along = Pair(along.x + freedom.along.x, along.y + freedom.along.y)
            if edge is own or edge.base in field:
                field[edge.link] = Twist(turn, anchor, along)
        fields.append(field)
    return fields, {edge.link: twist for edge, twist in twists.items()}


def _slopes(motion: Motion, closures: Closures, fields: list[dict[str, Twist]]) -> list[list[Scalar]]:
    """The slope of each closure's equations to each coordinate; zero where this moves none of its links."""
    rows: list[list[Scalar]] = []
    for c, inner in closures:
        bodies = [motion.bodies[link] for link in c.links]
        columns = [
            inner.rates(bodies, [field.get(link, STILL) for link in c.links])
            if any(link in field for link in c.links)
            else [0.0] * c.rows
            for field in fields
        ]
        rows += [list(row) for row in zip(*columns, strict=True)]
    return rows


def newton(motion: Motion, step: HigherGroup, start: list[float], drives: dict[str, Jet]) -> list[float] | None:
    """The higher group's coordinates on plain numbers by damped Newton from a start nearby; ``None`` where it fails."""
    # Newton needs positions only, so rates are switched off for its duration.
    here, still = list(start), motion.order
    motion.order = 0
    try:
        last = _miss(motion, step, here, drives)
        tiny = TINY * max(1.0, *(abs(float(q)) for body in motion.bodies.values() for q in body.anchor.now))
        for _ in range(40):
            solved = motion.higher_groups[step]
            # Full Newton step, then halve it until the closure error falls enough (Armijo's rule).
            steps = solved.factor.solve(solved.gaps)
            damping = 1.0
            while damping > 1e-4:
                there = [q - damping * s for q, s in zip(here, steps, strict=True)]
                miss = _miss(motion, step, there, drives)
                if miss <= last * (1 - 0.1 * damping) or miss < tiny:
                    break
                damping /= 2
            else:
                return None  # no step helps: a place where the links come near but don't meet
            here, last = there, miss
            # Converged when both the closure error and the step are at round-off.
            if last < tiny and max(map(abs, steps)) < 1e-12:
                return here
        return None
    except np.linalg.LinAlgError:
        return None
    finally:
        motion.order = still


TINY = 1e-13
"""A closure (m, rad) below this is closed; of large mechanisms, below this share of their places."""


def _miss(motion: Motion, step: HigherGroup, unknowns: list[float], drives: dict[str, Jet]) -> float:
    solve_higher_group(motion, step, drives, lambda _: unknowns)
    return math.sqrt(sum(float(gap) ** 2 for gap in motion.higher_groups[step].gaps))


def assemble_higher_group(
    motion: Motion, step: HigherGroup, sketch: dict[str, Pair], drives: dict[str, Jet]
) -> list[float] | None:
    """The coordinates at the start pose, by Newton from the sketched places of the links' points.

    Coordinates that no sketched point tells are tried all round; the solution nearest to the sketch is taken.
    ``None`` where none is found.
    """
    best: tuple[float, list[float]] | None = None
    for start in _starts(motion, step, sketch, drives, _sketch_size(sketch)):
        found = newton(motion, step, start, drives)
        if found is not None and (away := _away(motion, step, sketch)) < (best[0] if best else math.inf):
            best = away, found
            if away < 1e-3 * _sketch_size(sketch):
                break
    if best is not None:
        solve_higher_group(motion, step, drives, lambda _: best[1])
    return best[1] if best else None


def closes_in_a_singular_pose(
    motion: Motion, step: HigherGroup, sketch: dict[str, Pair], drives: dict[str, Jet]
) -> bool:
    """Whether the links close near their sketched places, but in a singular position, at which Newton's steps grow
    without bound: steps by least squares arrive there, halving their error each time as at a double root."""
    size = _sketch_size(sketch)
    still, motion.order = motion.order, 0
    try:
        starts = islice(_starts(motion, step, sketch, drives, size), TRIED)
        return any(_closes_singularly(motion, step, start, drives, size) for start in starts)
    except np.linalg.LinAlgError:
        return False
    finally:
        motion.order = still


def _closes_singularly(
    motion: Motion, step: HigherGroup, start: list[float], drives: dict[str, Jet], size: float
) -> bool:
    """The same from one start, the orders of rates being switched off."""
    here = list(start)
    for _ in range(HALVED_BY_STEPS):
        miss = _miss(motion, step, here, drives)
        solved = motion.higher_groups[step]
        matrix = np.array([[float(entry) for entry in row] for row in solved.slopes])
        gaps = np.array([float(gap) for gap in solved.gaps])
        if not (np.isfinite(matrix).all() and np.isfinite(gaps).all()):
            return False
        here = [q - float(s) for q, s in zip(here, np.linalg.lstsq(matrix, gaps, rcond=1e-9)[0], strict=True)]
    lengths = np.linalg.norm(matrix, axis=0)
    values = np.linalg.svd(matrix / np.where(lengths > 0, lengths, 1.0), compute_uv=False)
    return bool(miss < CLOSES * size and values[-1] < FLAT * values[0])


TRIED = 16
"""So many starts are looked at for that."""
HALVED_BY_STEPS = 60
"""So many halvings bring an error below the root of round-off."""
CLOSES, FLAT = 1e-9, 1e-4
"""Closures that miss by less than this share of the size close; singular values below this share are zero there."""


def assemble_as_drawn(
    motion: Motion, step: HigherGroup, poses: Mapping[str, tuple[float, float, float]], drives: dict[str, Jet]
) -> list[float] | None:
    """The coordinates at the start pose, by Newton from whole poses of the links (m, m, rad)."""
    for link in step.links:
        x, y, angle = poses[link]
        at, axis = Vec.constant(Pair(x, y), 0), Vec.constant(unit_vector(angle), 0)
        motion.bodies[link] = Body(at, Pair(0.0, 0.0), axis, Jet(()), angle)
    start = [outer_joint(motion, edge.joint, edge.link).coordinate(motion.bodies[edge.link]) for edge in step.free]
    found = newton(motion, step, start, drives)
    if found is not None:
        solve_higher_group(motion, step, drives, lambda _: found)
    return found


def drawn_phases(
    motion: Motion, step: HigherGroup, sketch: dict[str, Pair], drives: dict[str, Jet]
) -> dict[str, tuple[float, ...]]:
    """What the closures of a higher group fix once for all, by joint, in the pose that the sketch shows."""
    phased = [c for c in step.closures if c.kind.phased]
    if not phased:
        return {}
    size = _sketch_size(sketch) if sketch else extent(motion.structure.topology, motion.geometry)
    next(_starts(motion, step, sketch, drives, size), None)  # puts the links where they are drawn
    ask = {c: partial(c.kind.phase, motion.geometry, c.joint) for c in phased}
    return {c.joint: answered(c.kind, c.joint, motion.bodies, ask[c]) for c in phased}


SAME = 1e-6
"""Coordinates (rad, or over the mechanism's size) that differ by less are the same."""


def only_coordinates(motion: Motion, step: HigherGroup, drives: dict[str, Jet]) -> list[float] | None:
    """The coordinate at the start pose of a higher group that has one only, where no sketch is needed to choose it:
    Newton from all round always leads to the same. ``None`` where there are several, or none."""
    if len(step.free) > 1:
        return None
    size = extent(motion.structure.topology, motion.geometry)
    (unit,) = step.units(size)
    found: list[float] = []
    for start in _starts(motion, step, {}, drives, size):
        if (solved := newton(motion, step, start, drives)) is not None:
            away = [solved[0] - other for other in found]
            away = [math.remainder(a, 2 * math.pi) for a in away] if step.turning[0] else away
            if all(abs(a) > SAME * unit for a in away):
                found.append(solved[0])
    if len(found) != 1:
        return None
    solve_higher_group(motion, step, drives, lambda _: found)
    return found


TRIES = 64


def _starts(
    motion: Motion, step: HigherGroup, sketch: dict[str, Pair], drives: dict[str, Jet], reach: float
) -> Iterator[list[float]]:
    """Starts for Newton: what the sketch tells, and for the rest every 45 degrees or travels of some ``reach`` (m)."""
    options: list[list[float]] = []
    motion.order, still = 0, motion.order
    for edge in step.edges:
        if edge.drive is not None:
            motion.bodies[edge.link] = driven_body(motion, edge, drives[edge.drive])[1]
            continue
        told = _sketched_coordinate(motion, step, edge, sketch, drives)
        around = [k * math.pi / 4 for k in range(8)]
        if edge.link in motion.geometry.mechanism.turned:
            around = [(math.pi if edge.base == FRAME else 0.0) - angle for angle in around]
        if not edge.joint.kind.angular:
            around = [k * reach / 2 for k in (0, 1, -1, 2, -2)]
        options.append([told] if told is not None else around)
        motion.bodies[edge.link] = _free(motion, edge, options[-1][0], Jet(()))
    motion.order = still
    for start in islice(product(*options), TRIES):
        yield list(start)


def _sketched_coordinate(
    motion: Motion, step: HigherGroup, edge: LinkPlacement, sketch: dict[str, Pair], drives: dict[str, Jet]
) -> float | None:
    """The coordinate that brings the link's points, and those of links that a drive holds on it, nearest to
    their sketched places; ``None`` where there is none to go by."""
    outer = outer_joint(motion, edge.joint, edge.link)
    motion.bodies[edge.link] = _free(motion, edge, 0.0, Jet(()))
    carried = [edge.link]
    for later in step.edges:
        if later.drive is not None and later.base in carried:
            motion.bodies[later.link] = driven_body(motion, later, drives[later.drive])[1]
            carried.append(later.link)
    links = motion.geometry.mechanism.links
    places = [
        (motion.bodies[link].point(motion.point(link, name)).now, sketch[name])
        for link in carried
        for name in links[link].points
        if name in sketch
    ]
    return outer.nearest(places)


def _away(motion: Motion, step: HigherGroup, sketch: dict[str, Pair]) -> float:
    """How far the higher group's points are from their sketched places (m, root of the sum of squares)."""
    links = motion.geometry.mechanism.links
    errors = [
        motion.bodies[link].point(motion.point(link, name)).now.minus(sketch[name])
        for link in step.links
        for name in links[link].points
        if name in sketch
    ]
    return math.sqrt(sum(float(e.dot(e)) for e in errors))


def _sketch_size(sketch: dict[str, Pair]) -> float:
    """The size of a sketch (m)."""
    xs, ys = [float(p.x) for p in sketch.values()], [float(p.y) for p in sketch.values()]
    return math.hypot(max(xs) - min(xs), max(ys) - min(ys)) or math.hypot(xs[0], ys[0]) or 1.0
