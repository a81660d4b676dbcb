"""A batch of exports from a CSV file: what is written, and that nothing is where a row is wrong."""

from __future__ import annotations

import csv
import json
import re
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

import linkwright as lw
from linkwright import gallery
from linkwright.app import export_batch
from linkwright.cli import cli

EXAMPLES = Path(__file__).parents[2] / "examples"
TO = "process-simulate"


def batch(folder: Path, text: str, **options: Any) -> Any:
    (folder / "batch.csv").write_text(text, encoding="utf-8")
    return export_batch(folder / "batch.csv", TO, folder / "out", given=options)


def told(job: Any) -> list[tuple[str, int | None, str]]:
    return [(f.code, f.line, f.element) for f in (*job.examined.findings, *job.found)]


def test_every_row_is_what_its_own_model_gives(tmp_path: Path) -> None:
    job = export_batch(EXAMPLES / "hinges.csv", TO, tmp_path / "out", given={"mirror": {}})
    assert job.exit_code == 0
    rows = list(csv.DictReader((EXAMPLES / "hinges.csv").open(encoding="utf-8")))
    written = {path.name for path in (tmp_path / "out").iterdir()}
    endings = ("joint_functions.txt", "joint_functions.cs", "joint_functions.html", "check_table.csv")
    assert written == {f"{row['name']}_{end}" for row in rows for end in endings} | {
        "index.html", "linkwright-manifest.json",
    }  # fmt: skip
    for row in rows:
        document = lw.load(Path(gallery.__file__).parent / "hinge.yaml")
        values = {head.split(" ")[0]: float(cell) for head, cell in row.items() if head != "name" and cell}
        own = lw.export(document.replace(**values), TO, mirror={})
        assert job.summary["rows"][row["name"]]["functions"] == own.summary["functions"]
        text = (tmp_path / "out" / f"{row['name']}_joint_functions.txt").read_text(encoding="utf-8")
        assert f"Bonnet hinge, {row['name']}" in text
        assert all(function in text for function in own.summary["functions"].values())


def test_the_index_links_to_every_file_and_nothing_else(tmp_path: Path) -> None:
    job = batch(tmp_path, 'name,x1 [mm]\n"a b.c",60\n左铰链,61\n')
    assert job.exit_code == 0
    page = (tmp_path / "out" / "index.html").read_text(encoding="utf-8")
    from urllib.parse import unquote

    links = {unquote(link) for link in re.findall(r'href="([^"]+)"', page)}
    links -= {"data:,", "?lang=en", "?lang=zh-CN"}
    assert links == {path.name for path in (tmp_path / "out").iterdir()} - {"index.html", "linkwright-manifest.json"}
    assert "左铰链" in page
    assert page.count("<script") == 2  # the choice of languages
    heads = re.findall(r"<th>(.*?)</th>", page)
    assert re.findall(r'data-head="(.*?)"', page)[: len(heads)] == heads  # what narrow screens show instead


def test_units_in_the_heads_and_models_of_ones_own(tmp_path: Path) -> None:
    (tmp_path / "own.yaml").write_text(gallery.text("hinge").replace("x1: 60", "x1: 72"), encoding="utf-8")
    job = batch(tmp_path, "name,model,x1 [cm],opening\na,,7.2,30\nb,own.yaml,,30\nc,slider-crank,,\n")
    assert job.exit_code == 0
    rows = job.summary["rows"]
    assert rows["a"]["functions"] == rows["b"]["functions"]
    assert rows["a"]["limits"]["j2"]["high"] == pytest.approx(30 * 3.141592653589793 / 180)
    assert rows["c"]["model"] == "slider-crank"


def test_everything_wrong_is_told_at_once_and_nothing_is_written(tmp_path: Path) -> None:
    job = batch(
        tmp_path,
        "name,model,x1 [mm],x2\ngood,,60,\n../bad,,60,\nGOOD,,6l,\nletters,,six,\nnone,nothing.yaml,,\nlong,,1,2,3\n"
        "foreign,slider-crank,3,\nfar,,600,1000\ntall,,1e99,\n",
    )
    assert job.exit_code == 2
    assert job.folder is None
    assert not (tmp_path / "out").exists()
    assert told(job) == [
        ("batch.name", 3, "name"),
        ("batch.name-twice", 4, "GOOD.name"),
        ("table.not-number", 4, "GOOD.x1 [mm]"),
        ("table.not-number", 5, "letters.x1 [mm]"),
        ("batch.model", 6, "nothing.yaml"),
        ("batch.cells", 7, "long"),
        ("batch.parameter", 8, "foreign.x1 [mm]"),
        ("table.not-number", 10, "tall.x1 [mm]"),
        ("functions.toggle", 9, "far.exports.process-simulate.stops"),
    ]


