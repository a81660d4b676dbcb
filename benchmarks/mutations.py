"""Model files made wrong: by changes of the text, and by changes of what the text says."""

from __future__ import annotations

import copy
import io
import random
import re
from typing import Any

from ruamel.yaml import YAML

NUMBER = re.compile(r"(?<![\w.])\d+(?:\.\d+)?")
WORD = re.compile(r"[^\W\d]\w*")
UNIT = re.compile(r"(?<=\d )(?:mm|deg|kg|s|N|kN|rpm|inch|m/s\^2|m/s|N\*m)\b")
NUMBERS = ["0", "-1", "-0.0", "1e300", "1e-300", "1e9", "99999999999999999999", "nan", ".inf", "1/0", "0x1F", "1_000"]
UNITS = ["kg", "m", "rpm", "furlong", "deg/s", "mm^2", "N*m", "", "°", "s s", "Hz", "mm/mm"]
LETTERS = ["é", "曲", "柄", "\u202e", "\u200b", "\ufeff", "🦿", "\x00", "\x7f", "\t", "\u2028", "Ａ", "ﬁ", "\r"]
MARKS = ["{", "}", "[", "]", ":", ",", "#", "'", '"', "&a ", "*a", "!!python/object:os.system ", "|", ">", "- ", "? "]
VALUES: list[Any] = [
    *(None, True, 0, -1, 1e308, float("nan"), float("inf"), "", "0", "-0", "nan", "1e400", "x", "frame", "t", "pi"),
    *([], {}, [0], [0, 0], [0, 0, 0], [None, None], {"x": 1}, "5 furlong", "1/0", "sqrt(-1)", "2^9999", "(((", "a.b.c"),
    *("left of A-A", "rod A-A", "A at 0", "ahead of A along A", ">= 0", "1 .. 0", "0 motor", "9e9 motor", "1 s", "0 s"),
    *("force(frame, frame).x", "motor.angle", "A.x", "step5(t, 1 s, 0, 1 s, 1)", "atan2(0, 0)", "x" * 5000, 10**400),
]


def mutated(random_: random.Random, text: str) -> str:
    """The text with one to four changes."""
    for _ in range(random_.choice((1, 1, 2, 4))):
        text = random_.choice((_structure, _structure, _numbers, _units, _names, _lines, _letters, _cut, _depth))(
            random_, text
        )
    return text


# Of the text.


def _replaced(random_: random.Random, text: str, pattern: re.Pattern[str], options: list[str]) -> str:
    found = list(pattern.finditer(text))
    if not found:
        return text
    spot = random_.choice(found)
    return text[: spot.start()] + random_.choice(options) + text[spot.end() :]


def _numbers(random_: random.Random, text: str) -> str:
    return _replaced(random_, text, NUMBER, NUMBERS)


def _units(random_: random.Random, text: str) -> str:
    return _replaced(random_, text, UNIT, UNITS)


def _names(random_: random.Random, text: str) -> str:
    """One word by another of the file, or two swapped throughout."""
    words = WORD.findall(text)
    if not words:
        return text
    a, b = random_.choice(words), random_.choice(words)
    if random_.random() < 0.5:
        return _replaced(random_, text, WORD, [b])
    return WORD.sub(lambda m: b if m.group() == a else a if m.group() == b else m.group(), text)


def _lines(random_: random.Random, text: str) -> str:
    """A line dropped, twice there, elsewhere, or indented otherwise."""
    lines = text.split("\n")
    i, j = random_.randrange(len(lines)), random_.randrange(len(lines))
    way = random_.randrange(4)
    if way == 0:
        del lines[i]
    elif way == 1:
        lines.insert(j, lines[i])
    elif way == 2:
        lines[i], lines[j] = lines[j], lines[i]
    else:
        lines[i] = random_.choice((" " + lines[i], lines[i].lstrip(), "\t" + lines[i], lines[i] + "  "))
    return "\n".join(lines)


def _letters(random_: random.Random, text: str) -> str:
    at = random_.randrange(len(text) + 1)
    return text[:at] + random_.choice([*LETTERS, *MARKS]) + text[at + random_.choice((0, 0, 1, 3)) :]


def _cut(random_: random.Random, text: str) -> str:
    """The file ends early, or has a hole."""
    a, b = sorted(random_.randrange(len(text) + 1) for _ in range(2))
    return text[:a] if random_.random() < 0.5 else text[:a] + text[min(b, a + 200) :]


def _depth(random_: random.Random, text: str) -> str:
    deep = random_.choice((3, 20, 300))
    opening, closing = random_.choice((("[", "]"), ("{a: ", "}"), ("(", ")"), ("-", ""), ("abs(", ")"), ("1+", "1")))
    return _replaced(random_, text, NUMBER, [opening * deep + "1" + closing * deep])


# Of what it says.


def _structure(random_: random.Random, text: str) -> str:
    """The file's data with an entry changed, written anew; the text itself where it can't be read."""
    yaml = YAML(typ="safe", pure=True)
    yaml.default_flow_style = False
    try:
        data = yaml.load(text)
        change(random_, data)
        stream = io.StringIO()
        yaml.dump(data, stream)
    except Exception:  # of the YAML reader, for text that isn't any
        return text
    return stream.getvalue()


def change(random_: random.Random, data: Any) -> None:
    """Change one entry of some data, in place."""
    there = list(places(data))
    if not there:
        return
    (holder, key), (other, elsewhere) = random_.choice(there), random_.choice(there)
    way = random_.randrange(7)
    if way == 0:
        del holder[key]
    elif way == 1:
        holder[key] = copy.deepcopy(random_.choice(VALUES))
    elif way == 2:
        holder[key], other[elsewhere] = copy.deepcopy(other[elsewhere]), copy.deepcopy(holder[key])
    elif way == 3:
        holder[key] = copy.deepcopy(other[elsewhere])
    elif way == 4 and isinstance(holder[key], dict | list | str):
        holder[key] = type(holder[key])()
    elif way == 5 and isinstance(holder, dict):
        name = random_.choice([str(elsewhere), "frame", "t", "1a", "x y", "é", "a" * 70, "points"])
        holder[name] = holder.pop(key)
    elif isinstance(holder, dict):
        holder[random_.choice(("more", str(elsewhere)))] = copy.deepcopy(other[elsewhere])
    else:
        holder.append(copy.deepcopy(holder[key]))


def places(data: Any) -> Any:
    """Every (list or mapping, index or key) in some data."""
    keys = list(data) if isinstance(data, dict) else range(len(data)) if isinstance(data, list) else ()
    for key in keys:
        yield data, key
        yield from places(data[key])
