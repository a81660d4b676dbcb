"""The catalogue of user-facing words, one module per language."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from importlib import import_module
from typing import Any

LANGUAGE = "en"


@lru_cache(maxsize=4)
def catalogue(language: str = LANGUAGE) -> dict[str, str]:
    """All texts of a language by key."""
    words: dict[str, str] = import_module(f"linkwright.words.{language}").WORDS
    return words


def add(language: str, texts: Mapping[str, str]) -> None:
    """Add texts of a kind of another package to a language; a key that is there already is an error."""
    if twice := catalogue(language).keys() & texts.keys():
        raise ValueError(f"texts that there are already: {sorted(twice)}")
    catalogue(language).update(texts)


def say(key: str, /, **data: Any) -> str:
    """The text of ``key`` with its data filled in. An unknown key is a programming error."""
    return catalogue(LANGUAGE)[key].format(**data)
