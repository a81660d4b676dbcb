"""Motion laws and tables that make no sense with a deviation alone: a width of which no other segment takes up the
deviation."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from linkwright.findings import Finding, Joined
from linkwright.kernels import Compiled
from linkwright.kernels.motion_faults import asking
from linkwright.kernels.motions import MotionReader
from linkwright.kernels.tables import open_ends
from linkwright.laws import MotionError
from linkwright.laws.motion import jumping
from linkwright.notation.duals import Dual, slope_of
from linkwright.studies.accuracy.contributors import Contributor, Contributors


def check_laws(compiled: Compiled, deviations: Contributors) -> Iterator[Finding]:
    """Laws that don't add up, close or run on without jumps along the direction of some deviation; tables that don't
    close."""
    quantities, m = compiled.quantities, compiled.mechanism
    askers, moved = asking(m), {one.name: _parameter_duals(compiled, one) for one in deviations.every}
    for law, motion in compiled.motions.items():
        wrong = [
            name
            for name, given in moved.items()
            if any(isinstance(given[own], Dual) for own in motion.names)
            and _senseless(MotionReader(quantities, m.laws[law], given), law in askers)
        ]
        if wrong:
            yield Finding("accuracy.law", ("laws", law), {"law": law, "names": Joined(wrong)})
    for name, table in m.tables.items():
        open_by = [one for one, given in moved.items() if np.any(slope_of(open_ends(quantities, table, given)))]
        if open_by:
            yield Finding("accuracy.table", ("tables", name), {"table": name, "names": Joined(open_by)})


def _parameter_duals(compiled: Compiled, one: Contributor) -> dict[str, float | Dual]:
    """The parameters along the direction of a deviation."""
    rows = zip(compiled.quantities.parameters.items(), one.direction.tolist(), strict=True)
    return {name: Dual(value, np.array([[slope]])) if slope else value for (name, value), slope in rows}


def _senseless(reader: MotionReader, asked: bool) -> bool:
    """Whether a law makes no sense, or jumps where a drive or cam asks it."""
    try:
        made = reader.motion()
    except MotionError:
        return True
    return asked and bool(np.any(jumping(made)))
