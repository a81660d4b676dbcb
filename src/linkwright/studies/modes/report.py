"""What assembly modes and circuits show, in the file's units, with a small drawing of each mode."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import partial
from typing import Any, TypedDict

import numpy as np

from linkwright.escape import markup
from linkwright.expressions import units as u
from linkwright.findings import CLAUSES, SENTENCES, Joined, Said, Text
from linkwright.graph.modes import Mode
from linkwright.notation.hull import hull
from linkwright.presentation.blocks import Block, Bullets, Card, Cards, Section, Sentences, StudyReport
from linkwright.structure import FRAME
from linkwright.studies.modes.outcome import ModesOutcome
from linkwright.studies.sides import side_sentences


class ModeEntry(TypedDict):
    """One assembly mode; numbers count from 1. ``assembly``: lines of the file's section that select it."""

    number: int
    own: bool
    singular: bool
    circuit: int | None
    branch: int | None
    branches: dict[str, int]
    coordinates: dict[str, list[float]]
    points: dict[str, list[float]]
    assembly: list[str]


class BranchEntry(TypedDict):
    """A part of a circuit between dead points: the drive's range on it, and the modes there."""

    number: int
    modes: list[int]
    low: float
    high: float


class CircuitEntry(TypedDict):
    """Poses joined by motion. ``turns``: the drive goes round; ``change_points``: the drive's values at those."""

    number: int
    modes: list[int]
    closed: bool
    turns: bool
    branches: list[BranchEntry]
    change_points: list[float]


class ModesData(TypedDict):
    """What was found. ``complete``: no mode is missing. Angles of ``coordinates`` in rad, their lengths in m."""

    time: float
    drives: dict[str, float]
    complete: bool
    drive: str | None
    drive_unit: str
    length_unit: str
    sentences: list[Said]
    modes: list[ModeEntry]
    circuits: list[CircuitEntry]


def modes_data(outcome: ModesOutcome) -> ModesData:
    """The modes of a mechanism as plain data in its units."""
    quantities, found = outcome.quantities, outcome.survey
    length, size = quantities.unit_of(u.LENGTH)
    units = {name: quantities.drive_unit(name) for name in outcome.values}
    unit, scale = units[found.drive] if found.drive else ("", 1.0)
    modes: list[ModeEntry] = []
    for i, mode in enumerate(found.modes):
        place = found.places[i]
        modes.append(
            {
                "number": i + 1,
                "own": i == outcome.own,
                "singular": mode.singular,
                "circuit": place[0] + 1 if place else None,
                "branch": place[1] + 1 if place else None,
                "branches": {label: int(sign) for label, sign in mode.branches.items()},
                "coordinates": {label: list(u) for label, u in mode.coordinates.items()},
                "points": {name: [x / size, y / size] for name, (x, y) in mode.places.items()},
                "assembly": list(mode.lines),
            }
        )
    return {
        "time": outcome.time / quantities.unit_of(u.TIME)[1],
        "drives": {name: value / units[name][1] for name, value in outcome.values.items()},
        "complete": outcome.complete,
        "drive": found.drive,
        "drive_unit": unit,
        "length_unit": length,
        "sentences": [*_sentences(outcome), *side_sentences(line for mode in modes for line in mode["assembly"])],
        "modes": modes,
        "circuits": [_circuit(outcome, i, scale) for i in range(len(found.circuits))],
    }


def _circuit(outcome: ModesOutcome, index: int, scale: float) -> CircuitEntry:
    found, circuit = outcome.survey, outcome.circuits[index]
    assert found.drive is not None
    turning, here = outcome.quantities.mechanism.prescribed(found.drive).turns, outcome.values[found.drive]

    def range_in_unit(low: float, high: float) -> tuple[float, float]:
        """In the file's unit; of ranges that are a whole turn apart, the one about the pose looked at."""
        away = 2 * math.pi * round((0.5 * (low + high) - here) / (2 * math.pi)) if turning else 0.0
        return (low - away) / scale, (high - away) / scale

    branches: list[BranchEntry] = []
    for branch, (low, high) in enumerate(circuit.ranges):
        low, high = range_in_unit(low, high)
        modes = [i + 1 for i in found.on(index, branch)]
        branches.append({"number": branch + 1, "modes": modes, "low": low, "high": high})
    return {
        "number": index + 1,
        "modes": [i + 1 for i in found.on(index)],
        "closed": circuit.closed,
        "turns": circuit.turns,
        "branches": branches,
        "change_points": sorted({round(range_in_unit(value, value)[0], 6) + 0.0 for value in circuit.crossings}),
    }


def _sentences(outcome: ModesOutcome) -> Iterator[Said]:
    found, count = outcome.survey.found, len(outcome.modes)
    yield Said("modes.all" if found.complete else "modes.found", count=count)
    if found.open_groups:
        yield Said("modes.open", groups=Joined(found.open_groups, CLAUSES))
    if found.free_groups:
        yield Said("modes.free", groups=Joined(sorted(found.free_groups), CLAUSES))
    if found.cut:
        yield Said("modes.cut", count=count)
    if outcome.survey.untold:
        yield Said("modes.untold-circuits")
    if outcome.survey.drive is None and outcome.values:
        yield Said("modes.no-drive")


