"""Names and texts that would be something else in another program: in all that is written they stay texts.

Every study and every export writes a model twice, with a harmless title and with a hostile one. The lines of both are
the same but for those that hold the title.
"""

from __future__ import annotations

import csv
import io
import json
import os
import re
from collections.abc import Callable
from html.parser import HTMLParser
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

import pytest

from app.models import SOUND
from linkwright.app import Writing, examine_export, examine_file, export_batch, export_into
from linkwright.app.job import carry_out
from linkwright.exports import TARGETS
from linkwright.model.document import Document, dump, parse_document, read_document, save
from linkwright.model.yaml_text import read_text
from linkwright.model.yaml_write import write_text
from linkwright.studies import STUDIES, RunContext

EXAMPLES = Path(__file__).parents[2] / "examples"
QUICK = {
    "accuracy": "four_bar_calibration",
    "cam": "groove_cam",
    "cycle": "four_bar",
    "limits": "bonnet_hinge",
    "modes": "sauer_platform",
    "workspace": "five_bar_path",
}
"""An example of a study that is performed sooner than the shortest one."""

UNSEEN = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u2028\u2029\u202a-\u202e\u2066-\u2069]")
NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")
HARMLESS = "Harmless"
PAYLOADS = [
    '=HYPERLINK("http://example.org")',
    'a\nSystem.Diagnostics.Process.Start("calc.exe");',
    "a\r\nM30",
    "a\u2028G0 X999",
    "a\x85M3",
    "a\u2029b",
    "0\nENDSEC\n0\nEOF",
    "*/ int x; /*",
    "// \\",
    'a"; b',
    "</script><script>alert(1)</script>",
    '"><img src=x onerror=alert(1)>',
    "</title></style></svg>",
    "--> ]]> <?x ?> <!ENTITY a SYSTEM 'file:///etc/passwd'>",
    "&lt; &#10; %0a",
    "{0} {title} %s ${x}",
    "[bold]a[/] [/nothing]",
    ") G0 X999 (",
    "\u202ereversed\u2066",
    "\t-1+1\t@SUM(1)",
    "- a: b # c",
]
HOSTILE = "\n".join(PAYLOADS)
FILE = "=a'& ;(c).yaml" if os.name == "nt" else "=a'&\n\x1b[31m<b>;(c).yaml"


def example_of(study: str) -> Path:
    """An example that has a study: the one named above, or the shortest."""
    if study in QUICK:
        return EXAMPLES / f"{QUICK[study]}.yaml"
    files = [path for path in EXAMPLES.glob("*.yaml") if study in studies(path)]
    return min(files, key=lambda path: path.stat().st_size)


def studies(path: Path) -> set[str]:
    return {*(data_of(path.read_bytes()).get("studies") or {})}


def data_of(content: bytes) -> dict[str, Any]:
    return read_text(content).data  # type: ignore[no-any-return]


def titled(data: dict[str, Any], text: str) -> Document:
    """A model with a text wherever there may be one."""
    given = {name: at if isinstance(at, dict) else {"value": at} for name, at in (data.get("parameters") or {}).items()}
    parameters = {name: {**at, "note": text} for name, at in given.items()}
    document = parse_document(data | {"name": text, "note": text, "source": text, "parameters": parameters})
    assert document is not None
    return document


def with_texts(path: Path, text: str, file: Path) -> Path:
    """A copy of an example, beside all its tables, with a text wherever there may be one."""
    for table in path.parent.glob("*.csv"):
        (file.parent / table.name).write_bytes(table.read_bytes())
    save(titled(data_of(path.read_bytes()), text), file)
    return file


def both(path: Path, folder: Path, write: Callable[[Path, Path], None]) -> tuple[dict[str, bytes], dict[str, bytes]]:
    """What is written of an example with a harmless title and with a hostile one, by the names of the files."""
    made = []
    for text, name in ((HARMLESS, f"{HARMLESS}.yaml"), (HOSTILE, FILE)):
        inside = folder / text[:1].replace("=", "x")
        inside.mkdir()
        file = with_texts(path, text, inside / name)
        write(file, inside / "out")
        made.append({file.name: file.read_bytes() for file in sorted((inside / "out").iterdir()) if file.is_file()})
    return made[0], made[1]


