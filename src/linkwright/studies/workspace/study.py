"""The workspace study: where a point gets to with two drives, in each assembly mode."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.blocks import Threads
from linkwright.findings import Finding, Term
from linkwright.kernels import Compiled
from linkwright.kernels.parameter_batch import Varied
from linkwright.presentation.blocks import StudyReport
from linkwright.studies.interruption import Stopped
from linkwright.studies.registry import Command, Study, register
from linkwright.studies.run_context import NOWHERE, RunContext
from linkwright.studies.workspace.assembly_signs import Signs, combinations, named
from linkwright.studies.workspace.coupler_curve import CouplerCurve, curve
from linkwright.studies.workspace.doubts import doubts
from linkwright.studies.workspace.files import FILES
from linkwright.studies.workspace.options import PATH, WorkspaceOptions, check
from linkwright.studies.workspace.outcome import Reached, Workspace, WorkspaceOutcome, values_text
from linkwright.studies.workspace.parallel import run_in_threads
from linkwright.studies.workspace.parts import perform
from linkwright.studies.workspace.preconditions import unfit
from linkwright.studies.workspace.region_files import FOLDER, resumable
from linkwright.studies.workspace.regions import Region, region
from linkwright.studies.workspace.report import report
from linkwright.studies.workspace.sheet import ModeSheet
from linkwright.studies.workspace.turning import turnings
from linkwright.studies.workspace.unreachable import unreachable_data

Array = NDArray[np.float64]

LOOKS = 64
SAMPLES = 20_000
"""A region has to hold what is reached at so many random values of the drives."""
FLAT = 1e-9
"""A jacobian's determinant below this share of its columns' lengths everywhere: the point moves along curves only."""


@register
class WorkspaceStudy(Study):
    """Reachable regions with their boundaries."""

    name = "workspace"
    example = "{point: P}"
    options = WorkspaceOptions
    rank = 5
    command = Command(fresh=True)
    files = FILES

    def check(self, compiled: Compiled, options: WorkspaceOptions) -> list[Finding]:
        """What is wrong with the options."""
        found = [*check(compiled, options)]
        return found or [*unfit(compiled, options, PATH)]

    def run(self, compiled: Compiled, options: WorkspaceOptions, site: RunContext = NOWHERE) -> WorkspaceOutcome:
        """The region of each mode for each combination of values."""
        outcome = WorkspaceOutcome(compiled, options, options.chord * compiled.graph.size)
        if len(compiled.graph.drives) == 2:
            outcome.box = options.box(compiled)
        done = total = 0
        try:
            done, total, stopped = _regions(outcome, site)
            if stopped:
                raise KeyboardInterrupt
            if outcome.workspaces:
                perform(outcome)
        except KeyboardInterrupt:
            outcome.failures.append(Finding("workspace.stopped", PATH, {"done": done, "total": total}))
            raise Stopped(outcome, outcome.failures[-1]) from None
        return outcome

    def report(self, outcome: WorkspaceOutcome) -> StudyReport:
        """Pictures and tables of regions."""
        return report(outcome)

    def stores(self, options: WorkspaceOptions) -> Sequence[str]:
        """Where regions that are done wait for the rest."""
        return [FOLDER]


def _regions(outcome: WorkspaceOutcome, site: RunContext) -> tuple[int, int, bool]:
    """Find the region of each mode for each combination of values; how many are done, of how many, and whether an
    interrupt came."""
    compiled, options = outcome.compiled, outcome.options
    signs, cases = combinations(compiled, options.modes), []
    every = options.values(compiled)
    for values, parameters in zip(every, _parameters(compiled, every), strict=True):
        if fault := _senseless(compiled, values):
            outcome.failures += fault
        else:
            cases.append((values, parameters))
    works = [(one, parameters) for _, parameters in cases for one in signs]
    if outcome.box is not None and works:
        _sheet(outcome, *works[0]).make_programs()  # the graph isn't made for several threads
    # NumPy's calls are short and each waits for the interpreter: more threads are no sooner done, unless asked for.
    workers = site.runner.workers if outcome.box and isinstance(site.runner, Threads) else 1
    find = resumable(lambda work: _search_mode(outcome, *work), lambda work: _sheet(outcome, *work), outcome, site)
    found, stopped = run_in_threads(find, works, workers, site.progress)
    for i, (values, parameters) in enumerate(cases):
        here = [found[k] for k in range(i * len(signs), (i + 1) * len(signs)) if k in found]
        for finding in (finding for _, findings in here for finding in findings):
            (outcome.failures if finding.severity == "error" else outcome.warnings).append(finding)
        reached = [one for one, _ in here if one is not None]
        if reached or len(here) == len(signs):
            _note_workspace(outcome, values, parameters, reached)
    return len(found), len(works), stopped


def _parameters(compiled: Compiled, every: list[dict[str, float]]) -> Array:
    """All parameters for each combination: (combinations, parameters)."""
    names = tuple(every[0])
    values = np.array([[one[name] for one in every] for name in names]).reshape(len(names), len(every))
    return Varied(compiled, names).parameters(values).T


def _senseless(compiled: Compiled, values: dict[str, float]) -> list[Finding]:
    """What the model's own checks say of such values."""
    return Varied(compiled, tuple(values)).faults(np.array([*values.values()]).reshape(-1, 1))


