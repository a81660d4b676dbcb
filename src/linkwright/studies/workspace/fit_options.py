"""The section ``fits`` of a workspace study: required circles and rectangles, and the largest there is room for."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Annotated, Any

from pydantic import ConfigDict, Field, RootModel

from linkwright.elements.fields import Vector, freeze
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Frozen
from linkwright.expressions.fields import Name as NameField
from linkwright.expressions.typed_fields import Context, Quantity, Sign
from linkwright.expressions.written import Fault
from linkwright.findings import Finding, Joined
from linkwright.kernels import Compiled
from linkwright.model.walk import ExpressionPlace, sites
from linkwright.studies.numbers import constant
from linkwright.studies.sampling_options import one_of
from linkwright.studies.workspace.path_options import positive
from linkwright.studies.workspace.target_path import Path_

if TYPE_CHECKING:
    from linkwright.studies.workspace.options import WorkspaceOptions

PATH: Path_ = ("studies", "workspace", "fits")
KINDS = ("circle", "rectangle", "largest")
MOST = 100
"""The most figures of one study."""

Largest = one_of("workspace", "largest", ["circle", "rectangle"])


class RequiredFit(Frozen):
    """A circle or rectangle that has to fit into a region; or the largest one is looked for."""

    circle: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE)] = None
    rectangle: Annotated[Vector | None, Quantity(u.LENGTH, Sign.POSITIVE)] = None
    largest: Largest | None = None  # type: ignore[valid-type]
    centre: Annotated[Vector | None, Quantity(u.LENGTH)] = None
    angle: Annotated[Expression | None, Quantity(u.ANGLE)] = None
    aspect: Annotated[Expression | None, Quantity(u.PURE, Sign.POSITIVE)] = None

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        kinds = [key for key in KINDS if key in given]
        if len(kinds) != 1:
            yield "workspace.fit-kind", {"given": Joined(kinds) or "-"}
        oblong = "rectangle" in given or given.get("largest") == "rectangle"
        for key, fitting, of in (
            ("angle", oblong, "rectangle, largest: rectangle"),
            ("aspect", given.get("largest") == "rectangle", "largest: rectangle"),
            ("centre", "circle" in given or "rectangle" in given, "circle, rectangle"),
        ):
            if kinds and key in given and not fitting:
                yield "workspace.path-key", {"key": key, "of": of}

    def stated_numbers(self, compiled: Compiled, name: str) -> Iterator[tuple[ExpressionPlace, Sign]]:
        """The numbers of the figure of this name, each with the sign that it must have."""
        for site in sites(self, Context(compiled.mechanism, (*PATH, name))):
            yield from ((place, site.parts[0][1].sign_at(site.context)) for place in site.places())


class RequiredFits(RootModel[Annotated[dict[NameField, RequiredFit], freeze, Field(min_length=1, max_length=MOST)]]):
    """Figures by name."""

    model_config = ConfigDict(frozen=True)

    def check(self, compiled: Compiled, options: WorkspaceOptions) -> Iterator[Finding]:
        """What is wrong with them."""
        if len(compiled.graph.drives) != 2:
            yield Finding("workspace.section-drives", PATH, {"count": len(compiled.graph.drives)})
            return
        for name, figure in self.root.items():
            for place, sign in figure.stated_numbers(compiled, name):
                dimension = compiled.quantities.dimensions.resolve(place.wanted)
                if sign is Sign.POSITIVE:
                    yield from positive(compiled, place.expression, dimension, place.path)
                else:
                    yield from constant(compiled.quantities, place.expression, dimension, place.path)[1]
