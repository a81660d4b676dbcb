"""How the fuzzer performs a case, and what it holds the outcome to.

A case is performed by the command line's own code in this process, in a folder of its own. Then

- nothing is raised, and the exit code is 0, 1 or 2; NumPy and Python warn of nothing;
- what is printed as JSON is JSON without NaN; a sound file is described; exit codes 1 and 2 come with findings that
  have a code, a place, words;
- nothing is written outside the folder of results, and what lies in it is whole: JSON and CSV of finite numbers, pages,
  drawings and NC code to their last line, no file left aside;
- no verification fails: a result that the program itself finds wrong is a fault of its check or of its computation;
- memory grows by no more than :data:`MEMORY`, and the time of the processor by no more than :data:`PATIENCE`;
- performed once more, a case gives the same bytes (a share of the cases).
"""

from __future__ import annotations

import contextlib
import csv
import io
import json
import os
import re
import shutil
import sys
import tempfile
import traceback
import warnings
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

from fuzz_cases import OUT, Case
from patience import limited

from linkwright.words import catalogue

PATIENCE = 25.0
"""Seconds of processor time for one case."""
LONGER = {"workspace": 50.0, "mechanisms": 95.0}
"""More seconds for some classes: a region whose way back is a triad takes up to a minute, as do dozens of links in
groups solved by Newton's method, with a page that computes them."""
MEMORY = 900
"""MiB that a case may add to the process."""
MORE_MEMORY = {"mechanisms": 600}
"""More MiB for some classes."""
TWICE = 8
"""Every so manieth case is performed twice."""
QUOTED, GAP = re.compile(r"'.*'", re.DOTALL), re.compile(r"\b(None|nan)\b")
PLACELESS = ("file.", "folder.", "blocks.", "name.", "export.", "study.")
"""Codes that begin so may be of the file as a whole or of the command line."""
UNPROVEN = "Verification failed"
"""How findings begin that say that a result isn't right."""


@dataclass
class Verdict:
    """What came of a case: its exit code and findings' codes, and what is wrong with that."""

    kind: str
    seed: int
    code: int | None = None
    came: tuple[str, ...] = ()
    faults: list[str] = field(default_factory=list)
    seconds: float = 0.0
    mebibytes: float = 0.0


@dataclass
class Performed:
    """One performance: the exit code, what was printed, the files written by name, what is wrong."""

    code: int | None = None
    out: str = ""
    files: dict[str, bytes] = field(default_factory=dict)
    faults: list[str] = field(default_factory=list)


def judge(case: Case) -> Verdict:
    """Perform a case and hold the outcome to all of the above."""
    verdict = Verdict(case.kind, case.seed)
    before, start = _peak(fresh=True), sum(os.times()[:2])
    done = performed(case)
    verdict.seconds, verdict.mebibytes = sum(os.times()[:2]) - start, max(0.0, _peak() - before)
    verdict.code, verdict.faults = done.code, done.faults
    if verdict.mebibytes > MEMORY + MORE_MEMORY.get(case.kind, 0):
        verdict.faults.append(f"memory: {verdict.mebibytes:.0f} MiB")
    if not done.faults:
        verdict.came = tuple(_findings(done, case, verdict.faults))
        given = b" ".join(case.files.values())
        verdict.faults += [fault for name, content in done.files.items() for fault in unsound(name, content, given)]
    if not verdict.faults and case.seed % TWICE == 0:
        verdict.faults += _differences(done, performed(case))
    return verdict


def performed(case: Case) -> Performed:
    """Perform a case once, in a folder that is removed."""
    done, home = Performed(), Path.cwd()
    place = Path(tempfile.mkdtemp(prefix="fuzz-"))
    work = place / "work"
    work.mkdir()
    try:
        for name, content in case.files.items():
            (work / name).write_bytes(content)
        os.chdir(work)
        _command(case, done)
        os.chdir(home)
        _look(place, case, done)
    finally:
        os.chdir(home)
        shutil.rmtree(place, ignore_errors=True)
    return done


