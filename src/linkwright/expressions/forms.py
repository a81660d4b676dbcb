"""Dimensions with unknowns in them: what an expression says about the dimensions of its parameters.

Each use of a bare parameter gives one linear equation between powers of length, mass and time. The power of
angle is followed apart and leniently (a radian is 1): it steers what bare numbers mean, and never conflicts.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field
from fractions import Fraction
from itertools import count
from typing import Any

from linkwright.data_classes import dataclass
from linkwright.expressions.language import FUNCTIONS, Binary, Call, Name, Negative, Node, Number, evaluate, nodes
from linkwright.expressions.system import DimensionSystem, Unknown
from linkwright.expressions.trees import is_signal, text_of
from linkwright.expressions.units import ANGLE, PURE, TIME, Dimension, unit, words_of

_serial = count(1)


class DimensionError(ValueError):
    """An expression's dimensions don't fit; ``key`` is the code of the finding, ``data`` its data.

    Values of ``data`` that are a :class:`Dimension` are spelled as units before anybody reads them.
    """

    def __init__(self, key: str, **data: Any) -> None:
        super().__init__(key)
        self.key, self.data = key, data


@dataclass(frozen=True)
class DimensionForm:
    """A dimension that is linear in unknown ones: sum of ``unknowns`` x power, plus ``known``."""

    known: Dimension = PURE
    unknowns: tuple[tuple[Unknown, Fraction | int], ...] = ()
    turns: bool = False  # holds pi: the power of angle means nothing

    def times(self, other: DimensionForm, power: Fraction | int = 1) -> DimensionForm:
        """The dimension of a product."""
        merged = dict(self.unknowns)
        for name, p in other.unknowns:
            merged[name] = merged.get(name, 0) + power * p
        kept = tuple((name, p) for name, p in merged.items() if p != 0)
        return DimensionForm(self.known.times(other.known, power), kept, self.turns or other.turns)

    def to(self, power: Fraction | int) -> DimensionForm:
        """The dimension of a power."""
        return DimensionForm().times(self, power)

    @classmethod
    def of(cls, unknown: Unknown) -> DimensionForm:
        """One unknown by itself."""
        return cls(unknowns=((unknown, 1),))


Known = Callable[[Name | Call], DimensionForm]
"""The form of a name or signal."""
Tables = Callable[[Call], tuple[DimensionForm, DimensionForm]]
"""The forms of a table's argument and value."""


class Equations:
    """The equations of dimensions read so far, physical ones strictly and the angle's leniently."""

    def __init__(self) -> None:
        self.physical, self.angular = DimensionSystem(), DimensionSystem()

    def read(self, node: Node, place: DimensionForm, known: Known, tables: Tables) -> dict[int, Unknown]:
        """Note that ``node`` stands where ``place`` is wanted; the unknowns of its floating numbers by id.

        Raises DimensionError on a conflict, naming the part of the expression where it arises.
        """
        reader = _FormReader(known, tables)
        whole = reader.form(node)
        for left, right, where in reader.sums:
            self.equate(left, right, where, mixed=True)
        for left, right, where in reader.equations:
            self.equate(left, right, where)
        self.equate(whole, place, node)
        return reader.floats

    def equate(self, left: DimensionForm, right: DimensionForm, where: Node, mixed: bool = False) -> None:
        """Note that two dimensions are one (those of two summands where ``mixed``). Raises DimensionError."""
        if left == right:  # most summands: long sums are read in no time
            return
        form = left.times(right, -1)
        if not self.physical.add(dict(form.unknowns), tuple(-p for p in form.known[:3])):
            data = {"part": text_of(where)[:80], "given": self.dimension(left), "wanted": self.dimension(right)}
            raise DimensionError("expression.units-mixed" if mixed else "expression.units-conflict", **data)
        fits = form.turns or self.angular.add(dict(form.unknowns), (-form.known.angle, 0, 0))
        if not fits and (hertz := _hertz(where)):
            raise DimensionError("expression.hertz", part=hertz)

    def settled(self, unknown: Unknown) -> Dimension | None:
        """The dimension of an unknown where the equations settle it altogether."""
        (physical, known), (angular, also) = self.physical.value(unknown), self.angular.value(unknown)
        return Dimension._make([*physical, angular[0]]) if known and also else None

    def dimension_of(self, unknown: Unknown) -> Dimension:
        """What the equations say of an unknown; what nothing settles is a pure number."""
        (physical, _), (angular, _) = self.physical.value(unknown), self.angular.value(unknown)
        return Dimension._make([*physical, angular[0]])

    def dimension(self, form: DimensionForm) -> Dimension:
        """The dimension of a form with what is known of its unknowns."""
        dimension = form.known
        for unknown, power in form.unknowns:
            dimension = dimension.times(self.dimension_of(unknown), power)
        return dimension


def _hertz(node: Node) -> str | None:
    """A number in hertz within an expression, as it is written."""
    for part in nodes(node):
        if isinstance(part, Number) and part.unit and {"Hz", "kHz"} & set(words_of(part.unit)):
            return text_of(part)
    return None


