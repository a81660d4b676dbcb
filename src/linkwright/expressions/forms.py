"""Dimensions with unknowns in them: what an expression says about the dimensions of its parameters.

Each use of a bare parameter gives one linear equation between powers of length, mass and time. The power of
angle is followed apart and leniently (a radian is 1): it steers what bare numbers mean, and never conflicts.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import count
from typing import Any

from linkwright.expressions.language import FUNCTIONS, Binary, Call, Name, Negative, Node, Number, evaluate, nodes
from linkwright.expressions.system import System, Unknown
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
class Form:
    """A dimension that is linear in unknown ones: sum of ``unknowns`` x power, plus ``known``."""

    known: Dimension = PURE
    unknowns: tuple[tuple[Unknown, Fraction | int], ...] = ()
    turns: bool = False  # holds pi: the power of angle means nothing

    def times(self, other: Form, power: Fraction | int = 1) -> Form:
        """The dimension of a product."""
        merged = dict(self.unknowns)
        for name, p in other.unknowns:
            merged[name] = merged.get(name, 0) + power * p
        kept = tuple((name, p) for name, p in merged.items() if p != 0)
        return Form(self.known.times(other.known, power), kept, self.turns or other.turns)

    def to(self, power: Fraction | int) -> Form:
        """The dimension of a power."""
        return Form().times(self, power)

    @classmethod
    def of(cls, unknown: Unknown) -> Form:
        """One unknown by itself."""
        return cls(unknowns=((unknown, 1),))


Known = Callable[[Name | Call], Form]
"""The form of a name or signal."""
Tables = Callable[[Call], tuple[Form, Form]]
"""The forms of a table's argument and value."""


class Equations:
    """The equations of dimensions read so far, physical ones strictly and the angle's leniently."""

    def __init__(self) -> None:
        self.physical, self.angular = System(), System()

    def read(self, node: Node, place: Form, known: Known, tables: Tables) -> dict[int, Unknown]:
        """Note that ``node`` stands where ``place`` is wanted; the unknowns of its floating numbers by id.

        Raises DimensionError on a conflict, naming the part of the expression where it arises.
        """
        reader = _Reader(known, tables)
        whole = reader.form(node)
        for left, right, where in reader.sums:
            self.equate(left, right, where, mixed=True)
        for left, right, where in reader.equations:
            self.equate(left, right, where)
        self.equate(whole, place, node)
        return reader.floats

    def equate(self, left: Form, right: Form, where: Node, mixed: bool = False) -> None:
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

    def of(self, unknown: Unknown) -> Dimension:
        """What the equations say of an unknown; what nothing settles is a pure number."""
        (physical, _), (angular, _) = self.physical.value(unknown), self.angular.value(unknown)
        return Dimension._make([*physical, angular[0]])

    def dimension(self, form: Form) -> Dimension:
        """The dimension of a form with what is known of its unknowns."""
        dimension = form.known
        for unknown, power in form.unknowns:
            dimension = dimension.times(self.of(unknown), power)
        return dimension


def _hertz(node: Node) -> str | None:
    """A number in hertz within an expression, as it is written."""
    for part in nodes(node):
        if isinstance(part, Number) and part.unit and {"Hz", "kHz"} & set(words_of(part.unit)):
            return text_of(part)
    return None


@dataclass
class _Reader:
    """Reads one expression: gives its form, notes equations, and names each floating number's unknown."""

    known: Known
    tables: Tables
    sums: list[tuple[Form, Form, Node]] = field(default_factory=list)
    equations: list[tuple[Form, Form, Node]] = field(default_factory=list)
    floats: dict[int, Unknown] = field(default_factory=dict)

    def form(self, node: Node) -> Form:
        if isinstance(node, Binary) and node.op in "+-":
            left, right = self.form(node.left), self.form(node.right)
            self.sums.append((left, right, node))
            return _either(left, right)
        if isinstance(node, Negative):
            return self.form(node.of)
        return self.product(node)

    def product(self, node: Node) -> Form:
        """A term: the product of its factors; with a bare number and otherwise pure, it floats."""
        if isinstance(node, Name):
            return self.name(node)
        form, bare = Form(), None
        for factor, power in _factors(node):
            if _is_bare(factor):
                bare = bare or (factor if power == 1 else None)
                continue
            form = form.times(self.factor(factor), power)
        if bare is None or form.unknowns or form.known != PURE:
            return form
        name: Unknown = ("number", next(_serial))
        self.floats[id(bare)] = name
        return Form(unknowns=((name, 1),), turns=form.turns)

    def factor(self, node: Node) -> Form:
        if isinstance(node, Number):
            return Form(unit(node.unit)[1] if node.unit else PURE)
        if isinstance(node, Name):
            return self.name(node)
        if isinstance(node, Call):
            return self.known(node) if is_signal(node) else self.call(node)
        if isinstance(node, Binary) and node.op == "^":
            return self.power(node)
        return self.form(node)

    def name(self, node: Name) -> Form:
        if node.text == "pi":
            return Form(turns=True)
        return Form(TIME) if node.text == "t" else self.known(node)

    def power(self, node: Binary) -> Form:
        exponent = constant(node.right)
        if exponent is not None and not _is_bare(node.left):
            return self.product(node.left).to(exponent)
        if not _is_bare(node.left):
            self.equations.append((self.form(node.left), Form(), node.left))
        self.equations.append((self.form(node.right), Form(), node.right))
        return Form()

    def call(self, node: Call) -> Form:
        function = FUNCTIONS.get(node.name)
        wanted = 1 if function is None else function.arity
        if len(node.args) != wanted:
            raise DimensionError("expression.arguments", name=node.name, wanted=wanted, given=len(node.args))
        if function is None:
            argument, value = self.tables(node)
            self.equations.append((self.form(node.args[0]), argument, node.args[0]))
            return value
        return _RULES[function.rule](self, [self.form(arg) for arg in node.args], node)


def _pure(reader: _Reader, forms: list[Form], node: Call) -> Form:
    reader.equations += [(form, Form(), arg) for form, arg in zip(forms, node.args, strict=True)]
    return Form()


def _trig(reader: _Reader, forms: list[Form], node: Call) -> Form:
    reader.equations.append((forms[0], Form(ANGLE), node.args[0]))
    return Form()


def _either(a: Form, b: Form) -> Form:
    """The form of two that are alike: the one whose power of angle means something."""
    return b if a.turns and not b.turns else a


def _same(reader: _Reader, forms: list[Form], node: Call) -> Form:
    form = forms[0]
    for other, arg in zip(forms[1:], node.args[1:], strict=True):
        reader.equations.append((other, form, arg))
        form = _either(form, other)
    return form


def _step(reader: _Reader, forms: list[Form], node: Call) -> Form:
    x, x0, h0, x1, h1 = forms
    reader.equations += [(x0, x, node.args[1]), (x1, x, node.args[3]), (h1, h0, node.args[4])]
    return _either(h0, h1)


def _angle(reader: _Reader, forms: list[Form], node: Call) -> Form:
    _pure(reader, forms, node)
    return Form(ANGLE)


def _ratio(reader: _Reader, forms: list[Form], node: Call) -> Form:
    _same(reader, forms, node)
    return Form(ANGLE)


_RULES: dict[str, Callable[[_Reader, list[Form], Call], Form]] = {
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
