"""One Chinese term for one thing: words that texts, pages and models of the gallery had beside the glossary's term,
and over which a reader who knows the textbooks stumbles.

The table is kept for the whole of what is Chinese: the catalogue, docs/zh, the README, the glossary, the gallery.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from helpers.offenders import nobody_breaks
from linkwright.words import catalogue

ROOT = Path(__file__).parents[2]

BETTER = {
    r"转折点": "变点",
    r"(?<!条)环路|移动副的环(?!境)|封闭环": "闭环",
    r"主运动副": "主动运动副",
    r"输出死点|死点数|外死点|内死点": "极限位置",
    r"急回系数": "行程速比系数",
    r"升程": "从动件位移；推程；升距",
    r"摆臂": "摆杆",
    r"三摇杆": "双摇杆机构（不满足杆长条件）",
    r"Grashof|格拉霍夫(?!定理)": "杆长条件（格拉霍夫定理）",
    r"肘节位置": "死点（构件共线）",
    r"方言": "语法格式",
    r"[该本]工具|该软件(?!包)|目标软件": "Process Simulate",
    r"搜索所得|采样所得": "数值搜索，采样值",
    r"全部可用名称": "可用的有",
    r"热板|凸轮毛坯": "加热片，凸轮坯体",
    r"常用对数": "lg x",
    r"雨刮": "刮水器",
    r"说明 `[a-z.-]+`": "提示",
}
"""What isn't written, as regular expressions, with what is."""

ALLOWED = {
    ("docs/zh/papers/cam.md", "升程"),  # the paper's word for the rise
    ("docs/zh/how-to/process-simulate.md", "工具"),
}


def sources() -> Iterator[tuple[str, str]]:
    """All Chinese texts: those of the catalogue by key, files by path."""
    yield from catalogue("zh").items()
    pages = [*(ROOT / "docs" / "zh").rglob("*.md"), ROOT / "README.zh-CN.md", ROOT / "docs" / "glossary.md"]
    for page in (*pages, *(ROOT / "src" / "linkwright" / "gallery" / "zh").glob("*.yaml")):
        yield page.relative_to(ROOT).as_posix(), page.read_text(encoding="utf-8")


def unwanted(text: str) -> list[str]:
    """The words of a text for which there is a better one."""
    return [found[0] for words in BETTER for found in re.finditer(words, text)]


def test_chinese_texts_have_one_term_for_one_thing() -> None:
    nobody_breaks({name: [word for word in unwanted(text) if (name, word) not in ALLOWED] for name, text in sources()})


@pytest.mark.parametrize("text", ["位于移动副的环中", "急回系数", "主运动副 A", "输出死点", "搜索所得（0.1 s）"])
def test_other_words_are_seen(text: str) -> None:
    assert unwanted(text)
    assert not unwanted("主动运动副、独立闭环、行程速比系数、条环境、极限位置")
