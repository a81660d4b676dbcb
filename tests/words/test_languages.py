"""The languages say the same: same texts, same data, the terms of docs/glossary.md; Chinese reads like Chinese.

Each rule is a function that gives what is wrong with a text; each is seen to find a planted fault.
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from string import Formatter

import pytest

from helpers.offenders import nobody_breaks
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
    "Tecnomatix Process Simulate",
    "d({point}.x, {point}.y)/d({drives})",
    "d(x, y)/d(drives)",
    "exp(-d/m)",
)
"""Parts of files, commands, formulas, names: their punctuation and words are their own."""


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


def test_texts_ask_for_the_same_data() -> None:
    nobody_breaks({key: [str(one) for one in data(CHINESE[key]) ^ data(text)] for key, text in ENGLISH.items()})


def test_other_data_are_seen() -> None:
    assert data("{a} {b:.6g} {{c}}") == data("{{d}} {b:.6g}，{a}")
    assert len({frozenset(data(text)) for text in ("{a}", "{b}", "{a!r}", "{a:.6g}", "{{a}}")}) == 5


# Chinese texts.


def plain(text: str) -> str:
    """A text without lines of a file, names standing for its data."""
    for code in CODE:
        text = text.replace(code, "X")
    for _ in range(2):  # lists of a file, lists of such lists
        text = re.sub(r"\[[^][]*\]", "X", text)
    text = re.sub(r"{{.*}}", "X", text)
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


def test_punctuation_is_full_width() -> None:
    nobody_breaks({key: punctuation(text) for key, text in CHINESE.items()})


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


def test_no_text_is_english() -> None:
    nobody_breaks({key: english(text) for key, text in CHINESE.items()})


def test_english_is_seen() -> None:
    assert english("杆组 {group}: the links are collinear") == ["the links are collinear"]
    assert english("写“ahead of B along JOINT”，或 rod A-B") == []


def test_all_texts_are_translated() -> None:
    letters = re.compile(r"[a-z]{3}")
    same = {key for key, text in CHINESE.items() if text == ENGLISH[key] and letters.search(plain(text))}
    assert same == set()


# The glossary.

TERMS = (
    "allocation", "assembly mode", "Assur group", "base circle", "boundary", "branch", "calibration", "change point",
    "circuit", "clearance", "closure error", "concave", "confidence interval", "contact force", "contributor",
    "counterweight", "coupler", "cylinder", "dead centre", "degree of freedom", "deviation", "drive force",
    "drive torque", "dyad", "excess material", "follower", "gouge", "instant centre", "jerk", "joint function",
    "kernel", "limit position", "margin to singularity", "mobility", "Monte Carlo", "over-constrained", "pitch curve",
    "preload", "pressure angle", "prismatic joint", "problem", "requirement", "residual", "revolute joint", "RSS",
    "shaking force", "singular position", "stroke", "sweep", "swing", "time ratio", "tolerance",
    "transfer coefficient", "transmission angle", "under-constrained", "undercut", "verification", "working point",
    "worst case", "yield",
)  # fmt: skip
"""Terms of the glossary that have one Chinese term wherever they stand."""

EXCEPTIONS = {
    "cam.no-figure.mend": "follower",  # form-closed is said of the cam
    "joint.lifts-off.mend": "preload",  # to preload
    # Keys of a file, and what happens in place of what it is called.
    "schema.Facts.outline": "sweep",
    "schema.Sections.require": "stroke",
    "schema.SweepOptions.keep": "deviation",
}
"""Texts that say one of them in another way."""


def glossary() -> dict[str, list[str]]:
    """The Chinese terms by their English ones."""
    rows = re.findall(r"^\| ([^|]+) \| ([^|]+) \|", GLOSSARY.read_text(encoding="utf-8"), re.MULTILINE)
    made = {}
    for terms, chinese in rows[1:]:
        for term in re.sub(r" \([^)]*\)", "", terms).split(", "):
            made[term] = [one for one in re.split("[、（）]", chinese) if one]
    return made


MEANT = glossary()


@cache
def named(term: str) -> re.Pattern[str]:
    """A term as texts have it: of one, of many."""
    many = (re.sub("y$", "(?:y|ies)", re.escape(word)) + "(?:s|es)?" for word in term.split())
    return re.compile(rf"(?<![\w'.-]){' '.join(many)}(?![\w-])", re.IGNORECASE)


def otherwise(text: str, chinese: str) -> list[str]:
    """The terms of an English text that its Chinese one has in other words."""
    words = re.sub(r"(?<!\w)'[^']*'(?!\w)|{{.*}}|{[^}]*}|(?i:standard deviations?)", "#", text)
    return [
        term
        for term in TERMS
        if named(term).search(words) and not any(one.lower() in chinese.lower() for one in MEANT[term])
    ]


def test_chinese_texts_have_the_terms_of_the_glossary() -> None:
    found = {key: otherwise(text, CHINESE[key]) for key, text in ENGLISH.items()}
    assert {key: found[key] for key in EXCEPTIONS} == {key: [term] for key, term in EXCEPTIONS.items()}
    nobody_breaks({key: terms for key, terms in found.items() if key not in EXCEPTIONS})


def test_all_terms_are_in_the_glossary_and_in_texts() -> None:
    texts = "\n".join(ENGLISH.values())
    assert [term for term in TERMS if term not in MEANT or not named(term).search(texts)] == []
    assert len(TERMS) >= 40


def test_other_terms_are_seen() -> None:
    assert otherwise("Two dead centres of {drive}.", "{drive} 的两个止点。") == ["dead centre"]
    assert otherwise("The boundaries of 'boundary: {boundary}'.", "轮廓线。") == ["boundary"]
    assert otherwise("Dead centres.", "死点。") == otherwise("A standard deviation.", "标准差。") == []
    assert MEANT["transfer coefficient"] == ["灵敏度", "传递系数"]


def test_examples_in_texts_show_the_same_keys() -> None:
    """What can be written is one thing: a key that a text shows in one language stands in the other, too. Only code has
    a plain colon behind a word in Chinese; in English it is sure behind a brace."""
    en, zh = catalogue("en"), catalogue("zh")
    shown = {key: {*re.findall(r"([a-z_]+): ", str(zh[key]))} for key in en}
    absent = {key: {word for word in words if f"{word}:" not in str(en[key])} for key, words in shown.items()}
    back = {key: {*re.findall(r"\{\{([a-z_]+): ", str(en[key]))} - shown[key] for key in en}
    assert sum(map(bool, shown.values())) > 40
    assert {key: words for key, words in absent.items() if words} == {}
    assert {key: words for key, words in back.items() if words} == {}
