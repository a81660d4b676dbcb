"""The section ``exports``: its options, and what is said of it when it is wrong."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner
from pydantic import Field

import linkwright as lw
from app.models import SOUND
from linkwright.cli import cli
from linkwright.exports import TARGETS, Exported, register
from linkwright.expressions.fields import Frozen
from linkwright.findings import Finding
from linkwright.model.document import read_document


class Options(Frozen):
    """Those of a target that is there for the tests."""

    digits: int = Field(3, ge=1, description="digits")


@pytest.fixture
def target() -> Iterator[None]:
    @register
    class Numbers:
        """The lengths of a four-bar as text."""

        name = "own-numbers"
        options = Options

        def check(self, compiled: Any, options: Options) -> list[Finding]:
            wrong = Finding(
                "export.options", ("exports", "own-numbers"), {"export": "", "key": "", "reason": "so many"}
            )
            return [wrong] if options.digits > 15 else []

        def export(self, compiled: Any, options: Options, site: Any) -> Exported:
            text = f"{compiled.quantities.parameters['a']:.{options.digits}f}"
            failed = Finding("export.options", (), {"export": "", "key": "digits", "reason": "too few"})
            failures = [] if options.digits > 1 else [failed]
            return Exported({"a.txt": text}, {"a": text, "name": site.document.name}, (f"a is {text}",), failures)

    yield
    del TARGETS["own-numbers"]


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "model.yaml"
    path.write_text(SOUND + "exports:\n  own-numbers: {digits: 4}\n")
    return path


def call(*words: object) -> Any:
    return CliRunner().invoke(cli, [str(word) for word in words], catch_exceptions=False)


def test_the_section_survives_reading_and_writing(file: Path, tmp_path: Path) -> None:
    document = lw.load(file)
    assert document.exports == {"own-numbers": {"digits": 4}}
    lw.save(document, tmp_path / "other.yaml")
    assert lw.load(tmp_path / "other.yaml") == document
    assert lw.Builder().export("own-numbers", digits=4)._data["exports"] == document.exports


@pytest.mark.usefixtures("target")
def test_the_file_s_options_and_others(file: Path) -> None:
    assert lw.check(file) == []
    assert lw.export(file, "own-numbers").files == {"a.txt": "0.0400"}
    assert lw.export(lw.load(file), "own-numbers", digits=2).summary == {"a": "0.04", "name": "Four-bar"}


@pytest.mark.usefixtures("target")
def test_the_command(file: Path, tmp_path: Path) -> None:
    done = call("export", file, "--to", "own-numbers", "--set", "digits=6")
    assert done.exit_code == 0 and "a is 0.040000" in done.stdout
    folder = tmp_path / "model_linkwright"
    assert {path.name for path in folder.iterdir()} == {"a.txt", "linkwright-manifest.json"}
    assert (folder / "a.txt").read_text() == "0.040000"
    done = call("export", file, "--to", "own-numbers", "--json", "--out", tmp_path / "out")
    data = json.loads(done.stdout)
    assert data == {"target": "own-numbers", "done": True, "a": "0.0400", "name": "Four-bar"} | {
        "files": ["a.txt"],
        "findings": [],
    }


@pytest.mark.usefixtures("target")
def test_a_failure_of_the_target_is_exit_1(file: Path) -> None:
    done = call("export", file, "--to", "own-numbers", "--set", "digits=1", "--json")
    assert done.exit_code == 1
    data = json.loads(done.stdout)
    assert not data["done"] and [finding["code"] for finding in data["findings"]] == ["export.options"]


@pytest.mark.usefixtures("target")
@pytest.mark.parametrize(
    ("words", "code"),
    [
        (("--to", "own-number"), "export.unknown"),
        (("--to", "own-numbers", "--set", "digits"), "export.setting"),
        (("--to", "own-numbers", "--set", "digits=[1"), "export.setting"),
        (("--to", "own-numbers", "--set", "digits=0"), "export.options"),
        (("--to", "own-numbers", "--set", "digits=16"), "export.options"),
        (("--to", "own-numbers", "--set", "digit=2"), "file.unknown-key"),
        (("--to", "own-numbers", "--dialect", "seed"), "file.unknown-key"),
    ],
)
def test_wrong_words(file: Path, words: tuple[str, ...], code: str) -> None:
    done = call("export", file, *words)
    assert done.exit_code == 2 and code in done.stderr and not (file.parent / "model_linkwright").exists()
    done = call("export", file, *words, "--json")
    assert [finding["code"] for finding in json.loads(done.stdout)["findings"]] == [code]


@pytest.mark.usefixtures("target")
@pytest.mark.parametrize(
    ("section", "codes"),
    [
        ("{own-nubers: {}}", ["export.unknown"]),
        ("{own-numbers: {digits: many}}", ["export.options"]),
        ("{own-numbers: {digits: 0}, mjfc: {}}", ["export.options", "export.unknown"]),
        ("{own-numbers: {digits: 20}}", ["export.options"]),
        ("[own-numbers]", ["file.expected"]),
        ("{own-numbers: 5}", ["file.expected"]),
    ],
)
def test_a_wrong_section_is_told_with_its_line(tmp_path: Path, section: str, codes: list[str]) -> None:
    path = tmp_path / "model.yaml"
    path.write_text(SOUND + f"exports: {section}\n")
    found = lw.check(path)
    assert [finding.code for finding in found] == codes
    assert all(finding.line == SOUND.count("\n") + 1 for finding in found)


@pytest.mark.usefixtures("target")
def test_near_names_are_offered() -> None:
    document, _ = read_document((SOUND + "exports: {own-nubers: {}}\n").encode())
    assert document is not None
    (finding,) = lw.check(document)
    assert "own-numbers" in finding.mend
