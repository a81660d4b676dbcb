"""Expressions in the spellings of other places: what is meant is proposed, and can be read."""

from __future__ import annotations

import pytest

from linkwright.expressions.language import ExpressionError, parse
from linkwright.expressions.respelled import respelled, unit_respelled

SPELLINGS = {
    "190,5": "190.5",
    "60,5 rpm": "60.5 rpm",
    "AB+1,5*CD": "AB+1.5*CD",
    "1.000,5": "1000.5",
    "1'900.5": "1900.5",
    "1'900": "1900",
    "1 900,5 mm": "1900.5 mm",
    "2AB": "2*AB",
    "2,5AB": "2.5*AB",
    "3(AB+1)": "3*(AB+1)",
    "(AB+1)(BC)": "(AB+1)*(BC)",
    "max(1,5)*2AB": "max(1,5)*2*AB",
    "45 1/min": "45 rpm",
    "451/min": "451 rpm",
    "45 min^-1": "45 rpm",
    "45 min⁻¹": "45 rpm",
    "45 U/min": "45 rpm",
    "45 RPM": "45 rpm",
    "45转/分": "45 rpm",
    "2 rps": "2 r/s",
    "60 deg/sec": "60 deg/s",
    "60 millimeters": "60 mm",
    "60毫米": "60 mm",
    "30度": "30 deg",
    "9.81 m/s2": "9.81 m/s^2",
    "5 N.m": "5 N*m",
    "（AB＋CD）": "(AB+CD)",
    "１９０": "190",
    "CD÷2": "CD/2",
    "√(AB)": "sqrt(AB)",
    "AB*π": "AB*pi",
    "=AB*2": "AB*2",
    "190;": "190",
    "190 // coupler": "190",
    "±0.1": "0.1",
    "$AB*2": "AB*2",
    "{AB} + 1": "AB + 1",
    "190 x 2": "190*2",
    "|C.vx|": "abs(C.vx)",
    "motor torque": "motor.torque",
    "0.4kgs": "0.4 kg",
    "120 mmm": "120 mm",
    "2rod": "2*rod",
    "2arm": "2*arm",
    "60 rpm clockwise": "-60 rpm",
    "clockwise 60 rpm": "-60 rpm",
    "60 rpm (ccw)": "60 rpm",
    "60转/分 顺时针": "-60 rpm",
    "每秒2转": "2 r/s",
    "9.8 m·s⁻²": "9.8 m/s^2",
    "6 rad*s^-1": "6 rad/s",
    "2pi rad/s": "2*pi*(1 rad/s)",
    "√900": "sqrt(900)",
    "-30°15'": "-(30 deg + 15 arcmin)",
    "30º": "30°",
    "30 ㎟": "30 mm^2",
    "0.2 千克平方米": "0.2 kg*m^2",
    "9.8 米/秒2": "9.8 m/s^2",
    "3 牛每毫米": "3 N/mm",
    "5 N-m": "5 N*m",
    "5 N m": "5 N*m",
    "5 公斤/平方厘米": "5 kgf/cm^2",
    "10 马力": "10*735.5 W",
    "曲柄的angle": "曲柄.angle",
    "AB = 2*CD": "2*CD",
}


@pytest.mark.parametrize("text", SPELLINGS)
def test_what_is_meant(text: str) -> None:
    found = respelled(text)
    assert found is not None and str(found[1]) == f"Write '{SPELLINGS[text]}'."
    parse(SPELLINGS[text])


@pytest.mark.parametrize(
    "text",
    [
        "",
        "AB CD",
        "about 190",
        "190..200",
        "7 1/2 in",
        "190 m m",
        "2 +",
        "(AB",
        "f(1,5",
        "190 ± x y",
        "a" * 50 + "(" * 50,
        "1/2 AB CD",
    ],
)
def test_what_has_no_sound_spelling(text: str) -> None:
    assert respelled(text) is None
    with pytest.raises(ExpressionError):
        parse(text)


def test_a_comma_before_three_digits_may_be_either() -> None:
    found = respelled("1,900 mm")
    assert found is not None
    assert str(found[1]) == "Write '1.900 mm', or '1900 mm' if the comma separates thousands."


@pytest.mark.parametrize(
    ("text", "choice"),
    [
        ("30′", ("30 arcmin", "30 ft")),
        ('20"', ("20 arcsec", "20 in")),
        ("30～32 mm", ("30", "32 mm")),
        ("3(曲柄长)", ("3*(曲柄长)", "3  # 曲柄长")),
    ],
)
def test_what_may_be_meant_in_two_ways(text: str, choice: tuple[str, str]) -> None:
    found = respelled(text)
    assert found is not None and str(found[1]) == f"Write '{choice[0]}' or '{choice[1]}', whichever is meant."


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        ("φ30", "Write '30'."),
        ("⌀12 mm", "Write '12 mm'."),
        ("φ30H7", "Write '{value: 30, tolerance: H7}'."),
        ("φ30±0.02", "Write '{value: 30, tolerance: 0.02}'."),
        ("60 mm（中心距）", "Write '60 mm  # 中心距'."),
    ],
)
def test_a_dimension_of_a_drawing(text: str, hint: str) -> None:
    found = respelled(text)
    assert found is not None and str(found[1]) == hint


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("毫米", "mm"), ("牛·米", "N*m"), ("牛米", "N*m"), ("N·m", "N*m"), ("N×m", "N*m"), ("N.m", "N*m"),
        ("mm2", "mm^2"), ("公斤力·米", "kgf*m"), ("毫米每秒", "mm/s"), ("foo", None), ("", None), ("2", None),
    ],
)  # fmt: skip
def test_a_unit_alone(text: str, meant: str | None) -> None:
    assert unit_respelled(text) == meant


def test_a_parameter_may_have_the_name_of_a_sign() -> None:
    assert respelled("φ30", ["φ30"]) is None


def test_a_tolerance_beside_its_value() -> None:
    found = respelled("190 ± 0.1")
    assert found is not None and str(found[1]) == "Write '{value: 190, tolerance: 0.1}'."


def test_names_that_are_known_stay() -> None:
    assert respelled("60 deg/sec", ["sec"]) is None
    assert respelled("2*sec", ["sec"]) is None
