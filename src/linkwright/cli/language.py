"""The language of a process, and click's own texts in it."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any

import click
from click import core, decorators, exceptions, formatting, parser, types

from linkwright.words import LANGUAGES, in_language, text, texts
from linkwright.words.en import click as english

_CHINESE = 0x04
"""The primary language of Windows' numbers of languages (LANG_CHINESE)."""

_VARIABLES = ("LC_ALL", "LC_MESSAGES", "LANG", "LANGUAGE")
"""The variables of the environment that name the language, the first one that is set counts."""


def requested_language(words: Sequence[str], environment: Mapping[str, str]) -> str:
    """The language that the command line asks for by ``--lang``, else the system's where there are texts in it."""
    for k, word in enumerate(words):
        name = words[k + 1] if word == "--lang" and k + 1 < len(words) else word.removeprefix("--lang=")
        if name in LANGUAGES and name != word:
            return name
    system = next((environment[name] for name in _VARIABLES if environment.get(name)), None)
    if system is None and sys.platform == "win32":
        import ctypes

        system = "zh" if ctypes.windll.kernel32.GetUserDefaultUILanguage() & 0x3FF == _CHINESE else "en"
    return next((name for name in LANGUAGES if (system or "").lower().startswith(name)), LANGUAGES[0])


def use_language(context: click.Context, _: click.Parameter, name: str | None) -> None:
    """Give texts in a language for the rest of a command."""
    if name is not None:
        context.with_resource(in_language(name))


@cache
def _keys() -> dict[str, str]:
    return {own: key for key, own in texts(english)}


def _translated(own: str) -> str:
    return text(_keys()[own]) if own in _keys() else own


def _counted(one: str, several: str, count: int) -> str:
    return _translated(one if count == 1 else several)


def install() -> None:
    """Let click take its texts, which it has by gettext's functions, from the catalogue."""
    modules: tuple[Any, ...] = (core, decorators, exceptions, formatting, parser, types)
    for module in modules:
        for name, function in (("_", _translated), ("ngettext", _counted)):
            if hasattr(module, name):
                setattr(module, name, function)


def process_language() -> str:
    """The language of this process."""
    return requested_language(sys.argv[1:], os.environ)
