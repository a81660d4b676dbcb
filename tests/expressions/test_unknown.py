"""Names that nothing is called by: which ones are meant."""

from __future__ import annotations

import pytest

from linkwright.expressions.synonyms import meant
from linkwright.expressions.unknown import likeliest, near

LINKS = ["frame", "crank", "rod", "rocker"]
DRIVE = ["turns", "slides", "extends", "on", "speed", "start", "acceleration", "position", "output"]


@pytest.mark.parametrize(
    ("name", "known", "likely"),
    [
        ("crnk", LINKS, ["crank"]),
        ("Crank", LINKS, ["crank"]),
        ("ｃｒａｎｋ", LINKS, ["crank"]),
        ("ground", LINKS, ["frame"]),
        ("base_plate", LINKS, ["frame"]),
        ("机架", LINKS, ["frame"]),
        ("roker", LINKS, ["rocker"]),
        ("lever", LINKS, []),
        ("omega", DRIVE, ["speed"]),
        ("rotates", DRIVE, ["turns"]),
        ("accel", DRIVE, ["acceleration"]),
        ("lenght", ["length", "angle"], ["length"]),
        ("maximum", ["max", "min"], ["max"]),
        ("four_bar", ["four-bar"], ["four-bar"]),
        ("BB", ["A", "B"], ["B"]),
        ("C", ["AB", "CD"], []),
        ("x", [], []),
    ],
)
def test_the_likeliest(name: str, known: list[str], likely: list[str]) -> None:
    assert likeliest(name, known) == likely


def test_a_sentence_on_what_may_be_meant() -> None:
    assert str(near("abc", ["abd", "zzz"])) == "Did you mean 'abd'?"
    assert str(near("abcd", ["abcx", "abcy"])) == "Did you mean one of these: abcx, abcy?"
    assert str(near("q" * 5000, ["a"])) == "Write one of these: a."
    assert "none" in str(near("x", []))
    assert len(near("zzzz", [f"name{i}" for i in range(500)]).data["names"].data["parts"]) == 24


def test_words_from_elsewhere() -> None:
    assert meant("Hinge") == ["revolute"] and meant("free length") == ["free"] and meant("feed") == []
