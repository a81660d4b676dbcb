"""All assembly modes of a mechanism at given values of its drives.

The groups are solved in order; where one can be put together in several ways, each way is followed on. Dyads have
two modes at most and triads six, all found (:mod:`linkwright.graph.triads`); larger higher groups are searched for by
Newton's method from many starts, so that some mode may be missed.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import field
from functools import partial

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions.units import LENGTH
from linkwright.graph.geometry import Geometry, extent
from linkwright.graph.graph import Graph
from linkwright.graph.higher_groups import newton, solve_higher_group
from linkwright.graph.legs import triad
from linkwright.graph.motion import Motion, solve_motion
from linkwright.graph.search import many_starts
from linkwright.graph.triads import TriadSystem, coordinates, read_coordinates
from linkwright.groups import Dyad
from linkwright.model.quantities import Quantities
from linkwright.notation import MAX_ORDER, Body, Jet
from linkwright.structure import FRAME, Group, HigherGroup, Step, Structure

Array = NDArray[np.float64]
Choice = float | tuple[float, ...]

MOST = 64
"""The most modes that are followed, of mechanisms up to some thirty links; of larger ones fewer."""
CLOSED = 1e-10
"""A closure (over the mechanism's size) below this is closed where Newton's method can't settle: two modes meet."""
SAME, VAGUE = 1e-7, 1e-4
"""Coordinates (rad, or lengths over the size) nearer than this are one mode; the same of singular ones."""


class _DeadEnd(Exception):
    """A group can't be closed behind the choices made so far."""


@dataclass(frozen=True)
class Mode:
    """One way to put the mechanism together.

    ``branches`` of the dyads by label, ``coordinates`` (rad, m) of the higher groups by label, ``places`` (m) of all
    points, ``lines`` of an assembly section that select it: none where only links without a point of their own tell it
    from another mode. ``singular`` where two modes meet in it.
    """

    branches: Mapping[str, float]
    coordinates: Mapping[str, tuple[float, ...]]
    places: Mapping[str, tuple[float, float]]
    bodies: Mapping[str, Body]
    lines: tuple[str, ...]
    singular: bool = False


@dataclass
class FoundModes:
    """The modes of a mechanism, and the labels of the groups of which some mode may be missing.

    ``free_groups`` have outer pins that meet behind some choices: there they may turn, which is no single mode.
    """

    modes: list[Mode] = field(default_factory=list)
    open_groups: list[str] = field(default_factory=list)
    free_groups: set[str] = field(default_factory=set)
    cut: bool = False  # more than MOST

    @property
    def complete(self) -> bool:
        """Whether no mode can be missing."""
        return not (self.open_groups or self.free_groups or self.cut)


class Explorer:
    """Finds the modes of a mechanism at given values of its drives (rad or m)."""

    def __init__(self, quantities: Quantities, structure: Structure, drives: Mapping[str, float]) -> None:
        self.quantities, self.structure = quantities, structure
        self.geometry = Geometry(quantities, quantities.parameters)
        self.values = dict(drives)
        self.drives = {name: Jet([value]) for name, value in drives.items()}
        self.graph = Graph(quantities, structure)
        self.size = extent(structure.topology, self.geometry)
        self.found = FoundModes()
        self.goal: Mapping[str, Body] | None = None
        self.needed = self.step_dependencies()

    def run(self) -> FoundModes:
        """Follow every choice."""
        # Depth-first: each walk follows one list of choices and notes the alternatives it passes.
        self.todo: list[tuple[Choice, ...]] = [()]
        most, walks = min(MOST, max(8, 2000 // len(self.structure.topology.moving))), 0
        while self.todo:
            if len(self.found.modes) >= most or walks >= 4 * most:
                self.found.cut = True
                break
            self.walk(self.todo.pop())
            walks += 1
        return self.found

    def step_dependencies(self) -> dict[Step, frozenset[int]]:
        """The choices, by their numbers, on which the places of each step's known links depend."""
        # Go through the steps in order; a link depends on all choices behind the links that carry it, and on its own
        # step's.
        found: dict[Step, frozenset[int]] = {}
        behind: dict[str, frozenset[int]] = {}
        count = 0
        for step in self.structure.steps:
            bases = {link for c in step.joints for link in (c.a, c.b)} - set(step.links)
            found[step] = frozenset().union(*(behind.get(link, frozenset()) for link in bases))
            after = found[step]
            if step in self.structure.choices:
                after, count = after | {count}, count + 1
            behind |= dict.fromkeys(step.links, after)
        return found

    def dead_end(self, step: Step) -> _DeadEnd:
        """A step can't be closed: nor can it after any choices that agree in what its known links depend on."""
        # Drop all noted walks that would fail the same way: they agree in the choices on which this step depends.
        if self.goal is None:
            same = {i: self.taken[i] for i in self.needed[step]}
            self.todo = [p for p in self.todo if not all(i < len(p) and p[i] == v for i, v in same.items())]
        return _DeadEnd()

    def near(self, bodies: Mapping[str, Body]) -> Mode | None:
        """The mode in which the links have these poses."""
        count, self.goal = len(self.found.modes), bodies
        self.walk(())
        self.goal = None
        return self.found.modes.pop() if len(self.found.modes) > count else None

    def walk(self, chosen: tuple[Choice, ...]) -> None:
        """One mode: the choices given, then the first of each; the others are noted to be walked later."""
        self.chosen, self.singular = chosen, False
        self.taken: list[Choice] = []
        # Solve the whole position; dyads ask for their branch and higher groups for their coordinates.
        self.motion = Motion(self.structure, self.geometry, 0)
        try:
            with np.errstate(all="ignore"):
                solve_motion(self.structure, self.geometry, self.drives, self.branch, self.unknowns, self.motion)
        except (_DeadEnd, ZeroDivisionError, np.linalg.LinAlgError):
            return
        bodies = self.motion.bodies.values()
        if all(math.isfinite(float(v)) for body in bodies for v in (*body.anchor.now, *body.axis.now)):
            self.found.modes.append(self.mode())
        # No finite position: the outer pins of a dyad meet, so that it may turn freely.
        elif free := [g.label for g, (_, solved) in self.motion.dyads.items() if not math.isfinite(solved.determinant)]:
            self.found.free_groups.add(free[0])

    def choose(self, options: list[Choice]) -> Choice:
        """The next choice: one made already, else the first of the options."""
        if len(self.taken) < len(self.chosen):
            choice = self.chosen[len(self.taken)]
        else:
            choice = options[0]
            if self.goal is None:
                self.todo += [(*self.taken, other) for other in reversed(options[1:])]
        self.taken.append(choice)
        return choice

    def branch(self, group: Group, dyad: Dyad) -> float:
        """The branch of a dyad that closes."""
        if dyad.shortfall() is not None:
            raise self.dead_end(group)
        if group.modes == 1:
            return 1.0
        # A dyad at its limit has one mode only (a double root): the mode is singular.
        touching = abs(float(dyad.root(1.0).reach)) < 1e-13
        self.singular = self.singular or touching
        options: list[Choice] = [1.0] if touching else [1.0, -1.0]
        if group.inner.joint in self.structure.topology.mechanism.cylinders:
            options = [group.front]  # no cylinder has a negative length
        # If a given pose is sought, take first the branch whose link points as there.
        elif self.goal is not None and not touching:
            goal = self.goal[group.links[0]].axis.now
            axes = [dyad.solve(sign, 0).first.axis.now for sign in (1.0, -1.0)]
            options = options[:: 1 if axes[0].dot(goal) >= axes[1].dot(goal) else -1]
        branch = self.choose(options)
        assert isinstance(branch, float)
        return branch

    def unknowns(self, higher_group: HigherGroup) -> list[float]:
        """The coordinates of a higher group that closes."""
        known = len(self.taken) < len(self.chosen)
        options: list[Choice] = [] if known else [tuple(u) for u in self.higher_group(higher_group)]
        if not known and not options:
            raise self.dead_end(higher_group)
        choice = self.choose(options)
        assert isinstance(choice, tuple)
        solve_higher_group(self.motion, higher_group, self.drives, lambda _: list(choice))
        self.singular = self.singular or self.vague(higher_group)
        return list(choice)

    def higher_group(self, higher_group: HigherGroup) -> list[list[float]]:
        """All coordinates of a higher group on the links placed so far: of a triad all, else those found."""
        # If a given pose is sought, start from the coordinates that it has.
        if self.goal is not None:
            self.motion.bodies.update({link: self.goal[link] for link in higher_group.links})
            there = self.polish(higher_group, read_coordinates(self.motion, higher_group))
            return [] if there is None else [there]
        # All modes of a triad follow from a polynomial, so the list is complete.
        shape = triad(self.motion, higher_group, self.drives)
        candidates: list[list[float]] = []
        complete = False
        if shape is not None:
            system = TriadSystem(self.motion, shape)
            roots = system.roots()
            complete = roots.complete
            candidates = [coordinates(self.motion, higher_group, system, pose) for pose in roots.poses]
        # Other groups are searched from many starts; some mode may be missing.
        if not complete:
            if higher_group.label not in self.found.open_groups:
                self.found.open_groups.append(higher_group.label)
            candidates += self.search(higher_group)
        # Improve every candidate by Newton and drop duplicates; near singular poses these agree to fewer digits.
        found: list[tuple[list[float], bool]] = []
        for start in candidates:
            there = self.polish(higher_group, start)
            if there is None:
                continue
            vague = self.vague(higher_group)
            if not any(self.same(higher_group, there, u, VAGUE if vague or v else SAME) for u, v in found):
                found.append((there, vague))
        return sorted(u for u, _ in found)

    def vague(self, higher_group: HigherGroup) -> bool:
        """Whether a higher group, as it is placed now, is singular: its coordinates are known to few digits only."""
        return not abs(float(self.motion.higher_groups[higher_group].margin())) > 1e-6

    def polish(self, higher_group: HigherGroup, start: list[float]) -> list[float] | None:
        """The solution at a start, singular ones too; ``None`` where there is none.

        A closing slide's sine also vanishes for opposed lines; its slope is that of equal ones, which drives Newton's
        method away from there.
        """
        if not all(map(math.isfinite, start)):
            return None
        # Newton first; where it creeps, as at a double root, least-squares steps.
        there = newton(self.motion, higher_group, start, self.drives)
        there = self.singular_solution(higher_group, start) if there is None else there
        if there is None:
            return None
        solve_higher_group(self.motion, higher_group, self.drives, lambda _: there)
        free = zip(higher_group.turning, there, strict=True)
        return [math.remainder(q, 2 * math.pi) if turns else q for turns, q in free]

    def same(self, higher_group: HigherGroup, a: list[float], b: list[float], near: float) -> bool:
        """Whether two sets of a higher group's coordinates are one pose."""
        for turns, unit, p, q in zip(higher_group.turning, higher_group.units(self.size), a, b, strict=True):
            if abs(math.remainder(p - q, 2 * math.pi) if turns else (p - q) / unit) > near:
                return False
        return True

    def singular_solution(self, higher_group: HigherGroup, start: list[float]) -> list[float] | None:
        """Least-squares steps to a singular solution, where Newton's method creeps."""
        here = np.array(start)
        for _ in range(60):
            at: list[float] = [float(q) for q in here]
            solve_higher_group(self.motion, higher_group, self.drives, partial(_fixed_coordinates, at))
            solved = self.motion.higher_groups[higher_group]
            gaps = np.array([float(gap) for gap in solved.gaps])
            if np.abs(gaps).max() < CLOSED * min(self.size, 1.0):
                return at
            # The minimum-norm step ignores the direction in which the slopes are singular.
            step = np.linalg.lstsq(np.array(solved.slopes, dtype=float), gaps, rcond=1e-9)[0]
            here = here - step
        return None

    def search(self, higher_group: HigherGroup) -> list[list[float]]:
        """Solutions of a higher group from many starts."""
        n, graph = len(higher_group.free), self.graph
        block = graph.program(graph.closure(higher_group)).block
        rows = graph.coordinates(higher_group)
        parameters = np.array([self.quantities.parameters[name] for name in graph.parameters])
        known = self.inputs()

        def closure(u: Array) -> tuple[Array, Array]:
            x = np.repeat(known[:, None], u.shape[1], axis=1)
            x[rows] = u
            y = np.array(block.arrays(x, parameters))
            return y[:n].T, y[n:].reshape(n, n, -1).transpose(2, 0, 1)

        return many_starts(closure, np.array(higher_group.turning), self.size, CLOSED * self.size)

    def inputs(self) -> Array:
        """The program's inputs as far as groups are placed: (inputs,)."""
        x = np.zeros(len(self.graph.inputs))
        for i, name in enumerate(self.graph.drives):
            x[i * (MAX_ORDER + 2)] = self.values[name]
        for step, choice in zip(self.structure.choices, self.taken, strict=False):  # as far as they are made
            if isinstance(step, HigherGroup):
                x[self.graph.coordinates(step)] = choice
            else:
                x[self.graph.inputs.index(f"branch:{step.label}")] = choice
        return x

    def mode(self) -> Mode:
        """The mode just walked."""
        chosen = list(zip(self.structure.choices, self.taken, strict=True))
        branches = {step.label: choice for step, choice in chosen if isinstance(choice, float)}
        free = {step.label: choice for step, choice in chosen if isinstance(choice, tuple)}
        bodies = self.motion.bodies
        places = {
            name: _place(bodies[link], self.geometry, link, name)
            for name, link in self.quantities.signals.links_of_points.items()
        }
        lines = self.lines(branches, places)
        return Mode(branches, free, places, dict(bodies), lines, self.singular)

    def lines(self, branches: Mapping[str, float], places: Mapping[str, tuple[float, float]]) -> tuple[str, ...]:
        """The lines of an assembly section that select a mode."""
        links = self.quantities.mechanism.links
        known = set(links[FRAME].points)
        said: dict[str, str] = {}
        for step in self.structure.steps:
            points = [name for link in step.links for name in links[link].points if name not in known]
            if isinstance(step, HigherGroup):
                said |= {name: self.sketch(places[name]) for name in points if name not in said}
            elif isinstance(step, Group) and step.modes > 1:
                rules = step.rules(branches[step.label])
                rules += [(name, self.sketch(places[name])) for name in points]
                name, rule = next(((n, r) for n, r in rules if n not in said), rules[0])
                said[name] = rule
            known |= set(points)
        return tuple(f"{name}: {rule}" for name, rule in said.items())

    def sketch(self, place: tuple[float, float]) -> str:
        """A place as a file writes it."""
        unit, size = self.quantities.unit_of(LENGTH)
        bare = self.quantities.mechanism.units.length is not None
        digits = max(0, 6 - math.ceil(math.log10(self.size / size)))
        x, y = (f"{round(v / size, digits) + 0.0:.{digits}f}" + ("" if bare else f" {unit}") for v in place)
        return f"[{x}, {y}]"


def _fixed_coordinates(at: list[float], _: HigherGroup) -> list[float]:
    return at


def _place(body: Body, geometry: Geometry, link: str, name: str) -> tuple[float, float]:
    at = body.point(geometry.point(link, name)).now
    return float(at.x), float(at.y)
