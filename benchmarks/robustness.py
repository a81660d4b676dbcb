"""The page docs/validation/robustness.md: ``python benchmarks/robustness.py [--counts FILE ...] [--plants FILE]``.

The tables between its marks are generated from the measured results in docs/validation/robustness.json:

    python benchmarks/fuzz.py --count 100000 --save counts.json
    python benchmarks/fuzz.py --plants --save plants.json
    python benchmarks/robustness.py --counts counts.json --plants plants.json

Several files of counts, with other seeds or classes, are added up. Without options the tables are regenerated from
the stored results.
"""

from __future__ import annotations

import argparse
import json
import re
from collections import Counter
from pathlib import Path
from typing import Any

from fuzz_cases import KINDS
from fuzz_plants import PLANTS

PAGE = Path(__file__).resolve().parent.parent / "docs" / "validation" / "robustness.md"
MEASURED = PAGE.with_suffix(".json")
MARK = "<!-- {0} -->\n{1}<!-- end of {0} -->\n"


def cases_table(counts: dict[str, Any]) -> str:
    """The classes of cases: their number, how many ended with exit code 0, failures."""
    columns = [counts[name] for name in ("cases", "performed", "failed")]
    lines = ["| class | inputs | cases | exit code 0 | failures |", "|---|---|---|---|---|"]
    for name, kind in KINDS.items():
        numbers = " | ".join(str(column.get(name, 0)) for column in columns)
        lines.append(f"| {name} | {kind.about} | {numbers} |")
    lines.append(f"| all | | {' | '.join(f'**{sum(column.values())}**' for column in columns)} |")
    return "\n".join(lines) + "\n"


def limits_text(counts: dict[str, Any]) -> str:
    """The number of different problems, the slowest and the largest case."""
    slow, wide = counts["slowest"], counts["largest"]
    return (
        f"The cases led to {len(counts['codes'])} different problem reports. The slowest case took\n"
        f"{slow['seconds']:g} s of processor time ({slow['kind']}); the largest needed {wide['mebibytes']} MiB of\n"
        f"additional memory ({wide['kind']}).\n"
    )


def plants_table(found: dict[str, int]) -> str:
    """The planted faults, and the number of the case that detected each."""
    lines = ["| planted fault | class | detected in case |", "|---|---|---|"]
    lines += [
        f"| {plant.about} | {plant.kind} | {found.get(name) or 'not detected'} |" for name, plant in PLANTS.items()
    ]
    return "\n".join(lines) + "\n"


def read(file: Path) -> Any:
    """The content of a JSON file."""
    return json.loads(file.read_text(encoding="utf-8"))


def added(runs: list[dict[str, Any]]) -> dict[str, Any]:
    """The counts of several runs as those of one."""
    sums = {
        name: dict(sum((Counter(run[name]) for run in runs), Counter())) for name in ("cases", "performed", "failed")
    }
    worst = {
        name: max((run[name] for run in runs), key=lambda one, key=key: one[key])
        for name, key in (("slowest", "seconds"), ("largest", "mebibytes"))
    }
    failures = [failure for run in runs for failure in run["failures"]]
    return {**sums, **worst, "failures": failures, "codes": sorted({code for run in runs for code in run["codes"]})}


def page(text: str, measured: dict[str, Any]) -> str:
    """The page's text with its tables generated from the measured results."""
    made = {
        "cases": cases_table(measured["counts"]),
        "limits": limits_text(measured["counts"]),
        "plants": plants_table(measured["plants"]),
    }
    for name, table in made.items():
        pattern = re.escape(MARK.format(name, "\0")).replace("\0", ".*?")
        text, count = re.subn(pattern, MARK.format(name, table).replace("\\", "\\\\"), text, flags=re.DOTALL)
        assert count == 1, f"the page has no place for {name}"
    return text


def main() -> None:
    """Store the measured results and write the page."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--counts", type=Path, nargs="+", metavar="FILE", help="what fuzz.py --save wrote")
    parser.add_argument("--plants", type=Path, metavar="FILE", help="what fuzz.py --plants --save wrote")
    asked = parser.parse_args()
    measured = read(MEASURED) if MEASURED.exists() else {}
    if asked.plants:
        measured["plants"] = read(asked.plants)
    if asked.counts:
        measured["counts"] = added([read(file) for file in asked.counts])
    MEASURED.write_text(json.dumps(measured, indent=2) + "\n", encoding="utf-8")
    PAGE.write_text(page(PAGE.read_text(encoding="utf-8"), measured), encoding="utf-8")


if __name__ == "__main__":
    main()
