"""Elements seen in a mirror: the x axis of the frame turned round, and the y axis of every moving link.

A point of the frame at (x, y) is at (-x, y), one of a moving link at (x, -y) in the link's own axes; directions follow.
The angle of a moving link's axes in the frame then is 180 deg less what it was, and a line on two links coincides as
before. What a kind states otherwise than by points and lines it mirrors itself (``mirrored``); a kind that doesn't say
how can't be mirrored.
"""

from __future__ import annotations

import re
from collections.abc import Container, Mapping
from typing import Any, Protocol, TypeVar, runtime_checkable

from linkwright.data_classes import dataclass
from linkwright.elements.points import FRAME
from linkwright.expressions.fields import Expression, FrozenDict, LineOn, Position
from linkwright.expressions.language import signal_text, signals_in

Made = TypeVar("Made")


class NotMirroredError(ValueError):
    """That can't be mirrored."""


HALF_TURN = "180 deg"
_SIGNAL = re.compile(r"(?<![\w.])[^\W\d]\w*\.\w+")
"""A signal as expressions name it, those of functions such as ``force`` apart."""


@dataclass(frozen=True)
class Reflection:
    """What a signal is in the mirror: a ``constant``, as a file has it, less what it was; or as it was."""

    opposite: bool = False
    constant: str = ""

    def original(self, signal: str) -> str:
        """What a signal of the mirror image was, as an expression."""
        if not self.opposite:
            return signal if not self.constant else f"({signal} - ({self.constant}))"
        return f"({self.constant} - {signal})" if self.constant else f"(-{signal})"

    def image(self, value: Expression) -> Expression:
        """What a value of the signal is in the mirror."""
        if not self.opposite:
            return value if not self.constant else Expression(f"{value.text} + ({self.constant})")
        return Expression(f"{self.constant} - ({value.text})") if self.constant else Expression(_opposite(value))


@dataclass(frozen=True)
class Mirror:
    """Mirrors positions and lines by the link on which they are: the frame, or one of the ``links`` that are mirrored
    with them. Those on other links can't be. ``signals`` has what becomes of signals of what is mirrored."""

    links: frozenset[str]
    signals: Mapping[str, Reflection] = FrozenDict()
    sliding: Container[frozenset[str]] = frozenset()
    """Pairs of links of which one slides on the other."""

    def holds(self, *links: str) -> None:
        """Raises :class:`NotMirroredError` where a link is neither the frame nor mirrored."""
        for link in links:
            self._check(link)

    def angle(self, link: str, on: str) -> Reflection:
        """What becomes of the angle of a link against another one."""
        self.holds(link, on)
        if FRAME in (link, on) and link != on:
            return Reflection(True, HALF_TURN if on == FRAME else f"-{HALF_TURN}")
        return Reflection(True)

    def turns(self, link: str, on: str) -> bool:
        """Whether the value of a link on another one is an angle."""
        return frozenset((link, on)) not in self.sliding

    def expression(self, value: Expression) -> Expression:
        """An expression in signals of the mirror image that has the value which it had before."""
        signals = {signal_text(one) for one in signals_in(value.node)}
        if not signals:
            return value
        if signals - self.signals.keys():
            raise NotMirroredError

        def original(found: re.Match[str]) -> str:
            return self.signals[found[0]].original(found[0]) if found[0] in signals else found[0]

        return Expression(_SIGNAL.sub(original, value.text))

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
