"""Named positions: the signals there become measures of the mechanism, and so nothing else need know of them."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression
from linkwright.expressions.unknown import unknown
from linkwright.expressions.written import FrozenDict
from linkwright.findings import Finding
from linkwright.kernels import Compiled
from linkwright.model.document import Document
from linkwright.reductions import Measure
from linkwright.studies.accuracy.options import AccuracyOptions
from linkwright.studies.cycle.options import span
from linkwright.studies.numbers import constant
from linkwright.studies.sampling_options import of_signals, signal_faults

PATH = ("studies", "accuracy", "positions")
WIDEST = ""
OWN = "accuracy__"
"""The measures and windows that stand for positions begin so."""
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
class Augmented:
    """A document in which signals at positions are measures, asked for with the other outputs. ``places`` says of each
    of these which signal it is and at which position, :data:`WIDEST` for the widest pose."""

    document: Document
    places: Mapping[str, tuple[str, str]]


def augmented(
    document: Document, compiled: Compiled, options: AccuracyOptions, widest: Mapping[str, float]
) -> Augmented:
    """The document with a measure of each signal at each named position, and at its ``widest`` time (s)."""
    measures, windows = dict(document.measures), dict(document.windows)
    places: dict[str, tuple[str, str]] = {}
    stop = span(compiled, options.cycle)[0]

    def at(time: float, window: str) -> dict[str, str]:
        if time >= stop:
            return {"where": "end"}
        windows[window] = (Expression(f"{time!r} s"), Expression(f"{stop!r} s"))
        return {"where": "start", "window": window}

    def place(position: str, window: str) -> dict[str, str]:
        text = options.positions[position]
        if match := _END.fullmatch(text):
            return {"where": match[1], "window": match[2]}
        if _EXTREME.fullmatch(text):
            return {"where": text}
        return at(compiled.quantities.value(Expression(text), u.TIME), window)

    for number, signal in enumerate(options.signals(compiled)):
        wheres = {name: place(name, f"{OWN}{i}") for i, name in enumerate(options.positions)}
        if signal.text in widest:
            wheres[WIDEST] = at(widest[signal.text], f"{OWN}widest_{number}")
        for i, (position, where) in enumerate(wheres.items()):
            name = f"{OWN}{number}_{i}"
            measures[name] = Measure.model_validate({"value": signal.raw, **where})
            places[name] = signal.text, position
    studies = {name: dict(entry) for name, entry in document.studies.items()}
    outputs = [output.raw for output in options.outputs or ()]
    if places:
        studies["accuracy"]["outputs"] = [*outputs, *places]
    changed = {"measures": FrozenDict(measures), "windows": FrozenDict(windows), "studies": FrozenDict(studies)}
    return Augmented(document.model_copy(update=changed), places)
