"""Counterweights: masses added to links."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, ClassVar, Self

from linkwright.elements.entries import ForceEntry
from linkwright.elements.fields import INERTIA, At
from linkwright.elements.force import ForceKind, Weight, register
from linkwright.elements.mirror import Mirror
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Name
from linkwright.expressions.typed_fields import Quantity, Ref, Sign
from linkwright.expressions.units import Dimension
from linkwright.findings import Term


class Counterweight(ForceEntry):
    """A mass added to a link, with or without mass of its own."""

    kind: ClassVar[str] = "counterweight"

    on: Annotated[Name, Ref("link")]
    mass: Annotated[Expression, Quantity(u.MASS, Sign.POSITIVE, "mass")]
    at: Annotated[At, Ref("point", of="on")]
    inertia: Annotated[Expression | None, INERTIA] = None

    def mirrored(self, name: str, mirror: Mirror) -> Self:
        """The same mass seen in a mirror."""
        if isinstance(self.at, str):
            return self
        return self.model_copy(update={"at": mirror.position(self.on, self.at)})


@register
class Counterweights(ForceKind[Counterweight]):
    """Masses added to links. Gravity and inertia act on a link with all that it carries."""

    name = "counterweight"
    section = "counterweights"
    entry = Counterweight
    usual = True
    acts = False

    def weighs(self, entry: Counterweight) -> Weight:
        return Weight(entry.on, entry.mass, entry.at, entry.inertia)

    def sentence(
        self, name: str, entry: Counterweight, effort: float, shown: Callable[[float, Dimension], str]
    ) -> Term:
        return Term("weight-on", name=name, link=entry.on)
