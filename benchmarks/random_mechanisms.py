"""Random mechanisms run over a cycle, each pose judged: ``python benchmarks/random_mechanisms.py [--count 10000]``.

Dyads, triads, double triads and four-link loops with pins and slides on one to three drives, a third of them with a
drive inside a loop (sketches.py). Each is examined and run like a model file. It is refused with a finding's code, or
its poses are judged from the sketch (judge.py): every joint closed to 1e-10 of the size, every drive on its law; the
start as sketched; the same branch throughout, by the sign of the determinant of all constraints, by the orientation
of each pinned dyad's triangle, by poses that go on as their exact rates say, and by coming back where one drive moves
to and fro; forces in balance by the certificate to 1e-9, or to 1e-15 over the square of the least reciprocal
condition number of the constraints on the way where that is more: near a singular pose forces grow with it, and so
do their digits' losses.

A refusal is no failure. It counts as doubtful where the sketch is no singular pose and yet isn't assembled, or where
a path stops away from singular poses.

Prints counts and the seeds of failures; exit code 1 where there are any. An interrupt prints the counts so far.
"""

from __future__ import annotations

import argparse
import contextlib
import sys
import time
import traceback
import warnings
from collections import Counter
from dataclasses import dataclass, field

import numpy as np
from judge import Judge
from patience import OutOfTime, limited, spread
from sketches import PERIOD, Sketch, sketch

from linkwright.app.job import examine_document, perform
from linkwright.model.document import Document

PATIENCE = 120
"""Seconds of processor time for one mechanism."""
FORCES = 1e-9
REGULAR = 1e-3
"""A refusal at a pose in which the constraints' reciprocal condition number is above this is doubtful."""
ASSEMBLED = "assembled"


@dataclass
class Verdict:
    """What came of one mechanism: assembled, a finding's code, or what is wrong with it."""

    seed: int
    kinds: tuple[str, ...]
    came: str = ASSEMBLED
    faults: list[str] = field(default_factory=list)
    doubtful: bool = False
    figures: dict[str, float] = field(default_factory=dict)
    seconds: float = 0.0


def kinds(s: Sketch) -> tuple[str, ...]:
    """The words of the table's rows under which a mechanism counts."""
    beyond = sorted({kind for kind in s.kinds if kind not in ("dyad", "moved drive")})
    slides = "with slides" if any(j.kind == "P" for j in s.joints.values()) else "pins only"
    moved = ["moved drive"] if "moved drive" in s.kinds else []
    return (*(beyond or ["dyads only"]), *moved, slides, f"{len(s.drives)} drive{'s' * (len(s.drives) > 1)}")


def judged(seed: int) -> Verdict:
    """Make, run and judge one mechanism; whatever goes wrong is a fault."""
    start, s = time.perf_counter(), sketch(seed)
    verdict = Verdict(seed, kinds(s))
    with warnings.catch_warnings(), limited(PATIENCE):
        warnings.simplefilter("error")
        try:
            run(s, verdict)
        except (Exception, OutOfTime) as error:
            verdict.came = type(error).__name__
            place = traceback.extract_tb(error.__traceback__)[-1]
            verdict.faults.append(f"{type(error).__name__} in {place.filename}:{place.lineno} {place.name}: {error}")
    verdict.seconds = time.perf_counter() - start
    return verdict


def run(s: Sketch, verdict: Verdict) -> None:
    examined = examine_document(Document.model_validate(s.data()))
    job = perform(examined)
    # What runs without a proof isn't refused: it is judged below, by how near it is to a singular pose.
    found = [f for f in (*examined.findings, *job.found) if f.code != "motion.unproven" and f.severity != "note"]
    compiled = examined.compiled
    judge = Judge(s, compiled)
    if found:
        verdict.came = found[0].code
        stops = [finding.data["start"] for finding in found if finding.code == "motion.stuck"]
        if stops or compiled is None:
            verdict.doubtful = judge.regularity(min(stops, default=None)) > REGULAR
        return
    assert compiled is not None
    assert job.cycle is not None
    verdict.faults += judge.faults(np.linspace(0.0, PERIOD, 49))
    certificate = job.cycle.result.certificate
    assert certificate is not None
    limit = max(FORCES, 1e-15 / judge.rcond**2)
    verdict.figures = {"joints": judge.worst_closure, **certificate.residuals, "1/condition": judge.rcond}
    verdict.faults += [f"{name} {value:.2g}" for name, value in certificate.residuals.items() if not value < limit]


def table(found: list[Verdict]) -> str:
    """Counts by kind and by what came, the worst figures, the failures."""
    rows = ["all", *sorted({kind for v in found for kind in v.kinds})]
    lines = [f"{'':16s}{'mechanisms':>11s}{'assembled':>11s}{'refused':>9s}{'failures':>9s}"]
    for row in rows:
        part = [v for v in found if row == "all" or row in v.kinds]
        good = sum(v.came == ASSEMBLED for v in part)
        bad = sum(bool(v.faults) for v in part)
        lines.append(f"{row:16s}{len(part):11d}{good:11d}{len(part) - good:9d}{bad:9d}")
    lines += ["", "refused by"]
    codes = Counter(v.came for v in found if v.came != ASSEMBLED)
    lines += [f"  {code:28s}{count:7d}" for code, count in codes.most_common()]
    lines += ["", "worst figures of those assembled"]
    for name in sorted({name for v in found for name in v.figures}):
        pick = min if name == "1/condition" else max
        v = pick((v for v in found if name in v.figures), key=lambda v: v.figures[name])
        lines.append(f"  {name:12s}{v.figures[name]:9.2g}  seed {v.seed}, 1/condition {v.figures['1/condition']:.2g}")
    slow = max(found, key=lambda v: v.seconds, default=None)
    if slow is not None:
        lines.append(f"  {'seconds':12s}{slow.seconds:9.2g}  seed {slow.seed}")
    doubtful = [v for v in found if v.doubtful]
    lines += ["", f"doubtful refusals: {len(doubtful)}"]
    lines += [f"  seed {v.seed} ({', '.join(v.kinds)}): {v.came}" for v in doubtful[:40]]
    lines += ["", f"failures: {sum(bool(v.faults) for v in found)}"]
    return "\n".join([*lines, *(fault(v) for v in found if v.faults)])


def fault(v: Verdict) -> str:
    """A failure in a line."""
    return f"  seed {v.seed} ({', '.join(v.kinds)}; {v.came}): {'; '.join(v.faults)}"


def main() -> int:
    """Run, show how far it is, print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=10_000, help="number of mechanisms")
    parser.add_argument("--seed", type=int, default=0, help="seed of the first; each next has one more")
    parser.add_argument("--jobs", type=int, default=2, help="number of processes")
    options = parser.parse_args()
    found: list[Verdict] = []
    start = last = time.perf_counter()
    with contextlib.suppress(KeyboardInterrupt):
        for verdict in spread(judged, range(options.seed, options.seed + options.count), options.jobs, 2):
            found.append(verdict)
            if verdict.faults:
                print(f"\r{fault(verdict)}", file=sys.stderr)
            if (now := time.perf_counter()) - last > 2:
                last = now
                bad = sum(bool(v.faults) for v in found)
                print(f"\r{len(found)}/{options.count}, failures {bad}, {now - start:.0f} s", end="", file=sys.stderr)
    print("\n", end="", file=sys.stderr)
    print(table(sorted(found, key=lambda v: v.seed)))
    return 1 if any(v.faults for v in found) else 0


if __name__ == "__main__":
    sys.exit(main())
