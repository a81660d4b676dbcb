"""Every registered target over the examples: it writes the mechanism, or says why not."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from linkwright.app import Examined, examine_file, export_of
from linkwright.app.job import examine_document
from linkwright.app.single_study import altered
from linkwright.exports import TARGETS, Exported

EXAMPLES = Path(__file__).parents[2] / "examples"
FILES = [
    "boom_cylinder",
    "class_four",
    "dwell_drive",
    "five_bar",
    "four_bar",
    "paper_feeder",
    "parallelogram",
    "press_law",
    "quick_return",
    "slider_crank_gas",
    "tailgate",
]


def exported(file: Path, to: str) -> tuple[Examined, Exported | None]:
    document = examine_file(file).document
    assert document is not None
    examined = examine_document(altered(document, to, {}, section="exports"), file.parent, to=to)
    return examined, export_of(examined, to).exported


@pytest.mark.parametrize("name", FILES)
@pytest.mark.parametrize("to", TARGETS)
def test_it_writes_or_refuses(name: str, to: str) -> None:
    examined, first = exported(EXAMPLES / f"{name}.yaml", to)
    if first is None:
        assert examined.exit_code != 0
        assert all(finding.what and finding.mend for finding in examined.findings)
        return
    assert first.done == bool(first.files)
    assert all(finding.what and finding.mend for finding in first.failures + first.warnings)
    json.dumps(dict(first.summary), allow_nan=False)
    for text in (content for content in first.files.values() if isinstance(content, str)):
        assert not re.search(r"\b(nan|inf)\b", text, re.IGNORECASE)
    assert exported(EXAMPLES / f"{name}.yaml", to)[1] == first


@pytest.mark.parametrize("to", TARGETS)
def test_no_warnings_where_the_range_ends_at_dead_centres(tmp_path: Path, to: str) -> None:
    """Rates are infinite where the joint functions' range ends; a RuntimeWarning of NumPy fails the test."""
    text = (EXAMPLES / "sketched_six_bar.yaml").read_text(encoding="utf-8").replace("D: [130, 0]", "D: [143, 0]")
    (tmp_path / "model.yaml").write_text(text.replace("60 rpm", "0.06 rpm"), encoding="utf-8")
    examined, _ = exported(tmp_path / "model.yaml", to)
    assert {finding.code for finding in examined.findings} <= {"motion.cannot-assemble"}
