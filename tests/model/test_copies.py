"""Copies of sub-assemblies: any model file as a sub-assembly, placed once, is that mechanism under other names."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from linkwright import gallery
from linkwright.compilation import examine
from linkwright.elements.entries import ENTRIES
from linkwright.kernels import Compiled
from linkwright.model.document import Document, load, parse_document, plain, read_document
from linkwright.model.mechanism import Mechanism
from linkwright.model.sections import Sections
from linkwright.model.stiffness import JOINTS
from linkwright.reductions import ENTRIES as MEASURES

EXAMPLES = Path(__file__).parents[2] / "examples"
NAME = "c"


def models() -> Iterator[tuple[str, Document, Path | None]]:
    """All examples and models of the gallery."""
    for path in sorted(EXAMPLES.glob("*.yaml")):
        yield path.stem, load(path), EXAMPLES
    for name in gallery.names():
        document, _ = read_document(gallery.text(name, "en").encode())
        assert document is not None
        yield f"gallery {name}", document, None


MODELS = {name: (document, folder) for name, document, folder in models()}


def alone(document: Document) -> dict[str, Any]:
    """A document as plain data without what is asked of it."""
    return {key: value for key, value in plain(document).items() if key not in ("studies", "exports")}


def wrapped(data: Mapping[str, Any]) -> dict[str, Any]:
    """The same with all its elements in a sub-assembly, of which it places one copy."""
    inside = {key: value for key, value in data.items() if key in Sections.model_fields}
    head = {key: value for key, value in data.items() if key not in inside}
    if "gravity" in head and "parameters" in inside:
        head["parameters"] = inside["parameters"]
    if "stiffness" in head:  # that of a whole mechanism, by the names that elements have in it
        stated = head["stiffness"].items()
        head["stiffness"] = {name if name == JOINTS else f"{NAME}_{name}": value for name, value in stated}
    known = head.pop("subassemblies", {})
    return {**head, "subassemblies": {**known, "whole": inside}, "links": {}, "copies": {NAME: {"of": "whole"}}}


def signals(compiled: Compiled) -> list[str]:
    """All signals of elements."""
    named = compiled.quantities.signals
    return [f"{name}.{attribute}" for name in named.named for attribute in named.attributes(name)[1]]


def prefixed(name: str) -> str:
    """A signal of the copy."""
    return name if name.startswith("frame.") else f"{NAME}_{name}"


@pytest.mark.parametrize("name", MODELS)
def test_a_whole_file_as_a_copy_has_the_same_motion_and_forces(name: str) -> None:
    document, folder = MODELS[name]
    data = alone(document)
    if any(isinstance(at, list) and len(at) == 3 for at in data.get("sketch", {}).values()):
        pytest.skip("the sketch has three coordinates, which a sub-assembly can't have")
    expected, found = examine(Document.model_validate(data), folder)
    if expected is None:
        pytest.skip(f"its studies are part of what it says: {[finding.code for finding in found]}")
    document = parse_document(wrapped(data))
    assert isinstance(document, Mechanism)
    compiled, findings = examine(document, folder)
    assert compiled is not None, [str(finding) for finding in findings]
    assert len(findings) == len(found)
    rows = [
        row
        for row in signals(expected)
        if row.split(".")[-1] in ("x", "vx", "angle", "omega", "s", "v", "force", "torque", "power")
    ]
    t = np.linspace(0.0, 0.05, 4)
    one, other = expected.evaluate(rows, t), compiled.evaluate([prefixed(row) for row in rows], t)
    np.testing.assert_array_equal(one, other)


def test_every_kind_of_element_is_among_them() -> None:
    """So a new kind is covered by its example."""
    found = {
        type(entry)
        for document, _ in MODELS.values()
        for section in ENTRIES
        for entry in getattr(document, section).values()
    }
    found |= {type(measure) for document, _ in MODELS.values() for measure in document.measures.values()}
    known = {entry for entries in ENTRIES.values() for entry in entries.values()} | {*MEASURES.values()}
    assert {entry for entry in known - found if entry.__module__.startswith("linkwright.")} == set()
