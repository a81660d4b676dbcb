"""YAML text to plain data with line numbers, and back. Nothing in it is executed and no alias expands."""

from __future__ import annotations

import io
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from linkwright.model.findings import Finding

MAX_BYTES = 1_000_000
MAX_DEPTH = 24
MAX_FINDINGS = 50

Path = tuple[str | int, ...]

_INT = re.compile(r"^[-+]?\d+$")
_FLOAT = re.compile(r"^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$")
_CONSTANTS = {"": None, "~": None, "null": None, "true": True, "false": False}
_NOT_NUMBERS = {".nan", ".inf", "-.inf", "+.inf", "nan", "inf", "-inf"}


@dataclass
class Source:
    """What a file holds: its data, the line of each entry, and what is wrong with its text."""

    data: Any = None
    lines: dict[Path, int] = field(default_factory=dict)
    findings: list[Finding] = field(default_factory=list)

    def line(self, path: Path) -> int | None:
        """The line of an entry, or of the nearest one around it."""
        while path and path not in self.lines:
            path = path[:-1]
        return self.lines.get(path)


def read_text(raw: bytes) -> Source:
    """Read a model file's bytes; every fault of the text becomes a finding."""
    source = Source()
    if len(raw) > MAX_BYTES:
        source.findings.append(Finding("file.too-large", data={"size": len(raw), "limit": MAX_BYTES}))
        return source
    try:
        text = raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        source.findings.append(Finding("file.binary", data={"at": error.start}))
        return source
    if bad := re.search(r"[^\t\n\r\x20-\x7e\x85\xa0-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]", text):
        source.findings.append(Finding("file.binary", data={"at": bad.start()}, line=text.count("\n", 0, bad.start()) + 1))
        return source
    _Builder(source).build(text)
    return source


class _Stop(Exception):
    """The text can't be read further; the finding is noted."""


class _Builder:
    """Builds plain data from YAML events; refuses aliases, tags, duplicate keys and deep nesting."""

    def __init__(self, source: Source) -> None:
        self.source = source

    def build(self, text: str) -> None:
        from ruamel.yaml import YAML
        from ruamel.yaml.error import MarkedYAMLError, YAMLError

        try:
            self.events = iter(YAML(typ="safe", pure=True).parse(io.StringIO(text)))
            event = self.next()
            while type(event).__name__ in ("StreamStartEvent", "DocumentStartEvent"):
                event = self.next()
            if type(event).__name__ == "StreamEndEvent":
                self.note("file.empty", 1)
                return
            self.source.data = self.value(event, ())
            self.next()
            if type(self.next()).__name__ != "StreamEndEvent":
                self.note("file.documents", None)
        except _Stop:
            self.source.data = None
        except MarkedYAMLError as error:
            mark = error.problem_mark or error.context_mark
            line = mark.line + 1 if mark else None
            self.source.data = None
            self.note("file.yaml", line, reason=" ".join(str(error.problem or error.context).split()))
        except (YAMLError, ValueError, RecursionError) as error:
            self.source.data = None
            self.note("file.yaml", None, reason=" ".join(str(error).split())[:200])

    def next(self) -> Any:
        return next(self.events)

    def note(self, code: str, line: int | None, path: Path = (), **data: Any) -> None:
        self.source.findings.append(Finding(code, path, data, line))

    def value(self, event: Any, path: Path) -> Any:
        line = event.start_mark.line + 1
        self.source.lines.setdefault(path, line)
        kind = type(event).__name__
        if kind == "AliasEvent" or getattr(event, "anchor", None):
            self.note("file.alias", line, path)
            raise _Stop
        if len(path) > MAX_DEPTH:
            self.note("file.depth", line, path[:4], limit=MAX_DEPTH)
            raise _Stop
        if getattr(event, "tag", None) is not None and str(event.tag) not in ("!", "None"):
            self.note("file.tag", line, path, tag=str(event.tag))
            raise _Stop
        if kind == "ScalarEvent":
            return event.value if event.style in ("'", '"', "|", ">") else self.scalar(event.value, line, path)
        return self.mapping(path) if kind == "MappingStartEvent" else self.sequence(path)

    def mapping(self, path: Path) -> dict[str, Any]:
        data: dict[str, Any] = {}
        while type(event := self.next()).__name__ != "MappingEndEvent":
            line = event.start_mark.line + 1
            if type(event).__name__ != "ScalarEvent":
                code = "file.alias" if type(event).__name__ == "AliasEvent" else "file.key"
                self.note(code, line, path)
                raise _Stop
            key = str(event.value)
            if key in data:
                self.note("file.duplicate", line, (*path, key), key=key, first=self.source.lines[(*path, key)])
            self.source.lines[(*path, key)] = line
            data[key] = self.value(self.next(), (*path, key))
        return data

    def sequence(self, path: Path) -> list[Any]:
        data: list[Any] = []
        while type(event := self.next()).__name__ != "SequenceEndEvent":
            data.append(self.value(event, (*path, len(data))))
        return data

    def scalar(self, text: str, line: int, path: Path) -> Any:
        if text in _CONSTANTS:
            return _CONSTANTS[text]
        if text.lower() in _NOT_NUMBERS:
            return float(text.lower().replace(".", ""))
        if _INT.match(text) and len(text) < 19:
            return int(text)
        return float(text) if _FLOAT.match(text) else text


def write_text(data: Mapping[str, Any]) -> str:
    """Plain data as YAML: sections as blocks, leaves in one line each."""
    from ruamel.yaml import YAML

    yaml = YAML(typ="rt", pure=True)
    yaml.default_flow_style = None
    yaml.width = 110
    yaml.allow_unicode = True
    stream = io.StringIO()
    yaml.dump(dict(data), stream)
    return stream.getvalue()
