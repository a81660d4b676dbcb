"""The cam study: figures, checks, sizes, the contour, and NC code that is read back."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from linkwright.cam.cams_of_mechanism import frame
from linkwright.cam.checks import CamCheck, CamLimits, checks, undercut
from linkwright.cam.contour import area, contour
from linkwright.cam.disc import Disc
from linkwright.cam.form_closure import Conjugate
from linkwright.cam.nc.path import Sharp
from linkwright.cam.sizing import feasible, resized, smallest
from linkwright.cam.solid import Blank
from linkwright.cam.splines import splines
from linkwright.expressions import units as u
from linkwright.findings import Finding, Joined, Term
from linkwright.kernels import Compiled
from linkwright.presentation.blocks import StudyReport
from linkwright.studies.cam.closure_forces import cam_and_closing
from linkwright.studies.cam.figures import CamFigure, every
from linkwright.studies.cam.files import FILES
from linkwright.studies.cam.force_findings import press
from linkwright.studies.cam.milled_discs import axis_comments, milled
from linkwright.studies.cam.options import PATH, CamOptions
from linkwright.studies.cam.outcome import CamOutcome
from linkwright.studies.cam.plate import Plate
from linkwright.studies.cam.report import report
from linkwright.studies.cam.stated_dimensions import CamRequirements, DimensionReader
from linkwright.studies.registry import Command, Setting, Study, register
from linkwright.studies.run_context import NOWHERE, RunContext

LARGER = 20.0
"""How many times as large a base circle is looked for as the one that won't do."""
NAMED = {
    "pressure_rise": Term("check-pressure_rise"),
    "pressure_return": Term("check-pressure_return"),
    "pitch_radius": Term("check-pitch_radius"),
    "profile_radius": Term("check-profile_radius"),
    "hollow_radius": Term("check-hollow_radius"),
    "groove_radius": Term("check-groove_radius"),
}
MILLED = {"nc.concave": "hollow_radius", "nc.undercut-outer": "groove_radius"}
"""What is told of NC code where a check, which tells what mends it, hasn't failed for it."""
JUMPS = (Term("law-velocity"), Term("jump-acceleration"), Term("jump-jerk"))
"""What jumps first, by the class of the law."""
UP = 1 + 1e-6
"""A radius that is to suffice is told so much larger."""


@register
class CamStudy(Study):
    """A plate cam from its law to its NC code."""

    name = "cam"
    example = "{cam: seal, limits: {pressure_rise: 30}}"
    options = CamOptions
    rank = 7
    command = Command([Setting("post", ("nc", "post"), several=True)])
    files = FILES

    def without(self, wrong: set[str]) -> set[str] | None:
        """The keys to leave out where some are wrong in form; ``None`` where nothing can be judged then."""
        return None if "cam" in wrong else wrong | ({"require"} if "forces" in wrong else set())

    def check(self, compiled: Compiled, options: CamOptions) -> list[Finding]:
        """What is wrong with the options."""
        name, findings = selected_cam(compiled, options)
        if name is None:
            return findings
        return _read(compiled, options, name)[1]

    def run(self, compiled: Compiled, options: CamOptions, site: RunContext = NOWHERE) -> CamOutcome:
        """All that is asked of the cam; nothing is made of a disc that is undercut."""
        name, _ = selected_cam(compiled, options)
        assert name is not None
        outcome = _initial_outcome(compiled, options, name)
        stated = outcome.stated
        for plate in outcome.plates:
            plate.checks = checks(plate.disc, stated.limits)
        if stated.base is not None:
            _sizes(outcome, *stated.base)
        outcome.failures += _rough(outcome)
        cuts = {plate.second: cut for plate in outcome.plates if (cut := undercut(plate.disc)) is not None}
        outcome.failures += [_undercut(outcome, p, cuts[p.second]) for p in outcome.plates if p.second in cuts]
        sound = [plate for plate in outcome.plates if plate.second not in cuts]
        for plate in sound:
            outcome.add(plate.figures(), every(plate.disc.follower.turns))
        if outcome.first in sound:
            _closes(outcome)
        if not cuts:
            press(outcome)
        for plate in sound:
            outcome.failures += [_failed(outcome, plate, check) for check in plate.checks if not check.passed]
        outcome.failures += [_unmet(outcome, figure) for figure in outcome.figures if not figure.kept]
        for plate in sound:
            _shape(outcome, plate)
            _mill(outcome, plate)
        return outcome

    def report(self, outcome: CamOutcome) -> StudyReport:
        """Pictures, charts, figures and checks of the cam."""
        return report(outcome)


def _read(compiled: Compiled, options: CamOptions, name: str) -> tuple[CamRequirements, list[Finding]]:
    """The numbers of the options and what is wrong with them, read once for check and run."""

    def read_requirements() -> tuple[CamRequirements, list[Finding]]:
        reader = DimensionReader(compiled, options, name, *cam_and_closing(compiled, name))
        return reader.read(), reader.findings

    return compiled.cached((_read, name, options), read_requirements)


