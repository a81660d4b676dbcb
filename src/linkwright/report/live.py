"""What a report needs to compute its mechanism itself: programs in place of tables, and the numbers that can be moved.

All numbers that stand in the model file are parameters of these programs. Where a page can't compute a motion it shows
what was recorded: a sweep of a drive, a structure that stands, a redundant mechanism, a motion through change points,
whose branches hold at the nominal parameters alone.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.compilation import compile_named
from linkwright.escape import printed
from linkwright.expressions.units import ANGLE, LENGTH, TIME
from linkwright.findings import Finding, Joined, ModelError, Term, Text, enumerated
from linkwright.graph.power_rows import PowerRow
from linkwright.kernels import Compiled
from linkwright.kernels.page_inputs import Length, number_conditions
from linkwright.kernels.page_programs import PagePrograms, page_programs
from linkwright.measures import live_measures, live_rows
from linkwright.model.conditions import Condition
from linkwright.model.desugar import file_paths
from linkwright.model.document import Document
from linkwright.model.drawn_numbers import DrawnNumber, EntryPlace, drawn_numbers, entry_place
from linkwright.model.live_numbers import LiveNumber as WrittenLiveNumber
from linkwright.model.live_numbers import live_numbers
from linkwright.model.named_numbers import NamedNumbers, named_numbers
from linkwright.model.yaml_text import Source
from linkwright.notation.jets import varies
from linkwright.presentation.json_numbers import known
from linkwright.report.arrows import Arrow, arrow_rows
from linkwright.report.data import LiveData, LiveEntry, LiveNumber, Plot, SaidBy, Scene
from linkwright.report.joint_shapes import live_joint_shapes
from linkwright.report.number_names import number_name
from linkwright.report.outlines import LiveOutline
from linkwright.report.packed import pruned
from linkwright.report.signal_list import measured_signals, signal_list
from linkwright.results import Result
from linkwright.studies.cycle.options import CycleOptions, length_condition
from linkwright.studies.drive_sweep import Sweep

Array = NDArray[np.float64]

EVERY = 3
"""Of how many rows one is compared."""
PROBE = 7919
"""A prime: the pose at which the value of row i is compared is i times this, modulo the number of poses."""

ROUND_OFF = 1e-9
"""A row that is nowhere larger than this share of the largest of its kind is only round-off."""


def can_be_live(result: Result) -> bool:
    """Whether a page can compute what a result shows."""
    return recorded_for(result) is None


def recorded_for(result: Result) -> str | None:
    """Why a page shows a result as it was recorded, as a key of its texts; ``None`` where it can compute it."""
    run = result.run
    if run.compiled.structure.releases:  # other numbers may no longer agree with what is left out
        return "redundant"
    if isinstance(run, Sweep):
        return "sweep"
    if run.compiled.passages.every:  # branches hold at the nominal parameters alone
        return "passages"
    return None if run.start == 0.0 < run.stop else "stands"


def live_data(
    document: Document,
    source: Source,
    result: Result,
    scene: Scene,
    plots: Sequence[Plot],
    arrows: Sequence[Arrow] = (),
) -> LiveData | None:
    """The data of a result that a report shows by this scene, plots and arrows; ``source`` is what was read of the
    model file. ``None`` where the page can't compute it."""
    if not can_be_live(result):
        return None
    recorded, named = result.run.compiled, named_numbers(document)
    try:
        compiled = compile_named(named, recorded.folder)
    except ModelError:  # a number that has to stand there as such
        return None
    names = dict.fromkeys(f"{trace['name']}.{axis}" for trace in scene["traces"] for axis in "xy")
    names |= dict.fromkeys(series["name"] for plot in plots for series in plot["series"])
    pointed = arrow_rows(arrows)
    names |= dict.fromkeys(row for row in pointed if isinstance(row, str))
    listed, quantities = signal_list(result, names), recorded.quantities
    signals = [*listed.names]
    others = [row for row in pointed if not isinstance(row, str)]
    dimensions = [*map(result.dimension, signals), *(pointed[row] for row in others)]
    measures = live_measures(compiled)
    measured = live_rows(measures)
    weighs = any(compiled.mechanism.has_mass(link) for link in compiled.mechanism.links)
    power = weighs or any(one.kind.acts for one in compiled.mechanism.acting())
    balance = [PowerRow(), PowerRow(size=True)] if power else []
    cams: list[LiveOutline] = []
    if compiled.mechanism.cams:
        from linkwright.report.cam_shapes import live_cam_shapes

        cams = live_cam_shapes(compiled)
    outlines = [*cams, *live_joint_shapes(compiled)]
    place = entry_place(named, source)
    drawn = drawn_numbers(named) if place else []
    made = page_programs(
        compiled,
        [*compiled.graph.pose_rows, *signals, *others, *balance],
        measured,
        [one.program for one in outlines],
        _length(document, compiled),
        [one.name for one in drawn],
    )
    values = [*recorded.evaluate(recorded.graph.pose_rows, result.t), *(result[name] for name in signals)]
    values += [*recorded.evaluate(others, result.t)] if others else []
    written = live_numbers(named, source)
    stated = [place.line] if drawn and place and place.line else []
    lines = _Lines(source, [*stated, *(one["line"] for one in written if one["name"] in made.derived.inputs)])
    labels = {one["name"]: one["label"] for one in written}
    numbers = [*_numbers(made, named, written, lines, labels), *_drawn(made, drawn, labels)]
    probed = [*enumerate(values)][::EVERY]
    kinds = [*("pose" for _ in compiled.graph.pose_rows), *dimensions]
    return {
        "code": made.code(),
        "program": made.data(),
        "times": result.t.tolist(),
        "length": quantities.unit_of(LENGTH)[1],
        "second": quantities.unit_of(TIME)[1],
        "poses": list(compiled.structure.topology.moving),
        "signals": signals,
        "arrow_rows": recorded.graph.labels(others),
        "sizes": [quantities.unit_of(dimension)[1] for dimension in dimensions],
        "units": listed.units,
        "owners": listed.owners,
        "axes": listed.axes,
        "wrapped": [i for i, name in enumerate(signals) if recorded.graph.wrapped(name)],
        "probes": [known(float(f"{row[i * PROBE % result.t.size]:.12g}")) for i, row in probed],
        "scales": [float(f"{one:.2g}") for one in _scales(values, kinds)[::EVERY]],
        "outlines": [one.data() for one in outlines],
        "cams": bool(cams),
        "power": power,
        "measures": [pruned(one.data({row: i for i, row in enumerate(measured)})) for one in measures],
        "measured": measured_signals((one.measure for one in measures), listed.names),
        "conditions": [
            {"place": place, "what": one.fault("{value}", _figure_places(one)).said("what"), "size": one.size}
            for one, place in zip(made.conditions, _places(document, named, made.conditions), strict=True)
        ],
        "numbers": numbers,
        "entry": _entry(place, lines) if drawn else None,
        "lines": lines.shown,
        "drives": list(compiled.graph.drives),
        "by": _said_by(compiled),
        "gap": _gap_texts(compiled),
        "groups": [
            (enumerated(group.links), enumerated([connection.joint for connection in group.outer]))
            for group in compiled.graph.branched
        ],
        "parameters": list(compiled.graph.parameters),
    }


