"""What the bare numbers and bare parameters of a file mean: inference of dimensions, and binding to SI.

1. Each use of a bare parameter gives one linear equation between powers of length, mass and time. All
   equations of a file are solved together, so a parameter takes its unit from where it is used, and a conflict
   is found where it arises.
2. Within one expression a number without a unit is a pure number in a product that has another dimension
   (``2*AB``); else its term is read in the unit of its place (``1100 + 20*t/(1 s)`` as a length in mm).
3. ``pi`` is a pure number, and in an angle it counts radians: ``pi/2`` and ``2*pi`` are never degrees.
4. The power of angle is followed apart and leniently: a radian is 1, so ``r*phi`` is a length.
5. What nothing settles is a pure number.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Mapping
from copy import copy

from linkwright.expressions.forms import DimensionError, DimensionForm, Equations
from linkwright.expressions.language import FUNCTIONS, Binary, Call, Name, Negative, Node, Number, is_signal, nodes
from linkwright.expressions.system import Unknown
from linkwright.expressions.units import BASES, PURE, Dimension, UnitError, unit, unit_text
from linkwright.findings import Term

__all__ = ["DimensionError", "Dimensions", "Wanted", "argument", "declared_scale", "value"]

Wanted = Dimension | Unknown
"""What an expression's place asks for: a dimension, or that it be the same as others' with the same unknown."""

_PLACE: Unknown = ("place", 0)


class Dimensions:
    """The dimensions of a file's parameters, and the binding of its expressions to SI.

    ``signals`` gives the dimension of a signal; those of parameters and tables are inferred.
    """

    def __init__(
        self,
        declared: Mapping[str, str],
        parameters: Container[str],
        signals: Callable[[Name | Call], Dimension],
    ) -> None:
        self.declared, self.parameters, self.signals = dict(declared), parameters, signals
        self.equations = Equations()

    def _open(self, node: Name | Call) -> DimensionForm:
        unknown = self._parameter(node)
        return self._form(unknown) if unknown else DimensionForm(self.signals(node))

    def _settled(self, node: Name | Call) -> DimensionForm:
        unknown = self._parameter(node)
        return DimensionForm(self.of(unknown) if unknown else self.signals(node))

    def _parameter(self, node: Name | Call) -> str | None:
        return node.text if isinstance(node, Name) and node.text in self.parameters else None

    def _open_table(self, node: Call) -> tuple[DimensionForm, DimensionForm]:
        return self._form(argument(node.name)), self._form(value(node.name))

    def _settled_table(self, node: Call) -> tuple[DimensionForm, DimensionForm]:
        return DimensionForm(self.of(argument(node.name))), DimensionForm(self.of(value(node.name)))

    def _form(self, wanted: Wanted) -> DimensionForm:
        if isinstance(wanted, Dimension):
            return DimensionForm(wanted)
        known = self.equations.settled(wanted)
        return DimensionForm.of(wanted) if known is None else DimensionForm(known)

    def set_dimension(self, unknown: Unknown, dimension: Dimension) -> None:
        """Note that an unknown has this dimension. Raises DimensionError."""
        self.equations.equate(DimensionForm.of(unknown), DimensionForm(dimension), Name(str(unknown)))

    def use(self, node: Node, place: Wanted) -> None:
        """Note one use: the expression stands where ``place`` is wanted. Raises DimensionError."""
        self.equations.read(node, self._form(place), self._open, self._open_table)

    def with_names(self, names: Mapping[str, Dimension]) -> Dimensions:
        """The same where ``names`` stand besides: those that a place gives a meaning."""
        other = copy(self)
        other.signals = lambda node: (
            names[node.text] if isinstance(node, Name) and node.text in names else self.signals(node)
        )
        return other

    def of(self, unknown: Unknown) -> Dimension:
        """The inferred dimension of a parameter, or of another unknown."""
        return self.equations.dimension_of(unknown)

    def leaves_open(self, node: Node) -> bool:
        """Whether a parameter or a table's column in an expression has no unit yet, by itself or by its uses."""
        calls = {part.name for part in nodes(node) if isinstance(part, Call) and not is_signal(part)} - {*FUNCTIONS}
        named = {part.text for part in nodes(node) if isinstance(part, Name) and part.text in self.parameters}
        unknowns: list[Unknown] = [*named, *(of(call) for call in calls for of in (argument, value))]
        return any(self.equations.settled(unknown) is None for unknown in unknowns)

    def resolve(self, wanted: Wanted) -> Dimension:
        """The dimension that a place turns out to want."""
        return wanted if isinstance(wanted, Dimension) else self.of(wanted)

    def bind(self, node: Node, place: Dimension | None) -> Node:
        """The expression with every number in SI; ``place`` ``None`` takes the expression's own dimension.

        Raises DimensionError on a conflict or where a unit is needed that isn't declared.
        """
        equations = Equations()
        wanted = DimensionForm.of(_PLACE) if place is None else DimensionForm(place)
        floats = equations.read(node, wanted, self._settled, self._settled_table)

        def in_si(part: Node) -> Node | None:
            if isinstance(part, Number) and part.unit is not None:
                return Number(part.value * unit(part.unit)[0])
            unknown = floats.get(id(part))
            if unknown is None or part == Number(0.0):
                return None
            scale = declared_scale(equations.dimension_of(unknown), self.declared)
            return Number(part.value * scale) if isinstance(part, Number) else Binary("*", part, Number(scale))

        return _mapped(node, in_si)

    def dimension(self, node: Node) -> Dimension:
        """The dimension that an expression has by itself. Raises DimensionError."""
        equations = Equations()
        equations.read(node, DimensionForm.of(_PLACE), self._settled, self._settled_table)
        return equations.dimension_of(_PLACE)


def argument(table: str) -> Unknown:
    """The unknown dimension of a table's argument."""
    return (f"argument {table}", 0)


def value(table: str) -> Unknown:
    """The unknown dimension of a table's value."""
    return (f"value {table}", 0)


def crossed(window: str) -> Unknown:
    """The unknown dimension of the signal that bounds a window."""
    return (f"window {window}", 0)


def declared_scale(dimension: Dimension, declared: Mapping[str, str]) -> float:
    """The SI value of one declared unit of ``dimension``. Raises DimensionError where it isn't declared."""
    if dimension == PURE:
        return 1.0
    try:
        return unit(unit_text(dimension, dict(declared)))[0]
    except UnitError as error:
        base = str(error)
        if base in BASES:
            raise DimensionError(
                "expression.undeclared-unit", base=base, quantity=Term(f"base-{base}"), count=1
            ) from None
        raise DimensionError("expression.odd-unit", dimension=dimension) from None


def _mapped(node: Node, other: Callable[[Node], Node | None]) -> Node:
    """The tree with those nodes put in for which ``other`` gives one."""
    if (instead := other(node)) is not None:
        return instead
    if isinstance(node, Negative):
        return Negative(_mapped(node.of, other))
    if isinstance(node, Binary):
        return Binary(node.op, _mapped(node.left, other), _mapped(node.right, other))
    if isinstance(node, Call) and node.attribute is None:
        return Call(node.name, tuple(_mapped(arg, other) for arg in node.args))
    return node
