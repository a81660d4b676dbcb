"""The motion laws of a mechanism as functions: their numbers in SI, their formulas on jets."""

from __future__ import annotations

from dataclasses import dataclass
from math import isfinite, pi
from typing import Any

import numpy as np

from linkwright.laws import (
    LAWS,
    Blend,
    Curve,
    Dwell,
    Fault,
    Formula,
    Law,
    Motion,
    MotionError,
    Rise,
    Segment,
    Shape,
    b_spline,
    motion,
    of_powers,
    scca,
    scca_by_widths,
    series,
)
from linkwright.model import motions as stated
from linkwright.model.expressions import Binary, Call, Name, Negative, Node, Number, evaluate
from linkwright.model.fields import Expression
from linkwright.model.findings import Finding, Term
from linkwright.model.quantities import Quantities
from linkwright.model.units import PURE, Dimension
from linkwright.notation import Jet

CLOSE = 1e-9
"""How closely fractions must add up to 1."""
NARROWEST = 1e-6
"""The smallest fraction of a zone of acceleration that isn't zero."""
EDGE = 1e-3
"""How near to an end of its way a law may be fastest."""


def motion_laws(quantities: Quantities) -> tuple[dict[str, Motion], list[Finding]]:
    """The motion of each law of a mechanism (SI), and what is wrong with them."""
    made: dict[str, Motion] = {}
    findings: list[Finding] = []
    for name, law in quantities.mechanism.laws.items():
        reader = _Reader(quantities, law)
        if not all(isfinite(reader.number(number, of)) for _, number, of in law.numbers()):
            continue  # told where all numbers are looked at
        try:
            made[name] = reader.motion()
        except MotionError as error:
            findings += [reader.finding(name, fault) for fault in error.faults]
    return made, findings


def rate_unit(quantities: Quantities, law: stated.MotionLaw, order: int) -> tuple[str, float]:
    """The unit in which a derivative of a law by its axis is told, and its SI value: ``mm/deg^2``."""
    (value, size), (axis, one) = quantities.unit_of(law.value), quantities.unit_of(law.axis)
    power = f"/{axis}^{order}" if order > 1 else f"/{axis}" if order else ""
    return value + power, size / one**order


