"""Why the system refuses something, in the language of all texts."""

from __future__ import annotations

import errno
import os

import pytest

from linkwright.findings import SYSTEM, reason
from linkwright.words import catalogue, in_language


def test_usual_reasons_have_texts() -> None:
    """In English the system's own, in Chinese without any English."""
    texts = {key for key in catalogue("en") if key.startswith("term.system-")}
    assert texts == {f"term.system-{name.lower()}" for name in SYSTEM}
    for name in SYSTEM:
        error = OSError(getattr(errno, name), "system's words")
        with in_language("zh"):
            assert str(reason(error)).isascii() is False


@pytest.mark.skipif(os.name == "nt", reason="Windows has other words")
def test_in_english_they_are_posix_words() -> None:
    numbers = [getattr(errno, name) for name in SYSTEM]
    found = {number: str(reason(OSError(number, "-"))) for number in numbers}
    assert found[errno.EACCES] == "Permission denied"
    if os.uname().sysname == "Linux":
        assert found == {number: os.strerror(number) for number in numbers}


def test_other_reasons_are_in_the_words_of_the_system() -> None:
    assert reason(OSError(errno.EIO, "Input/output error")) == "Input/output error"
    assert reason(OSError("no number")) == reason(ValueError("no number")) == "no number"


def test_a_file_that_another_program_holds_is_in_use() -> None:
    error = PermissionError(errno.EACCES, "The process cannot access the file")
    error.winerror = 32  # type: ignore[attr-defined]
    assert str(reason(error)) == "Device or resource busy"
