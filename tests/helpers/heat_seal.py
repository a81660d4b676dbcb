"""The heat-seal cam of examples/, altered, as the data of a model file; and what comes of its study."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from linkwright.app.job import Job, examine_document, perform
from linkwright.findings import Finding
from linkwright.model.document import load, parse_document, plain

EXAMPLE = Path(__file__).parents[2] / "examples" / "heat_seal_cam.yaml"
NC = {"post": "grbl", "cutter": 8, "depth": 12, "tolerance": "2e-3 deg", "feed": "400 mm/min", "speed": "6000 rpm"}


def heat_seal(cam: dict[str, Any] | None = None, **options: Any) -> dict[str, Any]:
    """The model with other entries of its cam and with such options of the study alone."""
    data = plain(load(EXAMPLE))
    data["cams"]["heat_seal"] |= cam or {}
    data["studies"] = {"cam": options}
    return data


def performed(data: dict[str, Any]) -> Job:
    """A model's studies; the file itself is sound."""
    document = parse_document(data)
    assert document is not None
    examined = examine_document(document)
    assert not examined.findings, examined.findings
    return perform(examined)


def findings(data: dict[str, Any]) -> list[Finding]:
    """What is wrong with a model."""
    document = parse_document(data)
    assert document is not None
    return examine_document(document).findings
