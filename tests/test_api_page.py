"""docs/api.md lists the public names as they are: each has its section, with the arguments that it takes."""

from __future__ import annotations

import dataclasses
import inspect
import re
from pathlib import Path

import pytest

import linkwright

PAGE = (Path(__file__).parents[1] / "docs" / "api.md").read_text(encoding="utf-8")
SECTIONS = dict(re.findall(r"^### `lw\.(\w+)(.*)`$", PAGE, re.M))
"""The sections by name, each with what follows the name in its title."""


def test_every_public_name_has_its_section_and_no_other_has_one() -> None:
    assert sorted(SECTIONS) == sorted(linkwright.__all__)


@pytest.mark.parametrize("name", [name for name, title in SECTIONS.items() if title])
def test_the_arguments_are_those_of_the_title(name: str) -> None:
    parameters = [*inspect.signature(getattr(linkwright, name)).parameters.values()]
    texts = (re.sub(r":.*?(?= = |$)", "", str(one), flags=re.S) for one in parameters)
    shown = [text.replace(" = ", "=").replace("'", '"') for text in texts]
    keyword = next((i for i, one in enumerate(parameters) if one.kind is one.KEYWORD_ONLY), None)
    if keyword is not None:
        shown.insert(keyword, "*")
    assert SECTIONS[name].split(" -> ")[0] == f"({', '.join(shown)})"


def test_the_page_names_every_study_s_outcome() -> None:
    section = PAGE.split("### `lw.Job`")[1].split("\n## ")[0]
    named = set(re.findall(r"^\| `(\w+)` \|", section, re.M))
    own = {name for name, of in vars(linkwright.Job).items() if isinstance(of, property)}
    assert own <= named and {field.name for field in dataclasses.fields(linkwright.Job)} - named <= {
        "examined",
        "stopped",
        "outdated",
    }
