"""Units and speeds in the spellings of other places, each as an expression has it."""

from __future__ import annotations

import re
from collections.abc import Collection

from linkwright.expressions.parser import tokens
from linkwright.expressions.synonyms import unit_meant
from linkwright.expressions.units import UnitError, is_unit, unit, unit_words
from linkwright.expressions.unknown import alike

ALIKE_UNIT = 0.75
"""How much of a word and a unit must agree: 'rod' and 'rad' are two words."""

_NUMBER = r"(?<![\w.])(\d+(?:\.\d*)?)"
_ROUND = r"(?:rounds?|rev(?:olution)?s?|turns?|rotations?|r|U|转|圈)"
_MINUTE = re.compile(
    rf"{_NUMBER}(?:(?:\s+1|\s*{_ROUND})?\s*[/每]\s*(?:min(?:utes?)?|分钟?)|\s*min\s*\^?\s*-\s*1|\s*r\.p\.m\.?)(?!\s*[\w(])",
    re.I,
)
_SECOND = re.compile(rf"{_NUMBER}\s*(?:rps|{_ROUND}\s*[/每]\s*(?:s|sec|seconds?|秒钟?))(?!\s*[\w(])", re.I)
_EACH = re.compile(r"每(分|秒)钟?\s*(\d+(?:\.\d+)?)\s*(?:转|圈)")
_MULTIPLES = {"丝": "0.01 mm", "道": "0.01 mm", "忽米": "0.01 mm", "斤": "0.5 kg", "两": "50 g", "马力": "735.5 W"}
_MULTIPLE = re.compile(rf"{_NUMBER}\s*({'|'.join(_MULTIPLES)})(?!\w)")
_INVERSE = re.compile(r"\s*(?:[*·×.]|(?<=\w)\s)\s*([^\W\d]+)\s*\^\s*-\s*([1-9])(?!\d)")
_PI_UNIT = re.compile(r"(?<![^\W\d])pi\s*\*?\s*([^\W\d]+(?:\s*/\s*[^\W\d]+(?:\^\d)?)?)\s*$")


def speed(text: str, known: Collection[str]) -> str:
    """Speeds of rotation per minute and per second."""
    text = _EACH.sub(lambda match: f"{match[2]} {'rpm' if match[1] == '分' else 'r/s'}", text)
    return _SECOND.sub(r"\1 r/s", _MINUTE.sub(r"\1 rpm", text))


def multiple(text: str, known: Collection[str]) -> str:
    """Units that there are elsewhere as multiples of those that there are here."""
    return _MULTIPLE.sub(lambda match: f"{match[1]}*{_MULTIPLES[match[2]]}", text)


def inverse(text: str, known: Collection[str]) -> str:
    """A division where a unit has a negative power."""

    def divided(match: re.Match[str]) -> str:
        word = match[1] if is_unit(match[1]) else unit_meant(match[1])
        return match.group() if word is None else f"/{word}" + (f"^{match[2]}" if match[2] != "1" else "")

    return _INVERSE.sub(divided, text)


def pi(text: str, known: Collection[str]) -> str:
    """A unit behind pi with the number 1 before it."""

    def with_number(match: re.Match[str]) -> str:
        try:
            unit(match[1])
        except UnitError:
            return match.group()
        return f"pi*(1 {match[1]})"

    return _PI_UNIT.sub(with_number, text)


def units(text: str, known: Collection[str]) -> str:
    """Units by their short names, where a unit can stand: behind a number or another unit."""
    text = _DOTTED.sub(lambda match: match.group() if match[2] in known else f"{match[1]}*{match[2]}", text)
    text = _PRESSURE.sub("kgf", text)
    parts, at, may = [], 0, False
    for kind, value, start, end in tokens(text):
        foreign = kind == "word" and may and value not in known and not is_unit(value)
        meant = unit_meant(value) or _with_power(value) or _misspelled(value) if foreign else None
        gap = text[at:start] or (" " if meant and text[start - 1 : start].isdigit() else "")
        parts += [gap, meant or ("*" if may and value == "·" else text[start:end])]
        may = kind == "number" or (may and (meant is not None or is_unit(value) or value in ("*", "/", "^", "·", "×")))
        at = end
    return "".join(parts) + text[at:]


_DOTTED = re.compile(r"\b(k?N)[-. ](m{1,2})\b")
_PRESSURE = re.compile(r"(?:公斤|kg)(?=\s*/\s*(?:平方[厘毫]?米|(?:[cm]?m|[厘毫]?米)\^?2))")


def _with_power(word: str) -> str | None:
    """A unit and its power written as one word: s2."""
    stem, power = word[:-1], word[-1]
    base = stem if is_unit(stem) else unit_meant(stem)
    return f"{base}^{power}" if power in "23" and base is not None else None


def _misspelled(word: str) -> str | None:
    """A unit of which a word of letters is a misspelling."""
    if len(word) < 3 or not word.isalpha():
        return None
    return next(iter(alike(word, [unit for unit in unit_words() if len(unit) > 1], ALIKE_UNIT)), None)
