"""What stands in the cells of tables: texts, numbers with their units, verdicts."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import isfinite

from linkwright.data_classes import dataclass
from linkwright.escape import printed
from linkwright.findings import Said, Text

UNKNOWN = "–"
"""What stands for a number that there isn't."""


@dataclass(frozen=True)
class NumberCell:
    """A number with so many significant ``digits``, or as ``form`` says (decimals where it is ``f``), in ``unit`` where
    that stands beside it; ``signed``, with its sign where it is positive too; ``unknown`` stands for one that there
    isn't."""

    value: float | None
    digits: int = 7
    unit: str = ""
    unknown: Text = UNKNOWN
    form: str = "g"
    signed: bool = False

    def __str__(self) -> str:
        if self.value is None or not isfinite(self.value):
            return str(self.unknown)
        sign = "+" if self.signed and self.value > 0 else ""
        value = self.value + 0.0  # -0 reads oddly
        return f"{sign}{value:.{self.digits}{self.form}} {printed(self.unit)}".rstrip()


def percent(share: float | None, digits: int = 4) -> NumberCell:
    """A share in percent."""
    return NumberCell(None if share is None else float(f"{100 * share:.{digits}g}"), 10, "%")  # rounded first: no 1e+02


@dataclass(frozen=True)
class Numbers:
    """Numbers of one ``unit``, such as the ends of a range; signed ones that are opposite as ±; ``unknown`` stands for
    none."""

    numbers: Sequence[NumberCell]
    unit: str = ""
    apart: str = " .. "
    unknown: Text = UNKNOWN

    def __str__(self) -> str:
        texts, values = [str(one) for one in self.numbers], [one.value for one in self.numbers]
        if all(value is None for value in values):
            return self.apart.join(texts) or str(self.unknown)
        match texts, values:
            case [low, high], [float(a), float(b)] if self.numbers[1].signed and a <= 0 <= b:
                sizes = [low.lstrip("+-"), high.lstrip("+-")]
                texts = [f"±{sizes[1]}"] if sizes[0] == sizes[1] else texts
        return f"{self.apart.join(texts)} {printed(self.unit)}".rstrip()


def numbers(values: Iterable[float | None], digits: int = 7, unit: str = "", apart: str = " .. ") -> Numbers:
    """Numbers with so many significant digits."""
    return Numbers([NumberCell(value, digits) for value in values], unit, apart)


class Unit(Said):
    """A unit as files spell it (``N*m``, ``mm/s^2``); a terminal and a page show it in print (N·m, mm/s²)."""

    def __str__(self) -> str:
        return printed(self.key)


@dataclass(frozen=True)
class Verdict:
    """Whether something is as it should be, in a word."""

    passed: bool
    text: Text

    def __str__(self) -> str:
        return str(self.text)


Cell = Text | NumberCell | Numbers | Verdict
