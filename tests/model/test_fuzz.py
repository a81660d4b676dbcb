"""Whatever a file holds, reading and examining it ends in findings or a mechanism, never in an exception."""

from __future__ import annotations

import random
import re
import warnings
from collections.abc import Iterable
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from linkwright.compilation import examine
from linkwright.model.document import Document, located, read_document
from model.given import DATA

EXAMPLES = sorted((Path(__file__).parents[2] / "examples").glob("*.yaml"))
FILES = [path.read_text(encoding="utf-8") for path in sorted(DATA.glob("*.yaml"))]
TOKEN = re.compile(r"\w+|[0-9.]+|\S|\s+")
WORDS = re.compile(r"[^\W\d]\w*")
NUMBERS = ["0", "-0", "1e9", "1e-9", "nan", "-1", "1e38", "1e41", "1e400", "1e-300", ".5", "0x10", "1_000"]
JUNK = [
    *(".nan", "inf", "null", "true", "yes", "on", "~", "{}", "[]", "*a", "&a", "!t", "@", "%", "`", "|", ">", "'", '"'),
    *("#", ":", "?", "-", "---", "...", "[[", "}}", "曲柄", "é", "[0,0]", "{a:1}", "1:30", "open", "crossed", "\t"),
    *("2^9999^9999", "1/0", "0^0", "(-1)^0.5", "sqrt(-1)", "10^400", "abs(E.x)", "step5(t,0,0,1,1)", "min(1,2)"),
    *("t", "pi", "E.x", "crank.angle", "force(frame,crank).x", "com(crank).x", "shaking.x", "energy.kinetic", "gas(t)"),
    *("frame", "A", "B", "D", "AB", "mm", "kg", "deg", "rpm", "Hz", "r/min"),
]
LONGER = [
    "left of B-D",
    "behind B along slide",
    "disc 3 at A",
    "rod A-A",
    "point A",
    "3 at 4",
    "curve",
    "half",
    "pull.length",
    "pull.force",
    "curve(curve(t))",
    "1 .. 2",
    ">= 3",
]
HUGE = ["x" * 3000, "(" * 200, "1+" * 400 + "1", "9" * 5000]


def mutated(random_: random.Random, text: str) -> str:
    """The text with a few of its tokens, lines or characters changed."""
    for _ in range(random_.choice([1, 1, 1, 2, 3, 6])):
        text = _changed(random_, text)
    return text


def _changed(random_: random.Random, text: str) -> str:
    tokens = TOKEN.findall(text) or [" "]
    i = random_.randrange(len(tokens))
    kind = random_.randrange(9)
    if kind == 0:
        tokens[i] = random_.choice([*JUNK, *LONGER, *HUGE])
    elif kind == 1:
        del tokens[i]
    elif kind == 2:
        tokens.insert(i, random_.choice([*JUNK, *LONGER]))
    elif kind == 3:
        j = random_.randrange(len(tokens))
        tokens[i], tokens[j] = tokens[j], tokens[i]
    elif kind == 4:
        lines = text.split("\n")
        line = lines.pop(random_.randrange(len(lines)))
        if random_.random() < 0.5:
            lines[random_.randrange(len(lines) + 1) : 0] = [line, line]
        return "\n".join(lines)
    elif kind == 5:
        at = random_.randrange(len(text) + 1)
        odd = random_.choice([0, 9, 10, 45, 58, 0x7F, 0x85, 0x2028, 0x1F600, random_.randrange(32, 127)])
        return text[:at] + chr(odd) + text[at + 1 :]
    else:
        kinds = {6: lambda token: token[0].isdigit(), 7: WORDS.fullmatch, 8: WORDS.fullmatch}
        found = [k for k, token in enumerate(tokens) if kinds[kind](token)]
        if found:
            tokens[random_.choice(found)] = random_.choice(NUMBERS) if kind == 6 else tokens[random_.choice(found)]
    return "".join(tokens)


def survives(raw: bytes) -> bool:
    """Whether a file is sound; what is found in it otherwise has words."""
    document, source = read_document(raw)
    assert (document is None) == bool(source.findings)
    findings = source.findings
    compiled = None
    if document is not None:
        compiled, findings = examine(document, DATA)
        findings = located(findings, source)
        assert (compiled is None) == any(finding.severity == "error" for finding in findings)
    for finding in findings:
        assert "{" not in finding.code
        assert finding.as_dict()["what"]
        assert str(finding).encode()
    return compiled is not None


def every_one_survives(texts: Iterable[str]) -> list[bool]:
    """Whether each of some files is sound; warnings of NumPy and others count as failures."""
    found = []
    for text in texts:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            try:
                found.append(survives(text.encode()))
            except Exception as error:
                raise AssertionError(f"{type(error).__name__} for the file:\n{text}") from error
    return found


@pytest.mark.parametrize("seed", range(10))
def test_mutated_files(seed: int) -> None:
    """A hundred files a seed."""
    random_ = random.Random(seed)
    assert not all(every_one_survives(mutated(random_, random_.choice(FILES)) for _ in range(100)))


@pytest.mark.long
@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_mutated_examples(path: Path) -> None:
    """Every example 60 times, more than 3 000 files in all."""
    text, random_ = path.read_text(encoding="utf-8"), random.Random(path.stem)
    assert not all(every_one_survives(mutated(random_, text) for _ in range(60)))


@given(st.binary(max_size=300))
@settings(max_examples=100)
def test_any_bytes(raw: bytes) -> None:
    assert not survives(raw)


_SECTIONS = [
    "name",
    "gravity",
    *(field for field in Document.model_fields if field.endswith("s")),
    "assembly",
    "require",
]
_values = st.recursive(
    st.none() | st.booleans() | st.floats() | st.integers() | st.sampled_from([*JUNK, *LONGER]) | st.text(max_size=8),
    lambda below: (
        st.lists(below, max_size=3)
        | st.dictionaries(
            st.sampled_from(["frame", "A", "points", "on", "turns", "max", "file"]) | st.text(max_size=5),
            below,
            max_size=3,
        )
    ),
    max_leaves=12,
)


@given(st.dictionaries(st.sampled_from(_SECTIONS), _values, max_size=6))
@settings(max_examples=150)
def test_any_sections(data: dict[str, object]) -> None:
    """Well-formed files of any content, by way of JSON, which is YAML too."""
    import json

    survives(json.dumps({"linkwright": 1, **data}).encode())
