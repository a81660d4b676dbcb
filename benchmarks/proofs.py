"""What it costs to prove the extremes of every example's measures, against searching for them.

python benchmarks/proofs.py              the table of all examples
python benchmarks/proofs.py four_bar     those with this in their names
python benchmarks/proofs.py --orders     all of them at other degrees and numbers of first panels
"""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from linkwright.app.job import examine_file
from linkwright.enclosures import Claim, Proof, panels, proofs, prove_all
from linkwright.measures import Measurer, bound_measures
from linkwright.results import Run
from linkwright.studies.change_point_carry import carry_through_change_points
from linkwright.studies.cycle.options import CycleOptions, span

EXAMPLES = Path(__file__).parents[1] / "examples"
BOUNDED = ("span", "max", "min", "extremes")


@dataclass
class Case:
    """An example's run with the extremes that its search found."""

    name: str
    run: Run
    claims: dict[str, Claim]
    searched: float  # s


def cases(part: str = "") -> Iterator[Case]:
    """The examples with extremes among their measures."""
    for path in sorted(EXAMPLES.glob("*.yaml")):
        if part in path.stem and (found := case_of(path)):
            yield found


def case_of(path: Path) -> Case | None:
    """An example, if it has extremes among its measures."""
    examined = examine_file(path)
    options = next((task.options for task in examined.tasks if task.study.name == "cycle"), None)
    if examined.compiled is None or not isinstance(options, CycleOptions):
        return None
    stop, _ = span(examined.compiled, options)
    run = Run(examined.compiled, 0.0, stop, options.samples)
    if options.through == "keep":
        run, _ = carry_through_change_points(run)
    start = time.process_time()
    claims = searched(run)
    return Case(path.stem, run, claims, time.process_time() - start) if claims else None


def searched(run: Run) -> dict[str, Claim]:
    """The extremes of a run's measures, as the search finds them."""
    every = bound_measures(run.compiled.quantities)
    measurer = Measurer(run, [measure for measure in every if measure.entry.reduction in BOUNDED])
    found = {}
    for name, measure in measurer.by_name.items():
        probe = measurer.probe(measure)
        if not probe.limits:
            ends = tuple((float(a), float(b)) for a, b in probe.intervals)
            found[name] = Claim(probe.node, ends, probe.bottom().value, probe.top().value)
    return found


def proven(case: Case, times: int = 4) -> tuple[dict[str, Proof], float, float]:
    """The proofs, and how long they took (s of processor time): the first time, and the best of the others."""
    took = []
    for _ in range(times):
        start = time.process_time()
        made = prove_all(case.run, list(case.claims.values()), case.run.breaks)
        took.append(time.process_time() - start)
    return dict(zip(case.claims, made, strict=True)), took[0], min(took[1:], default=took[0])


def table(part: str) -> None:
    """A row for each example."""
    print("example                     claims proven panels  search ms  prove ms  again ms  left open")
    for case in cases(part):
        made, first, again = proven(case)
        done, most = sum(proof.is_proven for proof in made.values()), max(proof.panels for proof in made.values())
        left = ", ".join(f"{name}: {proof.reason}" for name, proof in made.items() if not proof.is_proven)
        print(
            f"{case.name:28s}{len(made):6d}{done:7d}{most:7d}{1e3 * case.searched:11.0f}{1e3 * first:10.0f}"
            f"{1e3 * again:10.0f}  {left}"
        )


def orders() -> None:
    """The sum of all examples that are proven, at other degrees and numbers of first panels."""
    every = [case for case in cases() if all(proof.is_proven for proof in proven(case)[0].values())]
    print("degree first  again ms  panels  proven")
    kept = panels.Panels.__init__.__defaults__
    assert kept is not None
    for order in (4, 5, 6, 7, 8, 10):
        for first in (12, 24, 48):
            panels.Panels.__init__.__defaults__ = (kept[0], order, *kept[2:])  # type: ignore[attr-defined]
            proofs.FIRST = first
            took, done, most = 0.0, 0, 0
            for case in every:
                made, _, again = proven(case)
                took += again
                done += sum(proof.is_proven for proof in made.values())
                most += max(proof.panels for proof in made.values())
            print(f"{order:6d}{first:6d}{1e3 * took:10.0f}{most:8d}{done:8d}", flush=True)
    panels.Panels.__init__.__defaults__ = kept  # type: ignore[attr-defined]


if __name__ == "__main__":
    np.seterr(all="ignore")
    if "--orders" in sys.argv:
        orders()
    else:
        table(sys.argv[1] if len(sys.argv) > 1 else "")
