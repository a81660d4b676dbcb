"""One pass over all expressions of a mechanism: their names, the dimensions inferred from them, what conflicts."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from graphlib import CycleError, TopologicalSorter

from linkwright.expressions.dimensions import DimensionError, Dimensions, argument, value
from linkwright.expressions.language import FUNCTIONS, Call, Name, Node, Number, nodes, text_of
from linkwright.expressions.units import PURE, Dimension, unit, words_of
from linkwright.findings import Finding
from linkwright.model.actions import column_unit
from linkwright.model.mechanism import Mechanism
from linkwright.model.names import Names
from linkwright.model.places import ExpressionPlace, Path, Scope, places
from linkwright.model.signals import Signals
from linkwright.model.walk import Found
from linkwright.reductions import figure


class Inference:
    """The dimensions of a mechanism's parameters and tables, the order of its parameters, and all findings.

    ``fields`` is what the mechanism's typed fields hold; ``sound`` are the places whose names and dimensions fit.
    ``uses`` are expressions elsewhere (in the options of studies): what the mechanism leaves open takes its unit from
    them; what is wrong with them is told there. Those are kept that name something open, with those on which their
    dimensions hang.
    """

    def __init__(
        self,
        mechanism: Mechanism,
        signals: Signals,
        declared: Mapping[str, str],
        fields: Sequence[Found],
        uses: Sequence[ExpressionPlace],
    ) -> None:
        self.mechanism = mechanism
        self.findings: list[Finding] = []
        self.dimensions = Dimensions(declared, mechanism.parameters, lambda node: signals.find(node).dimension)
        self.places = list(places(mechanism, fields))
        self.order = self._order()
        names = Names(mechanism, signals)
        self.sound = [place for place in self.places if self._names_known(names, place)]
        self.uses = self._infer(uses)
        self._measure_units()

    def _order(self) -> list[str]:
        """The parameters, each after those that it needs; those in a circle are left out with a finding."""
        parameters = self.mechanism.parameters
        left = {
            name: {n.text for n in nodes(entry.value.node) if isinstance(n, Name) and n.text in parameters}
            for name, entry in parameters.items()
        }
        while True:
            try:
                return list(TopologicalSorter(left).static_order())
            except CycleError as error:
                circle = error.args[1][::-1]
                path: Path = ("parameters", circle[0])
                self.findings.append(Finding("parameters.cycle", path, {"cycle": " -> ".join(circle)[:200]}))
                left = {n: needs - {*circle} for n, needs in left.items() if n not in circle}

    def _names_known(self, names: Names, place: ExpressionPlace) -> bool:
        self._add(list(names.misplaced(place)))
        unknown = list(names.unknown(place))
        self._add(unknown)
        in_circle = place.path[0] == "parameters" and place.path[1] not in self.order
        return not unknown and not in_circle

    def _add(self, findings: list[Finding]) -> None:
        self.findings += [f for i, f in enumerate(findings) if f not in self.findings and f not in findings[:i]]

    def _infer(self, uses: Sequence[ExpressionPlace]) -> tuple[ExpressionPlace, ...]:
        for name, table in self.mechanism.tables.items():
            for unknown, text in ((argument(name), table.x), (value(name), table.y)):
                if text is not None:
                    self.dimensions.set_dimension(unknown, column_unit(text)[1])
        for name, law in self.mechanism.laws.items():
            self.dimensions.set_dimension(argument(name), law.axis)
            self.dimensions.set_dimension(value(name), law.value)
        fine = {id(place) for place in sorted(self.sound, key=_rank) if self._try(place, self._use)}
        telling = self._telling(uses)
        for place in sorted(telling, key=_rank):
            with suppress(DimensionError):
                self._use(place)
        self.sound = [place for place in self.sound if id(place) in fine and self._try(place, self._bind_here)]
        for place in self.sound:
            self._ambiguous(place)
        return telling

    def _telling(self, uses: Sequence[ExpressionPlace]) -> tuple[ExpressionPlace, ...]:
        """The uses that tell the units of what the mechanism's own places leave open."""
        leaving = [self.dimensions.leaves_open(place.expression.node) for place in uses]
        wanted = {place.wanted for place, is_open in zip(uses, leaving, strict=True) if is_open}
        unknown = {of for of in wanted if not isinstance(of, Dimension) and of not in self.mechanism.parameters}
        return tuple(place for place, is_open in zip(uses, leaving, strict=True) if is_open or place.wanted in unknown)

    def _dimensions_at(self, place: ExpressionPlace) -> Dimensions:
        return self.dimensions.with_names(place.names) if place.names else self.dimensions

    def _use(self, place: ExpressionPlace) -> None:
        self._dimensions_at(place).use(place.expression.node, place.wanted)

    def _bind_here(self, place: ExpressionPlace) -> None:
        self._dimensions_at(place).bind(place.expression.node, self.dimensions.resolve(place.wanted))

    def _try(self, place: ExpressionPlace, action: Callable[[ExpressionPlace], None]) -> bool:
        try:
            action(place)
        except DimensionError as error:
            self._add([Finding(error.key, place.path, error.data)])
            return False
        return True

    def _ambiguous(self, place: ExpressionPlace) -> None:
        """A word behind ``2 mm*`` that is a unit and a parameter, where both could be meant."""
        for node in nodes(place.expression.node):
            for word in words_of(node.unit)[1:] if isinstance(node, Number) and node.unit else ():
                if word in self.mechanism.parameters:
                    is_unit, is_parameter = unit(word)[1].physical, self.dimensions.of(word).physical
                    if is_unit in (PURE, is_parameter):
                        data = {"part": text_of(node), "word": word}
                        self._add([Finding("expression.ambiguous-unit", place.path, data)])

    def _measure_units(self) -> None:
        fine = {place.path[1] for place in self.sound if place.path[0] == "measures"}
        for name, measure in self.mechanism.measures.items():
            if measure.unit is None or name not in fine:
                continue
            given, wanted = unit(measure.unit)[1], self.dimensions.resolve(figure(name, measure))
            angle = wanted.angle in (given.angle, 0) or wanted.physical not in _TURNING
            if given.physical != wanted.physical or not angle:
                data = {"unit": measure.unit, "wanted": wanted}
                self._add([Finding("measure.unit", ("measures", name, "unit"), data)])


# Without length and mass, radians and revolutions are told apart by the angle alone (40 rpm is no frequency).
_TURNING = tuple(Dimension(0, 0, -k) for k in range(4))


def _rank(place: ExpressionPlace) -> int:
    """In which order the uses are read. What states its own units comes first: a conflict is then told where
    such a thing is used. Lone names come next: they settle the power of angle, which later uses confirm; and
    what is measured comes before the bounds on it."""
    section, node = place.path[0], place.expression.node
    defines = (section == "parameters" and len(place.path) == 2) or (section == "tables" and "points" in place.path)
    if defines and _explicit(node):
        return 0
    if section == "parameters":
        return 3
    return 1 if isinstance(node, Name) or place.scope is Scope.SIGNALS else 2


def _explicit(node: Node) -> bool:
    """Whether an expression has its dimension by itself: units are written, no name is in it."""
    parts = list(nodes(node))
    named = any(
        (isinstance(part, Name) and part.text != "pi") or (isinstance(part, Call) and part.name not in FUNCTIONS)
        for part in parts
    )
    return not named and any(isinstance(part, Number) and part.unit for part in parts)
