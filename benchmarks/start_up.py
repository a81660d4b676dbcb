"""Whole commands on a small model, imports included, against the third parties' imports alone, in alternation.

Processor time of processes. ``--before SRC`` measures another state of the package in the same run, such as
``git worktree add ../before REVISION`` and ``--before ../before/src``."""

from __future__ import annotations

import argparse
import statistics
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path

from whole_runs import process

FEEDER = Path(__file__).parents[1] / "examples" / "paper_feeder.yaml"
BARE = ("-c", "import numpy, pydantic")
COMMANDS = {
    "numpy, pydantic imported": BARE,
    "linkwright --help": ("-m", "linkwright", "--help"),
    "linkwright check": ("-m", "linkwright", "check", str(FEEDER)),
    "linkwright run": ("-m", "linkwright", "run", str(FEEDER), "--out", "{out}"),
}


def seconds(words: Sequence[str], source: Path | None) -> float:
    """Processor time (s) of Python with these arguments, with the package of ``source`` if one is given."""
    time, _, code = process(*words, source=source)
    if code:
        raise RuntimeError(f"{' '.join(words)} ended with {code}")
    return time


def measured(states: Mapping[str, Path | None], repeat: int) -> dict[tuple[str, str], list[float]]:
    """Times by command and state, one after the other; a first round, which writes compiled modules, isn't counted."""
    found: dict[tuple[str, str], list[float]] = {(name, state): [] for name in COMMANDS for state in states}
    with tempfile.TemporaryDirectory() as out:
        for _ in range(repeat + 1):
            for (name, state), times in found.items():
                times.append(seconds([word.format(out=out) for word in COMMANDS[name]], states[state]))
    return {key: times[1:] for key, times in found.items()}


def main(arguments: Sequence[str] | None = None) -> None:
    """Print medians and what they are of the first command and of the state before."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--repeat", type=int, default=15)
    parser.add_argument("--before", type=Path, help="the src folder of another state")
    options = parser.parse_args(arguments)
    states = {"now": None} | ({"before": options.before.resolve()} if options.before else {})
    medians = {key: statistics.median(times) for key, times in measured(states, options.repeat).items()}
    bare = medians[next(iter(COMMANDS)), "now"]
    for (name, state), median in medians.items():
        against = f", {medians[name, 'now'] / median:.2f} of it now" if state == "before" else ""
        print(f"{name:34s} {state:7s}{median:6.3f} s {median / bare:5.2f} times those imports{against}")


if __name__ == "__main__":
    main()
