"""Texts use the field's terms: words that a reader would have to translate are kept out."""

from __future__ import annotations

import re

from helpers.offenders import nobody_breaks
from words.test_findings import FINDINGS

BETTER = {
    # Verbs of programs and of fixes.
    r"mend(s|ed|ing)?": "fix",
    r"take \w+( \w+)? out|take (it|them) (out|off)": "remove",
    r"(leave|left) (\w+ ){0,3}out": "remove, omit",
    r"tells?|told|telling": "report, list, show",
    r"(goes|go|going|went) on": "continue, resume",
    r"begin anew|start anew|anew(?!=)|begun": "restart, started",
    r"puts?(ting)? together": "assemble",
    r"gets? to|gets? in": "reach",
    r"asks?( for)?|asked": "need, evaluate, require",
    r"looks? (into|at|for)": "check",
    r"it isn't said|nothing says|it isn't clear what": "... is missing, isn't defined",
    r"can't stand|stands?( still| twice)?|stood": "isn't allowed, is given, doesn't move",
    # Terms of mechanisms.
    r"wanted": "expected, required",
    r"rests?": "residual, remaining",
    r"miss(es)?": "closure error, deviation",
    r"off by|is off|strays?": "deviates by, error",
    r"part ways": "disagree",
    r"hollow": "concave",
    r"ways?": "direction, path, travel, assembly mode",
    r"turns? back": "reverse",
    r"play": "clearance",
    r"figures?": "value, result, shape",
    r"slopes?": "sensitivity, derivative",
    r"freedoms?(?<!of freedom)|free motions?": "degree of freedom",
    r"aren't held|isn't held|held (already|too much)": "under-constrained, over-constrained",
    r"dead positions?": "dead centre, singular position",
    r"singular poses?": "singular position",
    r"(are|is|lie|lies|nearly) in (a )?line": "collinear",
    r"square to": "perpendicular to",
    r"pictures?": "plot",
    r"all at once|all together": "simultaneously",
    # Sizes and other words.
    r"greatest|smallest|(?<!at )least": "maximum, minimum",
    r"findings?": "problem",
    r"(?<!there )is no(?! longer)": "isn't a",
}
"""Words that aren't used, as regular expressions, with what is written instead."""
RULES = [re.compile(rf"\b(?:{word})\b", re.IGNORECASE) for word in BETTER]
ALLOWED = {("motion.singular.what", "ways")}
"""Where one of them is the right word all the same."""


def unwanted(text: str) -> list[str]:
    """The words of a text that have better ones, in lower case; names of data don't count."""
    words = re.sub(r"{{|}}|{[^}]*}", " # ", text)
    return [m[0].lower() for word in RULES for m in word.finditer(words)]


def test_texts_use_the_terms_of_the_field() -> None:
    nobody_breaks(
        {key: [word for word in unwanted(text) if (key, word) not in ALLOWED] for key, text in FINDINGS.items()}
    )


def test_unwanted_words_are_seen_in_texts_but_not_in_their_data() -> None:
    assert unwanted("Take it out; at {way}, the miss is {play:.6g}.") == ["take it out", "miss"]


def test_what_is_allowed_is_there() -> None:
    assert all(word in unwanted(FINDINGS[key]) for key, word in ALLOWED)
