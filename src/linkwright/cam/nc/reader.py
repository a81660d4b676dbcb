"""A modal interpreter of G-code (ISO 6983 / RS-274): what a machine does on reading a file, or why it would stop.

It knows the words that milling a plate cam needs, in the XY plane; anything else is a fault, not ignored: a proof must
not pass over what it doesn't understand.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import field, replace

from linkwright.data_classes import dataclass

Place = tuple[float, float, float]

INCH = 25.4
MISMATCH = (0.005, 0.001)
"""An arc's radii at its ends may differ by so many mm, or by this share (Grbl; the strictest of the controls)."""

WORD = re.compile(r"\s*([A-Za-z])\s*([-+]?(?:\d+\.?\d*|\.\d+))")
COMMENT = re.compile(r"\([^)]*\)|;.*$")
CALL = re.compile(r"\s*(?:N\d+\s*)?CYCLE832\([^)]*\)\s*$", re.IGNORECASE)
SILENT = {"17", "40", "49", "54", "64", "80", "94", "43", "61.1"}
"""G words without a motion that this reader has nothing to do for."""


@dataclass(frozen=True)
class Move:
    """A motion of the cutter's programmed point, mm and mm/min.

    ``centre`` is the arc's, ``None`` of a straight one; ``turn`` +1 counter-clockwise, -1 clockwise. ``side``: +1 where
    the cutter runs left of the path by its radius (G41), -1 right (G42), 0 on it. ``feed`` is ``None`` at rapid speed.
    """

    line: int
    start: Place
    end: Place
    centre: tuple[float, float] | None = None
    turn: int = 0
    feed: float | None = None
    side: int = 0

    @property
    def radius(self) -> float:
        """Of an arc (mm)."""
        assert self.centre is not None
        return math.hypot(self.start[0] - self.centre[0], self.start[1] - self.centre[1])

    @property
    def sweep(self) -> float:
        """The angle of an arc (rad, positive), a whole turn where it ends at its start."""
        assert self.centre is not None
        (cx, cy), (sx, sy, _), (ex, ey, _) = self.centre, self.start, self.end
        angle = self.turn * (math.atan2(ey - cy, ex - cx) - math.atan2(sy - cy, sx - cx)) % (2 * math.pi)
        return angle if angle > 1e-12 else 2 * math.pi

    @property
    def length(self) -> float:
        """Of the way (mm), helices included."""
        rise = self.end[2] - self.start[2]
        if self.centre is not None:
            return math.hypot(self.radius * self.sweep, rise)
        return math.dist(self.start, self.end)


@dataclass(frozen=True)
class NCFault:
    """What a control would stop at, or do otherwise than meant: ``key`` and ``data`` say it, ``line`` where."""

    key: str
    line: int
    data: dict[str, str] = field(default_factory=dict)


@dataclass
class Read:
    """The motions of a file, its faults; ``ended`` where it has M2 or M30."""

    moves: list[Move] = field(default_factory=list)
    faults: list[NCFault] = field(default_factory=list)
    spindle: bool = False
    ended: bool = False


@dataclass(frozen=True)
class _State:
    place: tuple[float | None, float | None, float | None] = (None, None, None)
    motion: str | None = None
    absolute: bool = True
    unit: float | None = None
    feed: float | None = None
    side: int = 0
    spindle: bool = False


SETTINGS: dict[str, dict[str, object]] = {
    "20": {"unit": INCH},
    "21": {"unit": 1.0},
    "70": {"unit": INCH},
    "71": {"unit": 1.0},
    "90": {"absolute": True},
    "91": {"absolute": False},
    "40": {"side": 0},
    "41": {"side": 1},
    "42": {"side": -1},
}
MOTIONS = {"0": 0, "1": 0, "2": -1, "3": 1}
MACHINE = {"3": {"spindle": True}, "5": {"spindle": False}}
QUIET = {"6", "8", "9", "7"}
END = {"2", "30"}


