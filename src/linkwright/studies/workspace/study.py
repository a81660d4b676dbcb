"""The workspace study: where a point gets to with two drives, in each assembly mode."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.kernels import Compiled
from linkwright.kernels.varied import Varied
from linkwright.model.findings import Finding
from linkwright.studies.registry import register
from linkwright.studies.site import NOWHERE, Site
from linkwright.studies.workspace.never import never
from linkwright.studies.workspace.one import Curve, curve
from linkwright.studies.workspace.options import PATH, WorkspaceOptions, check
from linkwright.studies.workspace.outcome import Reached, Workspace, WorkspaceOutcome
from linkwright.studies.workspace.parts import sections
from linkwright.studies.workspace.regions import Region, region
from linkwright.studies.workspace.sheet import Sheet
from linkwright.studies.workspace.signs import combinations, named
from linkwright.studies.workspace.turning import turnings
from linkwright.studies.workspace.unfit import unfit
from linkwright.words import say

Array = NDArray[np.float64]

CLOSE = 1e-6
"""Meshes are doubled until the area changes by less than this share, or that which the chords leave open."""
LOOKS = 64
MESHES = ((96, 1536), (96, 96), (80, 80), (112, 112))
"""First and last steps of meshes; others are tried where a region doesn't hold all that is sampled ..."""
SAMPLES = 20_000
"""... at so many random values of the drives."""
FLAT = 1e-9
"""A jacobian's determinant below this share of its columns' lengths everywhere: the point moves along curves only."""


class Stopped(KeyboardInterrupt):
    """The study was interrupted; nothing of it is kept."""

    def __init__(self, done: int, total: int) -> None:
        super().__init__()
        self.done, self.total = done, total

    @property
    def what(self) -> str:
        """How far it came."""
        return say("workspace.interrupted", done=self.done, total=self.total)


@register
class WorkspaceStudy:
    """Reachable regions with their boundaries."""

    name = "workspace"
    options = WorkspaceOptions

    def check(self, compiled: Compiled, options: WorkspaceOptions) -> list[Finding]:
        """What is wrong with the options."""
        found = [*check(compiled, options)]
        return found or [*unfit(compiled, options, PATH)]

    def run(self, compiled: Compiled, options: WorkspaceOptions, site: Site = NOWHERE) -> WorkspaceOutcome:
        """The region of each mode for each combination of values."""
        outcome = WorkspaceOutcome(compiled, options, options.chord * compiled.graph.size)
        signs = combinations(compiled, options.modes)
        every = options.values(compiled)
        if len(compiled.graph.drives) == 2:
            outcome.box = options.box(compiled)
        done, total = 0, len(signs) * len(every)
        try:
            for values, parameters in zip(every, _parameters(compiled, every), strict=True):
                if fault := _senseless(compiled, values):
                    outcome.failures += fault
                    continue
                found: list[Any] = []
                for one in signs:
                    found.append(_found(outcome, one, parameters))
                    done += 1
                    if site.progress is not None:
                        site.progress(done, total)
                _keep(outcome, values, parameters, [f for f in found if f is not None])
        except KeyboardInterrupt:
            raise Stopped(done, total) from None
        if outcome.workspaces:
            for name, section in sections(options):
                outcome.parts[name] = section.perform(outcome, site)
        return outcome


def _parameters(compiled: Compiled, every: list[dict[str, float]]) -> Array:
    """All parameters for each combination: (combinations, parameters)."""
    names = tuple(every[0])
    values = np.array([[one[name] for one in every] for name in names]).reshape(len(names), len(every))
    return Varied(compiled, names).parameters(values).T


def _senseless(compiled: Compiled, values: dict[str, float]) -> list[Finding]:
    """What the model's own checks say of such values."""
    return Varied(compiled, tuple(values)).faults(np.array([*values.values()]).reshape(-1, 1))


