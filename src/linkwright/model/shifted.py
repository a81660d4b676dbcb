"""What a sub-assembly states in the frame, where a copy of it is placed."""

from __future__ import annotations

from linkwright.expressions.fields import AssemblyRule, FrozenDict, Position
from linkwright.model.parts import Link


def _xy(at: Position) -> tuple[str, str]:
    """A position as two expressions."""
    first, second = at.first.text, at.second.text
    return (f"({first})*cos({second})", f"({first})*sin({second})") if at.polar else (f"({first})", f"({second})")


def _shifted(position: Position, by: Position) -> list[str]:
    return [f"{here} + {way}" for here, way in zip(_xy(position), _xy(by), strict=True)]


def shifted_link(link: Link, by: Position | None) -> Link:
    """The frame's points of a sub-assembly where the copy is; those by distances from others follow these."""
    if by is None:
        return link
    points = {name: Position(_shifted(at, by)) if isinstance(at, Position) else at for name, at in link.points.items()}
    return link.model_copy(update={"points": FrozenDict(points)})


def shifted_rule(rule: AssemblyRule, by: Position | None) -> AssemblyRule:
    """A rule of assembly; the approximate position of a point where the copy is."""
    return rule if by is None or rule.sketch is None else type(rule)(_shifted(rule.sketch, by))
