"""What the sections that ask for maps share: how fine these are, which are shown, at what values lines are drawn."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Annotated, Any, ClassVar

from pydantic import Field

from linkwright.elements.fields import freeze
from linkwright.expressions.fields import Expression, Frozen, FrozenDict, Text
from linkwright.expressions.typed_fields import Context, Quantity
from linkwright.expressions.units import Dimension
from linkwright.findings import Finding, Joined
from linkwright.kernels import Compiled
from linkwright.model.mechanism import Mechanism
from linkwright.studies.numbers import constant, positive

Path = tuple[str | int, ...]


def _of_map(c: Context) -> Dimension | None:
    """The dimension of the map by whose name a value stands."""
    known: Mapping[str, Dimension] = c.entry.kinds_in(c.mechanism)
    return known.get(str(c.path[4]))


class MapsAsked(Frozen):
    """Maps over the drives' values."""

    section: ClassVar[str]

    steps: int = Field(200, ge=10, le=2000)
    show: tuple[Text, ...] | None = Field(None, max_length=20)
    levels: Annotated[
        dict[Text, Annotated[tuple[Expression, ...], Field(min_length=1, max_length=20)]], Quantity(_of_map), freeze
    ] = Field(default_factory=FrozenDict, examples=[{"condition": [2, 5, 10]}])

    def kinds_in(self, mechanism: Mechanism) -> Mapping[str, Dimension]:
        """The maps that there may be, with their dimensions."""
        return {}

    @property
    def path(self) -> Path:
        """Where the section stands."""
        return ("studies", "workspace", self.section)

    def check_drives(self, compiled: Compiled) -> Iterator[Finding]:
        """Maps need two drives."""
        if len(compiled.graph.drives) == 1:
            yield Finding("workspace.two-drives", self.path, {"section": self.section})

    def check_maps(
        self, compiled: Compiled, kinds: Mapping[str, Dimension], others: Mapping[str, str] | None = None
    ) -> Iterator[Finding]:
        """What is wrong with the names of maps and the lines' values; ``others`` are maps that there would be with
        another key of the section, by that key."""
        named: list[tuple[Path, str]] = [(("show", i), name) for i, name in enumerate(self.show or ())]
        named += [(("levels", name), name) for name in self.levels]
        for place, name in named:
            if name in (others or {}):
                data = {"name": name, "key": (others or {})[name]}
                yield Finding("workspace.map-task", (*self.path, *place), data)
            elif name not in kinds:
                yield Finding("workspace.map-name", (*self.path, *place), {"name": name[:60], "known": Joined(kinds)})
        for name, values in self.levels.items():
            for i, value in enumerate(values if name in kinds else ()):
                yield from constant(compiled.quantities, value, kinds[name], (*self.path, "levels", name, i))[1]

    def lines(self, compiled: Compiled, kinds: Mapping[str, Dimension]) -> dict[str, tuple[float, ...]]:
        """The values (SI) at which maps have lines, rising, where they are given."""
        value = compiled.quantities.value
        return {name: tuple(sorted({value(v, kinds[name]) for v in vs})) for name, vs in self.levels.items()}

    def shown_maps(self, usual: Sequence[str]) -> tuple[str, ...]:
        """The maps that are shown."""
        return tuple(dict.fromkeys(usual if self.show is None else self.show))


def limit(
    compiled: Compiled, expression: Expression, dimension: Dimension, path: Path, what: Any
) -> tuple[float | None, list[Finding]]:
    """The value of a limit, which has to be above zero, or what is wrong with it; ``what`` it is."""
    data = {"what": what, "given": expression.text[:60]}
    return positive(compiled.quantities, expression, dimension, path, "workspace.limit-positive", **data)
