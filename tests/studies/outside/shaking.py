"""A study of another package: the shaking force over a time, with its harmonics."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Annotated

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Frozen
from linkwright.expressions.typed_fields import Quantity
from linkwright.findings import Finding, Said
from linkwright.kernels import Compiled
from linkwright.model.csv_text import cell, head, table_text
from linkwright.presentation.blocks import Chart, Charts, FileOf, Section, Sentences, StudyReport, Table
from linkwright.presentation.cells import NumberCell
from linkwright.presentation.charts import Axis, Graph, Line
from linkwright.results import Result, Run
from linkwright.studies.numbers import constant
from linkwright.studies.registry import Command, Setting, Study, register
from linkwright.studies.run_context import RunContext

PATH = ("studies", "shaking")


class ShakingOptions(Frozen):
    """Over which time, and at how many poses."""

    over: Annotated[Expression, Quantity(u.TIME)] = Field(description="how long the force is looked at")
    samples: int = Field(360, ge=8, le=100_000, description="equal steps")
    kernel: str | None = Field(None, description="the kernel to compute with")


@dataclass
class ShakingOutcome:
    """The force (N) at the times (s): (2, times)."""

    compiled: Compiled
    run: Run
    kernel: str
    force: NDArray[np.float64] = field(default_factory=lambda: np.zeros((2, 0)))
    failures: list[Finding] = field(default_factory=list)
    warnings: list[Finding] = field(default_factory=list)
    done = True

    @property
    def result(self) -> Result:
        """The motion, for a drawing."""
        return Result(self.run)


@register
class Shaking(Study):
    """The shaking force over a time."""

    name = "shaking"
    example = "{over: 1 s}"
    options = ShakingOptions
    files = {"shaking.csv": FileOf(lambda outcome: _csv(outcome))}
    command = Command([Setting("samples", ("samples",), low=8), Setting("kernel", ("kernel",))])
    words = {
        "en": {
            "cli.study.shaking": "Look at the shaking force of a cycle.",
            "report.shaking": "Shaking force",
            "shaking.sentence": "Largest shaking force: {force} {unit} ({kernel} kernel).",
            "shaking.table": "Harmonics of the shaking force",
            "shaking.order": "Order",
            "shaking.size": "Amplitude, {unit}",
            "shaking.chart": "Shaking force over time",
        }
    }

    def check(self, compiled: Compiled, options: ShakingOptions) -> list[Finding]:
        """What is wrong with the time."""
        return constant(compiled.quantities, options.over, u.TIME, (*PATH, "over"))[1]

    def run(self, compiled: Compiled, options: ShakingOptions, site: RunContext) -> ShakingOutcome:
        """Compute the force."""
        stop = compiled.quantities.value(options.over, u.TIME)
        run = Run(compiled, 0.0, stop, options.samples)
        kernel = options.kernel or "numpy"
        force = replace(compiled, kernel=kernel, _kernels={}).evaluate(["shaking.x", "shaking.y"], run.t)
        return ShakingOutcome(compiled, run, kernel, np.asarray(force))

    def report(self, outcome: ShakingOutcome) -> StudyReport:
        """The largest force, its harmonics, a chart."""
        unit, size = outcome.compiled.quantities.unit_of(u.FORCE)
        x, y = outcome.force / size
        whole = np.hypot(x, y)
        largest = float(whole.max())
        sizes = np.abs(np.fft.fft(x[:-1] + 1j * y[:-1]))[:4] / (x.size - 1)
        told = Said("shaking.sentence", force=f"{largest:.6g}", unit=unit, kernel=outcome.kernel)
        heads = [Said("shaking.order"), Said("shaking.size", unit=unit)]
        rows = [[str(k), NumberCell(float(value), 6)] for k, value in enumerate(sizes)]
        title = Said("shaking.chart")

        def graph() -> Graph:
            return Graph(Axis(Said("plot.time"), "s"), outcome.run.t, Axis(title, unit), [Line(title, whole)])

        blocks = [
            Sentences([told]),
            Table("harmonics", Said("shaking.table"), heads, rows),
            Charts([Chart(title, shown=graph)]),
        ]
        summary = {"shaking": {"largest": largest, "unit": unit, "harmonics": sizes.tolist(), "kernel": outcome.kernel}}
        return StudyReport([Section("shaking", blocks)], summary)


def _csv(outcome: ShakingOutcome) -> str:
    unit, size = outcome.compiled.quantities.unit_of(u.FORCE)
    rows = zip(outcome.run.t.tolist(), *(outcome.force / size).tolist(), strict=True)
    return table_text([head("t", "s"), head("x", unit), head("y", unit)], (list(map(cell, row)) for row in rows))
