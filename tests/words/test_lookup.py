"""Texts are found by their keys, whether their modules are those of nearly every command or are imported by need."""

from __future__ import annotations

import subprocess
import sys

import pytest

from linkwright.words import LANGUAGES, USUAL, catalogue, in_language, known, modules, text


@pytest.mark.parametrize("name", LANGUAGES)
def test_every_text_is_found_by_its_key(name: str) -> None:
    with in_language(name):
        assert {key: text(key) for key in catalogue()} == catalogue(name)
    assert all(map(known, catalogue(name)))


def test_a_text_that_there_is_not() -> None:
    assert not known("nothing.at-all")
    with in_language(LANGUAGES[-1]), pytest.raises(KeyError, match="nothing"):
        text("nothing.at-all")


@pytest.mark.parametrize("name", LANGUAGES)
def test_other_modules_are_imported_by_need(name: str) -> None:
    lines = (
        "import sys",
        "from linkwright.words import in_language, text",
        "def imported(): return sorted(m for m in sys.modules if m.startswith('linkwright.words.'))",
        f"with in_language({name!r}):",
        "    text('report.areas'); print(*imported()); text('file.missing.what'); print(*imported())",
    )
    done = subprocess.run([sys.executable, "-c", "\n".join(lines)], capture_output=True, text=True, check=True)
    usual, all_of_them = (line.split() for line in done.stdout.splitlines())
    packages = {f"linkwright.words.{name}", f"linkwright.words.{name}.findings"}
    assert set(usual) == packages | {f"linkwright.words.{name}.{module}" for module in USUAL}
    assert set(all_of_them) == {*usual, f"linkwright.words.{name}.schema", *(m.__name__ for m in modules(name))}
