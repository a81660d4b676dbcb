"""The list of signals from which a reader of a live report chooses what to plot: units, elements, axes, and which
signal each measure is of."""

from __future__ import annotations

from collections.abc import Container, Iterable, Sequence
from itertools import groupby

from linkwright.data_classes import dataclass
from linkwright.escape import printed
from linkwright.expressions.language import Call, Name, Negative, Node, is_signal, parse, signal_text
from linkwright.expressions.units import ANGLE, LENGTH
from linkwright.measures import BoundMeasure
from linkwright.model.signals import Signal
from linkwright.report.data import MeasuredSignal, SignalOwner
from linkwright.results import Result

KINDS = ("com", "drive", "energy", "force", "joint", "link", "point", "shaking", "slide")
"""The kinds of elements that the report's words name; signals of others are listed under their own names."""

LEVELS = ("extremes", "max", "mean", "min", "value")
"""The reductions whose value is one of the signal's own, so that a limit of it is a line in the signal's plot."""


@dataclass(frozen=True)
class SignalList:
    """All signals that a page can plot, in the order of results. ``owners`` are the elements to which they belong, run
    by run; ``axes`` are the signals that can stand in place of the time: values of drives."""

    names: Sequence[str]
    units: Sequence[str]
    sizes: Sequence[float]
    owners: Sequence[SignalOwner]
    axes: Sequence[str]


def signal_list(result: Result, others: Iterable[str] = ()) -> SignalList:
    """The signals of a result, and ``others`` that aren't among its names; lines of action, which have gaps of their
    own, are left out."""
    compiled, quantities = result.run.compiled, result.run.compiled.quantities
    signals = [signal for signal in quantities.signals.all() if signal.attribute != "arm"]
    known = {signal.text: signal.dimension for signal in signals}
    for name in others:
        known.setdefault(name, result.dimension(name))
    shown = [quantities.unit_of(dimension) for dimension in known.values()]
    owners = [_owner(result, [*run]) for _, run in groupby(signals, lambda signal: (signal.kind, signal.owners))]
    if rest := len(known) - len(signals):
        owners.append({"kind": "", "of": "", "count": rest})
    axes = []
    for drive in compiled.graph.drives:
        own = (s for s in signals if s.kind == "drive" and s.owners == (drive,) and s.dimension in (ANGLE, LENGTH))
        axes += [signal.text for signal in own][:1]
    return SignalList([*known], [printed(unit) for unit, _ in shown], [size for _, size in shown], owners, axes)


def _owner(result: Result, signals: Sequence[Signal]) -> SignalOwner:
    """The element of some signals: of a point the links that have it, else its own names."""
    first = signals[0]
    links = result.run.compiled.quantities.signals.links_of_points
    names = (links[first.owners[0]],) if first.kind == "point" else first.owners
    of = ", ".join(name for name in names if name not in KINDS)
    return {"kind": first.kind, "of": of, "count": len(signals)}


def measured_signals(measures: Iterable[BoundMeasure], names: Container[str]) -> list[MeasuredSignal | None]:
    """The signal of each measure among those of these names, where it is of one: as it is, negated, its magnitude."""
    return [_measured(measure, names) for measure in measures]


def _measured(measure: BoundMeasure, names: Container[str]) -> MeasuredSignal | None:
    node: Node | None = parse(measure.entry.signal.text)
    by = "value"
    if isinstance(node, Negative):
        node, by = node.of, "negative"
    elif isinstance(node, Call) and node.name == "abs" and len(node.args) == 1:
        node, by = node.args[0], "magnitude"
    elif isinstance(node, Call) and node.name == "hypot" and len(node.args) == 2:
        node, by = _component(node.args), "vector"
    if not isinstance(node, Name | Call) or not is_signal(node):
        return None
    text = signal_text(node)
    if text not in names and isinstance(node, Call) and node.name == "force" and node.attribute in ("x", "y"):
        # The reaction of the other link: the list has one of the two.
        one, other, *joint = node.args
        text = signal_text(Call(node.name, (other, one, *joint), node.attribute))
        by = {"value": "negative", "negative": "value"}.get(by, by)
    if text not in names:
        return None
    return {"signal": text, "by": by, "level": measure.entry.reduction in LEVELS}


def _component(parts: Sequence[Node]) -> Node | None:
    """The x component, where two expressions are the components of one vector."""
    x, y = (signal_text(part) if isinstance(part, Name | Call) else "" for part in parts)
    return parts[0] if x.endswith("x") and y == f"{x[:-1]}y" else None