def _command(case: Case, done: Performed) -> None:
    """The command line on the case's words, as in a process of its own."""
    from linkwright import cli

    out, err = io.TextIOWrapper(io.BytesIO(), "utf-8"), io.TextIOWrapper(io.BytesIO(), "utf-8")
    told, sys.argv = sys.argv, ["linkwright", *case.words]
    os.environ["SOURCE_DATE_EPOCH"] = "1700000000"
    try:
        with (
            contextlib.redirect_stdout(out),
            contextlib.redirect_stderr(err),
            warnings.catch_warnings(record=True) as warned,
            _writing_elsewhere(done),
            limited(PATIENCE + LONGER.get(case.kind, 0.0)),
        ):
            warnings.simplefilter("always")
            done.code = cli._performed() or 0
    except BaseException as error:
        if isinstance(error, KeyboardInterrupt):
            raise
        at = [frame for frame in traceback.extract_tb(error.__traceback__) if "linkwright" in frame.filename][-1:]
        where = f"{Path(at[0].filename).name}:{at[0].lineno} {at[0].name}" if at else "-"
        done.faults.append(f"{type(error).__name__} in {where}: {error}"[:300])
    finally:
        sys.argv = told
    done.faults += [
        f"warns of {w.category.__name__} in {Path(w.filename).name}:{w.lineno}: {w.message}"[:200]
        for w in warned
        if issubclass(w.category, RuntimeWarning)
    ]
    for stream in (out, err):
        stream.flush()
    done.out = out.buffer.getvalue().decode("utf-8", "replace")  # type: ignore[attr-defined]
    complaint = err.buffer.getvalue().decode("utf-8", "replace")  # type: ignore[attr-defined]
    if "Traceback" in complaint or "Warning:" in complaint:
        done.faults.append(f"standard error: {complaint[-200:]}")
    if done.code not in (0, 1, 2) and not done.faults:
        done.faults.append(f"exit code {done.code}")


_OUTSIDE: list[str] | None = None


@cache
def _watch() -> None:
    """Note files that are opened for writing outside the working folder."""
    own = [os.devnull, tempfile.gettempdir(), "/dev", "/proc"]
    allowed = tuple(os.path.realpath(place) for place in own)

    def hook(event: str, given: tuple[Any, ...]) -> None:
        if _OUTSIDE is None or event != "open" or not isinstance(given[0], str | bytes | os.PathLike):
            return
        mode, flags = given[1], given[2]
        if (isinstance(mode, str) and set(mode) & set("wax+")) or (mode is None and flags & (os.O_WRONLY | os.O_RDWR)):
            path = os.path.realpath(os.fsdecode(given[0]))
            if not path.startswith(allowed) and "__pycache__" not in path:
                _OUTSIDE.append(path)

    sys.addaudithook(hook)


@contextlib.contextmanager
def _writing_elsewhere(done: Performed) -> Iterator[None]:
    global _OUTSIDE
    _watch()
    _OUTSIDE = found = []
    try:
        yield
    finally:
        _OUTSIDE = None
        done.faults += [f"writes to {path}" for path in found]


def _look(place: Path, case: Case, done: Performed) -> None:
    """Take the files that were written, and see that nothing else was."""
    for path in sorted(place.rglob("*")):
        name = path.relative_to(place).as_posix()
        inside = name.removeprefix(f"work/{OUT}/")
        if path.is_dir() or name.removeprefix("work/") in case.files:
            continue
        if inside == name:
            done.faults.append(f"writes {name}, outside its folder")
        else:
            done.files[inside] = path.read_bytes()
    for name, content in case.files.items():
        if not (place / "work" / name).is_file() or (place / "work" / name).read_bytes() != content:
            done.faults.append(f"changes {name}")


# What is held against the outcome.


def _findings(done: Performed, case: Case, faults: list[str]) -> list[str]:
    """The codes of what was found; what is wrong with how that is told goes to the faults."""
    told = _json(done.out)
    if not isinstance(told, dict):
        faults.append(f"prints no JSON: {done.out[:100]!r}")
        return []
    found = [item for item in told.get("findings", []) if isinstance(item, dict)]
    unmet = done.code == 1 and '"met": false' in done.out
    if done.code and not unmet and not any(item["severity"] == "error" for item in found):
        faults.append(f"exit code {done.code} without a finding")
    if not done.code and any(item["severity"] == "error" for item in found):
        faults.append("exit code 0 with an error")
    if told.get("ok") and not told.get("structure"):
        faults.append("accepts what it doesn't describe")
    given = b"\n".join(case.files.values()).decode("utf-8", "replace") + " ".join(case.words)
    for item in found:
        faults.extend(gaps(item, given, [*case.files]))
    return [item["code"] for item in found] or ["nothing found"]


