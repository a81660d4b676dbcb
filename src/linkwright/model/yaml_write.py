"""Plain data to YAML text, laid out as model files are written by hand."""

from __future__ import annotations

import io
import re
from collections.abc import Mapping
from typing import Any

from linkwright.model.yaml_text import scalar

WIDTH = 110

# What can stand without quotes in any place; ruamel would let more stand than every reader takes.
_PLAIN = re.compile(r"(?:[-+.]?[\w(])[\w .()+*/^<>='%°-]*")


def write_text(data: Mapping[str, Any]) -> str:
    """Plain data as YAML: one entry of a section a line where it fits, quotes where they are needed."""
    from ruamel.yaml import YAML
    from ruamel.yaml.comments import CommentedMap

    yaml = YAML(typ="rt", pure=True)
    yaml.width = 1 << 20
    yaml.allow_unicode = True
    laid_out = {_text(key): _laid_out(value, len(key), top=True) for key, value in data.items()}
    stream = io.StringIO()
    yaml.dump(CommentedMap(laid_out), stream)
    return stream.getvalue()


def _laid_out(value: Any, indent: int, top: bool = False) -> Any:
    """Collections in one line where they fit; a section of mappings takes a line for each."""
    from ruamel.yaml.comments import CommentedMap, CommentedSeq

    if not isinstance(value, dict | list):
        return _text(value)
    many = top and isinstance(value, dict) and any(isinstance(entry, dict) for entry in value.values())
    flat = indent + _length(value) <= WIDTH and not many
    step = 0 if flat else 4
    if isinstance(value, dict):
        entries = {_text(k): _laid_out(v, 0 if flat else indent + len(k) + step) for k, v in value.items()}
        made: Any = CommentedMap(entries)
    else:
        made = CommentedSeq([_laid_out(entry, 0 if flat else indent + step) for entry in value])
    if flat or not value:
        made.fa.set_flow_style()
    return made


def _text(value: Any) -> Any:
    """A scalar; a text in double quotes unless it reads as the same text without."""
    from ruamel.yaml.scalarstring import DoubleQuotedScalarString

    if not isinstance(value, str):
        return value
    plain = _PLAIN.fullmatch(value) and not value.endswith(" ") and scalar(value) is value
    return value if plain else DoubleQuotedScalarString(value)


def _length(value: Any) -> int:
    """About how many characters a value takes in one line."""
    if isinstance(value, dict):
        return sum(len(key) + 4 + _length(entry) for key, entry in value.items()) + 2
    if isinstance(value, list):
        return sum(2 + _length(entry) for entry in value) + 2
    return len(str(value))
