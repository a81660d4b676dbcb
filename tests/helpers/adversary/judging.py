"""What a run says of each case, and whether that is right, wrong, or not said.

:func:`answers` is the one place that knows how results are reported.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from helpers.adversary.cases import Batch, Case, Wanted

RIGHT, UNBOUNDED, MISSED, REFUSED, WRONG = "found", "said unbounded", "missed", "refused", "wrong in silence"
OUTCOMES = RIGHT, UNBOUNDED, MISSED, REFUSED, WRONG
SIDES = {-1: -1, 1: 1, "before": -1, "after": 1, "left": -1, "right": 1, "-": -1, "+": 1}


@dataclass(frozen=True)
class Said:
    """A number as reported: value (SI), time (s) and side of it, and the width (s) below which it may miss things."""

    value: float
    time: float | None = None
    side: int | None = None
    width: float = 0.0
    kind: str = "ungraded"


@dataclass(frozen=True)
class Answer:
    """What is reported of a measure: numbers by label, codes of findings."""

    said: dict[str, Said]
    codes: tuple[str, ...] = ()


@dataclass(frozen=True)
class Verdict:
    """What came of a case."""

    case: Case
    outcome: str
    grade: str = ""
    width: float = 0.0
    why: str = ""


def answers(job: Any) -> dict[str, Answer]:
    """The answers of a job by the names of the measures."""
    found: dict[str, list[str]] = {}
    for finding in (*job.found, *job.cycle.failures, *job.cycle.warnings):
        if finding.code.startswith("measure.") and len(finding.path) > 1:
            found.setdefault(str(finding.path[1]), []).append(finding.code)
    return {
        m.name: Answer({one.label: _said(one) for one in m.found}, tuple(found.get(m.name, ())))
        for m in job.cycle.measures
    }


def _said(found: Any) -> Said:
    grade = getattr(found, "grade", None)
    kind = str(getattr(grade, "kind", "ungraded"))
    width = getattr(grade, "width", None)
    if width is None:
        width = math.inf if kind == "sampled" else 0.0
    return Said(found.value, found.time, SIDES.get(getattr(found, "side", None)), float(width), kind)


def judged(batch: Batch, given: dict[str, Answer]) -> list[Verdict]:
    """The verdict on each case of a batch."""
    return [judge(case, given.get(case.name, Answer({}))) for case in batch.cases]


def judge(case: Case, answer: Answer) -> Verdict:
    """The verdict on one case: the worst of its numbers."""
    if not answer.said:
        if answer.codes:
            return Verdict(case, REFUSED, why=", ".join(answer.codes))
        return Verdict(case, WRONG, why="neither a number nor a finding")
    verdicts = [_number(case, label, number, answer.said.get(label)) for label, number in case.wanted.items()]
    return max(verdicts, key=lambda verdict: OUTCOMES.index(verdict.outcome))


def _number(case: Case, label: str, number: Wanted, said: Said | None) -> Verdict:
    def verdict(outcome: str, why: str = "") -> Verdict:
        grade, width = (said.kind, said.width) if said else ("", 0.0)
        return Verdict(case, outcome, grade, width, f"{label or 'value'}: {why}" if why else "")

    if said is None:
        return verdict(WRONG, "no number of this label")
    given = f"{said.value!r} at {said.time!r}, truth {number.value!r}"
    if math.isnan(said.value):
        return verdict(WRONG, "NaN")
    if not math.isfinite(number.value):
        if math.isfinite(said.value):
            return verdict(WRONG, f"a number for what is unbounded: {given}")
        if not math.isnan(number.value) and said.value != number.value:
            return verdict(WRONG, f"the wrong infinity: {given}")
        return verdict(UNBOUNDED) if _placed(number, said) else verdict(WRONG, f"wrong place: {given} {number.places}")
    if math.isinf(said.value):
        return verdict(WRONG, f"unbounded, but it is finite: {given}")
    if abs(said.value - number.value) <= number.tolerance:
        return verdict(RIGHT)
    excused = case.width < said.width
    return verdict(
        MISSED if excused else WRONG, f"{given}, off by {abs(said.value - number.value) / number.tolerance:.2g}"
    )


def _placed(number: Wanted, said: Said) -> bool:
    if not number.places:
        return True
    if said.time is None:
        return False
    sides = (said.side,) if said.side else (-1, 1)
    return any(abs(said.time - time) <= number.slack and side in sides for time, side in number.places)


def faults(verdicts: Iterable[Verdict]) -> list[str]:
    """What is wrong in silence, a line each."""
    return [
        f"{v.case.name} ({v.case.family}, width {v.case.share:.1g} of the run, {v.grade or 'no grade'}): "
        f"{v.case.measure} {v.why}"
        for v in verdicts
        if v.outcome == WRONG
    ]
