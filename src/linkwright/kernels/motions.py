"""The motion laws of a mechanism as functions: their numbers in SI, their formulas on jets."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping
from dataclasses import field
from functools import partial
from math import isfinite, pi
from typing import Any

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.expressions.fields import Expression
from linkwright.expressions.language import Binary, Call, Name, Negative, Node, Number, evaluate
from linkwright.expressions.units import PURE, Dimension
from linkwright.findings import Finding, Term
from linkwright.kernels.law import Parameters
from linkwright.laws import (
    LAWS,
    Blend,
    Curve,
    Dwell,
    Formula,
    Law,
    Motion,
    MotionError,
    MotionFault,
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
from linkwright.laws.motion import jumping
from linkwright.laws.numbers import first, off, plain
from linkwright.model import motions as stated
from linkwright.model.places import ExpressionPlace, Scope
from linkwright.model.quantities import Quantities
from linkwright.model.sampled import names_in
from linkwright.notation import Jet, Scalar
from linkwright.notation.duals import Dual, value_of
from linkwright.notation.jets import symbolic

CLOSE = 1e-9
"""How closely fractions must add up to 1."""
NARROWEST = 1e-6
"""The smallest fraction of a zone of acceleration that isn't zero."""
EDGE = 1e-3
"""How near to an end of its way a law may be fastest."""
KEPT = 8
"""At how many sets of values of its parameters a law is kept."""


@dataclass(frozen=True)
class StatedMotion(Motion):
    """The motion of a law at the ``nominal`` parameters, of which its numbers hold those of some ``names``;
    ``make(parameters, checked)`` gives it at others: floats, arrays (samples, 1) or duals."""

    names: frozenset[str] = frozenset()
    nominal: Mapping[str, float] = field(default_factory=dict)
    make: Callable[[Parameters, bool], Motion] | None = None
    fixed: frozenset[str] = frozenset()
    """Those of the names that stand in shapes of the law that are no expressions of symbols."""
    _kept: dict[Any, Motion] = field(default_factory=dict, repr=False, compare=False)

    def at_parameters(self, parameters: Parameters) -> Motion:
        """At other parameters; what makes no sense there comes out as it may. At symbols an expression, in which those
        that are ``fixed`` are as at the nominal parameters."""
        if any(symbolic(parameters[name]) for name in self.names - self.fixed):
            assert self.make is not None
            return self.make(self._symbols(parameters), False)
        if parameters is self.nominal or all(_same(parameters[name], self.nominal[name]) for name in self.names):
            return self
        key = tuple(_key(parameters[name]) for name in sorted(self.names))
        if (made := self._kept.get(key)) is None:
            assert self.make is not None
            with np.errstate(all="ignore"):
                made = self.make(parameters, False)
            if len(self._kept) >= KEPT:
                self._kept.clear()
            self._kept[key] = made
        return made

    def _symbols(self, parameters: Parameters) -> Parameters:
        return {**parameters, **{name: self.nominal[name] for name in self.fixed}}

    def checked(self, parameters: Parameters) -> Motion:
        """At other parameters, all of them floats. Raises :class:`MotionError` where it makes no sense."""
        assert self.make is not None
        if unknown := [name for name in sorted(self.names) if not np.isfinite(parameters[name])]:
            raise MotionError([MotionFault("value.not-finite", None, {"text": name}) for name in unknown])
        return self if parameters is self.nominal else self.make(parameters, True)

    def places_at(self, law: str, parameters: Parameters) -> dict[str, Scalar]:
        """Where its pieces begin at other parameters, the end of the last, and the period: under names that no
        parameter has."""
        assert self.make is not None
        with np.errstate(all="ignore"):
            made = self.make(parameters, False)
        places = [*(part.start for part in made.curve.parts), made.curve.stop, made.period]
        return {f"{law}@{i}": place for i, place in enumerate(places)}


def _same(value: Any, nominal: float) -> bool:
    return not isinstance(value, Dual) and bool(np.all(value == nominal))


def _key(value: Any) -> Any:
    if isinstance(value, Dual):
        return _key(value.value), _key(value.slope)
    return (value.shape, value.tobytes()) if isinstance(value, np.ndarray) else value


