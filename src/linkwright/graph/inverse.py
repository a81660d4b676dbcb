"""A mechanism turned round: its drives are free, and two slides carry one of its points to any place (x, y).

The links fall apart into groups again, hung on the frame and on the point. Where all of these are dyads, every pose in
which the point is at a place is one choice of their branches, in closed form. Of a triad the platform's angle is a root
of a polynomial (:mod:`linkwright.graph.triads`), at most one of six; all else follows from it in closed form. So the
inverse kinematics is exhaustive (J.-P. Merlet, Parallel Robots, 2nd ed. 2006, ch. 3). What tells whether a pose is one
of an assembly mode are signs: of what stands under the roots of those dyads (``radicand``: the pose exists), and of the
determinants of the mechanism's own groups in the pose (``closure``: the mode).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from copy import copy
from functools import cached_property
from typing import Any

from linkwright.data_classes import dataclass
from linkwright.elements.points import AXES
from linkwright.graph.geometry import Geometry
from linkwright.graph.graph import Graph
from linkwright.graph.legs import triad
from linkwright.graph.motion import Motion, known_determinant, solve_step
from linkwright.graph.program import Program
from linkwright.graph.rows import Radicand
from linkwright.graph.triads import TriadSystem, place_links
from linkwright.model.mechanism import FRAME, Drive, Joint, Link, Mechanism
from linkwright.notation import Body, Jet, Pair, Scalar
from linkwright.structure import Group, HigherGroup, Structure, decompose
from linkwright.symbols import ExpressionStage, Symbol, as_symbol, derivatives_along, jacobian, symbols_of

TRIADS = 1
"""With more the poses would be too many to enclose."""


@dataclass(frozen=True)
class Platform:
    """What tells the poses of a triad's platform. Its programs have the inputs of all poses, of which four are this
    one's cosine, sine, x and y.

    ``polynomial`` vanishes at its angles; ``slope`` is that and its derivative by the angle; ``place`` is x and y where
    it vanishes; of ``rooms`` none is negative at a pose's angle; ``misses`` is what the three legs miss at any pose (m2
    or m), and row by row the derivatives by angle, x and y. The first legs, so many, move on ``circles``."""

    circles: int
    polynomial: Program
    slope: Program
    place: Program
    rooms: Program
    misses: Program


@dataclass(frozen=True)
class DeterminantRow:
    """A row of the inverse: the determinant of one of the mechanism's own groups, whose sign tells the mode."""

    group: str

    @property
    def label(self) -> str:
        """What it is called among the program's outputs."""
        return f"closure:{self.group}"


@dataclass(frozen=True)
class DriveValue:
    """A row of the inverse: the ``cos`` or ``sin`` of a drive's angle, or its ``travel`` (m)."""

    drive: str
    part: str

    @property
    def label(self) -> str:
        """What it is called among the program's outputs."""
        return f"{self.drive}:{self.part}"


