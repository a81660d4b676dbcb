"""Every kind of element by every study, form of drive, export and more: ``python benchmarks/matrix.py [--jobs 2]``.

Performs the cells of the matrix (tests/combinations), prints each that is wrong with its faults, then the counts; exit
code 1 where one is wrong. ``--save`` keeps the outcomes and, once there are all, writes the page
docs/validation/matrix.md. ``--rows`` and ``--columns`` choose some by name; with ``--save`` the others stay as they
are. ``--show`` prints the findings too.
"""

from __future__ import annotations

import argparse
import multiprocessing
import os
import sys
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
sys.path.append(str(Path(__file__).resolve().parent.parent / "tests"))

from combinations.columns import COLUMNS
from combinations.mechanisms import MECHANISMS
from combinations.performing import REFUSED, RIGHT, WRONG, Cell
from combinations.table import PAGE, cell, keep, kept, page


def tried(place: tuple[str, str]) -> tuple[str, str, Cell]:
    """A cell, with its place."""
    return (*place, cell(*place))


def main() -> int:
    """Try the cells, print what is wrong, keep the outcomes."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rows", nargs="+", choices=[*MECHANISMS], default=[*MECHANISMS], metavar="NAME")
    parser.add_argument("--columns", nargs="+", choices=[*COLUMNS], default=[*COLUMNS], metavar="NAME")
    parser.add_argument("--jobs", type=int, default=1, help="number of processes")
    parser.add_argument("--save", action="store_true", help="keep the outcomes and write the page")
    parser.add_argument("--missing", action="store_true", help="only cells whose outcomes aren't kept yet")
    parser.add_argument("--show", action="store_true", help="print the findings of refusals")
    asked = parser.parse_args()
    outcomes, verdicts = kept(), dict.fromkeys((RIGHT, REFUSED, WRONG), 0)
    places = [(row, name) for row in asked.rows for name in asked.columns]
    if asked.missing:
        places = [(row, name) for row, name in places if name not in outcomes.get(row, {})]
    with multiprocessing.get_context("spawn").Pool(asked.jobs) as pool:
        for row, name, found in pool.imap(tried, places, chunksize=4):
            verdicts[found.verdict] += 1
            if found.verdict != WRONG:
                outcomes.setdefault(row, {})[name] = [*found.codes]
            if found.verdict == WRONG:
                print(f"{row}, {name}:", *found.faults, sep="\n    ", flush=True)
            elif asked.save:
                keep(outcomes)
            if asked.show and found.findings:
                print(f"{row}, {name}:", *found.findings, sep="\n    ", flush=True)
    print(", ".join(f"{verdict} {count}" for verdict, count in verdicts.items()))
    if asked.save and all({*COLUMNS} <= kept().get(row, {}).keys() for row in MECHANISMS):
        PAGE.write_text(page(PAGE.read_text("utf-8"), kept()), encoding="utf-8")
    return 1 if verdicts[WRONG] else 0


if __name__ == "__main__":
    sys.exit(main())
