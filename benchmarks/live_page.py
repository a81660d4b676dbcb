"""The live report in Chromium: ``python benchmarks/live_page.py [--json] [--frames 120] [EXAMPLE ...]``.

Of each report: its size, as it is and as sent (gzip); per change of a number the time of computing all signals and
measures' rows (``compute``, by the page's clock), and the processor time of the scripts, of styles and layout, by the
clock of Chromium's thread, for the whole change: compute, drawing, visible plots, measures. While a joint is dragged
round a small circle, one move a frame: the same processor time of each frame, as Chromium's trace has it, and the time
from frame to frame. Also the time of a pose beside a plain loop of as many multiplications and additions as the program
has instructions, in the same page.
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

EXAMPLES = {"paper_feeder": "C", "jansen_leg": "D", "loader": "S"}
"""Reports, and the joint that is dragged in each; elsewhere the last point is."""
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
ROUND = """([x, y, frames]) => new Promise(done => {
  const picture = linkwright.drawing.picture, times = [];
  const step = (k = 0) => {
    times.push(performance.now());
    const [c, s] = [Math.cos(k * Math.PI / 10), Math.sin(k * Math.PI / 10)];
    const at = { clientX: x + 8 * (c - 1), clientY: y - 8 * s, pointerId: 1, buttons: 1, bubbles: true };
    picture.dispatchEvent(new PointerEvent("pointermove", { ...at, pointerType: "mouse", isPrimary: true }));
    if (k < frames) requestAnimationFrame(() => step(k + 1)); else done(times);
  };
  requestAnimationFrame(() => step());
})"""
TRACED = ["devtools.timeline", "devtools.timeline.frame", "disabled-by-default-devtools.timeline", "toplevel"]
WORK = ("FireAnimationFrame", "UpdateLayoutTree", "Layout", "EventDispatch", "TimerFire", "MinorGC", "MajorGC")
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
        worked, intervals = dragged(browser, view, EXAMPLES.get(example), frames)

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
        "frame of a drag ms, median": round(float(np.median(worked)), 2),
        "frame of a drag ms, p95": round(float(np.percentile(worked, 95)), 2),
        "from frame to frame ms, median": round(float(np.median(intervals)), 1),
        "from frame to frame ms, p95": round(float(np.percentile(intervals, 95)), 1),
        "over plain loop": round(float(np.median(run[5:] / plain[5:])), 2),
    }


def dragged(browser: Any, view: Any, point: str | None, frames: int) -> tuple[np.ndarray, np.ndarray]:
    """Of each frame of a drag the processor time (ms) of the page's thread, and the time from frame to frame (ms)."""
    view.evaluate("linkwright.drawing.setIndex(40)")
    point = point or view.evaluate("linkwright.live.data.program.points")[-1]
    box = view.locator(f'#drawing [data-point="{point}"]').bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    view.mouse.move(x, y)
    view.mouse.down()
    view.evaluate(ROUND, [x, y, frames])
    browser.start_tracing(page=view, categories=TRACED)
    times = view.evaluate(ROUND, [x, y, frames])
    events = json.loads(browser.stop_tracing())["traceEvents"]
    view.mouse.up()
    view.evaluate("linkwright.live.reset()")
    view.wait_for_timeout(500)
    fired = [(event["pid"], event["tid"]) for event in events if event["name"] == "FireAnimationFrame"]
    thread = max(set(fired), key=fired.count)
    own = [event for event in events if (event["pid"], event["tid"]) == thread]
    ends = sorted(event["ts"] for event in events if event["name"] == "Commit" and event["pid"] == thread[0])
    spent, end = np.zeros(len(ends) + 1), 0.0
    for event in sorted((e for e in own if e["name"] in WORK and e["ph"] == "X"), key=lambda e: (e["ts"], -e["dur"])):
        if event["ts"] >= end:  # what lies within another one is counted there
            end = event["ts"] + event["dur"]
            spent[np.searchsorted(ends, event["ts"])] += event["tdur"] / 1e3
    return spent[2:-2], np.diff(times)


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
