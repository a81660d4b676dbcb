"""Proving reported extremes: the grade *enclosed*, and a second look where a proof finds what the search missed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from linkwright.enclosures import Claim, Proof, prove_all
from linkwright.measures.check import ROUND_OFF
from linkwright.measures.found import MeasureResult
from linkwright.measures.measure import Measurer
from linkwright.reductions import Grade, ProofKind, kind_of

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
        pieces = [measurer.search.places.pieces[claim.node] for claim in claims.values()]
        edges = np.unique(np.concatenate([edge for one in pieces for edge in (one.before, one.after)])).tolist()
        proofs = dict(zip(claims, prove_all(measurer.run, [*claims.values()], edges, BUDGET), strict=True))
        missed = {
            claims[name].node: [proof.refuted.time] for name, proof in proofs.items() if proof.refuted is not None
        }
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
    proven = kind_of(measure).proven
    if not proven:
        return None
    probe = measurer.probe(measurer.by_name[result.name])
    if probe.limits:
        return None
    top = probe.top().value if 1.0 in proven else np.inf
    bottom = probe.bottom().value if -1.0 in proven else -np.inf
    slack = ROUND_OFF * run.usual([result.dimension])[0]
    return Claim(probe.node, tuple((float(a), float(b)) for a, b in probe.intervals), bottom, top, slack)


def _graded(result: MeasureResult, proof: Proof | None) -> MeasureResult:
    if proof is None:
        return result
    if proof.is_proven:
        return replace(result, found=tuple(replace(found, grade=Grade(ProofKind.ENCLOSED)) for found in result.found))
    grades = (replace(found, grade=replace(found.grade, reason=proof.reason)) for found in result.found)
    return replace(result, found=tuple(grades))
