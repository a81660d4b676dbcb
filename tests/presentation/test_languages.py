"""What a page says in another language: the differences, applied, make that page."""

from __future__ import annotations

import re
from collections.abc import Iterator
from html import escape
from itertools import count
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from linkwright.findings import Said
from linkwright.presentation.html_file import html_file
from linkwright.presentation.languages import Differences, Element, element, replacements, without_keys

TEXTS = st.sampled_from(["Value", "数值", "<b> & 'x'", "3.5", " ", "Time"])


def applied(here: str, there: str) -> str:
    """What the page's script makes of a page: elements that differ are replaced, then texts and attributes."""
    found = Differences(element(here), there)
    for place in sorted(found.inside, reverse=True):
        whole = next(one for one in every(element(here)) if one.tag[1] == place)
        here = here[: whole.inside[0]] + found.inside[place] + here[whole.inside[1] :]
    texts = replacements(found.texts)
    attributes = {name: replacements(pairs) for name, pairs in found.attributes.items()}
    return written(element(here), texts, attributes, {})


def every(one: Element) -> Iterator[Element]:
    yield one
    for part in one.elements:
        yield from every(part)


def written(one: Element, texts: Any, attributes: Any, seen: dict[Any, Iterator[int]]) -> str:
    def replaced(kind: str, some: Any, text: str) -> str:
        found = some.get(text, text)
        if isinstance(found, str):
            return found
        return found[next(seen.setdefault((kind, text), count()))] or text

    made = ""
    for k, text in enumerate(one.texts):
        made += escape(replaced("", texts, text))
        if k < len(one.elements):
            part = one.elements[k]
            own = "".join(
                f' {name}="{escape(replaced(name, attributes.get(name, {}), value))}"'
                for name, value in part.attributes
            )
            made += f"<{part.name}{own}>{written(part, texts, attributes, seen)}</{part.name}>"
    return made


@st.composite
def pages(draw: st.DrawFn, depth: int = 3) -> tuple[str, str]:
    """Two pages with the same elements, but for a few whose inside differs."""
    here = there = ""
    for _ in range(draw(st.integers(0, 3))):
        one, other = draw(TEXTS), draw(TEXTS)
        here, there = here + escape(one), there + escape(other)
        name = draw(st.sampled_from(["p", "g", "td"]))
        head, head2 = draw(TEXTS), draw(TEXTS)
        inside, inside2 = draw(pages(depth - 1)) if depth else ("", "")
        if draw(st.integers(0, 4)) == 0:
            inside2 += "<i>more</i>"
        here += f'<{name} data-head="{escape(head)}">{inside}</{name}>'
        there += f'<{name} data-head="{escape(head2)}">{inside2}</{name}>'
    return here, there


@given(pages())
def test_the_differences_make_the_other_page(pair: tuple[str, str]) -> None:
    here, there = pair
    assert applied(here, there) == there


def test_a_name_like_a_word_of_the_page_stays() -> None:
    """A link called Value below the head Value."""
    here = "<table><th>Value</th><td>Value</td></table>"
    there = "<table><th>数值</th><td>Value</td></table>"
    assert replacements(Differences(element(here), there).texts) == {"Value": ["数值", None]}
    assert applied(here, there) == there


def test_what_is_equal_isn_t_carried() -> None:
    page = '<p title="a">A name</p><p>1.5</p>'
    found = Differences(element(page), page)
    assert replacements(found.texts) == {} and found.inside == {}


def test_what_scripts_don_t_see_isn_t_counted() -> None:
    """To a page whose script runs, what is in <noscript> is one text."""
    here = "<noscript><p>Value</p></noscript><p>Value</p><b>Value</b>"
    there = "<noscript><p>数值</p></noscript><p>数值</p><b>Value</b>"
    assert replacements(Differences(element(here), there).texts) == {"Value": ["数值", None]}


def test_a_page_has_a_choice_of_all_languages() -> None:
    page = html_file(Said("cli.version"), lambda: "<p>1</p>")
    assert '<html lang="en">' in page
    assert re.findall(r'<a href="\?lang=([\w-]+)" lang="\1">(.*?)</a>', page) == [
        ("en", "English"),
        ("zh-CN", "简体中文"),
    ]


def test_markup_that_does_not_nest_is_an_error() -> None:
    with pytest.raises(IndexError):
        element("</p></p>")


def test_words_without_keys_have_the_order_in_which_scripts_sort() -> None:
    """Of UTF-16, in which rare letters stand before some others."""
    assert without_keys({"b": 1, "a": {"\uffee": 2, "\U00020000": (3, {"k": 4})}, "10": [5]}) == [[5], [[3, [4]], 2], 1]