def motion_laws(quantities: Quantities) -> tuple[dict[str, StatedMotion], list[Finding]]:
    """The motion of each law of a mechanism (SI), and what is wrong with them."""
    made: dict[str, StatedMotion] = {}
    findings: list[Finding] = []
    resolve, places = quantities.dimensions.resolve, defaultdict[Any, list[ExpressionPlace]](list)
    for place in quantities.places:
        if place.path[0] == "laws":
            places[place.path[1]].append(place)
    for name, law in quantities.mechanism.laws.items():
        reader = MotionReader(quantities, law, quantities.parameters)
        fixed = [place for place in places[name] if place.scope is Scope.CONSTANT]
        if not all(isfinite(reader.number(place.expression, resolve(place.wanted))) for place in fixed):
            continue  # told where all numbers are looked at
        try:
            nominal = reader.motion()
        except MotionError as error:
            findings += [reader.finding(name, fault) for fault in error.faults]
            continue
        names = {
            part for place in places[name] for part in names_in(place.expression.node)
        } & quantities.parameters.keys()
        made[name] = StatedMotion(
            nominal.curve,
            nominal.places,
            nominal.beyond,
            frozenset(names),
            quantities.parameters,
            partial(_read_motion, quantities, law),
            frozenset(part for node in fixed_parts(law) for part in names_in(node)) & names,
        )
    return made, findings


def _read_motion(quantities: Quantities, law: stated.MotionLaw, parameters: Parameters, checked: bool) -> Motion:
    return MotionReader(quantities, law, parameters).motion(checked)


FEW = 9
"""With so many unknowns at most a polynomial or spline is solved as an expression of the places of its points."""


def fixed_parts(law: stated.MotionLaw) -> Iterator[Node]:
    """The expressions of a law whose numbers aren't replaced by symbols: shapes that are cut, fitted or evaluated on
    samples to be checked, and places of many points."""
    for s in law.segments:
        shape = [*(s.fractions or ()), *filter(None, (s.skew, s.formula))]
        via, matched = s.via or (), stated.MATCHED.get(s.match or "", 0)
        rates = sum(max(matched, len(given or ())) for given in (s.from_, s.to))
        half = (stated.DEGREES.get(s.spline or "", 1) - 1) // 2
        if via and (half * len(via) if half else 2 + rates + len(via)) > FEW:
            shape += [s.width, *(place for place, _ in via)]
        yield from (each.node for each in shape)


def motion_conditions(quantities: Quantities, name: str, law: StatedMotion, parameters: Parameters) -> list[Any]:
    """What makes a motion law at symbols invalid for a drive that asks it: conditions, as expressions."""
    found: list[MotionFault] = []
    reader = MotionReader(quantities, quantities.mechanism.laws[name], law._symbols(parameters))
    made = reader.motion(found=found)
    return [*(fault.where for fault in found), jumping(made)]


def rate_unit(quantities: Quantities, law: stated.MotionLaw, order: int) -> tuple[str, float]:
    """The unit in which a derivative of a law by its axis is told, and its SI value: ``mm/deg^2``."""
    (value, size), (axis, one) = quantities.unit_of(law.value), quantities.unit_of(law.axis)
    power = f"/{axis}^{order}" if order > 1 else f"/{axis}" if order else ""
    return value + power, size / one**order


