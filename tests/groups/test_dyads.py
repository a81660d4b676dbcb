"""Every registered dyad, found by its signature: closed form, Newton twin, rates, equilibrium."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from helpers.differences import derivative
from linkwright.elements import InnerLine, InnerPin, OuterLine, OuterPin
from linkwright.groups import REGISTRY, Dyad
from linkwright.groups.dyad import register
from linkwright.notation import Body, Jet, Pair, Vec, Wrench

TOLERANCE = 1e-12
ORDER = 3

size = st.floats(-2.0, 2.0)
angle = st.floats(-3.1, 3.1)
length = st.floats(0.2, 2.0)


@dataclass(frozen=True)
class Course:
    """A polynomial in time, of any derivative."""

    coefficients: tuple[float, ...]

    def jet(self, t: float, order: int) -> list[float]:
        p = np.polynomial.Polynomial(self.coefficients)
        return [float(p.deriv(k)(t)) if k else float(p(t)) for k in range(order + 1)]


@dataclass(frozen=True)
class Pose:
    """A link as it is placed: origin and angle."""

    x: float
    y: float
    angle: float

    def local(self, at: Pair) -> Pair:
        dx, dy = at.x - self.x, at.y - self.y
        c, s = math.cos(self.angle), math.sin(self.angle)
        return Pair(c * dx + s * dy, c * dy - s * dx)

    def heading(self, world: float) -> Pair:
        return Pair(math.cos(world - self.angle), math.sin(world - self.angle))


@dataclass(frozen=True)
class Example:
    """A dyad with a pose that closes it at t = 0, on bases that move: outer joints and inner joint by letter."""

    signature: str
    poses: tuple[Pose, Pose]
    at: tuple[Pair, Pair]
    ways: tuple[float, float]  # headings of the outer lines
    courses: tuple[tuple[Course, Course, Course], tuple[Course, Course, Course]]
    meeting: tuple[Pair, Pair]  # the inner joint's point on each link; the same for a pin
    inner_way: float

    def dyad(self, t: float, order: int = ORDER) -> Dyad:
        joints = [self.outer(i, t, order) for i in (0, 1)]
        (a, b), (pa, pb) = self.poses, self.meeting
        inner: Any
        if self.signature[1] == "R":
            inner = InnerPin(a.local(pa), b.local(pb))
        else:
            inner = InnerLine(a.local(pa), a.heading(self.inner_way), b.local(pb), b.heading(self.inner_way))
        return REGISTRY[self.signature](joints[0], inner, joints[1])

    def outer(self, i: int, t: float, order: int) -> Any:
        """The joint on its base, which moves by small polynomials from its place at t = 0."""
        x, y, turn = (course.jet(t, order) for course in self.courses[i])
        at, way, pose = self.at[i], self.ways[i], self.poses[i]
        base = Vec(Jet([x[0] + at.x, *x[1:]]), Jet([y[0] + at.y, *y[1:]]))
        if self.signature[2 * i] == "R":
            return OuterPin(base, pose.local(at))
        jet = Jet([turn[0] + way, *turn[1:]])
        return OuterLine(base, Vec(jet.cos(), jet.sin()), jet.rate(), pose.local(at), pose.heading(way))


@st.composite
def examples(draw: Any, signature: str) -> Example:
    def pair() -> Pair:
        return Pair(draw(size), draw(size))

    def course() -> Course:
        return Course((0.0, *(draw(st.floats(-0.5, 0.5)) for _ in range(3))))

    poses = tuple(Pose(draw(size), draw(size), draw(angle)) for _ in range(2))
    courses = tuple(tuple(course() for _ in range(3)) for _ in range(2))
    meeting, inner_way = pair(), draw(angle)
    step = draw(size)
    other = meeting
    if signature[1] == "P":
        other = Pair(meeting.x + step * math.cos(inner_way), meeting.y + step * math.sin(inner_way))
    ways = (draw(angle), draw(angle))
    return Example(signature, poses, (pair(), pair()), ways, courses, (meeting, other), inner_way)  # type: ignore[arg-type]


def coordinates(dyad: Dyad, branch: float) -> Any:
    root = dyad.root(branch)
    return root.first, root.second


def places(bodies: tuple[Body, Body]) -> np.ndarray:
    """Both links' axes and two points of each."""
    rows = []
    for body in bodies:
        rows += [*body.axis.now, *body.point(Pair(0.3, -0.7)).now, *body.point(Pair(0.0, 0.0)).now]
    return np.array(rows, dtype=float)


def built(example: Example) -> np.ndarray:
    """The same rows from the pose that the example was made of."""
    rows: list[float] = []
    for pose in example.poses:
        c, s = math.cos(pose.angle), math.sin(pose.angle)
        rows += [c, s, pose.x + 0.3 * c + 0.7 * s, pose.y + 0.3 * s - 0.7 * c, pose.x, pose.y]
    return np.array(rows)


