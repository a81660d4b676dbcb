"""Proving reported extremes: the grade *enclosed*, and a second look where a proof finds what the search missed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from linkwright.enclosures import Claim, Proof, prove_all
from linkwright.measures.check import BEYOND, ROUND_OFF
from linkwright.measures.found import MeasureResult
from linkwright.measures.grades import Grade, Kind
from linkwright.measures.measure import Measurer

BUDGET = 1200
"""Panels that are evaluated at most for the measures of a run."""
LOOKS = 3
"""How often a refuted extreme is searched for again."""


def enclose(measurer: Measurer, results: Sequence[MeasureResult]) -> list[MeasureResult]:
    """The same results with the grade *enclosed* where intervals prove that no value lies outside.

    Where a proof finds a value outside, the search looks there and everything is measured again.
    """
    for look in range(LOOKS):
        claims = {result.name: claim for result in results if (claim := _claim(measurer, result)) is not None}
        if not claims:
            return list(results)
        pieces = measurer.search.places.pieces
        edges = np.concatenate([pieces.before, pieces.after]).tolist()
        proofs = dict(zip(claims, prove_all(measurer.run, [*claims.values()], edges, BUDGET), strict=True))
        missed = [proof.refuted.time for proof in proofs.values() if proof.refuted is not None]
        if not missed or look == LOOKS - 1:
            break
        measurer.look_at(missed)
        results = measurer.all()
    return [_graded(result, proofs.get(result.name)) for result in results]


def _claim(measurer: Measurer, result: MeasureResult) -> Claim | None:
    """What a measure says of its expression, where that is finite and continuous on each piece."""
    measure, run = result.measure, measurer.run
    if not result.found or measure.wrap is not None or any(found.unbounded for found in result.found):
        return None
    if measure.reduction not in (*BEYOND, "span"):
        return None
    probe = measurer.probe(result.name, measure.window)
    if probe.limits:
        return None
    high, low = BEYOND.get(measure.reduction, ("", ""))
    top = np.inf if high is None else probe.top().value
    bottom = -np.inf if low is None else probe.bottom().value
    slack = ROUND_OFF * run.usual(result.dimension)
    return Claim(probe.node, tuple((float(a), float(b)) for a, b in probe.intervals), bottom, top, slack)


def _graded(result: MeasureResult, proof: Proof | None) -> MeasureResult:
    if proof is None:
        return result
    if proof.done:
        return replace(result, found=tuple(replace(found, grade=Grade(Kind.ENCLOSED)) for found in result.found))
    grades = (replace(found, grade=replace(found.grade, reason=proof.reason)) for found in result.found)
    return replace(result, found=tuple(grades))
