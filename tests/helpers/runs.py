"""The runs of examples, and limits of their measures as they are searched for."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from linkwright.app.job import examine_file
from linkwright.expressions.language import Node
from linkwright.measures import bound_measures
from linkwright.results import Run
from linkwright.studies.change_point_carry import carry_through_change_points
from linkwright.studies.cycle.options import CycleOptions, span

EXAMPLES = Path(__file__).parents[2] / "examples"


def example_run(name: str) -> Run:
    """The cycle of an example."""
    examined = examine_file(EXAMPLES / name)
    assert examined.compiled is not None
    options = next(task.options for task in examined.tasks if task.study.name == "cycle")
    assert isinstance(options, CycleOptions)
    stop, _ = span(examined.compiled, options)
    run = Run(examined.compiled, 0.0, stop, options.samples)
    return carry_through_change_points(run)[0] if options.through == "keep" else run


def trees(run: Run) -> dict[str, Node]:
    """The expressions of its measures, bound to SI."""
    every = bound_measures(run.compiled.quantities)
    return {measure.name: measure.signal for measure in every if measure.entry.reduction != "straightness"}


def edges(run: Run, panels: int) -> np.ndarray:
    """Equal panels, cut where something may bend or jump."""
    every = np.unique(np.concatenate([np.linspace(run.start, run.stop, panels + 1), run.breaks]))
    return every[np.append(True, np.diff(every) > 1e-12 * (run.stop - run.start))]
