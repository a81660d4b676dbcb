"""Times of the main job, as figures and as ratios within one run: ``python3 dev.py bench [--json]``.

The paper feeder: compile, 200 poses of full kinetostatics, a million poses of the 18 outputs of a design study
(docs/performance.md), the command line. Machines differ and are noisy: hold ratios against each other, not seconds.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import numpy as np
from figures import parser, tell

import linkwright as lw
from linkwright.app.bench import bench, median

ROOT = Path(__file__).resolve().parent.parent
FEEDER = ROOT / "examples" / "paper_feeder.yaml"
PLATFORM = ROOT / "examples" / "platform.yaml"

OUTPUTS = [
    *("C.x", "C.y", "E.x", "E.y", "E.vx", "E.vy", "E.ax", "E.ay"),
    *("coupler.omega", "rocker.omega", "coupler.alpha", "rocker.alpha"),
    *("force(frame, crank).x", "force(frame, crank).y", "force(coupler, rocker).x", "force(coupler, rocker).y"),
    *("force(guide, slider).x", "motor.torque"),
]


def command(*words: str) -> Callable[[], object]:
    """A run of the command line in a process of its own."""
    return lambda: subprocess.run([sys.executable, "-m", "linkwright", *words], check=True, capture_output=True)


def one_thread(compiled: lw.Compiled, poses: int) -> float:
    """Nanoseconds a pose of the machine code on one thread."""
    times = bench(compiled, OUTPUTS, poses, workers=1, seconds=1.5, kernels=["llvm"])
    return times.kernels["llvm"].ns_per_pose


def measure(poses: int) -> dict[str, float]:
    """All figures by name; the unit ends the name."""
    document = lw.load(FEEDER)
    compiled = lw.compile(document)
    every = [signal.text for signal in compiled.quantities.signals.all()]
    t = np.linspace(0.0, 1.5, 200)
    figures = {
        "compile_ms": 1e3 * median(lambda: lw.compile(document).graph.program(OUTPUTS), 9),
        "poses_200_full_ms": 1e3 * median(lambda: compiled.evaluate(every, t), 9),
        "poses_200_full_cold_ms": 1e3 * median(lambda: lw.compile(document).evaluate(every, t), 5),
    }
    platform, turn = lw.load(PLATFORM), np.linspace(0.0, 1.0, 361)
    plate = ["plate.angle", "plate.omega", "plate.alpha", "motor.torque", "force(leg3, plate).x"]
    fresh = [lw.compile(platform) for _ in range(6)]  # each follows its group once
    figures["triad_360_poses_ms"] = 1e3 * median(lambda: fresh.pop().evaluate(plate, turn), 5)
    times = bench(compiled, OUTPUTS, poses, seconds=1.5)
    figures["fill_ns_per_pose"] = times.fill_ns_per_pose
    for name, kernel in times.kernels.items():
        figures[f"{name}_cold_s"] = kernel.cold_s
        figures[f"{name}_ns_per_pose"] = kernel.ns_per_pose
        figures[f"{name}_over_fill"] = kernel.ns_per_pose / times.fill_ns_per_pose
        if name == "llvm":
            figures["llvm_one_thread_over_fill"] = one_thread(compiled, poses) / times.fill_ns_per_pose
    with tempfile.TemporaryDirectory() as folder:
        figures["help_s"] = median(command("--help"), 5)
        figures["run_with_report_s"] = median(command("run", str(FEEDER), "--out", folder), 5)
    return figures


def main() -> None:
    """Print the figures, as a table or as JSON."""
    arguments = parser(__doc__)
    arguments.add_argument("--poses", type=int, default=1_000_000, help="poses of the kernel's figure")
    options = arguments.parse_args()
    tell(measure(options.poses), options.json)


if __name__ == "__main__":
    main()
