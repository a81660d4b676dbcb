"""Cylinders, a short form: one line of a file that stands for a barrel, a rod and the slide between them.

A cylinder ``lift`` from the point K to the point M becomes the links ``lift_barrel`` (pinned at K) and ``lift_rod``
(pinned at M) and the prismatic joint ``lift``, whose travel is the distance of the two pins.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Annotated, Any, Self

from pydantic import Field

from linkwright.elements.fields import INERTIA, PART_LENGTH, Interval, PointName
from linkwright.elements.mirror import Mirror
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Frozen
from linkwright.expressions.typed_fields import ELSEWHERE, Quantity, Sign


class CylinderPart(Frozen):
    """The mass of a cylinder's barrel or rod."""

    # Its numbers are those of the link that it becomes, and looked at there.

    mass: Annotated[Expression, Quantity(u.MASS, Sign.NOT_NEGATIVE, "mass")]
    com: Annotated[Expression, Quantity(u.LENGTH)]
    inertia: Annotated[Expression | None, INERTIA] = None

    @property
    def uniform(self) -> bool:
        """Whether it is a slender uniform rod, with a point at its far end."""
        return self.inertia is None


class Cylinder(Frozen):
    """A cylinder or linear actuator between two points: barrel, rod and their slide, whose value is the distance."""

    from_: PointName = Field(alias="from")
    to: PointName
    length: Annotated[Interval | None, PART_LENGTH] = None
    barrel: Annotated[CylinderPart | None, ELSEWHERE] = None
    rod: Annotated[CylinderPart | None, ELSEWHERE] = None

    def stands_for(self, name: str) -> tuple[dict[str, Any], dict[str, Any]]:
        """The links and the slide of one of that name, as a file would state them."""
        barrel, rod = links_of(name)
        links = {barrel: _part(barrel, self.from_, self.barrel, 1), rod: _part(rod, self.to, self.rod, -1)}
        return links, {"prismatic": [barrel, rod], "line": [f"{self.from_} at 0", f"{self.to} at 0"]}

    def mirrored(self, name: str, mirror: Mirror) -> Self:
        """The same cylinder seen in a mirror: all of it lies on one line."""
        return self

    def parts(self, name: str) -> Iterator[tuple[str, str, CylinderPart | None]]:
        """Link, key and mass of barrel and rod."""
        yield from zip(links_of(name), ("barrel", "rod"), (self.barrel, self.rod), strict=True)


def links_of(name: str) -> tuple[str, str]:
    """The names of a cylinder's two links."""
    return f"{name}_barrel", f"{name}_rod"


def ends_of(cylinders: Iterable[str]) -> set[str]:
    """The points that barrels and rods of cylinders have besides their pins, by the cylinders' names."""
    return {end_of(link) for name in cylinders for link in links_of(name)}


def end_of(link: str) -> str:
    """The point at the far end of a barrel or rod."""
    return f"{link}_end"


def _part(link: str, pin: str, part: CylinderPart | None, sign: int) -> dict[str, Any]:
    """Barrel or rod: its pin is the origin, its x axis runs from the barrel's pin to the rod's."""
    data: dict[str, Any] = {"points": {pin: [0, 0]}}
    if part is not None:
        data["mass"] = part.mass
        if part.uniform:  # as long as puts its centre where it is
            data["points"][end_of(link)] = [_times(2 * sign, part.com), 0]
            data["shape"] = f"rod {pin}-{end_of(link)}"
        else:
            data |= {"com": [_times(sign, part.com), 0], "inertia": part.inertia}
    return data


def _times(factor: int, length: Expression) -> Any:
    return length.raw if factor == 1 else f"{factor}*({length.text})"
