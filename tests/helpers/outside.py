"""Packages beside linkwright: processes of their own that know by entry points of kinds of elements, of reductions and
of studies, which lie in folders ``outside`` of the tests."""

from __future__ import annotations

import csv
import io
import json
import os
import subprocess
import sys
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

KINDS = Path(__file__).parents[1] / "elements" / "outside"
MEASURES = Path(__file__).parents[1] / "measures" / "outside"
GROUPS = {
    "linkwright.elements": KINDS,
    "linkwright.measures": MEASURES,
    "linkwright.studies": Path(__file__).parents[1] / "studies" / "outside",
}


def path(folder: Path) -> list[str]:
    """Where Python looks in a folder for kinds: first there, which makes the package's entry points known too."""
    info = folder / "outside-1.0.dist-info"
    info.mkdir(exist_ok=True)
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: outside\nVersion: 1.0\n", encoding="utf-8")
    text = ""
    for group, place in GROUPS.items():
        text += f"[{group}]\n" + "".join(f"{kind.stem} = {kind.stem}\n" for kind in sorted(place.glob("*.py")))
    (info / "entry_points.txt").write_text(text, encoding="utf-8")
    return [str(folder), *map(str, GROUPS.values())]


def python(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    """Python in a folder, with the package's entry points."""
    places = [*path(folder), *filter(None, [os.environ.get("PYTHONPATH")])]
    return subprocess.run(
        [sys.executable, *words],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(places), "PYTHONDONTWRITEBYTECODE": "1"},
        capture_output=True,
        text=True,
        encoding="utf-8",
        check=False,
    )


def without_kinds(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    """The command line where the package isn't installed."""
    command = [sys.executable, "-m", "linkwright", *words]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)


def linkwright(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    """The command line: a process forked off one that has started already, which takes longest."""
    if not hasattr(os, "fork"):
        return python(folder, "-m", "linkwright", *words)
    server = _server()
    assert server.stdin is not None
    assert server.stdout is not None
    server.stdin.write(json.dumps({"folder": str(folder), "path": path(folder), "words": words, "seconds": 600}) + "\n")
    server.stdin.flush()
    code, out, err = json.loads(server.stdout.readline())
    return subprocess.CompletedProcess(list(words), code, out, err)


@cache
def _server() -> subprocess.Popen[str]:
    pipe = subprocess.PIPE
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "OPENBLAS_NUM_THREADS": "1"}  # threads outlive no fork
    command = [sys.executable, str(Path(__file__).parents[2] / "tools" / "forked_commands.py")]
    return subprocess.Popen(command, env=environment, stdin=pipe, stdout=pipe, text=True, encoding="utf-8")


def planted(folder: Path, kind: str, *changes: tuple[str, str]) -> None:
    """A copy of a kind's file in the folder, which comes first, with other text."""
    text = (KINDS / f"{kind}.py").read_text(encoding="utf-8")
    for right, wrong in changes:
        assert right in text
        text = text.replace(right, wrong)
    (folder / f"{kind}.py").write_text(text, encoding="utf-8")


def table(path: Path) -> tuple[dict[str, Any], Any]:
    """The columns of a CSV file by their heads, and the time (s)."""
    heads, *rows = csv.reader(io.StringIO(path.read_text(encoding="utf-8-sig")))
    values = np.array([[cell or "nan" for cell in row] for row in rows], dtype=float).T
    columns = dict(zip(heads, values, strict=True))
    return columns, columns["t [s]"]
