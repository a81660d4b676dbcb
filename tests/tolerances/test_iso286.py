"""ISO 286-1: its tables against the formulas that they were made by, and what it has no value for.

The formulas are those of ISO 286-1:1988, annex A, and of Machine Drawing (Narayana, Kannaiah, Venkata Reddy), table
15.4; D is the geometric mean of a range (mm). The printed values are rounded by rules with exceptions, so the tables
are held to the formulas by the width of that rounding; tests/validation/test_limits_and_fits.py holds them to print.
"""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

from linkwright.tolerances import NoTolerance, tolerance_class
from linkwright.tolerances.iso286 import ABOVE, BELOW, IT, LETTERS, MAIN, SIZES, STEPPED, STEPS


def limits(text: str, mm: float) -> tuple[float, float]:
    """Of a class, in micrometres."""
    found = tolerance_class(text)
    assert found is not None
    low, high = found.limits(mm * 1e-3)
    return round(low * 1e6, 6), round(high * 1e6, 6)


def has(text: str, mm: float) -> bool:
    try:
        limits(text, mm)
    except NoTolerance:
        return False
    return True


def mean(ends: tuple[int, ...], i: int) -> float:
    return math.sqrt((ends[i - 1] if i else 1) * ends[i])


def standard(grade: int, i: int) -> float:
    """The standard tolerance by its formula, unrounded."""
    d = mean(SIZES, i)
    unit = 0.45 * d ** (1 / 3) + 0.001 * d if d < 500 else 0.004 * d + 2.1
    if grade >= 5:
        return (7, 10, 16, 25, 40, 64, 100, 160, 250, 400, 640, 1000, 1600, 2500)[grade - 5] * unit
    first, fifth = (0.8 + 0.02 * d, 7 * unit) if d < 500 else (2 * unit, 7 * unit)
    return first * (fifth / first) ** ((grade - 1) / 4)


@pytest.mark.parametrize("grade", range(1, 19))
def test_standard_tolerances_follow_their_formula(grade: int) -> None:
    row = IT[str(grade)]
    assert len(row) == 21
    for i, value in enumerate(row):
        # The rules round up to 10 mm, and the finest grades throughout, to few values; else to 1/20 or less.
        rel = 0.215 if grade < 5 else 0.16 if SIZES[i] <= 10 else 0.06
        assert value == pytest.approx(standard(grade, i), rel=rel), SIZES[i]


DEVIATION = {
    "a": lambda d, it: 265 + 1.3 * d if d <= 120 else 3.5 * d,
    "b": lambda d, it: 140 + 0.85 * d if d <= 160 else 1.8 * d,
    "c": lambda d, it: 52 * d**0.2 if d <= 40 else 95 + 0.8 * d,
    "d": lambda d, it: 16 * d**0.44,
    "e": lambda d, it: 11 * d**0.41,
    "f": lambda d, it: 5.5 * d**0.41,
    "g": lambda d, it: 2.5 * d**0.34,
    "m": lambda d, it: it(7) - it(6) if d <= 500 else 0.024 * d + 12.6,
    "n": lambda d, it: 5 * d**0.34 if d <= 500 else 0.04 * d + 21,
    "p": lambda d, it: it(7) + 2.5 if d <= 500 else 0.072 * d + 37.8,
    "s": lambda d, it: it(8) + 2.5 if d <= 50 else it(7) + 0.4 * d,
    "t": lambda d, it: it(7) + 0.63 * d,
    "u": lambda d, it: it(7) + d,
    "v": lambda d, it: it(7) + 1.25 * d,
    "x": lambda d, it: it(7) + 1.6 * d,
    "y": lambda d, it: it(7) + 2 * d,
    "z": lambda d, it: it(7) + 2.5 * d,
    "za": lambda d, it: it(8) + 3.15 * d,
    "zb": lambda d, it: it(9) + 4 * d,
    "zc": lambda d, it: it(10) + 5 * d,
}


@pytest.mark.parametrize("letter", DEVIATION)
def test_fundamental_deviations_follow_their_formulas(letter: str) -> None:
    """To 1.5 um or 6 %, which is how the standard rounds; below 18 mm (of c 40 mm) the printed values leave the
    formulas."""
    ends, row = (STEPS, STEPPED[letter]) if letter in STEPPED else (SIZES, MAIN[letter])
    for i, value in enumerate(row):
        if value is None or ends[i] <= (40 if letter == "c" else 18):
            continue
        d = mean(ends, i)
        main = next(k for k, end in enumerate(SIZES) if d <= end)
        it = {grade: IT[str(grade)][main] for grade in range(6, 11)}
        assert value == pytest.approx(DEVIATION[letter](d, it.get), rel=0.06, abs=1.6 if letter != "t" else 3.2), ends[
            i
        ]


def test_r_lies_between_p_and_s_and_the_paired_letters_in_the_middle() -> None:
    for i, r in enumerate(STEPPED["r"]):
        p = MAIN["p"][next(k for k, end in enumerate(SIZES) if STEPS[i] <= end)]
        assert r == pytest.approx(math.sqrt(p * STEPPED["s"][i]), rel=0.041, abs=0.9)  # type: ignore[operator]
    sides = {**MAIN, "c": tuple(STEPPED["c"][:3])}
    for pair, (a, b) in {"cd": ("c", "d"), "ef": ("e", "f"), "fg": ("f", "g")}.items():
        for i, value in enumerate(MAIN[pair]):
            assert value == pytest.approx(math.sqrt(sides[a][i] * sides[b][i]), abs=0.9)  # type: ignore[operator]


