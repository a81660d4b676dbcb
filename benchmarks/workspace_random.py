"""Workspaces of random mechanisms against their inverse kinematics: ``python benchmarks/workspace_random.py``.

Five-bars with nearly equal links, near change points, with limited ranges and of any lengths, two cylinders, two
slides, a crank with a slide, a four-bar with an arm (tests/helpers/reach). The places that P reaches in each assembly
mode are known by inverse kinematics in closed form, on a raster refined along their boundary.

Each case's worst mode counts. Right: certified, and area, parts and holes agree within the stated bounds and the
raster's own error; not certified, and off or not; wrong in silence: certified, and off; refused with findings; raised.
What is narrower than some cells of the raster is too small to tell and isn't held against a count.

``[--count 500] [--seed 0] [--jobs 2] [--only SEED ...] [--show SEED] [--json] [--lines FILE]``: ``--lines`` adds a line
of JSON for each case to a file as it comes. Exit code 1 where anything is wrong in silence or raised. An interrupt
prints the counts so far.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import statistics
import sys
import time
import warnings
from pathlib import Path
from typing import Any

from patience import OutOfTime, limited, spread

sys.path.append(str(Path(__file__).resolve().parent.parent / "tests"))

import linkwright as lw
from helpers.reach import FAMILIES, Outcome, make
from helpers.reach import tried as judged_case
from helpers.reach.judging import OFF, OPEN, OUTCOMES, RAISED, RIGHT, WRONG, Verdict
from helpers.reach.product import as_dict

PATIENCE = 600
"""Seconds of processor time for one case."""


def tried(seed: int) -> Outcome:
    """A case with an end to its time; NumPy's warnings are raised."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            with limited(PATIENCE):
                return judged_case(seed)
        except (Exception, OutOfTime) as error:
            text = f"{type(error).__name__}: {error}"[:300]
            return Outcome(seed, make(seed).family, [Verdict("", RAISED, text)], float(PATIENCE))


def line(one: Outcome) -> str:
    """A case in a line."""
    whys = "; ".join(f"{verdict.mode}: {verdict.why}" for verdict in one.verdicts if verdict.why)
    return f"seed {one.seed} ({one.family}): {one.outcome}; {whys}"


def table(found: list[Outcome]) -> str:
    """Counts of what came of the cases, and seconds of the study."""
    lines = [
        f"{'':26s}{'cases':>6s}" + "".join(f"{name:>20s}" for name in OUTCOMES) + f"{'median, s':>11s}{'most, s':>9s}"
    ]
    for name in ("all", *FAMILIES):
        if part := [one for one in found if name in ("all", one.family)]:
            counts = "".join(f"{sum(one.outcome == outcome for one in part):20d}" for outcome in OUTCOMES)
            seconds = [one.seconds for one in part]
            lines.append(f"{name:26s}{len(part):6d}{counts}{statistics.median(seconds):11.2f}{max(seconds):9.1f}")
    return "\n".join(lines)


def figures(found: list[Outcome]) -> dict[str, Any]:
    """The counts as data."""
    counts = {name: sum(one.outcome == name for one in found) for name in OUTCOMES}
    return {"version": lw.__version__, "cases": len(found), **counts, "seeds": [as_dict(one) for one in found]}


def main() -> int:
    """Try the cases, show how far it is, print the counts."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=500, help="number of cases")
    parser.add_argument("--seed", type=int, default=0, help="seed of the first case; each next has one more")
    parser.add_argument("--only", type=int, nargs="+", metavar="SEED", help="these cases")
    parser.add_argument("--jobs", type=int, default=2, help="number of processes")
    parser.add_argument("--json", action="store_true", help="print data")
    parser.add_argument("--lines", type=Path, metavar="FILE", help="add a line of JSON for each case to a file")
    parser.add_argument("--show", type=int, metavar="SEED", help="print the model file of a case")
    options = parser.parse_args()
    if options.show is not None:
        print(json.dumps(make(options.show).document, indent=1))
        return 0
    seeds = options.only or range(options.seed, options.seed + options.count)
    found: list[Outcome] = []
    start = time.perf_counter()
    with contextlib.suppress(KeyboardInterrupt):
        for outcome in spread(tried, seeds, options.jobs, 1):
            found.append(outcome)
            if options.lines:
                with options.lines.open("a", encoding="utf-8") as file:
                    file.write(json.dumps(as_dict(outcome)) + "\n")
            if not options.json and outcome.outcome not in (RIGHT, OPEN):
                print(line(outcome), flush=True)
            print(f"\r{len(found)}/{len(seeds)} cases, {time.perf_counter() - start:.0f} s", end="", file=sys.stderr)
    print(file=sys.stderr)
    found.sort(key=lambda one: one.seed)
    print(json.dumps(figures(found), indent=1) if options.json else table(found))
    for name in (OFF, WRONG, RAISED):
        if (bad := [one.seed for one in found if one.outcome == name]) and not options.json:
            print(f"{name}: {' '.join(map(str, bad))}")
    return 1 if any(one.outcome in (WRONG, RAISED) for one in found) else 0


if __name__ == "__main__":
    sys.exit(main())
