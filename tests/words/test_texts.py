"""Texts become words only where they are shown: their keys are there, they get the data they ask for, all are used."""

from __future__ import annotations

import re

from helpers.offenders import nobody_breaks
from words import source
from words.test_findings import OTHERS, WORDS, fields


def test_every_key_is_there() -> None:
    assert not {key for key, _ in source.spoken() if not any(re.fullmatch(key, known) for known in WORDS)}


def test_texts_get_the_data_that_they_ask_for() -> None:
    absent = {
        f"{key}, {number}": fields(WORDS[key]) - given
        for number, (pattern, given) in enumerate(source.spoken())
        if given is not None
        for key in WORDS
        if re.fullmatch(pattern, key)
    }
    assert len(absent) > 300
    nobody_breaks(absent)


def test_no_text_is_orphaned() -> None:
    bare = {key: key.removeprefix("term.") for key in OTHERS if not key.startswith("click.")}
    made = source.named({*bare, *bare.values()})
    assert {key for key, short in bare.items() if key not in made and short not in made} == set()


def test_what_the_source_says_is_found() -> None:
    """Both ways of naming a text are seen: at once, and as what becomes words later."""
    named = {key for key, _ in source.spoken()}
    assert {r"cli\.interrupted", r"accuracy\.failed", r"term\.gallery\-model", r"limits\.table\.ranges"} <= named
