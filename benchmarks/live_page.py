"""The live report in Chromium: ``python benchmarks/live_page.py [--json] [--frames 120] [EXAMPLE ...]``.

Of each report: its size, as it is and as sent (gzip); per change of a number the time of computing all signals and
measures' rows (``compute``, by the page's clock), and the processor time of the scripts, of styles and layout, as
Chromium's profiler has them, for the whole change: compute, drawing, visible plots, measures. Percentiles over frames;
the machine's other work is in them. Also the time of a pose beside a plain loop of as many multiplications and
additions as the program has instructions, in the same page.
"""

from __future__ import annotations

import gzip
import json
import shutil
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from figures import parser
from run import ROOT

import linkwright as lw
from linkwright.measures import live_measures, live_rows
from linkwright.model.document import load
from linkwright.model.named_numbers import named_numbers
from linkwright.report.build import report_data
from linkwright.report.data import LiveData
from linkwright.report.page import page

EXAMPLES = ("paper_feeder", "jansen_leg", "loader")
FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-background-networking"]

CHANGE = """async k => {
  const live = linkwright.live, number = live.data.numbers.find(each => each.low < each.high && !each.locked);
  const i = live.data.numbers.indexOf(number);
  const start = performance.now();
  live.set(i, number.value * (1 + 0.0005 * (k % 20 + 1)) + (number.value ? 0 : 1e-4 * (k % 20 + 1)));
  const computed = performance.now() - start;
  await new Promise(r => requestAnimationFrame(() => requestAnimationFrame(r)));
  return computed;
}"""
LOOP = """() => {
  const {mechanism, values} = linkwright.live, poses = mechanism.times.length, count = %d, times = [[], []];
  const plain = () => { let a = 0; for (let k = 0; k < poses * count; k++) a = a * 0.9999999 + 1.0000001; return a; };
  for (let round = 0; round < 30; round++)
    for (const [i, run] of [() => mechanism.run(values), plain].entries()) {
      const start = performance.now(); run(); times[i].push(performance.now() - start);
    }
  return times;
}"""
KINDS = ("ScriptDuration", "RecalcStyleDuration", "LayoutDuration")


def measured(browser: Any, example: str, frames: int) -> dict[str, Any]:
    """The row of an example."""
    file = ROOT / "examples" / f"{example}.yaml"
    job = lw.run(file)
    data = report_data(load(file), job.outcomes, text=file.read_text(encoding="utf-8"))
    text = page(data)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "report.html"
        path.write_text(text, encoding="utf-8")
        view = browser.new_page(viewport={"width": 1400, "height": 900})
        view.goto(path.as_uri())
        view.evaluate("linkwright.drawing.pause()")
        session = view.context.new_cdp_session(view)
        session.send("Performance.enable", {"timeDomain": "threadTicks"})

        def used() -> float:
            found = {one["name"]: one["value"] for one in session.send("Performance.getMetrics")["metrics"]}
            return sum(found[kind] for kind in KINDS) * 1e3

        computed, whole = [], []
        for k in range(frames):
            before = used()
            computed.append(view.evaluate(CHANGE, k))
            whole.append(used() - before)
        live = data["live"]
        assert live is not None
        run, plain = (np.array(times) for times in view.evaluate(LOOP % operations(example, live)))
        view.close()
    half = frames // 4  # engines optimise first
    return {
        "report": example,
        "kB": round(len(text.encode()) / 1e3, 1),
        "kB gzip": round(len(gzip.compress(text.encode())) / 1e3, 1),
        "poses": len(live["times"]),
        "compute ms, median": round(float(np.median(computed[half:])), 2),
        "compute ms, p95": round(float(np.percentile(computed[half:], 95)), 2),
        "change ms, median": round(float(np.median(whole[half:])), 2),
        "change ms, p95": round(float(np.percentile(whole[half:], 95)), 2),
        "over plain loop": round(float(np.median(run[5:] / plain[5:])), 2),
    }


def main() -> None:
    arguments = parser(__doc__)
    arguments.add_argument("--frames", type=int, default=120)
    arguments.add_argument("examples", nargs="*", default=EXAMPLES)
    given = arguments.parse_args()
    from playwright.sync_api import sync_playwright

    chromium = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))))
    with sync_playwright() as play:
        browser = play.chromium.launch(executable_path=chromium, args=FLAGS)
        rows = [measured(browser, example, given.frames) for example in given.examples]
        browser.close()
    if given.json:
        print(json.dumps(rows, indent=2))
        return
    for row in rows:
        print("  ".join(f"{key}: {value}" for key, value in row.items()))


def operations(example: str, live: LiveData) -> int:
    """The instructions of a pose: those of the programs of signals and of measures' rows."""
    file = ROOT / "examples" / f"{example}.yaml"
    compiled = lw.compile(named_numbers(load(file)).mechanism)
    graph, measured = compiled.graph, live_rows(live_measures(compiled))
    return graph.with_rates([*graph.pose_rows, *live["signals"]], measured).size


if __name__ == "__main__":
    main()
