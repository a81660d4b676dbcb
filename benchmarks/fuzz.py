"""Wrong files by the thousand: ``python benchmarks/fuzz.py [--count 100000] [--seed 0] [--class NAME] [--jobs 2]``.

Cases of the classes of fuzz_cases.py, each performed by the command line and held to what fuzz_judge.py says: a failure
is an exception, a hang, memory without bound, a warning of NumPy, NaN in a file, a file that isn't whole or lies
elsewhere, a finding without place or words, or another answer the second time.

Prints each failure with its class and seed, then counts; exit code 1 where there are any. ``--minutes`` ends it early,
``--save FILE`` keeps the counts for docs/validation/robustness.md (robustness.py). ``--show SEED`` prints what a case
is, ``--folder PLACE`` writes its files, ``--smaller SEED`` prints the fewest lines of its model that still fail.
``--plants`` plants known faults instead (fuzz_plants.py), and says after how many cases each is found.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import shlex
import sys
import time
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

# Cases share the cores: threads of linear algebra that wait for one would count as a case's processor time.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from fuzz_cases import KINDS, MODEL, Case, case_of, lines_of
from fuzz_judge import Verdict, judge
from fuzz_plants import PLANTS
from fuzz_processes import imported, judged, patience

WITHIN = 100
"""The number of cases of its class within which a planted fault is to be found."""


@dataclass
class Counts:
    """What came of many cases, by class."""

    cases: Counter[str] = field(default_factory=Counter)
    codes: Counter[str] = field(default_factory=Counter)
    performed: Counter[str] = field(default_factory=Counter)
    failed: Counter[str] = field(default_factory=Counter)
    failures: list[tuple[int, str]] = field(default_factory=list)
    slowest: Verdict = field(default_factory=lambda: Verdict("-", -1))
    largest: Verdict = field(default_factory=lambda: Verdict("-", -1))

    def add(self, verdict: Verdict) -> None:
        """One more."""
        self.cases[verdict.kind] += 1
        self.performed[verdict.kind] += verdict.code == 0
        self.failed[verdict.kind] += bool(verdict.faults)
        self.failures += [(verdict.seed, verdict.kind)] if verdict.faults else []
        self.codes.update({*verdict.came})
        self.slowest = max(self.slowest, verdict, key=lambda one: one.seconds)
        self.largest = max(self.largest, verdict, key=lambda one: one.mebibytes)

    def as_dict(self) -> dict[str, Any]:
        """For a file."""
        return {
            "cases": dict(self.cases),
            "performed": dict(self.performed),
            "failed": dict(self.failed),
            "failures": self.failures,
            "codes": sorted(code for code in self.codes if "." in code),
            "slowest": {"kind": self.slowest.kind, "seconds": round(self.slowest.seconds, 1)},
            "largest": {"kind": self.largest.kind, "mebibytes": round(self.largest.mebibytes)},
        }


def main() -> int:
    """Try the cases, show how far it is, print the counts."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=100_000, help="number of cases")
    parser.add_argument("--seed", type=int, default=0, help="seed of the first; each next has one more")
    parser.add_argument("--class", dest="kind", choices=[*KINDS], help="one class alone")
    parser.add_argument("--jobs", type=int, default=2, help="number of processes")
    parser.add_argument("--minutes", type=float, default=float("inf"), help="when to end at the latest")
    parser.add_argument("--save", type=Path, metavar="FILE", help="write the counts as JSON")
    parser.add_argument("--show", type=int, metavar="SEED", help="print the case of a seed")
    parser.add_argument("--folder", type=Path, metavar="PLACE", help="with --show: write its files there")
    parser.add_argument("--smaller", type=int, metavar="SEED", help="print the fewest lines of a failing model")
    parser.add_argument("--plants", action="store_true", help="find planted faults instead")
    asked = parser.parse_args()
    imported()
    if asked.plants:
        found = planted()
        if asked.save:
            asked.save.write_text(json.dumps(found, indent=2) + "\n", encoding="utf-8")
        return 0 if all(found.values()) else 1
    if asked.show is not None:
        show(case_of(asked.show, asked.kind), asked.folder)
        return 0
    if asked.smaller is not None:
        print("".join(smaller(case_of(asked.smaller, asked.kind))))
        return 0
    tasks = ((seed, asked.kind) for seed in range(asked.seed, asked.seed + asked.count))
    counts = tried(judged(tasks, asked.jobs), asked.count, 60 * asked.minutes)
    if asked.save:
        asked.save.write_text(json.dumps(counts.as_dict(), indent=2) + "\n", encoding="utf-8")
    for code, count in counts.codes.most_common():
        print(f"{code:32s}{count:8d}")
    for kind in KINDS:
        print(f"{kind:16s}{counts.cases[kind]:8d}{counts.failed[kind]:8d} failed")
    slow, wide = counts.slowest, counts.largest
    print(f"slowest {slow.seconds:.1f} s ({slow.kind} {slow.seed}), ", end="")
    print(f"largest {wide.mebibytes:.0f} MiB ({wide.kind} {wide.seed})")
    print(f"cases {counts.cases.total()}, failures {counts.failed.total()}")
    return 1 if counts.failed.total() else 0


