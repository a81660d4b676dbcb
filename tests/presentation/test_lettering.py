"""Lines of Chinese: joined without spaces that they don't have."""

from __future__ import annotations

from itertools import pairwise

import pytest

from linkwright.presentation.lettering import breaks, columns, folded, widest, without_hanzi_spaces


@pytest.mark.parametrize(
    ("text", "whole"),
    [
        ("曲柄整周转动， 摇杆摆动。", "曲柄整周转动，摇杆摆动。"),
        ("各运动 副的函数", "各运动副的函数"),
        ("连杆与 180 deg 之差 （表 1）， B 点", "连杆与 180 deg 之差（表 1），B 点"),
        ("名为 “right”的 “左” 侧", "名为“right”的“左”侧"),
        ("Peaucellier 机构 was “exact” in 1864, not 近似", "Peaucellier 机构 was “exact” in 1864, not 近似"),
        ("two  spaces. And more.", "two  spaces. And more."),
    ],
)
def test_lines_are_joined_as_each_language_has_it(text: str, whole: str) -> None:
    assert without_hanzi_spaces(text) == whole


TEXT = "把驱动角度的全部范围分成 12 段，逐段搜索（步长 0.5 deg）。"


@pytest.mark.parametrize("room", [12, 16, 20, 40, 80])
def test_a_text_is_broken_where_it_is_folded(room: int) -> None:
    edges = [0, *breaks(TEXT, room), len(TEXT)]
    lines = [TEXT[start:end].rstrip() for start, end in pairwise(edges)]
    assert lines == [*folded(TEXT, room)]
    assert all(columns(line) <= room for line in lines)
    assert not any(line.startswith(tuple("，。）")) or line.endswith("（") for line in lines)


def test_what_isn_t_broken_needs_its_width() -> None:
    assert widest("one 三 three") == 5


def test_a_percent_sign_stays_with_its_figure() -> None:
    for room in range(8, 30):
        lines = [*folded("偏距 81 %、连杆长 15 %、AD 4.3 %, CD 2 %", room)]
        assert not any(line.startswith("%") for line in lines), lines
    assert widest("a 99.73 %") == 7
    assert widest("12 段，逐段") == 4  # a sign stays with its hanzi
    assert widest("") == 0


@pytest.mark.parametrize("text", ["", "a", "  lift of 99 %, 3 N·m; ±2 mm² ", "one-two\tthree\n4 % 5%  %"])
def test_a_text_without_hanzi_is_broken_at_spaces(text: str) -> None:
    """Beside one hanzi, where the patterns of Chinese are used, it is broken at the same places."""
    for room in (1, 4, 9, 30):
        lines, beside = [*folded(text, room)], [*folded(f"{text}\n中", room)]
        assert "".join(beside).replace(" ", "") == "".join(lines).replace(" ", "") + "中"
        assert beside[: len(lines) - 1] == lines[:-1]
        assert breaks(f"{text}\n中", room)[: len(breaks(text, room))] == breaks(text, room)
    assert max(widest(text), columns("中")) == widest(f"{text} 中")