@dataclass(frozen=True)
class Inverse:
    """The poses in which a point is at a place.

    ``groups`` are the dyads with a root of the mechanism turned round, in the order of their branches, ``triads`` its
    triads, each after those that it hangs on; ``modes`` the mechanism's own groups with two assembly modes; ``drives``
    its drives.
    """

    graph: Graph
    structure: Structure
    groups: tuple[Group, ...]
    triads: tuple[HigherGroup, ...]

    @property
    def modes(self) -> tuple[Group, ...]:
        """The mechanism's own groups with two assembly modes."""
        return self.graph.branched

    @property
    def drives(self) -> tuple[str, ...]:
        """Its drives."""
        return self.graph.drives

    def turns(self, drive: str) -> bool:
        """Whether a drive's value is an angle."""
        return bool(self.graph.structure.topology.mechanism.prescribed(drive).turns)

    def branches(self) -> list[tuple[float, ...]]:
        """All choices of branches: of a cylinder the one in which its length isn't negative."""
        cylinders = self.structure.topology.mechanism.cylinders
        found: list[tuple[float, ...]] = [()]
        for group in self.groups:
            options = (group.front,) if group.inner.joint in cylinders else (1.0, -1.0)
            found = [(*one, sign) for one in found for sign in options]
        return found

    @cached_property
    def rows(self) -> tuple[Radicand | DeterminantRow | DriveValue, ...]:
        """The rows of the program: rooms (m^2), closures, then of each drive its cosine and sine or its travel (m)."""
        parts = ((drive, ("cos", "sin") if self.turns(drive) else ("travel",)) for drive in self.drives)
        return (
            *(Radicand(group.label) for group in self.groups),
            *(DeterminantRow(group.label) for group in self.modes),
            *(DriveValue(drive, part) for drive, own in parts for part in own),
        )

    @cached_property
    def _symbols(self) -> tuple[list[Symbol], list[Symbol], list[Symbol], list[TriadSystem]]:
        """The inputs (x and y of the place, the branches, each platform's cosine, sine, x and y), the parameters, the
        rows, and the triads' systems."""
        place, signs = Symbol.several("place", 2), [Symbol.named(group.label) for group in self.groups]
        poses = [Symbol.several(higher_group.label, 4) for higher_group in self.triads]
        values = [Symbol.named(name) for name in self.graph.parameters]
        quantities = copy(self.graph.quantities)
        quantities.mechanism = self.structure.topology.mechanism
        geometry = Geometry(quantities, dict(zip(self.graph.parameters, values, strict=True)))
        drives = {axis: Jet([place[k]]) for k, axis in enumerate(AXES)}
        chosen = dict(zip(self.groups, signs, strict=True))
        motion = Motion(self.structure, geometry, 0, {FRAME: Body.fixed(0)})
        systems: list[TriadSystem] = []
        for step in self.structure.steps:
            if isinstance(step, HigherGroup):
                systems.append(_hung(motion, step, poses[len(systems)]))
            else:
                solve_step(motion, step, drives, lambda group, _: chosen.get(group, 1.0), _no_higher_groups)
        rows = symbols_of(self._rows(motion))
        return [*place, *signs, *(symbol for pose in poses for symbol in pose)], values, rows, systems

    def _rows(self, motion: Motion) -> Iterator[Scalar]:
        for group in self.groups:
            yield motion.dyads[group][0].radicand()
        own = Motion(self.graph.structure, motion.geometry, 0, motion.bodies)
        for group in self.modes:
            yield known_determinant(own, group)
        topology = self.graph.structure.topology
        for name in self.drives:
            drive = topology.mechanism.prescribed(name)
            yield from (
                own.drive_axis(drive)
                if drive.turns
                else own.slide_value(drive, topology.drivable_joints(name)[0].joint).d[:1]
            )

    @cached_property
    def program(self) -> Program:
        """The :attr:`rows` of inputs x, y (m), the branches, and each platform's cosine, sine, x and y."""
        return self._program(self._symbols[2], tuple(row.label for row in self.rows))

    @cached_property
    def platforms(self) -> tuple[Platform, ...]:
        """Of each triad what tells the poses of its platform."""
        x, _, _, systems = self._symbols
        found = []
        for k, system in enumerate(systems):
            row = 2 + len(self.groups) + 4 * k
            c, s, *at = (x[row + i] for i in range(4))
            polynomial = as_symbol(system.polynomial(c, s))
            misses = symbols_of(system.misses(c, s, Pair(*at)))
            by_turning = _by_turning([polynomial, *misses], c, s)
            slopes = [[turned, *of_row] for turned, of_row in zip(by_turning[1:], jacobian(misses, at), strict=True)]
            rows: dict[str, Sequence[Scalar]] = {
                "polynomial": [polynomial],
                "slope": [polynomial, by_turning[0]],
                "place": system.place(c, s),
                "rooms": system.rooms(c, s),
                "misses": [*misses, *(slope for of_row in slopes for slope in of_row)],
            }
            programs = {name: self._numbered(name, some) for name, some in rows.items()}
            found.append(Platform(len(system.circles), **programs))
        return tuple(found)

    @cached_property
    def slopes(self) -> Program:
        """The derivatives of the :attr:`rows` by x, then those by y, where there are dyads alone."""
        x, _, rows, _ = self._symbols
        names = [f"d({row.label})/d({axis})" for axis in AXES for row in self.rows]
        slopes = jacobian(rows, x[:2])
        return self._program([of_row[k] for k in range(2) for of_row in slopes], tuple(names))

    def _numbered(self, name: str, rows: Sequence[Scalar]) -> Program:
        return self._program(rows, tuple(f"{name}:{i}" for i in range(len(rows))))

    def _program(self, rows: Sequence[Scalar], names: tuple[str, ...]) -> Program:
        x, p, *_ = self._symbols
        inputs = [*AXES, *(f"branch:{group.label}" for group in self.groups)]
        inputs += [f"{higher_group.label}:{part}" for higher_group in self.triads for part in ("cos", "sin", "x", "y")]
        return Program((), ExpressionStage(x, p, rows), tuple(inputs), self.graph.parameters, names)


