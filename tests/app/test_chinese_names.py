"""A model whose names are all Chinese: every study and every export has them as they are, in each language."""

from __future__ import annotations

import json
import math
import re
from pathlib import Path

import pytest

import linkwright as lw
from linkwright.model.document import Document
from linkwright.words import LANGUAGES, in_language

MODEL = Path(__file__).parents[2] / "examples" / "chinese_names.yaml"
HANZI = re.compile("[\u4e00-\u9fff]")


@pytest.fixture(scope="module")
def document() -> Document:
    return lw.load(MODEL)


def test_all_names_are_chinese(document: Document) -> None:
    points = {name for link in document.links.values() for name in link.points}
    sections = ("links", "joints", "drives", "parameters", "tables", "loads", "windows", "measures")
    names = points.union(*(getattr(document, section) for section in sections)) - {"frame"}
    assert [name for name in names if not HANZI.search(name)] == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_study_has_them(language: str, document: Document, tmp_path: Path) -> None:
    with in_language(language):
        job = lw.run(MODEL, out=tmp_path / "out")
    assert (job.exit_code, job.found) == (0, [])
    page = (tmp_path / "out" / "report.html").read_text("utf-8")
    assert all(name in page for name in (*document.links, *document.measures, *document.drives, document.name))
    assert not re.search("[\u4e00-\u9fff，。] [\u4e00-\u9fff]", re.search(r"<p[^>]*>曲柄带动.*?</p>", page, re.S)[0])  # type: ignore[index]
    heads = (tmp_path / "out" / "cycle.csv").read_text("utf-8-sig").split("\n", 1)[0]
    assert {"曲柄销.x [mm]", "导轨.s [mm]", "电机.torque [N*m]"} <= {*heads.split(",")}
    summary = json.loads((tmp_path / "out" / "summary.json").read_text("utf-8"))
    values = {name: entry["value"] for name, entry in summary["measures"].items() if "value" in entry}
    assert math.isclose(values["行程"], values["理论行程"], rel_tol=1e-12)


@pytest.mark.parametrize(
    ("target", "file", "names"),
    [
        ("process-simulate", "joint_functions.txt", ["曲柄", "连杆", "滑块", "导轨"]),
        ("mjcf", "mechanism.xml", ["曲柄", "连杆", "滑块", "电机"]),
        ("motor-expressions", "motors.txt", ["电机"]),
    ],
)
def test_every_export_has_them(target: str, file: str, names: list[str], document: Document) -> None:
    exported = lw.export(document, target)
    assert exported.done
    content = exported.files[file]
    text = content.decode() if isinstance(content, bytes) else content
    assert [name for name in (*names, document.name) if name not in text] == []
