"""Measures with known truth, made to be hard: a batch of them for every seed, and a judge of what a run says of them.

batch = make(seed)
verdicts = judged(batch, answers(lw.run(lw.Document.model_validate(batch.document))))
"""

from __future__ import annotations

import random

from mpmath import mp

from helpers.adversary.cases import Batch, Case, Wanted, clock_batch
from helpers.adversary.dead_centres import dead_centre_batch
from helpers.adversary.judging import Answer, Said, Verdict, answers, faults, judge, judged
from helpers.adversary.laws import law_batch, table_batch
from helpers.adversary.linkages import four_bar_batch, guide_batch, near_change_batch
from helpers.adversary.trees import DIGITS

__all__ = ["Answer", "Batch", "Case", "Said", "Verdict", "Wanted", "answers", "faults", "judge", "judged", "make"]

COUNT = 40
"""Measures of a batch, at most: laws, tables and change points take fewer."""
MAKERS = (
    clock_batch, four_bar_batch, dead_centre_batch, guide_batch, clock_batch, law_batch, clock_batch, near_change_batch,
    clock_batch, table_batch,
)  # fmt: skip


def make(seed: int) -> Batch:
    """The batch of a seed."""
    with mp.workdps(DIGITS):
        return MAKERS[seed % len(MAKERS)](seed, random.Random(seed), COUNT)
