"""The cam study as entries of the summary, sentences and tables, in the file's units (NC code in mm)."""

from __future__ import annotations

from typing import Any

import numpy as np

from linkwright.cam.checks import CamCheck
from linkwright.expressions import units as u
from linkwright.findings import Said, Text
from linkwright.presentation.blocks import Block, Charts, Section, Sentences, StudyReport, Table, table
from linkwright.presentation.cells import Cell, NumberCell, Unit, Verdict, numbers
from linkwright.presentation.json_numbers import known, listed
from linkwright.studies.cam.charts import charts, of_disc
from linkwright.studies.cam.force_findings import MEASURES
from linkwright.studies.cam.forces_report import force_charts, force_entry, force_sentences
from linkwright.studies.cam.milled_discs import Milled
from linkwright.studies.cam.outcome import CamOutcome
from linkwright.studies.cam.plate import Plate


def cam_entry(outcome: CamOutcome) -> dict[str, Any]:
    """Entries of the summary: the figures are among the file's measures too."""
    quantities = outcome.compiled.quantities
    length, size = quantities.unit_of(u.LENGTH)
    angle, deg = quantities.unit_of(u.ANGLE)
    entry: dict[str, Any] = {"cam": outcome.name, "follower": outcome.disc.follower.name, "figures": {}}
    for figure in outcome.figures:
        unit, one = quantities.unit_of(figure.dimension)
        told = {
            "value": known(figure.value / one),
            "unit": unit,
            "at": figure.theta / deg,
            "at_unit": angle,
        }
        if figure.wanted is not None:
            told |= {"require": str(outcome.options.require[figure.name].raw), "met": figure.kept}
        entry["figures"][figure.name] = told
    entry |= _plate(outcome, outcome.first) | force_entry(outcome)
    entry["checks"] += [_check(outcome, check) for check in outcome.force_checks]
    if outcome.map is not None:
        found = outcome.map
        entry["size"]["map"] = {
            "base": (found.first / size).tolist(),
            found.names[1]: (found.second / size).tolist(),
            "margins": [*map(listed, found.margins)],
        }
    if outcome.second is not None:
        follower = outcome.second.disc.follower
        entry["second"] = {"base": follower.base / size, "roller": follower.radius / size, "unit": length}
        entry["second"] |= _plate(outcome, outcome.second)
    return {"measures": entry["figures"], "cam": entry}


def _plate(outcome: CamOutcome, plate: Plate) -> dict[str, Any]:
    """What is told of each disc."""
    length, size = outcome.compiled.quantities.unit_of(u.LENGTH)
    entry: dict[str, Any] = {"checks": [_check(outcome, check) for check in plate.checks]}
    if outcome.stated.base is not None:
        least = plate.smallest
        entry["size"] = {"base": None if least is None else least / size, "unit": length}
    if plate.has_profile:
        entry["contour"] = {
            "elements": len(plate.elements),
            "tolerance": plate.stated.tolerance / size,
            "area": plate.area / size**2,
            "unit": length,
        }
    if plate.volume is not None:
        entry["volume"] = {"value": plate.volume / size**3, "unit": f"{length}^3"}
    return entry | {"nc": {one.post.name: _milled(outcome, one) for one in plate.milled}}


def _check(outcome: CamOutcome, check: CamCheck) -> dict[str, Any]:
    dimension = MEASURES.get(check.name, u.ANGLE if check.name.startswith("pressure") else u.LENGTH)
    unit, size = outcome.compiled.quantities.unit_of(dimension)
    angle, deg = outcome.compiled.quantities.unit_of(u.ANGLE)
    return {
        "name": check.name,
        "value": check.value / size,
        "at": check.theta / deg,
        "limit": None if check.limit is None else check.limit / size,
        "margin": None if check.margin is None else check.margin / size,
        "unit": unit,
        "angle_unit": angle,
        "kept": check.passed,
    }


def _milled(outcome: CamOutcome, one: Milled) -> dict[str, Any]:
    """A file and its proof: lift in the file's unit, per ``angle_unit`` of the cam; mm, s."""
    unit, size = outcome.compiled.quantities.unit_of(outcome.lift_dimension)
    angle, deg = outcome.compiled.quantities.unit_of(u.ANGLE)
    proof = one.proof
    told: dict[str, Any] = {"written": one.proven, "lines": one.lines, "tolerance": one.job.tolerance / size}
    told |= {"unit": unit, "angle_unit": angle}
    if proof.faults:
        return told
    if proof.play is not None:
        told["play_mm"] = [known(1e3 * play) for play in proof.play]
    return told | {
        "lift_error": known(proof.worst / size),
        "velocity_error": known(float(np.abs(proof.rate).max()) / size * deg),
        "gouge_mm": 1e3 * proof.gouge,
        "rest_mm": 1e3 * proof.rest,
        "time_s": proof.time,
        "length_m": proof.length,
    }


def report(outcome: CamOutcome) -> StudyReport:
    """What was found, pictures and charts, tables."""
    drawn, summary = [*charts(outcome), *force_charts(outcome)], cam_entry(outcome)
    blocks: list[Block] = [Sentences(cam_sentences(outcome)), Charts(drawn), *cam_tables(outcome, summary["cam"])]
    return StudyReport([Section("cam", blocks)], summary)


