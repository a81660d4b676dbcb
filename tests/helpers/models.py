"""The model files that come with the package: the examples and the gallery."""

from __future__ import annotations

from pathlib import Path

from linkwright import gallery

EXAMPLES = sorted((Path(__file__).parents[2] / "examples").glob("*.yaml"))
GALLERY = sorted(Path(gallery.__file__).parent.glob("*.yaml"))
CHINESE = sorted((Path(gallery.__file__).parent / "zh").glob("*.yaml"))


def identity(path: Path) -> str:
    """What tells the files apart in the names of tests."""
    return f"{path.parent.name}-{path.stem}"