def usable(dyad: Dyad, branch: float, least: float = 0.01) -> bool:
    """Whether the closed form stands and the normalised determinant is over ``least``."""
    try:
        with np.errstate(all="ignore"):
            determinant = float(dyad.solve(branch, 0).determinant)
    except (ZeroDivisionError, ValueError):
        return False
    return abs(determinant) > least


def branches(signature: str) -> tuple[float, ...]:
    return (1.0, -1.0) if REGISTRY[signature].rules else (1.0,)


def each(count: int = 40) -> Any:
    """Run a test for every dyad in the registry, drawing inside it, as the example depends on the signature."""

    def mark(test: Any) -> Any:
        drawn = settings(max_examples=count)(given(data=st.data())(test))
        return pytest.mark.parametrize("signature", sorted(REGISTRY))(drawn)

    return mark


def distances(example: Example) -> float:
    """The shortest length that the group's closed form divides by."""
    (a, b), (pa, pb) = example.at, example.meeting
    arms = []
    if example.signature[1] == "R":
        arms += [math.dist(a, pa)] if example.signature[0] == "R" else []
        arms += [math.dist(b, pb)] if example.signature[2] == "R" else []
    if example.signature in ("RRR", "RPR"):
        arms.append(math.dist(a, b))
    return min(arms, default=1.0)


def draw_usable(data: Any, signature: str, least: float = 0.01) -> tuple[Example, Dyad, float]:
    """An example away from a singular pose, with no arm very short against the others, and a branch of it."""
    example = data.draw(examples(signature))
    assume(distances(example) > 0.3)
    dyad, branch = example.dyad(0.0), data.draw(st.sampled_from(branches(signature)))
    assume(usable(dyad, branch, least))
    return example, dyad, branch


@each()
def test_one_branch_is_the_pose_that_it_was_made_of(signature: str, data: Any) -> None:
    example, dyad, _ = draw_usable(data, signature)
    found = [places(_bodies(dyad, branch)) for branch in branches(signature) if usable(dyad, branch)]
    assume(found)
    assert min(np.abs(rows - built(example)).max() for rows in found) < 1e-9


def _bodies(dyad: Dyad, branch: float) -> tuple[Body, Body]:
    solved = dyad.solve(branch, 0)
    return solved.first, solved.second


@each(100)
def test_closed_form_agrees_with_newton(signature: str, data: Any) -> None:
    """To 1e-12 of the pose's extent, wherever the normalised determinant is over 0.01."""
    _, dyad, branch = draw_usable(data, signature)
    bodies = _bodies(dyad, branch)
    nudge = data.draw(st.floats(-1e-3, 1e-3))
    start = tuple(_nudged(q, nudge) for q in coordinates(dyad, branch))
    twin = dyad.newton(start)
    extent = max(1.0, np.abs(places(bodies)).max())
    assert np.abs(places(twin) - places(bodies)).max() < TOLERANCE * extent


def _nudged(q: Any, by: float) -> Any:
    return q.rotated(Pair(math.cos(by), math.sin(by))) if isinstance(q, Pair) else q + by


@each()
def test_closure_holds_at_the_root(signature: str, data: Any) -> None:
    _, dyad, branch = draw_usable(data, signature)
    a, b = _bodies(dyad, branch)
    gaps = [abs(float(gap.d[0])) for gap in dyad.inner.gap(a, b)]
    extent = max(1.0, np.abs(places((a, b))).max())
    assert max(gaps) < TOLERANCE * extent
    assert all(abs(math.hypot(*body.axis.now) - 1.0) < TOLERANCE for body in (a, b))


@each()
def test_determinant_is_normalised(signature: str, data: Any) -> None:
    _, dyad, branch = draw_usable(data, signature, least=0.0)
    assert abs(float(dyad.solve(branch, 0).determinant)) <= 1.0 + 1e-12


@each()
def test_the_other_branch_is_the_other_mode(signature: str, data: Any) -> None:
    _, dyad, _ = draw_usable(data, signature, least=0.05)
    if len(branches(signature)) < 2:
        assert np.array_equal(places(_bodies(dyad, 1.0)), places(_bodies(dyad, -1.0)))
        return
    one, two = (dyad.solve(branch, 0) for branch in (1.0, -1.0))
    assert float(one.determinant) * float(two.determinant) < 0.0
    assert np.abs(places((one.first, one.second)) - places((two.first, two.second))).max() > 1e-3
    gaps = dyad.inner.gap(two.first, two.second)
    assert max(abs(float(gap.d[0])) for gap in gaps) < 1e-11