def test_a_wrong_model_file_is_told_once_with_its_own_line(tmp_path: Path) -> None:
    (tmp_path / "own.yaml").write_text(gallery.text("hinge").replace("studies:", "studie:"), encoding="utf-8")
    job = batch(tmp_path, "name,model,x1\na,own.yaml,60\nb,own.yaml,61\n")
    ((code, line, element),) = told(job)
    at = gallery.text("hinge").splitlines().index("studies:") + 1
    assert (code, line, element.split(".")[:2]) == ("file.unknown-key", 2, ["own", f"yaml:{at}"])


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("name,x1 [mmm]\na,1\n", [("units.unknown", 1, "x1 [mmm]")]),
        ("name,x1 [mm\na,1\n", [("batch.head", 1, "x1 [mm")]),
        ("name,x7\na,1\n", [("name.unknown-parameter", 1, "x7")]),
        ("name,x1,x1 [mm]\na,1,1\n", [("table.column-twice", 1, "x1 [mm]")]),
        ("name,x1 [deg]\na,1\n", [("expression.units-conflict", 2, ""), ("expression.units-mixed", 2, "")]),
        ("x1\n1\n", [("batch.no-name", 1, "")]),
        ("name,x1\n", [("batch.empty", 1, "")]),
        ("name;x1\na;1\n", [("table.separator", None, "")]),
    ],
)
def test_wrong_heads_are_told(tmp_path: Path, text: str, found: list[Any]) -> None:
    assert [(code, line) for code, line, _ in told(batch(tmp_path, text))] == [f[:2] for f in found]
    assert not (tmp_path / "out").exists()


def test_a_row_that_cannot_be_exported_leaves_the_last_results_outdated(tmp_path: Path) -> None:
    assert batch(tmp_path, "name,x1\na,60\n").exit_code == 0
    job = batch(tmp_path, "name,x1,x2\na,60,\nb,600,1000\n")
    assert job.exit_code == 1
    assert [code for code, _, _ in told(job)] == ["functions.toggle"]
    assert job.outdated is not None
    assert (job.outdated / "index.html").exists()
    assert not (tmp_path / "out" / "index.html").exists()


def test_the_table_to_start_from_gives_the_model_itself(tmp_path: Path) -> None:
    file = tmp_path / "start.csv"
    made = CliRunner().invoke(cli, ["new", "hinge", "--table", "--out", str(file)])
    assert made.exit_code == 0
    assert file.read_text(encoding="utf-8").splitlines()[0].startswith("name,model,x1 [mm],x2 [mm]")
    out = tmp_path / "out"
    done = CliRunner().invoke(cli, ["export", str(file), "--to", TO, "--out", str(out), "--json"])
    assert done.exit_code == 0
    own = lw.export(Path(gallery.__file__).parent / "hinge.yaml", TO)
    assert json.loads(done.output)["rows"]["hinge-1"]["functions"] == own.summary["functions"]
    again = CliRunner().invoke(cli, ["new", "hinge", "--table", "--out", str(file)])
    assert again.exit_code == 2
    assert CliRunner().invoke(cli, ["new", "nothing", "--table"]).exit_code == 2


@pytest.mark.parametrize("name", gallery.names())
def test_every_model_of_the_gallery_has_a_table(name: str, tmp_path: Path) -> None:
    from linkwright.app.new_files import new_table

    assert new_table(name, tmp_path / "table.csv") == []
    heads, cells = (tmp_path / "table.csv").read_text(encoding="utf-8").splitlines()
    assert heads.count(",") == cells.count(",") >= 2


def test_a_table_in_gbk_is_read_with_a_warning(tmp_path: Path) -> None:
    (tmp_path / "batch.csv").write_bytes("name,x1 [mm]\n左铰链,61\n".encode("gbk"))
    job = export_batch(tmp_path / "batch.csv", TO, tmp_path / "out")
    assert job.exit_code == 0 and told(job)[0][:2] == ("file.read-as", 1)
    assert (tmp_path / "out" / "左铰链_check_table.csv").is_file()
