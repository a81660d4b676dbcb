"""Folders of the process."""

from __future__ import annotations

import tempfile
from pathlib import Path

import pytest

from linkwright.findings import ModelError
from linkwright.model.temporary import temporary_folder


def test_it_goes_at_the_end() -> None:
    with temporary_folder() as folder:
        (folder / "file").write_text("x")
    assert not folder.exists()


def test_a_system_without_a_place_for_it(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "none"))
    with pytest.raises(ModelError) as refused, temporary_folder():
        pass
    assert [finding.code for finding in refused.value.findings] == ["file.no-temporary"]
