"""Mechanisms of up to 200 links as whole processes: from the model file to results, and to the answer to a fault.

Processor time, imports included, which other work on the machine changes less than the time on the clock."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from large_models import CLASSES, FAULTS

Row = dict[str, Any]
SIZES = (10, 20, 50, 100, 194)
"""Moving links asked for; a crank and the up to four links of a fault besides: the format allows 200."""


def process(*words: str, source: Path | None = None) -> tuple[float, float, int]:
    """Processor time (s), peak memory (MB) and exit code of Python in a process of its own, on one thread, with the
    package of the folder ``source`` if one is given."""
    command = [sys.executable, *words]
    here = {**os.environ, "OPENBLAS_NUM_THREADS": "1"} | ({"PYTHONPATH": str(source)} if source else {})
    here.pop("PYTHONDONTWRITEBYTECODE", None)  # where set, each process compiles all modules anew
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=here) as running:
        _, status, usage = os.wait4(running.pid, 0)
        running.returncode = os.waitstatus_to_exitcode(status)
    unit = 1 if sys.platform == "darwin" else 1024
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss * unit / 1e6, running.returncode


def command(*words: str) -> tuple[float, float, int]:
    """The same of a command of linkwright."""
    return process("-m", "linkwright", *words)


def measure(kind: str, links: int, seed: int = 0) -> Row:
    """A class of mechanism at one size: ``run`` of the sound one, ``check`` of it with each fault."""
    row: Row = {"class": kind, "links": len(CLASSES[kind](links, seed)["links"]) - 1}
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "model.yaml"
        for fault, change in FAULTS.items():
            file.write_text(json.dumps(change(CLASSES[kind](links, seed), seed)), "utf-8")
            seconds, _, code = command("check", str(file))
            row[f"check_{fault}_s"] = seconds
            if code != (0 if fault == "sound" else 1):
                raise RuntimeError(f"check of {kind}, {fault}, {links} links ended with {code}")
        file.write_text(json.dumps(CLASSES[kind](links, seed)), "utf-8")
        row["run_s"], row["run_mb"], code = command("run", str(file), "--out", str(Path(folder) / "out"))
        row["done"] = code == 0
    return row


def measured(sizes: Iterable[int]) -> Iterator[Row]:
    """All classes at all sizes, one after the other."""
    for kind in CLASSES:
        for links in sizes:
            yield measure(kind, links)


def table(rows: Iterable[Row]) -> Iterator[str]:
    """The figures as a table; a star where the motion doesn't get through."""
    checks = [f"check_{fault}_s" for fault in FAULTS]
    yield "class     links  " + "".join(f"{name[6:-2]:>12s}" for name in checks) + "       run s    MB"
    for row in rows:
        left = f"{row['class']:10s}{row['links']:5d}  " + "".join(f"{row[name]:12.2f}" for name in checks)
        yield f"{left}{row['run_s']:12.2f}{row['run_mb']:6.0f}{'' if row['done'] else ' *'}"
