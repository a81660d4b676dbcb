"""The modes study: every way to put the mechanism together at a pose, and which of them motion joins."""

from __future__ import annotations

from typing import Annotated, Any

import numpy as np

from linkwright.compilation import Prepared
from linkwright.elements.fields import DriveName
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Frozen
from linkwright.expressions.typed_fields import Quantity
from linkwright.findings import Finding, ModelError
from linkwright.graph.constraints import FollowerRelation
from linkwright.graph.geometry import ZERO
from linkwright.graph.mode_survey import SAME, survey
from linkwright.graph.modes import Mode
from linkwright.kernels import Compiled
from linkwright.kernels.followers import FollowerLaw
from linkwright.kernels.laws import values_at
from linkwright.model.quantities import Quantities
from linkwright.model.references import option_faults
from linkwright.presentation.blocks import StudyReport
from linkwright.studies.cycle.options import LONGEST
from linkwright.studies.modes.outcome import ModesOutcome
from linkwright.studies.modes.report import report
from linkwright.studies.numbers import constant
from linkwright.studies.registry import Study, register
from linkwright.studies.run_context import NOWHERE, RunContext

PATH = ("studies", "modes")


class ModesOptions(Frozen):
    """At which pose, and over which drive circuits are followed."""

    at: Annotated[Expression | None, Quantity(u.TIME)] = None
    drive: DriveName | None = None


def find_modes(made: Prepared | Compiled, options: ModesOptions) -> ModesOutcome:
    """All modes of a mechanism whose structure is sound. Raises :class:`ModelError` for options that can't be."""
    findings = check_options(made, options)
    if findings:
        raise ModelError(findings)
    time = _time(made.quantities, options)
    values = values_at(made.laws, time)
    found = survey(made.quantities, made.structure, values, options.drive, _rides(made))
    return ModesOutcome(made.quantities, found, time, values)


def check_options(made: Prepared | Compiled, options: ModesOptions) -> list[Finding]:
    """What is wrong with the options."""
    if unnamed := option_faults(made.mechanism, options, PATH):
        return unnamed
    if options.drive is not None and isinstance(law := made.laws[options.drive], FollowerLaw):
        return [Finding("study.follower", (*PATH, "drive"), {"name": options.drive, "motor": law.motor})]
    time, wrong = 0.0, list[Finding]()
    if options.at is not None:
        value, wrong = constant(made.quantities, options.at, u.TIME, (*PATH, "at"), LONGEST)
        time = value or 0.0
    if wrong:
        return wrong
    try:
        values_at(made.laws, time)
    except ModelError as error:
        return list(error.findings)
    return []


def _rides(made: Prepared | Compiled) -> dict[str, FollowerRelation]:
    """How the followers of cams move with their motors."""
    found = {}
    for name, follower in made.quantities.mechanism.followers.items():
        law = made.laws[name]
        assert isinstance(law, FollowerLaw)
        found[name] = FollowerRelation(law.motor, law.along, follower.step(made.motions))
    return found


def _time(quantities: Quantities, options: ModesOptions) -> float:
    return 0.0 if options.at is None else quantities.value(options.at, u.TIME)


@register
class Modes(Study):
    """Every way to put the mechanism together."""

    name = "modes"
    example = "{drive: motor}"
    options = ModesOptions
    rank = 2

    def check(self, compiled: Compiled, options: ModesOptions) -> list[Finding]:
        """What is wrong with the options."""
        return check_options(compiled, options)

    def run(self, compiled: Compiled, options: ModesOptions, site: RunContext = NOWHERE) -> ModesOutcome:
        """Find the modes, and the one that the mechanism has at that time."""
        outcome = find_modes(compiled, options)
        outcome.own = own_mode(compiled, outcome)
        return outcome

    def report(self, outcome: ModesOutcome) -> StudyReport:
        """Circuits, and each mode."""
        return report(outcome)


def own_mode(compiled: Compiled, outcome: ModesOutcome) -> int | None:
    """The mode in which the compiled mechanism is at the outcome's time."""
    here = compiled.evaluate(compiled.graph.pose_rows, np.array([outcome.time]))[:, 0].reshape(-1, 4)
    scale = np.array([*(2 * [compiled.assembly.size()]), 1.0, 1.0])
    away: list[float] = []
    for mode in outcome.modes:
        there = [_row(mode, link) for link in compiled.structure.topology.moving]
        away.append(float(np.nan_to_num(np.abs((here - there) / scale), nan=np.inf).max()))
    best = int(np.argmin(away)) if away else 0
    return best if away and away[best] < 100 * SAME else None


def _row(mode: Mode, link: str) -> list[Any]:
    body = mode.bodies[link]
    return [*body.point(ZERO).now, *body.axis.now]
