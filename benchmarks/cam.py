"""What the cam study of the heat-seal example takes of the processor, check and run, without what is written.

With --against SRC, a src folder of another version, the two take turns, each in a process of its own, and their ratio
is told.

    python benchmarks/cam.py --against ../other/src
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from statistics import median

from figures import parser, tell

ROOT = Path(__file__).parents[1]
EXAMPLE = ROOT / "examples" / "heat_seal_cam.yaml"
ONCE = """
import sys, time
from linkwright.app.job import examine_file, perform
start = time.process_time()
examined = examine_file(__import__("pathlib").Path(sys.argv[1]), only="cam")
middle = time.process_time()
job = perform(examined)
assert job.exit_code == 0
print(middle - start, time.process_time() - middle)
"""


def once(source: Path) -> tuple[float, float]:
    """CPU seconds to check and to run with the package in a folder."""
    given = os.environ | {"PYTHONPATH": str(source)}
    done = subprocess.run([sys.executable, "-c", ONCE, EXAMPLE], env=given, capture_output=True, text=True, check=True)
    check, run = map(float, done.stdout.split())
    return check, run


def main() -> None:
    """Print the figures."""
    made = parser(__doc__)
    made.add_argument("--against", type=Path, help="src folder of another version")
    made.add_argument("--times", type=int, default=5)
    options = made.parse_args()
    sources = {"here": ROOT / "src"} | ({"there": options.against} if options.against else {})
    taken = [{name: once(source) for name, source in sources.items()} for _ in range(options.times)]
    figures: dict[str, float | str] = {}
    for k, part in enumerate(("check", "run")):
        seconds = {name: median(one[name][k] for one in taken) for name in sources}
        figures |= {f"{part}, {name} (s)": value for name, value in seconds.items()}
        if options.against:
            figures[f"{part}, here over there"] = median(one["here"][k] / one["there"][k] for one in taken)
    tell(figures, options.json)


if __name__ == "__main__":
    main()
