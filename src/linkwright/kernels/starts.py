"""Whether drives start where the sketch is drawn."""

from __future__ import annotations

import math
from collections.abc import Mapping

from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression
from linkwright.findings import Finding
from linkwright.kernels.law import DriveLaw
from linkwright.kernels.laws import values_at
from linkwright.model.desugar import Spelled
from linkwright.model.plausible import amount
from linkwright.model.quantities import Quantities

NEAR = math.radians(0.1)
"""A start this near to the drawn angle (rad) is the drawn one, rounded; of a length, its share of that."""


def moved_starts(spelled: Spelled, quantities: Quantities, laws: Mapping[str, DriveLaw]) -> list[Finding]:
    """A warning for each drive that starts elsewhere than drawn, and doesn't say so by ``sketch``."""
    findings, starts = [], values_at(dict(laws), 0.0)
    for name, text in spelled.drawn.items():
        dimension = quantities.drive_dimension(name)
        drawn = quantities.value(Expression(text), dimension)
        off = starts[name] - drawn
        if dimension == u.ANGLE:  # whole turns away is the same pose
            off = math.remainder(off, 2 * math.pi)
        if not abs(off) > NEAR * (1.0 if dimension == u.ANGLE else abs(drawn)):
            continue
        key = "start" if spelled.placed.drives[name].start is not None else "position"
        unit, size = quantities.drive_unit(name)
        data = {"name": name, "start": amount(quantities, starts[name], dimension)}
        data |= {"drawn": amount(quantities, drawn, dimension), "off": amount(quantities, abs(off), dimension)}
        data |= {"apart": f"sketch {'+' if off > 0 else '-'} {abs(off) / size:.6g} {unit}"}
        code = "sketch.other-start" if key == "start" else "sketch.other-position"
        findings.append(Finding(code, ("drives", name, key), data, severity="warning"))
    return findings
