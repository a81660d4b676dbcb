"""``linkwright new``: the gallery listed, a model written, nothing written over."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from linkwright import gallery
from linkwright.cli import cli
from linkwright.words import LANGUAGES


def call(*words: object) -> Result:
    return CliRunner().invoke(cli, ["new", *map(str, words)], catch_exceptions=False)


@pytest.mark.parametrize("words", [[], ["--list"], ["wiper", "--list"]])
def test_a_line_for_each_model(words: list[str]) -> None:
    result = call(*words)
    assert result.exit_code == 0
    lines = result.stdout.splitlines()
    assert [line.split()[0] for line in lines] == gallery.names()
    assert all(gallery.title(line.split()[0]) in line for line in lines)


@pytest.mark.parametrize("name", gallery.names())
def test_what_is_written_is_what_is_shipped(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert call(name).exit_code == 0
    assert [path.name for path in tmp_path.iterdir()] == [f"{name}.yaml"]
    assert (tmp_path / f"{name}.yaml").read_bytes() == gallery.text(name).encode()


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_models_are_in_the_language_of_the_command(language: str, tmp_path: Path) -> None:
    listed = call("--list", "--lang", language).stdout.splitlines()
    assert [line.split("  ")[-1].strip() for line in listed] == [gallery.title(n, language) for n in gallery.names()]
    assert call("hinge", "--lang", language, "--out", tmp_path / "hinge.yaml").exit_code == 0
    assert (tmp_path / "hinge.yaml").read_text("utf-8") == gallery.text("hinge", language)


def test_out_names_the_file(tmp_path: Path) -> None:
    result = call("wiper", "--out", tmp_path / "mine.yaml")
    assert result.exit_code == 0
    assert "mine.yaml" in result.stdout
    assert (tmp_path / "mine.yaml").read_text("utf-8") == gallery.text("wiper")


def test_a_file_that_is_there_stays_unless_forced(tmp_path: Path) -> None:
    path = tmp_path / "mine.yaml"
    path.write_text("mine", "utf-8")
    result = call("wiper", "--out", path)
    assert result.exit_code == 2
    assert "file.exists" in result.stderr
    assert path.read_text("utf-8") == "mine"
    assert call("wiper", "--out", path, "--force").exit_code == 0
    assert path.read_text("utf-8") == gallery.text("wiper")


@pytest.mark.parametrize(
    ("name", "near"), [("crankrocker", "crank-rocker"), ("scisor-lift", "scissor-lift"), ("x", "walking-leg")]
)
def test_an_unknown_name_is_told_with_near_ones(name: str, near: str, tmp_path: Path) -> None:
    result = call(name, "--out", tmp_path / "x.yaml")
    assert result.exit_code == 2
    assert "gallery.unknown" in result.stderr
    assert near in result.stderr
    assert not list(tmp_path.iterdir())


def test_a_folder_that_is_not_there(tmp_path: Path) -> None:
    result = call("wiper", "--out", tmp_path / "no" / "x.yaml")
    assert result.exit_code == 2
    assert "file.unwritable" in result.stderr


@pytest.mark.skipif(os.name == "nt", reason="links are POSIX's")
def test_a_link_is_not_written_through(tmp_path: Path) -> None:
    """Not even one that leads nowhere yet."""
    (tmp_path / "mine.yaml").symlink_to(tmp_path / "elsewhere.yaml")
    assert call("wiper", "--out", tmp_path / "mine.yaml").exit_code == 2
    assert call("wiper", "--out", tmp_path / "mine.yaml", "--force").exit_code == 0
    assert not (tmp_path / "elsewhere.yaml").exists()
    assert (tmp_path / "mine.yaml").read_text("utf-8") == gallery.text("wiper")
