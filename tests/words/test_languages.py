"""The languages say the same: same texts, same data, the terms of docs/glossary.md; Chinese reads like Chinese.

Each rule is a function that gives what is wrong with a text; each is seen to find a planted fault.
"""

from __future__ import annotations

import re
from pathlib import Path
from string import Formatter

import pytest

from linkwright.words import LANGUAGES, catalogue, modules

GLOSSARY = Path(__file__).parents[2] / "docs" / "glossary.md"
ENGLISH, CHINESE = catalogue("en"), catalogue("zh")
KINDS = ("TEXTS", "PROBLEMS", "TERMS")
HANZI = "\u4e00-\u9fff"
FULL = "，。；：、？！（）“”"

CODE = (
    "[[半宽, 成本], ...]",
    "[[公差带半宽, 成本], ...]",
    "[最小值, 最大值]",
    "[最小长度, 最大长度]",
    "[下限, 上限]",
    "[下限, 最可能值, 上限]",
    "[下偏差, 上偏差]",
    "-(a 的运动规律)*z1/z2",
    "r*(小齿轮的运动规律)",
    "-(位移)/r",
    "名称: 值",
    "最小 .. 最大",
    "left of B-D",
    "pip install linkwright[fast]",
    "d({point}.x, {point}.y)/d({drives})",
    "d(x, y)/d(drives)",
)
"""Parts of files, commands and formulas: their punctuation and words are their own."""


# What the languages have in common.


def shape(name: str) -> dict[str, dict[str, list[str]]]:
    """The keys of a language in their order, by module and kind."""
    return {
        module.__name__.split(f".{name}.")[1]: {kind: [*vars(module)[kind]] for kind in KINDS if kind in vars(module)}
        for module in modules(name)
    }


def data(text: str) -> set[tuple[str, str, str]]:
    """The data that a text asks for: name, conversion, format."""
    return {(name, how or "", spec or "") for _, name, spec, how in Formatter().parse(text) if name is not None}


def test_languages_have_the_same_keys_in_the_same_order() -> None:
    assert {name for name in LANGUAGES if shape(name) != shape("en")} == set()


@pytest.mark.parametrize("key", sorted(ENGLISH))
def test_texts_ask_for_the_same_data(key: str) -> None:
    assert data(CHINESE[key]) == data(ENGLISH[key])


def test_other_data_are_seen() -> None:
    assert data("{a} {b:.6g} {{c}}") == data("{{d}} {b:.6g}，{a}")
    assert len({frozenset(data(text)) for text in ("{a}", "{b}", "{a!r}", "{a:.6g}", "{{a}}")}) == 5


# Chinese texts.


def plain(text: str) -> str:
    """A text without lines of a file, names standing for its data."""
    for code in CODE:
        text = text.replace(code, "X")
    return "".join(words + ("X" if name is not None else "") for words, name, _, _ in Formatter().parse(text))


HALF = re.compile(rf"[{HANZI}] ?[,:;.?!()]|[,:;.?!()] ?[{HANZI}]")
CLOSE = re.compile(rf"[{HANZI}][A-Za-z0-9]|(?<!\\n)[A-Za-z0-9][{HANZI}]")
APART = re.compile(rf" [{FULL}]|[{FULL}] ")


def punctuation(text: str) -> list[str]:
    """Half-width signs beside hanzi, hanzi right beside letters and digits, spaces beside full-width signs."""
    spelled = re.sub("X+", "X", plain(text))
    return [m[0] for rule in (HALF, APART) for m in rule.finditer(spelled)] + [
        m[0] for m in CLOSE.finditer(spelled) if "X" not in m[0]
    ]


@pytest.mark.parametrize("key", sorted(CHINESE))
def test_punctuation_is_full_width(key: str) -> None:
    assert punctuation(CHINESE[key]) == []


@pytest.mark.parametrize(
    "text",
    [
        "给出数值,或删除。",
        "单位: {unit}",
        "（{a}）;否则",
        "角度(度)",
        "是否指“{name}”? 改正.",
        "取 ISO公差",
        "第2 行",
        "给出 {a} ，或",
        "完成。 再次运行",
    ],
)
def test_wrong_punctuation_is_seen(text: str) -> None:
    assert punctuation(text)


LATIN = re.compile(r"[A-Za-z][a-z]+(?:['-][a-z]+)*(?: [A-Za-z][a-z]*(?:['-][a-z]+)*){2,}")


def english(text: str) -> list[str]:
    """Three English words or more in a row; those between quotation marks are lines of a file or a command."""
    return LATIN.findall(re.sub("“[^”]*”|{{.*}}", "X", plain(text)))


@pytest.mark.parametrize("key", sorted(CHINESE))
def test_no_text_is_english(key: str) -> None:
    assert english(CHINESE[key]) == []


def test_english_is_seen() -> None:
    assert english("杆组 {group}: the links are collinear") == ["the links are collinear"]
    assert english("写“ahead of B along JOINT”，或 rod A-B") == []


def test_all_texts_are_translated() -> None:
    letters = re.compile(r"[a-z]{3}")
    same = {key for key, text in CHINESE.items() if text == ENGLISH[key] and letters.search(plain(text))}
    assert same == set()
