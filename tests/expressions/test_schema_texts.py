"""Descriptions in schemas: the catalogue's, by the class that declares a key; those of other packages stay."""

from __future__ import annotations

from typing import Annotated

import pytest
from pydantic import BaseModel, Field

from linkwright import words
from linkwright.expressions.schema_texts import Described, described, description
from linkwright.words import in_language


class BaseOptions(BaseModel):
    """Options."""

    size: int = 3
    plain: int = Field(4, description="own text")


class FurtherOptions(BaseOptions):
    """Further options."""

    in_: Annotated[str, Described("FurtherOptions.in")] | None = Field(None, alias="in")


@pytest.fixture
def texts(monkeypatch: pytest.MonkeyPatch) -> None:
    """A catalogue of both languages with a few texts only."""
    english = {
        "schema.FurtherOptions": "Both.",
        "schema.BaseOptions.size": "its size",
        "schema.FurtherOptions.in": "{{a}}",
    }
    catalogues = {"en": english, "zh": {key: text + "。" for key, text in english.items()}}
    monkeypatch.setattr(words, "_catalogue", catalogues.__getitem__)


@pytest.mark.usefixtures("texts")
@pytest.mark.parametrize(("language", "end"), [("en", ""), ("zh", "。")])
def test_texts_come_from_the_catalogue_in_the_present_language(language: str, end: str) -> None:
    with in_language(language):
        schema = described(FurtherOptions)
    assert schema["description"] == "Both." + end
    assert {key: entry["description"] for key, entry in schema["properties"].items()} == {
        "size": "its size" + end,
        "plain": "own text",
        "in": "{a}" + end,
    }
    assert described(BaseOptions)["description"] == "Options."


def test_a_text_that_is_not_there() -> None:
    assert description("Nothing.at") == {}
    assert described(BaseOptions)["properties"]["plain"]["description"] == "own text"
