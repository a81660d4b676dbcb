"""The catalogue of user-facing texts: one package per language, of modules with the same names and keys.

A module gives ``TEXTS``, texts by key; ``PROBLEMS``, by the code of a problem its description and suggested fix
(``CODE.what``, ``CODE.mend``); or ``TERMS``, phrases that are inserted into other texts (``term.NAME``).
"""

from __future__ import annotations

import pkgutil
import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from functools import cache
from importlib import import_module
from string import Formatter
from types import ModuleType
from typing import Any

LANGUAGES = ("en", "zh")
USUAL = (
    "language",
    "click",
    "texts",
    "report",
    "number_names",
    "findings.expressions",
    "findings.motion",
    "findings.terms",
)
"""The modules with what nearly every command says; the others are imported where another text is asked for."""
_LANGUAGE = ContextVar("language", default=LANGUAGES[0])


def language() -> str:
    """The language in which texts are given now, such as ``en``."""
    return _LANGUAGE.get()


@contextmanager
def in_language(name: str) -> Iterator[None]:
    """Give texts in one of the :data:`LANGUAGES` for a while. ValueError for another."""
    if name not in LANGUAGES:
        raise ValueError(f"not one of {LANGUAGES}: {name}")
    token = _LANGUAGE.set(name)
    try:
        yield
    finally:
        _LANGUAGE.reset(token)


def modules(name: str) -> Iterator[ModuleType]:
    """The modules of a language that hold texts."""
    package = import_module(f"linkwright.words.{name}")
    for module in pkgutil.walk_packages(package.__path__, f"{package.__name__}."):
        if not module.ispkg:
            yield import_module(module.name)


def texts(module: ModuleType) -> Iterator[tuple[str, str]]:
    """The texts of a module by key."""
    yield from getattr(module, "TEXTS", {}).items()
    for code, (what, mend) in getattr(module, "PROBLEMS", {}).items():
        yield f"{code}.what", what
        yield f"{code}.mend", mend
    for term, text in getattr(module, "TERMS", {}).items():
        yield f"term.{term}", text


def catalogue(name: str | None = None) -> dict[str, str]:
    """All texts by key, of a language or of the present one."""
    return _catalogue(name or language())


@cache
def _begun(name: str) -> dict[str, str]:
    """The usual texts, to which the others are added when one of them is asked for."""
    return dict(pair for module in USUAL for pair in texts(import_module(f"linkwright.words.{name}.{module}")))


@cache
def _catalogue(name: str) -> dict[str, str]:
    begun = _begun(name)
    begun.update(pair for module in modules(name) for pair in texts(module))
    return begun


def _find(key: str, name: str) -> str | None:
    """The text of ``key`` in a language, if there is one."""
    begun = _begun(name)
    return begun[key] if key in begun else catalogue(name).get(key)


def known(key: str) -> bool:
    """Whether the catalogue has a text of ``key``."""
    return _find(key, LANGUAGES[0]) is not None


def add(name: str, more: Mapping[str, str]) -> None:
    """Add texts of a kind of another package to a language; a key that is there already with another text is an error.
    The same text comes again where the import of that package was interrupted."""
    known = catalogue(name)
    if twice := {key for key in known.keys() & more.keys() if known[key] != more[key]}:
        raise ValueError(f"texts that there are already: {sorted(twice)}")
    known.update(more)


def text(key: str) -> str:
    """The text of ``key`` in the present language; in the first one where a kind of another package has no other. An
    unknown key is a programming error."""
    found = _find(key, language())
    return catalogue(LANGUAGES[0])[key] if found is None else found


def filled(pattern: str, data: Mapping[str, Any]) -> str:
    """A text with its data filled in. Spaces set data of Latin letters and digits off from hanzi; where the data begin
    or end with hanzi themselves, such as names of a Chinese file, there are none."""
    made = pattern.format_map(data)
    return _without_spaces(pattern, data) if _BETWEEN_HANZI.search(made) else made


_HANZI = "[\u2e80-\u9fff\uf900-\uffef]"
_BETWEEN_HANZI = re.compile(f"{_HANZI} {_HANZI}")


def _without_spaces(pattern: str, data: Mapping[str, Any]) -> str:
    """The same without the pattern's spaces between hanzi and data; spaces within data are their own."""
    made, own = "", False  # what is made, and whether its last letter is the pattern's
    for words, name, spec, conversion in Formatter().parse(pattern):
        ended = words[:1] == " " and _BETWEEN_HANZI.fullmatch(made[-1:] + words[:2])
        made += words[1:] if ended else words
        own = bool(words) or own
        if name is None:
            continue
        field = "{" + name + (f"!{conversion}" if conversion else "") + (f":{spec}" if spec else "") + "}"
        value = field.format_map(data)
        begun = own and made[-1:] == " " and _BETWEEN_HANZI.fullmatch(made[-2:] + value[:1])
        made, own = (made[:-1] if begun else made) + value, False
    return made


def say(key: str, /, **data: Any) -> str:
    """The text of ``key`` with its data filled in."""
    return filled(text(key), data)
