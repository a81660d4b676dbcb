"""Named positions: the signals there are measures, and so nothing else need know of them."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from linkwright.data_classes import dataclass
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression
from linkwright.expressions.unknown import unknown
from linkwright.findings import Finding
from linkwright.kernels import Compiled
from linkwright.measures import BoundMeasure
from linkwright.model.bound_window import BoundWindow
from linkwright.reductions import Measure
from linkwright.studies.accuracy.options import AccuracyOptions
from linkwright.studies.cycle.options import span
from linkwright.studies.numbers import constant
from linkwright.studies.sampling_options import of_signals, signal_faults

PATH = ("studies", "accuracy", "positions")
WIDEST = ""
"""Stands for the position at which the worst case is widest."""
_EXTREME = re.compile(r"\s*(max|min)\s+(\S.*)", re.S)
_END = re.compile(r"\s*(start|end)\s+of\s+(\S+)\s*")


def check_positions(compiled: Compiled, options: AccuracyOptions) -> Iterator[Finding]:
    """What is wrong with the named positions."""
    quantities, m = compiled.quantities, compiled.mechanism
    for name, text in options.positions.items():
        path = (*PATH, name)
        if match := _END.fullmatch(text):
            if match[2] not in m.windows:
                yield unknown("window", path, match[2], m.windows)
            continue
        match = _EXTREME.fullmatch(text)
        try:
            expression = Expression(match[2] if match else text)
        except ValueError:
            yield Finding("accuracy.position", path, {"text": text[:60]})
            continue
        if match:
            wrong = signal_faults(compiled, expression, path)
            yield from wrong
            if not wrong and not of_signals(expression):
                yield Finding("accuracy.position", path, {"text": text[:60]})
            continue
        time, wrong = constant(quantities, expression, u.TIME, path)
        yield from wrong
        stop = span(compiled, options.cycle)[0]
        if time is not None and not 0 <= time <= stop:
            unit, size = quantities.unit_of(u.TIME)
            data = {"text": text[:60], "stop": f"{stop / size:.6g}", "unit": unit}
            yield Finding("accuracy.outside-run", path, data)


@dataclass(frozen=True)
class PlacedSignal:
    """A signal at a position, :data:`WIDEST` for the widest pose, as a measure."""

    text: str
    position: str
    measure: BoundMeasure


def placed_signals(compiled: Compiled, options: AccuracyOptions, widest: Mapping[str, float]) -> Iterator[PlacedSignal]:
    """Each signal at each named position, and at its ``widest`` time (s)."""
    stop = span(compiled, options.cycle)[0]

    def instant_at(time: float) -> tuple[str, BoundWindow | None]:
        """The instant of a time: where the window begins that is left of the run from there."""
        if time >= stop:
            return "end", None
        return "start", BoundWindow((Expression(f"{time!r} s"), Expression(f"{stop!r} s")))

    def place(text: str) -> tuple[str, BoundWindow | None]:
        if match := _END.fullmatch(text):
            return match[1], compiled.quantities.window(match[2])
        return (
            (text, None)
            if _EXTREME.fullmatch(text)
            else instant_at(compiled.quantities.value(Expression(text), u.TIME))
        )

    named = {name: place(text) for name, text in options.positions.items()}
    for signal in options.signals(compiled):
        places = named | ({WIDEST: instant_at(widest[signal.text])} if signal.text in widest else {})
        for position, (where, window) in places.items():
            name = f"{signal.text} at {position}" if position != WIDEST else signal.text
            entry = Measure.model_validate({"value": signal.raw, "where": where})
            measure = BoundMeasure.of_entry(
                compiled.quantities, name, entry, window, ("studies", "accuracy", "outputs")
            )
            yield PlacedSignal(signal.text, position, measure)
