"""Letters that an encoding lacks: their like is written, and what they mean isn't lost."""

from __future__ import annotations

import pytest

from linkwright.cli import streams

assert streams  # it registers what stands for letters that a stream lacks


@pytest.mark.parametrize(
    ("encoding", "passed", "failed", "area"),
    [("gbk", "√", "×", "^2"), ("gb18030", "✓", "✗", "²"), ("ascii", "+", "x", "^2"), ("latin-1", "+", "×", "²")],
)
def test_verdicts_and_units_stay_apart(encoding: str, passed: str, failed: str, area: str) -> None:
    """A tick and a cross were both a question mark, and so were mm² and mm³."""
    written = [letter.encode(encoding, "linkwright.replace").decode(encoding) for letter in ("✓", "✗", "mm²", "mm³")]
    assert written[:3] == [passed, failed, f"mm{area}"]
    assert len({*written}) == 4 and "?" not in "".join(written)


def test_what_has_no_like_is_a_question_mark() -> None:
    assert "𝕏 好".encode("ascii", "linkwright.replace") == b"? ?"