def tried(verdicts: Iterable[Verdict], count: int, seconds: float) -> Counts:
    """The counts of verdicts; failures are printed as they come. An interrupt ends it early, and so does time."""
    counts, start, last = Counts(), time.monotonic(), 0.0
    with contextlib.suppress(KeyboardInterrupt):
        for verdict in verdicts:
            counts.add(verdict)
            if verdict.faults:
                print(f"{verdict.kind} {verdict.seed}: {'; '.join(verdict.faults)}", flush=True)
            now = time.monotonic() - start
            if now - last > 2:
                last = now
                done, failed = counts.cases.total(), counts.failed.total()
                print(f"\r{done}/{count}, failures {failed}, {now:.0f} s", end="", file=sys.stderr)
            if now > seconds:
                break
    print(file=sys.stderr)
    return counts


def planted() -> dict[str, int]:
    """After how many cases of its class each planted fault is found; 0 for one that isn't."""
    found = {}
    patience(4.0, 6.0)
    for name, plant in PLANTS.items():
        verdicts = judged(((seed, plant.kind) for seed in range(WITHIN)), 1, plant.plant)
        numbers = (i for i, v in enumerate(verdicts, start=1) if any(plant.reported in fault for fault in v.faults))
        found[name] = next(numbers, 0)
        verdicts.close()
        print(f"{name:24s}{plant.kind:16s}{found[name] or 'not found'}", flush=True)
    return found


def show(case: Case, folder: Path | None) -> None:
    """Print a case: its words and its model; or write all its files."""
    print(f"# {case.kind}: linkwright {shlex.join(case.words)}")
    if folder is None:
        print(case.files[MODEL].decode("utf-8", "replace"))
        return
    folder.mkdir(parents=True, exist_ok=True)
    for name, content in case.files.items():
        (folder / name).write_bytes(content)


def smaller(case: Case) -> list[str]:
    """The fewest lines of a case's model, by leaving out ever shorter stretches, that fail as all of them do."""

    def failure(lines: list[str]) -> str:
        made = replace(case, files={**case.files, MODEL: "".join(lines).encode("utf-8", "surrogatepass")})
        return (judge(made).faults or [""])[0].partition(":")[0]

    lines = lines_of(case)
    wanted, width = failure(lines), len(lines) // 2
    while wanted and width:
        at = 0
        while at < len(lines):
            fewer = lines[:at] + lines[at + width :]
            if failure(fewer) == wanted:
                lines = fewer
            else:
                at += width
        width //= 2
    return lines


if __name__ == "__main__":
    sys.exit(main())
