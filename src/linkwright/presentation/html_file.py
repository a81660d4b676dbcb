"""The frame of all pages: one HTML file that needs nothing else and loads nothing."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from importlib.resources import files
from typing import Any

from linkwright import _version
from linkwright.escape import markup
from linkwright.findings import Said
from linkwright.presentation.languages import in_all_languages
from linkwright.presentation.payload import data_block
from linkwright.presentation.scripts import built, element, policy


def html_file(
    title: object,
    body: Callable[[], str],
    *,
    data: Mapping[str, object] | None = None,
    scripts: Sequence[str] = (),
    words: Callable[[], Any] = dict,
    style: str = "",
    before: str = "",
    kind: str = "",
) -> str:
    """The text of an HTML file (UTF-8) with the style of all pages, in all languages, the present one first.

    ``title`` becomes plain text and ``body`` gives markup in the language of the moment. ``scripts`` are those that
    follow, the only ones that run beside the choice of languages; they find ``data`` in elements of these ids, and
    ``words`` as ``linkwrightWords``. ``style`` stands after the common one, ``before`` before it; ``kind`` is the
    body's class.
    """
    scripts = (built(__package__, "assets/languages.js"), *scripts)
    blocks = [*(data_block(name, value) for name, value in (data or {}).items()), *map(element, scripts)]
    lines = "\n".join(blocks)
    of_kind = f' class="{kind}"' if kind else ""
    return f"""<!DOCTYPE html>
<html lang="{Said("language.tag")}">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{policy(scripts)}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="generator" content="linkwright {markup(_version.__version__)}">
<link rel="icon" href="data:,">
<title>{markup(title)}</title>
<style>
{before}{compact_css(asset(__package__, "page.css") + style)}
</style>
</head>
<body{of_kind}>
{in_all_languages(title, body, words)}
{lines}
</body>
</html>
"""


_COMMENT = re.compile(r"/\*.*?\*/", re.S)


def compact_css(text: str) -> str:
    """A style sheet without comments and the spaces that don't count."""
    text = " ".join(_COMMENT.sub("", text).split())
    for mark in "{};,":
        text = text.replace(f" {mark}", mark).replace(f"{mark} ", mark)
    return text.replace(";}", "}").replace(": ", ":")


def asset(package: str, name: str) -> str:
    """The text of a file of a package that pages are made of."""
    return files(package).joinpath("assets", name).read_text("utf-8")
