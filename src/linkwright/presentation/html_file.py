"""The frame of all pages: one HTML file that needs nothing else and loads nothing."""

from __future__ import annotations

from collections.abc import Callable
from importlib.resources import files
from typing import Any

from linkwright import _version
from linkwright.escape import markup
from linkwright.findings import Said
from linkwright.presentation.languages import in_all_languages

# The browser itself is told to load nothing, so that the file stays self-contained whatever is put into it.
POLICY = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:"


def html_file(
    title: object,
    body: Callable[[], str],
    *,
    scripts: str = "",
    words: Callable[[], Any] = dict,
    style: str = "",
    before: str = "",
    kind: str = "",
) -> str:
    """The text of an HTML file (UTF-8) with the style of all pages, in all languages, the present one first.

    ``title`` becomes plain text and ``body`` gives markup in the language of the moment; ``scripts`` is markup that
    follows, and finds ``words`` as ``linkwrightWords``. ``style`` stands after the common one, ``before`` before it;
    ``kind`` is the body's class.
    """
    of_kind = f' class="{kind}"' if kind else ""
    return f"""<!DOCTYPE html>
<html lang="{Said("language.tag")}">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{POLICY}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="generator" content="linkwright {markup(_version.__version__)}">
<link rel="icon" href="data:,">
<title>{markup(title)}</title>
<style>
{before}{asset(__package__, "page.css")}{style}
</style>
</head>
<body{of_kind}>
{in_all_languages(title, body, words)}
{scripts}
</body>
</html>
"""


def asset(package: str, name: str) -> str:
    """The text of a file of a package that pages are made of."""
    return files(package).joinpath("assets", name).read_text("utf-8")
