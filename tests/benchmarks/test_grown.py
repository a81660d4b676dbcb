"""Grown mechanisms have the whole vocabulary of model files, in all sizes, and most of them run as they are drawn."""

from __future__ import annotations

import random
from collections import Counter
from typing import Any

import grown
import pytest

from linkwright.elements.kind_modules import KIND_MODULES, Listed
from linkwright.model.desugar import spell_out
from linkwright.model.document import parse_document
from linkwright.structure import Group, HigherGroup, decompose

FILES = 600


@pytest.fixture(scope="module")
def files() -> list[dict[str, Any]]:
    return [grown.mechanism(random.Random(f"file {seed}")) for seed in range(FILES)]


def test_every_word_has_a_grower() -> None:
    assert grown.missing() == set()


def test_a_new_kind_without_a_grower_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(KIND_MODULES, "ratchet", Listed("joint", "ratchet", "joints"))
    assert grown.missing() == {"ratchet"}


def test_every_word_is_in_files(files: list[dict[str, Any]]) -> None:
    there = Counter(word for data in files for word in grown.words_of(data))
    structural = {word for word in grown.vocabulary() if word.partition("_")[0] in ("floating", "prescribed")}
    structural |= {word for word in grown.vocabulary() if word.startswith("dyad.")}
    assert sorted(word for word in grown.vocabulary() - structural if not there[word]) == []


def test_every_group_is_in_files(files: list[dict[str, Any]]) -> None:
    """Dyads by their signatures, coordinates of links that float, drives that act at no joint."""
    found: Counter[str] = Counter()
    for data in files[:250]:
        if len(data["links"]) > 12:
            continue
        document = parse_document(data)
        assert document is not None
        structure = decompose(spell_out(document).mechanism)
        for step in structure.steps:
            if isinstance(step, Group):
                found[f"dyad.{step.signature}"] += 1
            elif isinstance(step, HigherGroup):
                joints = (*(edge.joint for edge in step.edges), *step.closures)
                found.update(joint.kind.name for joint in joints)
    wanted = {word for word in grown.vocabulary() if word.startswith(("dyad.", "floating_", "prescribed_"))}
    assert {word for word in wanted if not found[word]} == set()


def test_mechanisms_have_three_to_sixty_links() -> None:
    sizes = [grown.grown(random.Random(f"file {seed}"))[0].size() for seed in range(FILES)]
    least, most = grown.LINKS
    assert min(sizes) == least and most - 20 < max(sizes) <= most


def test_mechanisms_come_again_by_their_seed() -> None:
    again = [grown.mechanism(random.Random("file 7")) for _ in range(2)]
    assert again[0] == again[1]
