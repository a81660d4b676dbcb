"""The accuracy study as tables of text: outputs, contributors, joints with clearance."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from math import floor, inf, log10

import numpy as np

from linkwright.escape import printed
from linkwright.expressions.units import TIME
from linkwright.findings import Joined, Said, Text
from linkwright.presentation.blocks import Cell, Table
from linkwright.studies.accuracy.design_report import design_tables
from linkwright.studies.accuracy.outcome import AccuracyOutcome, Figure, MonteCarlo
from linkwright.studies.accuracy.summary import WIDE, part, per, ranked, study_entry

FIRST = 3
"""So many contributors are named beside an output."""


def overview(outcome: AccuracyOutcome) -> list[Table]:
    """A line for each output and position: worst case, RSS, Monte Carlo as deviations from the nominal value, what
    clearances add at most where there are any, and the first contributors."""
    rows = [_line(*place, outcome) for place in _places(outcome)]
    heads = ["output", "at", "nominal", "worst", "rss", "monte_carlo", "play", "first"]
    if not outcome.joints:
        del heads[-2]
        for row in rows:
            del row[-2]
    return [_grid("outputs", heads, rows, outcome)] if rows else []


def further(outcome: AccuracyOutcome) -> list[Table]:
    """Correlations, what clearances do, joints with clearance, allocation, calibration; those that there are."""
    grids = [_correlations(outcome), _play(outcome), _joints(outcome)]
    design = design_tables(outcome.allocation, outcome.calibration)
    grids += [_grid(name, heads, rows, outcome) for name, heads, rows in design]
    return grids


def _places(outcome: AccuracyOutcome) -> Iterator[tuple[str, Text, Figure]]:
    """Each output, the name of a position, and the figure there."""
    yield from ((name, "", figure) for name, figure in outcome.figures.items())
    for text, curve in outcome.curves.items():
        yield text, Said("accuracy.widest"), curve.figure
        yield from ((text, name, figure) for name, figure in curve.positions.items())


def _line(name: str, position: Text, figure: Figure, outcome: AccuracyOutcome) -> list[Cell]:
    first = [(outcome.contributors.every[i].name, float(figure.shares[i])) for i in ranked(figure)[:FIRST]]
    told = ", ".join(f"{name} {percent(share, 2)}" for name, share in first if share > 0)
    ranges = (_range(ends, figure) for ends in _totals(figure).values())
    play = [] if figure.play is None else [sign * figure.play.bound / figure.column.size for sign in (-1, 1)]
    nominal = _with(_nominal(figure), figure.column.unit)
    return [name, _at(position, figure, outcome), nominal, *ranges, _range(play, figure), told or "–"]


def _at(position: Text, figure: Figure, outcome: AccuracyOutcome) -> Text:
    time = "" if figure.time is None else moment(figure.time, outcome)
    return Joined(filter(None, (position, time)), ": ") if position or time else "–"


def _totals(figure: Figure) -> dict[str, tuple[float, ...]]:
    """Deviations of worst case, RSS, Monte Carlo (none without samples), in the figure's unit."""
    wide, found, size = WIDE * figure.sigma, figure.monte_carlo, figure.column.size
    sampled = () if found is None else [end - figure.nominal for end in found.interval]
    ends = {"worst": figure.worst, "rss": (figure.mean - wide, figure.mean + wide), "monte_carlo": sampled}
    return {key: tuple(end / size for end in pair) for key, pair in ends.items()}


def review(figure: Figure, outcome: AccuracyOutcome) -> Table:
    """A figure's contributors as a drawing review wants them, with what they come to."""
    heads = ("dimension", "nominal", "tolerance", "limits", "coefficient", "share", "contribution")
    size, unit, rows = figure.column.size, figure.column.unit, list[list[Cell]]()
    for i in ranked(figure):
        one = outcome.contributors.every[i]
        below, above = figure.coefficients[i] * one.size / size
        coefficient = f"{_number(below, 5)} / {_number(above, 5)}" if figure.tie else _number(above, 5)
        rows.append(
            [
                one.name,
                _with(_number(one.nominal / one.size), one.unit),
                one.stated,
                _with(f"{_signed(one.low / one.size)} / {_signed(one.high / one.size)}", one.unit),
                _with(coefficient, per(unit, one.unit)),
                percent(float(figure.shares[i])),
                _with(_range([end / size for end in part(figure, i, one)], figure), unit),
            ]
        )
    nominal = _with(_nominal(figure), unit)
    for key, ends in _totals(figure).items():
        rows.append([_head(key, outcome), nominal, "", "", "", "", _with(_range(ends, figure), unit)])
    return _grid("review", heads, rows, outcome, figure.name)


def review_text(figure: Figure, outcome: AccuracyOutcome) -> str:
    """The same for a spreadsheet: tab-separated, plain numbers, their units in columns of their own."""
    heads = (
        "dimension", "nominal", "unit", "tolerance", "lower", "upper", "coefficient", "coefficient_unit", "share",
        "contribution_low", "contribution_high", "output_unit",
    )  # fmt: skip
    size, unit = figure.column.size, figure.column.unit
    rows: list[list[Cell]] = [[_head(head, outcome) for head in heads]]
    for i in ranked(figure):
        one = outcome.contributors.every[i]
        low, high = part(figure, i, one)
        slope = float(figure.coefficients[i].mean()) * one.size / size
        limits = (_plain(one.low / one.size), _plain(one.high / one.size))
        share, ends = _plain(float(figure.shares[i])), (_plain(low / size), _plain(high / size))
        known = (one.name, _plain(one.nominal / one.size), one.unit, one.stated, *limits)
        rows.append([*known, _plain(slope), per(unit, one.unit), share, *ends, unit])
    for key, deviations in _totals(figure).items():
        contributions = [_plain(end) for end in deviations] or ["", ""]
        rows.append([_head(key, outcome), _plain(figure.nominal / size), unit, *[""] * 6, *contributions, unit])
    return "\n".join("\t".join(" ".join(str(cell).split()) for cell in row) for row in rows) + "\n"


