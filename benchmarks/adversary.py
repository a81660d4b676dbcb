"""Measures with known truth, made to be hard: ``python benchmarks/adversary.py [--count 10000] [--seed 0] [--jobs 2]``.

Poles, near-poles, jumps, edges, kinks, narrow peaks at joins, knots, ends and near change points, with features of
1e-1 to 1e-7 of the run (tests/helpers/adversary). Each measure is found, or rightly said to be unbounded, or refused
with a finding, or missed below the width that its grade states, or wrong in silence: a value off the truth although
the feature is wider than that; a number for what is unbounded; a finite value called unbounded.

Prints counts by family, by decade of the width and by grade, and what is wrong in silence; exit code 1 where anything
is. ``--show SEED`` prints the document of a seed. An interrupt prints the counts so far.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import math
import sys
import time
import warnings
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace
from pathlib import Path

from patience import OutOfTime, limited, spread

sys.path.append(str(Path(__file__).resolve().parent.parent / "tests"))

import linkwright as lw
from helpers.adversary import Verdict, answers, faults, judged, make
from helpers.adversary.judging import OUTCOMES, REFUSED, WRONG

PATIENCE = 120
"""Seconds of processor time for one document of some ten to forty measures."""
PER_DOCUMENT = 30
"""Measures of a document, on average."""


@dataclass
class Outcome:
    """What came of a document: a verdict for each measure, or what was raised."""

    seed: int
    verdicts: list[Verdict] = field(default_factory=list)
    raised: str = ""
    seconds: float = 0.0

    @property
    def faults(self) -> list[str]:
        """What is wrong, a line each."""
        return [f"seed {self.seed}: {text}" for text in ([self.raised] if self.raised else faults(self.verdicts))]


def tried(seed: int) -> Outcome:
    """Run the document of a seed and judge its measures; whatever is raised is a fault."""
    batch = make(seed)
    outcome, start = Outcome(seed), time.perf_counter()
    with warnings.catch_warnings(), limited(PATIENCE):
        warnings.simplefilter("error")
        try:
            job = lw.run(lw.Document.model_validate(batch.document))
            verdicts = judged(batch, answers(job))
            # Expressions stay here: they hold functions, which don't go from one process to another.
            outcome.verdicts = [replace(v, case=replace(v.case, f=None)) for v in verdicts]
        except (Exception, OutOfTime) as error:
            outcome.raised = f"{type(error).__name__}: {error}"[:500]
    outcome.seconds = time.perf_counter() - start
    return outcome


def table(verdicts: list[Verdict]) -> str:
    """Counts of what came of the measures."""
    head = f"{'':26s}{'cases':>8s}" + "".join(f"{outcome:>18s}" for outcome in OUTCOMES)
    lines = [head + f"{'stated width':>14s}"]
    lines += _rows("all", verdicts, lambda v: "all")
    lines += ["", "by family", *_rows("", verdicts, lambda v: v.case.family)]
    lines += ["", "by width, as a share of the run", *_rows("", verdicts, lambda v: decade(v.case.share))]
    given = [v for v in verdicts if v.grade]
    lines += ["", "by grade", *_rows("", given, lambda v: v.grade)]
    refused = [v for v in verdicts if v.outcome == REFUSED]
    lines += ["", "refused by", *_rows("", refused, lambda v: v.why)]
    return "\n".join(lines)


def decade(share: float) -> str:
    """The decade of a width, narrow ones last."""
    return f"1e{math.floor(math.log10(share) + 1e-9):+03d}" if share < 0.1 else "above 1e-01"


def _rows(title: str, verdicts: Iterable[Verdict], key: Callable[[Verdict], str]) -> list[str]:
    parts: dict[str, list[Verdict]] = {}
    for verdict in verdicts:
        parts.setdefault(key(verdict), []).append(verdict)
    lines = []
    for name, part in sorted(parts.items()):
        counts = "".join(f"{sum(v.outcome == outcome for v in part):18d}" for outcome in OUTCOMES)
        width = max((v.width for v in part if math.isfinite(v.width)), default=0.0)
        lines.append(f"{title or name[:25]:26s}{len(part):8d}{counts}{width:14.2g}")
    return lines


def main() -> int:
    """Try the documents, show how far it is, print the counts."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=10_000, help="number of measures, about")
    parser.add_argument("--seed", type=int, default=0, help="seed of the first document; each next has one more")
    parser.add_argument("--jobs", type=int, default=2, help="number of processes")
    parser.add_argument("--show", type=int, metavar="SEED", help="print the document of a seed")
    options = parser.parse_args()
    if options.show is not None:
        print(json.dumps(make(options.show).document, indent=1))
        return 0
    documents = range(options.seed, options.seed + math.ceil(options.count / PER_DOCUMENT))
    found: list[Outcome] = []
    start = last = time.perf_counter()
    with contextlib.suppress(KeyboardInterrupt):
        for outcome in spread(tried, documents, options.jobs, 2):
            found.append(outcome)
            for fault in outcome.faults:
                print(fault, flush=True)
            if (now := time.perf_counter()) - last > 2:
                last, bad = now, sum(len(one.faults) for one in found)
                done = f"{len(found)}/{len(documents)} documents, {sum(len(one.verdicts) for one in found)} measures"
                print(f"\r{done}, {bad} wrong, {now - start:.0f} s", end="", file=sys.stderr)
    print(file=sys.stderr)
    verdicts = [verdict for one in found for verdict in one.verdicts]
    print(table(verdicts))
    slow = max(found, key=lambda one: one.seconds, default=Outcome(-1))
    wrong, raised = sum(v.outcome == WRONG for v in verdicts), sum(bool(one.raised) for one in found)
    print(f"\nmeasures {len(verdicts)}, wrong in silence {wrong}, documents that raised {raised}, ", end="")
    print(f"slowest {slow.seconds:.1f} s (seed {slow.seed})")
    return 1 if wrong or raised else 0


if __name__ == "__main__":
    sys.exit(main())
