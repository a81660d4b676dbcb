"""Time against the number of links: ``python benchmarks/scaling.py [--json] [--largest 40] [--poses 50000]``.

With ``--links 10 20 50 100 194`` instead whole processes, from a model file of so many links to its results, or to the
answer to a fault (whole_runs.py): processor time and peak memory.

Chains of 2 to 40 dyads: a crank rocks the first of a row of parallelograms, each driven by the rocker before it. All
links have mass; outputs are each rocker's joint, angular acceleration and force from the frame, and the drive's torque.
The rockers turn like the crank, whatever the length of the chain, so that the last joint's height and the torque have
closed forms: the largest error of both, over their largest magnitude, stands beside the times.

Of each kernel: building it (its first run included), run time on one thread, how much faster two are. A kernel that
keeps what it has built in the user's cache folder is given an empty one.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import sys
import tempfile
import time
from collections.abc import Iterator
from functools import partial
from typing import Any
from unittest.mock import patch

import numpy as np
import whole_runs
from contest import Array, kernels
from run import median

import linkwright as lw
from linkwright.kernels.threaded import spread

SIZES = (2, 5, 10, 20, 40)
SWING = 0.5
"""Amplitude of the crank (rad), about upright."""
Row = dict[str, Any]


def chain(dyads: int) -> lw.Document:
    """Parallelograms in a row, a dyad each: rockers of 0.3 m on pivots 0.3 to 0.5 m apart."""
    build = lw.Builder("chain", length="m", angle="rad").gravity(0, "-9.80665 m/s^2").parameter("r", 0.3)
    pivots, tops = [0.0], [f"B{i}" for i in range(dyads + 1)]
    for i in range(dyads):
        pivots.append(pivots[-1] + 0.3 + 0.1 * (i % 3))
    build.frame({f"A{i}": [x, 0] for i, x in enumerate(pivots)})
    build.link("L0", {"A0": [0, 0], "B0": ["r", 0]}, mass=1, shape="rod A0-B0")
    for i, (x, before) in enumerate(zip(pivots[1:], pivots, strict=False), start=1):
        build.parameter(f"c{i}", x - before)
        coupler = {tops[i - 1]: [0, 0], tops[i]: [f"c{i}", 0]}
        build.link(f"K{i}", coupler, mass=0.5, shape=f"rod {tops[i - 1]}-{tops[i]}")
        build.link(f"L{i}", {f"A{i}": [0, 0], tops[i]: ["r", 0]}, mass=1, shape=f"rod A{i}-{tops[i]}")
        build.assembly(tops[i], f"left of {tops[i - 1]}-A{i}")
    upright = f"{math.pi / 2!r} rad + {SWING} rad*sin({2 * math.pi!r} rad/s*t)"
    return build.drive("motor", turns="L0", position=upright).build()


def outputs(dyads: int) -> list[str]:
    """What is computed of a chain."""
    each = ("B{}.x", "B{}.y", "L{}.alpha", "force(frame, L{}).x")
    return [*(name.format(i) for i in range(1, dyads + 1) for name in each), "motor.torque"]


def exact(dyads: int, q: Array, alpha: Array) -> Array:
    """The height of the last joint (m) and the drive's torque (N m), in closed form.

    The rockers turn about their ends (m r^2 / 3), the couplers go round in circles of radius r.
    """
    r = 0.3
    inertia = ((dyads + 1) / 3 + dyads * 0.5) * r**2
    return np.array([r * np.sin(q), inertia * alpha + 9.80665 * r * ((dyads + 1) / 2 + dyads * 0.5) * np.cos(q)])


def measure(dyads: int, poses: int, repeats: int) -> Row:
    """The figures of one chain."""
    document, names = chain(dyads), outputs(dyads)
    start = time.perf_counter()
    compiled = lw.compile(document)
    program = compiled.graph.program(names)
    row: Row = {"dyads": dyads, "instructions": program.size, "graph_s": time.perf_counter() - start, "kernels": {}}
    x, p, out = compiled.inputs(np.linspace(0.0, 1.0, poses)), compiled.parameters, np.empty((len(names), poses))
    true = exact(dyads, x[0], x[2])
    skipped: list[str] = []
    for kind in kernels(skipped):
        start = time.perf_counter()
        kernel = kind(program)
        kernel.run(x[:, :64], p, out[:, :64])
        figures = {"build_s": time.perf_counter() - start}
        times = [median(partial(spread, kernel, x, p, out, n), repeats) / poses for n in (1, 2)]
        off = np.abs(out[[-4, -1]] - true).max(axis=1) / np.abs(true).max(axis=1)
        figures |= {"ns_per_pose": 1e9 * times[0], "ns_per_pose_and_dyad": 1e9 * times[0] / dyads}
        row["kernels"][kernel.name] = {**figures, "two_threads": times[0] / times[1], "error": float(off.max())}
        say(f"{dyads} dyads, {program.size} instructions, {kernel.name}: {figures['build_s']:.3g} s to build")
    for reason in skipped:
        say(f"left out: {reason}")
    return row


def table(rows: list[Row]) -> Iterator[str]:
    """The figures as a table."""
    yield "dyads  instructions  graph s  kernel      build s   ns/pose  ns/pose/dyad  2 threads  error"
    for row in rows:
        for name, f in row["kernels"].items():
            left = f"{row['dyads']:5d}{row['instructions']:14d}{row['graph_s']:9.3f}  {name:10s}"
            times = f"{f['build_s']:9.3g}{f['ns_per_pose']:10.4g}{f['ns_per_pose_and_dyad']:14.4g}"
            yield f"{left}{times}{f['two_threads']:11.2f}  {f['error']:.0e}"


def told(rows: Iterator[Row]) -> Iterator[Row]:
    """The rows, each said when it is there."""
    for row in rows:
        say(f"{row['class']}, {row['links']} links: {row['run_s']:.3g} s")
        yield row


def say(text: str) -> None:
    """Progress, apart from the figures."""
    print(text, file=sys.stderr, flush=True)


def main() -> None:
    """Print the figures, as a table or as JSON."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.add_argument("--largest", type=int, default=SIZES[-1], help="dyads of the longest chain")
    parser.add_argument("--poses", type=int, default=50_000, help="poses of a run")
    parser.add_argument("--repeats", type=int, default=5, help="runs that the medians are taken of")
    parser.add_argument("--links", type=int, nargs="*", help="whole processes for models of so many links")
    options = parser.parse_args()
    if options.links is not None:
        whole = list(told(whole_runs.measured(options.links or whole_runs.SIZES)))
        print(json.dumps(whole, indent=2) if options.json else "\n".join(whole_runs.table(whole)))
        return
    with tempfile.TemporaryDirectory() as folder, patch.dict(os.environ, XDG_CACHE_HOME=folder):
        measure(1, 100, 1)  # what kernels import isn't theirs to build
        rows = [measure(n, options.poses, options.repeats) for n in SIZES if n <= options.largest]
    print(json.dumps(rows, indent=2) if options.json else "\n".join(table(rows)))


if __name__ == "__main__":
    main()
