"""Texts become words only where they are shown: their keys are there, they get the data they ask for, all are used."""

from __future__ import annotations

import re

from words import source
from words.test_findings import OTHERS, WORDS, fields


def test_every_key_is_there() -> None:
    assert not {key for key, _ in source.spoken() if not any(re.fullmatch(key, known) for known in WORDS)}


def test_texts_get_the_data_that_they_ask_for() -> None:
    seen = 0
    for pattern, given in source.spoken():
        if given is not None:
            (key,) = (known for known in WORDS if re.fullmatch(pattern, known))
            assert fields(WORDS[key]) <= given, f"{key}: {fields(WORDS[key]) - given} not given"
            seen += 1
    assert seen > 300


def test_no_text_is_orphaned() -> None:
    made = source.keys()
    assert {
        key
        for key in OTHERS
        if not key.startswith("click.") and not made.fullmatch(key) and not made.fullmatch(key.removeprefix("term."))
    } == set()


def test_what_the_source_says_is_found() -> None:
    """Both ways of naming a text are seen: at once, and as what becomes words later."""
    named = {key for key, _ in source.spoken()}
    assert {r"cli\.interrupted", r"accuracy\.failed", r"term\.gallery\-model", r"limits\.table\.ranges"} <= named
