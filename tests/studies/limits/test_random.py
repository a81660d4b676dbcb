"""Limits of random mechanisms: what is said of a range holds at every place of it, and it ends where it is said to."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings

from helpers.compiled import compiled_of
from helpers.plain import Plain, document_of
from helpers.random_mechanisms import Seeded, build, driven_elsewhere, mechanisms, sketched
from linkwright.graph.rows import Determinant, ReachRow
from linkwright.model.document import Document
from linkwright.structure import decompose
from linkwright.studies.limits.outcome import RunLimits
from linkwright.studies.limits.ranges import Range
from linkwright.studies.limits.study import Limits, LimitsOptions

STUDY = Limits()


def holds(found: Range, stretch: RunLimits, shares: Any) -> None:
    """Every figure of a range bounds what is seen at some shares of it."""
    run, groups = found.sweep, found.sweep.compiled.structure.groups
    pole = "pole" in (found.low.kind, found.high.kind)  # what hangs on a slide that runs away has few digits left
    t = run.place(shares * 0.99 + 0.005 if pole else shares)[0]
    rows = [row(group.label) for row in (ReachRow, Determinant) for group in groups]
    if rows:
        values = run.compiled.evaluate(rows, t)
        assert np.isfinite(values).all()
        assert (values[: len(groups)] > -1e-12).all()
        least = np.sin([transmission.angle for transmission in stretch.transmission])
        assert (np.abs(values[len(groups) :]) > least[:, None] - (1e-5 if pole else 1e-9)).all()
    for course in stretch.courses:
        seen = run.evaluate([course.signal], t)[0]
        assert np.isfinite(seen).all()
        tiny = (1e-4 if pole else 1e-7) * (1 + np.abs(seen).max())
        assert course.low.value - tiny <= seen.min()
        assert course.high.value + tiny >= seen.max()
        turning = np.sort([r.time for r in course.reversals])
        if not stretch.touches and not pole:
            # Between two dead centres it goes one way.
            edges = [run.start, *turning, run.stop]
            for a, b in pairwise(edges):
                way = np.diff(run.evaluate([course.signal], np.linspace(a, b, 40))[0])
                assert (way > -tiny).all() or (way < tiny).all()


def ends(found: Range) -> None:
    """Just past a dead end the group that is named fails."""
    run, past = found.sweep, 1e-6 * (found.sweep.stop - found.sweep.start)
    for end, time in ((found.low, run.start - past), (found.high, run.stop + past)):
        if end.kind == "group":
            assert run.compiled.evaluate([ReachRow(end.group)], np.array([time]))[0, 0] < 0
            assert abs(run.compiled.evaluate([ReachRow(end.group)], np.array([end.value - run.origin]))[0, 0]) < 1e-12


@settings(max_examples=20, deadline=None)
@given(mechanisms())
def test_of_random_mechanisms(plain: Plain) -> None:
    compiled = compiled_of(plain)
    outcome = STUDY.run(compiled, LimitsOptions())
    shares = np.random.default_rng(1).uniform(1e-6, 1 - 1e-6, 150)
    assume(all(limits.ranges for limits in outcome.drives))
    for limits in outcome.drives:
        for found, stretch in limits.ranges:
            holds(found, stretch, shares)
            ends(found)
        assert any(found.sweep.start <= 0 <= found.sweep.stop for found, _ in limits.ranges)


@pytest.mark.parametrize(("chain", "seed"), [("four_bar", 0), ("slider_crank", 3), ("elliptic_trammel", 9)])
def test_of_mechanisms_with_a_drive_inside_a_loop(chain: str, seed: int) -> None:
    """Both ways from the start; in the last one slides run away, which takes no longer than all else."""
    source = Seeded(seed)
    plain = driven_elsewhere(build(chain, source), source)
    links = decompose(Document.model_validate(document_of(plain))).topology.moving
    outcome = STUDY.run(compiled_of(sketched(plain, links)), LimitsOptions())
    ranges = outcome.drives[0].ranges
    assert any(found.sweep.start <= 0 <= found.sweep.stop for found, _ in ranges)
    for found, stretch in ranges:
        assert {found.low.kind, found.high.kind} <= ({"pole"} if chain == "elliptic_trammel" else {"group", "window"})
        holds(found, stretch, np.random.default_rng(1).uniform(0.01, 0.99, 100))
