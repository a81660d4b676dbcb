"""What the fuzzer tries: classes of cases, each a folder of files and a command line, made from a seed.

A class is a function of a source of random numbers under ``@register``, with its weight among
all. Studies and export targets come from their registries, so that a new one is tried without a line here.
"""

from __future__ import annotations

import copy
import functools
import json
import random
import re
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import grown
import large_models
import mutations
from ruamel.yaml import YAML

from linkwright import gallery
from linkwright.exports import TARGETS
from linkwright.studies import STUDIES

EXAMPLES = Path(__file__).resolve().parent.parent / "examples"
MODEL, OUT = "model.yaml", "out"
BATCHED = "bonnet_hinge"
"""The example whose mechanism the batch of examples/ has."""
SAMPLES = 12
CHORD = 1e-2
VALUES = 2
"""Options that make studies short, where the case isn't about them."""
ALTERED = 0.25
"""The share of grown mechanisms that are altered."""
LONG = 4000
"""Grown mechanisms whose links take more letters than this are checked, not run."""
Data = dict[str, Any]


@dataclass(frozen=True)
class Case:
    """Files by name, and the words of a command in their folder."""

    kind: str
    seed: int
    files: dict[str, bytes] = field(repr=False)
    words: tuple[str, ...]


@dataclass(frozen=True)
class Kind:
    """A class of cases: its name, what it is, its weight, and a function that makes files and words."""

    name: str
    about: str
    weight: int
    make: Callable[[random.Random], tuple[dict[str, bytes], list[str]]]


KINDS: dict[str, Kind] = {}


def register(weight: int) -> Callable[[Any], Any]:
    """Register a class under its function's name; its docstring describes it in the table."""

    def entered(make: Any) -> Any:
        assert make.__name__ not in KINDS
        KINDS[make.__name__] = Kind(make.__name__, make.__doc__.strip().rstrip("."), weight, make)
        return make

    return entered


def case_of(seed: int, kind: str | None = None) -> Case:
    """The case of a seed: of a class, or of one drawn by the weights."""
    if kind is None:
        weights = [kind.weight for kind in KINDS.values()]
        kind = random.Random(f"kind {seed}").choices([*KINDS], weights)[0]
    files, words = KINDS[kind].make(random.Random(f"{kind} {seed}"))
    return Case(kind, seed, files, tuple(words))


# What cases are made from.


@functools.cache
def texts() -> dict[str, str]:
    """The models of the gallery and the examples, by name."""
    found = {f"gallery {name}": gallery.text(name) for name in gallery.names()}
    return found | {path.stem: path.read_text(encoding="utf-8") for path in sorted(EXAMPLES.glob("*.yaml"))}


@functools.cache
def _read(name: str) -> Data:
    data: Data = YAML(typ="safe").load(texts()[name])
    return data


def data_of(name: str) -> Data:
    """What a model says, for changes."""
    return copy.deepcopy(_read(name))


@functools.cache
def having(section: str, entry: str) -> tuple[str, ...]:
    """The models that ask for a study (section ``studies``) or an export."""
    return tuple(name for name in texts() if entry in (_read(name).get(section) or {}))


@functools.cache
def beside() -> dict[str, bytes]:
    """The tables that examples name."""
    return {path.name: path.read_bytes() for path in sorted(EXAMPLES.glob("*.csv"))}


@functools.cache
def with_tables() -> tuple[str, ...]:
    """The models that name one."""
    return tuple(name for name in texts() if any(table in json.dumps(_read(name), default=str) for table in beside()))


def folder(model: str | Data, **more: bytes) -> dict[str, bytes]:
    """The files of a case: its model, and the tables that its text names."""
    text = model if isinstance(model, str) else json.dumps(model, ensure_ascii=False, default=str)
    tables = {name: content for name, content in beside().items() if name in text}
    return {MODEL: text.encode("utf-8", "surrogatepass"), **tables, **more}


def performing(command: str, *more: str) -> list[str]:
    """The words of a command that writes results."""
    return [command, MODEL, "--out", OUT, "--json", *more]


CHECK = ["check", MODEL, "--json"]


def brief(data: Data) -> Data:
    """The same model with few samples and regions, and coarse curves."""
    studies = data.get("studies")
    if isinstance(studies, dict):
        for name in ("cycle", "sweep", "accuracy"):
            if isinstance(entry := studies.get(name), dict):
                entry["samples"] = SAMPLES
        if isinstance(entry := studies.get("workspace"), dict):
            entry["chord"] = CHORD
            for name, values in entry.get("for", {}).items():
                entry["for"][name] = values[:VALUES]
    return data


def mostly_checked(random_: random.Random, data: Data, share: float = 0.25) -> tuple[dict[str, bytes], list[str]]:
    """A changed model, run by some share, else only checked."""
    studies = data.get("studies")
    short = not isinstance(studies, dict) or {"cycle", "limits", "modes", "reactions"} >= studies.keys()
    return folder(data), performing("run") if short and random_.random() < share else CHECK


