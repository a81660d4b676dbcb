"""Text of pages in which no line begins with the unit of a figure that ends the line before it."""

from __future__ import annotations

import re

from linkwright.escape import markup
from linkwright.expressions.units import is_unit

_BESIDE = re.compile(r"(?<=\d) (?=(?:1/)?(%|[^\W\d_]+[²³⁴]?(?:[·/][^\W\d_]+[²³⁴]?)*)(?!\w))")
_FACTORS = re.compile(r"[^·/²³⁴]+")
TOGETHER = "\u00a0"
"""A space at which no line ends."""


def prose(text: object) -> str:
    """Text as markup, a figure and its unit in one line."""
    return _BESIDE.sub(_space, markup(text))


def _space(found: re.Match[str]) -> str:
    return TOGETHER if all(map(is_unit, _FACTORS.findall(found[1]))) else " "
