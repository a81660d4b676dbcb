"""The accuracy study as tables: outputs, contributors, joints with clearance."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from math import floor, inf, log10

from linkwright.expressions.units import TIME
from linkwright.findings import Joined, Said, Term, Text
from linkwright.presentation.blocks import Table, table
from linkwright.presentation.cells import UNKNOWN, Cell, NumberCell, Numbers, percent
from linkwright.studies.accuracy.design_report import design_tables
from linkwright.studies.accuracy.outcome import AccuracyOutcome, MonteCarlo, OutputDeviations
from linkwright.studies.accuracy.summary import WIDE, part, ranked, study_entry
from linkwright.studies.figures import per

FIRST = 3
"""So many contributors are named beside an output."""


def overview(outcome: AccuracyOutcome) -> list[Table]:
    """A line for each output and position: worst case, RSS, Monte Carlo as deviations from the nominal value, what
    clearances add at most where there are any, and the first contributors."""
    rows = [_line(*place, outcome) for place in _places(outcome)]
    heads = ["output", "at", "nominal", "worst", "rss", "monte_carlo", "play", "first"]
    if not outcome.joints:
        heads, rows = [*heads[:-2], heads[-1]], [[*row[:-2], row[-1]] for row in rows]
    return [_table("outputs", heads, rows, outcome)]


def further(outcome: AccuracyOutcome) -> list[Table]:
    """Correlations, what clearances do, joints with clearance, allocation, calibration; those that there are."""
    design = design_tables(outcome.allocation, outcome.calibration)
    return [_correlations(outcome), _play(outcome), _joints(outcome), *design]


def _places(outcome: AccuracyOutcome) -> Iterator[tuple[Text, Text, OutputDeviations]]:
    """Each output, the name of a position, and the figure there."""
    yield from ((figure.title, "", figure) for figure in outcome.figures.values())
    for text, curve in outcome.curves.items():
        yield text, Said("accuracy.widest"), curve.figure
        yield from ((text, name, figure) for name, figure in curve.positions.items())


def _line(name: Text, position: Text, figure: OutputDeviations, outcome: AccuracyOutcome) -> list[Cell]:
    first = [(outcome.contributors.every[i].name, float(figure.shares[i])) for i in ranked(figure)[:FIRST]]
    told = Joined(f"{name} {percent(share, 2)}" for name, share in first if share > 0)
    ranges = (_range(ends, figure) for ends in _totals(figure).values())
    play = [] if figure.play is None else [sign * figure.play.bound / figure.column.size for sign in (-1, 1)]
    return [
        name,
        _position_text(position, figure, outcome),
        _nominal(figure),
        *ranges,
        _range(play, figure),
        told or UNKNOWN,
    ]


def _position_text(position: Text, figure: OutputDeviations, outcome: AccuracyOutcome) -> Cell:
    time = "" if figure.time is None else moment(figure.time, outcome)
    if position and time:
        return Term("colon", first=position, then=time)
    return position or time or UNKNOWN


def _totals(figure: OutputDeviations) -> dict[str, tuple[float, ...]]:
    """Deviations of worst case, RSS, Monte Carlo (none without samples), in the figure's unit."""
    wide, found, size = WIDE * figure.sigma, figure.monte_carlo, figure.column.size
    sampled = () if found is None else [end - figure.nominal for end in found.interval]
    ends = {"worst": figure.worst, "rss": (figure.mean - wide, figure.mean + wide), "monte_carlo": sampled}
    return {key: tuple(end / size for end in pair) for key, pair in ends.items()}


def review(figure: OutputDeviations, outcome: AccuracyOutcome) -> Table:
    """A figure's contributors as a drawing review wants them, with what they come to."""
    heads = ("dimension", "nominal", "tolerance", "limits", "coefficient", "share", "contribution")
    size, unit, rows = figure.column.size, figure.column.unit, list[list[Cell]]()
    for i in ranked(figure):
        one = outcome.contributors.every[i]
        coefficients = [NumberCell(float(c), 5) for c in figure.coefficients[i] * one.size / size]
        limits = [NumberCell(end / one.size, 6, signed=True) for end in (one.low, one.high)]
        rows.append(
            [
                one.name,
                NumberCell(one.nominal / one.size, 6, one.unit),
                one.stated,
                Numbers(limits, one.unit, " / "),
                Numbers(coefficients if figure.tie else coefficients[1:], per(unit, one.unit), " / "),
                percent(float(figure.shares[i]), 3),
                _range([end / size for end in part(figure, i, one)], figure, unit),
            ]
        )
    for key, ends in _totals(figure).items():
        rows.append([_head(key, outcome), _nominal(figure), *[""] * 4, _range(ends, figure, unit)])
    shown = _table("review", heads, rows, outcome, figure.title)
    if figure.time is None:
        return shown
    title = Said("accuracy.table.review.at", output=figure.title, time=moment(figure.time, outcome))
    return replace(shown, title=title)


