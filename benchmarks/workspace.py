"""The eight regions of a five-bar and their quality maps: ``python benchmarks/workspace.py [--json] [--repeats N]``.

Those of examples/five_bar_workspace.yaml, four angles in two modes, with a million poses in all their maps (of every
figure: conditioning, transmission, speeds, forces, torques). Seconds on all processors and on one thread of the same
process, taken in turns after a first run of both; medians.
"""

from __future__ import annotations

import statistics
import time
from pathlib import Path

from figures import parser, tell

import linkwright as lw
from linkwright._machine import processors
from linkwright.app import examine_alone
from linkwright.blocks import Threads
from linkwright.studies import RunContext
from linkwright.studies.workspace.options import SECTIONS
from linkwright.studies.workspace.parallel import run_in_threads
from linkwright.studies.workspace.quality import QualityTask, quality

EXAMPLE = Path(__file__).resolve().parent.parent / "examples" / "five_bar_workspace.yaml"
STEPS = 353
"""Eight maps of 354 x 354 poses are a million."""
TASK = QualityTask(speeds=(3.0, 3.0), efforts=(1.0, 1.0), force=(1.0, 2.0))


def once(workers: int) -> tuple[float, float]:
    """Seconds of the regions and of the maps."""
    examined = examine_alone(EXAMPLE, "workspace")
    assert examined.compiled is not None and not examined.findings
    (task,) = examined.tasks
    alone = task.options.model_copy(update=dict.fromkeys(SECTIONS))  # the regions without what the file asks of them
    begun = time.perf_counter()
    outcome = task.study.run(examined.compiled, alone, RunContext(runner=Threads(workers)))
    found = time.perf_counter()
    sheets = [one.region for one in outcome.regions]
    maps, _ = run_in_threads(lambda one: quality(one.sheet, one.box, TASK, STEPS, one.segments), sheets, workers)
    done = time.perf_counter()
    assert len(maps) == 8 and sum(one.maps.at[0].size for one in maps.values()) > 1e6
    return found - begun, done - found


def main() -> None:
    """Measure and tell."""
    options = parser(__doc__)
    options.add_argument("--repeats", type=int, default=5)
    given = options.parse_args()
    every = processors()
    times: dict[int, list[tuple[float, float]]] = {every: [], 1: []}
    for turn in range(given.repeats + 1):
        for workers, seconds in times.items():
            measured = once(workers)
            if turn:
                seconds.append(measured)
    figures: dict[str, float | str] = {"version": lw.__version__, "threads": float(every)}
    middle = statistics.median
    for name, part in (("regions", lambda s: s[0]), ("maps", lambda s: s[1]), ("all", sum)):
        figures[f"{name}, s"] = middle(map(part, times[every]))
        figures[f"{name}, one thread, s"] = middle(map(part, times[1]))
        ratios = [part(one) / part(all_) for one, all_ in zip(times[1], times[every], strict=True)]
        figures[f"{name}, one thread over all"] = middle(ratios)
    tell(figures, given.json)


if __name__ == "__main__":
    main()
