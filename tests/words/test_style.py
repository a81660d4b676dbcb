"""Texts use the terms of the field: none of them has a word of its own for what mechanical engineers have a name for.

Texts of findings are looked at in a file of their own.
"""

from __future__ import annotations

import re

from helpers.offenders import nobody_breaks
from words.test_findings import OTHERS, WORDS

TEXTS = {key: WORDS[key] for key in OTHERS}

BETTER = {
    r"rests?": "residual, or excess material",
    r"miss(?:es)?": "error",
    r"mend(?:s|ed)?": "suggested fix",
    r"findings?": "problem",
    r"least|greatest": "minimum, maximum",
    r"(?:off|apart) by|is off": "deviation, error",
    r"strays?": "deviates",
    r"to blame": "contributes",
    r"play": "clearance",
    r"hollow": "concave",
    r"(?:not )?(?:kept|met)|NOT met|holds?": "passed, failed",
    r"told|tells?|told apart": "reported, identifiable",
    r"gets? to": "reaches, workspace",
    r"part(?:s|ed)? ways": "disagree",
    r"put together": "assembled",
    r"turns? (?:fully|all the way|round|over)": "rotates, reverses",
    r"dead points?": "dead centre",
    r"wanted|wished|asked for": "required, requested",
    r"the way of|goes one way": "path, direction",
    r"gone? on|goes on|begin anew": "resume, continue",
    r"take it out|taken out": "remove",
    r"made by": "made with",
    r"whatever they do|what is sure": "guaranteed",
    r"held against|against each other": "compared, relative to",
    r"too much work|too little work": "what it saves",
    r"freedoms?": "degree of freedom",
    r"slopes?": "sensitivity",
    r"foretell?|foretold": "predicted",
    r"insist|perform": "fail if, run",
}
"""What isn't written, as regular expressions of whole words, and what stands for it."""
RULES = [re.compile(rf"(?<![\w-])(?:{words})(?![\w-])", re.IGNORECASE) for words in BETTER]

ALLOWED = {
    "accuracy.failed": "least",  # at least one
    "fact.plane.fitted": "least",  # least squares
    "report.play": "Play",  # the button that begins the animation
    "report.plots_hint": "hold",  # the mechanism stays where it is
    "sheet.hand.text": "hold",  # the hand holds back
    "cli.outdated": "kept",  # files are
    "term.interrupted-kept": "kept",
}
"""Texts that may have a word in another sense."""

VERDICTS = {"cli.met", "cli.not_met", "report.pass", "report.fail", "report.holds", "report.violated", "cam.kept",
            "cam.not-kept", "cam.met", "cam.not-met"}  # fmt: skip


TYPED = re.compile(r"[A-Za-z}]\*[A-Za-z{]|\^\d")
"""A unit as files have it: texts have it in print."""


def slang(text: str) -> list[str]:
    """The words of a text that aren't the field's, in the order of the list."""
    plain = re.sub(r"{[^}]*}", "{}", text)
    found = (words.search(plain) for words in RULES)
    return [one[0] for one in (*found, TYPED.search(plain)) if one]


def test_texts_use_the_terms_of_the_field() -> None:
    nobody_breaks({key: [word for word in slang(text) if word != ALLOWED.get(key)] for key, text in TEXTS.items()})


def test_what_is_allowed_is_there() -> None:
    assert {key: [word] for key, word in ALLOWED.items()} == {key: slang(TEXTS[key]) for key in ALLOWED}


def test_requirements_checks_and_limits_have_one_word_for_each_verdict() -> None:
    assert {TEXTS[key].lower() for key in VERDICTS} == {"passed", "failed"}


def test_slang_is_found() -> None:
    assert slang("The worst miss; the rest in {rest}, N*m.") == ["rest", "miss", "N*m"]
    assert slang("Where P gets to, in mm^2: {count} regions.") == ["gets to", "^2"]
