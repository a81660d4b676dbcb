"""What a cycle without measures shows: strokes and swings, efforts and powers, reactions, transmission angles."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.expressions.fields import Expression
from linkwright.expressions.language import parse
from linkwright.expressions.units import ANGLE, TIME, Dimension
from linkwright.measures.probe import Probe, Search
from linkwright.measures.together import look_ahead, mean_squares
from linkwright.reductions.figures import Peak
from linkwright.results import Run
from linkwright.results.windows import intervals
from linkwright.studies.limits.extremes import Transmission, transmission
from linkwright.studies.output_signals import output_signals

if TYPE_CHECKING:
    from linkwright.blocks import Progress

PARTS = 3
"""Parts of the work that progress is told of."""


@dataclass(frozen=True)
class Extent:
    """An expression over a run: its smallest and largest value, and the root of its mean square (SI)."""

    text: str
    dimension: Dimension
    low: Peak
    high: Peak
    rms: float

    @property
    def peak(self) -> Peak:
        """The value of the largest magnitude."""
        return max(self.low, self.high, key=lambda peak: abs(peak.value))


@dataclass(frozen=True)
class Overview:
    """What a run comes to: its outputs; of each drive effort and power; of each contact, by joint and two links, the
    magnitude of its force; the transmission angles of its dyads. Without masses and loads there are no forces."""

    outputs: tuple[Extent, ...]
    drives: Mapping[str, tuple[Extent, Extent]]
    reactions: Mapping[tuple[str, str, str], Extent]
    transmission: tuple[Transmission, ...]


def overview(run: Run, forces: bool, progress: Progress | None = None) -> Overview:
    """The overview of a run that could be followed; ``forces`` says whether any act. ``progress`` is told of parts."""
    drives, graph = run.compiled.mechanism.drives, run.compiled.graph
    outputs = output_signals(run.compiled)
    efforts = {name: (f"{name}.{drives[name].effort}", f"{name}.power") for name in graph.motors if forces}
    reactions = dict(_reactions(run)) if forces else {}
    plain = dict.fromkeys([*outputs, *(text for pair in efforts.values() for text in pair)])
    found = _extents(run, [*plain], [*reactions.values()], progress or (lambda done, total: None))
    return Overview(
        tuple(found[text] for text in outputs),
        {name: (found[effort], found[power]) for name, (effort, power) in efforts.items()},
        {key: found[text] for key, text in reactions.items()},
        tuple(transmission(run)),
    )


def _extents(run: Run, plain: Sequence[str], forces: Sequence[str], progress: Progress) -> dict[str, Extent]:
    """The extents of signals, and of the magnitudes of forces: all together, these by their squares, which are smooth
    where a force vanishes."""
    quantities = run.compiled.quantities
    if not plain and not forces:
        return {}
    texts = [*plain, *(f"{force}.x^2 + {force}.y^2" for force in forces)]
    trees = [quantities.bind(Expression(text), None) for text in texts]
    dimensions = [quantities.dimensions.dimension(parse(text)) for text in (*plain, *(f"{f}.x" for f in forces))]
    sizes = run.usual(dimensions)
    search, window = Search(run, trees), intervals(run, None)
    probes = [Probe(search, tree, window) for tree in trees]
    progress(1, PARTS)
    squared = [i >= len(plain) for i in range(len(texts))]
    look_ahead(probes)
    progress(2, PARTS)
    found: dict[str, Extent] = {}
    squares = mean_squares(probes, squared, sizes)
    progress(PARTS, PARTS)
    for text, dimension, probe, square, magnitude in zip(
        (*plain, *forces), dimensions, probes, squares, squared, strict=True
    ):
        ends = [probe.bottom(), probe.top()]
        if magnitude:
            ends = [end._replace(value=float(np.sqrt(max(end.value, 0.0)))) for end in ends]
        found[text] = Extent(text, dimension, ends[0], ends[1], float(np.sqrt(max(square, 0.0))))
    return found


def _reactions(run: Run) -> Iterator[tuple[tuple[str, str, str], str]]:
    """Each contact's force, by joint and links."""
    for contact in run.compiled.quantities.signals.reactions:
        force = f"force({contact.link}, {contact.on}, {contact.joint})"
        yield (contact.joint, contact.link, contact.on), force


def overview_entry(found: Overview, run: Run) -> dict[str, Any]:
    """What ``summary.json`` says of it, in the file's units; ``null`` for what is unbounded."""
    quantities = run.compiled.quantities
    time_unit, second = quantities.unit_of(TIME)
    degree, size_of_angle = quantities.unit_of(ANGLE)

    def number(value: float, size: float) -> float | None:
        return value / size if np.isfinite(value) else None

    def place(peak: Peak, size: float) -> dict[str, Any]:
        return {"value": number(peak.value, size), "at": peak.time / second}

    def extent_entry(extent: Extent) -> dict[str, Any]:
        unit, size = quantities.unit_of(extent.dimension)
        ends = {"min": place(extent.low, size), "max": place(extent.high, size)}
        return {**ends, "rms": number(extent.rms, size), "unit": unit, "at_unit": time_unit}

    def largest(extent: Extent) -> dict[str, Any]:
        unit, size = quantities.unit_of(extent.dimension)
        return {**place(extent.peak, size), "rms": number(extent.rms, size), "unit": unit, "at_unit": time_unit}

    return {
        "outputs": {one.text: extent_entry(one) for one in found.outputs},
        "drives": {name: {"effort": largest(a), "power": largest(b)} for name, (a, b) in found.drives.items()},
        "reactions": [
            {"joint": joint, "links": [link, on], **largest(one)} for (joint, link, on), one in found.reactions.items()
        ],
        "transmission": [
            {
                "group": one.group,
                "least": one.angle / size_of_angle,
                "unit": degree,
                "at": None if one.time is None else one.time / second,
                "at_unit": time_unit,
            }
            for one in found.transmission
        ],
    }
