"""What the bare numbers and bare parameters of a file mean: inference of dimensions.

Each use of a bare parameter gives one linear equation between powers of length, mass and time; all equations
of a file are solved together, so a parameter takes its unit from where it is used, and a conflict is found
where it arises. Within one expression a number without a unit is a pure number in a product that has another
dimension, else its term is read in the unit of its place (``1100 + 20*t/(1 s)`` as a length in mm).

The power of angle is followed apart and leniently: a radian is 1, so ``r*phi`` is a length.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import count
from typing import Any

from linkwright.model.expressions import (
    FUNCTIONS,
    Binary,
    Call,
    evaluate,
    Name,
    Negative,
    Node,
    Number,
    is_signal,
    nodes,
)
from linkwright.model.units import ANGLE, BASES, PURE, TIME, Dimension, UnitError, spelled, unit

Powers = tuple[Fraction | int, ...]
Unknown = str | tuple[str, int]
"""A parameter's name, or a floating number (tagged, its serial number)."""
Known = Callable[[Name | Call], Dimension]


class DimensionError(ValueError):
    """An expression's dimensions don't fit; ``key`` names the reason in the catalogue."""

    def __init__(self, key: str, **data: Any) -> None:
        super().__init__(key)
        self.key, self.data = key, data


@dataclass(frozen=True)
class Form:
    """A dimension that is linear in unknown ones: sum of ``unknowns`` x power, plus ``known``."""

    known: Dimension = PURE
    unknowns: tuple[tuple[Unknown, Fraction | int], ...] = ()
    turns: bool = False  # holds pi or a mixture in which the power of angle means nothing

    def times(self, other: Form, power: Fraction | int = 1) -> Form:
        merged = dict(self.unknowns)
        for name, p in other.unknowns:
            merged[name] = merged.get(name, 0) + power * p
        kept = tuple((name, p) for name, p in merged.items() if p != 0)
        return Form(self.known.times(other.known, power), kept, self.turns or other.turns)

    def to(self, power: Fraction | int) -> Form:
        return Form().times(self, power)


@dataclass
class System:
    """Linear equations over unknown dimensions, eliminated as they come."""

    solved: dict[Unknown, tuple[dict[Unknown, Fraction | int], list[Fraction | int]]] = field(default_factory=dict)

    def add(self, unknowns: Mapping[Unknown, Fraction | int], value: Powers) -> bool:
        """Add sum(unknowns) = value; ``False`` where it contradicts what is known."""
        row, right = self._reduced(dict(unknowns), [Fraction(v) for v in value])
        if not row:
            return not any(right)
        pivot = next((name for name in row if isinstance(name, tuple)), None) or next(iter(row))
        scale = row.pop(pivot)
        self.solved[pivot] = ({k: -Fraction(v) / scale for k, v in row.items()}, [v / scale for v in right])
        return True

    def value(self, name: Unknown) -> list[Fraction | int] | None:
        """The powers of an unknown, or ``None`` while it is open."""
        row, right = self._reduced({name: Fraction(-1)}, [Fraction(0)] * 3)
        return None if row else right

    def _reduced(
        self, row: dict[Unknown, Fraction | int], right: list[Fraction | int]
    ) -> tuple[dict[Unknown, Fraction | int], list[Fraction | int]]:
        while known := next((name for name in row if name in self.solved), None):
            power = row.pop(known)
            others, constant = self.solved[known]
            for name, p in others.items():
                row[name] = row.get(name, 0) + power * p
                if row[name] == 0:
                    del row[name]
            right = [r - power * c for r, c in zip(right, constant, strict=True)]
        return row, right


