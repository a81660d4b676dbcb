"""Expressions in the spellings of other places: what is meant, in the format's own.

Decimal commas, factors without ``*``, speeds per minute, units by name, signs of print and of Chinese keyboards. An
expression is never read that way: the spelling that is meant is proposed, and must be one that can be read.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection

from linkwright.expressions.parser import reads, tokens
from linkwright.expressions.synonyms import unit_meant
from linkwright.expressions.units import is_unit, unit_words
from linkwright.expressions.unknown import alike
from linkwright.expressions.written import Fault
from linkwright.findings import Term

WIDE = {code: chr(code - 0xFEE0) for code in range(0xFF01, 0xFF5F)} | {
    0x3000: " ", 0x3001: ",", 0x3002: ".", 0x3010: "[", 0x3011: "]", 0x201C: '"', 0x201D: '"', 0x2018: "'", 0x2019: "'",
}  # fmt: skip
"""Punctuation, digits and letters of Chinese keyboards, with those that a file takes."""
_SIGNS = str.maketrans({"÷": "/", "√": "sqrt", "π": "pi", "∙": "*", "•": "*", "–": "-"})
_RAISED = str.maketrans("⁻¹²³", "-123")
_LONGEST = 100
ALIKE_UNIT = 0.75
"""How much of a word and a unit must agree: 'rod' and 'rad' are two words."""
_SIGNALS = "x|y|vx|vy|ax|ay|angle|omega|alpha|jerk|s|v|a|torque|force|power"


def respelled(text: str, known: Collection[str] = ()) -> tuple[Term, Term] | None:
    """Why a text isn't an expression and how the one is written that it stands for, if there is one. ``known`` are
    names that mean what they say."""
    if len(text) > _LONGEST:
        return None
    if (limits := _LIMITS.fullmatch(text.strip())) and reads(limits[1] or "0") and reads(limits[2]):
        value, tolerance = limits.groups()
        hint = Term("write-tolerance", value=value, text=tolerance) if value else Term("write", text=tolerance)
        return Term("respelled-tolerance"), hint
    why, meant = None, text
    for reason, rule in _RULES.items():
        if (changed := rule(meant, known)) != meant:
            why, meant = why or reason, changed
    if why is None or not reads(meant):
        return None
    if thousands := _THOUSANDS.fullmatch(text.strip()):
        return Term("respelled-comma"), Term("write-either", text=meant, other="".join(thousands.groups()))
    return Term(f"respelled-{why}"), Term("write", text=meant)


_LIMITS = re.compile(r"(.*?)\s*(?:±|\+/-|\+-)\s*(.+)")
_THOUSANDS = re.compile(r"(-?\d{1,3}),(\d{3})((?:\s*\w+)?)")
_NUMBER = r"(?<![\w.])(\d+(?:\.\d*)?)"
_ROUND = r"(?:rounds?|rev(?:olution)?s?|turns?|rotations?|r|U|转)"
_MINUTE = re.compile(
    rf"{_NUMBER}(?:(?:\s+1|\s*{_ROUND})?\s*/\s*(?:min(?:utes?)?|分钟?)|\s*min\s*\^?\s*-\s*1|\s*r\.p\.m\.?)(?!\s*[\w(])",
    re.I,
)
_SECOND = re.compile(rf"{_NUMBER}\s*(?:rps|{_ROUND}\s*/\s*(?:s|sec|seconds?|秒))(?!\s*[\w(])", re.I)
_COMMA = re.compile(r"(?<![\w.,])(\d+),(\d+)(?![\w.,]*,)(?!\.)")
_GROUPED = re.compile(r"(?<![\w.,])\d{1,3}(?:(?:\.\d{3})+,\d+|(?:,\d{3})+\.\d+|(?:[' ]\d{3})+(?:[.,]\d+)?)(?![\w.,])")


def _wide(text: str, known: Collection[str]) -> str:
    return text.translate(WIDE)


def _signs(text: str, known: Collection[str]) -> str:
    text = re.sub(r"\|([^|]+)\|", r"abs(\1)", text)
    text = re.sub(r"(?<=[\d)])\s*[xX]\s*(?=[\d(])", "*", text)
    return re.sub("[⁻¹²³]+", lambda match: "^" + match.group().translate(_RAISED), text).translate(_SIGNS)


def _stray(text: str, known: Collection[str]) -> str:
    """Without what programs and sentences put around an expression: = before it, a comment, a mark behind it."""
    plain = re.sub(r"\$|\{(?=\w+\})|(?<=\w)\}", "", text)
    return re.sub(r"\s*(?://.*|#.*|[;,.])\s*$", "", re.sub(r"^\s*=+\s*", "", plain))


def _comma(text: str, known: Collection[str]) -> str:
    """Decimal points in numbers outside the arguments of calls."""
    text = _GROUPED.sub(lambda match: _ungrouped(match.group()), text)

    def pointed(match: re.Match[str]) -> str:
        return match.group() if _within_call(text, match.start()) else f"{match[1]}.{match[2]}"

    return _COMMA.sub(pointed, text)


def _ungrouped(number: str) -> str:
    """A number without the marks between its thousands, with a decimal point."""
    *groups, last = re.split("[.,]", number)
    whole, decimals = ("".join(groups), f".{last}") if groups else (last, "")
    return re.sub(r"\D", "", whole) + decimals


def _within_call(text: str, at: int) -> bool:
    """Whether a place lies among the arguments of a call."""
    opened: list[bool] = []
    for i, letter in enumerate(text[:at]):
        if letter == "(":
            opened.append(bool(re.search(r"\w\s*$", text[:i])))
        elif letter == ")" and opened:
            opened.pop()
    return any(opened)


def _speed(text: str, known: Collection[str]) -> str:
    return _SECOND.sub(r"\1 r/s", _MINUTE.sub(r"\1 rpm", text))


def _units(text: str, known: Collection[str]) -> str:
    """Units by their short names, where a unit can stand: behind a number or another unit."""
    text = _DOTTED.sub(r"\1*\2", text)
    parts, at, may = [], 0, False
    for kind, value, start, end in tokens(text):
        foreign = kind == "word" and may and value not in known and not is_unit(value)
        unit = unit_meant(value) or _with_power(value) or _misspelled(value) if foreign else None
        gap = text[at:start] or (" " if unit and text[start - 1 : start].isdigit() else "")
        parts += [gap, unit or text[start:end]]
        may = kind == "number" or (may and (unit is not None or is_unit(value) or value in ("*", "/", "^")))
        at = end
    return "".join(parts) + text[at:]


_DOTTED = re.compile(r"\b(k?N)\.(m{1,2})\b")


def _with_power(word: str) -> str | None:
    """A unit and its power written as one word: s2."""
    unit, power = word[:-1], word[-1]
    return f"{unit}^{power}" if power in "23" and is_unit(unit) else None


def _misspelled(word: str) -> str | None:
    """A unit of which a word of letters is a misspelling."""
    if len(word) < 3 or not word.isalpha():
        return None
    return next(iter(alike(word, [unit for unit in unit_words() if len(unit) > 1], ALIKE_UNIT)), None)


def _factor(text: str, known: Collection[str]) -> str:
    """A * behind numbers and brackets."""
    parts, at, before = [], 0, ("", "")
    for kind, value, start, end in tokens(text):
        of_number = before[0] == "number" and (value == "(" or (kind == "word" and not is_unit(value)))
        of_bracket = before[1] == ")" and (value == "(" or kind in ("number", "word"))
        parts += ["*" if of_number or of_bracket else text[at:start], text[start:end]]
        at, before = end, (kind, value)
    return "".join(parts) + text[at:]


def _dot(text: str, known: Collection[str]) -> str:
    """A signal of an element whose name stands before it."""
    return re.sub(rf"^\s*([^\W\d]\w*)\s+({_SIGNALS})\s*$", r"\1.\2", text)


def _sense(text: str, known: Collection[str]) -> str:
    """A speed with the sense of rotation as its sign."""
    return re.sub(r"^\s*(\d.*?)\s+(?i:clockwise|cw|顺时针)\s*$", r"-\1", text)


_RULES: dict[str, Callable[[str, Collection[str]], str]] = {
    "wide": _wide, "signs": _signs, "stray": _stray, "comma": _comma, "speed": _speed, "unit": _units,
    "factor": _factor, "dot": _dot, "sense": _sense,
}  # fmt: skip
"""Ways to write, each with its rewriting; applied one after the other, the first that changes something is named."""


def syntax_fault(text: str, reason: Term, known: Collection[str] = ()) -> Fault:
    """The finding on a text that is no expression, and its data: with what is meant, where that is found."""
    short = text if len(text) <= 60 else text[:57] + "..."
    if found := respelled(text, known):
        return "expression.respelled", {"text": short, "reason": found[0], "hint": found[1]}
    return "expression.syntax", {"text": short, "reason": reason}
