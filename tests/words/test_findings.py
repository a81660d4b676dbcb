"""Every finding has words, the words have the data that they ask for, and docs/findings.md lists them all.

``python tests/words/test_findings.py`` writes docs/findings.md anew.
"""

from __future__ import annotations

import re
from pathlib import Path
from string import Formatter

from linkwright.words import catalogue, modules, texts

if __name__ != "__main__":
    from helpers.offenders import nobody_breaks
    from words import source

DOCUMENT = Path(__file__).parents[2] / "docs" / "findings.md"
WORDS = catalogue("en")
FINDINGS = dict(pair for module in modules("en") if ".findings." in module.__name__ for pair in texts(module))
CODES = [key.removesuffix(".what") for key in FINDINGS if key.endswith(".what")]
OTHERS = WORDS.keys() - FINDINGS.keys()
"""Keys of texts that are no findings."""
SPOKEN_FOR = {"window.outside"}
"""Codes that have their words before anything raises them."""

INTRODUCTION = """# Problems and fixes

linkwright reports all problems of a model at once. Each problem has a code, the line, the affected element, a
description of the cause and a suggested fix. The command line, `summary.json`, the report and Python
(`linkwright.check`, `ModelError.findings`) show the same ones. The codes are stable; the texts may change.

Exit codes: 2 if the file or the command is wrong; 1 if the file is right, but the mechanism can't do what is required
(`structure.…`, `assembly.…`, `motion.…`, `export.cannot-…`, a load or measure without a value, a requirement that
fails).

Words in *italics* stand for names and values of the model.
"""

TITLES = {
    "file": "The file",
    "builder": "The builder",
    "gallery": "The gallery",
    "folder": "Results folders",
    "blocks": "Large studies",
    "units": "Units",
    "gravity": "Gravity",
    "plausible": "Unusual values and modes",
    "expression": "Expressions",
    "parameters": "Parameters",
    "value": "Numbers",
    "name": "Names",
    "signal": "Signals",
    "model": "The model as a whole",
    "triangle": "Points by two distances",
    "mass": "Masses",
    "element": "Elements that aren't supported or have another name",
    "joint": "Joints",
    "cylinder": "Cylinders",
    "cam": "Cams",
    "subassembly": "Sub-assemblies",
    "sketch": "The sketch",
    "drive": "Drives",
    "path": "Paths of points",
    "load": "Loads",
    "spring": "Springs",
    "friction": "Friction",
    "differential": "Differentials",
    "gears": "Gears, racks and rolling contact",
    "geneva": "Geneva drives",
    "belt": "Belts and chains",
    "table": "Tables",
    "drawing": "Drawings",
    "law": "Motion laws",
    "window": "Windows",
    "measure": "Measures",
    "nc": "NC code of cams",
    "study": "Studies",
    "reactions": "Reactions of structures",
    "export": "Exports",
    "batch": "Batches of exports",
    "clearance": "Clearances",
    "tolerance": "Tolerances",
    "accuracy": "Accuracy",
    "functions": "Joint functions",
    "workspace": "Workspaces",
    "varied": "Many parameter sets",
    "stiffness": "Stiffness",
    "structure": "Structure",
    "assembly": "Assembly",
    "motion": "Motion",
}


def fields(text: str) -> set[str]:
    """The names of the data that a text asks for."""
    return {name for _, name, _, _ in Formatter().parse(text) if name}


def shown(text: str) -> str:
    """A text of the catalogue with its data in italics, fit for a table's cell."""
    parts = [
        re.sub(r"[*|\\]", r"\\\g<0>", words) + (f"*{name.replace('_', ' ')}*" if name else "")
        for words, name, _, _ in Formatter().parse(text)
    ]
    return "".join(parts)


def rendered() -> str:
    """docs/findings.md as it should be."""
    parts = [INTRODUCTION]
    for group, title in TITLES.items():
        rows = [
            f"| `{c}` | {shown(FINDINGS[c + '.what'])} | {shown(FINDINGS[c + '.mend'])} |"
            for c in CODES
            if c.split(".")[0] == group
        ]
        parts.append(f"## {title}\n\n| code | description | suggested fix |\n|---|---|---|\n" + "\n".join(rows) + "\n")
    return "\n".join(parts)