def _correlations(outcome: AccuracyOutcome) -> Table:
    pairs = study_entry(outcome)["correlations"]
    rows = [[*pair["of"], _number(pair["is"])] for pair in pairs]
    return _grid("correlations", ("dimension", "dimension", "correlation"), rows, outcome)


def _play(outcome: AccuracyOutcome) -> Table:
    """What clearances add: under load, and at most; worst tolerances and clearances together; the joints' parts."""
    rows = []
    for name, position, figure in _places(outcome):
        if (play := figure.play) is None:
            continue
        size, (low, high) = figure.column.size, figure.worst
        joints = sorted(play.bounds, key=lambda joint: -play.bounds[joint])
        told = ", ".join(f"{joint} ±{_fixed(play.bounds[joint] / size, play.bound / size, 3)}" for joint in joints)
        bound = f"±{_fixed(play.bound / size, play.bound / size, 3)}"
        both = _range([(low - play.bound) / size, (high + play.bound) / size], figure)
        shift, nominal = deviation(play.shift / size, figure), _with(_nominal(figure), figure.column.unit)
        rows.append([name, _at(position, figure, outcome), nominal, shift, bound, both, told])
    return _grid("play", ("output", "at", "nominal", "shift", "bound", "together", "joints"), rows, outcome)


def _joints(outcome: AccuracyOutcome) -> Table:
    rows = []
    for joint in study_entry(outcome)["joints"]:
        lost = [
            Said(
                "accuracy.lost",
                low=_number(span["from"]),
                high=_number(span["to"]),
                unit=span["unit"],
                why=span["cause"],
            )
            for span in joint["contact_lost"]
        ]
        reaction = " .. ".join(_fixed(joint[end], joint["reaction_max"], 4) for end in ("reaction_min", "reaction_max"))
        clearance = _with(_number(joint["clearance"]), joint["unit"])
        rows.append(
            [
                joint["joint"],
                ", ".join(joint["links"]),
                clearance,
                _with(reaction, joint["reaction_unit"]),
                Joined(lost, "\n") if lost else Said("accuracy.kept"),
            ]
        )
    heads = ("joint", "links", "clearance", "reaction", "lost")
    return _grid("joints", heads, rows, outcome)


def _grid(
    name: str, heads: Iterable[str], rows: Sequence[Sequence[Cell]], outcome: AccuracyOutcome, of: str = ""
) -> Table:
    title = Said(f"accuracy.table.{name}", name=of)
    return Table(name, title, [_head(head, outcome) for head in heads], rows)


def _head(key: str, outcome: AccuracyOutcome) -> Said:
    sampled = (figure.monte_carlo for figure in outcome.every.values() if figure.monte_carlo is not None)
    coverage = next((found.coverage for found in sampled), MonteCarlo.coverage)
    return Said(f"accuracy.column.{key}", coverage=percent(coverage, 4))


# Numbers.


def _scale(figure: Figure) -> float:
    """How large a figure's deviations are, in its unit."""
    play = 0.0 if figure.play is None else figure.play.bound
    return max(figure.half, abs(figure.worst[0]), abs(figure.worst[1]), figure.sigma, play) / figure.column.size


def _fixed(value: float | None, scale: float | None, digits: int) -> str:
    """A number with so many digits of what is ``scale`` large."""
    if value is None or scale is None or not np.isfinite(value):
        return "–"
    decimals = digits - 1 - floor(log10(scale)) if 0 < scale < inf else 12
    return _sign(f"{value:.{decimals}f}" if 0 <= decimals <= 9 and abs(value) < 1e9 else f"{value:.6g}")


def _nominal(figure: Figure) -> str:
    return _fixed(figure.nominal / figure.column.size, _scale(figure), 3)


def deviation(value: float, figure: Figure) -> str:
    """A deviation in the figure's unit, with its sign."""
    text = _fixed(value, _scale(figure), 3)
    return f"+{text}" if value > 0 else text


def _range(ends: Iterable[float], figure: Figure) -> str:
    """Least and largest deviation; one figure where they are opposite."""
    texts = [deviation(end, figure) for end in ends]
    if len(texts) == 2 and texts[0].startswith("−") and texts[1] == f"+{texts[0][1:]}":
        return f"±{texts[0][1:]}"
    return " .. ".join(texts) or "–"


def _number(value: float | None, digits: int = 6) -> str:
    return "–" if value is None or not np.isfinite(value) else _sign(f"{value:.{digits}g}")


def _signed(value: float) -> str:
    return f"+{_number(value)}" if value > 0 else _number(value)


def _plain(value: float) -> str:
    return f"{value:.10g}" if np.isfinite(value) else ""


def _sign(text: str) -> str:
    return text.replace("-", "−")


def _with(text: str, unit: str) -> str:
    return f"{text} {printed(unit)}" if unit and text != "–" else text


def percent(share: float, digits: int = 3) -> str:
    """A share in percent."""
    rounded = float(f"{100 * share:.{digits}g}")  # no 1e+02
    return _sign(f"{rounded:g} %") if np.isfinite(share) else "–"


def moment(time: float | None, outcome: AccuracyOutcome) -> str:
    """A time (s) in the file's unit."""
    unit, second = outcome.compiled.quantities.unit_of(TIME)
    return "–" if time is None else f"{time / second:.6g} {unit}"
