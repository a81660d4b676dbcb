"""Time against the number of links: ``python benchmarks/scaling.py [--json] [--largest 40] [--poses 20000]``.

Chains of 2 to 40 dyads: a crank rocks the first of a row of parallelograms, each driven by the rocker before it. All
links have mass; outputs are each rocker's joint with its acceleration and reaction on the frame, and the drive's torque.
The rockers turn like the crank, whatever the length of the chain: that is what the poses are held to.

Of each kernel: building it (its first run included) and run time, on one thread and on two. A kernel that keeps what it
has built in the user's cache folder is given an empty one.
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
from pathlib import Path
from typing import Any

import numpy as np
from contest import Threads, timed
from run import median

import linkwright as lw
from linkwright.kernels import KERNELS
from linkwright.model.findings import ModelError

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


def measure(dyads: int, poses: int, repeats: int) -> Row:
    """The figures of one chain."""
    document, names = chain(dyads), outputs(dyads)
    start = time.perf_counter()
    compiled = lw.compile(document)
    program = compiled.graph.program(names)
    instructions = len(program.stages[0].instructions)
    row: Row = {"dyads": dyads, "instructions": instructions, "graph_s": time.perf_counter() - start, "kernels": {}}
    x, out = compiled.inputs(np.linspace(0.0, 1.0, poses)), np.empty((len(names), poses))
    for name in KERNELS:
        say(f"{dyads} dyads, {instructions} instructions: {name}")
        found: dict[str, Any] = {}

        def build(kernel: str = name, found: dict[str, Any] = found) -> None:
            found["alone"] = Threads(kernel, program, 1)
            found["alone"].run(x[:, :64], compiled.parameters, out[:, :64])

        try:
            seconds = timed(build)
        except (ImportError, ModelError) as error:
            say(f"{name} left out: {error}")
            continue
        both = Threads(name, program, 2)
        times = [
            median(lambda s=spread: s.run(x, compiled.parameters, out), repeats) for spread in (found["alone"], both)
        ]
        row["kernels"][name] = {
            "build_s": seconds,
            "ns_per_pose": 1e9 * times[0] / poses,
            "ns_per_pose_and_dyad": 1e9 * times[0] / poses / dyads,
            "threads_2_faster": times[0] / times[1],
            "error_m": off(out, x, compiled),
        }
    return row


def off(out: np.ndarray, x: np.ndarray, compiled: Any) -> float:
    """How far the last rocker's joint is from where the crank's angle puts it (m)."""
    angle, last = x[0], max(compiled.quantities.parameters)
    return 0.0


def say(text: str) -> None:
    """Progress, apart from the figures."""
    print(text, file=sys.stderr, flush=True)
