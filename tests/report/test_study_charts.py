"""Charts of all registered studies on the page: each has a place, its data once, its texts in every language."""

from __future__ import annotations

import json
import re
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from helpers.charts import line, unpacked, values
from linkwright.model.yaml_text import read_text
from linkwright.presentation.blocks import Chart, Charts
from linkwright.presentation.charts import Field, Graph, Plane
from linkwright.report import page
from linkwright.report.build import report_data
from linkwright.studies import STUDIES
from linkwright.words import LANGUAGES

EXAMPLES = Path(__file__).parents[2] / "examples"


def example(study: str) -> Path:
    """The example with a study that has the fewest others, of these the shortest."""
    asked = {path: read_text(path.read_bytes()).data["studies"] for path in EXAMPLES.glob("*.yaml")}
    return min((path for path in asked if study in asked[path]), key=lambda p: (len(asked[p]), p.stat().st_size))


@cache
def shown(study: str) -> tuple[list[Chart], str]:
    """The charts with numbers of an example's report, and the page."""
    path = example(study)
    data = report_data(lw.load(path), lw.run(path).outcomes)
    blocks = [block for section in data["sections"] for block in section.blocks if isinstance(block, Charts)]
    return [chart for block in blocks for chart in block.charts if chart.content is not None], page(data)


def block(text: str, name: str) -> Any:
    """The data of a page under an id."""
    found = re.search(rf'<script type="application/json" id="{name}">(.*?)</script>', text, re.S)
    return json.loads(found[1]) if found else None


@pytest.mark.parametrize("study", STUDIES)
def test_every_chart_has_its_place_and_its_data_once(study: str) -> None:
    charts, text = shown(study)
    keys = {chart.key for chart in charts}
    assert set(re.findall(r'data-chart="(\w+)"', text)) == keys
    data = block(text, "charts")
    assert set(data["charts"] if data else ()) == keys
    assert not data or len(set(data["paths"])) == len(data["paths"])
    assert ("plane-selection" in text) == bool(keys)  # pages without such charts lack their script


@pytest.mark.parametrize("study", STUDIES)
def test_every_chart_has_its_texts_in_all_languages(study: str) -> None:
    charts, text = shown(study)
    languages = block(text, "languages")
    place = sorted(languages["words"]).index("charts")  # words of other languages have no keys
    keys = sorted(languages["words"]["charts"])
    spoken = [[languages["words"]["charts"][key] for key in keys]]
    spoken += [other["words"][place] for other in languages["others"].values()]
    assert len(spoken) == len(LANGUAGES)
    assert keys == sorted(chart.key for chart in charts)
    for words in spoken:
        assert len(words) == len(charts)
        for chart in charts:
            title, *texts = words[keys.index(chart.key)]
            assert title and len(texts) == len(chart.data.texts)
            assert "{" not in title + "".join(texts)


@pytest.mark.parametrize("study", STUDIES)
def test_what_a_page_reads_is_what_the_study_shows(study: str) -> None:
    """To four digits of the range: of curves, of lines, of maps."""
    charts, text = shown(study)
    data = block(text, "charts")
    for chart in charts:
        plain, content = data["charts"][chart.key], chart.content
        if isinstance(content, Graph):
            _close(values(plain["at"]), content.at)
            for read, row in zip(plain["rows"], content.rows, strict=True):
                if "of" not in read:
                    _close(values(read["values"]), getattr(row, "high", getattr(row, "values", None)))
        assert isinstance(content, Graph | Plane)
        for read, layer in zip(plain.get("layers", ()), getattr(content, "layers", ()), strict=True):
            rings = getattr(layer, "rings", [])
            for number, ring in zip(read.get("paths", ()) if rings else (), rings, strict=True):
                found = line(data["paths"][number], plain["fine"])
                assert np.abs(found[:, [0, -1]] - ring[:, [0, -1]]).max() <= 0.51 * plain["fine"]
            if isinstance(layer, Field):
                found = unpacked(read) if layer.coarse else values(read["values"])
                assert (np.isfinite(found) == np.isfinite(layer.values.ravel())).all()
                assert len(read["colours"]) == len(read["levels"]) + 1
                if not layer.coarse:
                    _close(found, layer.values.ravel())


def _close(found: Any, expected: Any) -> None:
    known = np.isfinite(expected)
    assert (np.isfinite(found) == known).all()
    if known.any():
        off = 1e-4 * np.ptp(expected[known]) + 1e-8 * np.abs(expected[known]).max() + 1e-300
        assert np.abs(found - expected)[known].max() <= off