def _by_turning(rows: Sequence[Symbol], c: Symbol, s: Symbol) -> list[Symbol]:
    """The derivatives of rows of a cosine and a sine by their angle."""
    return derivatives_along(rows, {c: -s, s: c})


def _no_higher_groups(_: Any) -> list[Scalar]:
    raise AssertionError("no other groups")


def _hung(motion: Motion, higher_group: HigherGroup, pose: Any) -> TriadSystem:
    """A triad, its links placed as its platform's pose has it."""
    shape = triad(motion, higher_group, {})
    assert shape is not None
    system, (c, s, x, y) = TriadSystem(motion, shape), (pose[i] for i in range(4))
    place_links(motion, system, Body.still(Pair(x, y), system.reference, Pair(c, s)))
    return system


def inverse(graph: Graph, point: str) -> Inverse | None:
    """The mechanism of a graph turned round at one of its points; ``None`` where it falls apart into other groups than
    dyads and one triad, or into none."""
    structure = decompose(guided_mechanism(graph.structure.topology.mechanism, point))
    if structure.findings or graph.structure.higher_groups or len(structure.higher_groups) > TRIADS:
        return None
    motion = Motion(structure, Geometry(graph.quantities, {}), 0)
    shapes = [triad(motion, higher_group, {}) for higher_group in structure.higher_groups]
    if not all(shape is not None and all(any(leg.turning) for leg in shape.legs) for shape in shapes):
        return None
    groups = tuple(group for group in structure.groups if group.modes > 1)
    return Inverse(graph, structure, groups, structure.higher_groups)


def guided_mechanism(mechanism: Mechanism, point: str) -> Mechanism:
    """A mechanism whose drives are free, and one of whose points two slides carry: along x, and on that along y."""
    taken = {*mechanism.links, *mechanism.joints, *(name for link in mechanism.links.values() for name in link.points)}
    foot, seat, *names = (_unused(name, taken) for name in ("foot", "seat", "along_x", "along_y", "at_x", "at_y"))
    stages, slides = names[:2], names[2:]
    frame = mechanism.links[FRAME]
    links = {**mechanism.links, FRAME: frame.model_copy(update={"points": {**frame.points, **_origin(foot).points}})}
    links |= {stages[0]: _origin(seat), stages[1]: _origin(point)}
    lines = ([f"{foot} at 0 deg", f"{seat} at 0 deg"], [f"{seat} at 90 deg", f"{point} at 90 deg"])
    pairs = ([FRAME, stages[0]], stages)
    joints = {
        slide: Joint.model_validate({"prismatic": pair, "line": line})
        for slide, pair, line in zip(slides, pairs, lines, strict=True)
    }
    drives = {
        axis: Drive.model_validate({"slides": stage, "on": on, "position": 0})
        for axis, (on, stage) in zip(AXES, pairs, strict=True)
    }
    update = {"links": links, "joints": {**mechanism.joints, **joints}, "drives": drives, "assembly": {}}
    return mechanism.model_copy(update=update)


def _unused(name: str, taken: set[str]) -> str:
    while name in taken:
        name += "_"
    return name


def _origin(point: str) -> Link:
    """A link with one point, at its origin."""
    return Link.model_validate({"points": {point: [0, 0]}})