@dataclass
class MotionReader:
    """Makes the motion of a law at some parameters."""

    quantities: Quantities
    law: stated.MotionLaw
    parameters: Parameters

    def motion(self, checked: bool = True, found: list[MotionFault] | None = None) -> Motion:
        """Raises :class:`MotionError`; of what is wrong with numbers only where they are ``checked``. What may be wrong
        with symbols is added to those ``found``."""
        self.checked = checked
        segments, faults = [], []
        for i, entry in enumerate(self.law.segments):
            try:
                segments.append(self.segment(entry))
            except _WrongError as wrong:
                faults.append(MotionFault(wrong.code, i, wrong.data, wrong.where))
        if faults:
            raise MotionError(faults)
        period = 2 * pi if self.law.over == "angle" and self.law.beyond != "hold" else None
        if self.law.period is not None:
            period = self.number(self.law.period, self.law.axis)
        return motion(segments, self.number(self.law.start, self.law.value), period, self.law.beyond, checked, found)

    def number(self, of: Expression, dimension: Dimension) -> Scalar:
        """A number at the parameters given."""
        node = self.quantities.bind(of, dimension)
        with np.errstate(all="ignore"):
            value = evaluate(node, lambda name: self.parameters[name.text])
        return float(value) if plain(value) else value

    def refuse(self, code: str, where: Any, **data: Scalar) -> None:
        """Refuse a segment ``where`` something is wrong, told with numbers."""
        if np.any(where):
            raise _WrongError(code, where, **{key: f"{first(value, where):.10g}" for key, value in data.items()})

    def numbers(self, of: tuple[Expression, ...] | None, dimension: Dimension = PURE) -> list[Scalar]:
        return [self.number(each, dimension) for each in of or ()]

    def segment(self, s: stated.SegmentEntry) -> Segment:
        over, axis, value = self.number(s.width, self.law.axis), self.law.axis, self.law.value
        if s.dwell is not None:
            return Dwell(over)
        if s.control is not None:
            degree = s.degree or 5
            if len(s.control) < degree + 1:
                raise _WrongError("law.control", True, given=len(s.control), wanted=degree + 1)
            control = self.numbers(s.control, value)
            return Shape(over, b_spline(control, degree), control[-1] - control[0])
        if s.harmonics is not None:
            rows = [self.numbers(row, value) for row in s.harmonics]
            return Shape(over, series([a for a, _ in rows], [b for _, b in rows]), 0.0)
        if s.fall is not None:
            return Rise(over, -self.number(s.fall, value), self.normalised(s), fall=True)
        assert s.rise is not None
        lift = self.number(s.rise, value)
        if any((s.law, s.fractions, s.powers, s.formula)):
            return Rise(over, lift, self.normalised(s))
        via = tuple((self.number(x, axis), self.number(y, value)) for x, y in s.via or ())
        return Blend(over, lift, self.rates(s, s.from_), self.rates(s, s.to), via, stated.DEGREES.get(s.spline or ""))

    def rates(self, s: stated.SegmentEntry, given: tuple[Expression, ...] | None) -> tuple[Scalar | None, ...]:
        """The rates at an end: those given, then those of the neighbour."""
        own = [self.number(rate, self.law.rate(k)) for k, rate in enumerate(given or (), start=1)]
        return (*own, *[None] * (stated.MATCHED.get(s.match or "", 0) - len(own)))

    def normalised(self, s: stated.SegmentEntry) -> Curve:
        """The law of a rise or fall."""
        if s.formula is not None:
            return self.formula(s.formula)
        if s.powers is not None:
            if len({*s.powers}) < len(s.powers):
                raise _WrongError("law.powers", True)
            return of_powers(s.powers)
        law = LAWS[s.law] if s.law is not None else self.member(self.numbers(s.fractions))
        if s.skew is None:
            return law
        share = self.number(s.skew, PURE)
        if self.checked:
            value = value_of(share)
            self.refuse("law.skew", (value < EDGE) | (value > 1 - EDGE) | law.uneven, share=share)
        return law.skewed(share)

    def member(self, fractions: list[Scalar]) -> Law:
        """A member of the SCCA family."""
        count, whole = len(fractions), sum(fractions)
        if count not in (4, 7):
            raise _WrongError("law.fractions", True, count=count, sum=f"{first(whole, True):.10g}")
        if self.checked:
            wrong = off(whole - 1.0, 1.0, CLOSE, fractions)
            for fraction in map(value_of, fractions):
                wrong = wrong | (fraction != 0) & (fraction < NARROWEST)
            for half in (fractions[:3], fractions[4:])[: 1 if count == 4 else 2]:
                wrong = wrong | (value_of(sum(half)) == 0)
            self.refuse("law.fractions", wrong, count=count, sum=whole)
        return Law((scca if count == 4 else scca_by_widths)(*fractions).parts)

    def formula(self, expression: Expression) -> Curve:
        node = self.quantities.formula(expression)
        values = self.parameters

        def function(u: Jet) -> Jet:
            value = evaluate(node, lambda name: u if name.text == stated.ARGUMENT else values[name.text])
            return value if isinstance(value, Jet) else Jet.constant(value, u.order)

        own = tuple(values[name] for name in sorted(names_in(node)) if name in values)
        curve = Curve((Formula(function, lambda x: expression_text(node, {**values, stated.ARGUMENT: x}), given=own),))
        if self.checked:
            grid = np.linspace(0.0, 1.0, 257)
            smooth = [np.isfinite(value_of(curve.at(grid, order))).all(axis=-1, keepdims=True) for order in range(3)]
            self.refuse("law.not-smooth", ~np.all(smooth, axis=0) & ~_unknown(own))
        return curve

    def finding(self, name: str, fault: MotionFault) -> Finding:
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

    def __init__(self, code: str, where: Any, **data: Any) -> None:
        super().__init__(code)
        self.code, self.where, self.data = code, where, data


def _unknown(numbers: tuple[Scalar, ...]) -> Any:
    """Of which samples some number is NaN."""
    return np.any([np.isnan(np.atleast_2d(value_of(number))) for number in numbers], axis=0) if numbers else False


def expression_text(node: Node, values: dict[str, Any]) -> str:
    """A bound tree as text that says it exactly: numbers as Python writes them, names by their values or texts."""
    if isinstance(node, Number):
        return repr(float(node.value)) if node.value >= 0 else f"({float(node.value)!r})"
    if isinstance(node, Name):
        value = node.text if node.text == "pi" else values[node.text]
        return value if isinstance(value, str) else expression_text(Number(float(value)), values)
    if isinstance(node, Negative):
        return f"(-{expression_text(node.of, values)})"
    if isinstance(node, Call):
        return f"{node.name}({', '.join(expression_text(arg, values) for arg in node.args)})"
    assert isinstance(node, Binary)
    return f"({expression_text(node.left, values)} {node.op} {expression_text(node.right, values)})"
