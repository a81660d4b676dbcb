"""Lists, clauses and alternatives have the separators of the language in which they are shown."""

from __future__ import annotations

import pickle

import pytest

from linkwright.findings import CLAUSES, SENTENCES, Finding, Joined, Said, Term, alternatives, enumerated
from linkwright.words import in_language


@pytest.mark.parametrize(
    ("text", "english", "chinese"),
    [
        (Joined(["crank", "rocker"]), "crank, rocker", "crank、rocker"),
        (Joined([Said("limits.none"), 2]), "none, 2", "无、2"),
        (Joined(["C: open", "D: open"], CLAUSES), "C: open; D: open", "C: open；D: open"),
        (
            Joined([Said("limits.full_turn")] * 2, SENTENCES),
            "Full rotation. Full rotation.",
            "可整周转动。可整周转动。",
        ),
        (Joined(["a\nb", "c"]), "a b, c", "a b、c"),
        (enumerated(["a", "b", "c"]), "a, b and c", "a、b 和 c"),
        (alternatives(["a", "b", "c"]), "'a', 'b' or 'c'", "“a”、“b”或“c”"),
        (alternatives(["a"]), "'a'", "“a”"),
        (Term("colon", first="x", then="y"), "x: y", "x：y"),
        (Term("with-unit", name="x", unit="mm"), "x, mm", "x（mm）"),
    ],
)
def test_separators_are_those_of_the_language(text: Said, english: str, chinese: str) -> None:
    assert str(text) == english
    with in_language("zh"):
        assert str(text) == chinese == str(pickle.loads(pickle.dumps(text)))


def test_a_list_without_names_is_false() -> None:
    assert not Joined([]) and Joined(["a"])
    assert (Joined(iter("ab")).parts, str(Joined([]))) == (("a", "b"), "")


def test_lists_are_equal_by_their_parts() -> None:
    assert Joined(["a", "b"]) == Joined(("a", "b")) != Joined(["a"])
    assert Joined(["a"]) != Joined(["a"], CLAUSES)
    assert len({Joined(["a"]), Joined(["a"]), Joined(["b"])}) == 2
    assert repr(Joined(["a"])) != repr(Joined(["b"]))  # faults are told apart by it


def test_a_problem_as_text_is_of_its_language() -> None:
    problem = Finding("mass.incomplete", ("links", "a"), {"missing": Joined(["com", "inertia"])}, line=3)
    assert str(problem).startswith("line 3: links.a: ") and "com, inertia" in str(problem)
    with in_language("zh"):
        assert str(problem).startswith("第 3 行：links.a：") and "com、inertia" in str(problem)
