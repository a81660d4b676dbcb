"""The accuracy study as sentences and tables, and as the section of the report."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import numpy as np

from linkwright.escape import markup
from linkwright.report.accuracy_charts import curve_charts, figure_charts
from linkwright.report.accuracy_design import design_sentences
from linkwright.report.accuracy_tables import deviation, further, moment, overview, percent, review, review_text
from linkwright.report.charts import MOST_CHARTS, figures
from linkwright.report.data import AccuracyData, Chart, Grid, OutputData
from linkwright.report.disagreement import along, disagreement
from linkwright.studies.accuracy.outcome import AccuracyOutcome, Curve, Figure
from linkwright.words import say


def accuracy_page(outcome: AccuracyOutcome) -> dict[str, AccuracyData]:
    """The report's data of the study."""
    return {
        "accuracy": {
            "sentences": sentences(outcome),
            "overview": overview(outcome),
            "outputs": _outputs(outcome),
            "tables": further(outcome),
        }
    }


def sentences(outcome: AccuracyOutcome) -> list[str]:
    """What was done, and what doesn't hold to first order."""
    if not outcome.every:
        return [say("accuracy.sentence.none")]
    data = {"contributors": len(outcome.contributors), "samples": f"{outcome.samples:,}", "kernel": outcome.kernel}
    told = [say("accuracy.sentence.samples" if outcome.samples else "accuracy.sentence", **data)]
    if outcome.failed:
        share = percent(outcome.failed / outcome.samples)
        told.append(say("accuracy.failed", failed=f"{outcome.failed:,}", samples=data["samples"], share=share))
    told += [text for figure in outcome.every.values() for text in _remarks(figure, outcome, brief=True)]
    apart = (disagreement(figure, outcome) for figure in outcome.every.values())
    if any(parted and parted.parted for parted in apart):
        told.append(say("accuracy.parted.why"))
    return [*told, *design_sentences(outcome.allocation, outcome.calibration)]


def section(data: AccuracyData, title: str, table: Callable[[Grid], str]) -> str:
    """The report's section; ``table`` makes a table of HTML."""
    head = "".join(f"<p>{markup(text)}</p>" for text in data["sentences"])
    outputs = "".join(_output(output, table) for output in data["outputs"])
    legend = f'<p class="note">{markup(say("accuracy.chart.legend"))}</p>' if outputs else ""
    tables = "".join(map(table, data["tables"]))
    return (
        f'<section id="accuracy"><h2>{markup(title)}</h2>{head}{"".join(map(table, data["overview"]))}'
        f"{legend}{outputs}{tables}</section>"
    )


def _output(output: OutputData, table: Callable[[Grid], str]) -> str:
    notes = "".join(f'<p class="note">{markup(text)}</p>' for text in output["sentences"])
    button = (
        f'<button type="button" class="copy screen" data-copy="{markup(output["copied"])}" hidden>'
        f"{markup(say('accuracy.copy'))}</button>"
    )
    return f'{table(output["review"])}{button}{notes}<div class="plots">{figures(output["charts"])}</div>'


def _outputs(outcome: AccuracyOutcome) -> list[OutputData]:
    curves = {id(curve.figure): curve for curve in outcome.curves.values()}
    made: list[OutputData] = []
    for figure in outcome.every.values():
        curve, charts = curves.get(id(figure)), list[Chart]()
        if len(made) < MOST_CHARTS:
            charts = [*(curve_charts(curve, outcome) if curve else ()), *figure_charts(figure, outcome)]
        made.append(
            {
                "name": figure.name,
                "sentences": [*_remarks(figure, outcome), *(_along(curve, outcome) if curve else ())],
                "review": review(figure, outcome),
                "copied": review_text(figure, outcome),
                "charts": charts,
            }
        )
    return made


def _remarks(figure: Figure, outcome: AccuracyOutcome, brief: bool = False) -> Iterable[str]:
    """What is to be known of a figure; ``brief``, only what is amiss."""
    found, size = figure.searched, figure.column.size
    if (parted := disagreement(figure, outcome)) and (text := parted.sentence(figure.name)):
        yield text
    if found is not None and not (brief and found.off <= outcome.options.nonlinear):
        key = "accuracy.searched" if found.proven else "accuracy.searched.bound"
        ends = {"low": deviation(found.low / size, figure), "high": deviation(found.high / size, figure)}
        yield say(key, name=figure.name, off=percent(found.off), unit=figure.column.unit, **ends)
    if brief:
        return
    if figure.time is not None:
        yield say("accuracy.at", time=moment(figure.time, outcome))
    if figure.tie:
        yield say("accuracy.tie", name=figure.name)


def _along(curve: Curve, outcome: AccuracyOutcome) -> Iterable[str]:
    """Where samples and RSS of a signal part ways."""
    places = np.flatnonzero(along(curve, outcome))
    if places.size:
        ends = {"low": moment(curve.t[places[0]], outcome), "high": moment(curve.t[places[-1]], outcome)}
        yield say("accuracy.parted.along", count=places.size, poses=curve.t.size, **ends)
