"""The cam study: figures, checks, sizes, the contour, and NC code that is read back."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from linkwright.cam.checks import Check, Limits, checks, undercut
from linkwright.cam.contour import area, contour
from linkwright.cam.disc import Disc
from linkwright.cam.nc.path import Sharp
from linkwright.cam.pairs import disc as disc_of
from linkwright.cam.pairs import frame
from linkwright.cam.sizing import feasible, smallest
from linkwright.cam.splines import splines
from linkwright.kernels import Compiled
from linkwright.model import units as u
from linkwright.model.findings import Finding, Term
from linkwright.model.unknown import unknown
from linkwright.studies.cam.force_findings import press
from linkwright.studies.cam.milled import milled, seen
from linkwright.studies.cam.options import PATH, CamOptions
from linkwright.studies.cam.outcome import CamOutcome, Figure, figures
from linkwright.studies.cam.stated import Reader
from linkwright.studies.registry import register
from linkwright.studies.site import NOWHERE, Site

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
JUMPS = (Term("law-velocity"), Term("jump-acceleration"), Term("jump-jerk"))
"""What jumps first, by the class of the law."""
UP = 1 + 1e-6
"""A radius that is to suffice is told so much larger."""


@register
class CamStudy:
    """A plate cam from its law to its NC code."""

    name = "cam"
    options = CamOptions

    def without(self, wrong: set[str]) -> set[str] | None:
        """The keys to leave out where some are wrong in form; ``None`` where nothing can be judged then."""
        return None if "cam" in wrong else wrong | ({"require"} if "forces" in wrong else set())

    def check(self, compiled: Compiled, options: CamOptions) -> list[Finding]:
        """What is wrong with the options."""
        name, findings = chosen(compiled, options)
        if name is None:
            return findings
        reader = Reader(compiled, options, name, disc_of(compiled, name))
        reader.read()
        return reader.findings

    def run(self, compiled: Compiled, options: CamOptions, site: Site = NOWHERE) -> CamOutcome:
        """All that is asked of the cam; nothing is made of one that is undercut."""
        name, _ = chosen(compiled, options)
        assert name is not None
        disc = disc_of(compiled, name)
        stated = Reader(compiled, options, name, disc).read()
        outcome = CamOutcome(compiled, options, name, disc, frame(compiled, name), stated)
        outcome.checks = checks(disc, stated.limits)
        if stated.base is not None:
            _sizes(outcome, *stated.base)
        outcome.failures += _rough(outcome)
        if (cut := undercut(disc)) is not None:
            outcome.failures.append(_undercut(outcome, cut))
            return outcome
        outcome.figures = list(figures(disc, outcome.checks, stated.required))
        press(outcome)
        outcome.failures += [_failed(outcome, check) for check in outcome.checks if not check.kept]
        outcome.failures += [_unmet(outcome, figure) for figure in outcome.figures if not figure.kept]
        _shape(outcome)
        if stated.job is not None and options.nc is not None:
            hollow = any(finding.code == "cam.hollow" for finding in outcome.failures)
            outcome.milled, found = milled(disc, stated.job, options.nc.post, options.steps, seen(outcome.frame))
            told = [finding for finding in found if not (hollow and finding.code == "nc.concave")]
            outcome.failures += [finding for finding in told if finding.severity == "error"]
            outcome.warnings += [finding for finding in told if finding.severity != "error"]
        return outcome


def _rough(outcome: CamOutcome) -> Iterator[Finding]:
    """Jumps of the law that the limits refuse; those of the velocity no cam may have."""
    for join in outcome.law.joins:
        if join.continuity < (outcome.options.limits.continuity or 0):
            data = {"rate": JUMPS[join.continuity], "theta": _angle(outcome, join.at)}
            yield Finding("cam.rough", ("cams", outcome.name, "law"), data)


def chosen(compiled: Compiled, options: CamOptions) -> tuple[str | None, list[Finding]]:
    """The cam that is looked at, or what is wrong."""
    cams = compiled.mechanism.cams
    if options.cam is not None:
        return (options.cam, []) if options.cam in cams else (None, [unknown("cam", (*PATH, "cam"), options.cam, cams)])
    if len(cams) == 1:
        return next(iter(cams)), []
    return None, [Finding("cam.which", PATH, {"count": len(cams), "names": ", ".join(cams) or "-"})]


def _sizes(outcome: CamOutcome, low: float, high: float) -> None:
    disc, limits = outcome.disc, outcome.stated.limits
    outcome.smallest = smallest(disc, limits, low, high)
    if outcome.smallest is None:
        unit, size = outcome.compiled.quantities.unit_of(u.LENGTH)
        data = {"low": f"{low / size:.6g}", "high": f"{high / size:.6g}", "unit": unit}
        outcome.warnings.append(Finding("cam.no-base", (*PATH, "size", "base"), data, severity="warning"))
    against, size_options = outcome.stated.against, outcome.options.size
    if against is not None and size_options is not None:
        outcome.map = feasible(disc, limits, ("base", low, high), against, size_options.steps)


def _shape(outcome: CamOutcome) -> None:
    """The contour, and whether bore and hub fit into it."""
    disc, stated = outcome.disc, outcome.stated
    try:
        outcome.elements = contour(disc, stated.tolerance)
        cut = any(check.name == "groove_radius" and not check.kept for check in outcome.checks)
        if stated.limits.groove and not cut:
            outcome.outer = contour(disc, stated.tolerance, disc.follower.radius)
        if outcome.options.drawing == "splines":
            sides = (-1, 1) if outcome.outer else (-1,)
            outcome.curves = [splines(disc, stated.tolerance, side * disc.follower.radius) for side in sides]
    except Sharp as sharp:
        data = {"theta": _angle(outcome, sharp.theta), "tolerance": outcome.options.tolerance.text[:60]}
        outcome.failures.append(Finding("cam.sharp", (*PATH, "tolerance"), data))
        return
    outcome.area = area(disc)
    blank = stated.blank
    if blank is not None:
        least = next(f.value for f in outcome.figures if f.name == "radius_min")
        reach = max(blank.hub, math.hypot(blank.bore + blank.key_depth, blank.key_width / 2)) / 1e3
        if reach >= least:
            unit, size = outcome.compiled.quantities.unit_of(u.LENGTH)
            data = {"reach": f"{reach / size:.6g}", "least": f"{least / size:.6g}", "unit": unit}
            outcome.failures.append(Finding("cam.blank", (*PATH, "blank"), data))


def mending(disc: Disc, limits: Limits) -> float | None:
    """The smallest larger base circle that keeps limits."""
    return smallest(disc, limits, disc.follower.base, LARGER * disc.follower.base)


def _undercut(outcome: CamOutcome, cut: Check) -> Finding:
    smaller: Term | str = "" if outcome.disc.follower.faced else Term("or-roller")
    data = _place(outcome, cut) | _base(outcome, Limits()) | {"roller": smaller}
    return Finding("cam.undercut", ("cams", outcome.name), data)


def _failed(outcome: CamOutcome, check: Check) -> Finding:
    """A limit that isn't kept."""
    data = _place(outcome, check)
    if check.name == "hollow_radius":
        limits = replace(Limits(), cutter=check.limit)
        return Finding("cam.hollow", ("cams", outcome.name), data | _base(outcome, limits))
    return Finding("cam.limit", (*PATH, "limits"), data)


