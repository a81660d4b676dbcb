"""Names that nothing is called by, with those that are meant: the one place where names are compared."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Sequence
from difflib import SequenceMatcher
from typing import Any

from linkwright.findings import Finding, Joined, Term

MOST = 3
"""The most names that a hint proposes."""
LISTED = 24
"""The most names that are listed where none is like the given one."""
ALIKE, ALIKE_SHORT = 0.7, 0.6
"""How much of two names must agree: 'ground' isn't 'rod'; less of two or three letters: 'BB' may be 'B'."""
LONGEST = 60


def unknown(kind: str, path: tuple[Any, ...], name: str, known: Iterable[str]) -> Finding:
    """A finding on a name; ``kind`` says of what: ``link``, ``slide``, ``drive``, ..."""
    return Finding("name.unknown", path, {"kind": Term(f"a-{kind}"), "name": name, "near": near(name, [*known])})


def unknown_point(path: tuple[Any, ...], link: str, point: str, known: Iterable[str]) -> Finding:
    """That a link has no such point."""
    return Finding("name.unknown-point", path, {"link": link, "name": point, "near": near(point, [*known])})


class Near(Term):
    """A sentence on a name that isn't known; ``likely`` are the known ones that may be meant, the likeliest first."""

    def __init__(
        self, key: str, names: Iterable[str], likely: Iterable[str], known: Iterable[str] = (), more: int = 0
    ) -> None:
        super().__init__(key, names=Joined(names), known=Joined(known), more=more)
        self.likely = tuple(likely)


def proposed(names: Sequence[str]) -> Near:
    """A sentence that proposes these names."""
    return Near("near-one" if len(names) == 1 else "near-some", names, names)


def near(name: str, known: Iterable[str], listed: bool = False) -> Near:
    """A sentence: which of the known names may be meant, else what is known; ``listed`` says that besides, too."""
    names = [word for word in dict.fromkeys(known) if len(word) <= LONGEST]
    if likely := likeliest(name, names):
        if any(name != word and _narrow(name) == _narrow(word) for word in likely[:1]):
            return Near("near-wide", likely[:1], likely)
        if listed and len(likely) < len(names) <= LISTED:
            return Near("near-one-of" if len(likely) == 1 else "near-some-of", likely, likely, names[:LISTED])
        return proposed(likely)
    if len(names) > LISTED:
        return Near("near-many", names[:LISTED], (), more=len(names) - LISTED)
    return Near("near-none" if names else "near-nothing", names, ())


def _narrow(name: str) -> str:
    """A name with half-width letters."""
    return unicodedata.normalize("NFKC", name)


def likeliest(name: str, known: Sequence[str]) -> list[str]:
    """The known names that may be meant, the likeliest first: the same in another spelling, what it stands for
    elsewhere, names spelled much like it, longer and shorter forms of it; three at most."""
    from linkwright.expressions.synonyms import meant, plain

    own = plain(name)
    same = [word for word in known if plain(word) == own]
    if same:
        return same[:MOST]
    elsewhere = [word for word in meant(name) if word in known]
    longer = [word for word in known if _begins(own, plain(word))]
    found = [*elsewhere, *alike(name, known), *longer]
    found = found or [word for part in re.split("[-_ ]", name) for word in meant(part) if word in known]
    return [*dict.fromkeys(found)][:MOST]


def _begins(name: str, other: str) -> bool:
    """Whether one of two names is a shorter form of the other: of three letters at least, from its beginning."""
    short, long = sorted((name, other), key=len)
    return len(short) > 2 and long.startswith(short)


def alike(name: str, known: Sequence[str], cutoff: float | None = None) -> list[str]:
    """The known names that are spelled much like one, the closest first; three at most. ``cutoff`` is the share of both
    that must agree."""
    from linkwright.expressions.synonyms import plain

    own = plain(name)
    cutoff = cutoff or (ALIKE_SHORT if 2 <= len(own) <= 3 else ALIKE)
    words = [word for word in known if abs(len(word) - len(name)) <= 4][:200]
    ratios = {word: SequenceMatcher(None, own, plain(word)).ratio() for word in words}
    return sorted((word for word in ratios if ratios[word] >= cutoff), key=lambda word: -ratios[word])[:MOST]