@pytest.fixture(autouse=True)
def _one_date(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1767225600")


@pytest.mark.parametrize("study", STUDIES)
def test_what_studies_write(study: str, tmp_path: Path) -> None:
    def write(file: Path, out: Path) -> None:
        job = carry_out(examine_file(file), RunContext(out=out), Writing(["netcdf"], comments=True))
        assert study in job.outcomes

    harmless, hostile = both(example_of(study), tmp_path, write)
    compare(harmless, hostile)


@pytest.mark.parametrize("to", TARGETS)
@pytest.mark.parametrize("name", ["four_bar", "slider_crank_gas", "press_law"])
def test_what_exports_write(to: str, name: str, tmp_path: Path) -> None:
    def write(file: Path, out: Path) -> None:
        out.mkdir()
        export_into(examine_export(file, to), to, out, Writing(comments=True))

    harmless, hostile = both(EXAMPLES / f"{name}.yaml", tmp_path, write)
    compare(harmless, hostile)


def test_what_a_batch_writes(tmp_path: Path) -> None:
    """Its CSV file and the model beside it have hostile names; those of rows are names of files."""

    def write(file: Path, out: Path) -> None:
        model = file.with_name(f"{HARMLESS}2.yaml" if HARMLESS in file.name else "=m'& ;(c)2.yaml")
        table = file.with_suffix(".csv")
        table.write_text(f"name,model,a\nleft,{file.rename(model).name},40\n", "utf-8")
        assert export_batch(table, "process-simulate", out).exit_code == 0

    harmless, hostile = both(EXAMPLES / "four_bar.yaml", tmp_path, write)
    compare(harmless, hostile)


def compare(harmless: dict[str, bytes], hostile: dict[str, bytes]) -> None:
    """Hold the files of both to each other, and to what their kinds allow."""
    assert harmless.keys() == hostile.keys()
    for name, content in hostile.items():
        suffix = Path(name).suffix
        if suffix in (".nc", ".png", ".step"):
            continue
        text = content.decode()
        assert not UNSEEN.search(text), name
        if suffix in PARSED:
            assert PARSED[suffix](text) == PARSED[suffix](harmless[name].decode()), name
        if suffix != ".html":
            same_lines(name, harmless[name].decode(), text)


CHANGING = re.compile(r"[0-9a-f]{12,}|\{[0-9A-F-]{36}\}|\d+\.\d{6,}|(?<=\"size\": )\d+|(?<=\"line\": )\d+")
"""Hashes, sizes and lines of files; dates and identifiers of drawings."""


def same_lines(name: str, harmless: str, hostile: str) -> None:
    """The lines are the same ones, but that the hostile text stands in place of the harmless one, within its line."""
    first, second = (CHANGING.sub("#", text).splitlines() for text in (harmless, hostile))
    assert len(first) == len(second), name
    for a, b in zip(first, second, strict=True):
        if HARMLESS in a:
            before, after = re.split(f"{HARMLESS}(?:.*{HARMLESS})?", a, maxsplit=1)
            assert b.startswith(before.rstrip("'\"")), (name, b)
            assert b.endswith(after.lstrip("'\"")), (name, b)
        elif name.endswith(".dxf"):
            assert bool(a.strip().isdigit()) == bool(b.strip().isdigit()), (name, b)
        else:
            assert a == b, (name, b)


def _cells(text: str) -> list[int]:
    """The cells of each row; none begins a formula."""
    rows = [*csv.reader(io.StringIO("".join(line for line in text.splitlines(True) if not line.startswith("#"))))]
    for row in rows:
        assert all(NUMBER.fullmatch(cell) or not cell.startswith(("=", "+", "-", "@", "\t")) for cell in row)
    return [*map(len, rows)]


def _elements(text: str) -> list[Any]:
    return [(element.tag, sorted(element.attrib)) for element in ET.fromstring(text).iter()]


class _Page(HTMLParser):
    """The elements of a page with their attributes, and what its scripts hold."""

    def __init__(self) -> None:
        super().__init__()
        self.seen: list[Any] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.seen.append((tag, sorted(name for name, _ in attrs)))

    def handle_endtag(self, tag: str) -> None:
        self.seen.append(f"/{tag}")

    def handle_comment(self, data: str) -> None:
        self.seen.append(data)

    def handle_data(self, data: str) -> None:
        if self.seen and self.seen[-1] == ("script", ["id", "type"]):
            self.seen.append(_shape(_without_texts(json.loads(data))))
        elif self.seen and self.seen[-1] in (("script", []), ("style", [])):
            self.seen.append(data)


def _without_texts(data: Any) -> Any:
    """What scripts hold without the texts of a page by language, whose keys are the texts themselves."""
    for other in data.get("others", {}).values():
        for part in ("texts", "attributes", "inside"):
            assert all(isinstance(value, str | list | dict) for value in other.pop(part).values())
    return data


def _page(text: str) -> list[Any]:
    reader = _Page()
    reader.feed(text)
    return reader.seen


def _shape(data: Any) -> Any:
    """The keys and kinds of plain data; keys that are names of model files may be any."""
    if isinstance(data, dict):
        return {"file" if key.endswith(".yaml") else key: _shape(value) for key, value in data.items()}
    return [*map(_shape, data)] if isinstance(data, list) else type(data).__name__


def _no_code_but_its_own(text: str) -> str:
    """C# without comments and the insides of strings."""
    return re.sub(r'//[^\n\r\x85\u2028\u2029]*|"(\\.|[^"\\])*"', "", text)


def _drawing(text: str) -> list[str]:
    ezdxf = pytest.importorskip("ezdxf")
    return [entity.dxftype() for entity in ezdxf.read(io.StringIO(text)).modelspace()]


PARSED: dict[str, Callable[[str], Any]] = {
    ".cs": _no_code_but_its_own,
    ".csv": _cells,
    ".dxf": _drawing,
    ".geojson": lambda text: _shape(json.loads(text)),
    ".html": _page,
    ".json": lambda text: _shape(json.loads(text)),
    ".svg": _elements,
    ".xml": _elements,
}


@pytest.mark.parametrize("payload", PAYLOADS)
def test_names_of_elements_are_refused_in_clear_words(payload: str) -> None:
    data = data_of(SOUND.encode())
    for section, entries in data.items():
        if not isinstance(entries, dict) or section == "units":
            continue
        name, value = next(iter(entries.items()))
        changed = {**data, section: {payload: value, **{key: v for key, v in entries.items() if key != name}}}
        document, source = read_document(write_text(changed).encode())
        assert document is None
        for finding in source.findings:
            assert not UNSEEN.search(str(finding))
            assert len(str(finding).splitlines()) == 1


@pytest.mark.parametrize("text", PAYLOADS)
def test_a_saved_file_holds_the_texts_as_they_are(text: str) -> None:
    data = data_of(SOUND.encode())
    saved = dump(titled(data, text))
    assert len(saved.splitlines()) == len(dump(titled(data, HARMLESS)).splitlines())
    again = data_of(saved.encode())
    assert again["name"] == again["note"] == text
