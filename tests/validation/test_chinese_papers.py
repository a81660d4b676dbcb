"""The pages docs/zh/papers: what their tables and commands show is what linkwright computes now.

Above a computed table stands ``<!-- table NAME -->``; the module of the page in ``papers`` gives the last
cells of its rows. Of a ``console`` block the commands are run, and what it shows of their output must come, in order.
Run as a script, with the folder ``tests`` on the path, this file writes the computed cells anew.
"""

from __future__ import annotations

import re
import shlex
import shutil
from importlib import import_module
from pathlib import Path

import pytest
from click.testing import CliRunner

from linkwright.cli import cli
from validation.papers import Rows, Tables

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "docs" / "zh" / "papers"
PAGES = {
    "index": "index",
    "paper-feeder": "feeder",
    "hinge": "hinge",
    "five-bar": "five_bar",
    "accuracy": "accuracy",
    "cam": "cam",
}
"""The pages by the modules that compute what they show."""
TABLE = re.compile(
    r"^(?P<above> *<!-- table (?P<name>[\w-]+) -->\n\n *\|.*\n *\|[-|]+\|\n)(?P<rows>(?: *\|.*\n)*)", re.M
)
"""A table with its name: the lines above its rows, and these."""
CONSOLE = re.compile(r"^```console\n(.*?)^```$", re.M | re.S)


def text(page: str) -> str:
    return (FOLDER / f"{page}.md").read_text(encoding="utf-8")


def computed(page: str) -> Tables:
    found: Tables = import_module(f"validation.papers.{PAGES[page]}").tables()
    return found


def cells(line: str) -> list[str]:
    return [cell.strip() for cell in line.strip().removeprefix("|").removesuffix("|").split("|")]


@pytest.mark.parametrize("page", PAGES)
def test_the_tables_are_those_computed(page: str) -> None:
    shown = {one["name"]: [cells(line) for line in one["rows"].splitlines()] for one in TABLE.finditer(text(page))}
    assert len(shown) == text(page).count("<!-- table ")
    found = computed(page)
    assert sorted(shown) == sorted(found)
    for name, rows in found.items():
        assert [line[-len(row) :] for line, row in zip(shown[name], rows, strict=True)] == rows, name


@pytest.mark.parametrize("page", PAGES)
def test_the_commands_answer_as_shown(page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    shutil.copytree(ROOT / "examples", tmp_path / "examples", ignore=shutil.ignore_patterns("*_linkwright"))
    monkeypatch.chdir(tmp_path)
    blocks = CONSOLE.findall(text(page))
    assert blocks
    for block in blocks:
        for command, answer in re.findall(r"^\$ linkwright (.*)\n((?:(?!\$ ).*\n)*)", block, re.M):
            done = CliRunner().invoke(cli, shlex.split(command))
            assert done.exit_code == 0, done.output
            said = [line.rstrip() for line in done.output.splitlines()]
            after = 0
            for line in answer.splitlines():
                if line != "...":
                    assert line in said[after:], (command, line)
                    after = said.index(line, after) + 1


def rewritten(page: str) -> str:
    """The page with the computed cells as they come out now."""
    found = computed(page)

    def made(match: re.Match[str]) -> str:
        above, name, lines = match["above"], match["name"], match["rows"].splitlines()
        rows: Rows = found[name]
        width = above.splitlines()[-1].count("|") - 1
        heads = [cells(line)[: width - len(rows[0])] for line in lines]
        indent = len(lines[0]) - len(lines[0].lstrip())
        new = (" " * indent + f"| {' | '.join([*head, *row])} |" for head, row in zip(heads, rows, strict=True))
        return above + "".join(f"{line}\n" for line in new)

    return TABLE.sub(made, text(page))


if __name__ == "__main__":
    for every in PAGES:
        (FOLDER / f"{every}.md").write_text(rewritten(every), encoding="utf-8")
