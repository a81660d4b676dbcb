"""Motion laws that make no sense with a deviation alone: a width of which no other segment takes up the deviation."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from linkwright.kernels import Compiled
from linkwright.kernels.motion_faults import asking
from linkwright.kernels.motions import Reader
from linkwright.laws import MotionError
from linkwright.laws.motion import jumping
from linkwright.model.findings import Finding
from linkwright.notation.duals import Dual
from linkwright.studies.accuracy.contributors import Contributors


def check_laws(compiled: Compiled, deviations: Contributors) -> Iterator[Finding]:
    """Laws that don't add up, close or run on without jumps along the direction of some deviation."""
    m, askers = compiled.mechanism, asking(compiled.mechanism)
    for law, motion in compiled.motions.items():
        wrong = []
        for one in deviations.every:
            slopes = dict(zip(compiled.graph.parameters, one.direction.tolist(), strict=True))
            moved = {n: Dual(motion.nominal[n], np.array([[slopes[n]]])) for n in motion.names if slopes[n]}
            if not moved:
                continue
            try:
                made = Reader(compiled.quantities, m.laws[law], {**motion.nominal, **moved}).motion()
                alone = law in askers and bool(np.any(jumping(made)))
            except MotionError:
                alone = True
            wrong += [one.name] if alone else []
        if wrong:
            yield Finding("accuracy.law", ("laws", law), {"law": law, "names": ", ".join(wrong)})