def review_text(figure: OutputDeviations, outcome: AccuracyOutcome) -> str:
    """The same for a spreadsheet: tab-separated, plain numbers, their units in columns of their own."""
    heads = (
        "dimension", "nominal", "unit", "tolerance", "lower", "upper", "coefficient", "coefficient_unit", "share",
        "contribution_low", "contribution_high", "output_unit",
    )  # fmt: skip
    size, unit = figure.column.size, figure.column.unit
    rows: list[list[Cell]] = [[_head(head, outcome) for head in heads]]

    def plain(*values: float) -> list[Cell]:
        return [NumberCell(value, 10, unknown="") for value in values]

    for i in ranked(figure):
        one = outcome.contributors.every[i]
        slope = float(figure.coefficients[i].mean()) * one.size / size
        limits, ends = plain(one.low / one.size, one.high / one.size), (end / size for end in part(figure, i, one))
        known = [one.name, *plain(one.nominal / one.size), one.unit, one.stated, *limits]
        rows.append([*known, *plain(slope), per(unit, one.unit), *plain(float(figure.shares[i]), *ends), unit])
    for key, deviations in _totals(figure).items():
        contributions = plain(*deviations) or ["", ""]
        rows.append([_head(key, outcome), *plain(figure.nominal / size), unit, *[""] * 6, *contributions, unit])
    return "\n".join("\t".join(" ".join(str(cell).split()) for cell in row) for row in rows) + "\n"


def _correlations(outcome: AccuracyOutcome) -> Table:
    pairs = study_entry(outcome)["correlations"]
    rows = [[*pair["of"], NumberCell(pair["is"], 6)] for pair in pairs]
    return _table("correlations", ("dimension", "dimension", "correlation"), rows, outcome)


def _play(outcome: AccuracyOutcome) -> Table:
    """What clearances add: under load, and at most; worst tolerances and clearances together; the joints' parts."""
    rows = []
    for name, position, figure in _places(outcome):
        if (play := figure.play) is None:
            continue
        size, (low, high) = figure.column.size, figure.worst
        joints = sorted(play.bounds, key=lambda joint: -play.bounds[joint])
        told = Joined(f"{joint} ±{_fixed(play.bounds[joint] / size, play.bound / size, 3)}" for joint in joints)
        bound = f"±{_fixed(play.bound / size, play.bound / size, 3)}"
        both = _range([(low - play.bound) / size, (high + play.bound) / size], figure)
        shift = deviation(play.shift / size, figure)
        rows.append([name, _position_text(position, figure, outcome), _nominal(figure), shift, bound, both, told])
    return _table("play", ("output", "at", "nominal", "shift", "bound", "together", "joints"), rows, outcome)


def _joints(outcome: AccuracyOutcome) -> Table:
    rows = []
    for joint in study_entry(outcome)["joints"]:
        lost = [
            Said(
                "accuracy.lost", **{key: NumberCell(at[end], 6) for key, end in _LOST}, unit=at["unit"], why=at["cause"]
            )
            for at in joint["contact_lost"]
        ]
        reaction = [_fixed(joint[f"reaction_{end}"], joint["reaction_max"], 4) for end in ("min", "max")]
        clearance = NumberCell(joint["clearance"], 6, joint["unit"])
        told = Joined(lost, "\n") if lost else Said("accuracy.kept")
        links = Joined(joint["links"])
        rows.append([joint["joint"], links, clearance, Numbers(reaction, joint["reaction_unit"]), told])
    return _table("joints", ("joint", "links", "clearance", "reaction", "lost"), rows, outcome)


_LOST = (("low", "from"), ("high", "to"))


def _table(
    name: str, heads: Iterable[str], rows: Sequence[Sequence[Cell]], outcome: AccuracyOutcome, of: Text = ""
) -> Table:
    return table("accuracy", name, [_head(head, outcome) for head in heads], rows, output=of)


def _head(key: str, outcome: AccuracyOutcome) -> Said:
    sampled = (figure.monte_carlo for figure in outcome.every.values() if figure.monte_carlo is not None)
    coverage = next((found.coverage for found in sampled), MonteCarlo.coverage)
    return Said(f"accuracy.column.{key}", coverage=percent(coverage))


# Numbers.


def _scale(figure: OutputDeviations) -> float:
    """How large a figure's deviations are, in its unit."""
    play = 0.0 if figure.play is None else figure.play.bound
    return max(figure.half, abs(figure.worst[0]), abs(figure.worst[1]), figure.sigma, play) / figure.column.size


def _fixed(value: float | None, scale: float | None, digits: int, unit: str = "", signed: bool = False) -> NumberCell:
    """A number with so many digits of what is ``scale`` large."""
    if value is None or scale is None:
        return NumberCell(None)
    decimals = digits - 1 - floor(log10(scale)) if 0 < scale < inf else 12
    if 0 <= decimals <= 9 and abs(value) < 1e9:
        return NumberCell(value, decimals, unit, form="f", signed=signed)
    return NumberCell(value, 6, unit, signed=signed)


def _nominal(figure: OutputDeviations) -> NumberCell:
    return _fixed(figure.nominal / figure.column.size, _scale(figure), 3, figure.column.unit)


def deviation(value: float, figure: OutputDeviations) -> NumberCell:
    """A deviation in the figure's unit, with its sign."""
    return _fixed(value, _scale(figure), 3, signed=True)


def _range(ends: Iterable[float], figure: OutputDeviations, unit: str = "") -> Numbers:
    """Least and largest deviation."""
    return Numbers([deviation(end, figure) for end in ends], unit)


def moment(time: float, outcome: AccuracyOutcome) -> NumberCell:
    """A time (s) in the file's unit."""
    unit, second = outcome.compiled.quantities.unit_of(TIME)
    return NumberCell(time / second, 6, unit)
