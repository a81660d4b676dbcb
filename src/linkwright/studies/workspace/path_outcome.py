"""Wanted paths tried in each region: the ways back that were found, and the best of each path."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions import units as u
from linkwright.expressions.units import Dimension
from linkwright.findings import Finding, ModelError, raise_errors
from linkwright.kernels import Compiled
from linkwright.presentation.json_numbers import known
from linkwright.studies.workspace.inverse_kinematics import ServoLaw, Way, free, timed
from linkwright.studies.workspace.outcome import Reached, Workspace, WorkspaceOutcome, in_units
from linkwright.studies.workspace.path_options import WantedPath, WantedPaths, build_path, rate_of
from linkwright.studies.workspace.target_path import PATH, TargetPath

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Attempt:
    """A path in a region: ``name`` is the path's, ``index`` that of its workspace, ``constant`` whether the motor has
    constant speed."""

    name: str
    index: int
    workspace: Workspace
    reached: Reached
    wanted: TargetPath
    constant: bool
    way: Way

    @property
    def law(self) -> ServoLaw | None:
        """The laws of both drives, where it can be followed."""
        return self.way.law

    @property
    def is_feasible(self) -> bool:
        """Whether it can be followed as it is asked."""
        return self.law is not None and not any(one.severity == "error" for one in self.way.findings)

    @property
    def rank(self) -> tuple[float, ...]:
        """How good it is: first whether it is kept, then how much of it can be followed, then how far from any limit
        and from any uncertain position."""
        blocked = np.zeros(1001, dtype=bool)
        for one in self.way.stretches:
            blocked |= (np.linspace(0, 1, 1001) >= one.start) & (np.linspace(0, 1, 1001) <= one.stop)
        law = self.law
        room = (0.0, 0.0) if law is None else (law.determinant, law.closure)
        return (self.is_feasible, law is not None, 1.0 - float(blocked.mean()), *room)


@dataclass(frozen=True, eq=False)
class PathsOutcome:
    """The part of the outcome: each path in each region."""

    compiled: Compiled
    point: str
    attempts: tuple[Attempt, ...]

    @cached_property
    def best(self) -> dict[str, Attempt]:
        """The best attempt at each path; of equals the first, which is the file's own mode."""
        found: dict[str, Attempt] = {}
        for one in self.attempts:
            if one.name not in found or one.rank > found[one.name].rank:
                found[one.name] = one
        return found

    def within(self, index: int) -> dict[str, Attempt]:
        """The best attempt at each path in one workspace."""
        return PathsOutcome(self.compiled, self.point, tuple(one for one in self.attempts if one.index == index)).best

    def as_dict(self) -> list[dict[str, Any]]:
        """Entries of the summary, in the file's units."""
        return [self._entry(one) for one in self.attempts]

    def _entry(self, one: Attempt) -> dict[str, Any]:
        unit, size = self.compiled.quantities.unit_of(u.LENGTH)
        stretches = [
            {"from": s.start, "to": s.stop, "why": s.kind, "by": s.by / size, "drive": s.drive or None}
            for s in one.way.stretches
        ]
        entry = {
            "path": one.name,
            "mode": one.reached.mode,
            **in_units(self.compiled, one.workspace.values),
            "followed": one.law is not None,
            "kept": one.is_feasible,
            "best": self.best[one.name] is one,
            "unit": unit,
            "stretches": stretches,
        }
        return entry if one.law is None else entry | self._law(one.law)

    def _law(self, law: ServoLaw) -> dict[str, Any]:
        """What is told of a law."""
        time_unit, second = self.compiled.quantities.unit_of(u.TIME)
        size = self.compiled.quantities.unit_of(u.LENGTH)[1]
        times = {"reversals": law.reverses, "limit_positions": law.limit_positions}
        efforts = law.efforts
        return {
            "motor": law.names[0],
            "servo": law.names[1],
            "drives": {name: self.drive(law, k) for k, name in enumerate(law.names)},
            "duration": float(law.t[-1]) / second,
            "period": None if law.period is None else law.period / second,
            "time_unit": time_unit,
            "backward": law.backward,
            **{key: (some / second).tolist() for key, some in times.items()},
            "servo_share": None if efforts is None or efforts.share is None else known(efforts.share),
            "residual": law.residual / size,
            "determinant": known(law.determinant / self.per_drives(law.names)),
            "determinant_of": f"d({self.point}.x, {self.point}.y)/d({', '.join(law.names)})",
            "closure": law.closure,
        }

    def per_drives(self, names: tuple[str, str]) -> float:
        """The SI value of an area by both drives' units: lengths in the file's, angles in rad."""
        quantities = self.compiled.quantities
        size = quantities.unit_of(u.LENGTH)[1]
        return math.prod(size if self.compiled.mechanism.prescribed(name).turns else 1.0 for name in names)

    def drive(self, law: ServoLaw, k: int) -> dict[str, dict[str, Any]]:
        """Of the motor (0) or servo (1): its range, the largest speed, acceleration, effort and power, its work."""
        value, *rates = (law.motor, law.servo)[k]
        units = self.units(law.names[k])
        rows = dict(zip(("speed", "acceleration"), rates, strict=True))
        if law.efforts is not None:
            rows |= {"effort": law.efforts.effort[k], "power": law.efforts.power[k]}
        unit, size = units["value"]
        made: dict[str, dict[str, Any]] = {
            "value": {"from": value.min() / size, "to": value.max() / size, "unit": unit}
        }
        for key, row in rows.items():
            unit, size = units[key]
            made[key] = {"largest": known(float(np.abs(row).max()) / size), "unit": unit}
        if law.efforts is not None:
            unit, size = units["work"]
            given, taken = (known(float(some[k]) / size) for some in (law.efforts.work, law.efforts.taken))
            made["work"] = {"given": given, "taken": taken, "unit": unit}
        return made

    def units(self, drive: str) -> dict[str, tuple[str, float]]:
        """The units of a drive's quantities with their SI values."""
        turns = self.compiled.mechanism.prescribed(drive).turns
        motion: tuple[Dimension, ...] = (u.ANGLE, u.OMEGA, u.ALPHA) if turns else (u.LENGTH, u.SPEED, u.ACCELERATION)
        every = (*motion, u.TORQUE if turns else u.FORCE, u.POWER, u.ENERGY)
        keys = ("value", "speed", "acceleration", "effort", "power", "work")
        return {key: self.compiled.quantities.unit_of(one) for key, one in zip(keys, every, strict=True)}


