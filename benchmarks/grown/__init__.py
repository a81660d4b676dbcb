"""Random mechanisms grown over the whole vocabulary of model files, for the fuzzer.

``mechanism`` gives one, ``vocabulary`` the words that growers cover: every kind of joint, follower and force, every
dyad, motion law, reduction, study, way to drive, section of the file.
"""

from __future__ import annotations

import random

from grown import acting, groups, laws, sketching, studies, wheels  # noqa: F401  (each registers its growers)
from grown.acting import masses
from grown.plane import GROWERS, Data, Grower, Growing, at_stage
from grown.vocabulary import missing, vocabulary, words_of

LINKS = 3, 60
"""The fewest and the most moving links."""
LARGEST = 6
"""The most links that one grower adds."""
STANDING = [GROWERS[name] for name in ("rrr", "rrr", "rrp", "rpr", "prp", "rpp", "large_group", "in_slot")]
"""What structures that stand are made of."""


def mechanism(random_: random.Random) -> Data:
    """A random mechanism that is assembled as drawn, as data of a model file."""
    return grown(random_)[1]


def grown(random_: random.Random) -> tuple[Growing, Data]:
    """The same with what it was made of."""
    g = Growing(random_)
    standing = random_.random() < 0.03
    most = min(size(random_), 9) if standing else size(random_)
    if not standing:
        _stage(g, "drives", random_.choice((1, 1, 1, 2)))
    while g.size() < most:
        _grow(g, STANDING[random_.randrange(len(STANDING))] if standing else chosen(g, "groups"))
    for _ in range(random_.choice((0, 1, 2, 3))):
        _grow(g, chosen(g, "acting"))
    if standing:
        g.data.pop("friction", None)
    if random_.random() < 0.7:
        masses(g)
    _stage(g, "measures", 0 if standing else random_.choice((0, 1, 2, 4)))
    links = sketching.links(g)
    if standing:
        g.section("studies")["reactions"] = {}
    else:
        _grow(g, GROWERS["cycle"])
        _stage(g, "studies", random_.choice((0, 0, 0, 0, 1, 1)))
    return g, g.written(links)


def _stage(g: Growing, stage: str, count: int) -> None:
    for _ in range(count):
        _grow(g, chosen(g, stage))


def _grow(g: Growing, grower: Grower) -> None:
    grower.grow(g)


def size(random_: random.Random) -> int:
    """The number of moving links: a few in most mechanisms."""
    least, most = LINKS[0], LINKS[1] - LARGEST
    return round(least * (most / least) ** (random_.random() ** 2.8))


def chosen(g: Growing, stage: str) -> Grower:
    """One of a stage, by the weights."""
    there = [*at_stage(stage)]
    return g.random.choices(there, [grower.weight for grower in there])[0]


__all__ = ["GROWERS", "LINKS", "mechanism", "missing", "vocabulary", "words_of"]
