"""The varied parameters of a workspace study as sliders: which picture belongs to which of their values."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from linkwright.findings import Text
from linkwright.presentation.blocks import Chart, Slider
from linkwright.presentation.charts import Plane
from linkwright.studies.workspace.outcome import Workspace, WorkspaceOutcome, values_text


class SliderSteps:
    """Each varied parameter with its distinct values, rising; those with one value have no slider."""

    def __init__(self, outcome: WorkspaceOutcome) -> None:
        self.outcome = outcome
        every = {name: sorted({one.values[name] for one in outcome.workspaces}) for name in outcome.options.for_}
        self.values = {name: some for name, some in every.items() if len(some) > 1}

    def positions(self, one: Workspace) -> tuple[int, ...]:
        """The sliders' positions for a workspace."""
        return tuple(some.index(one.values[name]) for name, some in self.values.items())

    def chart(
        self, one: Workspace, stack: str, title: Text, shown: Callable[[], Plane], drawing: Callable[[], str]
    ) -> Chart:
        """A chart of a workspace with its picture for files, in a stack of such for other values."""
        return Chart(title, drawing, stack, self.positions(one), shown=shown)

    def sliders(self) -> Sequence[Slider]:
        """A slider for each parameter; it starts at the file's own value, where that is among them."""
        compiled = self.outcome.compiled
        own = dict(zip(compiled.graph.parameters, compiled.parameters.tolist(), strict=True))
        made: list[Slider] = []
        for name, some in self.values.items():
            texts = [values_text(compiled, {name: value}).partition(" = ")[2] for value in some]
            near = [i for i, value in enumerate(some) if abs(value - own[name]) <= 1e-9 * max(abs(value), 1e-9)]
            made.append(Slider(name, texts, near[0] if near else 0))
        return made