@dataclass
class _Reader:
    quantities: Quantities
    law: stated.MotionLaw

    def motion(self) -> Motion:
        """Raises :class:`MotionError`."""
        segments, faults = [], []
        for i, entry in enumerate(self.law.segments):
            try:
                segments.append(self.segment(entry))
            except _WrongError as wrong:
                faults.append(Fault(wrong.code, i, wrong.data))
        if faults:
            raise MotionError(faults)
        period = 2 * pi if self.law.over == "angle" and self.law.beyond != "hold" else None
        if self.law.period is not None:
            period = self.number(self.law.period, self.law.axis)
        return motion(segments, self.number(self.law.start, self.law.value), period, self.law.beyond)

    def number(self, of: Expression, dimension: Dimension) -> float:
        return self.quantities.value(of, dimension)

    def numbers(self, of: tuple[Expression, ...] | None, dimension: Dimension = PURE) -> list[float]:
        return [self.number(each, dimension) for each in of or ()]

    def segment(self, s: stated.Segment) -> Segment:
        over, axis, value = self.number(s.width, self.law.axis), self.law.axis, self.law.value
        if s.dwell is not None:
            return Dwell(over)
        if s.control is not None:
            degree = s.degree or 5
            if len(s.control) < degree + 1:
                raise _WrongError("law.control", given=len(s.control), wanted=degree + 1)
            return Shape(over, b_spline(self.numbers(s.control, value), degree))
        if s.harmonics is not None:
            rows = [self.numbers(row, value) for row in s.harmonics]
            return Shape(over, series([a for a, _ in rows], [b for _, b in rows]))
        if s.fall is not None:
            return Rise(over, -self.number(s.fall, value), self.normalised(s), fall=True)
        assert s.rise is not None
        lift = self.number(s.rise, value)
        if any((s.law, s.fractions, s.powers, s.formula)):
            return Rise(over, lift, self.normalised(s))
        via = tuple((self.number(x, axis), self.number(y, value)) for x, y in s.via or ())
        return Blend(over, lift, self.rates(s, s.from_), self.rates(s, s.to), via, stated.DEGREES.get(s.spline or ""))

    def rates(self, s: stated.Segment, given: tuple[Expression, ...] | None) -> tuple[float | None, ...]:
        """The rates at an end: those given, then those of the neighbour."""
        own = [self.number(rate, self.law.rate(k)) for k, rate in enumerate(given or (), start=1)]
        return (*own, *[None] * (stated.MATCHED.get(s.match or "", 0) - len(own)))

    def normalised(self, s: stated.Segment) -> Curve:
        """The law of a rise or fall."""
        if s.formula is not None:
            return self.formula(s.formula)
        if s.powers is not None:
            if len({*s.powers}) < len(s.powers):
                raise _WrongError("law.powers")
            return of_powers(s.powers)
        law = LAWS[s.law] if s.law is not None else self.member(self.numbers(s.fractions))
        if s.skew is None:
            return law
        share = self.number(s.skew, PURE)
        if not EDGE <= share <= 1 - EDGE or not law.symmetric:
            raise _WrongError("law.skew", share=f"{share:.6g}")
        return law.skewed(share)

    def member(self, fractions: list[float]) -> Law:
        """A member of the SCCA family."""
        fit = (
            len(fractions) in (4, 7)
            and abs(sum(fractions) - 1) < CLOSE
            and all(f == 0 or f >= NARROWEST for f in fractions)
        )
        halves = (fractions[:3],) if len(fractions) == 4 else (fractions[:3], fractions[4:])
        if not fit or any(sum(half) == 0 for half in halves):
            raise _WrongError("law.fractions", count=len(fractions), sum=f"{sum(fractions):.10g}")
        return Law((scca if len(fractions) == 4 else scca_by_widths)(*fractions).parts)

    def formula(self, expression: Expression) -> Curve:
        node = self.quantities.formula(expression)
        values = self.quantities.parameters

        def function(u: Jet) -> Jet:
            value = evaluate(node, lambda name: u if name.text == stated.ARGUMENT else values[name.text])
            return value if isinstance(value, Jet) else Jet.constant(value, u.order)

        curve = Curve((Formula(function, lambda x: spelled(node, {**values, stated.ARGUMENT: x})),))
        grid = np.linspace(0.0, 1.0, 257)
        if not all(np.isfinite(curve.at(grid, order)).all() for order in range(3)):
            raise _WrongError("law.not-smooth")
        return curve

    def finding(self, name: str, fault: Fault) -> Finding:
        """A fault of a motion in the units of the file."""
        path = ("laws", name) if fault.segment is None else ("laws", name, "segments", fault.segment)
        dimension = self.law.axis if fault.code == "law.period" else self.law.value
        unit, size = self.quantities.unit_of(dimension)
        data = {k: f"{v / size:.10g}" if isinstance(v, float) else v for k, v in fault.data.items()}
        if fault.code in ("law.period", "law.not-closed"):
            data["unit"] = unit
        if "side" in data:
            data["side"] = Term("law-end" if data["side"] == "end" else "law-start")
        return Finding(fault.code, path, data)


class _WrongError(ValueError):
    """A segment that can't be made."""

    def __init__(self, code: str, **data: Any) -> None:
        super().__init__(code)
        self.code, self.data = code, data


def spelled(node: Node, values: dict[str, Any]) -> str:
    """A bound tree as text that says it exactly: numbers as Python writes them, names by their values or texts."""
    if isinstance(node, Number):
        return repr(float(node.value)) if node.value >= 0 else f"({float(node.value)!r})"
    if isinstance(node, Name):
        value = node.text if node.text == "pi" else values[node.text]
        return value if isinstance(value, str) else spelled(Number(float(value)), values)
    if isinstance(node, Negative):
        return f"(-{spelled(node.of, values)})"
    if isinstance(node, Call):
        return f"{node.name}({', '.join(spelled(arg, values) for arg in node.args)})"
    assert isinstance(node, Binary)
    return f"({spelled(node.left, values)} {node.op} {spelled(node.right, values)})"
