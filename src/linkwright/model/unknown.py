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
    return ", ".join(alike(name, known) or known[:20]) or "-"


def alike(name: str, known: Sequence[str]) -> list[str]:
    """The known names that are spelled much like one, the closest first; three at most."""
    words = [word for word in known if abs(len(word) - len(name)) <= 4][:200]
    return get_close_matches(name, words, n=3, cutoff=0.6)