def _sheet(outcome: WorkspaceOutcome, signs: Signs, parameters: Array) -> ModeSheet:
    first, second = outcome.compiled.graph.drives
    return ModeSheet(outcome.compiled, outcome.point, (first, second), signs, parameters)


def _search_mode(
    outcome: WorkspaceOutcome, signs: Signs, parameters: Array
) -> tuple[Reached | CouplerCurve | None, list[Finding]]:
    """What one mode reaches, ``None`` where it can't be assembled anywhere; what contradicts that. The outcome isn't
    changed."""
    compiled, options, box = outcome.compiled, outcome.options, outcome.box
    mode = named(compiled, signs)
    if box is None:
        (drive,) = compiled.graph.drives
        ends = options.range(compiled, drive)
        assert ends is not None
        turns = options.turns(compiled)[0]
        way = curve(compiled, options.point, mode, signs, parameters, ends, turns, outcome.chord)
        return way if way.length > 0 else None, []
    sheet = _sheet(outcome, signs, parameters)
    if _flat(sheet, box.low, box.high):
        return None, []
    found = region(sheet, box, outcome.chord)
    told = [*doubts(compiled, PATH, mode, found.certificate)]
    if found.shape.area == 0:
        return None, told
    if missed := _missed(found, outcome.chord):
        told.append(Finding("workspace.incomplete", PATH, {"mode": mode or "-", "share": f"{100 * missed:.3g}"}))
    return Reached(mode, signs, found), told


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


def _flat(sheet: ModeSheet, low: tuple[float, float], high: tuple[float, float]) -> bool:
    """Whether the point moves along curves only."""
    axes = [np.linspace(a, b, LOOKS + 1)[:-1] + 0.37 * (b - a) / LOOKS for a, b in zip(low, high, strict=True)]
    look = sheet.look(np.stack(np.meshgrid(*axes)).reshape(2, -1))
    known = look.reach > 0
    sizes = np.hypot(look.jacobian[0], look.jacobian[1])[:, known]
    return bool(known.any() and (np.abs(look.determinant[known]) <= FLAT * sizes.max() ** 2).all())


def _note_workspace(outcome: WorkspaceOutcome, values: dict[str, float], parameters: Array, found: list[Any]) -> None:
    """Note a workspace, or that there is none."""
    if not found:
        outcome.failures += _nothing(outcome, values, parameters)
        return
    curves = tuple(one for one in found if isinstance(one, CouplerCurve))
    regions = tuple(one for one in found if isinstance(one, Reached))
    sheets = [one.region.sheet for one in regions]
    turning = tuple(turnings(sheets, outcome.box)) if outcome.box and sheets else ()
    outcome.workspaces.append(Workspace(values, regions, curves, outcome.chord, turning))


def _nothing(outcome: WorkspaceOutcome, values: dict[str, float], parameters: Array) -> Iterator[Finding]:
    compiled, options = outcome.compiled, outcome.options
    where = Term("for-values", values=values_text(compiled, values)) if values else ""
    ranges = [options.range(compiled, drive) for drive in compiled.graph.drives]
    data = unreachable_data(
        compiled, [r for r in ranges if r is not None], dict(zip(compiled.graph.parameters, parameters, strict=True))
    )
    if data is None:
        yield Finding("workspace.no-area", (*PATH, "point"), {"name": options.point, "values": where})
    else:
        yield Finding("workspace.never-closes", PATH, {"values": where, **data})