@dataclass
class _FormReader:
    """Reads one expression: gives its form, notes equations, and names each floating number's unknown."""

    known: Known
    tables: Tables
    sums: list[tuple[DimensionForm, DimensionForm, Node]] = field(default_factory=list)
    equations: list[tuple[DimensionForm, DimensionForm, Node]] = field(default_factory=list)
    floats: dict[int, Unknown] = field(default_factory=dict)

    def form(self, node: Node) -> DimensionForm:
        if isinstance(node, Binary) and node.op in "+-":
            left, right = self.form(node.left), self.form(node.right)
            self.sums.append((left, right, node))
            return _either(left, right)
        if isinstance(node, Negative):
            return self.form(node.of)
        return self.product(node)

    def product(self, node: Node) -> DimensionForm:
        """A term: the product of its factors; with a bare number and otherwise pure, it floats."""
        if isinstance(node, Name):
            return self.name(node)
        form, bare = DimensionForm(), None
        for factor, power in _factors(node):
            if _is_bare(factor):
                bare = bare or (factor if power == 1 else None)
                continue
            form = form.times(self.factor(factor), power)
        if bare is None or form.unknowns or form.known != PURE:
            return form
        name: Unknown = ("number", next(_serial))
        self.floats[id(bare)] = name
        return DimensionForm(unknowns=((name, 1),), turns=form.turns)

    def factor(self, node: Node) -> DimensionForm:
        if isinstance(node, Number):
            return DimensionForm(unit(node.unit)[1] if node.unit else PURE)
        if isinstance(node, Name):
            return self.name(node)
        if isinstance(node, Call):
            return self.known(node) if is_signal(node) else self.call(node)
        if isinstance(node, Binary) and node.op == "^":
            return self.power(node)
        return self.form(node)

    def name(self, node: Name) -> DimensionForm:
        if node.text == "pi":
            return DimensionForm(turns=True)
        return DimensionForm(TIME) if node.text == "t" else self.known(node)

    def power(self, node: Binary) -> DimensionForm:
        exponent = constant(node.right)
        if exponent is not None and not _is_bare(node.left):
            return self.product(node.left).to(exponent)
        if not _is_bare(node.left):
            self.equations.append((self.form(node.left), DimensionForm(), node.left))
        self.equations.append((self.form(node.right), DimensionForm(), node.right))
        return DimensionForm()

    def call(self, node: Call) -> DimensionForm:
        function = FUNCTIONS.get(node.name)
        wanted = 1 if function is None else function.arity
        if len(node.args) != wanted:
            raise DimensionError("expression.arguments", name=node.name, wanted=wanted, given=len(node.args))
        if function is None:
            argument, value = self.tables(node)
            self.equations.append((self.form(node.args[0]), argument, node.args[0]))
            return value
        return _RULES[function.rule](self, [self.form(arg) for arg in node.args], node)


def _pure(reader: _FormReader, forms: list[DimensionForm], node: Call) -> DimensionForm:
    reader.equations += [(form, DimensionForm(), arg) for form, arg in zip(forms, node.args, strict=True)]
    return DimensionForm()


def _trig(reader: _FormReader, forms: list[DimensionForm], node: Call) -> DimensionForm:
    reader.equations.append((forms[0], DimensionForm(ANGLE), node.args[0]))
    return DimensionForm()


def _either(a: DimensionForm, b: DimensionForm) -> DimensionForm:
    """The form of two that are alike: the one whose power of angle means something, then the one that is known, so that
    a number before ``(1 + cos(x))`` counts like one before ``cos(x)``."""
    if a.turns != b.turns:
        return b if a.turns else a
    return b if a.unknowns and not b.unknowns else a


def _same(reader: _FormReader, forms: list[DimensionForm], node: Call) -> DimensionForm:
    form = forms[0]
    for other, arg in zip(forms[1:], node.args[1:], strict=True):
        reader.equations.append((other, form, arg))
        form = _either(form, other)
    return form


def _step(reader: _FormReader, forms: list[DimensionForm], node: Call) -> DimensionForm:
    x, x0, h0, x1, h1 = forms
    reader.equations += [(x0, x, node.args[1]), (x1, x, node.args[3]), (h1, h0, node.args[4])]
    return _either(h0, h1)


def _angle(reader: _FormReader, forms: list[DimensionForm], node: Call) -> DimensionForm:
    _pure(reader, forms, node)
    return DimensionForm(ANGLE)


def _ratio(reader: _FormReader, forms: list[DimensionForm], node: Call) -> DimensionForm:
    _same(reader, forms, node)
    return DimensionForm(ANGLE)


_RULES: dict[str, Callable[[_FormReader, list[DimensionForm], Call], DimensionForm]] = {
    "pure": _pure,
    "trig": _trig,
    "angle": _angle,
    "ratio": _ratio,
    "same": _same,
    "step": _step,
    "root": lambda reader, forms, node: forms[0].to(Fraction(1, 2)),
}


def _is_bare(node: Node) -> bool:
    """Whether a factor is a number without unit, or a power of such numbers."""
    if isinstance(node, Binary) and node.op != "^":
        return False
    return all(isinstance(n, Negative | Binary) or (isinstance(n, Number) and n.unit is None) for n in nodes(node))


def constant(node: Node) -> Fraction | None:
    """The value of an expression of bare numbers only (an exponent), else ``None``."""
    if any(not isinstance(n, Number | Negative | Binary) or getattr(n, "unit", None) for n in nodes(node)):
        return None
    try:
        return Fraction(float(evaluate(node, lambda _: 0.0))).limit_denominator(1000)
    except (ArithmeticError, ValueError):
        return None


def _factors(node: Node, power: int = 1) -> list[tuple[Node, int]]:
    if isinstance(node, Negative):
        return _factors(node.of, power)
    if isinstance(node, Binary) and node.op in "*/":
        return _factors(node.left, power) + _factors(node.right, power if node.op == "*" else -power)
    return [(node, power)]
