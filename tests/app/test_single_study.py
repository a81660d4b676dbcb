"""One study, or one export, of a file: what is said where the file doesn't have it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import linkwright as lw
from app.models import NO_STUDY, SOUND
from linkwright.app import examine_alone
from linkwright.exports import TARGETS, register
from linkwright.expressions.fields import Frozen
from linkwright.findings import ModelError
from linkwright.model.document import read_document
from linkwright.studies import STUDIES

MISSING = {"sweep": [], "workspace": [], "cam": ["cam.none"], "accuracy": ["tolerance.none"]}
"""Studies that a file must ask for, with what else the sound one lacks."""


@pytest.mark.parametrize("owner", [*STUDIES.values(), *TARGETS.values()], ids=lambda owner: owner.name)
def test_the_example_of_a_section_is_one(owner: Any) -> None:
    section = "studies" if owner in STUDIES.values() else "exports"
    document, source = read_document(f"{NO_STUDY}{section}: {{{owner.name}: {owner.example}}}\n".encode())
    assert document is not None, source.findings
    owner.options.model_validate(getattr(document, section)[owner.name], context={"cycle": {"turns": "1 motor"}})


@pytest.mark.parametrize("study", STUDIES)
def test_a_study_that_the_file_lacks(study: str, tmp_path: Path) -> None:
    (path := tmp_path / "model.yaml").write_text(SOUND)
    found = examine_alone(path, study).findings
    if study not in MISSING:
        assert "study.missing" not in [finding.code for finding in found]
        return
    assert [finding.code for finding in found] == ["study.missing", *MISSING[study]]
    assert "Its studies: cycle." in found[0].what
    assert f"'studies: {{{study}: {STUDIES[study].example}}}'" in found[0].mend


def test_a_file_without_studies_has_none(tmp_path: Path) -> None:
    (path := tmp_path / "model.yaml").write_text(NO_STUDY)
    assert "Its studies: none." in examine_alone(path, "sweep").findings[0].what


def test_in_python_too(tmp_path: Path) -> None:
    (path := tmp_path / "model.yaml").write_text(SOUND)
    with pytest.raises(ModelError) as caught:
        lw.sweep(path)
    assert [finding.code for finding in caught.value.findings] == ["study.missing"]
    assert lw.sweep(path, {"a": [40, 41]}).done  # its options may be given here


def test_a_wrong_option_is_told_as_such(tmp_path: Path) -> None:
    (path := tmp_path / "model.yaml").write_text(SOUND.replace("studies:", "studies:\n  sweep: {very: {a: [40, 41]}}"))
    assert [finding.code for finding in examine_alone(path, "sweep").findings] == ["file.missing", "file.unknown-key"]


class Options(Frozen):
    """Those of a target that is there for the tests."""

    digits: int


@pytest.fixture
def target() -> Iterator[None]:
    @register
    class Needy:
        """A target that can't do without options."""

        name = "needy"
        example = "{digits: 3}"
        options = Options

    yield
    del TARGETS["needy"]


@pytest.mark.usefixtures("target")
def test_an_export_that_the_file_lacks(tmp_path: Path) -> None:
    (path := tmp_path / "model.yaml").write_text(SOUND)
    with pytest.raises(ModelError) as caught:
        lw.export(path, "needy")
    (finding,) = caught.value.findings
    assert finding.code == "export.missing" and "'exports: {needy: {digits: 3}}'" in finding.mend