def _length(document: Document, compiled: Compiled) -> Length | None:
    """How long the cycle of a file lasts, where that depends on its numbers."""
    if "cycle" not in document.studies:
        return None
    options = CycleOptions.model_validate(document.studies["cycle"], context=document.studies)
    length = partial(length_condition, compiled, options)
    margin = number_conditions(compiled, length=length)[-1].margin
    return length if varies(margin) else None


def _said_by(compiled: Compiled) -> SaidBy | None:
    """The drive by whose values it is said where the mechanism can't be assembled, as findings have it; none where
    drives follow an output."""
    drives = compiled.mechanism.drives
    if not drives or any(drive.output for drive in drives.values()):
        return None
    name = next(name for name in compiled.graph.drives if name in drives)
    _, size = compiled.quantities.drive_unit(name)
    return {"drive": compiled.graph.drives.index(name), "size": size}


def _gap_texts(compiled: Compiled) -> list[tuple[Text, Text]]:
    """What findings say of a dyad that can't close and what mends it, with places for links, joints and figures: where
    it must span too much, and where too little."""
    if (by := _said_by(compiled)) is None:
        return []
    name, (unit, _) = compiled.graph.drives[by["drive"]], compiled.quantities.unit_of(LENGTH)
    data = {key: f"{{{key}}}" for key in ("links", "joints", "from", "to", "distance")}
    data |= {"drive": name, "unit": compiled.quantities.drive_unit(name)[0], "length_unit": unit}
    found: list[tuple[Text, Text]] = []
    for short, lengths in (("gap-wide", "lengths-longer"), ("gap-narrow", "lengths-equal")):
        terms = {
            "short": Term(short, by="{by}", limit="{limit}", unit=unit),
            "lengths": Term(lengths, by="{by}", unit=unit),
        }
        finding = Finding("motion.cannot-assemble", ("links",), data | terms)
        found.append((finding.said("what"), finding.said("mend")))
    return found