def in_source() -> set[str]:
    """The codes that the source raises: what looks like one, begins like one, and isn't another text's key."""
    files = (".csv", ".nc", ".svg", ".dxf", ".geojson", ".png", ".step")
    codes = {text for text in source.texts() if text.split(".")[0] in TITLES and not text.endswith(files)}
    return codes - OTHERS


def test_every_code_has_both_texts() -> None:
    missing = {f"{code}.{part}" for code in in_source() for part in ("what", "mend")} - set(FINDINGS)
    assert not missing


def test_no_text_is_orphaned() -> None:
    assert set(CODES) - in_source() == SPOKEN_FOR
    assert {key.removesuffix(".mend") for key in FINDINGS if key.endswith(".mend")} == set(CODES)


def test_examples_are_shown_whole_with_data_in_italics() -> None:
    text = "Write {{motor: {{turns: {name}}}}} at {value:.6g}, as 2*a|b."
    assert shown(text) == r"Write {motor: {turns: *name*}} at *value*, as 2\*a\|b."


def test_every_group_has_a_title() -> None:
    assert {code.split(".")[0] for code in CODES} == set(TITLES)


def test_every_raised_code_is_known() -> None:
    assert {code for code, _ in source.raised() if code.split(".")[0] in TITLES} <= set(CODES)


def test_call_sites_give_the_data_that_the_texts_ask_for() -> None:
    absent = {
        f"{code}, {number}": fields(FINDINGS[f"{code}.what"] + FINDINGS[f"{code}.mend"]) - given
        for number, (code, given) in enumerate(source.raised())
        if given is not None and code in CODES
    }
    assert len(absent) > 80
    nobody_breaks(absent)


def test_phrases_are_all_there_and_all_used() -> None:
    phrases = {key.removeprefix("term.") for key in FINDINGS if key.startswith("term.")}
    named = source.terms()
    starts = ("a-", "must-", "respelled-", "yaml-", "section-", "system-")
    made = {name for name in phrases if name.startswith(starts)} | {"mapping", "text", "list", "other"}
    made |= {name for name in phrases if name.removesuffix("-as") in phrases}
    assert phrases - named <= made, phrases - named - made


def test_what_is_wanted_has_an_example() -> None:
    phrases = {key.removeprefix("term.") for key in FINDINGS if key.startswith("term.")}
    assert {f"{name}-as" for name in source.wanted()} <= phrases


def unlike_sentences(key: str, text: str) -> list[str]:
    """What keeps a text from reading like a sentence, or like a part of one in a phrase."""
    faults = {
        "begins small": not (key.startswith("term.") or text[0].isupper() or text[0] in "'{["),
        "ends without a stop": not (key.startswith("term.") or text.endswith((".", ".'", "}", "?"))),
        "two spaces": "  " in text,
        "data that no name can hold": not all(name.isidentifier() for name in fields(text)),
    }
    return [fault for fault, found in faults.items() if found]


def test_texts_read_like_sentences() -> None:
    assert len(unlike_sentences("a.what", "no  {0}!")) == 4
    assert unlike_sentences("term.a", "in a row") == []
    nobody_breaks({key: unlike_sentences(key, text) for key, text in FINDINGS.items()})


def test_the_catalogue_holds_each_key_once() -> None:
    keys = [key for module in modules("en") for key, _ in texts(module)]
    assert len(keys) == len(set(keys))
    assert set(keys) <= set(WORDS)


def test_the_page_lists_exactly_the_codes() -> None:
    page = DOCUMENT.read_text(encoding="utf-8")
    assert sorted(re.findall(r"^\| `([a-z.-]+)` \|", page, re.M)) == sorted(CODES)
    assert page == rendered(), "run python tests/words/test_findings.py"


if __name__ == "__main__":
    DOCUMENT.write_text(rendered(), encoding="utf-8", newline="\n")
