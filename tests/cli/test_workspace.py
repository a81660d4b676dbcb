"""``linkwright workspace``: the study alone, for people and as JSON; ``lw.workspace`` the same from Python."""

from __future__ import annotations

import json
from importlib.util import find_spec
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from click.testing import CliRunner, Result

import linkwright as lw
from helpers.workspaces import arm
from linkwright.cli import cli, main
from linkwright.model.document import parse_document
from linkwright.studies import Stopped


@pytest.fixture
def file(tmp_path: Path) -> Path:
    document = parse_document(arm())
    assert document is not None
    lw.save(document, tmp_path / "arm.yaml")
    return tmp_path / "arm.yaml"


def call(*words: object) -> Result:
    return CliRunner().invoke(cli, [str(word) for word in words], catch_exceptions=False)


def test_the_study_alone(file: Path, tmp_path: Path) -> None:
    result = call("workspace", file, "--out", tmp_path / "out")
    assert result.exit_code == 0
    assert "Workspace of E: 1 regions" in result.stdout and "1507" in result.stdout
    files = {
        "linkwright-manifest.json",
        "report.html",
        "summary.json",
        "workspace.geojson",
        "workspace.svg",
        "workspace_boundary.csv",
    }
    assert {path.name for path in (tmp_path / "out").iterdir()} - {"workspace.dxf"} == files


def interrupted(
    study: dict[str, Any], where: str, file: Path, out: Path, monkeypatch: pytest.MonkeyPatch
) -> dict[str, Any]:
    """The summary of a study with an interrupt ``where`` in the code of the workspace."""
    lw.save(lw.load(file).model_copy(update={"studies": {"workspace": study}}), file)

    def interrupting(*given: Any) -> Any:
        raise KeyboardInterrupt

    monkeypatch.setattr(f"linkwright.studies.workspace.{where}", interrupting)
    monkeypatch.setattr("sys.argv", ["linkwright", "workspace", str(file), "--out", str(out)])
    with pytest.raises(SystemExit) as ended:
        main()
    assert ended.value.code == 130
    summary: dict[str, Any] = json.loads((out / "summary.json").read_text())
    assert [f["code"] for f in summary["findings"]] == ["workspace.stopped"]
    return summary


def test_interrupted_it_writes_what_is_done(
    file: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The first of three regions interrupts the rest."""
    study = {"point": "E", "chord": 1e-3, "for": {"b": [30, 35, 20]}}
    summary = interrupted(study, "parallel.wait", file, tmp_path / "out", monkeypatch)
    assert "1 of 3 regions" in capsys.readouterr().err
    assert not summary["done"]
    assert [region["b"] for region in summary["workspace"]["regions"]] == [30]
    assert "E" in (tmp_path / "out" / "workspace.svg").read_text()
    with pytest.raises(Stopped):
        lw.workspace(file, out=tmp_path / "python")
    assert (tmp_path / "python" / "summary.json").exists()


def test_interrupted_after_its_regions_it_keeps_them_and_the_maps(
    file: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The interrupt comes while the figures are fitted in."""
    study = {"point": "E", "chord": 1e-3, "quality": {"steps": 20}, "fits": {"table": {"circle": 5}}}
    summary = interrupted(study, "fits_outcome.circle_fits", file, tmp_path / "out", monkeypatch)
    assert len(summary["workspace"]["regions"]) == len(summary["workspace"]["quality"]) == 1
    assert "fits" not in summary["workspace"] and (tmp_path / "out" / "workspace_maps.csv").exists()


def test_json(file: Path) -> None:
    result = call("workspace", file, "--json")
    assert result.exit_code == 0
    (region,) = json.loads(result.stdout)["workspace"]["regions"]
    assert region["holes"] == 1


@pytest.mark.parametrize(("option", "extra"), [("--dxf", "cad"), ("--png", "png")])
def test_dxf_and_png_need_their_packages(file: Path, monkeypatch: pytest.MonkeyPatch, option: str, extra: str) -> None:
    monkeypatch.setattr("linkwright._machine.import_module", _missing)
    result = call("workspace", file, option)
    assert result.exit_code == 2
    assert "file.needs-package" in result.stderr and f"linkwright[{extra}]" in result.stderr


def test_png_shows_the_picture_of_the_svg(file: Path, tmp_path: Path) -> None:
    pytest.importorskip("resvg_py", reason="resvg-py isn't installed")
    assert call("workspace", file, "--out", tmp_path / "out", "--png").exit_code == 0
    drawn = ElementTree.parse(tmp_path / "out" / "workspace.svg").getroot()
    content = (tmp_path / "out" / "workspace.png").read_bytes()
    assert content[:8] == b"\x89PNG\r\n\x1a\n"
    size = int.from_bytes(content[16:20], "big"), int.from_bytes(content[20:24], "big")
    assert size == (2 * int(drawn.attrib["width"]), 2 * int(drawn.attrib["height"]))


def test_png_shows_the_trajectories_too(tmp_path: Path) -> None:
    pytest.importorskip("resvg_py", reason="resvg-py isn't installed")
    document = parse_document(arm(trajectories={"steps": 6}))
    assert document is not None
    lw.save(document, tmp_path / "arm.yaml")
    result = call("workspace", tmp_path / "arm.yaml", "--out", tmp_path / "out", "--png")
    assert result.exit_code == 0 and "Trajectories by region" in result.stdout
    names = {path.name for path in (tmp_path / "out").iterdir()}
    assert {f"workspace_trajectories.{kind}" for kind in ("csv", "svg", "png")} <= names
    assert (tmp_path / "out" / "workspace_trajectories.png").read_bytes()[:8] == b"\x89PNG\r\n\x1a\n"


def _missing(package: str) -> None:
    raise ImportError(package)


def test_a_file_without_a_point(tmp_path: Path) -> None:
    document = parse_document(arm() | {"studies": {}})
    assert document is not None
    lw.save(document, tmp_path / "arm.yaml")
    result = call("workspace", tmp_path / "arm.yaml")
    assert result.exit_code == 2 and "point" in result.stderr


def test_from_python(file: Path, tmp_path: Path) -> None:
    outcome = lw.workspace(file, values={"b": [20]}, chord=1e-3, out=tmp_path / "out")
    (region,) = outcome.regions
    assert region.figures.area * 1e6 == pytest.approx(np.pi * (60**2 - 20**2), rel=3e-3)
    assert (tmp_path / "out" / "workspace.dxf").exists() == (find_spec("ezdxf") is not None)
