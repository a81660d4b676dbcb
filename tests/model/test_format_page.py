"""docs/file-format.md: its fragments are well-formed, and it has every key, unit, function and signal."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from linkwright.compilation import examine
from linkwright.elements import FORCES, drive, spring
from linkwright.elements.cam_contact import entry as cams
from linkwright.expressions.language import FUNCTIONS
from linkwright.expressions.units import unit_words
from linkwright.model import actions, motions, parts, signals
from linkwright.model.document import Document
from linkwright.model.yaml_text import read_text
from linkwright.reductions import REDUCTIONS
from model.given import four_bar

PAGE = (Path(__file__).parents[2] / "docs" / "file-format.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"^```yaml\n(.*?)^```", PAGE, re.M | re.S)
CLASSES = [
    parts.Units, parts.Parameter, parts.Link, parts.Joint, drive.Drive, actions.Table,
    motions.MotionLaw, motions.SegmentEntry, cams.Cam,
    *(kind.entry for kind in FORCES.values()), *(kind.entry for kind in REDUCTIONS.values()),
]  # fmt: skip


def words() -> set[str]:
    """What stands in the page's code."""
    code = re.findall(r"`([^`\n]+)`", PAGE) + re.findall(r"^```\w*\n(.*?)^```", PAGE, re.M | re.S)
    return {word for text in code for word in re.findall(r"[^\W\d]\w*|[%°µ]\w*", text)}


@pytest.mark.parametrize("block", BLOCKS)
def test_every_block_is_well_formed(block: str) -> None:
    source = read_text(block.encode())
    assert not [str(finding) for finding in source.findings]
    data: dict[str, Any] = source.data
    Document.model_validate(data if "linkwright" in data else four_bar(**data))


def test_the_whole_model_is_sound() -> None:
    whole = [block for block in BLOCKS if block.startswith("linkwright: 1")]
    assert whole
    for block in whole:
        assert not examine(Document.model_validate(read_text(block.encode()).data))[1]


def keys() -> Iterator[str]:
    for cls in [Document, *CLASSES]:
        for name, field in cls.model_fields.items():
            yield field.alias or name


def test_every_key_is_explained() -> None:
    assert set(keys()) <= words()


def test_every_unit_is_listed() -> None:
    missing = set(unit_words()) - words() - {"μm"}  # the other µ
    assert not missing


def test_every_function_is_listed() -> None:
    assert set(FUNCTIONS) <= words()


def test_every_signal_is_listed() -> None:
    pressures = {"pressure": None, "pressure_second": None}
    motor, servo = drive.Drive(turns="a", on="b", position="t"), drive.Drive(slides="a", on="b", position="t")
    tables = [signals.POINT, signals.LINK, signals.SLIDE, signals.SLIDE_FORCE, motor.signals, servo.signals]
    tables += [pressures, signals.SHAKING, signals.ENERGY, spring.SIGNALS]
    tables += [spring.TORSION_SIGNALS, {"elastic": None}]
    assert {attribute for table in tables for attribute in table} <= words()


def test_links_within_the_page_lead_somewhere() -> None:
    headings = {
        re.sub(r"[^\w -]", "", h).strip().lower().replace(" ", "-") for h in re.findall(r"^#+ (.*)$", PAGE, re.M)
    }
    assert set(re.findall(r"\]\(#([\w-]+)\)", PAGE)) <= headings
