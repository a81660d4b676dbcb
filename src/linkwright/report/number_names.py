"""Numbers of a file as a page names them: by their places in short, or in words where a language has them."""

from __future__ import annotations

from collections.abc import Sequence

from linkwright.findings import Said, Text
from linkwright.structure import FRAME

Path = Sequence[str | int]

PLAIN = ("mass", "inertia", "speed", "start", "stiffness", "free", "damping", "radius", "base", "roller")
"""Keys of entries that have a word of their own."""


def number_name(path: Path, label: str) -> Text:
    """What the number at a place of the model is called; its ``label`` where no words are known."""
    match [*path]:
        case ["links", link, "points", point, str(part)] if part in ("x", "y"):
            kind = "frame" if link == FRAME else "link"
            return Said(f"number.point.{kind}", link=link, point=point, part=part)
        case ["sketch", point, str(part)] if part in ("x", "y", "z"):
            return Said("number.sketch", point=point, part=part)
        case ["links", link, "com", str(part)] if part in ("x", "y"):
            return Said("number.com", link=link, part=part)
        case ["joints", joint, "line", (0 | 1) as index]:
            return Said(f"number.line.{index}", joint=joint)
        case ["windows", window, (0 | 1) as end]:
            return Said(f"number.window.{end}", window=window)
        case [_, name, str(key)] if key in PLAIN:
            return Said(f"number.of.{key}", name=name)
    return label