def gaps(item: dict[str, Any], given: str = "", files: Iterable[str] = ()) -> Iterator[str]:
    """What a finding, as JSON has it, lacks; ``given`` is the input, whose words may be cited; one of ``files`` that it
    names is a place."""
    code = item["code"]
    if f"{code}.what" not in catalogue() or f"{code}.mend" not in catalogue():
        yield f"{code} isn't in the catalogue"
    if catalogue().get(f"{code}.what", "").startswith(UNPROVEN):
        yield f"unproven: {item['what']:.200}"
    for key in ("what", "mend"):
        text = QUOTED.sub("", item[key] or "")
        gap = GAP.search(text)
        if not (item[key] or "").strip() or (gap is not None and gap.group() not in given):
            yield f"{code} says: {item[key]!r:.200}"
    placed = item["line"] is not None or item["element"] or any(name in item["what"] for name in files)
    if not placed and not code.startswith(PLACELESS):
        yield f"{code} has neither line nor element"


def _strict(word: str) -> Any:
    raise ValueError(f"{word} in JSON")


def _json(text: str) -> Any:
    try:
        return json.loads(text, parse_constant=_strict)
    except ValueError:
        return None


def unsound(name: str, content: bytes, given: bytes = b"") -> Iterator[str]:
    """What is wrong with a written file; ``given`` is the input, whose names may be nan and inf."""
    base, suffix = Path(name).name, Path(name).suffix
    if base.startswith(".") and base != ".linkwright.lock":
        yield f"{name} is left aside"
        return
    if base.startswith("."):
        return
    if not content:
        yield f"{name} is empty"
    elif suffix in (".json", ".geojson"):
        if _json(content.decode()) is None:
            yield f"{name} is no JSON of finite numbers"
    elif suffix == ".csv":
        yield from _unsound_table(name, content.decode())
    elif suffix in (".xml", ".svg"):
        try:
            ElementTree.fromstring(content)
        except ElementTree.ParseError as error:
            yield f"{name} is no XML: {error}"
    elif suffix == ".html" and not content.rstrip().endswith(b"</html>"):
        yield f"{name} ends early"
    elif suffix == ".dxf" and (not content.rstrip().endswith(b"EOF") or re.search(rb"\n\s*-?(nan|inf)\b", content)):
        yield f"{name} isn't whole, or has numbers that aren't"
    elif suffix in (".ngc", ".nc", ".mpf", ".txt", ".cs"):
        found = re.search(rb"[=\sXYZIJKF](nan|inf)\b", content)
        if found is not None and found.group(1) not in given:
            yield f"{name} has numbers that aren't"


def _unsound_table(name: str, text: str) -> Iterator[str]:
    """Rows of one width, whose cells are no NaN and no infinity; and an end of the last line."""
    rows = [row for row in csv.reader(io.StringIO(text)) if row and not row[0].startswith("#")]
    if not text.endswith("\n") or len({len(row) for row in rows}) > 1:
        yield f"{name} isn't whole"
    if any(cell.strip().lower().lstrip("+-") in ("nan", "inf", "infinity") for row in rows[1:] for cell in row):
        yield f"{name} has NaN or infinity"


def _differences(first: Performed, second: Performed) -> list[str]:
    """Where two performances of one case differ; drawings have times and random numbers in their heads."""
    names = {name for name in {*first.files, *second.files} if not name.endswith((".json", ".html", ".dxf", ".step"))}
    found = [name for name in sorted(names) if first.files.get(name) != second.files.get(name)]
    if first.code != second.code or first.out != second.out:
        found.append("what is printed")
    return [f"differs the second time: {name}" for name in found]


def _peak(fresh: bool = False) -> float:
    """The largest memory of this process (MiB), ``fresh`` from now on; 0 where the system doesn't tell."""
    try:
        if fresh:
            Path("/proc/self/clear_refs").write_text("5")
        status = Path("/proc/self/status").read_text()
    except OSError:
        return 0.0
    found = re.search(r"VmHWM:\s+(\d+)", status)
    return int(found.group(1)) / 1024 if found else 0.0
