"""The language of the command line: by option or system; keys and codes are the same in all of them."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import click
import pytest
from click.testing import CliRunner

from app.models import NAMES, SOUND
from helpers.longer import mostly_long
from linkwright.cli import cli
from linkwright.cli.language import requested_language
from linkwright.presentation.lettering import columns, folded
from linkwright.words import catalogue, language

ENCODINGS = ("gbk", "cp936", "cp1252", "latin-1", "gb18030")
HANZI = r"[\u4e00-\u9fff]"


@pytest.mark.parametrize(
    ("words", "environment", "name"),
    [
        ([], {}, "en"),
        ([], {"LANG": "zh_CN.UTF-8"}, "zh"),
        ([], {"LANG": "zh_CN.GBK", "LC_ALL": "C"}, "en"),
        ([], {"LC_MESSAGES": "zh_TW.UTF-8", "LANG": "en_GB.UTF-8"}, "zh"),
        ([], {"LANG": "de_DE.UTF-8"}, "en"),
        (["run", "x.yaml", "--lang", "zh"], {}, "zh"),
        (["--lang=en", "run"], {"LANG": "zh_CN"}, "en"),
        (["run", "--lang"], {"LANG": "zh_CN"}, "zh"),
        (["run", "--lang", "fr"], {}, "en"),
        (["run", "zh"], {}, "en"),
    ],
)
@pytest.mark.skipif(sys.platform == "win32", reason="a system's language is no variable there")
def test_the_language_that_is_chosen(words: list[str], environment: dict[str, str], name: str) -> None:
    assert requested_language(words, environment) == name


def run(*words: object, **environment: str) -> subprocess.CompletedProcess[bytes]:
    command = [sys.executable, "-m", "linkwright", *map(str, words)]
    return subprocess.run(command, capture_output=True, env={**os.environ, **environment}, timeout=60, check=False)


@pytest.fixture
def model(tmp_path: Path) -> Path:
    path = tmp_path / "model.yaml"
    path.write_text(SOUND, "utf-8")
    return path


def test_json_has_the_same_keys_and_codes(model: Path) -> None:
    def keys(value: Any) -> Any:
        if isinstance(value, dict):
            return {key: keys(each) for key, each in value.items()}
        if isinstance(value, list):
            return [keys(each) for each in value]
        return value if isinstance(value, float | int | bool) else None

    for command in ("run", "check"):
        one, other = (CliRunner().invoke(cli, [command, str(model), "--json", "--lang", name]) for name in ("en", "zh"))
        assert keys(json.loads(one.output)) == keys(json.loads(other.output))
    model.write_text(NAMES, "utf-8")
    found = [
        [
            item["code"]
            for item in json.loads(CliRunner().invoke(cli, ["check", str(model), "--json", "--lang", name]).output)[
                "findings"
            ]
        ]
        for name in ("en", "zh")
    ]
    assert found[0] == found[1] != []
    assert language() == "en"  # only while a command runs


def test_help_and_errors_are_chinese_all_over(model: Path) -> None:
    for words in (
        ["--help"],
        ["run", "--help"],
        ["sweep", "--help"],
        ["runn"],
        ["run"],
        ["run", str(model), "--workres"],
    ):
        said = run(*words, LC_ALL="zh_CN.UTF-8", PYTHONIOENCODING="utf-8")
        text = (said.stdout + said.stderr).decode()
        for line in text.splitlines():
            plain = [
                part for part in line.split() if part.isascii() and part.isalpha() and part.islower() and len(part) > 2
            ]
            names = {"linkwright", "run", *cli.list_commands(click.Context(cli)), "sweep", "workers"}
            assert [part for part in plain if part not in names] == [], line
        assert any("\u4e00" <= letter <= "\u9fff" for letter in text)


@pytest.mark.parametrize("encoding", mostly_long(ENCODINGS, {"cp1252"}.__contains__))
def test_a_console_without_the_letters_shows_others(model: Path, encoding: str) -> None:
    for words in (["run", model, "-v"], ["check", model], ["run", "--help"], ["run", model.with_name("no.yaml")]):
        said = run(*words, LC_ALL="zh_CN.UTF-8", PYTHONIOENCODING=encoding, PYTHONUTF8="0")
        assert b"Traceback" not in said.stderr
        assert said.returncode in (0, 2)
        (said.stdout + said.stderr).decode(encoding)


def test_the_texts_of_click_are_its_own() -> None:
    """Else they wouldn't be found in the catalogue."""
    source = "".join(path.read_text("utf-8") for path in Path(click.__file__).parent.glob("*.py"))
    texts = [text for key, text in catalogue("en").items() if key.startswith("click.")]
    assert texts and [text for text in texts if f'"{text}"' not in source] == []


def test_lines_by_width() -> None:
    assert [*folded("把驱动角度的全部范围分成 12 段，逐段搜索。", 16)] == [
        "把驱动角度的全部",
        "范围分成 12 段，",
        "逐段搜索。",
    ]
    assert all(columns(line) <= 16 for line in folded("把驱动角度的全部范围分成 12 段，逐段搜索。", 16))
    assert [*folded("one two three", 7)] == ["one two", "three"]
