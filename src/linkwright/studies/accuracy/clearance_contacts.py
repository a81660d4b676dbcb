"""Where joints with clearance rest: what their kinds, and rollers of cams, hold with the stated clearances.

Each contact is displaced by the clearance along its force. The clearance as a massless link: Garrett and Hall 1969;
docs/theory.md.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise

import numpy as np

from linkwright.elements.clearance import Axis, Known, LooseJoint, StatedClearance
from linkwright.expressions.units import LENGTH
from linkwright.graph.geometry import Geometry
from linkwright.graph.rows import BodyPlace, Named
from linkwright.kernels import Compiled
from linkwright.studies.accuracy.clearance_options import Clearance
from linkwright.studies.accuracy.rollers import on_roller, rollers


def loose_joints(compiled: Compiled, clearances: Mapping[str, Clearance]) -> list[LooseJoint]:
    """What is held with the stated clearances, which are sound."""
    joints, of_rollers = compiled.structure.topology.joints, rollers(compiled)
    geometry = Geometry(compiled.quantities, compiled.quantities.parameters)
    found: list[LooseJoint] = []
    for name, entry in clearances.items():
        clearance = compiled.quantities.value(entry.clearance, LENGTH)
        if name in joints:
            kind, links = joints[name]
            length = None if entry.length is None else compiled.quantities.value(entry.length, LENGTH)
            found += kind.play(geometry, name, links, StatedClearance(clearance, length, entry.centre, entry.in_))
        else:
            found.append(on_roller(compiled, of_rollers[name], clearance))
    return found


def named(known: Known) -> Named:
    """The row of what a joint asks of a pose."""
    return BodyPlace(*known) if isinstance(known, Axis) else known


def columns(joints: Sequence[LooseJoint]) -> list[range]:
    """Where the displacements of each stand among those of all."""
    ends = np.cumsum([0, *(len(one.plays) for one in joints)]).tolist()
    return [range(start, stop) for start, stop in pairwise(ends)]
