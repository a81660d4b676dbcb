"""YAML text to plain data with line numbers. Nothing in it is executed and no alias expands."""

from __future__ import annotations

import io
import math
import re
from dataclasses import field
from itertools import pairwise
from typing import Any, NamedTuple

from linkwright.data_classes import dataclass
from linkwright.expressions.full_width import TO_ASCII
from linkwright.expressions.written import MAX_TEXT, NO_TEXT
from linkwright.findings import Finding, Term
from linkwright.model.encodings import decoded, likely_encoding

MAX_BYTES = 1_000_000
MAX_DEPTH = 24
MAX_NODES = 100_000
MAX_FINDINGS = 50

Path = tuple[str | int, ...]

_INT = re.compile(r"[-+]?[0-9]{1,15}")
_DECIMALS = re.compile(r"[0-9]{1,9}(\s*[^\W\d]\S{0,20})?")
_FLOAT = re.compile(r"[-+]?([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][-+]?[0-9]+)?")
_ROUND = re.compile(r"\([^()]*\)")
_FREE = (("name",), ("note",), ("source",), ("author",), ("revision",))
"""The keys of free texts."""
_CONSTANTS = {"": None, "~": None, "null": None, "true": True, "false": False}
_NOT_NUMBERS = {".nan": math.nan, ".inf": math.inf, "+.inf": math.inf, "-.inf": -math.inf}

# What YAML refuses or reads as something else where a value starts; ">=" stands for a folded text to it.
_MARKS = re.compile(r"(?:^\s*-\s+|:\s+|[\[{,]\s*)([@%`*][^\s,}\]]*|[>|](?![-+0-9]*\s*$)[^,}\]]*)")
_QUOTED = re.compile(r"\"[^\"]*\"|'[^']*'|(?:^|\s)#.*")


_REASONS = {
    "mapping values are not allowed": "colon",
    "could not find expected ':'": "no-colon",
    "expected <block end>": "indentation",
    "inconsistent": "indentation",
    "expected ',' or": "bracket",
    "expected the node content": "bracket",
    "found unexpected end of stream": "quote",
    "did not find expected ',' or": "bracket",
}
"""Why YAML gives up, by how its own sentence begins."""


class WrittenScalar(NamedTuple):
    """A value that is neither a mapping nor a list: from ``start`` to ``end`` in the text with its quotes, the
    quotation mark around it (empty without), and what it reads as."""

    start: int
    end: int
    quote: str
    value: str


@dataclass
class Source:
    """What a file holds: its data, the line of each entry and the places of its scalars, and what is wrong with its
    text.

    ``spoilt`` are the places of which a finding tells already; ``data`` is ``None`` where nothing could be read,
    ``text`` where it is no text. ``remarks`` are warnings and notes, on a text that is read all the same.
    """

    data: Any = None
    text: str | None = None
    lines: dict[Path, int] = field(default_factory=dict)
    scalars: dict[Path, WrittenScalar] = field(default_factory=dict)
    findings: list[Finding] = field(default_factory=list)
    remarks: list[Finding] = field(default_factory=list)
    spoilt: set[Path] = field(default_factory=set)

    def line(self, path: Path) -> int | None:
        """The line of an entry, or of the nearest one around it."""
        while path and path not in self.lines:
            path = path[:-1]
        return self.lines.get(path)


def read_text(raw: bytes) -> Source:
    """Read a model file's bytes; every fault of the text becomes a finding."""
    source = Source()
    if len(raw) > MAX_BYTES:
        source.findings.append(Finding("file.too-large", data={"limit": f"{MAX_BYTES:,}"}))
        return source
    text, bad = "", None
    try:
        text = raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        if other := decoded(raw):
            text = other.text
            severity = "note" if other.marked else "warning"
            source.remarks.append(Finding("file.read-as", (), {"encoding": other.encoding}, 1, severity))
        else:
            bad, line = error.start, raw.count(b"\n", 0, error.start) + 1
    if match := NO_TEXT.search(text):
        bad, line = match.start(), text.count("\n", 0, match.start()) + 1
    if bad is not None:
        source.remarks.clear()
        encoding = likely_encoding(raw)
        code = "file.binary" if encoding is None else "file.encoding"
        source.findings.append(Finding(code, data={"at": bad, "encoding": encoding}, line=line))
        return source
    source.text = text
    _Builder(source).build(text)
    return source


class _Stop(Exception):
    """The text can't be read further; the finding is noted."""


