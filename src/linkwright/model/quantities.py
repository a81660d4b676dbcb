"""The numbers of a mechanism in SI: its expressions bound to SI, its parameters evaluated."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from linkwright.expressions import units as u
from linkwright.expressions.dimensions import DimensionError, Dimensions, Wanted
from linkwright.expressions.fields import Expression
from linkwright.expressions.language import ExpressionError, Node, evaluate
from linkwright.expressions.units import Dimension, UnitError, si_text, unit, unit_text, words_of
from linkwright.findings import Finding, Term
from linkwright.model.actions import column_unit
from linkwright.model.bound_window import BoundWindow
from linkwright.model.inference import Inference
from linkwright.model.mechanism import Mechanism
from linkwright.model.names import Names
from linkwright.model.places import OF_FORMULA, ExpressionPlace, find_typed_values
from linkwright.model.signals import Signals
from linkwright.model.walk import Found

__all__ = ["Quantities", "column_unit"]

LARGEST = 1e40
"""The largest magnitude (SI) that an input may have; products of several must not overflow."""


class Quantities:
    """Binds a mechanism's expressions to SI. ``findings`` says what doesn't fit; values need none of them.

    ``uses`` are expressions from elsewhere, of which those are kept that tell the units of what the mechanism leaves
    open; ``fields`` is what its typed fields hold, where that is known already.
    """

    samples: int | None = None  # of how many sets of parameter values

    def __init__(
        self, mechanism: Mechanism, uses: Sequence[ExpressionPlace] = (), fields: Sequence[Found] | None = None
    ) -> None:
        self.mechanism = mechanism
        self.signals = Signals(mechanism)
        self.findings: list[Finding] = []
        self.declared = self._declared()
        self.fields = find_typed_values(mechanism) if fields is None else fields
        inference = Inference(mechanism, self.signals, self.declared, self.fields, uses)
        self.dimensions: Dimensions = inference.dimensions
        self.places: list[ExpressionPlace] = inference.places
        self.order, self.uses = inference.order, inference.uses
        wrong = {str(finding.path[1]) for finding in self.findings}
        self.findings += _collapsed([replace(f, data=self.spelt(f.data)) for f in inference.findings], wrong)
        self._bound: dict[tuple[str, Dimension | None], Node] = {}
        # Cells of tables and widths of bands are bound alike whoever asks: a bare 0 beside them tells no dimension.
        self._cells: dict[int, Wanted] = {
            id(place.expression): place.wanted
            for place in self.places
            if place.path[0] == "tables" or place.path[-1] == "within"
        }
        self.parameters: dict[str, float] = {}
        self.phases: dict[str, tuple[float, ...]] = {}  # by joint what its kind fixes when the mechanism is assembled
        if not self.findings:
            self._evaluate_parameters()

    def _declared(self) -> dict[str, str]:
        declared = self.mechanism.units.declared
        for base, word in list(declared.items()):
            try:
                fits = unit(word)[1] == u.BASE_DIMENSIONS[base]
            except UnitError:
                fits = False
            if not fits or (len(words_of(word)) > 1 and base in ("length", "angle", "mass", "time")):
                data = {
                    "word": word[:40],
                    "quantity": Term(f"base-{base}"),
                    "usual": _meant(word, base) or _USUAL[base],
                }
                self.findings.append(Finding("units.wrong", ("units", base), data))
                del declared[base]
        return declared

    def spelt(self, data: Mapping[str, Any]) -> dict[str, Any]:
        """The data of a finding with its dimensions spelled as units."""
        return {
            key: self.unit_of(value)[0] or Term("no-unit") if isinstance(value, Dimension) else value
            for key, value in data.items()
        }

    def _evaluate_parameters(self) -> None:
        for name in self.order:
            expression = self.mechanism.parameters[name].value
            self.parameters[name] = value = self.value(expression, self.dimensions.of(name))
            if not abs(value) < LARGEST:
                data = {"text": expression.text[:60]}
                self.findings.append(Finding("parameters.value", ("parameters", name), data))

    def bind(self, expression: Expression, dimension: Dimension | None) -> Node:
        """The expression's tree with every number in SI, for a place of ``dimension`` (its own where None).

        Raises DimensionError, which no expression of the mechanism itself does when there are no findings.
        """
        if id(expression) in self._cells:
            dimension = self.dimensions.resolve(self._cells[id(expression)])
        key = (expression.text, dimension)
        if key not in self._bound:
            try:
                self._bound[key] = self.dimensions.bind(expression.node, dimension)
            except DimensionError as error:
                raise self._explained(expression) or DimensionError(error.key, **self.spelt(error.data)) from None
        return self._bound[key]

    def formula(
        self, expression: Expression, dimension: Dimension = u.PURE, names: Mapping[str, Dimension] = OF_FORMULA
    ) -> Node:
        """The same of a formula in further ``names``; without them in
        :data:`~linkwright.model.motions.ARGUMENT`, which gives a pure number."""
        try:
            return self.dimensions.with_names(names).bind(expression.node, dimension)
        except DimensionError as error:
            raise DimensionError(error.key, **self.spelt(error.data)) from None

    def value(self, expression: Expression, dimension: Dimension | None) -> float:
        """The value in SI at the nominal parameters; NaN or infinite where it has none.

        Raises DimensionError where the expression isn't a constant of ``dimension``.
        """
        node = self.bind(expression, dimension)
        try:
            with np.errstate(all="ignore"):
                return self._plain(evaluate(node, lambda name: self.parameters[name.text]))
        except (KeyError, ExpressionError):
            raise self._explained(expression) or DimensionError("expression.not-constant", name="") from None

    def _plain(self, value: Any) -> float:
        return float(value)

    def bad(self, wrong: Any) -> bool:
        """Whether something is wrong with a value; of many samples, with some."""
        return bool(wrong)

    def _explained(self, expression: Expression) -> DimensionError | None:
        """What is wrong with the names of an expression that should be constant."""
        names, place = Names(self.mechanism, self.signals), ExpressionPlace((), expression, u.PURE)
        for finding in (*names.unknown(place), *names.misplaced(place)):
            return DimensionError(finding.code, **finding.data)
        return None

    def window(self, name: str) -> BoundWindow:
        """A window by its name."""
        return BoundWindow.of(self.mechanism.windows[name], self.dimensions)

    def law(self, drive: str) -> Node:
        """The law of a drive as a tree in SI: of the time t, parameters and called functions."""
        entry, path = self.mechanism.drives[drive], self.mechanism.path_law(drive)
        if path is None:
            return entry.tree(self.bind, self.drive_dimension(drive) == u.ANGLE)
        return path.coordinate(self.bind, self.mechanism.path_drives(str(entry.output)).index(drive) > 0)

    def drive_dimension(self, drive: str) -> Dimension:
        """The dimension of what a drive prescribes: an angle or a length."""
        return u.ANGLE if self.mechanism.prescribed(drive).turns else u.LENGTH

    def drive_unit(self, drive: str) -> tuple[str, float]:
        """The unit in which a drive's value goes out, and its SI value."""
        return self.unit_of(self.drive_dimension(drive))

    def unit_of(self, dimension: Dimension) -> tuple[str, float]:
        """The unit in which a quantity goes out, and its SI value: as declared, else SI."""
        try:
            text = unit_text(dimension, self.declared, strict=False)
        except UnitError:
            return si_text(dimension), 1.0
        return text, unit(text)[0]


_USUAL = {
    **u.SI,
    "length": "mm",
    "angle": "deg",
    "pressure": "bar",
}


def _meant(word: str, base: str) -> str | None:
    """The unit of a base quantity that a word stands for elsewhere, if it does for one of that."""
    from linkwright.expressions.respelled import unit_respelled

    meant = unit_respelled(word)
    other = meant is not None and meant != word and len(words_of(meant)) == 1
    return meant if other and unit(meant)[1] == u.BASE_DIMENSIONS[base] else None


def _collapsed(findings: list[Finding], wrong: set[str]) -> list[Finding]:
    """One finding for each unit that isn't declared, at the first number that needs it; none for wrong ones."""
    kept: list[Finding] = []
    count: dict[Any, int] = {}
    for finding in findings:
        base = finding.data.get("base") if finding.code == "expression.undeclared-unit" else None
        count[base] = count.get(base, 0) + 1
        if base is None or (count[base] == 1 and base not in wrong):
            kept.append(finding)
    return [
        replace(f, data={**f.data, "count": count[f.data["base"]]}) if f.code == "expression.undeclared-unit" else f
        for f in kept
    ]
