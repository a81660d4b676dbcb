"""The file of an interrupted study: whole or refused."""

from __future__ import annotations

import errno
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from blocks.works import Noise, bits, folding
from linkwright.blocks import Checkpoint, Together, carry
from linkwright.blocks import checkpoint as module
from linkwright.findings import ModelError, reason

ARRAYS = {"0.m.mean": np.array([[1.0, np.nan]]), "1.h.slots": np.arange(6).reshape(1, 3, 2)}


@pytest.fixture
def saved(tmp_path: Path) -> Path:
    path = tmp_path / "state"
    Checkpoint(path, "key").write(7, ARRAYS)
    return path


def code(path: Path, key: str = "key") -> str:
    with pytest.raises(ModelError) as caught:
        Checkpoint(path, key).read()
    (finding,) = caught.value.findings
    assert str(path) in finding.what
    assert finding.mend
    return finding.code


def test_what_is_written_is_read(saved: Path) -> None:
    read = Checkpoint(saved, "key").read()
    assert read is not None
    assert read.next == 7
    assert {k: v.tobytes() for k, v in read.arrays.items()} == {k: v.tobytes() for k, v in ARRAYS.items()}
    assert list(saved.parent.iterdir()) == [saved]


def test_nothing_is_there_yet(tmp_path: Path) -> None:
    assert Checkpoint(tmp_path / "state", "key").read() is None


def test_the_state_of_another_work(saved: Path) -> None:
    assert code(saved, "another") == "blocks.other-work"


def test_the_state_of_another_version(saved: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of linkwright, of what the study names, of the file's own format; sound states all of them."""
    monkeypatch.setattr("linkwright._version.__version__", "9.9")
    assert code(saved) == "blocks.other-version"
    Checkpoint(saved, "key", versions={"kernel": "abacus 1"}).write(7, ARRAYS)
    for versions in ({}, {"kernel": "abacus 2"}, {"kernel": "abacus 1", "numpy": "1"}):
        with pytest.raises(ModelError) as refused:
            Checkpoint(saved, "key", versions=versions).read()
        assert [finding.code for finding in refused.value.findings] == ["blocks.other-version"]
    assert Checkpoint(saved, "key", versions={"kernel": "abacus 1"}).read() is not None
    saved.write_bytes(saved.read_bytes().replace(b"blocks 2", b"blocks 1", 1))
    assert code(saved) == "blocks.other-version"


def test_a_damaged_file(saved: Path) -> None:
    """A flipped bit anywhere, a file cut short, an empty one, another kind of file."""
    content = saved.read_bytes()
    for at in [*range(0, len(content), 97), len(content) - 1]:
        saved.write_bytes(content[:at] + bytes([content[at] ^ 4]) + content[at + 1 :])
        assert code(saved) == "blocks.corrupt"
    for wrong in (content[:-1], content[:200], content + b"x", b"", b"linkwright: 1\n"):
        saved.write_bytes(wrong)
        assert code(saved) == "blocks.corrupt"


def test_a_sound_file_of_other_content(saved: Path) -> None:
    """A right checksum over what is no state."""
    import hashlib

    for body in (b"", b"PK\x03\x04 not a zip", saved.read_bytes().partition(b"\n")[2][:-40]):
        saved.write_bytes(f"linkwright blocks {module.FORMAT} {hashlib.sha256(body).hexdigest()}\n".encode() + body)
        assert code(saved) == "blocks.corrupt"


def test_a_file_that_cannot_be_read(tmp_path: Path) -> None:
    assert code(tmp_path) == "file.irregular"


def test_anew_passes_over_it(saved: Path) -> None:
    saved.write_bytes(b"damaged")
    fresh = Checkpoint(saved, "key", anew=True)
    assert fresh.read() is None
    fresh.write(1, {})
    assert Checkpoint(saved, "key").read() is not None


@pytest.mark.parametrize(
    ("number", "expected"), [(errno.ENOSPC, "blocks.no-space"), (errno.EACCES, "blocks.unwritable")]
)
def test_a_checkpoint_that_cannot_be_written(
    number: int, expected: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The study stops with a finding, the last checkpoint stands, and once that is mended the study goes on."""
    path, work, saves = tmp_path / "state", Noise(), 0
    write = module.write_aside

    def full(*words: Any, **options: Any) -> None:
        nonlocal saves
        saves += 1
        if saves > 1:
            raise OSError(number, "so it is")
        write(*words, **options)

    with monkeypatch.context() as patch:
        patch.setattr(module, "write_aside", full)
        outcome = carry(work, folding(work, path), every=0.0)
    assert outcome.error is not None
    assert outcome.error.code == expected
    assert str(reason(OSError(number, ""))) in outcome.error.what
    sink, whole = folding(work, path), folding(work)
    assert 0 < sink.next < outcome.atoms
    assert carry(work, Together([sink, whole])).done
    assert bits(sink.results()) == bits(whole.results())
