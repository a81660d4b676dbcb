"""Lines of a model file in the spellings of other places: full-width punctuation, colons without a space, ``=``.

Such a line is read as something else, and what is then found misleads. Here it is rewritten and read once more: where
that mends what was found on it, the spelling is the finding, and the rest of the file is looked at all the same.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable

from linkwright.expressions.full_width import BLANKS, TO_ASCII
from linkwright.expressions.respelled_units import speed
from linkwright.expressions.synonyms import unit_meant
from linkwright.findings import Finding, Term

ROUNDS = 6
"""How often a text is rewritten: YAML gives up at its first fault, and then only that line is known."""
LONGEST = 50_000
"""Longer texts are read once."""
LONGEST_LINE = 2_000
"""Longer lines stay as they are."""
AROUND = 24
"""So much of a line is shown around what is rewritten."""
SHOWN = "␣"
"""How a blank is shown that looks like a space."""

_QUOTED = re.compile(r"\"[^\"]*\"|'[^']*'|(?:^|\s)#.*")
_COLON = re.compile(r"((?:^|[{,])\s*[^\W\d]\w*):(?=[^\s:/])")
_EQUALS = re.compile(r"^(\s*[^\W\d]\w*)\s*=\s*(?=[^\s=])")


_KEY = re.compile(r"^(\s*[^\W\d]\w*)\(([\w .-]+)\)(?=\s*:)")
_UNIT = re.compile(r"(\d\s*|\bunit:\s*)([一-鿿]+(?:/[一-鿿]+)?)(?=[\s,}\])]|$)")
_LIST = re.compile(r"(?<=[:：,，[【])(\s*)（([^（）()]*)）")
_LIMIT = re.compile(r"(?<=: )((?:[＞＜][＝=]?|[>＞＜<]＝)[^,，}｝\]\s]*(?: [^,，}｝\]\s]+)*)")
_SIGNS = {code: meant for code, meant in TO_ASCII.items() if meant.strip()}


def _wide(text: str) -> str:
    """Half-width characters in place of full-width ones, and what else YAML needs with them: a space behind a colon and
    before a comment, quotes around a limit, square brackets around a list, nothing behind a value."""
    value, hash_, comment = text.partition("＃")
    text = f"{value.rstrip()}  # {comment.lstrip()}" if hash_ else text
    if (end := text.rstrip()).endswith(("；", "。")):
        text = end[:-1]
    text = _LIST.sub(_listed, _LIMIT.sub(r'"\1"', re.sub("： *", ": ", text)))
    return _separated(text).translate(_SIGNS)


def _listed(match: re.Match[str]) -> str:
    """A list in square brackets, where there is one in round ones."""
    return f"{match[1]}[{match[2]}]" if re.search("[,，、；]", match[2]) else match.group()


def _separated(text: str) -> str:
    """Commas with a space in place of full-width marks; a decimal point between digits that stand in no list."""
    parts, opened = re.split("([，；、] *)", text), ""
    for at, part in enumerate(parts):
        if at % 2 == 0:
            for letter in part.translate(_SIGNS):
                opened = opened + letter if letter in "[{" else opened[:-1] if letter in "]}" else opened
        elif opened[-1:] != "[" and parts[at - 1][-1:].isdigit() and parts[at + 1][:1].isdigit():
            parts[at] = "." if part == "，" else part
        elif opened or part[0] == "，":
            parts[at] = ", "
    return "".join(parts)


def _spaced(text: str) -> str:
    return re.sub(f"[{BLANKS}]", lambda match: match.group().translate(TO_ASCII), text)


_RULES: dict[str, Callable[[str], str]] = {
    "file.wide": _wide,
    "file.blank": _spaced,
    "file.colon": lambda text: _COLON.sub(r"\1: ", text),
    "file.equals": lambda text: _EQUALS.sub(r"\1: ", text),
}
"""Spellings by the finding on them, each with its rewriting; these stand outside quotes and comments."""


def read_respelled(text: str, found: list[Finding], read: Callable[[str], list[Finding]]) -> list[Finding]:
    """What is wrong with a text of which ``read`` has ``found`` the findings: lines in other spellings, and what else
    there is once these are rewritten."""
    told: list[Finding] = []
    lines = text.split("\n")
    for _ in range(ROUNDS if len(text) <= LONGEST else 0):
        meant = {at: line for at in _suspects(lines, found) if (line := _rewritten(lines[at])[0]) != lines[at]}
        again = read("\n".join(meant.get(at, line) for at, line in enumerate(lines))) if meant else found
        left = {(f.code, f.line, f.path) for f in again}
        mended = {at for f in found if (f.code, f.line, f.path) not in left for at in _places(lines, f) if at in meant}
        if not mended:
            break
        for at in sorted(mended):
            given, hint = _changed(lines[at], meant[at]), Term("write", text=_changed(meant[at], lines[at]))
            shown = re.sub(f"[{BLANKS}]", SHOWN, given)
            told.append(Finding(_rewritten(lines[at])[1], (), {"given": shown.strip(), "hint": hint}, at + 1))
            lines[at] = meant[at]
        found = again if mended == meant.keys() else read("\n".join(lines))
    return [*told, *found]


def _suspects(lines: list[str], found: Iterable[Finding]) -> list[int]:
    """The lines that may be to blame for findings."""
    return sorted({at for finding in found for at in _places(lines, finding)})


def _places(lines: list[str], finding: Finding) -> list[int]:
    """The line of a finding; where YAML gives up, the one before it too."""
    if not finding.line or finding.line > len(lines):
        return []
    at = finding.line - 1
    before = next((i for i in range(at - 1, -1, -1) if lines[i].strip()), at)
    return [at, before] if finding.code == "file.yaml" else [at]


def _rewritten(line: str) -> tuple[str, str]:
    """A line as it is meant, and the code of the first spelling that it has."""
    code, meant = "", line
    if len(line) > LONGEST_LINE:
        return meant, code
    for name, rule in _RULES.items():
        kept = [*_QUOTED.finditer(meant)]
        ends = [0, *(match.end() for match in kept)]
        starts = [*(match.start() for match in kept), len(meant)]
        parts = [rule(meant[end:start]) for end, start in zip(ends, starts, strict=True)]
        changed = "".join(part + match.group() for part, match in zip(parts, kept, strict=False)) + parts[-1]
        code, meant = code or (name if changed != meant else ""), changed
    return _valid(meant) if code else meant, code


def _valid(line: str) -> str:
    """A rewritten line with what is valid in place of what would be refused next: keys with brackets, units in
    hanzi."""
    line = _KEY.sub(lambda match: f"{match[1]}_{re.sub(r'[^0-9A-Za-z_]+', '_', match[2]).strip('_')}", line)
    return _UNIT.sub(lambda match: f"{match[1].rstrip()} {_unit(match[2])}", line)


def _unit(word: str) -> str:
    """A unit in hanzi as files write it, where it is known."""
    one = f"1 {word}"
    made = speed(one, ())
    return made.removeprefix("1 ") if made != one else unit_meant(word) or word


def _changed(line: str, other: str) -> str:
    """What of a line differs from another, with whole words around it."""
    short = min(len(line), len(other))
    first = next((i for i in range(short) if line[i] != other[i]), short)
    last = next((i for i in range(short - first) if line[-1 - i] != other[-1 - i]), short - first)
    before, changed, after = line[:first], line[first : len(line) - last], line[len(line) - last :]
    if len(before) > AROUND:
        before = re.sub(r"^[^\s,{\[]*[\s,{\[]\s*", "", before[-AROUND:])
    if len(after) > AROUND:
        after = re.sub(r"[\s,]+[^\s,]*$", "", after[:AROUND])
    return f"{before}{changed}{after}".strip(" ")
