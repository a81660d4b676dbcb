"""A study in a process of its own, to be killed and interrupted: python -m blocks.process FOLDER PAUSE."""

from __future__ import annotations

import json
import sys
from pathlib import Path

from blocks.works import Noise, folding, storing
from linkwright.blocks import Threads, Together, carry

if __name__ == "__main__":
    folder, work = Path(sys.argv[1]), Noise(pause=float(sys.argv[2]))
    sink = Together([folding(work, folder / "state"), storing(work, folder / "values.zarr")])
    print("next", sink.next, flush=True)
    outcome = carry(work, sink, Threads(2), lambda done, total: print("done", done, flush=True), every=0.0)
    print(json.dumps({"done": outcome.done, "interrupted": outcome.interrupted, "atoms": outcome.atoms}))
