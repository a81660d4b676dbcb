"""The names in a mechanism's expressions: each must be known, and of a kind that may stand there."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from linkwright.expressions.dimensions import DimensionError
from linkwright.expressions.language import FUNCTIONS, Call, Name, Node, is_signal, nodes, signal_text
from linkwright.expressions.trees import children
from linkwright.expressions.units import is_unit
from linkwright.expressions.unknown import likeliest, near, proposed
from linkwright.findings import Finding, Joined, Term
from linkwright.model.mechanism import Mechanism
from linkwright.model.places import ExpressionPlace, Scope
from linkwright.model.signals import Signals
from linkwright.tolerances import examples

# What stands where it may not: the finding of each scope.
_MISPLACED = {
    Scope.CONSTANT: "expression.not-constant",
    Scope.LOAD: "load.signal",
    Scope.TIME: "drive.signal",
    Scope.SIGNALS: "measure.table",
    Scope.FORMULA: "law.formula",
    Scope.TURN: "cam.load-signal",
    Scope.FOLLOWS: "joint.coupling-name",
}


_LIMITS = (("tolerance",), ("tolerance", "limits"))


def _of_class(finding: Finding) -> Finding:
    """Of a lone name that stands for the limits of a tolerance: it may be meant as a class."""
    path = finding.path
    if finding.code != "name.unknown-parameter" or path[:1] != ("parameters",) or path[2:] not in _LIMITS:
        return finding
    data = {"given": finding.data["name"], "known": Joined(examples())}
    return replace(finding, code="tolerance.unknown-class", data=data)


_VECTORS = {"force": 2, "com": 1, "pole": 2}
"""Signals that are asked for as a call, with the fewest elements that they take."""


class Names:
    """Looks up the names of expressions."""

    def __init__(self, mechanism: Mechanism, signals: Signals) -> None:
        self.mechanism, self.signals = mechanism, signals

    def unknown(self, place: ExpressionPlace) -> Iterator[Finding]:
        """Names in an expression that nothing is called by."""
        meant: set[int] = set()  # elements as arguments of what isn't a signal: told with it
        for node in nodes(place.expression.node):
            if isinstance(node, Name | Call):
                if isinstance(node, Name) and (node.text in place.names or id(node) in meant):
                    continue
                if isinstance(node, Call) and self._of_elements(node):
                    meant |= set(map(id, node.args))
                found = self._unknown(node, place)
                yield from map(_of_class, found) if node is place.expression.node else found

    def _unknown(self, node: Name | Call, place: ExpressionPlace) -> Iterator[Finding]:
        m, path = self.mechanism, place.path
        if is_signal(node):
            try:
                self.signals.find(node)
            except DimensionError as error:
                yield Finding(error.key, path, error.data)
        elif isinstance(node, Call):
            known = [*FUNCTIONS, *m.tables, *m.laws]
            if self._of_elements(node):
                yield Finding("signal.unknown", path, {"name": signal_text(node)[:60], "hint": self._meant(node)})
            elif node.name not in known:
                data = {"name": node.name, "near": near(node.name, known)}
                yield Finding("expression.unknown-function", path, data)
        elif node.text not in ("t", "pi") and node.text not in m.parameters:
            from linkwright.expressions.respelled import respelled

            known = [*place.names, *m.parameters, "t", "pi"]
            if found := respelled(place.expression.text, known):
                data = {"text": place.expression.text[:60], "reason": found[0], "hint": found[1]}
                yield Finding("expression.respelled", path, data)
            elif place.scope in (Scope.SIGNALS, Scope.LOAD, Scope.FOLLOWS) and node.text in self.signals.named:
                kind, attributes = self.signals.attributes(node.text)
                signals = Joined(f"{node.text}.{attribute}" for attribute in attributes)
                yield Finding(
                    "signal.element", path, {"name": node.text, "kind": Term(f"a-{kind}"), "signals": signals}
                )
            elif is_unit(node.text):
                yield Finding("expression.unit-alone", path, {"name": node.text})
            else:
                data = {"name": node.text, "near": near(node.text, known)}
                yield Finding("name.unknown-parameter", path, data)

    def _of_elements(self, call: Call) -> bool:
        """Whether a call that is none of a known function names links, points ... as a signal does."""
        m = self.mechanism
        elements = {*self.signals.named, *m.joints} - m.parameters.keys()
        unknown = call.attribute is None and call.name not in {*FUNCTIONS, *m.tables, *m.laws}
        return unknown and bool(call.args) and all(isinstance(a, Name) and a.text in elements for a in call.args)

    def _meant(self, call: Call) -> Term:
        """What a call of elements may mean: a signal of the one, or the x and y of a vector of several."""
        if len(call.args) >= _VECTORS.get(call.name, len(call.args) + 1):
            return proposed([f"{signal_text(call)}.{attribute}" for attribute in "xy"])
        owner = signal_text(call.args[0]) if isinstance(call.args[0], Name | Call) else ""
        alone = len(call.args) == 1 and owner in self.signals.named
        likely = likeliest(call.name, [*self.signals.attributes(owner)[1]]) if alone else []
        return proposed([f"{owner}.{attribute}" for attribute in likely]) if likely else Term("signal-forms")

    def misplaced(self, place: ExpressionPlace) -> Iterator[Finding]:
        """Known names that can't stand in this expression."""
        todo: list[Node] = [place.expression.node]
        while todo:
            node = todo.pop()
            lawful = place.path[:1] in (("drives",), ("paths",)) or place.scope is Scope.TURN
            if isinstance(node, Call) and node.name in self.mechanism.laws and not lawful:
                yield Finding("law.place", place.path, {"name": node.name})
            elif not isinstance(node, Name | Call) or self._may_stand(node, place.scope):
                todo += reversed(children(node))
            else:
                name = signal_text(node)[:60]
                yield Finding(_MISPLACED[place.scope], place.path, {"name": name})

    def _may_stand(self, node: Name | Call, scope: Scope) -> bool:
        if is_signal(node):
            return scope in (Scope.SIGNALS, Scope.FOLLOWS) or (scope is Scope.LOAD and self._kinematic(node))
        if isinstance(node, Name):
            return node.text != "t" or scope not in (Scope.CONSTANT, Scope.FORMULA, Scope.TURN, Scope.FOLLOWS)
        stated = node.name in self.mechanism.tables or node.name in self.mechanism.laws
        return not stated or scope in (Scope.TIME, Scope.LOAD, Scope.TURN)  # what is unknown is told elsewhere

    def _kinematic(self, node: Name | Call) -> bool:
        """Whether a signal is free of forces; what is unknown is told elsewhere."""
        try:
            return self.signals.find(node).kinematic
        except DimensionError:
            return True