def _found(outcome: WorkspaceOutcome, signs: tuple[float, ...], parameters: Array) -> Reached | Curve | None:
    """What one mode reaches; ``None`` where it can't be assembled anywhere."""
    compiled, options, box = outcome.compiled, outcome.options, outcome.box
    mode = named(compiled, signs)
    if box is None:
        (drive,) = compiled.graph.drives
        ends = options.range(compiled, drive)
        assert ends is not None
        found = curve(compiled, options.point, mode, signs, parameters, ends, options.turns(compiled)[0], outcome.chord)
        return found if found.length > 0 else None
    drives = compiled.graph.drives[0], compiled.graph.drives[1]
    sheet = Sheet(compiled, options.point, drives, signs, parameters)
    if _flat(sheet, box.low, box.high):
        return None
    tried: list[tuple[float, Region]] = []
    for first, most in MESHES:
        made = region(sheet, box, outcome.chord, first, most, close=max(CLOSE, 10 * options.chord))
        tried.append((_missed(made, outcome.chord), made))
        if not tried[-1][0]:
            break
    missed, best = min(tried, key=lambda one: one[0])
    if missed:
        data = {"mode": mode or "-", "share": f"{100 * missed:.3g}"}
        outcome.warnings.append(Finding("workspace.incomplete", PATH, data, severity="warning"))
    return Reached(mode, signs, best) if best.shape.area > 0 else None


def _missed(found: Region, chord: float) -> float:
    """The share of places, sampled at random drive values, that lie outside of a region."""
    import shapely

    box = found.box
    q = np.random.default_rng(0).uniform(box.low, box.high, (SAMPLES, 2)).T
    at = found.sheet.place(q)[0]
    at = at[:, np.isfinite(at).all(axis=0)]
    shapely.prepare(found.shape)
    outside = at[:, ~shapely.contains_xy(found.shape, *at)]
    return float((shapely.distance(found.shape, shapely.points(outside.T)) > 2 * chord).sum()) / SAMPLES


def _flat(sheet: Sheet, low: tuple[float, float], high: tuple[float, float]) -> bool:
    """Whether the point moves along curves only."""
    axes = [np.linspace(a, b, LOOKS + 1)[:-1] + 0.37 * (b - a) / LOOKS for a, b in zip(low, high, strict=True)]
    look = sheet.look(np.stack(np.meshgrid(*axes)).reshape(2, -1))
    known = look.reach > 0
    sizes = np.hypot(look.jacobian[0], look.jacobian[1])[:, known]
    return bool(known.any() and (np.abs(look.determinant[known]) <= FLAT * sizes.max() ** 2).all())


def _keep(outcome: WorkspaceOutcome, values: dict[str, float], parameters: Array, found: list[Any]) -> None:
    """Note a workspace, or that there is none."""
    if not found:
        outcome.failures += _nothing(outcome, values, parameters)
        return
    curves = tuple(one for one in found if isinstance(one, Curve))
    regions = tuple(one for one in found if isinstance(one, Reached))
    sheets = [one.region.sheet for one in regions]
    turning = tuple(turnings(sheets, outcome.box)) if outcome.box and sheets else ()
    outcome.workspaces.append(Workspace(values, regions, curves, outcome.chord, turning))


def _nothing(outcome: WorkspaceOutcome, values: dict[str, float], parameters: Array) -> Iterator[Finding]:
    compiled, options = outcome.compiled, outcome.options
    shown = []
    for name, value in values.items():
        unit, size = compiled.quantities.unit_of(compiled.quantities.dimensions.of(name))
        shown.append(f"{name} = {value / size:.6g} {unit}".strip())
    where = say("workspace.for", values=", ".join(shown)) if shown else ""
    ranges = [options.range(compiled, drive) for drive in compiled.graph.drives]
    data = never(
        compiled, [r for r in ranges if r is not None], dict(zip(compiled.graph.parameters, parameters, strict=True))
    )
    if data is None:
        yield Finding("workspace.no-area", (*PATH, "point"), {"name": options.point, "values": where})
    else:
        yield Finding("workspace.never-closes", PATH, {"values": where, **data})
