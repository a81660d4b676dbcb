"""Model files for the tests: the examples of the format, small ones to vary, and what is found in them."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from linkwright.compilation import examine
from linkwright.findings import Finding
from linkwright.model.document import Document, located, read_document
from linkwright.model.quantities import Quantities

DATA = Path(__file__).parent / "data"
FEEDER = (DATA / "paper_feeder.yaml").read_text(encoding="utf-8")


def findings(text: str | bytes, folder: Path = DATA) -> list[Finding]:
    """Everything that is found in a model file. Each finding has words."""
    raw = text.encode() if isinstance(text, str) else text
    document, source = read_document(raw)
    assert (document is None) == bool(source.findings)
    found = source.findings if document is None else located(examine(document, folder)[1], source)
    for finding in found:
        assert finding.what
        assert finding.mend
        assert "{" not in finding.code
    return found


def codes(text: str | bytes) -> list[str]:
    """The codes of everything that is found."""
    return [finding.code for finding in findings(text)]


def changed(*pairs: tuple[str, str], text: str = FEEDER) -> str:
    """The paper feeder with some of its text replaced, once each."""
    for old, new in pairs:
        assert old in text, old
        text = text.replace(old, new, 1)
    return text


def four_bar(**sections: Any) -> dict[str, Any]:
    """A four-bar as plain data, with sections added or replaced."""
    data: dict[str, Any] = {
        "linkwright": 1,
        "name": "four-bar",
        "units": {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"},
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [100, 0]}},
            "crank": {"points": {"A": [0, 0], "B": [40, 0]}},
            "coupler": {"points": {"B": [0, 0], "C": [120, 0]}},
            "rocker": {"points": {"D": [0, 0], "C": [80, 0]}},
        },
        "assembly": {"C": "left of B-D"},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": 40}},
    }
    return {**data, **sections}


def quantities(data: Mapping[str, Any]) -> Quantities:
    """The quantities of a model given as plain data, whatever is found in them."""
    return Quantities(Document.model_validate(dict(data)))
