"""Every model of the gallery teaches, runs, is proven, and survives reading and writing."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import linkwright as lw
from helpers.longer import mostly_long
from linkwright import gallery

NAMES = gallery.names()
HOW_TO = Path(__file__).parents[2] / "docs" / "how-to" / "start-from-the-gallery.md"


def loaded(name: str) -> lw.Document:
    return lw.load(Path(gallery.__file__).parent / f"{name}.yaml")


def test_there_are_enough() -> None:
    assert len(NAMES) >= 14
    assert sorted(NAMES) == NAMES
    assert all(re.fullmatch("[a-z]+(-[a-z]+)*", name) for name in NAMES)


def test_another_name() -> None:
    with pytest.raises(KeyError):
        gallery.text("../__init__")


def test_the_how_to_lists_them_all() -> None:
    rows = re.findall(r"^\| `([a-z-]+)` \|", HOW_TO.read_text(encoding="utf-8"), re.M)
    assert sorted(rows) == NAMES


@pytest.mark.parametrize("name", NAMES)
def test_it_says_what_it_is(name: str) -> None:
    text, document = gallery.text(name), loaded(name)
    assert text.startswith("# ")
    assert 30 < len(gallery.title(name)) < 100
    assert gallery.title(name).endswith(".")
    assert sum("#" in line for line in text.splitlines()) >= 3
    assert document.name
    assert len(document.note or "") > 100
    assert document.parameters
    assert len(document.measures) >= 3
    assert document.require
    assert max(map(len, text.splitlines())) <= 120


UNCITED = [name for name in NAMES if not loaded(name).source]


@pytest.mark.parametrize("name", mostly_long(UNCITED, lambda name: name in UNCITED[::4]))
def test_it_runs(name: str) -> None:
    """Nothing is found in it, all requirements are met, every proof holds. The same of all is held by the smoke run; of
    those with a source, the founding cases, from an installed wheel: ``tests/tools/test_wheel_cases.py``."""
    document = loaded(name)
    assert lw.check(document) == []
    job = lw.run(document)
    assert job.exit_code == 0
    assert job.found == []
    assert job.cycle is not None
    certificate = job.cycle.result.certificate
    assert certificate is not None
    assert certificate.sound(1e-10)
    assert all(m.found for m in job.cycle.measures)


@pytest.mark.parametrize("name", NAMES)
def test_it_survives_reading_and_writing(name: str, tmp_path: Path) -> None:
    document = loaded(name)
    lw.save(document, tmp_path / "again.yaml")
    assert lw.load(tmp_path / "again.yaml") == document
