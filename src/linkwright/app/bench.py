"""What each kernel takes for a model's poses: cold, with all that has to be made first, and warm."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Sequence
from dataclasses import field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright._machine import processors
from linkwright.app.job import Examined
from linkwright.data_classes import dataclass
from linkwright.expressions.dimensions import DimensionError
from linkwright.expressions.language import ExpressionError
from linkwright.expressions.unknown import near
from linkwright.findings import Finding, ModelError, Term, raise_errors
from linkwright.kernels import KERNELS, Compiled
from linkwright.kernels.threaded import pool, spread, stretches
from linkwright.model.signals import Signal
from linkwright.studies.cycle.options import CycleOptions, span

Array = NDArray[np.float64]

MOST = 1 << 30
"""Bytes of outputs at most; of many outputs fewer poses are taken."""
REPEATS = 7


@dataclass(frozen=True)
class KernelTimes:
    """A kernel's times. ``cold_s`` from the program to the figures of a first pose; ``ns_per_pose``
    the median of all poses on all threads (of a kernel that gains nothing from several on
    one), written to an array that is there; ``deviation`` the largest difference from
    the first kernel, over each output's largest magnitude."""

    cold_s: float
    ns_per_pose: float
    outputs: int
    deviation: float


@dataclass(frozen=True)
class Bench:
    """Times of all kernels installed, of one run: they stand against ``fill_ns_per_pose``, what it takes to write the
    same bytes on the same threads."""

    kernels: dict[str, KernelTimes]
    fill_ns_per_pose: float
    poses: int
    threads: int
    instructions: int
    outputs: tuple[str, ...]
    missing: tuple[str, ...] = field(default=())

    def as_dict(self) -> dict[str, Any]:
        """As plain data."""
        every = {name: dict(vars(times)) for name, times in self.kernels.items()}
        rest = {key: value for key, value in vars(self).items() if key != "kernels"}
        return {"kernels": every, **rest, "outputs": list(self.outputs), "missing": list(self.missing)}


def bench(
    compiled: Compiled,
    outputs: Sequence[str] = (),
    poses: int = 1_000_000,
    workers: int = 0,
    seconds: float = 1.0,
    kernels: Sequence[str] = (),
) -> Bench:
    """Time all kernels, or those named, on so many ``seconds`` of a compiled mechanism's motion.

    ``outputs`` are signals; without them all positions, velocities, accelerations, reactions and drive efforts of what
    moves. Raises :class:`ModelError` for a name that isn't a signal, and for a kernel whose package isn't installed.
    """
    names = _signals(compiled, outputs) or default_outputs(compiled)
    workers = workers or processors()
    poses = max(1, min(poses, MOST // (8 * len(names))))
    program = compiled.graph.program(names, solve=True)
    x = compiled.inputs(np.linspace(0.0, seconds, poses), starts=True)
    out = np.empty((len(names), poses))
    parts = stretches(poses, workers)

    def fill() -> None:
        list(pool(len(parts)).map(lambda part: out[:, part].fill(1.0), parts))

    found: dict[str, KernelTimes] = {}
    reference: Array | None = None
    fills = []
    for name, kernel in sorted(KERNELS.items(), key=lambda entry: entry[0] != "numpy"):
        if (name not in kernels) if kernels else not kernel.available():
            continue
        start = time.perf_counter()
        made = kernel(program)
        made.run(x[:, :1], compiled.parameters)
        cold = time.perf_counter() - start
        warm = median(lambda made=made: spread(made, x, compiled.parameters, out, workers if made.scales else 1))  # type: ignore[misc]
        reference = out.copy() if reference is None else reference
        found[name] = KernelTimes(cold, 1e9 * warm / poses, len(names), _deviation(out, reference))
        fills.append(median(fill))
    missing = tuple(name for name, kernel in KERNELS.items() if not kernel.available())
    return Bench(found, 1e9 * statistics.median(fills) / poses, poses, workers, program.size, names, missing)


def bench_file(
    examined: Examined,
    outputs: Sequence[str] = (),
    poses: int = 1_000_000,
    workers: int = 0,
    kernels: Sequence[str] = (),
) -> Bench | None:
    """The same of an examined file, over the span of its cycle where it has one. What is wrong goes to its findings."""
    compiled = examined.compiled
    unknown = [name for name in kernels if name not in KERNELS]
    known = sorted(KERNELS)
    for name in unknown:
        examined.findings.append(Finding("name.unknown-kernel", (), {"name": name, "near": near(name, known, True)}))
    if compiled is None or examined.exit_code:
        return None
    cycles = [task.options for task in examined.tasks if isinstance(task.options, CycleOptions)]
    seconds = span(compiled, cycles[0])[0] if cycles else 1.0
    try:
        return bench(compiled, outputs, poses, workers, seconds, kernels)
    except ModelError as error:
        examined.findings += examined.located(error.findings)
        return None


def default_outputs(compiled: Compiled) -> tuple[str, ...]:
    """All positions, velocities, accelerations, reactions and drive efforts of what moves."""
    structure = compiled.structure
    moving = set(structure.topology.moving)
    links_of_points = compiled.quantities.signals.links_of_points

    def wanted(signal: Signal) -> bool:
        owner, attribute = signal.owners[0] if signal.owners else "", signal.attribute
        if signal.kind == "point":
            return links_of_points[owner] in moving and attribute in ("x", "y", "vx", "vy", "ax", "ay")
        if signal.kind == "link":
            return owner in moving and attribute in ("omega", "alpha")
        if signal.kind == "force":
            return attribute in ("x", "y")
        return signal.kind == "drive" and attribute in ("torque", "force")

    return tuple(signal.text for signal in compiled.quantities.signals.all() if wanted(signal))


def _signals(compiled: Compiled, names: Sequence[str]) -> tuple[str, ...]:
    found, wrong = [], []
    for name in names:
        try:
            found.append(compiled.graph.signal(name).text)
        except (DimensionError, ExpressionError, AssertionError):
            wrong.append(Finding("signal.unknown", (), {"name": name, "hint": Term("signal-forms")}))
    raise_errors(wrong)
    return tuple(found)


def _deviation(found: Array, reference: Array) -> float:
    size = np.nanmax(np.abs(reference), axis=1, initial=0.0)
    size = np.maximum(size, 1e-9 * size.max(initial=1.0))
    return float(np.nanmax(np.abs(found - reference).max(axis=1) / size, initial=0.0))


def median(action: Callable[[], object], times: int = REPEATS, clock: Callable[[], float] = time.perf_counter) -> float:
    """The median time of an action (s), one warm-up apart."""
    action()
    seconds = []
    for _ in range(times):
        start = clock()
        action()
        seconds.append(clock() - start)
    return statistics.median(seconds)