# Of model files.


@register(300)
def text(random_: random.Random) -> tuple[dict[str, bytes], list[str]]:
    """model files with altered text, lines, bytes or YAML syntax."""
    made = mutations.mutated(random_, random_.choice([*texts().values()]))
    files = folder(made)
    if random_.random() < 0.2:
        files[MODEL] = _bytes(random_, files[MODEL])
    # Regions take far longer than all else, and have a class of their own.
    short = random_.random() < 0.1 and b"workspace:" not in files[MODEL]
    return files, performing("run") if short else CHECK


@register(150)
def tree(random_: random.Random) -> tuple[dict[str, bytes], list[str]]:
    """model files with entries removed, moved, renamed, duplicated or replaced."""
    data = brief(data_of(random_.choice([*texts()])))
    for _ in range(random_.choice((1, 1, 2, 4))):
        mutations.change(random_, data)
    return mostly_checked(random_, data if isinstance(data, dict) else {})


@register(120)
def expressions(random_: random.Random) -> tuple[dict[str, bytes], list[str]]:
    """model files with random expressions: nested, with units, with names of the file."""
    data = brief(data_of(random_.choice([*texts()])))
    places = [(holder, key) for holder, key in mutations.places(data) if isinstance(holder[key], str | int | float)]
    names = names_of(data)
    for holder, key in random_.sample(places, min(len(places), random_.choice((1, 2, 3)))):
        holder[key] = expression(random_, names, random_.choice((0, 1, 2, 4)))
    return mostly_checked(random_, data)


@register(120)
def options(random_: random.Random) -> tuple[dict[str, bytes], list[str]]:
    """options of every study and export format: wrong types, invalid values, options of other studies."""
    section, registry = random_.choice((("studies", STUDIES), ("studies", STUDIES), ("exports", TARGETS)))
    name = random_.choice([*registry])
    model = random_.choice(having(section, name) or [*texts()])
    data = brief(data_of(model))
    entries = data.setdefault(section, {})
    entry = entries[name] = entries.get(name) or {}
    names = names_of(data)
    for _ in range(random_.choice((1, 1, 2, 3))):
        key = random_.choice([*registry[name].options.model_fields])
        entry[key] = random_.choice((copy.deepcopy(random_.choice(mutations.VALUES)), expression(random_, names, 1)))
        if random_.random() < 0.3:
            mutations.change(random_, entries)
    return mostly_checked(random_, data)


# Of the files that models name.


@register(100)
def tables(random_: random.Random) -> tuple[dict[str, bytes], list[str]]:
    """CSV files with altered cells, separators, headers, encodings or bytes."""
    data = brief(data_of(random_.choice(with_tables())))
    files = folder(data)
    (table,) = files.keys() - {MODEL}
    files[table] = _table(random_, files[table].decode())
    # Regions take far longer than all else, and have a class of their own.
    short = random_.random() < 0.1 and b"workspace:" not in files[MODEL]
    return files, performing("run") if short else CHECK


@register(80)
def drawings(random_: random.Random) -> tuple[dict[str, bytes], list[str]]:
    """DXF drawings of lines, arcs, circles, ellipses and splines with invalid numbers, groups or end points."""
    data = brief(data_of("five_bar_path"))
    wanted = data["studies"]["workspace"]["paths"]["wanted"]
    wanted |= {"drawing": "path.dxf", "never_reverse": False}
    del wanted["file"], wanted["between"]
    drawn = _drawing(random_)
    return folder(data, **{"path.dxf": drawn}), CHECK if random_.random() < 0.95 else performing("run")


@register(10)
def batches(random_: random.Random) -> tuple[dict[str, bytes], list[str]]:
    """altered CSV files for batch export."""
    rows = beside()["hinges.csv"].decode()
    base = texts()[BATCHED].encode()
    target = random_.choice(("process-simulate", "process-simulate", *TARGETS))
    files = {"batch.csv": _table(random_, rows), MODEL: base, f"{BATCHED}.yaml": base}
    return files, ["export", "batch.csv", "--to", target, "--out", OUT, "--json"]


# Of studies that take long, and of exports.


@register(50)
def exports(random_: random.Random) -> tuple[dict[str, bytes], list[str]]:
    """every export format for any model, with options on the command line."""
    target = random_.choice([*TARGETS])
    data = brief(data_of(random_.choice(having("exports", target) + tuple(texts()))))
    _numbers(random_, data, random_.choice((0, 1, 2)))
    words = performing("export", "--to", target)
    for _ in range(random_.choice((0, 1, 2))):
        key = random_.choice([*TARGETS[target].options.model_fields])
        words += ["--set", f"{key}={expression(random_, names_of(data), 1)}".replace("\0", "")]
    return folder(data), words


