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
from linkwright.words import catalogue, filled

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


PAGE = re.compile(r"docs/(?!zh/)[\w/-]+\.md")


def test_chinese_texts_name_the_chinese_page_where_there_is_one() -> None:
    named = {key: [path for path in PAGE.findall(text) if translated(path)] for key, text in catalogue("zh").items()}
    nobody_breaks(named)


def test_chinese_pages_link_to_chinese_pages() -> None:
    """But for the line at their head that links to the English one."""
    pages = [*(ROOT / "docs" / "zh").rglob("*.md"), ROOT / "README.zh-CN.md"]
    nobody_breaks({page.relative_to(ROOT).as_posix(): english_links(page) for page in pages})


def english_links(page: Path) -> list[str]:
    """The links of a page to an English one that there is in Chinese."""
    found = re.findall(
        r"(?<!\[English\])(?<!\[英文操作页\])(?<!\[英文验证页\])\(([^)#\s]+\.md)", page.read_text("utf-8")
    )
    paths = [(page.parent / link).resolve() for link in found]
    inside = [path.relative_to(ROOT).as_posix() for path in paths if path.is_relative_to(ROOT)]
    return [path for path in inside if translated(path)]


def translated(path: str) -> bool:
    """Whether there is a Chinese page for an English one."""
    return (
        not path.startswith("docs/zh/") and (ROOT / path.replace("docs/", "docs/zh/", 1)).exists() and "docs/" in path
    )


def test_a_page_that_is_translated_is_seen() -> None:
    assert translated("docs/how-to/cams.md") and not translated("docs/how-to/exports.md")
    assert PAGE.findall("见 docs/how-to/cams.md。") == ["docs/how-to/cams.md"]


@pytest.mark.parametrize(
    ("pattern", "data", "made"),
    [
        ("{a} 相对 {b}（模型中为 {c}）", ("曲柄", "frame", "轴心"), "曲柄相对 frame（模型中为轴心）"),
        ("随 {a} 的变化", ("偏距",), "随偏距的变化"),
        ("随 {a} 的变化", ("AB",), "随 AB 的变化"),
        ("文件 {a} 为空", ("我的 机构.yaml",), "文件我的 机构.yaml 为空"),
        ("{a!r} 和 {b:.3g}", ("轴", 1.5), "'轴' 和 1.5"),
    ],
)
def test_no_spaces_between_hanzi(pattern: str, data: tuple[object, ...], made: str) -> None:
    """Where data of a Chinese file stand in a text; those within the data stay."""
    assert filled(pattern, dict(zip("abc", data, strict=False))) == made