ALL_SIZES = sorted({*STEPS, *SIZES, 0.5, 1.5, *(end + 0.1 for end in STEPS[:-1])})


@pytest.mark.parametrize("letter", [letter for letter in LETTERS if letter != "j"])
def test_holes_mirror_shafts_but_for_the_special_rule(letter: str) -> None:
    """ES = -ei by the general rule; by the special one a hole of grade n fits the shaft as the shaft of n - 1 a hole:
    H7/p6 and P7/h6 have the same clearances."""
    for mm in ALL_SIZES:
        for grade in (6, 7, 8, 9, 11):
            hole, shaft = f"{letter.upper()}{grade}", f"{letter}{grade}"
            special = (
                letter not in (*BELOW, "js") and 3 < mm <= 500 and grade <= (8 if letter in ("k", "m", "n") else 7)
            )
            if (letter in ("k", "n") and grade > 8) or not has(hole, mm) or (hole == "M6" and 250 < mm <= 315):
                continue
            if not special:
                assert limits(hole, mm) == tuple(-end or 0.0 for end in reversed(limits(shaft, mm)))
            else:
                (low, high), (hole_low, hole_high) = limits(f"{letter}{grade - 1}", mm), limits(f"H{grade}", mm)
                mirrored, basis = limits(hole, mm), limits(f"h{grade - 1}", mm)
                assert (mirrored[0] - basis[1], mirrored[1] - basis[0]) == (hole_low - high, hole_high - low)


@pytest.mark.parametrize("letter", [*LETTERS, *(letter.upper() for letter in LETTERS)])
def test_zones_grow_with_size_and_grade(letter: str) -> None:
    grades = (5, 6, 7) if letter == "j" else (6, 7, 8) if letter == "J" else range(3, 17)
    known = [[mm for mm in ALL_SIZES if has(f"{letter}{grade}", mm)] for grade in grades]
    assert any(known)
    for grade, sizes in zip(grades, known, strict=True):
        zones = [limits(f"{letter}{grade}", mm) for mm in sizes]
        widths = [high - low for low, high in zones]
        assert widths == sorted(widths)
        if letter.lower() in BELOW:
            nearest = [low if letter.isupper() else -high for low, high in zones]
            assert nearest == sorted(nearest)
    for finer, coarser in pairwise(grades):
        for mm in (20, 300, 480):
            if has(f"{letter}{finer}", mm) and has(f"{letter}{coarser}", mm):
                fine, coarse = limits(f"{letter}{finer}", mm), limits(f"{letter}{coarser}", mm)
                assert fine[1] - fine[0] < coarse[1] - coarse[0]


def test_stronger_letters_fit_tighter() -> None:
    for mm in (2, 5, 9, 17, 28, 45, 75, 110, 150, 190, 260, 350, 450, 600, 1100, 3000):
        order = [limits(f"{letter}7", mm)[0] for letter in (*BELOW, "js", "k", *ABOVE) if has(f"{letter}7", mm)]
        assert order == sorted(order), mm
        assert len(order) > 10


def test_ends_of_ranges_belong_to_the_lower_range() -> None:
    assert limits("h7", 30) == (-21, 0)
    assert limits("h7", 30.001) == (-25, 0)
    assert limits("h7", 0.1 + 29.9) == (-21, 0)  # a sum that misses 30 by round-off


@pytest.mark.parametrize(
    ("text", "mm"),
    [
        ("h7", 0), ("h7", 3150.1), ("IT0", 501), ("IT14", 1), ("js16", 0.9), ("a11", 0.9), ("B9", 501), ("cd7", 10.1),
        ("EF7", 11), ("t7", 24), ("v7", 14), ("Y7", 18), ("x7", 501), ("K9", 3.1), ("K9", 600), ("M9", 501),
        ("N9", 1), ("N9", 600), ("j6", 501), ("J7", 501), ("j8", 3.1),
    ],
)  # fmt: skip
def test_what_the_standard_leaves_open_is_refused(text: str, mm: float) -> None:
    with pytest.raises(NoTolerance) as caught:
        limits(text, mm)
    low, high = caught.value.data["low"] * 1e3, caught.value.data["high"] * 1e3
    assert not low < mm <= high
    inside = high if text != "h7" else 100
    assert has(text, inside)


@pytest.mark.parametrize(
    "text",
    [
        "i7",
        "l7",
        "o7",
        "q7",
        "w7",
        "h19",
        "h",
        "7h",
        "hH7",
        "t1",
        "a2",
        "j9",
        "J5",
        "IT19",
        "IT1.5",
        "H 7",
        "h7/H8",
        "",
    ],
)
def test_other_texts_name_no_class(text: str) -> None:
    assert tolerance_class(text) is None


def test_the_standard_may_be_named_too() -> None:
    assert limits("ISO 286 h7", 25) == limits(" h7 ", 25) == limits("ISO 286-2 h7", 25)
    assert limits("js9", 25) == limits("IT9", 25) == limits("ISO 286 IT9", 25)
