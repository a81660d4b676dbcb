"""Findings: what is wrong with an input, as values that command line, report and Python share.

A finding has a stable code; its words come from the catalogue. Raising is the caller's choice
(:class:`ModelError` carries a list of findings).
"""

from __future__ import annotations

import errno
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field, replace
from typing import Any

from linkwright.data_classes import dataclass
from linkwright.escape import line
from linkwright.words import filled, text


def _say(key: str, data: Mapping[str, Any]) -> str:
    """A text of the catalogue; what is quoted in it stands in one line."""
    shown = {name: line(value) if isinstance(value, str) else value for name, value in data.items()}
    return filled(text(key), shown)


class Said:
    """A text of the catalogue with the data that it names: it becomes words only where it is shown."""

    def __init__(self, key: str, /, **data: Any) -> None:
        self.key, self.data = key, data

    def __str__(self) -> str:
        return _say(self.key, self.data)

    def __format__(self, spec: str) -> str:
        return format(str(self), spec)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.key!r})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Said) and (self.key, self.data) == (other.key, other.data)

    def __hash__(self) -> int:
        return hash(self.key)


class Term(Said):
    """A phrase of the catalogue inside the data of a finding or another text."""

    def __init__(self, key: str, /, **data: Any) -> None:
        super().__init__(f"term.{key}", **data)


Text = str | Said
"""What is shown: a name or number as it is, or a text of the catalogue."""


LIST = Term("list-separator")
"""Stands between the items of a list."""
CLAUSES = Term("clause-separator")
"""Stands between the clauses of a sentence."""
SENTENCES = Term("sentence-separator")
"""Stands between sentences."""


class Joined(Said):
    """Texts one after another, such as the names of a list, with another text between them. Without any it is false."""

    def __init__(self, parts: Iterable[object], between: Text = LIST) -> None:
        super().__init__("joined", parts=tuple(parts), between=between)

    def __str__(self) -> str:
        parts = (part if isinstance(part, Said) else line(str(part)) for part in self.parts)
        return str(self.data["between"]).join(map(str, parts))

    def __repr__(self) -> str:
        return f"{type(self).__name__}{self.parts}"

    def __bool__(self) -> bool:
        return bool(self.parts)

    @property
    def parts(self) -> tuple[object, ...]:
        """The texts, without what stands between them."""
        return self.data["parts"]  # type: ignore[no-any-return]


def enumerated(names: Sequence[str]) -> Text:
    """Names of a sentence, as in *a, b and c*."""
    return Term("and", first=Joined(names[:-1]), last=names[-1]) if len(names) > 1 else names[0]


def alternatives(choices: Sequence[str]) -> Text:
    """Texts of which one is to be written."""
    quoted = [Term("quoted", text=choice) for choice in choices]
    return Term("or", first=Joined(quoted[:-1]), last=quoted[-1]) if len(quoted) > 1 else quoted[0]


SYSTEM = frozenset(
    {"ENOENT", "EACCES", "EPERM", "EISDIR", "ENOTDIR", "EEXIST", "ENOSPC", "EROFS", "ENAMETOOLONG", "EBUSY"}
)
"""Refusals of the system that have texts of their own."""
_IN_USE = (32, 33)
"""What Windows calls a file that another program holds; Python gives it the number of EACCES."""


def reason(error: Exception) -> Text:
    """Why the system refuses: a text for the usual reasons, else its own words."""
    if not isinstance(error, OSError):
        return str(error)
    in_use = getattr(error, "winerror", None) in _IN_USE
    name = "EBUSY" if in_use else errno.errorcode.get(error.errno or 0, "")
    return Term(f"system-{name.lower()}") if name in SYSTEM else error.strerror or str(error)


@dataclass(frozen=True)
class OtherPlace:
    """A second place in the file that a finding concerns, and the ``term`` that says what it is to the first."""

    term: str
    path: tuple[str | int, ...]
    line: int | None = None

    @property
    def element(self) -> str:
        """The element there, as a dotted path."""
        return line(".".join(str(key) for key in self.path))

    @property
    def said(self) -> Term:
        """Where that is, as a sentence."""
        at = Term("drawn-line", at=self.line) if self.line else None
        place = Term("colon", first=self.element, then=at) if at else self.element
        return Term(self.term, place=place)

    def as_dict(self) -> dict[str, Any]:
        """Plain data for JSON output."""
        return {"element": self.element, "line": self.line}


@dataclass(frozen=True)
class Finding:
    """One fault (or note): its code, the place in the file, the element, and the data of its sentence.

    ``path`` is the keys from the file's root (``("links", "crank", "mass")``), ``line`` 1-based.
    """

    code: str
    path: tuple[str | int, ...] = ()
    data: Mapping[str, Any] = field(default_factory=dict)
    line: int | None = None
    severity: str = "error"
    other: OtherPlace | None = None

    @property
    def element(self) -> str:
        """The element concerned, as a dotted path."""
        return line(".".join(str(key) for key in self.path))

    @property
    def what(self) -> str:
        """What is wrong and why, in a sentence."""
        return str(self.said("what"))

    @property
    def mend(self) -> str:
        """How to mend it."""
        return str(self.said("mend"))

    def said(self, part: str) -> Said:
        """Its ``what`` or ``mend``, in the language in which it is shown; with the former goes its second place."""
        said = Said(f"{self.code}.{part}", **self.data)
        return said if self.other is None or part != "what" else Joined((said, self.other.said), SENTENCES)

    def located(self, line: int | None) -> Finding:
        """The same finding with its line."""
        return replace(self, line=line)

    def as_dict(self) -> dict[str, Any]:
        """Plain data for JSON output."""
        return {
            "code": self.code,
            "severity": self.severity,
            "line": self.line,
            "element": self.element,
            "what": self.what,
            "mend": self.mend,
            **({"other": self.other.as_dict()} if self.other is not None else {}),
        }

    def __str__(self) -> str:
        what: Text = self.said("what")
        for place in (self.element if self.path else "", Term("drawn-line", at=self.line) if self.line else ""):
            what = Term("colon", first=place, then=what) if place else what
        return f"{what} [{self.code}] -> {self.mend}"


class ModelError(Exception):
    """The input is wrong; ``findings`` says all that is."""

    def __init__(self, findings: Iterable[Finding]) -> None:
        self.findings = tuple(findings)
        super().__init__("\n".join(str(finding) for finding in self.findings))

    def __reduce__(self) -> tuple[Any, ...]:
        return (ModelError, (self.findings,))


def capped(findings: list[Finding], most: int, path: tuple[str | int, ...] = ()) -> list[Finding]:
    """The first findings, ``most`` of them, and one on how many there are besides, at ``path``."""
    more = len(findings) - most
    return findings if more <= 0 else [*findings[:most], Finding("file.more", path, {"count": more})]


def raise_errors(findings: Iterable[Finding]) -> None:
    """Raise :class:`ModelError` when any of the findings is an error."""
    errors = [finding for finding in findings if finding.severity == "error"]
    if errors:
        raise ModelError(errors)
