"""tools/transcripts.py: what a block shows of a command's output, and how it is remade."""

import importlib.util
from pathlib import Path
from types import ModuleType

import pytest

TRANSCRIPTS = Path(__file__).resolve().parents[2] / "tools" / "transcripts.py"
SAID = """\
Name   Value  Unit
stroke   480  mm

rest  1e-16
Written: out
"""


@pytest.fixture(scope="module")
def transcripts() -> ModuleType:
    spec = importlib.util.spec_from_file_location("transcripts_under_test", TRANSCRIPTS)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize(
    "shown",
    [
        SAID,
        "Name Value Unit\nstroke 480.001 mm\nrest 3e-15\nWritten: out",
        "...\nstroke 480 mm\n...",
        "Name ...\n...\nWritten: out",
        "Name ...\n...",
        "...\nWritten: out",
        "...",
    ],
)
def test_what_is_printed_is_found(transcripts: ModuleType, shown: str) -> None:
    assert transcripts.difference(shown.splitlines(), SAID) == ""


@pytest.mark.parametrize(
    "shown",
    [
        "Name Value Unit",
        "stroke 480 mm\n...",
        "...\nstroke 480 mm",
        "...\nstroke 481 mm\n...",
        "...\nstroke 480 m\n...",
        "...\nrest 1e-8\n...",
        "...\nWritten: out\n...\nstroke 480 mm\n...",
        "...\nName Value Unit\nrest 1e-16\n...",
    ],
)
def test_what_is_not_printed_is_told(transcripts: ModuleType, shown: str) -> None:
    assert transcripts.difference(shown.splitlines(), SAID).startswith("not printed:")


@pytest.mark.parametrize(
    ("shown", "lines"),
    [
        ("old\nolder", ["Name   Value  Unit", "stroke   480  mm", "", "rest  1e-16", "Written: out"]),
        ("...\nstroke 470 mm\n...", ["...", "stroke   480  mm", "..."]),
        ("Name Value\nstroke 470 mm\n...", ["Name   Value  Unit", "stroke   480  mm", "..."]),
        ("...\nWritten: in", ["...", "Written: out"]),
        ("...\nstroke 1 ...\n...", ["...", "stroke   480 ...", "..."]),
    ],
)
def test_a_block_is_remade_with_the_lines_most_like_its_own(
    transcripts: ModuleType, shown: str, lines: list[str]
) -> None:
    assert transcripts.remade(shown.splitlines(), SAID) == lines
    assert transcripts.difference(lines, SAID) == ""