@dataclass
class _Reader:
    """Reads one expression: gives its form, notes equations, and names each bare term's unknown."""

    known: Known
    equations: list[tuple[Form, Node]] = field(default_factory=list)
    floats: dict[int, Unknown] = field(default_factory=dict)

    def alike(self, a: Form, b: Form, where: Node) -> Form:
        self.equations.append((a.times(b, -1), where))
        return b if a.turns and not b.turns else a

    def form(self, node: Node) -> Form:
        if isinstance(node, Binary) and node.op in "+-":
            return self.alike(self.form(node.left), self.form(node.right), node)
        if isinstance(node, Negative):
            return self.form(node.of)
        return self.product(node)

    def product(self, node: Node) -> Form:
        """A term: the product of its factors; with a bare number and otherwise pure, it floats."""
        form, bare = Form(), None
        for factor, power in _factors(node):
            if isinstance(factor, Number) and factor.unit is None:
                bare = bare or (factor if power == 1 else None)
                continue
            form = form.times(self.factor(factor), power)
        if bare is None or form.unknowns or form.known != PURE or form.turns:
            return form
        name: Unknown = ("number", next(_serial))
        self.floats[id(bare)] = name
        return Form(unknowns=((name, 1),))

    def factor(self, node: Node) -> Form:
        if isinstance(node, Number):
            return Form(unit(node.unit)[1] if node.unit else PURE)
        if isinstance(node, Name):
            return self.name(node)
        if isinstance(node, Call):
            return Form(self.known(node)) if is_signal(node) else self.call(node)
        if isinstance(node, Binary) and node.op == "^":
            return self.power(node)
        return self.form(node)

    def name(self, node: Name) -> Form:
        if node.text == "pi":
            return Form(turns=True)
        if node.text == "t":
            return Form(TIME)
        dimension = self.known(node)
        return Form(dimension) if dimension is not BARE else Form(unknowns=((node.text, 1),))

    def power(self, node: Binary) -> Form:
        if constant(node.left) is not None:
            self.equations.append((self.form(node.right), node.right))
            return Form()
        exponent = constant(node.right)
        if exponent is None:
            self.equations += [(self.form(node.left), node.left), (self.form(node.right), node.right)]
            return Form()
        return self.product(node.left).to(exponent)

    def call(self, node: Call) -> Form:
        function = FUNCTIONS.get(node.name)
        if function is None:
            return self.table(node)
        if len(node.args) != function.arity:
            raise DimensionError("expression.arguments", name=node.name, wanted=function.arity, given=len(node.args))
        forms = [self.form(arg) for arg in node.args]
        return _RULES[function.rule](self, forms, node)

    def table(self, node: Call) -> Form:
        try:
            argument, value = self.known(node)  # type: ignore[misc]
        except TypeError:
            raise DimensionError("expression.unknown-function", name=node.name) from None
        if len(node.args) != 1:
            raise DimensionError("expression.arguments", name=node.name, wanted=1, given=len(node.args))
        self.equations.append((self.form(node.args[0]).times(Form(argument), -1), node.args[0]))
        return Form(value)


def _pure(reader: _Reader, forms: list[Form], node: Call) -> Form:
    reader.equations += [(form, arg) for form, arg in zip(forms, node.args, strict=True)]
    return Form()


def _trig(reader: _Reader, forms: list[Form], node: Call) -> Form:
    reader.equations.append((forms[0].times(Form(ANGLE), -1), node.args[0]))
    return Form()


def _same(reader: _Reader, forms: list[Form], node: Call) -> Form:
    form = forms[0]
    for other in forms[1:]:
        form = reader.alike(form, other, node)
    return form


def _step(reader: _Reader, forms: list[Form], node: Call) -> Form:
    x, x0, h0, x1, h1 = forms
    reader.alike(reader.alike(x, x0, node), x1, node)
    return reader.alike(h0, h1, node)


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

_PLACE: Unknown = ("place", 0)
_serial = count(1)

BARE = Dimension(Fraction(-99))
"""Stands for the dimension of a parameter that is still to be inferred."""


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


class Equations:
    """The equations of dimensions read so far, physical ones strictly and the angle's leniently."""

    def __init__(self) -> None:
        self.physical, self.angular = System(), System()

    def read(self, node: Node, place: Form, known: Known) -> dict[int, Unknown]:
        """Note that ``node`` stands where ``place`` is wanted; the unknowns of its floating numbers by id.

        Raises DimensionError on a conflict.
        """
        reader = _Reader(known)
        whole = reader.form(node).times(place, -1)
        for form, where in [*reader.equations, (whole, node)]:
            if not self.physical.add(dict(form.unknowns), tuple(-p for p in form.known[:3])):
                raise DimensionError("expression.units-conflict", part=text_of(where))
            if not form.turns:
                self.angular.add(dict(form.unknowns), (-form.known.angle, 0, 0))
        return reader.floats

    def of(self, unknown: Unknown) -> Dimension:
        """What the equations say of an unknown; what nothing settles is a pure number."""
        physical = self.physical.value(unknown) or [0, 0, 0]
        angular = self.angular.value(unknown) or [0]
        return Dimension(*physical, angular[0])


