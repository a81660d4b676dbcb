"""Notes are rare: the examples and the models of the gallery have none, nor warnings on their inputs."""

from __future__ import annotations

from pathlib import Path

import pytest

import linkwright as lw
from linkwright import gallery

EXAMPLES = sorted((Path(__file__).parents[2] / "examples").glob("*.yaml"))
MODELS = [Path(gallery.__file__).parent / f"{name}.yaml" for name in gallery.names()]

SAID_OF_STRUCTURES = ("structure.moments-indeterminate", "structure.redundant-joints")


@pytest.mark.parametrize("path", [*EXAMPLES, *MODELS], ids=lambda path: path.stem)
def test_nothing_is_noted(path: Path) -> None:
    """A loop of slides has moments that statics doesn't determine, and a redundant mechanism says what it assumes:
    their own warnings."""
    assert [finding for finding in lw.check(path) if finding.code not in SAID_OF_STRUCTURES] == []