@each(25)
def test_rates_are_the_derivatives_of_the_root(signature: str, data: Any) -> None:
    """Each order against differences of the order below, the bases moving: 1e-7 where the determinant is over 0.3."""
    example, _, branch = draw_usable(data, signature, least=0.3)

    def rows(t: float, k: int) -> np.ndarray:
        solved = example.dyad(t).solve(branch, ORDER)
        found = []
        for body in (solved.first, solved.second):
            vectors = (body.axis, body.point(Pair(0.3, -0.7)), body.anchor)
            found += [float(jet.d[k]) for vector in vectors for jet in vector]
        return np.array(found)

    for k in range(ORDER):
        slopes = derivative(lambda t, k=k: rows(t, k), 0.0, 1e-3)
        exact = rows(0.0, k + 1)
        assert np.abs(slopes - exact).max() < 1e-7 * max(1.0, np.abs(exact).max())


@each(30)
def test_turn_is_the_rate_of_the_axis(signature: str, data: Any) -> None:
    _, dyad, branch = draw_usable(data, signature, least=0.1)
    solved = dyad.solve(branch, ORDER)
    for body in (solved.first, solved.second):
        (c, s), (c1, s1) = body.axis.now, (body.axis.x.d[1], body.axis.y.d[1])
        assert math.isclose(c * s1 - s * c1, body.turn.d[0], rel_tol=1e-12, abs_tol=1e-12)


@each()
def test_balance_leaves_no_work_on_the_freedoms(signature: str, data: Any) -> None:
    """With the inner reaction on both links, no outer freedom sees a generalised force; the reaction fits its joint."""
    _, dyad, branch = draw_usable(data, signature, least=0.05)
    solved = dyad.solve(branch, 0)

    def wrench() -> Wrench:
        return Wrench(Pair(data.draw(size), data.draw(size)), data.draw(size), Pair(data.draw(size), data.draw(size)))

    first, second = wrench(), wrench()
    inner = dyad.balance(solved, first, second)
    works = (solved.twists[0].work(first.plus(inner)), solved.twists[1].work(second.plus(inner.opposite)))
    scale = 1.0 + math.hypot(*inner.force) + abs(inner.moment)
    assert max(abs(float(work)) for work in works) < 1e-11 * scale
    if isinstance(dyad.inner, InnerPin):
        at = solved.first.point(dyad.inner.first).now
        assert abs(inner.at(at).moment) < 1e-11 * scale
    else:
        assert isinstance(dyad.inner, InnerLine)
        along = solved.first.direction(dyad.inner.first_heading).now
        assert abs(along.dot(inner.force)) < 1e-11 * scale


def test_all_five_kinds_are_there() -> None:
    assert {"RRR", "RRP", "RPR", "PRP", "RPP"} <= set(REGISTRY)


def test_a_second_dyad_of_one_signature_is_refused() -> None:
    with pytest.raises(ValueError, match="registered twice"):
        register(REGISTRY["RRR"])


@each(40)
def test_shortfall_tells_where_the_group_cannot_close(signature: str, data: Any) -> None:
    """``shortfall``, a negative ``reach`` and ``radicand`` agree; links a tenth shorter or longer may not close."""
    example = data.draw(examples(signature))
    assume(distances(example) > 0.05)
    stretch = data.draw(st.sampled_from((0.3, 1.0, 3.0)))
    (pa, pb), a = example.meeting, example.poses[0]
    moved = Pair(a.x + stretch * (pa.x - a.x) + stretch - 1.0, pa.y)
    other = Example(
        example.signature, example.poses, example.at, example.ways, example.courses, (moved, pb), example.inner_way
    )
    dyad = other.dyad(0.0)
    try:
        with np.errstate(all="ignore"):
            reach = float(dyad.root(1.0).reach)
    except ZeroDivisionError:
        return
    assume(abs(reach) > 1e-9)
    shortfall = dyad.shortfall()
    assert (shortfall is not None) == (reach < 0)
    assert (float(1.0 if (room := dyad.radicand()) is None else room) < 0) == (reach < 0)
    if shortfall is not None:
        assert shortfall[0] != shortfall[1]


@pytest.mark.parametrize("short", [pytest.param(0, id="first"), pytest.param(1, id="second")])
def test_a_very_short_link_keeps_its_digits(short: int) -> None:
    """Two pinned links, one a thousandth of the other: the unit vectors of both stay so to 1e-12."""
    arms = (1e-3, 1.0) if short == 0 else (1.0, 1e-3)
    for way in np.linspace(0.2, 2.9, 20):
        still = [Vec.constant(Pair(x, 0.0), 0) for x in (0.0, math.hypot(1.0 + 1e-3 * math.cos(way), 1e-3))]
        inner = InnerPin(Pair(arms[0], 0.0), Pair(arms[1], 0.0))
        dyad = REGISTRY["RRR"](OuterPin(still[0], Pair(0.0, 0.0)), inner, OuterPin(still[1], Pair(0.0, 0.0)))
        if not usable(dyad, 1.0, 0.1):
            continue
        a, b = _bodies(dyad, 1.0)
        assert all(abs(math.hypot(*body.axis.now) - 1.0) < 1e-12 for body in (a, b))
        assert max(abs(float(gap.d[0])) for gap in dyad.inner.gap(a, b)) < 1e-12
