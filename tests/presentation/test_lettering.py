"""Lines of Chinese: joined without spaces that they don't have."""

from __future__ import annotations

import pytest

from linkwright.presentation.lettering import joined


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
    assert joined(text) == whole