def cam_sentences(outcome: CamOutcome) -> list[Text]:
    """What was found, in words."""
    length, size = outcome.compiled.quantities.unit_of(u.LENGTH)
    told = list[Text]()
    for plate in outcome.plates:
        key = ("cam.sentence" if plate.has_profile else "cam.sentence.none") + ("-second" if plate.second else "")
        within = outcome.options.tolerance.text
        told.append(Said(key, name=outcome.name, elements=len(plate.elements), tolerance=within))
        if plate.smallest is not None:
            base = {"base": f"{plate.smallest / size:.6g}", "unit": length}
            told.append(Said("cam.sentence.second-base" if plate.second else "cam.sentence.base", **base))
    by = {check.name: check for check in outcome.first.checks}
    roller = outcome.disc.follower.radius
    if roller > 0 and "profile_radius" in by and "pitch_radius" in by:
        data = {"profile": by["profile_radius"].value, "roller": roller, "pitch": by["pitch_radius"].value}
        told.append(Said("cam.sentence.paper", unit=length, **{k: f"{v / size:.6g}" for k, v in data.items()}))
    return [*told, *force_sentences(outcome)]


def cam_tables(outcome: CamOutcome, entry: dict[str, Any]) -> list[Table]:
    """Its entry as tables."""
    figures: list[list[Cell]] = [
        [
            Said(f"cam.figure.{name}"),
            NumberCell(one["value"]),
            Unit(one["unit"]),
            _place(one),
            one.get("require", "–"),
            _mark(one),
        ]
        for name, one in entry["figures"].items()
    ]
    checks, made, parts = list[list[Cell]](), list[list[Cell]](), list[list[Cell]]()
    for one, second in [(entry, False), *([(entry["second"], True)] if outcome.second else [])]:
        checks += [_disc_row(second, _check_row(check)) for check in one["checks"]]
        made += [_disc_row(second, _nc_row(post, m)) for post, m in one["nc"].items() if "lift_error" in m]
        parts += [_disc_row(second, row) for row in _parts(one)]
    play = ("play",) if any("play_mm" in m for m in entry["nc"].values()) else ()
    columns = ("post", "error", "tolerance", "unit", "velocity", "gouge", "rest", *play, "time", "lines", "written")
    return [
        table("cam", "figures", ("figure", "value", "unit", "at", "required", "verdict"), figures),
        table("cam", "checks", ("check", "value", "unit", "at", "limit", "margin", "verdict"), checks),
        table("cam", "nc", columns, made),
        table("cam", "parts", ("part", "value", "unit"), parts),
    ]


def _disc_row(second: bool, row: list[Cell]) -> list[Cell]:
    """A row of which the first cell says that it is the second disc's."""
    name, *others = row
    assert isinstance(name, Text)
    return [of_disc(name, second), *others]


def _check_row(c: dict[str, Any]) -> list[Cell]:
    numbers: list[Cell] = [
        NumberCell(c["value"]),
        Unit(c["unit"]),
        _place(c),
        NumberCell(c["limit"]),
        NumberCell(c["margin"]),
    ]
    return [Said(f"cam.check.{c['name']}"), *numbers, _mark(c)]


def _nc_row(post: str, m: dict[str, Any]) -> list[Cell]:
    error: list[Cell] = [NumberCell(m["lift_error"], 3), NumberCell(m["tolerance"]), Unit(m["unit"])]
    speed = NumberCell(m["velocity_error"], 3, f"{m['unit']}/{m['angle_unit']}")
    off: list[Cell] = [NumberCell(m["gouge_mm"], 3), NumberCell(m["rest_mm"], 3)]
    if "play_mm" in m:
        off.append(numbers(m["play_mm"], 2))
    return [
        post,
        *error,
        speed,
        *off,
        NumberCell(m["time_s"], 0, form="f"),
        NumberCell(m["lines"], 9),
        _word(m["written"]),
    ]


def _parts(entry: dict[str, Any]) -> list[list[Cell]]:
    rows = list[list[Cell]]()
    if "contour" in entry:
        rows.append(
            [Said("cam.part.area"), NumberCell(entry["contour"]["area"], 9), Unit(f"{entry['contour']['unit']}^2")]
        )
    if "volume" in entry:
        rows.append([Said("cam.part.volume"), NumberCell(entry["volume"]["value"], 9), Unit(entry["volume"]["unit"])])
    return rows


def _place(entry: dict[str, Any]) -> NumberCell:
    return NumberCell(entry["at"], 6, entry.get("at_unit") or entry["angle_unit"])


def _mark(entry: dict[str, Any]) -> Cell:
    if "require" in entry:
        return Verdict(entry["met"], Said("cam.met" if entry["met"] else "cam.not-met"))
    return _word(entry["kept"]) if entry.get("limit") is not None else "–"


def _word(kept: bool) -> Verdict:
    return Verdict(kept, Said("cam.kept" if kept else "cam.not-kept"))
