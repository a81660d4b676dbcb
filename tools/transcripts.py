"""What the `console` blocks of a page show of a command's output, compared with what the command prints.

A line `...` in a block stands for any lines, `...` at the end of a line for the rest of that line. Blank lines and the
widths of gaps don't count; numbers agree to four digits, and round-off (below 1e-9) with any other round-off.
"""

import difflib
import math
import re

ANY = "..."
NUMBER = re.compile(r"(\d+(?:\.\d+)?(?:e[-+]?\d+)?)")
DIGITS = 1e-4
ROUND_OFF = 1e-9


def pieces(shown: list[str]) -> list[list[str]]:
    """The lines between the `...` of a block; an empty first or last piece stands for a `...` at that end."""
    found: list[list[str]] = [[]]
    for line in shown:
        if line.strip() == ANY:
            found.append([])
        elif line.strip():
            found[-1].append(line)
    return found


def same_number(one: str, other: str) -> bool:
    """Whether two numbers differ by round-off alone."""
    a, b = float(one), float(other)
    return math.isclose(a, b, rel_tol=DIGITS) or max(a, b) < ROUND_OFF


def same_line(shown: str, printed: str) -> bool:
    """Whether a line of a block says the same as one of output, or its beginning the same before a `...` at its end."""
    words, others = shown.split(), printed.split()
    if words[-1:] == [ANY]:
        words = words[:-1]
        others = others[: len(words)]
    a, b = (NUMBER.split(" ".join(line)) for line in (words, others))
    if len(a) != len(b) or a[::2] != b[::2]:
        return False
    return all(map(same_number, a[1::2], b[1::2]))


def same_lines(shown: list[str], printed: list[str]) -> bool:
    """Whether two lists of lines say the same."""
    return len(shown) == len(printed) and all(map(same_line, shown, printed))


def difference(shown: list[str], said: str) -> str:
    """What a block shows that the command doesn't print, or an empty text."""
    lines = [line for line in said.splitlines() if line.strip()]
    parts = pieces(shown)
    at = 0
    for index, part in enumerate(parts):
        if not part:
            continue
        first, last = index == 0, index == len(parts) - 1  # these stand at the ends of the output
        end = len(lines) - len(part)
        starts = [s for s in range(at, end + 1) if (s == 0 or not first) and (s == end or not last)]
        found = next((s for s in starts if same_lines(part, lines[s : s + len(part)])), None)
        if found is None:
            return "not printed:\n" + "\n".join(part) + "\nbut:\n" + said
        at = found + len(part)
    return ""


def remade(shown: list[str], said: str) -> list[str]:
    """The lines of a block with what the command prints now; a piece between `...` by the most similar lines."""
    lines = [line.rstrip() for line in said.rstrip().splitlines()]
    parts = pieces(shown)
    if len(parts) == 1:
        return shortened(parts[0], lines)
    new: list[str] = []
    at = 0
    for index, part in enumerate(parts):
        if part:
            first = at if index == 0 else most_similar(part[0], lines, at)
            last = len(lines) - 1 if index == len(parts) - 1 else most_similar(part[-1], lines, first)
            new += shortened(part, lines[first : last + 1])
            at = last + 1
        if index < len(parts) - 1:
            new.append(ANY)
    return new


def most_similar(line: str, lines: list[str], start: int) -> int:
    """The index, from `start` on, of the line that is most like a given one."""
    ratios = [difflib.SequenceMatcher(None, line.split(), other.split()).ratio() for other in lines[start:]]
    letters = [difflib.SequenceMatcher(None, line, other).ratio() for other in lines[start:]]
    scores = [a + b for a, b in zip(ratios, letters, strict=True)]
    return start + max(range(len(scores)), key=scores.__getitem__)


def shortened(part: list[str], lines: list[str]) -> list[str]:
    """The lines with `...` after as many words as in the lines of a piece that end with it, if they are as many."""
    if len(part) != len(lines):
        return lines
    new = []
    for old, line in zip(part, lines, strict=True):
        words = old.split()
        start = re.match(rf"(\s*\S+){{{len(words) - 1}}}(?=\s)", line) if words[-1] == ANY else None
        new.append(f"{start[0]} {ANY}" if start else line)
    return new