def _figure_places(condition: Condition) -> list[str]:
    """Places for the figures of a condition's sentence, which the page fills."""
    return [f"{{f{k}}} {figure.unit}" for k, figure in enumerate(condition.figures)]


def _places(document: Document, named: NamedNumbers, conditions: Sequence[Condition]) -> list[str]:
    """The places of conditions in the file, as findings have them."""
    findings = named.with_file_paths(condition.finding for condition in conditions)
    paths = file_paths(document, (finding.path for finding in findings))
    return [replace(finding, path=path).element for finding, path in zip(findings, paths, strict=True)]


def _scales(rows: Sequence[Array], kinds: Sequence[object]) -> list[float]:
    """How large the values of each row are, at least a millionth of the largest of its kind; of one that is only
    round-off, which adds up along a long chain, a thousandth of that."""
    largest = [float(np.max(np.abs(row), initial=0.0, where=np.isfinite(row))) for row in rows]
    of_kind: dict[object, float] = {}
    for kind, most in zip(kinds, largest, strict=True):
        of_kind[kind] = max(of_kind.get(kind, 1e-12), most)
    return [
        (1e-3 if most < ROUND_OFF * of_kind[kind] else max(most / of_kind[kind], 1e-6)) * of_kind[kind]
        for kind, most in zip(kinds, largest, strict=True)
    ]


class _Lines:
    """The lines of a file that a page has, in their order."""

    def __init__(self, source: Source, numbers: Iterable[int]) -> None:
        every = (source.text or "").splitlines()
        self._numbers = sorted({*numbers})
        self.shown = [every[line - 1] for line in self._numbers]

    def index(self, line: int) -> int:
        """The place of a line of the file (from 1) among those of the page."""
        return bisect_left(self._numbers, line)


def _entry(place: EntryPlace | None, lines: _Lines) -> LiveEntry | None:
    if place is None:
        return None
    line = None if place.line is None else lines.index(place.line)
    return {"line": line, "column": place.column, "indent": place.indent, "unit": place.unit}


def _drawn(made: PagePrograms, drawn: Sequence[DrawnNumber], labels: Mapping[str, str]) -> list[LiveNumber]:
    """What follows from the sketch, and is stated once it is moved."""
    found: list[LiveNumber] = []
    (unit, size), scale = made.compiled.quantities.unit_of(LENGTH), float(f"{made.compiled.assembly.size():.3g}")
    for one in drawn:
        why = made.locked.get(one.name)
        found.append(
            {
                "name": one.name,
                "label": one.name,
                "called": one.name,
                "value": one.value,
                "low": float(f"{one.low:.6g}"),
                "high": float(f"{one.high:.6g}"),
                "tolerance": None,
                "scale": scale,
                "unit": printed(unit),
                "size": size,
                "named": one.is_length,
                "drawn": True,
                "locked": "" if why is None else _labelled(why, labels).said("what"),
                "line": 0,
                "start": 0,
                "end": 0,
            }
        )
    return found


def _numbers(
    made: PagePrograms,
    named: NamedNumbers,
    written: Sequence[WrittenLiveNumber],
    lines: _Lines,
    labels: Mapping[str, str],
) -> list[LiveNumber]:
    """The numbers that stand in the text and are free."""
    found: list[LiveNumber] = []
    free, stated = {*made.derived.inputs}, made.compiled.mechanism.parameters
    scales = {LENGTH: made.compiled.assembly.size(), ANGLE: 1.0}
    for one in written:
        name = one["name"]
        if name not in free:
            continue
        dimension = made.compiled.quantities.dimensions.of(name)
        why = made.locked.get(name)
        found.append(
            {
                "name": name,
                "label": one["label"],
                "called": number_name(one["path"], one["label"]),
                "value": one["value"],
                "low": float(f"{one['low']:.6g}"),
                "high": float(f"{one['high']:.6g}"),
                "tolerance": one["tolerance"],
                "scale": float(f"{scales.get(dimension, abs(one['value']) or one['size']):.3g}"),
                "unit": printed(one["unit"]),
                "size": one["size"],
                "named": named.numbers[name].is_parameter if name in named.numbers else name in stated,
                "locked": "" if why is None else _labelled(why, labels).said("what"),
                "drawn": False,
                "line": lines.index(one["line"]),
                "start": one["start"],
                "end": one["end"],
            }
        )
    return found


def _labelled(finding: Finding, labels: Mapping[str, str]) -> Finding:
    """A finding with the names that a page has for numbers of the file, which have none there."""

    def label(value: Any) -> Any:
        if isinstance(value, Joined):
            return Joined(labels.get(str(part), part) for part in value.parts)
        return labels.get(value, value) if isinstance(value, str) else value

    return replace(finding, data={key: label(value) for key, value in finding.data.items()})
