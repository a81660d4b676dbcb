"""Where in the file that stands of which a finding on a spelled out copy tells: in its sub-assembly, or in its entry.

What is wrong with every copy in the same words is told once, in the sub-assembly; so is what is wrong with several, one
of which has no values of its own. What is wrong with others is told at each of these, and so is a value that a copy has
of its own. The other place is named besides.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from copy import copy as duplicate
from dataclasses import replace
from typing import Any

from linkwright.expressions.unknown import Near, near
from linkwright.findings import Finding, OtherPlace, Said
from linkwright.model.cylinders import cylinder_path
from linkwright.model.mechanism import Mechanism, mechanism_of
from linkwright.model.placed_copies import Placed, PlacedCopy
from linkwright.model.sketch import sketch_path

Path = tuple[str | int, ...]
_WORD = re.compile(r"[^\W\d]\w*")


def copied_path(written: Mechanism, placed: Placed, path: Path) -> Path:
    """The place in the file of one of a mechanism whose copies are spelled out."""
    of, stated, given = _origin(written, placed, path)
    return path if of is None else given or stated


def with_copied_places(written: Mechanism, placed: Placed, findings: Iterable[Finding]) -> list[Finding]:
    """Findings on a mechanism whose copies are spelled out, with their places in the file."""
    found = [f for f in findings if not _follows(placed, f)]
    if not placed.copies:
        return found
    origins = [_origin(written, placed, f.path) for f in found]
    local = [
        f if of is None else replace(f, data=_local(of, f.data)) for f, (of, _, _) in zip(found, origins, strict=True)
    ]
    alike: dict[tuple[Any, ...], list[PlacedCopy]] = {}
    for f, (of, stated, given) in zip(local, origins, strict=True):
        if of is not None and not given:
            alike.setdefault((f.code, stated, f.what), []).append(of)
    told: list[Finding] = []
    for f, own, (of, stated, given) in zip(found, local, origins, strict=True):
        if of is None:
            told.append(f)
            continue
        every = alike.get((own.code, stated, own.what), [])
        if _is_of_all(every, of, placed.copies):
            one = replace(own, path=stated, other=OtherPlace("placed-at", every[0].path))
        else:
            use = _use(every, of, placed.copies)
            told_as = own if of.within and use == of.path else f  # one in another: of all copies of that
            one = replace(told_as, path=given or use, other=OtherPlace("stated-at", stated))
        told += [] if one in told else [one]
    return told


def _is_of_all(found: Sequence[PlacedCopy], of: PlacedCopy, copies: Iterable[PlacedCopy]) -> bool:
    """Whether what is found in some copies of a sub-assembly comes from that, rather than from what they are given."""
    several = len({id(one) for one in found}) > 1 and not all(one.given for one in found)
    return several or {id(one) for one in found} == {id(one) for one in copies if one.of == of.of}


def _use(found: Sequence[PlacedCopy], of: PlacedCopy, copies: Iterable[PlacedCopy]) -> Path:
    """The entry that a finding on a copy concerns: of one in another, its own where it is found wherever that stands,
    else the outermost."""
    everywhere = {id(one) for one in found} >= {id(one) for one in copies if one.path == of.path}
    return of.path if everywhere or not of.within else of.within[0]


def _follows(placed: Placed, finding: Finding) -> bool:
    """Whether a name isn't known since the copy that has it couldn't be spelled out."""
    name = str(finding.data.get("name", ""))
    unknown = finding.code.startswith(("name.unknown", "signal."))
    return unknown and any(name.startswith(f"{copy}_") for copy in placed.failed)


def _origin(written: Mechanism, placed: Placed, path: Path) -> tuple[PlacedCopy | None, Path, Path]:
    """The copy to which a place belongs, where it stands in the sub-assembly, and in a copy's entry if it is given."""
    if len(path) < 2:
        return None, (), ()
    section, name = str(path[0]), str(path[1])
    given = next((one.given[name] for one in placed.copies if section == "parameters" and name in one.given), ())
    for one in placed.copies:
        if (section, name) in one.owned:
            inside: Path = (section, one.names[name], *(_old(one, key) for key in path[2:]))
        elif section == "links" and name in one.shared and path[2:3] == ("points",) and path[3:4] != ():
            if str(path[3]) not in one.points:
                continue
            inside = (section, one.shared[name], *(_old(one, key) for key in path[2:]))
        else:
            continue
        own = mechanism_of(written.subassemblies[one.of])
        inside = cylinder_path(own, inside) or sketch_path(own, inside) or inside
        rest = path[2:] if given else ()
        return one, ("subassemblies", one.of, *inside), (*given, *rest) if given else ()
    return None, (), ()


def _old(of: PlacedCopy, key: str | int) -> str | int:
    return _text(of, key) if isinstance(key, str) else key


def _text(of: PlacedCopy, text: str) -> str:
    """A text with the names that the sub-assembly has."""
    return _WORD.sub(lambda match: of.names.get(match[0], match[0]), text)


def _local(of: PlacedCopy, data: Mapping[str, Any]) -> dict[str, Any]:
    """The data of a finding with the names that the sub-assembly has; on a name that isn't known, those of it that may
    be meant come first."""
    found = {key: _value(of, value) for key, value in data.items()}
    if isinstance(data.get("near"), Near) and isinstance(name := data.get("name"), str):
        own = near(name, dict.fromkeys(of.names.values()))
        found |= {"near": own} if own.likely else {}
    return found


def _value(of: PlacedCopy, value: Any) -> Any:
    if isinstance(value, str):
        return _text(of, value)
    if isinstance(value, Said):
        same = duplicate(value)
        same.data = {key: _value(of, one) for key, one in value.data.items()}
        return same
    return tuple(_value(of, one) for one in value) if isinstance(value, tuple) else value
