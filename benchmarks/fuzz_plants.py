"""Faults planted in linkwright, each in a process of the fuzzer: a fuzzer that doesn't find them is ineffective.

Each function plants a fault in the process that calls it. ``PLANTS`` lists for each the class of cases that should
detect it, and a word of the failure that should be reported.
"""

from __future__ import annotations

import re
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any


@dataclass(frozen=True)
class Plant:
    """A planted fault: what it is, how it is planted, the class of cases, and a word of the failure to be reported."""

    about: str
    plant: Callable[[], None]
    kind: str
    reported: str


def empty_list() -> None:
    """An empty list in a model file raises an IndexError."""
    from linkwright.model import model_file

    read = model_file.read_document

    def spoiled(raw: bytes) -> Any:
        made = read(raw)
        _first_of_lists(made[1].data)
        return made

    model_file.read_document = spoiled


def _first_of_lists(data: Any) -> None:
    inside = data.values() if isinstance(data, dict) else data if isinstance(data, list) else ()
    if isinstance(data, list):
        data[0]
    for value in inside:
        _first_of_lists(value)


def hang_on_nan() -> None:
    """A NaN in a DXF drawing causes an endless loop that no signal interrupts."""
    import signal

    from linkwright.studies.workspace import path_options

    read = path_options.from_dxf

    def spoiled(file: str, size: float, folder: Path | None = None, *more: Any) -> Any:
        if b"nan" in Path(folder or Path(), file).read_bytes():
            signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGPROF})
            while True:
                pass
        return read(file, size, folder, *more)

    path_options.from_dxf = spoiled


def nan_in_a_table() -> None:
    """CSV files contain NaN instead of blank cells and zeros."""
    from linkwright.model import csv_text

    cell = csv_text.cell
    _everywhere("cell", cell, lambda value: "nan" if value == 0 else cell(value))


def half_written() -> None:
    """Long files are written without their second half."""
    from linkwright.model import output_files

    write = output_files.write_aside

    def spoiled(path: Path, content: str | bytes, *more: Any, **how: Any) -> None:
        write(path, content[: len(content) // 2] if len(content) > 20_000 else content, *more, **how)

    _everywhere("write_aside", write, spoiled)


def outside_the_folder() -> None:
    """A copy of the report is written outside the results folder."""
    from linkwright.model import output_files

    write = output_files.write_aside

    def spoiled(path: Path, content: str | bytes, *more: Any, **how: Any) -> None:
        write(path, content, *more, **how)
        if path.name == "report.html":
            write(path.parent.parent / path.name, content)

    _everywhere("write_aside", write, spoiled)


def memory_by_a_number() -> None:
    """Memory use grows with the largest number in a model file."""
    from linkwright.model import model_file

    read = model_file.read_document

    def spoiled(raw: bytes) -> Any:
        largest = max((float(word) for word in re.findall(rb"(?<![\w.])\d+(?:e\d+)?", raw)), default=0.0)
        held = b"\1" * int(min(largest, 1.2e9)) if largest > 1e8 else b""
        return *read(raw), *held[:0]

    model_file.read_document = spoiled


def other_answers() -> None:
    """Results depend on earlier work of the same process."""
    from linkwright.model import csv_text

    cell, asked = csv_text.cell, [0]

    def spoiled(value: float | int) -> str:
        asked[0] += 1
        return cell(value * (1 + 1e-15 * asked[0]))

    _everywhere("cell", cell, spoiled)


def left_aside() -> None:
    """A temporary file isn't removed."""
    from linkwright.model import output_files

    write = output_files.write_aside

    def spoiled(path: Path, content: str | bytes, *more: Any, **how: Any) -> None:
        write(path, content, *more, **how)
        Path(tempfile.mkstemp(prefix=f".{path.name}.", dir=path.parent)[1])

    _everywhere("write_aside", write, spoiled)


def silent_refusal() -> None:
    """An invalid file is rejected without a problem report."""
    from linkwright.model import model_file

    read = model_file.read_document

    def spoiled(raw: bytes) -> Any:
        made = read(raw)
        if made[0] is None and len(raw) % 7 == 0:
            del made[1].findings[:]
        return made

    model_file.read_document = spoiled


def wrong_speeds() -> None:
    """Angular velocities of links are a millionth too large."""
    from linkwright.kernels.compiled import Compiled

    rows = Compiled.closed_form_rows

    def spoiled(self: Any, names: Any, t: Any, rates: bool = False) -> Any:
        found = rows(self, names, t, rates)
        for k, name in enumerate(names):
            if isinstance(name, str) and name.endswith(".omega"):
                found[2 * k if rates else k] *= 1 + 1e-6
        return found

    Compiled.closed_form_rows = spoiled  # type: ignore[method-assign]


def rare_kind() -> None:
    """The verification of differentials raises a KeyError."""
    from linkwright.elements.differential import Differential

    def spoiled(*_: Any) -> Any:
        raise KeyError("shaft")

    Differential.restated = spoiled  # type: ignore[method-assign]


def dividing_table() -> None:
    """Tables with quintic splines divide by zero."""
    import numpy as np

    from linkwright.laws.table import TableLaw

    made = TableLaw.__post_init__

    def spoiled(self: TableLaw) -> None:
        made(self)
        if self.degree == 5:
            np.divide(self.x, np.zeros_like(self.x))

    TableLaw.__post_init__ = spoiled  # type: ignore[method-assign]


def _everywhere(name: str, old: Any, new: Any) -> None:
    """Put a function in the place of another, in all modules that have imported it."""
    import sys

    for module in [*sys.modules.values()]:
        if getattr(module, "__name__", "").startswith("linkwright") and getattr(module, name, None) is old:
            setattr(module, name, new)


PLANTS: dict[str, Plant] = {
    plant.__name__: Plant((plant.__doc__ or "").rstrip("."), plant, kind, reported)
    for plant, kind, reported in (
        (empty_list, "tree", "IndexError"),
        (hang_on_nan, "drawings", "hangs"),
        (nan_in_a_table, "samples", "NaN or infinity"),
        (half_written, "samples", "no JSON"),
        (outside_the_folder, "samples", "outside its folder"),
        (left_aside, "exports", "left aside"),
        (memory_by_a_number, "expressions", "memory"),
        (other_answers, "samples", "differs the second time"),
        (silent_refusal, "text", "accepts"),
        (wrong_speeds, "mechanisms", "unproven"),
        (rare_kind, "mechanisms", "KeyError"),
        (dividing_table, "mechanisms", "RuntimeWarning"),
    )
}