@register(20)
def samples(random_: random.Random) -> tuple[dict[str, bytes], list[str]]:
    """sweep and accuracy studies with altered numbers and distributions."""
    study = random_.choice(("sweep", "accuracy"))
    data = brief(data_of(random_.choice(having("studies", study))))
    _numbers(random_, data, random_.choice((0, 1, 2)))
    if random_.random() < 0.4:
        mutations.change(random_, data["studies"][study])
        brief(data)
    return folder(data), performing(study, "--workers", "1", "--kernel", "numpy")


@register(4)
def workspace(random_: random.Random) -> tuple[dict[str, bytes], list[str]]:
    """workspace studies of altered mechanisms."""
    data = brief(data_of(random_.choice(having("studies", "workspace"))))
    if random_.random() < 0.7:
        for part in ("quality", "errors", "paths", "trajectories"):
            data["studies"]["workspace"].pop(part, None)
    _numbers(random_, data, random_.choice((1, 2, 3)), gentle=True)
    return folder(data), performing("workspace")


@register(3)
def cam(random_: random.Random) -> tuple[dict[str, bytes], list[str]]:
    """cam studies of altered cams, with NC code."""
    data = brief(data_of(random_.choice(having("studies", "cam"))))
    _numbers(random_, data, random_.choice((1, 2)), gentle=True)
    posts = ["--post", random_.choice(("linuxcnc", "grbl", "fanuc", "none"))] if random_.random() < 0.3 else []
    return folder(data), performing("cam", *posts)


@register(25)
def large(random_: random.Random) -> tuple[dict[str, bytes], list[str]]:
    """chains, rings, grids and 2-trees of 15 to 200 links: valid, misspelled, over-constrained or disconnected."""
    links, seed = int(15 * (200 / 15) ** random_.random()), random_.randrange(10**6)
    made = large_models.CLASSES[random_.choice([*large_models.CLASSES])](links, seed)
    made = large_models.FAULTS[random_.choice([*large_models.FAULTS])](made, seed)
    run = links < 40 and random_.random() < 0.3
    return folder(made), performing("run") if run else CHECK


@register(0)  # asked for by its name: seeds of all others keep their cases
def mechanisms(random_: random.Random) -> tuple[dict[str, bytes], list[str]]:
    """valid random mechanisms of 3 to 60 links over the whole vocabulary; a quarter of them altered"""
    data = grown.mechanism(random_)
    if random_.random() < ALTERED:
        for _ in range(random_.choice((1, 1, 2))):
            random_.choice((mutations.change, _one_number))(random_, data)
    drawn = random_.random()
    if isinstance(data, dict) and len(str(data.get("links"))) > LONG:
        drawn = max(drawn, 10 * drawn - 0.2)
    if drawn < 0.06:
        return folder(data), performing("export", "--to", random_.choice([*TARGETS]))
    return folder(data), performing("run") if drawn < 0.6 else CHECK


def _one_number(random_: random.Random, data: Data) -> None:
    _numbers(random_, data, 1, gentle=random_.random() < 0.5)


# Changes.

NUMBERS = ["0", "1", "-1", "2", "90 deg", "1e300", "1e-300", "1e9", "nan", "inf", "1e400", "5 mm", "0.1 s", "10^10"]
CELLS = [
    *("", "nan", "inf", "-inf", "1e400", "1e308", "=1+1", "@x", "1,5", "x", "0", "-1", "1e-300", '"', "٣", " 7 "),
    *("\x1b[31m", "1" * 400, "--1", "0x10", "1_0", "None", "\x00"),
]
GROUPS = ["nan", "inf", "-inf", "1e400", "1e308", "0", "-1", "99999999999", "", "x", "1e-300", "-0.0", "2"]


def names_of(data: Data) -> list[str]:
    """Names that expressions of a model may have, and some that they may not."""
    sections = [data.get(name) for name in ("parameters", "drives", "links")]
    return [
        *(str(name) for section in sections if isinstance(section, dict) for name in section),
        "t",
        "pi",
        "A.x",
        "motor.angle",
        "nothing",
    ]


def expression(random_: random.Random, names: list[str], depth: int) -> str:
    """A random expression; many are wrong."""
    if depth <= 0:
        return random_.choice((random_.choice(NUMBERS), random_.choice(names), f"{random_.uniform(-9, 90):.3g}"))
    parts = [expression(random_, names, depth - random_.choice((1, 2))) for _ in range(2)]
    forms = ("{}+{}", "{}-{}", "{}*{}", "{}/{}", "({})^{}", "sqrt({})", "sin({})", "atan2({}, {})", "abs({}", "log({})")
    return random_.choice(forms).format(*parts)


