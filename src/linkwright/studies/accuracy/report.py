"""What the accuracy study shows."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

import numpy as np

from linkwright.drawing.charts import MOST_CHARTS
from linkwright.findings import Said, Text
from linkwright.presentation.blocks import Block, Chart, Charts, Copied, Section, Sentences, StudyReport
from linkwright.presentation.cells import Unit, percent
from linkwright.studies.accuracy.charts import curve_charts, figure_charts
from linkwright.studies.accuracy.design_report import design_sentences
from linkwright.studies.accuracy.disagreement import along, disagreement
from linkwright.studies.accuracy.outcome import AccuracyOutcome, OutputDeviations, SignalDeviations
from linkwright.studies.accuracy.summary import accuracy_entry
from linkwright.studies.accuracy.tables import deviation, further, moment, overview, review, review_text


def report(outcome: AccuracyOutcome) -> StudyReport:
    """What was done, a table of all outputs, each output by itself, further tables."""
    outputs = [block for blocks in _outputs(outcome) for block in blocks]
    blocks = [Sentences(sentences(outcome)), *overview(outcome), *outputs, *further(outcome)]
    return StudyReport([Section("accuracy", blocks)], accuracy_entry(outcome))


def sentences(outcome: AccuracyOutcome) -> list[Text]:
    """What was done, and what doesn't hold to first order."""
    if not outcome.every:
        return [Said("accuracy.sentence.none")]
    data = {"contributors": len(outcome.contributors), "samples": f"{outcome.samples:,}", "kernel": outcome.kernel}
    told: list[Text] = [Said("accuracy.sentence.samples" if outcome.samples else "accuracy.sentence", **data)]
    if outcome.failed:
        share = percent(outcome.failed / outcome.samples, 3)
        told.append(Said("accuracy.failed", failed=f"{outcome.failed:,}", samples=data["samples"], share=share))
    told += [text for figure in outcome.every.values() for text in _remarks(figure, outcome, brief=True)]
    apart = (disagreement(figure, outcome) for figure in outcome.every.values())
    if any(parted and parted.parted for parted in apart):
        told.append(Said("accuracy.parted.why"))
    return [*told, *design_sentences(outcome.allocation, outcome.calibration)]


def _outputs(outcome: AccuracyOutcome) -> Iterator[list[Block]]:
    """Of each output its contributors, what is to be known of it, its charts."""
    curves = {id(curve.figure): curve for curve in outcome.curves.values()}
    for number, figure in enumerate(outcome.every.values()):
        curve, charts = curves.get(id(figure)), list[Chart]()
        if number < MOST_CHARTS:
            charts = [*(curve_charts(curve, outcome) if curve else ()), *figure_charts(figure, outcome)]
        remarks = [*_remarks(figure, outcome), *(_along(curve, outcome) if curve else ())]
        yield [
            replace(review(figure, outcome), detail=True),
            Copied(Said("accuracy.copy"), review_text(figure, outcome)),
            Sentences(remarks, note=True, detail=True),
            Charts(charts),
        ]


def _remarks(figure: OutputDeviations, outcome: AccuracyOutcome, brief: bool = False) -> Iterable[Text]:
    """What is to be known of a figure; ``brief``, only what is amiss."""
    found, size = figure.searched, figure.column.size
    if (parted := disagreement(figure, outcome)) and (text := parted.sentence(figure.title)):
        yield text
    if found is not None and not (brief and found.off <= outcome.options.nonlinear):
        key = "accuracy.searched" if found.proven else "accuracy.searched.bound"
        ends = {"low": deviation(found.low / size, figure), "high": deviation(found.high / size, figure)}
        yield Said(key, name=figure.title, off=percent(found.off, 3), unit=Unit(figure.column.unit), **ends)
    if figure.tie and not brief:
        yield Said("accuracy.tie", name=figure.title)


def _along(curve: SignalDeviations, outcome: AccuracyOutcome) -> Iterable[Text]:
    """Where samples and RSS of a signal part ways."""
    places = np.flatnonzero(along(curve, outcome))
    if places.size:
        ends = {"low": moment(curve.t[places[0]], outcome), "high": moment(curve.t[places[-1]], outcome)}
        yield Said("accuracy.parted.along", count=places.size, poses=curve.t.size, **ends)
