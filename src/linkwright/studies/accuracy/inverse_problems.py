"""What follows from coefficients backwards: tolerances from a wanted accuracy, dimensions from measurements."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from linkwright.findings import Finding
from linkwright.kernels import Compiled
from linkwright.measures import bound_measures
from linkwright.results import Run
from linkwright.studies.accuracy.allocation_options import Output, allocated, problem
from linkwright.studies.accuracy.calibration_options import calibrate, check_calibrate
from linkwright.studies.accuracy.contributors import Contributors
from linkwright.studies.accuracy.options import AccuracyOptions
from linkwright.studies.accuracy.outcome import AccuracyOutcome, OutputDeviations, SignalDeviations
from linkwright.studies.accuracy.stackup import larger
from linkwright.studies.figures import columns
from linkwright.studies.sampling_options import signal_faults

Array = NDArray[np.float64]


def check_design(
    compiled: Compiled, options: AccuracyOptions, contributors: Contributors, stop: float
) -> Iterator[Finding]:
    """What is wrong with what is asked of the coefficients and with the measurements; ``stop`` is
    the length of the run (s)."""
    if options.allocate is not None:
        outputs = _expected_outputs(compiled, options, len(contributors))
        yield from problem(compiled.quantities, options.allocate, contributors, outputs)[1]
    if options.calibrate is not None:
        run = Run(compiled, 0.0, stop, options.steps)
        yield from check_calibrate(compiled, options.calibrate, contributors, run)


def add_calibration(outcome: AccuracyOutcome) -> None:
    """Put the calibration into an outcome where it is asked for. Raises ModelError where its file is wrong."""
    if (options := outcome.options.calibrate) is not None:
        outcome.calibration, notes = calibrate(outcome.run, options, outcome.contributors)
        outcome.warnings += notes


def add_allocation(outcome: AccuracyOutcome) -> None:
    """Put the allocation into an outcome that has its figures and curves, where it is asked for."""
    if (options := outcome.options.allocate) is None:
        return
    outputs = {name: _of_figure(figure) for name, figure in outcome.every.items()}
    outputs |= {text: _of_curve(curve) for text, curve in outcome.curves.items()}
    outputs = {name: output for name, output in outputs.items() if output.coefficients.size}
    posed, findings = problem(outcome.compiled.quantities, options, outcome.contributors, outputs)
    if posed is None:  # a measure without a value has no figure
        outcome.warnings += [replace(finding, severity="warning") for finding in findings]
        return
    outcome.allocation, notes = allocated(posed)
    outcome.warnings += notes


def _of_figure(figure: OutputDeviations) -> Output:
    """One row; of a tie the larger coefficients, which are safe for each of its places."""
    return Output(larger(figure.coefficients)[None], figure.column.dimension, figure.column.unit, figure.column.size)


def _of_curve(curve: SignalDeviations) -> Output:
    """A row for each pose."""
    rows = curve.coefficients.T
    return Output(rows[np.isfinite(rows).all(axis=1)], curve.dimension, curve.unit, curve.size)


def _expected_outputs(compiled: Compiled, options: AccuracyOptions, count: int) -> dict[str, Output]:
    """All figures that the study will have, without their coefficients."""
    empty, quantities, found = np.empty((0, count)), compiled.quantities, {}
    for measure in bound_measures(quantities, options.measures(compiled)):
        for column in columns(compiled, measure):
            found[column.name] = Output(empty, column.dimension, column.unit, column.size)
    for signal in options.signals(compiled):
        if signal_faults(compiled, signal, ()):
            continue  # told with the outputs
        dimension = quantities.dimensions.dimension(signal.node)
        output = Output(empty, dimension, *quantities.unit_of(dimension))
        found |= dict.fromkeys((signal.text, *(f"{signal.text} at {p}" for p in options.positions)), output)
    return found