def follow(paths: WantedPaths, outcome: WorkspaceOutcome) -> PathsOutcome:
    """Try each path in each region. A path that none of them lets follow as it is asked is a failure."""
    compiled = outcome.compiled
    attempts, wrong = [], []
    for index, one in enumerate(outcome.workspaces):
        for name, path in paths.root.items():
            parameters = parameters_of(one, compiled)
            try:
                way = build_path(compiled, path, (*PATH, name), parameters)
            except ModelError as error:
                wrong += [finding for finding in error.findings if finding not in wrong]
                continue
            if not wrong:
                attempts += [_attempt(outcome, name, path, index, reached, way) for reached in one.regions]
    raise_errors(wrong)
    found = PathsOutcome(compiled, outcome.point, tuple(attempts))
    for name, best in found.best.items():
        if best.is_feasible:
            outcome.warnings += best.way.findings
            continue
        tried = sum(one.name == name for one in attempts)
        if tried > 1:
            outcome.failures.append(_nowhere(outcome, best, tried))
        outcome.failures += best.way.findings
    return found


def parameters_of(one: Workspace, compiled: Compiled) -> dict[str, float]:
    """The parameters of a workspace in SI, by name."""
    if not one.regions:
        return dict(compiled.quantities.parameters)
    given = one.regions[0].region.sheet.parameters
    return {**compiled.quantities.parameters, **dict(zip(compiled.graph.parameters, map(float, given), strict=True))}


def _attempt(
    outcome: WorkspaceOutcome, name: str, path: WantedPath, index: int, reached: Reached, way: TargetPath
) -> Attempt:
    compiled, quantities = outcome.compiled, outcome.compiled.quantities
    assert outcome.box is not None
    region = replace(reached.region, box=outcome.box)  # a whole turn begins as the file has it
    off = None if path.tolerance is None else quantities.value(path.tolerance, u.LENGTH)
    asked = {"samples": path.samples, "never_reverse": path.never_reverse, "off": off}
    if path.speed is not None:
        speed = quantities.value(path.speed, rate_of(compiled, path.motor))
        found = free(region, way, path.motor, speed, **asked)  # type: ignore[arg-type]
    else:
        assert path.duration is not None
        time = quantities.value(path.duration, u.TIME)
        timing = from_rest(time) if path.timing == "rest" else None
        found = timed(region, way, path.motor, time, timing, **asked)  # type: ignore[arg-type]
    return Attempt(name, index, outcome.workspaces[index], reached, way, path.speed is not None, found)


def from_rest(time: float) -> Any:
    """u(t) from rest to rest, without a jump of acceleration: 10 s³ - 15 s⁴ + 6 s⁵ with s = t / ``time``."""

    def timing(t: Array) -> Array:
        s = t / time
        rate = 30 * s**2 * (1 - s) ** 2 / time
        return np.stack([s**3 * (10 - 15 * s + 6 * s**2), rate, 60 * s * (1 - s) * (1 - 2 * s) / time**2])

    return timing


def _nowhere(outcome: WorkspaceOutcome, best: Attempt, tried: int) -> Finding:
    values = outcome.values_text(best.workspace)
    data = {"name": best.name, "count": tried, "mode": best.reached.mode or "-", "values": values or "-"}
    return Finding("workspace.path-none", (*PATH, best.name), data)
