"""Numbers of files in the words of a page: in English by their places, in Chinese in words."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from helpers.models import EXAMPLES, GALLERY, identity
from linkwright.model.document import load
from linkwright.model.live_numbers import live_numbers
from linkwright.model.named_numbers import named_numbers
from linkwright.report.number_names import number_name
from linkwright.words import in_language


@pytest.mark.parametrize("path", [*EXAMPLES, *GALLERY], ids=identity)
def test_each_number_has_a_name_of_its_own(path: Path) -> None:
    """English names are the labels, by which the file is searched; Chinese ones are as many, and those of points,
    lines, windows and masses are words."""
    found = live_numbers(named_numbers(load(path)), path.read_text(encoding="utf-8"))
    names = [number_name(one["path"], one["label"]) for one in found]
    assert [str(name) for name in names] == [one["label"] for one in found]
    with in_language("zh"):
        chinese = [str(name) for name in names]
    assert len({*chinese}) == len({one["label"] for one in found})
    for one, name in zip(found, chinese, strict=True):
        section, last = one["path"][0], one["path"][-1]
        worded = section in ("windows", "sketch") or "line" in one["path"] or last in ("mass", "speed")
        if worded and len(one["path"]) == 3:
            assert re.search("[\u4e00-\u9fff]", name), (one["path"], name)