def _initial_outcome(compiled: Compiled, options: CamOptions, name: str) -> CamOutcome:
    """The disc or discs, and what is asked of them."""
    path, (disc, close) = ("cams", name), cam_and_closing(compiled, name)
    stated, _ = _read(compiled, options, name)
    axes = frame(compiled, name)
    plates = [Plate(disc, axes, stated, path, options.steps)]
    if isinstance(close, Conjugate):
        plates.append(Plate(close.disc, axes.mirrored, stated, (*path, "second"), options.steps, second=True))
    return CamOutcome(compiled, options, name, stated, plates, close)


def _closes(outcome: CamOutcome) -> None:
    """What holds the follower: its sizes, and the play of a yoke."""
    if outcome.closing is None:
        return
    sizes, limit = outcome.closing.figures, outcome.stated.play
    outcome.add(sizes.items(), every(outcome.disc.follower.turns))
    if (play := sizes.get("play")) is None:
        return
    margin = None if limit is None else limit - play.value
    outcome.first.checks.append(CamCheck("play", play.value, play.theta, limit, margin))
    if limit is None and play.value > outcome.stated.tolerance:
        outcome.warnings.append(_loose(outcome, severity="warning"))


def _mill(outcome: CamOutcome, plate: Plate) -> None:
    """NC code of a disc; of a second one the findings that the first one has too aren't told again."""
    job, nc = outcome.stated.job, outcome.options.nc
    if job is None or nc is None:
        return
    told = axis_comments(plate.frame)
    if plate.second:
        name = f"{job.name[:17]}_SECOND"
        job, told = replace(job, name=name, number=job.number % 9999 + 1), ["SECOND DISC", *told]
    broken = {check.name for check in plate.checks if not check.passed}
    known = {code for code, name in MILLED.items() if name in broken}
    plate.milled, found = milled(plate.disc, job, nc.post, outcome.options.steps, told)
    for finding in found:
        if finding.code in known:
            continue
        if plate.second:
            if finding in (*outcome.failures, *outcome.warnings):
                continue
            finding = replace(finding, path=plate.path)
        (outcome.failures if finding.severity == "error" else outcome.warnings).append(finding)


def _rough(outcome: CamOutcome) -> Iterator[Finding]:
    """Jumps of the law that the limits refuse; those of the velocity no cam may have."""
    for join in outcome.law.joins:
        if join.continuity < (outcome.options.limits.continuity or 0):
            data = {"rate": JUMPS[join.continuity], "theta": _angle(outcome, join.at)}
            yield Finding("cam.rough", ("cams", outcome.name, "law"), data)


def selected_cam(compiled: Compiled, options: CamOptions) -> tuple[str | None, list[Finding]]:
    """The cam that is looked at, or what is wrong."""
    cams = compiled.mechanism.cams
    if options.cam is not None:
        return (options.cam if options.cam in cams else None), []
    if len(cams) == 1:
        return next(iter(cams)), []
    if not cams:
        return None, [Finding("cam.none", PATH)]
    return None, [Finding("cam.which", PATH, {"count": len(cams), "names": Joined(cams)})]


def _sizes(outcome: CamOutcome, low: float, high: float) -> None:
    """The smallest base circles, each disc's by itself, and a map of the first one's."""
    limits = outcome.stated.limits
    for plate in outcome.plates:
        plate.smallest = smallest(plate.disc, limits, low, high)
        if plate.smallest is None:
            unit, size = outcome.compiled.quantities.unit_of(u.LENGTH)
            data = {"low": f"{low / size:.6g}", "high": f"{high / size:.6g}", "unit": unit}
            path = plate.path if plate.second else (*PATH, "size", "base")
            outcome.warnings.append(Finding("cam.no-base", path, data, severity="warning"))
    against, size_options = outcome.stated.against, outcome.options.size
    if against is not None and size_options is not None:
        outcome.map = feasible(outcome.disc, limits, ("base", low, high), against, size_options.steps)


def _shape(outcome: CamOutcome, plate: Plate) -> None:
    """The contour, and whether bore and hub fit into it."""
    disc, stated = plate.disc, outcome.stated
    try:
        plate.elements = contour(disc, stated.tolerance)
        cut = any(check.name == "groove_radius" and not check.passed for check in plate.checks)
        if stated.limits.groove and not cut:
            plate.outer = contour(disc, stated.tolerance, disc.follower.radius)
        if outcome.options.drawing == "splines":
            sides = (-1, 1) if plate.outer else (-1,)
            plate.curves = [splines(disc, stated.tolerance, side * disc.follower.radius) for side in sides]
    except Sharp as sharp:
        data = {"theta": _angle(outcome, sharp.theta), "tolerance": outcome.options.tolerance.text[:60]}
        path = plate.path if plate.second else (*PATH, "tolerance")
        outcome.failures.append(Finding("cam.sharp", path, data))
        return
    plate.area = area(disc)
    plate.outer_area = area(disc, disc.follower.radius) if plate.outer else None
    if stated.blank is not None:
        unfit = [*_unfit(outcome, plate, stated.blank)]
        plate.fits = not unfit
        outcome.failures += unfit