def circuit_text(entry: CircuitEntry, data: ModesData) -> Text:
    """A circuit in a sentence."""
    names: dict[str, Any] = {"drive": data["drive"], "unit": data["drive_unit"], "number": entry["number"]}
    names["modes"] = Joined(map(str, entry["modes"]))
    if entry["turns"]:
        texts = [Said("modes.circuit.turns", **names)]
    else:
        parts = [
            Said(
                "modes.branch",
                low=f"{b['low']:.6g}",
                high=f"{b['high']:.6g}",
                modes=Joined(map(str, b["modes"])) or Said("modes.none-here"),
                unit=names["unit"],
            )
            for b in entry["branches"]
        ]
        texts = [Said("modes.circuit.parts", parts=Joined(parts, CLAUSES), **names)]
    if not entry["closed"]:
        texts.append(Said("modes.circuit.open"))
    if entry["change_points"]:
        values = Joined(f"{value:.6g}" for value in entry["change_points"])
        texts.append(Said("modes.circuit.crossing", values=values, **names))
    return Joined(texts, SENTENCES)


Spot = tuple[float, float]
WIDTH, HEIGHT, PAD = 220.0, 150.0, 12.0


def drawing(outcome: ModesOutcome, mode: Mode) -> str:
    """A mode as a small SVG: links as the hulls of their points, slides as dashed lines. All modes at one scale."""
    every = [place for other in outcome.modes for place in other.places.values()]
    xs, ys = [x for x, _ in every], [y for _, y in every]
    span = max((max(xs) - min(xs)) / (WIDTH - 2 * PAD), (max(ys) - min(ys)) / (HEIGHT - 2 * PAD)) or 1.0
    middle = (max(xs) + min(xs)) / 2, (max(ys) + min(ys)) / 2

    def to_picture(name: str) -> Spot:
        x, y = mode.places[name]
        return WIDTH / 2 + (x - middle[0]) / span, HEIGHT / 2 - (y - middle[1]) / span

    def listed(spots: Sequence[Spot]) -> str:
        return " ".join(f"{x:.1f},{y:.1f}" for x, y in spots)

    shapes = []
    mechanism = outcome.quantities.mechanism
    links = mechanism.links
    for name, joint in mechanism.prismatic_joints():
        ends = listed([to_picture(line.point) for line in joint.line or ()])
        shapes.append(f'<polyline class="lw-centre" points="{ends}"><title>{markup(name)}</title></polyline>')
    for i, name in enumerate(name for name in links if name != FRAME):
        corners = listed(
            [(z.real, z.imag) for z in hull(np.array([complex(*to_picture(p)) for p in links[name].points]))]
        )
        title = f"<title>{markup(name)}</title>"
        shapes.append(f'<polygon class="lw-body lw-c{i % 8}" points="{corners}">{title}</polygon>')
    for name in mode.places:
        (x, y), size = to_picture(name), 4.5 if name in links[FRAME].points else 3
        title = f"<title>{markup(name)}</title>"
        shapes.append(f'<circle class="lw-pin" cx="{x:.1f}" cy="{y:.1f}" r="{size}">{title}</circle>')
    box = f"0 0 {WIDTH:.0f} {HEIGHT:.0f}"
    return f'<svg class="lw mode" viewBox="{box}" role="img">{"".join(shapes)}</svg>'


def mode_text(entry: ModeEntry) -> Text:
    """Where a mode lies, and what is special about it."""
    parts = [Said("modes.place", circuit=entry["circuit"], branch=entry["branch"])] if entry["circuit"] else []
    parts += [Said("modes.own")] if entry["own"] else []
    parts += [Said("modes.singular")] if entry["singular"] else []
    return Joined(parts, CLAUSES)


def report(outcome: ModesOutcome) -> StudyReport:
    """Sentences, the circuits, and each mode with the lines that select it."""
    data = modes_data(outcome)
    cards = [_card(outcome, entry, mode) for entry, mode in zip(data["modes"], outcome.modes, strict=True)]
    heads = (Said("modes.column.mode"), Said("modes.column.where_on"), Said("modes.column.assembly"))
    blocks: list[Block] = [
        Sentences(data["sentences"]),
        Bullets([circuit_text(entry, data) for entry in data["circuits"]]),
        Cards("assembly", heads, cards),
    ]
    return StudyReport([Section("modes", blocks)], {"modes": data})


def _card(outcome: ModesOutcome, entry: ModeEntry, mode: Mode) -> Card:
    title, picture = Said("modes.number", number=entry["number"]), partial(drawing, outcome, mode)
    return Card(title, mode_text(entry), picture, entry["assembly"], Said("modes.untold"))
