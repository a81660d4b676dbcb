"""A hundred thousand four-bars over a turn, reduced: ``python benchmarks/samples.py [--json] [--samples N]``.

All four lengths of examples/four_bar_sweep.yaml are varied; a coupler point and the rocker's angle are reduced at 360
poses to count, mean, deviation and extremes. By kernel and threads, by the workers of a Dask cluster, and the memory of
small and large sweeps. Seconds are those of the carried work after compiling, the median of several.
"""

from __future__ import annotations

import statistics
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from figures import parser, tell

import linkwright as lw
from linkwright.kernels import KERNELS

EXAMPLE = Path(__file__).resolve().parent.parent / "examples" / "four_bar_sweep.yaml"
OUTPUTS = ["P.x", "rocker.angle"]
POSES = 360


def seconds(samples: int, repeats: int, kernel: str, workers: int | None = None, cluster: str | None = None) -> float:
    """The median time of a sweep, compiled before."""

    def once(count: int, seed: int) -> float:
        done = lw.sweep(
            EXAMPLE, outputs=OUTPUTS, samples=count, plan="random", seed=seed, poses=POSES - 1, kernel=kernel,
            workers=workers, cluster=cluster,
        )  # fmt: skip
        assert done.done
        return done.seconds

    once(5000, 0)
    return statistics.median(once(samples, seed) for seed in range(1, repeats + 1))


@contextmanager
def local_cluster(workers: int) -> Iterator[str]:
    """A Dask cluster of so many processes here, by its address."""
    from distributed import LocalCluster

    with LocalCluster(
        n_workers=workers, threads_per_worker=1, processes=True, dashboard_address=None, silence_logs=50
    ) as cluster:
        yield cluster.scheduler_address


def memory(samples: int) -> float:
    """The most memory (MiB) of a process that makes such a sweep."""
    code = (
        "import resource, samples, sys; samples.seconds(int(sys.argv[1]), 1, samples.best()); "
        "print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024)"
    )
    folder = Path(__file__).resolve().parent
    done = subprocess.run(
        [sys.executable, "-c", code, str(samples)], cwd=folder, check=True, capture_output=True, text=True
    )
    return float(done.stdout)


def best() -> str:
    """The fastest kernel that is installed."""
    return "llvm" if KERNELS["llvm"].available() else "numpy"


def measure(samples: int, repeats: int, cluster: bool = True) -> dict[str, float]:
    """All figures by name."""
    figures: dict[str, float] = {}
    for kernel in dict.fromkeys([best(), "numpy"]):
        for workers in (1, 2):
            figures[f"{kernel}_{workers}_threads_s"] = seconds(samples, repeats, kernel, workers)
    if cluster:
        for workers in (1, 2):
            with local_cluster(workers) as address:
                figures[f"{best()}_{workers}_dask_workers_s"] = (
                    seconds(10 * samples, repeats, best(), cluster=address) / 10
                )
    for name in (f"{best()}_1_threads_s", f"{best()}_2_threads_s", "numpy_2_threads_s"):
        figures[name.replace("_s", "_ns_per_pose")] = 1e9 * figures[name] / (samples * POSES)
    for count in (samples, 10 * samples):
        figures[f"memory_of_{count:.0e}_samples_MiB".replace("e+0", "e")] = memory(count)
    return figures


def main() -> None:
    """Print the figures."""
    arguments = parser(__doc__)
    arguments.add_argument("--samples", type=int, default=100_000)
    arguments.add_argument("--repeats", type=int, default=3)
    arguments.add_argument("--no-cluster", action="store_true", help="leave Dask out")
    options = arguments.parse_args()
    tell(measure(options.samples, options.repeats, not options.no_cluster), options.json)


if __name__ == "__main__":
    main()
