"""The gallery in other languages: the same models line by line, but for comments, name, note and source."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from linkwright import gallery
from linkwright.model.yaml_text import read_text
from linkwright.words import LANGUAGES

FOLDER = Path(gallery.__file__).parent
OTHERS = [name for name in LANGUAGES if name != "en"]
CASES = [(language, name) for language in OTHERS for name in gallery.names()]
HOW_TO = Path(__file__).parents[2] / "docs" / "zh" / "how-to" / "start-from-the-gallery.md"
HANZI = re.compile("[\u4e00-\u9fff]")
TOLD = ("name", "note", "source")


def lines(text: str) -> list[tuple[str, bool]]:
    """The lines of a model without its texts: what stands before the comment, and whether there is one."""
    text = re.sub(r"^(name|note|source): .*\n(  .*\n)*", r"\1:\n", text, flags=re.M)
    pairs = (re.fullmatch(r"(.*?)(# .*)?", line) for line in text.splitlines())
    return [(pair[1], pair[2] is not None) for pair in pairs if pair]


@pytest.mark.parametrize("language", OTHERS)
def test_every_model_is_there_and_no_other(language: str) -> None:
    assert sorted(path.name for path in (FOLDER / language).iterdir()) == [f"{name}.yaml" for name in gallery.names()]


@pytest.mark.parametrize(("language", "name"), CASES)
def test_it_is_the_same_model_with_a_comment_for_each_comment(language: str, name: str) -> None:
    own, english = gallery.text(name, language), gallery.text(name)
    assert own != english
    assert lines(own) == lines(english)
    one, other = (read_text(text.encode()).data for text in (own, english))
    assert [*one] == [*other]
    assert {key: value for key, value in one.items() if key not in TOLD} == {
        key: value for key, value in other.items() if key not in TOLD
    }


@pytest.mark.parametrize("name", gallery.names())
def test_its_texts_are_chinese(name: str) -> None:
    text = gallery.text(name, "zh")
    data = read_text(text.encode()).data
    comments = [line.split("# ", 1)[1] for line in text.splitlines() if "# " in line]
    plain = [one for one in comments if not HANZI.search(one)]
    assert all(re.fullmatch(r"[\w .()+*/^-]+", one) for one in plain)  # formulas
    assert [key for key in TOLD if key in data and not HANZI.search(data[key])] == []
    assert 8 < len(gallery.title(name, "zh")) < 60
    assert gallery.title(name, "zh").endswith("。")
    assert len(data["note"]) > 40
    assert re.findall(r"[\u4e00-\u9fff][,;:!?]|[\u4e00-\u9fff][A-Za-z0-9]|[A-Za-z0-9][\u4e00-\u9fff]", text) == []


def test_a_language_without_models_has_the_english_ones() -> None:
    assert gallery.text("wiper", "fr") == gallery.text("wiper")


def test_the_how_to_lists_them_all() -> None:
    rows = re.findall(r"^\| `([a-z-]+)` \|", HOW_TO.read_text(encoding="utf-8"), re.M)
    assert sorted(rows) == gallery.names()
