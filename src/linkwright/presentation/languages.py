"""A page in all languages: rendered in each, written in the present one with what the others say instead.

The pages of two languages have the same tags, and differ in texts and attributes alone. Where ``?lang=TAG`` stands
behind its address, the page's own script replaces these before anything else looks at them.
"""

from __future__ import annotations

import html
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

from linkwright.escape import markup
from linkwright.presentation.payload import script_json
from linkwright.words import LANGUAGES, in_language, language, say

_TAG = re.compile(r"<[^>]*>")
_ATTRIBUTE = re.compile(r'([\w:-]+)="([^"]*)"')

Replaced = Mapping[str, str | Sequence[str | None]]
"""By a text as it stands what is written instead: everywhere, or at each of its places in their order (``None``: it
stays)."""

SCRIPT = """
{
  const languages = JSON.parse(document.getElementById("languages").textContent);
  const tag = new URLSearchParams(location.search).get("lang");
  const other = languages.others[tag];
  const seen = new Map();
  // What stands for a text: one that is replaced at some of its places only has a list of them.
  const instead = (kind, texts, text) => {
    const found = Object.hasOwn(texts, text) ? texts[text] : undefined;
    if (!Array.isArray(found)) return found ?? null;
    const place = `${kind} ${text}`;
    seen.set(place, (seen.get(place) ?? -1) + 1);
    return found[seen.get(place)] ?? null;
  };
  if (other) {
    document.documentElement.lang = tag;
    document.title = other.title;
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (walker.nextNode()) {
      const node = walker.currentNode;
      const text = node.parentNode.localName === "script" ? null : instead("", other.texts, node.data);
      if (text !== null) node.data = text;
    }
    for (const [name, texts] of Object.entries(other.attributes))
      for (const element of document.body.querySelectorAll(`[${CSS.escape(name)}]`)) {
        const text = instead(name, texts, element.getAttribute(name));
        if (text !== null) element.setAttribute(name, text);
      }
  }
  globalThis.linkwrightWords = other ? other.words : languages.words;
  for (const link of document.querySelectorAll("nav.languages a"))
    if (link.lang === document.documentElement.lang) link.setAttribute("aria-current", "true");
  document.querySelector("nav.languages").hidden = false;
}
"""


def in_all_languages(title: object, body: Callable[[], str], words: Callable[[], Any]) -> str:
    """The body in the present language, below a choice of languages, with the script of the choice.

    ``title`` and what ``body`` gives become texts in the language of the moment. ``words`` are those of the page's
    other scripts, which find them as ``linkwrightWords``.
    """
    present, here = language(), body()
    others, choice = {}, []
    for name in LANGUAGES:
        with in_language(name):
            tag = say("language.tag")
            choice.append(f'<a href="?lang={tag}" lang="{tag}">{markup(say("language.name"))}</a>')
            if name != present:
                texts, attributes = replaced(here, body())
                more = {"title": str(title), "words": words(), "texts": texts, "attributes": attributes}
                others[tag] = more
    label = markup(say("language.choice"))
    data = script_json({"words": words(), "others": others})
    return (
        f'<nav class="languages screen" aria-label="{label}" hidden>{"".join(choice)}</nav>\n{here}\n'
        f'<script type="application/json" id="languages">{data}</script>\n<script>{SCRIPT}</script>'
    )


def replaced(here: str, there: str) -> tuple[Replaced, Mapping[str, Replaced]]:
    """The texts and, by name, the attributes in which a page differs from the same in another language.

    Raises ValueError where their tags differ.
    """
    tags, others = _TAG.findall(here), _TAG.findall(there)
    if [tag.split()[0] for tag in tags] != [tag.split()[0] for tag in others]:
        raise ValueError("the page has other tags in another language")
    texts = _instead(zip(_texts(here), _texts(there), strict=True))
    pairs: dict[str, list[tuple[str, str]]] = {}
    for one, other in zip(tags, others, strict=True):
        for (name, value), (_, instead) in zip(_ATTRIBUTE.findall(one), _ATTRIBUTE.findall(other), strict=True):
            pairs.setdefault(name, []).append((html.unescape(value), html.unescape(instead)))
    attributes = {name: found for name, some in pairs.items() if (found := _instead(some))}
    return texts, attributes


def _texts(page: str) -> Iterator[str]:
    return (html.unescape(text) for text in _TAG.split(page))


def _instead(pairs: Iterator[tuple[str, str]] | Sequence[tuple[str, str]]) -> Replaced:
    found: dict[str, list[str]] = {}
    for one, other in pairs:
        found.setdefault(one, []).append(other)
    return {
        one: others[0] if len({*others}) == 1 else [None if other == one else other for other in others]
        for one, others in found.items()
        if any(other != one for other in others)
    }