def read(text: str) -> Read:
    """What a control does with a file."""
    made, state = Read(), _State()
    for number, raw in enumerate(text.splitlines(), start=1):
        line = "" if CALL.match(raw) else COMMENT.sub("", raw).strip()
        if not line or line == "%" or re.fullmatch(r"[O:]\d+", line):
            continue
        if made.ended:
            made.faults.append(NCFault("nc.after-end", number, {"text": line[:40]}))
            break
        words = WORD.findall(line)
        if "".join(WORD.sub("", line).split()):
            made.faults.append(NCFault("nc.unreadable", number, {"text": line[:40]}))
            continue
        state = _block(made, state, number, [(letter.upper(), value) for letter, value in words])
    if not made.ended:
        made.faults.append(NCFault("nc.no-end", len(text.splitlines())))
    return made


def _plain(value: str) -> str:
    """``01`` and ``1.0`` as ``1``."""
    return f"{float(value):g}"


def _block(made: Read, state: _State, number: int, words: list[tuple[str, str]]) -> _State:
    values: dict[str, float] = {}
    for letter, value in words:
        if letter == "G":
            code = _plain(value)
            if code in SETTINGS:
                state = replace(state, **SETTINGS[code])  # type: ignore[arg-type]
            elif code in MOTIONS:
                state = replace(state, motion=code)
            elif code not in SILENT:
                made.faults.append(NCFault("nc.unknown", number, {"word": f"G{code}"}))
        elif letter == "M":
            code = _plain(value)
            if code in MACHINE:
                state = replace(state, **MACHINE[code])  # type: ignore[arg-type]
                made.spindle |= state.spindle
            elif code in END:
                made.ended = True
            elif code not in QUIET:
                made.faults.append(NCFault("nc.unknown", number, {"word": f"M{code}"}))
        elif letter in values:
            made.faults.append(NCFault("nc.twice", number, {"word": letter}))
        elif letter in "XYZIJKRFNSTHDPQ":
            values[letter] = float(value)
        else:
            made.faults.append(NCFault("nc.unknown", number, {"word": f"{letter}{value}"}))
    if "F" in values:
        state = replace(state, feed=values["F"] * (state.unit or 1.0))
    if values.keys() & set("XYZIJ"):
        state = _read_motion(made, state, number, values)
    return state


def _read_motion(made: Read, state: _State, number: int, values: dict[str, float]) -> _State:
    faults = list(_unset(state, values))
    scale = state.unit or 1.0
    place = list(state.place)
    for i, letter in enumerate("XYZ"):
        if letter in values:
            before = 0.0 if state.absolute else place[i] or 0.0
            place[i] = before + values[letter] * scale
    state, before_state = replace(state, place=(place[0], place[1], place[2])), state
    made.faults += [NCFault(key, number) for key in faults]
    if faults or None in before_state.place or None in state.place:
        return state
    start, end = before_state.place, state.place
    turn = MOTIONS[state.motion or "0"]
    feed = None if state.motion == "0" else state.feed
    move = Move(number, start, end, None, turn, feed, state.side)  # type: ignore[arg-type]
    if turn:
        move = replace(
            move, centre=(move.start[0] + values.get("I", 0.0) * scale, move.start[1] + values.get("J", 0.0) * scale)
        )
        made.faults += _arc(move, values)
    made.moves.append(move)
    return state


def _unset(state: _State, values: dict[str, float]) -> Iterator[str]:
    """What must have been said before a motion."""
    if state.motion is None:
        yield "nc.no-motion"
    if state.unit is None:
        yield "nc.no-unit"
    if state.motion != "0" and state.motion is not None:
        if not state.feed:
            yield "nc.no-feed"
        if not state.spindle:
            yield "nc.no-spindle"
    if state.motion in ("2", "3"):
        if "R" in values or not values.keys() & set("IJ"):
            yield "nc.no-centre"
    elif values.keys() & set("IJR"):
        yield "nc.centre-on-line"


def _arc(move: Move, values: dict[str, float]) -> Iterator[NCFault]:
    assert move.centre is not None
    last = math.hypot(move.end[0] - move.centre[0], move.end[1] - move.centre[1])
    off = abs(last - move.radius)
    if move.radius == 0 or (off > MISMATCH[0] and off > MISMATCH[1] * move.radius):
        yield NCFault("nc.radius", move.line, {"start": f"{move.radius:.4f}", "end": f"{last:.4f}"})
