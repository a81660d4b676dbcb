"""Assembly modes and circuits as the data of a report, in the file's units, with a small drawing of each mode."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import TypedDict

import numpy as np

from linkwright.escape import markup
from linkwright.expressions import units as u
from linkwright.graph.modes import Mode
from linkwright.measures.paths import hull
from linkwright.structure import FRAME
from linkwright.studies import ModesOutcome
from linkwright.words import say


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
    sentences: list[str]
    modes: list[ModeEntry]
    circuits: list[CircuitEntry]
    drawings: list[str]


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
        "sentences": list(_sentences(outcome)),
        "modes": modes,
        "circuits": [_circuit(outcome, i, scale) for i in range(len(found.circuits))],
        "drawings": [drawing(outcome, mode) for mode in found.modes],
    }


def told(outcome: ModesOutcome) -> dict[str, object]:
    """The modes without their drawings, for summaries."""
    return {key: value for key, value in modes_data(outcome).items() if key != "drawings"}


def _circuit(outcome: ModesOutcome, index: int, scale: float) -> CircuitEntry:
    found, circuit = outcome.survey, outcome.circuits[index]
    assert found.drive is not None
    turning, here = outcome.quantities.mechanism.prescribed(found.drive).turns, outcome.values[found.drive]

    def shown(low: float, high: float) -> tuple[float, float]:
        """In the file's unit; of ranges that are a whole turn apart, the one about the pose looked at."""
        away = 2 * math.pi * round((0.5 * (low + high) - here) / (2 * math.pi)) if turning else 0.0
        return (low - away) / scale, (high - away) / scale

    branches: list[BranchEntry] = []
    for branch, (low, high) in enumerate(circuit.ranges):
        low, high = shown(low, high)
        modes = [i + 1 for i in found.on(index, branch)]
        branches.append({"number": branch + 1, "modes": modes, "low": low, "high": high})
    return {
        "number": index + 1,
        "modes": [i + 1 for i in found.on(index)],
        "closed": circuit.closed,
        "turns": circuit.turns,
        "branches": branches,
        "change_points": sorted({round(shown(value, value)[0], 6) + 0.0 for value in circuit.crossings}),
    }


def _sentences(outcome: ModesOutcome) -> Iterator[str]:
    found, count = outcome.survey.found, len(outcome.modes)
    yield say("modes.all" if found.complete else "modes.found", count=count)
    if found.open_groups:
        yield say("modes.open", groups="; ".join(found.open_groups))
    if found.free_groups:
        yield say("modes.free", groups="; ".join(sorted(found.free_groups)))
    if found.cut:
        yield say("modes.cut", count=count)
    if outcome.survey.untold:
        yield say("modes.untold-circuits")
    if outcome.survey.drive is None and outcome.values:
        yield say("modes.no-drive")


def circuit_text(entry: CircuitEntry, data: ModesData) -> str:
    """A circuit in a sentence."""
    names = {"drive": data["drive"], "unit": data["drive_unit"], "number": entry["number"]}
    names["modes"] = ", ".join(map(str, entry["modes"]))
    if entry["turns"]:
        text = say("modes.circuit.turns", **names)
    else:
        parts = [
            say(
                "modes.branch",
                low=f"{b['low']:.6g}",
                high=f"{b['high']:.6g}",
                modes=", ".join(map(str, b["modes"])) or say("modes.none-here"),
                unit=names["unit"],
            )
            for b in entry["branches"]
        ]
        text = say("modes.circuit.parts", parts="; ".join(parts), **names)
    if not entry["closed"]:
        text += " " + say("modes.circuit.open")
    if entry["change_points"]:
        values = ", ".join(f"{value:.6g}" for value in entry["change_points"])
        text += " " + say("modes.circuit.crossing", values=values, **names)
    return text


Spot = tuple[float, float]
WIDTH, HEIGHT, PAD = 220.0, 150.0, 12.0


def drawing(outcome: ModesOutcome, mode: Mode) -> str:
    """A mode as a small SVG: links as the hulls of their points, slides as dashed lines. All modes at one scale."""
    every = [place for other in outcome.modes for place in other.places.values()]
    xs, ys = [x for x, _ in every], [y for _, y in every]
    span = max((max(xs) - min(xs)) / (WIDTH - 2 * PAD), (max(ys) - min(ys)) / (HEIGHT - 2 * PAD)) or 1.0
    middle = (max(xs) + min(xs)) / 2, (max(ys) + min(ys)) / 2

    def at(name: str) -> Spot:
        x, y = mode.places[name]
        return WIDTH / 2 + (x - middle[0]) / span, HEIGHT / 2 - (y - middle[1]) / span

    def listed(spots: Sequence[Spot]) -> str:
        return " ".join(f"{x:.1f},{y:.1f}" for x, y in spots)

    shapes = []
    mechanism = outcome.quantities.mechanism
    links = mechanism.links
    for name, joint in mechanism.prismatic_joints():
        ends = listed([at(line.point) for line in joint.line or ()])
        shapes.append(f'<polyline class="lw-centre" points="{ends}"><title>{markup(name)}</title></polyline>')
    for i, name in enumerate(name for name in links if name != FRAME):
        corners = listed([(z.real, z.imag) for z in hull(np.array([complex(*at(p)) for p in links[name].points]))])
        title = f"<title>{markup(name)}</title>"
        shapes.append(f'<polygon class="lw-body lw-c{i % 8}" points="{corners}">{title}</polygon>')
    for name in mode.places:
        (x, y), size = at(name), 4.5 if name in links[FRAME].points else 3
        title = f"<title>{markup(name)}</title>"
        shapes.append(f'<circle class="lw-pin" cx="{x:.1f}" cy="{y:.1f}" r="{size}">{title}</circle>')
    box = f"0 0 {WIDTH:.0f} {HEIGHT:.0f}"
    return f'<svg class="lw mode" viewBox="{box}" role="img">{"".join(shapes)}</svg>'


def mode_text(entry: ModeEntry) -> str:
    """Where a mode lies, and what is special about it."""
    parts = [say("modes.place", circuit=entry["circuit"], branch=entry["branch"])] if entry["circuit"] else []
    parts += [say("modes.own")] if entry["own"] else []
    parts += [say("modes.singular")] if entry["singular"] else []
    return "; ".join(parts)


def section(data: ModesData, words: Mapping[str, str]) -> str:
    """The report's section on assembly modes."""
    title = markup(words["report.modes"])
    texts = "".join(f"<p>{markup(text)}</p>" for text in data["sentences"])
    circuits = "".join(f"<li>{markup(circuit_text(entry, data))}</li>" for entry in data["circuits"])
    cards = "".join(_card(entry, picture) for entry, picture in zip(data["modes"], data["drawings"], strict=True))
    listed = f"<ul>{circuits}</ul>" if circuits else ""
    return f'<section id="modes"><h2>{title}</h2>{texts}{listed}<div class="modes">{cards}</div></section>'


def _card(entry: ModeEntry, picture: str) -> str:
    lines = markup("\n".join(assembly_text(entry["assembly"])) or say("modes.untold"))
    head = markup(say("modes.number", number=entry["number"]))
    note = markup(mode_text(entry))
    return f"<figure>{picture}<figcaption><b>{head}</b> {note}<pre>{lines}</pre></figcaption></figure>"


def assembly_text(lines: Sequence[str]) -> list[str]:
    """The lines of a file's assembly section."""
    return ["assembly:", *(f"  {line}" for line in lines)] if lines else []
