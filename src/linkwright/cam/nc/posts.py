"""Posts: how each control wants the motions written."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import ClassVar

from linkwright.cam.nc.job import MillingJob, Pass
from linkwright.cam.nc.lead_in import beyond
from linkwright.cam.nc.path import Element
from linkwright.escape import nc
from linkwright.notation.registry import Registry

RATIO = (0.25, 4.0)
"""The feed on arcs is scaled within these."""


class Post:
    """A control: its frame around the motions, its comments. ``compensates``: it has G41 and G42. ``longest`` is the
    longest line that it takes; ``most`` the most digits after the point."""

    name: ClassVar[str]
    suffix: ClassVar[str] = "nc"
    compensates: ClassVar[bool] = True
    longest: ClassVar[int] = 127
    most: ClassVar[int] = 4

    def comment(self, text: str) -> str:
        """A remark."""
        return f"({nc(text)})"

    def head(self, job: MillingJob) -> list[str]:
        """What comes before the first motion."""
        raise NotImplementedError

    def foot(self, job: MillingJob) -> list[str]:
        """What comes after the last."""
        return ["M5", "M9", "M30"]

    def text(self, job: MillingJob, passes: Sequence[Pass], notes: Sequence[str] = ()) -> str:
        """The whole file."""
        writer = _ModalWriter(min(job.decimals, self.most))
        lines = [*self.head(job), *map(self.comment, notes), f"G0 Z{writer.number(job.clear)}"]
        for one in passes:
            lines.append(self.comment(f"{one.note.upper()} Z{writer.number(one.z)}"))
            lines += self._once(writer, job, one)
        return "\n".join([*lines, *self.foot(job)]) + "\n"

    def _once(self, writer: _ModalWriter, job: MillingJob, one: Pass) -> Iterator[str]:
        """Down, around, up."""
        x, y = one.entry
        if one.side:  # switched on and off on straight ways of their own, from beside the entry
            nx, ny = beyond(one.elements[0], one.aside)
            yield writer.straight(0, x + nx, y + ny)
        else:
            yield writer.straight(0, x, y)
        yield f"G0 Z{writer.number(min(2.0, job.clear))}"
        yield f"G1 Z{writer.number(0.0 if one.heights else one.z)} F{job.plunge:.0f}"
        writer.word, writer.feed = 1, None
        if one.side:
            yield f"{'G41' if one.side > 0 else 'G42'} D{job.tool} " + writer.straight(1, x, y, job.feed)
        heights = one.heights or (None,) * len(one.elements)
        for element, z in zip(one.elements, heights, strict=True):
            yield writer.element(element, job.feed * min(max(element.ratio, RATIO[0]), RATIO[1]), z)
        if one.side:
            ex, ey = one.elements[-1].end
            nx, ny = beyond(one.elements[-1], one.aside, last=True)
            yield "G40 " + writer.straight(1, ex + nx, ey + ny)
        yield f"G0 Z{writer.number(job.clear)}"
        writer.word = 0


POSTS: Registry[Post] = Registry()


def register(cls: type[Post]) -> type[Post]:
    """Register a post under its name."""
    POSTS[cls.name] = cls()
    return cls


@register
class LinuxCnc(Post):
    """LinuxCNC (RS-274/NGC)."""

    name = "linuxcnc"
    suffix = "ngc"
    longest = 255

    def head(self, job: MillingJob) -> list[str]:
        blend = f"{job.blend:.4f}"
        return [
            "%",
            self.comment(job.name),
            "G17 G54 G40 G49 G80 G90",
            "G21",
            f"G64 P{blend} Q{blend}",
            f"T{job.tool} M6",
            f"G43 H{job.tool}",
            f"S{job.speed:.0f} M3",
        ]

    def foot(self, job: MillingJob) -> list[str]:
        return ["M5", "M9", "M2", "%"]


@register
class Fanuc(Post):
    """Fanuc 0i, 30i and the like."""

    name = "fanuc"

    def head(self, job: MillingJob) -> list[str]:
        return [
            "%",
            f"O{job.number:04d} {self.comment(job.name)}",
            "G17 G54 G40 G49 G80 G90",
            "G21 G94",
            f"T{job.tool} M6",
            f"G0 G43 H{job.tool} Z{job.clear:.3f}",
            f"S{job.speed:.0f} M3",
        ]

    def foot(self, job: MillingJob) -> list[str]:
        return ["M5", "M9", "M30", "%"]


@register
class Siemens(Post):
    """Sinumerik 840D."""

    name = "siemens"
    suffix = "mpf"
    longest = 512

    def comment(self, text: str) -> str:
        return f"; {nc(text)}"

    def head(self, job: MillingJob) -> list[str]:
        return [
            self.comment(job.name),
            "G17 G54 G71 G40 G90 G94",
            f"T{job.tool} M6",
            f"CYCLE832({job.blend:.4f},_FINISH,1)",
            f"S{job.speed:.0f} M3",
        ]


@register
class Grbl(Post):
    """Grbl 1.1: no compensation, no tool table, no canned cycles."""

    name = "grbl"
    compensates = False
    longest = 70

    def head(self, job: MillingJob) -> list[str]:
        return [self.comment(job.name), "G17 G21 G90 G94 G54", "G40", f"S{job.speed:.0f} M3"]


class _ModalWriter:
    """Modal words: what hasn't changed isn't written."""

    def __init__(self, decimals: int) -> None:
        self.decimals = decimals
        self.word: int | None = None
        self.feed: str | None = None

    def number(self, value: float, more: int = 0) -> str:
        """Fixed decimals; controls may take a number without a point as one of the smallest unit."""
        decimals = self.decimals + more
        return f"{round(value, decimals) + 0.0:.{decimals}f}"

    def _start(self, word: int, feed: float | None) -> tuple[str, str]:
        """The G word and the feed, where they change."""
        front = "" if word == self.word else f"G{word} "
        self.word = word
        shown = None if feed is None else f"{feed:.0f}"
        back = f" F{shown}" if shown is not None and shown != self.feed else ""
        self.feed = shown or self.feed
        return front, back

    def straight(self, word: int, x: float, y: float, feed: float | None = None, z: float | None = None) -> str:
        """A straight motion."""
        front, back = self._start(word, feed)
        return f"{front}{self._place(x, y, z)}{back}"

    def element(self, element: Element, feed: float, z: float | None = None) -> str:
        """A motion of the path, which ends at the depth ``z`` where that isn't the same."""
        (x, y), (sx, sy) = element.end, element.start
        if element.centre is None:
            return self.straight(1, x, y, feed, z)
        front, back = self._start(3 if element.turn > 0 else 2, feed)
        i, j = element.centre[0] - sx, element.centre[1] - sy
        return f"{front}{self._place(x, y, z)} I{self.number(i, 1)} J{self.number(j, 1)}{back}"

    def _place(self, x: float, y: float, z: float | None) -> str:
        deep = "" if z is None else f" Z{self.number(z)}"
        return f"X{self.number(x)} Y{self.number(y)}{deep}"
