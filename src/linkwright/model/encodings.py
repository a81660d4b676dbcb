"""What a text that isn't UTF-8 may be saved as."""

from __future__ import annotations

import re

_CONTROL = re.compile(rb"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f]")
_MARKS = {b"\xff\xfe": "UTF-16", b"\xfe\xff": "UTF-16"}
_COMMON = (range(0xB0, 0xD8), range(0xA1, 0xAA))
"""The first bytes of common Chinese characters and of punctuation in GB 2312; those of rare ones follow."""
_SHARE = 0.7
"""So many of the pairs must be common ones: in Western encodings single letters make pairs by chance."""


def likely_encoding(raw: bytes) -> str | None:
    """The encoding that bytes which aren't UTF-8 look like: UTF-16, GBK, Windows-1252; ``None``: none of these."""
    if (marked := _MARKS.get(raw[:2])) is not None:
        return marked
    if raw.count(0) * 4 > len(raw) and _reads(raw, "utf-16-le"):
        return "UTF-16"
    if _CONTROL.search(raw):
        return None
    if _reads(raw, "gb18030") and _common(raw) >= _SHARE:
        return "GBK"
    return "Windows-1252" if _reads(raw, "cp1252") else None


def _reads(raw: bytes, encoding: str) -> bool:
    try:
        raw.decode(encoding)
    except UnicodeDecodeError:
        return False
    return True


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
