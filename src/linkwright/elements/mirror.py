"""Elements seen in a mirror: the x axis of the frame turned round, and the y axis of every moving link.

A point of the frame at (x, y) is at (-x, y), one of a moving link at (x, -y) in the link's own axes; directions follow.
The angle of a moving link's axes in the frame then is 180 deg less what it was, and a line on two links coincides as
before. What a kind states otherwise than by points and lines it mirrors itself (``mirrored``); a kind that doesn't say
how can't be mirrored.
"""

from __future__ import annotations

from collections.abc import Container
from typing import Any, Protocol, TypeVar, runtime_checkable

from linkwright.data_classes import dataclass
from linkwright.elements.points import FRAME
from linkwright.expressions.fields import Expression, LineOn, Position

Made = TypeVar("Made")


class NotMirroredError(ValueError):
    """That can't be mirrored."""


@dataclass(frozen=True)
class Mirror:
    """Mirrors positions and lines by the link on which they are: the frame, or one of the ``links`` that are mirrored
    with them. Those on other links can't be."""

    links: Container[str]

    def position(self, link: str, at: Position) -> Position:
        """A position on a link."""
        self._check(link)
        if at.sketched:
            return at
        if at.polar:
            return Position(f"{at.first.text} at {self._direction(link, at.second)}")
        x, y = at.first, at.second
        return Position([_opposite(x), y.raw]) if link == FRAME else Position([x.raw, _opposite(y)])

    def line(self, link: str, line: LineOn) -> LineOn:
        """A line on a link."""
        self._check(link)
        return LineOn(f"{line.point} at {self._direction(link, line.angle)}")

    def _check(self, link: str) -> None:
        if link != FRAME and link not in self.links:
            raise NotMirroredError

    def _direction(self, link: str, angle: Expression) -> str:
        return f"180 deg - ({angle.text})" if link == FRAME else str(_opposite(angle))


def _opposite(value: Expression) -> Any:
    """The opposite of a number or expression, as a file has it; a zero stays."""
    return value.raw if value.bare_number() == 0 else f"-({value.text})"


@runtime_checkable
class Mirrored(Protocol):
    """An entry that says how it is mirrored."""

    def mirrored(self: Made, name: str, mirror: Mirror) -> Made:
        """The same element of that name, seen in a mirror. Raises :class:`NotMirroredError` where there is none."""


def mirrored(entry: Made, name: str, mirror: Mirror) -> Made:
    """An entry of that name seen in a mirror. Raises :class:`NotMirroredError`."""
    if not isinstance(entry, Mirrored):
        raise NotMirroredError
    return entry.mirrored(name, mirror)
