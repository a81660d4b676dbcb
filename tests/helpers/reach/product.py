"""The workspace study performed on a case, and what came of it."""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from typing import Any

import shapely

import linkwright as lw
from helpers.reach.cases import Case, make
from helpers.reach.judging import OUTCOMES, RAISED, REFUSED, Claim, Verdict, claims, judged
from helpers.reach.raster import FIRST, raster
from linkwright.expressions import units as u
from linkwright.findings import ModelError
from linkwright.studies.workspace.report import workspace_entry


class Refused(Exception):
    """The study gives findings instead of regions."""


@dataclass
class Outcome:
    """What came of a case: a verdict on each mode, or one for all with what was raised."""

    seed: int
    family: str
    verdicts: list[Verdict] = field(default_factory=list)
    seconds: float = 0.0
    oracle_seconds: float = 0.0

    @property
    def outcome(self) -> str:
        """The worst of its verdicts."""
        return max((one.outcome for one in self.verdicts), key=OUTCOMES.index)


def studied(case: Case) -> list[Claim]:
    """What the study claims of a case; raises :class:`Refused` with its findings."""
    try:
        outcome = lw.workspace(lw.Document.model_validate(case.document))
    except ModelError as error:
        raise Refused(" ".join(finding.code for finding in error.findings)) from error
    if outcome.failures:
        raise Refused(" ".join(finding.code for finding in outcome.failures))
    size = outcome.compiled.quantities.unit_of(u.LENGTH)[1]
    shapes = [shapely.transform(one.shape, lambda at: at / size) for one in outcome.regions]
    return claims(workspace_entry(outcome)["workspace"]["regions"], shapes, case.mechanism.modes)


def tried(seed: int, first: int = FIRST) -> Outcome:
    """A case studied and judged by a raster of ``first`` cells a side, halved; whatever is raised is a verdict too."""
    case = make(seed)
    outcome = Outcome(seed, case.family)
    begun = time.perf_counter()
    try:
        given = studied(case)
    except Refused as error:
        outcome.verdicts = [Verdict("", REFUSED, str(error))]
    except Exception as error:
        outcome.verdicts = [Verdict("", RAISED, f"{type(error).__name__}: {error}"[:300])]
    outcome.seconds = time.perf_counter() - begun
    if not outcome.verdicts:
        begun = time.perf_counter()
        outcome.verdicts = judged(case.mechanism, raster(case.mechanism, first=first).truths, given)
        outcome.oracle_seconds = time.perf_counter() - begun
    return outcome


def as_dict(outcome: Outcome) -> dict[str, Any]:
    """The outcome as data."""
    verdicts = [vars(one) for one in outcome.verdicts]
    return {**vars(outcome), "verdicts": verdicts, "outcome": outcome.outcome}
