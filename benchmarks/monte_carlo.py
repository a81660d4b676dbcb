"""A million four-bars as they may be made, over a turn: ``python benchmarks/monte_carlo.py [--json] [--samples N]``.

The lengths of examples/four_bar_sweep.yaml with tolerances of some hundredths of a millimetre, correlated and
differently distributed; a coupler point and the rocker's angle at 360 positions, by the random samples of the accuracy
study. Seconds are those of the carried work after compiling, the median of several. Beside them: the same by a loop
over samples in NumPy with the closed form, all positions at once; and how far the standard deviation is from the root
sum square (with correlations) of the exact transfer coefficients at any position, in its standard errors.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from figures import parser, tell
from numpy.typing import NDArray

import linkwright as lw
from linkwright.blocks import Threads
from linkwright.kernels import KERNELS
from linkwright.model.document import plain
from linkwright.results import Run
from linkwright.studies import RunContext
from linkwright.studies.accuracy.figures import curves
from linkwright.studies.accuracy.monte_carlo import SampleStatistics, monte_carlo
from linkwright.studies.accuracy.options import AccuracyOptions
from linkwright.studies.accuracy.signal_sensitivities import Slopes
from linkwright.studies.accuracy.stated_contributors import contributors
from linkwright.studies.accuracy.study import AccuracyStudy

Array = NDArray[np.float64]
EXAMPLE = Path(__file__).resolve().parent.parent / "examples" / "four_bar_sweep.yaml"
TOLERANCES = {
    "a": {"value": 40, "tolerance": 0.02},
    "b": {"value": 120, "tolerance": {"limits": 0.03, "distribution": "uniform"}},
    "c": {"value": 80, "tolerance": [-0.01, 0.03]},
    "d": {"value": 100, "tolerance": {"limits": 0.03, "distribution": "triangular"}},
}
ACCURACY: dict[str, Any] = {
    "outputs": ["P.x", "rocker.angle"],
    "correlations": [{"of": ["a", "c"], "is": 0.8}],
    "plan": "random",
}
POSES = 360


class Case:
    """The study of so many samples."""

    def __init__(self, samples: int, seed: int, kernel: str) -> None:
        data = plain(lw.load(EXAMPLE))
        data["parameters"] = TOLERANCES
        given = {**ACCURACY, "samples": samples, "seed": seed, "kernel": kernel, "poses": POSES - 1}
        data["studies"] = {"cycle": data["studies"]["cycle"], "accuracy": given}
        self.document = lw.Document.model_validate(data)
        self.compiled = lw.compile(self.document)
        self.options = AccuracyOptions.model_validate(given, context=data["studies"])
        self.run = Run(self.compiled, 0.0, 0.5, POSES - 1)

    def random(self, workers: int) -> SampleStatistics:
        """Its random samples."""
        return monte_carlo(self.run, self.options, RunContext(document=self.document, runner=Threads(workers)))

    def loop(self, samples: int) -> tuple[float, Mapping[str, Array]]:
        """Seconds of a loop over the first samples, and its standard deviations at each position."""
        drawn = AccuracyStudy().draws(self.compiled, self.options)
        lengths = drawn.values(0)[:, :samples].T
        q = np.radians(40) + 4 * np.pi * self.run.t
        sums, squares, first = np.zeros((2, q.size)), np.zeros((2, q.size)), closed_form(*lengths[0], q)
        start = time.perf_counter()
        for sample in lengths:
            d = closed_form(*sample, q) - first
            sums += d
            squares += d * d
        seconds = time.perf_counter() - start
        n = len(lengths)
        sigma = np.sqrt((squares - sums**2 / n) / (n - 1))
        return seconds, dict(zip(ACCURACY["outputs"], sigma, strict=True))

    def superposed(self) -> Mapping[str, Array]:
        """The standard deviations that the exact transfer coefficients give."""
        of = contributors(self.compiled, self.options)
        found = curves(self.run, Slopes(self.run, of.directions), of, ACCURACY["outputs"])
        return {text: curve.sigma for text, curve in found.items()}


def closed_form(a: float, b: float, c: float, d: float, q: Array) -> Array:
    """x of the coupler point and the rocker's angle, (2, positions), at crank angles (rad): two circles cut."""
    x, y = a * np.cos(q), a * np.sin(q)
    e = np.hypot(d - x, -y)
    coupler = np.arctan2(-y, d - x) + np.arccos((b * b + e * e - c * c) / (2 * b * e))
    rocker = np.unwrap(np.arctan2(y + b * np.sin(coupler), x + b * np.cos(coupler) - d))
    return np.stack([x + 0.07 * np.cos(coupler + np.pi / 6), rocker])


def best() -> str:
    """The fastest kernel that is installed."""
    return "llvm" if KERNELS["llvm"].available() else "numpy"


def measure(samples: int, repeats: int, kernel: str, looped: int = 2000) -> dict[str, float]:
    """All figures by name."""
    Case(5000, 0, kernel).random(1)  # compiles
    figures: dict[str, float] = {"samples": samples, "positions": POSES}
    found: list[tuple[Case, SampleStatistics]] = []
    for workers in (1, 2):
        seconds = []
        for seed in range(1, repeats + 1):
            case = Case(samples, seed, kernel)
            found.append((case, case.random(workers)))
            seconds.append(found[-1][1].seconds)
        figures[f"{kernel}_{workers}_threads_s"] = statistics.median(seconds)
    figures["ns_per_position"] = 1e9 * figures[f"{kernel}_2_threads_s"] / (samples * POSES)
    case, random = found[0]
    one, own = case.loop(min(looped, samples))
    figures["numpy_loop_s"] = one / min(looped, samples) * samples
    figures["ratio_to_numpy_loop"] = figures["numpy_loop_s"] / figures[f"{kernel}_2_threads_s"]
    # The standard error of a deviation: (kurtosis - 1)/4n of its square, at most 1/2n where no kurtosis is over 3.
    error, few = np.sqrt(1 / (2 * samples)), np.sqrt(1 / (2 * min(looped, samples)))
    for text, sigma in case.superposed().items():
        off = np.abs(random.curves[text][1] / sigma - 1)
        figures[f"{text}_sigma_off_rss_largest"] = float(off.max())
        figures[f"{text}_sigma_off_rss_in_standard_errors"] = float(off.max() / error)
        figures[f"{text}_loop_off_rss_in_standard_errors"] = float(np.abs(own[text] / sigma - 1).max() / few)
    return figures


def main() -> None:
    """Print the figures."""
    arguments = parser(__doc__)
    arguments.add_argument("--samples", type=int, default=1_000_000)
    arguments.add_argument("--repeats", type=int, default=3)
    options = arguments.parse_args()
    tell(measure(options.samples, options.repeats, best()), options.json)


if __name__ == "__main__":
    main()
