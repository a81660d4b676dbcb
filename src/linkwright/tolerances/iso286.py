"""ISO 286-1:2010, ISO code system for tolerances on linear sizes: tables 1 to 5.

Sizes are in mm, deviations in micrometres, as printed. Where the standard has no value for a letter, a grade or a size,
there is none here: nothing is extrapolated.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from typing import NamedTuple, Self

from linkwright.tolerances.classes import Limits, NoTolerance, ToleranceClass, register

LARGEST = 3150.0
GRADES = ("01", *(str(grade) for grade in range(19)))
"""IT01, IT0, IT1 ... IT18."""

# Table 1: the sizes, up to and including; of each grade the standard tolerance.
SIZES = (3, 6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400, 500, 630, 800, 1000, 1250, 1600, 2000, 2500, 3150)
_IT = """
01  0.3 0.4 0.4 0.5 0.6 0.6 0.8 1 1.2 2 2.5 3 4
0   0.5 0.6 0.6 0.8 1 1 1.2 1.5 2 3 4 5 6
1   0.8 1 1 1.2 1.5 1.5 2 2.5 3.5 4.5 6 7 8                       9 10 11 13 15 18 22 26
2   1.2 1.5 1.5 2 2.5 2.5 3 4 5 7 8 9 10                          11 13 15 18 21 25 30 36
3   2 2.5 2.5 3 4 4 5 6 8 10 12 13 15                             16 18 21 24 29 35 41 50
4   3 4 4 5 6 7 8 10 12 14 16 18 20                               22 25 28 33 39 46 55 68
5   4 5 6 8 9 11 13 15 18 20 23 25 27                             32 36 40 47 55 65 78 96
6   6 8 9 11 13 16 19 22 25 29 32 36 40                           44 50 56 66 78 92 110 135
7   10 12 15 18 21 25 30 35 40 46 52 57 63                        70 80 90 105 125 150 175 210
8   14 18 22 27 33 39 46 54 63 72 81 89 97                        110 125 140 165 195 230 280 330
9   25 30 36 43 52 62 74 87 100 115 130 140 155                   175 200 230 260 310 370 440 540
10  40 48 58 70 84 100 120 140 160 185 210 230 250                280 320 360 420 500 600 700 860
11  60 75 90 110 130 160 190 220 250 290 320 360 400              440 500 560 660 780 920 1100 1350
12  100 120 150 180 210 250 300 350 400 460 520 570 630           700 800 900 1050 1250 1500 1750 2100
13  140 180 220 270 330 390 460 540 630 720 810 890 970           1100 1250 1400 1650 1950 2300 2800 3300
14  250 300 360 430 520 620 740 870 1000 1150 1300 1400 1550      1750 2000 2300 2600 3100 3700 4400 5400
15  400 480 580 700 840 1000 1200 1400 1600 1850 2100 2300 2500   2800 3200 3600 4200 5000 6000 7000 8600
16  600 750 900 1100 1300 1600 1900 2200 2500 2900 3200 3600 4000 4400 5000 5600 6600 7800 9200 11000 13500
17  1000 1200 1500 1800 2100 2500 3000 3500 4000 4600 5200 5700 6300 7000 8000 9000 10500 12500 15000 17500 21000
18  1400 1800 2200 2700 3300 3900 4600 5400 6300 7200 8100 8900 9700 11000 12500 14000 16500 19500 23000 28000 33000
"""

# Tables 4 and 5 (shafts): the fundamental deviations, of a to g of the upper limit (es, all negative), of m to zc of
# the lower one (ei).
# Those that change with the main sizes of table 1 only:
_BY_MAIN_SIZE = """
cd  34 46 56
d   20 30 40 50 65 80 100 120 145 170 190 210 230   260 290 320 350 390 430 480 520
e   14 20 25 32 40 50 60 72 85 100 110 125 135      145 160 170 195 220 240 260 290
ef  10 14 18
f   6 10 13 16 20 25 30 36 43 50 56 62 68           76 80 86 98 110 120 130 145
fg  4 6 8
g   2 4 5 6 7 9 10 12 14 15 17 18 20                22 24 26 28 30 32 34 38
m   2 4 6 7 8 9 11 13 15 17 20 21 23                26 30 34 40 48 58 68 76
n   4 8 10 12 15 17 20 23 27 31 34 37 40            44 50 56 66 78 92 110 135
p   6 12 15 18 22 26 32 37 43 50 56 62 68           78 88 100 120 140 170 195 240
"""
# Those that change within them too:
STEPS = (
    3, 6, 10, 14, 18, 24, 30, 40, 50, 65, 80, 100, 120, 140, 160, 180, 200, 225, 250, 280, 315, 355, 400, 450, 500,
    560, 630, 710, 800, 900, 1000, 1120, 1250, 1400, 1600, 1800, 2000, 2240, 2500, 2800, 3150,
)  # fmt: skip
_BY_STEP = """
a  270 270 280 290 290 300 300 310 320 340 360 380 410 460 520 580 660 740 820 920 1050 1200 1350 1500 1650
b  140 140 150 150 150 160 160 170 180 190 200 220 240 260 280 310 340 380 420 480 540 600 680 760 840
c  60 70 80 95 95 110 110 120 130 140 150 170 180 200 210 230 240 260 280 300 330 360 400 440 480
r  10 15 19 23 23 28 28 34 34 41 43 51 54 63 65 68 77 80 84 94 98 108 114 126 132
   150 155 175 185 210 220 250 260 300 330 370 400 440 460 550 580
