"""Characters of Chinese keyboards and of word processors, each with the one that a file takes."""

from __future__ import annotations

TO_ASCII = {code: chr(code - 0xFEE0) for code in range(0xFF01, 0xFF5F)} | {
    **dict.fromkeys((0x3001, 0xFF64), ","), **dict.fromkeys((0x3002, 0xFF61), "."),
    **dict.fromkeys((0x2236, 0xFE55, 0xFE30), ":"),
    **dict.fromkeys((0x3010, 0x3014), "["), **dict.fromkeys((0x3011, 0x3015), "]"),
    **dict.fromkeys((0x201C, 0x201D, 0x300C, 0x300D, 0x300E, 0x300F), '"'), **dict.fromkeys((0x2018, 0x2019), "'"),
    **dict.fromkeys((0x2010, 0x2011, 0x2012, 0x2013, 0x2014, 0x2015, 0x2212), "-"),
    **dict.fromkeys((0x3000, 0xA0, *range(0x2000, 0x200B), 0x202F), " "), **dict.fromkeys((0x200B, 0xFEFF), ""),
}  # fmt: skip
"""Full-width punctuation, digits and letters, quotes, dashes, blanks."""
BLANKS = "".join(chr(code) for code, meant in TO_ASCII.items() if not meant.strip())
"""The blanks among them, which look like spaces."""
