"""Texts that aren't UTF-8: which encoding they may be saved as, and those that can be read all the same.

UTF-16 begins with a mark of its own. In GBK, as in the encodings of other countries, a text is bytes of which nothing
says how they are meant, so a model is read so only where three things agree: every letter is a pair of high bytes, of
which no half is taken for punctuation of the file in any encoding; all pairs are characters and signs of GB 2312; and
many of the characters are common in texts on mechanisms, which is not so where a Korean, Japanese or Western text is
read as Chinese. What is read that way is reported. In a table nothing can be mistaken: its numbers are the same bytes
in all these encodings, and the name of a column is compared with the model's.
"""

from __future__ import annotations

import re
from typing import NamedTuple

_CONTROL = re.compile(rb"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f]")
_MARKS = {b"\xff\xfe": "UTF-16", b"\xfe\xff": "UTF-16"}
_COMMON = (range(0xB0, 0xD8), range(0xA1, 0xAA))
"""The first bytes of common Chinese characters and of punctuation in GB 2312; those of rare ones follow."""
_SHARE = 0.7
"""So many of the pairs must be common ones: in Western encodings single letters make pairs by chance."""

_PAIRS = re.compile(rb"(?:[\x00-\x7f]|[\xa1-\xa3\xa6\xa9\xb0-\xf7][\xa1-\xfe])*")
"""Text of ASCII and of GB 2312 without the letters of other countries (Japanese, Russian)."""
_OF_MECHANISMS = frozenset(
    "的一不在有用或其为是可以于与和及由从到向上下中内外左右前后时间点线面位置长度宽高角圆半径尺寸大小最值数量单个各每全"
    "机构架件杆曲柄连摇滑块轮凸销槽孔轴轨导铰链副弹簧阻尼缸活塞齿带臂台座板夹手爪刀门盖升降送料压切包装输推拉顶转动移摆"
    "驱电马达速加减力矩载荷重质心惯量功率频周期行程起始终止初工作空间路径轨迹范围极限运循环回返升休止正反顺逆参变设计分析"
    "要求公差精误偏间隙测试验证方法式图表示例型号名称说明注释文件模项目版本输入出结果"
)
_LEAST, _LEAST_SHARE = 3, 0.3
"""So many of the Chinese characters must be :data:`_OF_MECHANISMS`; of any 20, about one is."""
_FEW, _LEAST_OF_FEW = 3, 2
"""Of a word that is this short, fewer need be."""


class Decoded(NamedTuple):
    """A text and the name of its encoding; ``marked`` where the file itself says so."""

    text: str
    encoding: str
    marked: bool


def decoded(raw: bytes, table: bool = False) -> Decoded | None:
    """The text of bytes that aren't UTF-8, where there is one way only to read them; ``table`` for one whose words are
    compared with the model's."""
    if raw[:2] in _MARKS and (text := _decoded(raw, "utf-16")) is not None:
        return Decoded(text, "UTF-16", marked=True)
    if likely_encoding(raw) != "GBK" or (text := _decoded(raw, "gb18030")) is None:
        return None
    return Decoded(text, "GBK", marked=False) if table or _chinese(raw, text) else None


def likely_encoding(raw: bytes) -> str | None:
    """The encoding that bytes which aren't UTF-8 look like: UTF-16, GBK, Windows-1252; ``None``: none of these."""
    if (marked := _MARKS.get(raw[:2])) is not None:
        return marked
    if raw.count(0) * 4 > len(raw) and _decoded(raw, "utf-16-le") is not None:
        return "UTF-16"
    if _CONTROL.search(raw):
        return None
    if _decoded(raw, "gb18030") is not None and _common(raw) >= _SHARE:
        return "GBK"
    return "Windows-1252" if _decoded(raw, "cp1252") is not None else None


def _decoded(raw: bytes, encoding: str) -> str | None:
    try:
        return raw.decode(encoding)
    except UnicodeDecodeError:
        return None


def _chinese(raw: bytes, text: str) -> bool:
    """Whether a text that can be read as GBK is surely Chinese."""
    characters = [letter for letter in text if "\u4e00" <= letter <= "\u9fff"]
    known = sum(character in _OF_MECHANISMS for character in characters)
    least = _LEAST if len(characters) > _FEW else _LEAST_OF_FEW
    return bool(_PAIRS.fullmatch(raw)) and known >= max(least, _LEAST_SHARE * len(characters))


def _common(raw: bytes) -> float:
    """The share of common characters among the pairs of bytes that GBK would read."""
    found = common = at = 0
    while at < len(raw):
        if raw[at] < 0x80:
            at += 1
            continue
        found += 1
        common += any(raw[at] in some for some in _COMMON) and raw[at + 1 : at + 2] > b"\xa0"
        at += 2
    return common / max(found, 1)
