"""The accuracy study: its parts put together."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from linkwright.findings import Finding, ModelError, Said
from linkwright.kernels import Compiled
from linkwright.kernels.manufactured_cam import with_cut_cams
from linkwright.kernels.parameter_batch import Varied
from linkwright.measures import BoundMeasure, bound_measures
from linkwright.presentation.blocks import FileOf, StudyReport
from linkwright.reductions import kind_of
from linkwright.results import Run
from linkwright.studies.accuracy.clearance import PATH as CLEARANCES
from linkwright.studies.accuracy.clearance_figures import state_plays
from linkwright.studies.accuracy.clearance_options import check_clearances
from linkwright.studies.accuracy.deviations import Deviations, Shift
from linkwright.studies.accuracy.figures import curves, figures
from linkwright.studies.accuracy.files import contributors_csv
from linkwright.studies.accuracy.inverse_problems import add_allocation, add_calibration, check_design
from linkwright.studies.accuracy.law_checks import check_laws
from linkwright.studies.accuracy.monte_carlo import check_monte_carlo, monte_carlo
from linkwright.studies.accuracy.options import AccuracyOptions
from linkwright.studies.accuracy.outcome import AccuracyOutcome, OutputDeviations
from linkwright.studies.accuracy.positions import WIDEST, PlacedSignal, check_positions, placed_signals
from linkwright.studies.accuracy.report import report
from linkwright.studies.accuracy.signal_sensitivities import Slopes
from linkwright.studies.accuracy.stated_contributors import check_contributors, contributors, skipped
from linkwright.studies.accuracy.worst_case_vertices import check_searched, evaluating, search
from linkwright.studies.cycle.options import span
from linkwright.studies.registry import Command, Setting, Study, register
from linkwright.studies.run_context import RunContext
from linkwright.studies.sampling import refused
from linkwright.studies.sampling_options import check_outputs, check_span


@register
class AccuracyStudy(Study):
    """What deviations do to the outputs."""

    name = "accuracy"
    example = "{outputs: [rocker.angle], positions: {middle: 0.5 s}}"
    options = AccuracyOptions
    rank = 4
    command = Command([Setting("samples", ("samples",), low=0), Setting("kernel", ("kernel",))], work=True, fresh=True)
    files = {
        "accuracy.csv": FileOf(contributors_csv),
        "accuracy_bands.csv": FileOf(lambda outcome: outcome.dataset.csv("time")),
        "accuracy.nc": FileOf(lambda outcome: outcome.dataset.netcdf(), "netcdf", asked=True),
    }

    def check(self, compiled: Compiled, options: AccuracyOptions) -> list[Finding]:
        """What is wrong with the options."""
        return list(_check(compiled, options)) if options.spanned else []

    def sampled_mechanism(self, compiled: Compiled) -> Compiled:
        """The mechanism with its cams cut to the nominal dimensions, which deviations don't alter."""
        return with_cut_cams(compiled)

    def draws(self, compiled: Compiled, options: AccuracyOptions) -> Deviations:
        """The random samples of the deviations that the file states."""
        deviations = contributors(compiled, options)
        return Deviations(compiled, deviations, options.plan, options.samples, options.seed)

    def run(self, compiled: Compiled, options: AccuracyOptions, site: RunContext) -> AccuracyOutcome:
        """Transfer coefficients, worst case, root sum square, random samples, and what is asked of these."""
        compiled = self.sampled_mechanism(compiled)
        nominal = Run(compiled, 0.0, span(compiled, options.cycle)[0], options.steps)
        deviations = contributors(compiled, options)
        outcome = AccuracyOutcome(compiled, options, nominal, deviations)
        if found := refused(nominal, options, deviations.names):
            outcome.failures = found
            return outcome
        texts = [signal.text for signal in options.signals(compiled)]
        add_calibration(outcome)
        slopes = Slopes(nominal, deviations.directions)
        outcome.curves = curves(nominal, slopes, deviations, texts)
        widest = {text: float(nominal.t[curve.widest]) for text, curve in outcome.curves.items()}
        placed = [*placed_signals(compiled, options, widest)]
        more = tuple(signal.measure for signal in placed)
        measures = [*bound_measures(compiled.quantities, options.measures(compiled)), *more]
        every = figures(nominal, slopes, deviations, measures)
        outcome.warnings += [*skipped(compiled, options), *_valueless(measures, every)]
        searched = search(evaluating(nominal, deviations, measures), deviations, every, options.nonlinear)
        outcome.warnings += check_searched(searched)
        for name, figure in every.items():
            figure.searched = searched.get(name)
        if options.samples and len(deviations):
            random = monte_carlo(nominal, options, site, more)
            outcome.kernel, outcome.samples, outcome.failed = random.choice.kernel, random.samples, random.failed
            outcome.state = random.state
            outcome.warnings += random.warnings
            for name, figure in every.items():
                figure.monte_carlo = figure.with_samples(random.figures.get(name))
            for text, sampled in random.curves.items():
                outcome.curves[text].sampled = sampled
        state_plays(outcome, options, measures, every)
        _place(outcome, every, placed)
        add_allocation(outcome)
        return outcome

    def report(self, outcome: AccuracyOutcome) -> StudyReport:
        """Each output with what contributes to it."""
        return report(outcome)

    def settle(self, outcome: AccuracyOutcome) -> None:
        """The state from which the same study would go on isn't needed any more."""
        outcome.settle()


