"""Text on its way out: one function for each kind of place in which it may stand.

A mechanism's name, a column's head, a file's name or an argument may hold anything. Here it becomes text that stays
text there: it can't end a comment, begin a formula or steer a terminal. What has no shape of its own (control
characters, marks that turn the direction of writing) is written as its code, such as ``\\x1b``.
"""

from __future__ import annotations

import html
import re

_CONTROLS = r"\x00-\x08\x0b-\x1f\x7f-\x9f\u2028\u2029\u202a-\u202e\u2066-\u2069\ud800-\udfff\ufffe\uffff"
_UNSEEN = re.compile(f"[{_CONTROLS}]")
_LINE_ENDS = re.compile(r"[\t\n\v\f\r\x1c-\x1f\x85\u2028\u2029]+")
_NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")
_FORMULA = ("=", "+", "-", "@", "\uff1d", "\uff0b", "\uff0d", "\uff20")
_NOT_NC = re.compile(r"[^A-Za-z0-9 .,:=+/*'_\[\]-]")
_NC_ACTIVE = re.compile(r"(?=(MSG|DEBUG|PRINT|LOG\w*|PROBE\w*|PY|PYTHON|AXIS|ABORT)\b)", re.IGNORECASE)
_NO_LAYER = re.compile(r"""[<>/\\":;?*|=`,']""")
LAYER = 200
"""The most letters of a layer's name."""


def visible(text: str) -> str:
    """Text of several lines: what can't be seen is written as its code."""
    return _UNSEEN.sub(lambda found: _code(found[0]), text.replace("\r\n", "\n"))


def _code(letter: str) -> str:
    number = ord(letter)
    return f"\\x{number:02x}" if number < 0x100 else f"\\u{number:04x}"


def line(text: str) -> str:
    """Text in one line: a title, or what follows ``//`` or ``#`` to the end of the line."""
    return visible(_LINE_ENDS.sub(" ", text)).strip()


def markup(text: object) -> str:
    """Text in HTML, SVG or XML, in an element or an attribute; of what isn't a text yet, its words."""
    return html.escape(visible(str(text)))


def unmarked(text: str) -> str:
    """The text that stands in markup."""
    return html.unescape(text)


def json_text(text: str) -> str:
    """The text of a JSON file: the same values, with nothing in it that can't be seen."""
    return _UNSEEN.sub(lambda found: f"\\u{ord(found[0]):04x}", text)


def script(text: str) -> str:
    """The text of JSON within a script of a page: no ``<``, hence no ``</script`` and no ``<!--``."""
    return json_text(text).replace("<", "\\u003c")


def cell(text: str) -> str:
    """A cell of a table, in one line: a number as it is; what a spreadsheet would take for a formula has an apostrophe
    before it."""
    if _NUMBER.fullmatch(text):
        return text
    text = visible(_LINE_ENDS.sub(" ", text))
    return f"'{text}" if text.startswith(_FORMULA) else text


def csharp(text: str) -> str:
    """The inside of a string in C#, between double quotes."""
    return "".join(f"\\u{ord(c):04x}" if c in '"\\' or _UNSEEN.match(c) or c in "\t\n" else c for c in text)


def nc(text: str) -> str:
    """A comment of NC code: in letters that no control takes for the end of the comment, for a command of its own (such
    as ``!`` and ``~``, which Grbl obeys wherever they stand) or for an active comment (``LOG,...``)."""
    plain = _NOT_NC.sub("_", line(text).replace("(", "[").replace(")", "]"))
    return f"_{plain}" if _NC_ACTIVE.match(plain) else plain


def layer_name(text: str) -> str:
    """The name of a layer of a DXF drawing."""
    return " ".join(_NO_LAYER.sub("-", line(text)).split())[:LAYER]


def printed(text: str) -> str:
    """A unit as it is set in print: ``mm/s^2`` as mm/s², ``N*m`` as N·m."""
    for typed, letters in (("**", "^"), ("*", "·"), ("^2", "²"), ("^3", "³"), ("^4", "⁴")):
        text = text.replace(typed, letters)
    return text
