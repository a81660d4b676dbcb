"""A page in all languages: rendered in each, written in the present one with what the others say instead.

Two languages differ in texts and attributes; an element whose own elements differ (a title in two lines in place of
one) is replaced as a whole. Where ``?lang=TAG`` stands behind the address of a page, its own script
(``web/src/panels/languages.ts``) does all that before anything else looks at it.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import field
from typing import Any

from linkwright.data_classes import dataclass
from linkwright.escape import markup, unmarked
from linkwright.findings import Said
from linkwright.presentation.payload import data_block
from linkwright.words import LANGUAGES, in_language, language

_TAG = re.compile(r"<[^>]*>")
_ATTRIBUTE = re.compile(r'([\w:-]+)="([^"]*)"')

_ALONE = {"area", "br", "col", "hr", "img", "input", "link", "meta", "wbr"}
"""Elements without an end tag."""
UNSEEN = "noscript"
"""What is in it isn't on a page whose script translates it."""

Pairs = list[tuple[str, str]]
Replaced = Mapping[str, str | Sequence[str | None]]
"""By a text as it stands what is written instead: everywhere, or at each of its places in their order (``None``: it
stays)."""


@dataclass
class Element:
    """An element of a page: its name, its start tag and what is in it as places in the page, its attributes, the texts
    before, between and after its elements."""

    name: str
    tag: tuple[int, int]
    attributes: list[tuple[str, str]]
    inside: tuple[int, int] = (0, 0)
    texts: list[str] = field(default_factory=lambda: [""])
    elements: list[Element] = field(default_factory=list)


def element(page: str) -> Element:
    """The body of a page as an element: well-formed markup, as our own is."""
    root = Element("body", (0, 0), [], (0, len(page)))
    opened, last = [root], 0
    for found in _TAG.finditer(page):
        opened[-1].texts[-1] += unmarked(page[last : found.start()])
        last, text = found.end(), found[0]
        if text.startswith("</"):
            done = opened.pop()
            done.inside = (done.inside[0], found.start())
            continue
        name = text.strip("</>").split()[0]
        attributes = [(key, unmarked(value)) for key, value in _ATTRIBUTE.findall(text)]
        made = Element(name, found.span(), attributes, (found.end(), found.end()))
        opened[-1].elements.append(made)
        opened[-1].texts.append("")
        if name not in _ALONE and not text.endswith("/>"):
            opened.append(made)
    root.texts[-1] += unmarked(page[last:])
    return root


@dataclass
class Differences:
    """In what a page (``here``, its body as an element) differs from the same in another language (``there``): pairs of
    texts, pairs of attributes by name, and what is inside elements that differ, by the place of their start tag's end.
    """

    here: Element
    there: str
    texts: Pairs = field(default_factory=list)
    attributes: dict[str, Pairs] = field(default_factory=dict)
    inside: dict[int, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self._compare(self.here, element(self.there))

    def _compare(self, one: Element, other: Element) -> None:
        for (name, value), (_, translated) in zip(one.attributes, other.attributes, strict=True):
            self.attributes.setdefault(name, []).append((value, translated))
        if [part.name for part in one.elements] != [part.name for part in other.elements]:
            self.inside[one.tag[1]] = self.there[slice(*other.inside)]
            one = other  # from here on, this is what stands there
        for k, pair in enumerate(zip(one.texts, other.texts, strict=True)):
            self.texts.append(pair)
            if k < len(one.elements) and one.elements[k].name != UNSEEN:
                self._compare(one.elements[k], other.elements[k])


def in_all_languages(title: object, body: Callable[[], str], words: Callable[[], Any]) -> str:
    """The body in the present language, below a choice of languages, with what the script of the choice reads.

    ``title`` and what ``body`` gives become texts in the language of the moment. ``words`` are those of the page's
    other scripts, which find them as ``linkwrightWords``.
    """
    present, here = language(), body()
    others, choice, places, parsed = {}, [], set[int](), element(here)
    for name in LANGUAGES:
        with in_language(name):
            tag = str(Said("language.tag"))
            choice.append(f'<a href="?lang={tag}" lang="{tag}">{markup(Said("language.name"))}</a>')
            if name != present:
                found = Differences(parsed, body())
                others[tag] = {
                    "title": str(title),
                    "choice": str(Said("language.choice")),
                    "words": without_keys(words()),
                    "texts": replacements(found.texts),
                    "attributes": {
                        key: some for key, pairs in found.attributes.items() if (some := replacements(pairs))
                    },
                    "inside": found.inside,
                }
                places |= found.inside.keys()
    for place in sorted(places, reverse=True):
        here = f'{here[: place - 1]} data-place="{place}"{here[place - 1 :]}'
    label = markup(Said("language.choice"))
    nav = f'<nav class="languages screen" aria-label="{label}" hidden>{"".join(choice)}</nav>'
    return f"{nav}\n{here}\n{data_block('languages', {'words': words(), 'others': others})}"


def without_keys(value: Any) -> Any:
    """Plain data whose mappings are lists of their values, in the order of the keys as scripts sort them (UTF-16)."""
    if isinstance(value, Mapping):
        return [without_keys(value[key]) for key in sorted(value, key=lambda key: str(key).encode("utf-16-be"))]
    return [without_keys(one) for one in value] if isinstance(value, list | tuple) else value


def replacements(pairs: Pairs) -> Replaced:
    """What is written in place of texts, from pairs of what stands there and what would in another language."""
    found: dict[str, list[str]] = {}
    for one, other in pairs:
        found.setdefault(one, []).append(other)
    return {
        one: others[0] if len({*others}) == 1 else [None if other == one else other for other in others]
        for one, others in found.items()
        if any(other != one for other in others)
    }
