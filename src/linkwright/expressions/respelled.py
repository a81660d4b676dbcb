"""Expressions in the spellings of other places: what is meant, in the format's own.

Decimal commas, factors without ``*``, speeds per minute, units by name, signs of print and of Chinese keyboards. An
expression is never read that way: the spelling that is meant is proposed, and must be one that can be read.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Collection

from linkwright.expressions.full_width import TO_ASCII
from linkwright.expressions.parser import reads, tokens
from linkwright.expressions.respelled_units import inverse, multiple, pi, speed, units
from linkwright.expressions.synonyms import unit_meant
from linkwright.expressions.units import UnitError, is_unit, unit
from linkwright.expressions.written import Fault
from linkwright.findings import Term

_SIGNS = str.maketrans({"÷": "/", "∕": "/", "√": "sqrt", "π": "pi", "∙": "*", "•": "*", "⋅": "*", "˚": "°", "º": "°"})
_SQUARED = re.compile("[\u3371-\u33df]")
"""Units as one character: ㎜, ㎏, ㎡."""
_RAISED = str.maketrans("⁻¹²³", "-123")
_LONGEST = 100
_SIGNALS = "x|y|vx|vy|ax|ay|angle|omega|alpha|jerk|s|v|a|torque|force|power"


def respelled(text: str, known: Collection[str] = ()) -> tuple[Term, Term] | None:
    """Why a text isn't an expression and how the one is written that it stands for, if there is one. ``known`` are
    names that mean what they say."""
    if len(text) > _LONGEST:
        return None
    if (found := _as_drawn(text.strip().translate(TO_ASCII))) is not None:
        return None if text.strip() in known else found
    why, meant = None, text
    for reason, rule in _RULES.items():
        if (changed := rule(meant, known)) != meant:
            why, meant = why or reason, changed
    if why is None or not reads(meant):
        return None
    if thousands := _THOUSANDS.fullmatch(text.strip()):
        return Term("respelled-comma"), Term("write-either", text=meant, other="".join(thousands.groups()))
    return Term(f"respelled-{why}"), Term("write", text=meant)


def _as_drawn(text: str) -> tuple[Term, Term] | None:
    """A dimension as drawings have it: with the sign for a diameter, a tolerance, a range, a remark, a mark as its
    unit."""
    if drawn := _DIAMETER.fullmatch(text):
        value, tolerance = drawn.groups()
        hint = Term("write-tolerance", value=value, text=tolerance) if tolerance else Term("write", text=value)
        return Term("respelled-diameter"), hint
    if (remark := _REMARK.fullmatch(text)) and _sense(text, ()) == text:
        return _with_remark(*remark.groups())
    if (limits := _LIMITS.fullmatch(text)) and reads(limits[1] or "0") and reads(limits[2]):
        value, tolerance = limits.groups()
        hint = Term("write-tolerance", value=value, text=tolerance) if value else Term("write", text=tolerance)
        return Term("respelled-tolerance"), hint
    if ends := _RANGE.fullmatch(text):
        return Term("respelled-range"), Term("write-choice", text=ends[1].strip(), other=ends[2])
    if mark := _MARK.fullmatch(text):
        units = ("arcmin", "ft") if mark[2] in "′'" else ("arcsec", "in")
        text, other = (f"{mark[1]} {word}" for word in units)
        return Term("respelled-mark"), Term("write-choice", text=text, other=other)
    return None


def _with_remark(value: str, remark: str) -> tuple[Term, Term] | None:
    """A value and a remark in brackets, which may be a factor where there is no unit between them."""
    if not reads(value):
        found = respelled(value)
        value = str(found[1].data.get("text", "")) if found else ""
    if not value:
        return None
    commented = f"{value}  # {remark}"
    if [*tokens(value)][-1][0] != "number":
        return Term("respelled-stray"), Term("write", text=commented)
    return Term("respelled-factor"), Term("write-choice", text=f"{value}*({remark})", other=commented)


_LIMITS = re.compile(r"(.*?)\s*(?:±|\+/-|\+-)\s*(.+)")
_THOUSANDS = re.compile(r"(-?\d{1,3}),(\d{3})((?:\s*\w+)?)")
_DIAMETER = re.compile(r"[φΦøØ⌀∅]\s*(\d+(?:\.\d+)?(?:\s*mm)?)\s*(?:±\s*)?([a-zA-Z]{1,2}\d{1,2}|(?<=±)\d+(?:\.\d+)?)?")
"""A diameter as drawings have it, with a class or a tolerance."""
_RANGE = re.compile(r"(-?[\d.]+(?:\s*\w+?)?)\s*(?:~|…|至|到)\s*(-?[\d.]+(?:\s*\w+)?)")
_MARK = re.compile(r"(\d+(?:\.\d+)?)\s*(′|″|''|\"|')")
_PART = r"(\d+(?:\.\d+)?)\s*"
_REMARK = re.compile(r"(-?\d(?:.*?\S)?)\s*\(\s*([\u4e00-\u9fff][^-+*/^().]*?)\s*\)")
"""A remark in brackets behind a value, in Chinese."""
_DEGREES = re.compile(rf"(-?){_PART}(?:°|度|deg)\s*{_PART}(?:′|'|分)(?:\s*{_PART}(?:″|''|\"|秒))?")
_COMMA = re.compile(r"(?<![\w.,])(\d+),(\d+)(?![\w.,]*,)(?!\.)")
_GROUPED = re.compile(r"(?<![\w.,])\d{1,3}(?:(?:\.\d{3})+,\d+|(?:,\d{3})+\.\d+|(?:[' ]\d{3})+(?:[.,]\d+)?)(?![\w.,])")


def _wide(text: str, known: Collection[str]) -> str:
    return text.translate(TO_ASCII)


def _degrees(text: str, known: Collection[str]) -> str:
    """Degrees, minutes and seconds as a sum."""

    def summed(match: re.Match[str]) -> str:
        sign, *parts = match.groups()
        terms = [f"{part} {word}" for part, word in zip(parts, ("deg", "arcmin", "arcsec"), strict=True) if part]
        return f"-({' + '.join(terms)})" if sign else " + ".join(terms)

    return _DEGREES.sub(summed, text)


def _signs(text: str, known: Collection[str]) -> str:
    text = _SQUARED.sub(lambda match: unicodedata.normalize("NFKC", match.group()), text)
    text = re.sub(r"√\s*(\w[\w.]*)", r"sqrt(\1)", re.sub(r"\|([^|]+)\|", r"abs(\1)", text))
    text = re.sub(r"(?<=[\d)])\s*[xX]\s*(?=[\d(])", "*", text)
    return re.sub("[⁻¹²³]+", lambda match: "^" + match.group().translate(_RAISED), text).translate(_SIGNS)


def _stray(text: str, known: Collection[str]) -> str:
    """Without what programs and sentences put around an expression: = before it, a comment, a mark behind it."""
    plain = re.sub(r"\$|\{(?=\w+\})|(?<=\w)\}", "", text)
    return re.sub(r"\s*(?://.*|#.*|;.*|[,.])\s*$", "", re.sub(r"^\s*(?:[^\W\d]\w*\s*)?=+\s*", "", plain))


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
    return re.sub(rf"^\s*([^\W\d]\w*?)(?:\s+|\s*的\s*)({_SIGNALS})\s*$", r"\1.\2", text)


def _sense(text: str, known: Collection[str]) -> str:
    """A speed with the sense of rotation as its sign."""
    for words, sign in (("clockwise|cw|顺时针", "-"), ("counter-?clockwise|anti-?clockwise|ccw|逆时针", "")):
        text = re.sub(rf"^\s*(?i:{words})\s*(\d.*?)\s*$", rf"{sign}\1", text)
        text = re.sub(rf"^\s*(\d.*?)(?:\s+|\s*\(\s*)(?i:{words})\s*\)?\s*$", rf"{sign}\1", text)
    return text


_RULES: dict[str, Callable[[str, Collection[str]], str]] = {
    "wide": _wide, "degrees": _degrees, "signs": _signs, "sense": _sense, "stray": _stray, "comma": _comma,
    "speed": speed, "multiple": multiple, "inverse": inverse, "unit": units, "pi": pi, "factor": _factor,
    "dot": _dot,
}  # fmt: skip
"""Ways to write, each with its rewriting; applied one after the other, the first that changes something is named."""


def unit_respelled(text: str) -> str | None:
    """The unit that a text in another spelling stands for, if it does for one."""
    if (meant := unit_meant(text)) is not None:
        return meant
    text = re.sub("[·×⋅]", "*", text)
    found = respelled(f"1 {text}")
    meant = str(found[1].data.get("text", "")).removeprefix("1 ") if found else text
    try:
        return meant if unit(meant) and meant not in ("", "1") else None
    except UnitError:
        return None


def syntax_fault(text: str, reason: Term, known: Collection[str] = ()) -> Fault:
    """The finding on a text that is no expression, and its data: with what is meant, where that is found."""
    short = text if len(text) <= 60 else text[:57] + "..."
    if found := respelled(text, known):
        return "expression.respelled", {"text": short, "reason": found[0], "hint": found[1]}
    return "expression.syntax", {"text": short, "reason": reason}
