"""Packages beside linkwright: a process of its own that knows of the kinds in ``elements/outside`` by entry points."""

from __future__ import annotations

import csv
import io
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np

KINDS = Path(__file__).parents[1] / "elements" / "outside"


def python(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    """Python in a folder, with the package's entry points."""
    info = folder / "outside-1.0.dist-info"
    info.mkdir(exist_ok=True)
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: outside\nVersion: 1.0\n", encoding="utf-8")
    points = "".join(f"{path.stem} = {path.stem}\n" for path in sorted(KINDS.glob("*.py")))
    (info / "entry_points.txt").write_text(f"[linkwright.elements]\n{points}", encoding="utf-8")
    path = [str(folder), str(KINDS), *filter(None, [os.environ.get("PYTHONPATH")])]
    return subprocess.run(
        [sys.executable, *words],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(path), "PYTHONDONTWRITEBYTECODE": "1"},
        capture_output=True,
        text=True,
        encoding="utf-8",
        check=False,
    )


def linkwright(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    """The command line."""
    return python(folder, "-m", "linkwright", *words)


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
