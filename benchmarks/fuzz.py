"""Wrong model files by the thousand: ``python benchmarks/fuzz.py [--count 100000] [--seed 0] [--jobs 2]``.

The models of the gallery and of examples/ with changes of text and structure (mutations.py), examined like any file;
those in which nothing is found are run with few samples. Nothing may be raised but findings, nothing may take over
5 s of processor time, and each finding has a code of the catalogue, a line or an element, and words without gaps.

Prints counts by code, and each failure with its seed; exit code 1 where there are any. ``--show SEED`` prints the
file of a seed. An interrupt prints the counts so far.
"""

from __future__ import annotations

import argparse
import contextlib
import random
import re
import sys
import time
import traceback
import warnings
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

from mutations import mutated
from patience import limited, spread

from linkwright import gallery
from linkwright.app.job import Examined, examine_document, perform, summary_text
from linkwright.model.document import read_document
from linkwright.model.findings import Finding
from linkwright.model.mechanism import Document
from linkwright.words import catalogue

PATIENCE = 10
"""Seconds of processor time for one file."""
SAMPLES = 6
LONG = ("workspace", "cam")
"""Studies that take seconds: their options are examined, and that is all."""
EXAMPLES = Path(__file__).resolve().parent.parent / "examples"
RUN, UNPROVEN = "run", "run, its certificate not sound"
QUOTED, WORD = re.compile(r"'.*'"), re.compile(r"\w+")


@dataclass
class Case:
    """What came of one file: run or the codes found, and what is wrong with that."""

    seed: int
    came: tuple[str, ...] = ()
    faults: list[str] = field(default_factory=list)
    seconds: float = 0.0


@cache
def models() -> tuple[str, ...]:
    """The files that are made wrong."""
    examples = [path.read_text(encoding="utf-8") for path in sorted(EXAMPLES.glob("*.yaml"))]
    return (*map(gallery.text, gallery.names()), *examples)


def file_of(seed: int) -> str:
    """The file of a seed."""
    random_ = random.Random(seed)
    return mutated(random_, random_.choice(models()))


def tried(seed: int) -> Case:
    """Make one file, examine it, run it where nothing is found."""
    case, start = Case(seed), time.process_time()
    raw = file_of(seed).encode("utf-8", "surrogatepass")
    with warnings.catch_warnings(), limited(PATIENCE):
        warnings.simplefilter("error")
        try:
            examine(raw, case)
        except Exception as error:
            place = traceback.extract_tb(error.__traceback__)[-1]
            case.faults.append(f"{type(error).__name__} in {place.filename}:{place.lineno} {place.name}: {error}"[:300])
    case.seconds = time.process_time() - start
    return case


def examine(raw: bytes, case: Case) -> None:
    """Examine a file as the command line does, and run it."""
    document, source = read_document(raw)
    if document is None:
        case.came = tuple(finding.code for finding in source.findings)
        case.faults += [fault for finding in source.findings for fault in gaps(finding)]
        if not source.findings:
            case.faults.append("neither a document nor findings")
        return
    examined = examine_document(short(document), EXAMPLES)
    examined.source = source
    examined.findings = examined.located(examined.findings)
    case.came = tuple(finding.code for finding in examined.findings)
    case.faults += [fault for finding in examined.findings for fault in gaps(finding)]
    if not examined.findings and examined.tasks:
        run(examined, case)


def short(document: Document) -> Document:
    """A document with few samples, where its study says how many or nothing."""
    studies = dict(document.studies)
    for name in ("cycle", "accuracy"):
        if isinstance(entry := studies.get(name), dict):
            studies[name] = {**entry, "samples": SAMPLES}
    return document.model_copy(update={"studies": studies})


def run(examined: Examined, case: Case) -> None:
    """Perform the studies; what they find must have words too, and the summary no gaps."""
    examined.tasks = [task for task in examined.tasks if task.study.name not in LONG]
    job = perform(examined)
    found = [*examined.findings, *examined.located(job.found)]
    certificate = job.cycle.result.certificate if job.cycle else None
    proven = certificate is None or certificate.sound()
    case.came = tuple(finding.code for finding in found) or (RUN if proven else UNPROVEN,)
    case.faults += [fault for finding in found for fault in gaps(finding)]
    summary_text(job.summary)


def gaps(finding: Finding) -> Iterator[str]:
    """What a finding lacks."""
    if f"{finding.code}.what" not in catalogue() or f"{finding.code}.mend" not in catalogue():
        yield f"{finding.code} isn't in the catalogue"
        return
    cited = str(finding.data.get("given"))  # what the file holds may be anything, names too
    for text in (finding.what, finding.mend, str(finding)):
        said = WORD.findall(QUOTED.sub("", text.replace(cited, "").replace(finding.element, "")))
        if not text.strip() or "None" in said or "nan" in said:
            yield f"{finding.code} says: {text[:200]}"
    if finding.line is None and not finding.element and not finding.code.startswith("file."):
        yield f"{finding.code} has neither line nor element"


def main() -> int:
    """Try the files, show how far it is, print the counts."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=100_000, help="number of files")
    parser.add_argument("--seed", type=int, default=0, help="seed of the first; each next has one more")
    parser.add_argument("--jobs", type=int, default=2, help="number of processes")
    parser.add_argument("--show", type=int, metavar="SEED", help="print the file of a seed")
    options = parser.parse_args()
    if options.show is not None:
        print(file_of(options.show))
        return 0
    codes: Counter[str] = Counter()
    done = bad = 0
    slowest = Case(-1)
    start = last = time.perf_counter()
    with contextlib.suppress(KeyboardInterrupt):
        for case in spread(tried, range(options.seed, options.seed + options.count), options.jobs, 50):
            done += 1
            codes.update(set(case.came))
            slowest = max(slowest, case, key=lambda c: c.seconds)
            if case.faults:
                bad += 1
                print(f"seed {case.seed}: {'; '.join(case.faults)}", flush=True)
            if (now := time.perf_counter()) - last > 2:
                last = now
                print(f"\r{done}/{options.count}, failures {bad}, {now - start:.0f} s", end="", file=sys.stderr)
    print(file=sys.stderr)
    for code, count in codes.most_common():
        print(f"{code:32s}{count:8d}")
    print(f"files {done}, run {codes[RUN]}, slowest {slowest.seconds:.1f} s (seed {slowest.seed}), failures {bad}")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