def _check(compiled: Compiled, options: AccuracyOptions) -> Iterator[Finding]:
    wrong = list(check_contributors(compiled, options))
    yield from wrong
    yield from check_outputs(compiled, options)
    yield from _check_derivatives(compiled, options)
    yield from check_positions(compiled, options)
    yield from check_clearances(compiled, options.clearances, CLEARANCES)
    if wrong:
        return
    deviations = contributors(compiled, options)
    names = Shift(compiled, deviations).names
    yield from check_span(compiled, options, frozenset(names), "parameters")
    try:
        Varied(compiled, names)
    except ModelError as error:
        yield from error.findings
    yield from check_laws(compiled, deviations)
    yield from check_monte_carlo(options, deviations)
    stop, findings = span(compiled, options.cycle)
    if not findings:
        yield from check_design(compiled, options, deviations, stop)


def _check_derivatives(compiled: Compiled, options: AccuracyOptions) -> Iterator[Finding]:
    """Measures of which it isn't known how they follow deviations."""
    for name in options.measures(compiled):
        measure = compiled.mechanism.measures[name]
        if not kind_of(measure).differentiable:
            data = {"name": name, "reduction": measure.reduction}
            yield Finding("accuracy.no-derivative", ("studies", "accuracy", "outputs"), data)


def _valueless(measures: Sequence[BoundMeasure], every: Mapping[str, OutputDeviations]) -> Iterator[Finding]:
    """Measures without a value at the nominal dimensions, and signals without one at a position."""
    known = {figure.column.measure for figure in every.values()}
    for measure in measures:
        if measure.name not in known:
            yield Finding("measure.not-finite", measure.path, {"name": measure.name}, severity="warning")


def _place(outcome: AccuracyOutcome, every: Mapping[str, OutputDeviations], placed: Sequence[PlacedSignal]) -> None:
    """Give each figure its place in the outcome: a measure's, or that of a signal at a position. A signal without any
    value has no curve."""
    places = {signal.measure.name: signal for signal in placed}
    outcome.figures = {name: figure for name, figure in every.items() if name not in places}
    valued = set()
    for name, figure in every.items():
        if (signal := places.get(name)) is None:
            continue
        if signal.position == WIDEST:
            outcome.curves[signal.text].figure = figure
            valued.add(signal.text)
        else:
            title = Said("measure.placed", signal=signal.text, position=signal.position)
            figure.column = replace(figure.column, placed=title)
            outcome.curves[signal.text].positions[signal.position] = figure
    outcome.curves = {text: curve for text, curve in outcome.curves.items() if text in valued}