def _numbers(random_: random.Random, data: Data, count: int, gentle: bool = False) -> None:
    """Other numbers in place of some; gentle ones are of the same size."""
    plain = [(h, k) for h, k in mutations.places(data) if isinstance(h[k], int | float) and not isinstance(h[k], bool)]
    plain = [(holder, key) for holder, key in plain if key not in ("linkwright", "samples", "chord")]
    for holder, key in random_.sample(plain, min(len(plain), count)):
        if gentle and random_.random() < 0.8:
            holder[key] = holder[key] * random_.choice((0.3, 0.7, 0.95, 1.05, 1.3, 3))
        else:
            holder[key] = random_.choice((0, -1, 1, 1e-9, 1e9, 1e300, 0.5, "0 mm", "1/0"))


def _bytes(random_: random.Random, content: bytes) -> bytes:
    """Some bytes otherwise, another encoding, or an early end."""
    change = random_.randrange(5)
    if change == 0:
        return content[: random_.randrange(len(content) + 1)]
    if change == 1:
        return content.decode("utf-8", "replace").encode(random_.choice(("utf-16", "utf-8-sig", "utf-32")))
    if change == 2:
        return content.decode("utf-8", "replace").encode("gb18030", "replace")
    spoiled = bytearray(content)
    for _ in range(random_.choice((1, 3, 20))):
        if spoiled:
            spoiled[random_.randrange(len(spoiled))] = random_.randrange(256)
    return bytes(spoiled)


def _table(random_: random.Random, content: str) -> bytes:
    rows = [line.split(",") for line in content.splitlines()]
    for _ in range(random_.choice((1, 1, 2, 5))):
        row, other = random_.choice(rows), random_.choice(rows)
        change = random_.randrange(7)
        if change < 3 and row:
            row[random_.randrange(len(row))] = random_.choice(CELLS)
        elif change == 3:
            rows.remove(row) if len(rows) > 1 else row.clear()
        elif change == 4:
            rows.insert(random_.randrange(len(rows) + 1), [*other])
        elif change == 5:
            row.append(random_.choice(CELLS))
        else:
            del rows[random_.randrange(1, len(rows) + 1) :]
    separator = random_.choice((",", ",", ",", ",", ";", "\t", "|"))
    raw = random_.choice(("\n", "\n", "\r\n", "\r")).join(separator.join(row) for row in rows).encode()
    return _bytes(random_, raw) if random_.random() < 0.15 else raw


SHAPES = {
    "LINE": [(10, 30), (20, 30), (11, 36), (21, 36)],
    "CIRCLE": [(10, 35), (20, 35), (40, 3)],
    "ARC": [(10, 35), (20, 35), (40, 3), (50, 10), (51, 200)],
    "ELLIPSE": [(10, 35), (20, 35), (11, 4), (21, 0), (40, 0.5), (41, 0), (42, 6.2)],
    "LWPOLYLINE": [(90, 4), (70, 1), (10, 33), (20, 33), (10, 37), (20, 33), (42, 0.3), (10, 37), (20, 37), (10, 33)],
    "SPLINE": [
        *((70, 8), (71, 3), (72, 8), (73, 4), *((40, k) for k in (0, 0, 0, 0, 1, 1, 1, 1))),
        *(pair for x, y in ((33, 33), (36, 31), (38, 38), (32, 37)) for pair in ((10, x), (20, y), (30, 0))),
    ],
}
SUBCLASS = {"LWPOLYLINE": "AcDbPolyline"}


def _drawing(random_: random.Random) -> bytes:
    """A drawing of one shape, most times spoiled."""
    shape = random_.choice([*SHAPES])
    groups: list[tuple[Any, Any]] = [(0, shape), (8, "0"), (100, "AcDbEntity")]
    groups += [(100, SUBCLASS.get(shape, f"AcDb{shape.capitalize()}")), *SHAPES[shape]]
    for _ in range(random_.choice((0, 1, 1, 2, 4))):
        at = random_.randrange(1, len(groups))
        change = random_.randrange(6)
        if change < 4:
            groups[at] = (groups[at][0], random_.choice(GROUPS))
        elif change == 4:
            del groups[at]
        else:
            groups.insert(at, random_.choice([*groups, (random_.choice((5, 62, 210, 330, 1071, 9999, -5)), "x")]))
    whole = [(0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1015"), (0, "ENDSEC"), (0, "SECTION")]
    whole += [(2, "ENTITIES"), *groups, (0, "ENDSEC"), (0, "EOF")]
    raw = "".join(f"{code}\n{value}\n" for code, value in whole).encode()
    return _bytes(random_, raw) if random_.random() < 0.15 else raw


def lines_of(case: Case) -> list[str]:
    """The model of a case by lines, for what makes it smaller."""
    return re.split("(?<=\n)", case.files[MODEL].decode("utf-8", "replace"))