def _unfit(outcome: CamOutcome, plate: Plate, blank: Blank) -> Iterator[Finding]:
    """What of the blank doesn't fit the contour."""
    unit, size = outcome.compiled.quantities.unit_of(u.LENGTH)
    least = plate.extents[0].value
    reach = max(blank.hub, math.hypot(blank.bore + blank.key_depth, blank.key_width / 2)) / 1e3
    if reach >= least:
        lengths = {"reach": f"{reach / size:.6g}", "least": f"{least / size:.6g}", "unit": unit}
        yield Finding("cam.blank", (*PATH, "blank"), lengths | {"profile": plate.term_for(Term("cam-profile"))})
    if plate.outer and (most := plate.outer_extents[1].value) >= blank.radius / 1e3:
        yield Finding("cam.plate", (*PATH, "blank", "radius"), {"most": f"{most / size:.6g}", "unit": unit})


def mending(disc: Disc, limits: CamLimits) -> float | None:
    """The smallest larger base circle that keeps limits."""
    return smallest(disc, limits, disc.follower.base, LARGER * disc.follower.base)


def _undercut(outcome: CamOutcome, plate: Plate, cut: CamCheck) -> Finding:
    data = _place(outcome, plate, cut) | _base(outcome, plate, CamLimits())
    smaller: Term | str = "" if plate.disc.follower.faced else Term("or-roller")
    which = Term("cam-second" if plate.second else "cam-first")
    return Finding("cam.undercut", plate.path, data | {"disc": which, "roller": smaller})


def _failed(outcome: CamOutcome, plate: Plate, check: CamCheck) -> Finding:
    """A limit that isn't kept."""
    if check.name == "play":
        return _loose(outcome)
    data = _place(outcome, plate, check)
    if check.name == "groove_radius":
        data |= _base(outcome, plate, CamLimits(groove=True)) | {"disc": Term("cam-flank"), "roller": Term("or-roller")}
        return Finding("cam.undercut", plate.path, data)
    if check.name == "hollow_radius":
        limits = replace(CamLimits(), cutter=check.limit)
        data |= {"profile": plate.term_for(Term("cam-profile"))}
        return Finding("cam.hollow", plate.path, data | _base(outcome, plate, limits))
    return Finding("cam.limit", (*PATH, "limits"), data)


def _loose(outcome: CamOutcome, severity: str = "error") -> Finding:
    """The play of a yoke."""
    assert outcome.closing is not None
    unit, size = outcome.compiled.quantities.unit_of(u.LENGTH)
    sizes = outcome.closing.figures
    data = {name: f"{one.value / size:.6g} {unit}" for name, one in sizes.items()}
    places = {f"at_{end}": _angle(outcome, sizes[f"yoke_span_{end}"].theta) for end in ("min", "max")}
    return Finding("cam.play", ("cams", outcome.name, "closed"), data | places, severity=severity)


def _unmet(outcome: CamOutcome, figure: CamFigure) -> Finding:
    unit, size = outcome.compiled.quantities.unit_of(figure.dimension)
    data = {"name": figure.name, "value": f"{figure.value / size:.6g}", "unit": unit}
    wanted = str(outcome.options.require[figure.name].raw)
    return Finding("cam.required", (*PATH, "require", figure.name), data | {"wanted": wanted})


def _place(outcome: CamOutcome, plate: Plate, check: CamCheck) -> dict[str, object]:
    """A check in the file's units."""
    dimension = u.ANGLE if check.name.startswith("pressure") else u.LENGTH
    unit, size = outcome.compiled.quantities.unit_of(dimension)
    limit = "-" if check.limit is None else f"{check.limit / size:.6g}"
    data = {
        "name": plate.term_for(NAMED[check.name]),
        "value": f"{check.value / size:.6g}",
        "limit": limit,
        "unit": unit,
    }
    return data | {"theta": _angle(outcome, check.theta)}


def _angle(outcome: CamOutcome, theta: float) -> str:
    unit, size = outcome.compiled.quantities.unit_of(u.ANGLE)
    return f"{theta / size:.6g} {unit}"


def _base(outcome: CamOutcome, plate: Plate, limits: CamLimits) -> dict[str, object]:
    """The base circle that mends it, where there is one; of a second disc with what is between both contacts then."""
    found = mending(plate.disc, limits)
    if found is None:
        return {"base": Term("no-base")}
    quantities, wide = outcome.compiled.quantities, UP * found
    unit, size = quantities.unit_of(u.LENGTH)
    told = f"{wide / size:.6g} {unit}"
    if not plate.second:
        return {"base": told}
    assert isinstance(outcome.closing, Conjugate)
    other = resized(plate.disc, {"base": wide}).follower.start - plate.disc.follower.start
    one, measure = quantities.unit_of(outcome.lift_dimension)
    return {"base": Term("base-between", base=told, between=f"{(outcome.closing.between + other) / measure:.6g} {one}")}