def _unmet(outcome: CamOutcome, figure: Figure) -> Finding:
    unit, size = outcome.compiled.quantities.unit_of(figure.dimension)
    data = {"name": figure.name, "value": f"{figure.value / size:.6g}", "unit": unit}
    wanted = str(outcome.options.require[figure.name].raw)
    return Finding("cam.required", (*PATH, "require", figure.name), data | {"wanted": wanted})


def _place(outcome: CamOutcome, check: Check) -> dict[str, object]:
    """A check in the file's units."""
    dimension = u.ANGLE if check.name.startswith("pressure") else u.LENGTH
    unit, size = outcome.compiled.quantities.unit_of(dimension)
    limit = "-" if check.limit is None else f"{check.limit / size:.6g}"
    data = {"name": NAMED[check.name], "value": f"{check.value / size:.6g}", "limit": limit, "unit": unit}
    return data | {"theta": _angle(outcome, check.theta)}


def _angle(outcome: CamOutcome, theta: float) -> str:
    unit, size = outcome.compiled.quantities.unit_of(u.ANGLE)
    return f"{theta / size:.6g} {unit}"


def _base(outcome: CamOutcome, limits: Limits) -> dict[str, object]:
    """The base circle that mends it, where there is one."""
    found = mending(outcome.disc, limits)
    unit, size = outcome.compiled.quantities.unit_of(u.LENGTH)
    return {"base": Term("no-base") if found is None else f"{UP * found / size:.6g} {unit}"}