@dataclass
class _Entry:
    """One value of a collection, from ``start`` (that of its key) to ``end``, places in the text. ``plain`` is its text
    where it stands without quotes."""

    key: str
    value: Any
    line: int
    plain: str | None
    start: int
    end: int


class _Builder:
    """Builds plain data from YAML events; refuses aliases, anchors, tags, duplicate keys and deep nesting."""

    def __init__(self, source: Source) -> None:
        self.source, self.count = source, 0

    def build(self, text: str) -> None:
        from ruamel.yaml import YAML
        from ruamel.yaml.error import MarkedYAMLError, YAMLError

        self.events = iter(YAML(typ="safe", pure=True).parse(io.StringIO(text)))
        line, reason = None, None
        try:
            self.document()
            return
        except _Stop:
            pass
        except MarkedYAMLError as error:
            mark = error.problem_mark or error.context_mark
            line, reason = mark.line + 1 if mark else None, error.problem or error.context
        except (YAMLError, ValueError, RecursionError, StopIteration) as error:
            reason = error
        self.source.data = None
        if reason is not None:
            self.refused(text, line, " ".join(str(reason).split())[:200])

    def refused(self, text: str, line: int | None, reason: str) -> None:
        """YAML itself gives up at the first fault; where that is a common one, all of its kind are named."""
        tabs, marks = [], {}
        for number, content in enumerate(text.split("\n"), start=1):
            if re.match(r" *\t", content) or (number == line and "\t" in _QUOTED.sub("", content)):
                tabs.append(number)
            elif mark := _MARKS.search(_QUOTED.sub("", content)):
                marks[number] = mark.group(1).strip()[:40]
        if line in tabs:
            for number in tabs:
                self.note("file.tab", number)
        elif line in marks:
            for number, value in marks.items():
                self.note("file.quote", number, value=value)
        else:
            known = next((term for start, term in _REASONS.items() if reason.startswith(start)), None)
            self.note("file.yaml", line, reason=Term(f"yaml-{known}") if known else reason)

    def document(self) -> None:
        event = next(self.events)
        while type(event).__name__ in ("StreamStartEvent", "DocumentStartEvent"):
            event = next(self.events)
        if type(event).__name__ == "StreamEndEvent":
            self.note("file.empty", 1)
            return
        self.source.data = self.value(event, ())
        next(self.events)
        event = next(self.events)
        if type(event).__name__ != "StreamEndEvent":
            self.note("file.documents", event.start_mark.line + 1)

    def note(self, code: str, line: int | None, path: Path | None = None, **data: Any) -> None:
        """Note a finding; the entry at ``path`` is spoilt."""
        self.source.findings.append(Finding(code, path or (), data, line))
        if path is not None:
            self.source.spoilt.add(path)

    def value(self, event: Any, path: Path) -> Any:
        line = event.start_mark.line + 1
        self.source.lines.setdefault(path, line)
        kind = type(event).__name__
        self.count += 1
        if self.count > MAX_NODES:
            self.note("file.too-many", line, path[:2], count=self.count, limit=MAX_NODES)
            raise _Stop
        if len(path) > MAX_DEPTH:
            self.note("file.depth", line, path[:4], limit=MAX_DEPTH)
            raise _Stop
        if kind == "AliasEvent" or getattr(event, "anchor", None):
            self.note("file.alias", line, path, mark=("*" if kind == "AliasEvent" else "&") + str(event.anchor))
            if kind == "AliasEvent":
                return None
        if getattr(event, "tag", None) is not None and str(event.tag) not in ("!", "None"):
            self.note("file.tag", line, path, tag=str(event.tag)[:60])
        if kind == "ScalarEvent":
            quote = event.style if event.style in ("'", '"') else ""
            start, end = event.start_mark.index, event.end_mark.index
            self.source.scalars[path] = WrittenScalar(start, end, quote, event.value)
            if NO_TEXT.search(event.value):
                self.note("file.character", line, path)
                return None
            return self.plain(event.value, line, path) if _is_plain(event) else event.value
        if kind == "MappingStartEvent":
            return self.mapping(path, flow=bool(event.flow_style))
        return self.sequence(path, flow=bool(event.flow_style))

    def plain(self, text: str, line: int, path: Path) -> Any:
        """What a text without quotes stands for; a number in full-width digits is meant in half-width ones."""
        value = scalar(meant := text.translate(TO_ASCII))
        if meant == text.replace("−", "-") or not isinstance(value, int | float) or path[-1:] in _FREE:
            return scalar(text)
        self.note("file.wide", line, path, given=text[:40], hint=Term("write", text=meant[:40]))
        return value

    def mapping(self, path: Path, flow: bool) -> dict[str, Any]:
        entries: list[_Entry] = []
        while type(event := next(self.events)).__name__ != "MappingEndEvent":
            line = event.start_mark.line + 1
            if type(event).__name__ != "ScalarEvent":
                self.note("file.key", line, path)
                raise _Stop
            key, start, event = str(event.value), event.start_mark.index, next(self.events)
            if NO_TEXT.search(key):
                self.note("file.character", line, path)
                key = NO_TEXT.sub("?", key)
            self.source.lines.setdefault((*path, key), line)
            plain = event.value if _is_plain(event) else None
            end = event.end_mark.index
            entries.append(_Entry(key, self.value(event, (*path, key)), line, plain, start, end))
        data: dict[str, Any] = {}
        lines: dict[str, int] = {}
        for entry in self.rejoined(entries, path) if flow else entries:
            if entry.key in data:
                self.note("file.duplicate", entry.line, (*path, entry.key), name=entry.key, first=lines[entry.key])
            lines[entry.key] = entry.line
            data[entry.key] = entry.value
        return data

    def sequence(self, path: Path, flow: bool) -> list[Any]:
        entries: list[_Entry] = []
        while type(event := next(self.events)).__name__ != "SequenceEndEvent":
            plain, line = event.value if _is_plain(event) else None, event.start_mark.line + 1
            start, end = event.start_mark.index, event.end_mark.index
            entries.append(_Entry("", self.value(event, (*path, len(entries))), line, plain, start, end))
        return [entry.value for entry in (self.rejoined(entries, path) if flow else entries)]

    def rejoined(self, entries: list[_Entry], path: Path) -> list[_Entry]:
        """Put together again what YAML splits at the commas inside an expression's brackets, with a finding."""
        found: list[_Entry] = []
        at, spaced = 0, any(b.start > a.end + 1 for a, b in pairwise(entries))
        while at < len(entries):
            entry, end = entries[at], at + 1
            parts = [entry.plain or ""]
            opened, room = _opened(parts[0]), MAX_TEXT
            while opened > 0 and room > 0 and end < len(entries):
                part = entries[end].plain if not entry.key else entries[end].key
                if part is None or (entry.key and entries[end].plain != ""):
                    break
                parts.append(part)
                opened, room, end = opened + _opened(part), room - len(part) - 1, end + 1
            if (comma := _decimal(entries, at, spaced)) is not None:
                text, after = f"{entry.plain},{comma}", entries[at + 1]
                given = text.replace(",", ".")
                self.note("file.decimal-comma", entry.line, (*path, entry.key or len(found)), text=text, meant=given)
                entry.value, at = scalar(given), at + 2
                entry.end = after.end
            elif end > at + 1 and opened <= 0 and _ROUND.fullmatch(parts[0] + parts[-1]):
                text, place = ", ".join(parts), (*path, entry.key or len(found))
                self.note("file.brackets", entry.line, place, given=text[:80], meant=f"[{text[1:-1]}]"[:80])
                entry.value, at = text, end
            elif end > at + 1 and opened <= 0:
                text = ", ".join(parts)
                entry.value, at = text, end
                self.note("file.comma", entry.line, (*path, entry.key or len(found)), text=text[:80])
            else:
                at += 1
            found.append(entry)
        return found


def _decimal(entries: list[_Entry], at: int, spaced: bool) -> str | None:
    """What follows the comma of a number that YAML splits there: digits right behind it, of a list where other commas
    are ``spaced``; in a mapping, a key without a value."""
    if at + 1 >= len(entries) or not _INT.fullmatch(entries[at].plain or ""):
        return None
    entry, after = entries[at], entries[at + 1]
    close = after.start == entry.end + 1
    if entry.key:
        return after.key if close and after.plain == "" and _DECIMALS.fullmatch(after.key) else None
    return after.plain if close and spaced and _DECIMALS.fullmatch(after.plain or "") else None


def scalar(text: str) -> Any:
    """What a text without quotes stands for."""
    if text in _CONSTANTS:
        return _CONSTANTS[text]
    if text.lower() in _NOT_NUMBERS:
        return _NOT_NUMBERS[text.lower()]
    if _INT.fullmatch(text):
        return int(text)
    return float(text) if _FLOAT.fullmatch(text) else text


def _is_plain(event: Any) -> bool:
    return type(event).__name__ == "ScalarEvent" and event.style not in ("'", '"', "|", ">")


def _opened(text: str) -> int:
    """How many more brackets it opens than it closes."""
    return text.count("(") - text.count(")")