class Dimensions:
    """The dimensions of a file's parameters, and the binding of its expressions to SI.

    ``known`` gives the dimension of tables (argument, value) and signals; parameters are inferred.
    """

    def __init__(self, declared: Mapping[str, str], parameters: Mapping[str, Node], known: Known) -> None:
        self.declared, self.parameters, self.known = dict(declared), parameters, known
        self.equations = Equations()

    def _open(self, node: Name | Call) -> Dimension:
        return BARE if self._is_parameter(node) else self.known(node)

    def _settled(self, node: Name | Call) -> Dimension:
        return self.of(node.text) if isinstance(node, Name) and self._is_parameter(node) else self.known(node)

    def _is_parameter(self, node: Name | Call) -> bool:
        return isinstance(node, Name) and node.text in self.parameters

    def use(self, node: Node, place: Dimension) -> None:
        """Note one use: the expression stands where ``place`` is wanted."""
        self.equations.read(node, Form(place), self._open)

    def define(self, name: str) -> None:
        """Note a parameter's own definition (``BD: CD + 5``)."""
        self.equations.read(self.parameters[name], Form(unknowns=((name, 1),)), self._open)

    def of(self, name: str) -> Dimension:
        """The inferred dimension of a parameter."""
        return self.equations.of(name)

    def bind(self, node: Node, place: Dimension | None) -> Node:
        """The expression with every number in SI; ``place`` ``None`` takes the expression's own dimension.

        Raises DimensionError on a conflict or where a unit is needed that isn't declared.
        """
        equations = Equations()
        wanted = Form(unknowns=((_PLACE, 1),)) if place is None else Form(place)
        floats = equations.read(node, wanted, self._settled)

        def in_si(number: Number) -> Number:
            if number.unit is not None:
                return Number(number.value * unit(number.unit)[0])
            unknown = floats.get(id(number))
            if unknown is None or number.value == 0:
                return Number(number.value)
            return Number(number.value * declared_scale(equations.of(unknown), self.declared))

        return _mapped(node, in_si)

    def dimension(self, node: Node) -> Dimension:
        """The dimension that an expression has by itself."""
        equations = Equations()
        equations.read(node, Form(unknowns=((_PLACE, 1),)), self._settled)
        return equations.of(_PLACE)


def declared_scale(dimension: Dimension, declared: Mapping[str, str]) -> float:
    """The SI value of one declared unit of ``dimension``. Raises DimensionError where it isn't declared."""
    try:
        return unit(spelled(dimension, dict(declared)))[0]
    except UnitError as error:
        base = str(error)
        if base in BASES:
            raise DimensionError("expression.undeclared-unit", base=base) from None
        raise DimensionError("expression.odd-unit") from None


def _mapped(node: Node, number: Callable[[Number], Number]) -> Node:
    if isinstance(node, Number):
        return number(node)
    if isinstance(node, Negative):
        return Negative(_mapped(node.of, number))
    if isinstance(node, Binary):
        return Binary(node.op, _mapped(node.left, number), _mapped(node.right, number))
    if isinstance(node, Call) and node.attribute is None:
        return Call(node.name, tuple(_mapped(arg, number) for arg in node.args))
    return node


def text_of(node: Node) -> str:
    """A readable text of a tree, for messages."""
    if isinstance(node, Number):
        return f"{node.value:g}" + (f" {node.unit}" if node.unit else "")
    if isinstance(node, Name):
        return node.text
    if isinstance(node, Negative):
        return f"-{text_of(node.of)}"
    if isinstance(node, Binary):
        return f"{text_of(node.left)} {node.op} {text_of(node.right)}"
    args = ", ".join(text_of(arg) for arg in node.args)
    return f"{node.name}({args})" + (f".{node.attribute}" if node.attribute else "")
