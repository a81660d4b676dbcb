"""Names that nothing is called by, with the closest that are known."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from difflib import get_close_matches
from typing import Any

from linkwright.model.findings import Finding, Term


def unknown(kind: str, path: tuple[Any, ...], name: str, known: Iterable[str]) -> Finding:
    """A finding on a name; ``kind`` says of what: ``link``, ``slide``, ``drive``, ..."""
    return Finding("name.unknown", path, {"kind": Term(f"a-{kind}"), "name": name, "near": near(name, [*known])})


def near(name: str, known: Sequence[str]) -> str:
    """A readable hint: the closest known names, else all of them."""
    known = [word for word in dict.fromkeys(known) if len(word) <= 60]
    alike = [word for word in known if abs(len(word) - len(name)) <= 4][:200]
    close = get_close_matches(name, alike, n=3, cutoff=0.6)
    return ", ".join(close or known[:20]) or "-"