s  14 19 23 28 28 35 35 43 43 53 59 71 79 92 100 108 122 130 140 158 170 190 208 232 252
   280 310 340 380 430 470 520 580 640 720 820 920 1000 1100 1250 1400
t  - - - - - - 41 48 54 66 75 91 104 122 134 146 166 180 196 218 240 268 294 330 360
   400 450 500 560 620 680 780 840 960 1050 1200 1350 1500 1650 1900 2100
u  18 23 28 33 33 41 48 60 70 87 102 124 144 170 190 210 236 258 284 315 350 390 435 490 540
   600 660 740 840 940 1050 1150 1300 1450 1600 1850 2000 2300 2500 2900 3200
v  - - - - 39 47 55 68 81 102 120 146 172 202 228 252 284 310 340 385 425 475 530 595 660
x  20 28 34 40 45 54 64 80 97 122 146 178 210 248 280 310 350 385 425 475 525 590 660 740 820
y  - - - - - 63 75 94 114 144 174 214 254 300 340 380 425 470 520 580 650 730 820 920 1000
z  26 35 42 50 60 73 88 112 136 172 210 258 310 365 415 465 520 575 640 710 790 900 1000 1100 1250
za 32 42 52 64 77 98 118 148 180 226 274 335 400 470 535 600 670 740 820 920 1000 1150 1300 1450 1600
zb 40 50 67 90 108 136 160 200 242 300 360 445 525 620 700 780 880 960 1050 1200 1300 1500 1650 1850 2100
zc 60 80 97 130 150 188 218 274 325 405 480 585 690 800 900 1000 1150 1250 1350 1550 1700 1900 2100 2400 2600
"""
# k (ei) of IT4 to IT7; of other grades, and above 500 mm, 0. j: ei of shafts; ES of holes, in the last three rows.
_K = (0, 1, 1, 1, 2, 2, 2, 3, 3, 4, 4, 4, 5)
_J = """
j5  -2 -2 -2 -3 -4 -5 -7 -9 -11 -13 -16 -18 -20
j6  -2 -2 -2 -3 -4 -5 -7 -9 -11 -13 -16 -18 -20
j7  -4 -4 -5 -6 -8 -10 -12 -15 -18 -21 -26 -28 -32
j8  -6
J6  2 5 5 6 8 10 13 16 18 22 25 29 33
J7  4 6 8 10 12 14 18 22 26 30 36 39 43
J8  6 10 12 15 20 24 28 34 41 47 55 60 66
"""


def _rows(text: str) -> dict[str, tuple[float | None, ...]]:
    """A table by the first word of its rows; a row goes on where a line starts with a blank."""
    words = re.split(r"\n(?=\S)", text.strip())
    return {row.split()[0]: tuple(None if word == "-" else float(word) for word in row.split()[1:]) for row in words}


IT, MAIN, STEPPED, J = _rows(_IT), _rows(_BY_MAIN_SIZE), _rows(_BY_STEP), _rows(_J)
BELOW = ("a", "b", "c", "cd", "d", "e", "ef", "f", "fg", "g", "h")
"""The letters whose tolerance zone lies below the nominal size of a shaft (above that of a hole)."""
ABOVE = ("m", "n", "p", "r", "s", "t", "u", "v", "x", "y", "z", "za", "zb", "zc")
LETTERS = (*BELOW, "js", "j", "k", *ABOVE)
_LEAST = 3
"""The finest grade of all letters but h and js: special rules (table 3) start there."""


class Size(NamedTuple):
    """A nominal size in mm, with its places in the main sizes and their steps."""

    mm: float
    main: int
    step: int


def _size(size: float) -> Size:
    """Of a size in m. Raises NoTolerance."""
    mm = round(size * 1e3, 9)
    if not 0 < mm <= LARGEST:
        raise NoTolerance("size", low=0.0, high=LARGEST * 1e-3)
    return Size(mm, bisect_left(SIZES, mm), bisect_left(STEPS, mm))


@register
class Standard(ToleranceClass):
    """A standard tolerance, symmetric about the nominal size: ``IT8`` is half of it up and half of it down, as js8."""

    standard = "ISO 286-1, IT"
    examples = ("IT8",)

    def __init__(self, grade: str) -> None:
        self.grade, self.text = grade, f"IT{grade}"

    @classmethod
    def read(cls, text: str) -> Self | None:
        match = re.fullmatch(r"\s*(?:ISO\s*286(?:-1)?\s+)?IT(\d\d?)\s*", text)
        return cls(match[1]) if match and match[1] in GRADES else None

    def limits(self, size: float) -> Limits:
        half = self.tolerance(_size(size)) / 2
        return -half * 1e-6, half * 1e-6

    def tolerance(self, size: Size) -> float:
        """The standard tolerance, in micrometres. Raises NoTolerance."""
        row = IT[self.grade]
        coarse = self.grade not in ("01", "0") and int(self.grade) >= 14
        if size.main >= len(row) or (coarse and size.mm <= 1):
            raise NoTolerance("size", low=1e-3 if coarse else 0.0, high=SIZES[len(row) - 1] * 1e-3)
        value = row[size.main]
        assert value is not None
        return value


@register
class FitClass(ToleranceClass):
    """The tolerance class of a hole or a shaft: ``H7``, ``h7``, ``js9``."""

    standard = "ISO 286-1"
    examples = ("h7", "H7", "js9")

    def __init__(self, letter: str, grade: str) -> None:
        self.letter, self.it = letter.lower(), Standard(grade)
        self.hole, self.text = letter.isupper(), f"{letter}{grade}"

    @classmethod
    def read(cls, text: str) -> Self | None:
        match = re.fullmatch(r"\s*(?:ISO\s*286(?:-[12])?\s+)?([A-Z]{1,2}|[a-z]{1,2})(\d\d?)\s*", text)
        if match is None or match[1].lower() not in LETTERS or match[2] not in GRADES:
            return None
        letter, grade = match.groups()
        any_grade = letter.lower() in ("h", "js") or (grade != "01" and int(grade) >= _LEAST)
        listed = letter.lower() != "j" or letter + grade in J
        return cls(letter, grade) if any_grade and listed else None

    def limits(self, size: float) -> Limits:
        at = _size(size)
        tolerance = self.it.tolerance(at)
        if self.letter == "js":
            low = -tolerance / 2
        elif self.letter == "j":
            low = self._tabled(J[f"{'J' if self.hole else 'j'}{self.it.grade}"], at.main)
            low -= tolerance if self.hole else 0
        elif self.letter in BELOW:
            gap = self._deviation(at)
            low = gap if self.hole else -gap - tolerance
        else:
            low = self._hole(at) - tolerance if self.hole else self._deviation(at)
        return low * 1e-6, (low + tolerance) * 1e-6

    def _deviation(self, at: Size) -> float:
        """The size of the shaft's fundamental deviation (tables 4 and 5), in micrometres."""
        if self.letter in ("a", "b") and at.mm <= 1:
            raise NoTolerance("size", low=1e-3, high=0.5)
        if self.letter == "h":
            return 0.0
        if self.letter == "k":
            return float(_K[at.main]) if 4 <= int(self.it.grade) <= 7 and at.main < len(_K) else 0.0
        stepped = self.letter in STEPPED
        row = STEPPED[self.letter] if stepped else MAIN[self.letter]
        return self._tabled(row, at.step if stepped else at.main)

    def _hole(self, at: Size) -> float:
        """The upper limit deviation of holes K to ZC (tables 2 and 3), in micrometres.

        The special rule: a hole of grade n and a shaft of grade n - 1 fit as their opposites do, so the difference
        Delta of the two standard tolerances is added, for K, M, N to IT8 and for P to ZC to IT7, over 3 to 500 mm.
        """
        grade, middle = int(self.it.grade), self.letter in ("k", "m", "n")
        fine = grade <= (8 if middle else 7)
        if middle and not fine:
            if at.mm > 500 or (self.letter == "k" and at.mm > 3) or (self.letter == "n" and at.mm <= 1):
                raise NoTolerance(
                    "size", low=1e-3 if self.letter == "n" else 0.0, high=3e-3 if self.letter == "k" else 0.5
                )
            if self.letter == "n" and at.mm > 3:
                return 0.0
        if self.text == "M6" and 250 < at.mm <= 315:
            return -9.0
        delta = 0.0
        if fine and 3 < at.mm <= 500:
            delta = self.it.tolerance(at) - Standard(str(grade - 1)).tolerance(at)
        base = float(_K[at.main] if at.mm <= 500 else 0) if self.letter == "k" else self._deviation(at)
        return -base + delta

    def _tabled(self, row: tuple[float | None, ...], place: int) -> float:
        value = row[place] if place < len(row) else None
        if value is None:
            ends = (0, *(STEPS if self.letter in STEPPED else SIZES))
            kept = [i for i, entry in enumerate(row) if entry is not None]
            raise NoTolerance("size", low=ends[kept[0]] * 1e-3, high=ends[kept[-1] + 1] * 1e-3)
        return value
