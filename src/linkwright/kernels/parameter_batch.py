"""Many parameter sets of one compiled mechanism: its signals over samples and poses, without a loop over samples.

What a sample gives doesn't depend, to the last bit, on which others are computed with it. The groups' branches are
those of the nominal parameters.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Hashable, Iterator, Sequence
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.unknown import near
from linkwright.findings import Finding, Joined, raise_errors
from linkwright.graph.rows import Named, ReachRow
from linkwright.kernels.compiled import Compiled
from linkwright.kernels.continuation_batch import MOST, Pursued, Pursuit
from linkwright.kernels.external_inputs import Supply
from linkwright.kernels.failure_causes import Failures, causes
from linkwright.kernels.motion_faults import law_faults
from linkwright.kernels.registry import KERNELS, Kernel
from linkwright.kernels.tables import fixed_parts, table_faults
from linkwright.kernels.unwrapped_angles import turns_of
from linkwright.model.check import check_values
from linkwright.model.quantities import Quantities
from linkwright.model.sampled import Sampled, dependent, names_in
from linkwright.model.values import tilts
from linkwright.structure import Group

Array = NDArray[np.float64]
Key = TypeVar("Key", bound=Hashable)
Made = TypeVar("Made")

CHUNK = 1 << 18
"""Poses of which the inputs are held at once."""

_MAKING = threading.Lock()
"""Graphs and their symbols are made by one thread at a time."""


class Varied:
    """A compiled mechanism over many sets of values of the named parameters. All of it may be called from several
    threads."""

    def __init__(self, compiled: Compiled, names: Sequence[str]) -> None:
        self.compiled, self.graph, self.names = compiled, compiled.graph, tuple(names)
        self.varying = dependent(compiled.quantities, frozenset(self.names))
        raise_errors(self._refused())
        self.causes = causes(compiled.structure)
        self.row = {name: i for i, name in enumerate(self.graph.parameters)}
        self._kernels: dict[tuple[tuple[Named, ...], bool, str], Kernel] = {}
        self._pursued: dict[str, Pursued] = {}
        self._supplies: dict[str, Supply] = {}

    def _refused(self) -> Iterator[Finding]:
        """Why these parameters can't be varied."""
        quantities, known = self.compiled.quantities, self.graph.parameters
        for name in self.names:
            if name not in known:
                yield Finding("name.unknown-parameter", ("parameters", name), {"name": name, "near": near(name, known)})
        if self.names and self.compiled.passages.every:
            yield Finding("varied.passage", ("studies", "cycle", "through"), {"names": Joined(self.names)})
        for name in self.names if self.compiled.structure.topology.closing_slides else ():
            if tilted := next(tilts(_altered(quantities, name)), None):
                yield Finding("varied.slides", ("joints", tilted[0]), {"name": name, "loop": Joined(tilted[1])})
        for name, table in quantities.mechanism.tables.items():
            held = {part for node in fixed_parts(table) for part in names_in(node)} & self.varying
            if held:
                yield Finding("varied.table", ("tables", name), {"table": name, "names": Joined(sorted(held))})
        for name, follower in quantities.mechanism.followers.items():
            for law in follower.laws.values() if follower.derived else ():
                if held := {*self.compiled.motions[law].names} & self.varying:
                    data = {"law": law, "name": name, "names": Joined(sorted(held))}
                    yield Finding("varied.second", quantities.mechanism.path_of(name), data)

    def parameters(self, values: Array) -> Array:
        """All parameters (parameters, samples) from the values of the varied ones, (names, samples), both in SI.

        Those that are expressions of varied ones follow. A sample with which the model makes no sense comes out as NaN.
        """
        sampled = self._sampled(values)
        self._check(sampled)
        p = sampled.rows()
        p[:, sampled.wrong] = np.nan
        return p

    def faults(self, values: Array) -> list[Finding]:
        """What the model's own checks of numbers say of some samples, (names, samples): each fault once."""
        sampled = self._sampled(values)
        return [*sampled.findings, *self._check(sampled)]

    def _check(self, sampled: Sampled) -> list[Finding]:
        return [*check_values(sampled), *law_faults(sampled, self.compiled.motions), *table_faults(sampled)]

    def joins(self, p: Array) -> dict[str, Array]:
        """Where the pieces of laws that vary begin and end, and last their periods, under names that no parameter has:
        (samples,) each."""
        found: dict[str, Array] = {}
        for law, motion in self.compiled.motions.items():
            if motion.names & self.varying:
                places = motion.places_at(law, {name: p[self.row[name], :, None] for name in motion.names})
                found |= {name: np.broadcast_to(np.ravel(at), p.shape[1]) for name, at in places.items()}
        return found

    def _sampled(self, values: Array) -> Sampled:
        given = dict(zip(self.names, np.asarray(values, dtype=float), strict=True))
        return Sampled(self.compiled.quantities, given, np.shape(values)[1])

    def kernel(self, signals: Sequence[Named], rates: bool = False, kernel: str = "numpy") -> Kernel:
        """The kernel of some signals or other rows, kept."""
        key = (tuple(signals), rates, kernel)
        return _made_once(self._kernels, key, lambda: KERNELS[kernel](self.graph.program(*key[:2])))

    def evaluate(
        self,
        signals: Sequence[Named],
        p: Array,
        t: Array,
        rates: bool = False,
        kernel: str = "numpy",
        out: Array | None = None,
    ) -> Array:
        """Signals of all samples at the same times ``t`` (s), ascending from 0 on: (signals, samples, times) in SI.

        With ``rates``, each is followed by its rate: (2 signals, samples, times). NaN where a sample can't be
        assembled or followed; angles as :meth:`Compiled.evaluate` gives them. ``p`` is that of :meth:`parameters`.
        """
        return self._evaluate(self.kernel(signals, rates, kernel), p, np.asarray(t, dtype=float), out)

    def signals_at(
        self, signals: Sequence[Named], p: Array, t: Array, rates: bool = False, kernel: str = "numpy"
    ) -> Array:
        """Signals of each sample at its own times ``t`` (samples, times): (signals, samples, times), or with rates
        (signals, 2, samples, times)."""
        found = self._evaluate(self.kernel(signals, rates, kernel), p, np.asarray(t, dtype=float), None)
        return found.reshape(len(signals), 2, *t.shape) if rates else found

    def failures(self, p: Array, t: Array, kernel: str = "numpy") -> Failures:
        """Which samples can't be assembled or followed at some of the times ``t`` (s), and why."""
        t = np.asarray(t, dtype=float)
        first = np.full((len(self.causes), p.shape[1]), np.inf)
        first[0, np.isnan(p).any(axis=0)] = t[0] if t.size else 0.0
        if t.size:
            labels = [cause.of.label for cause in self.causes if isinstance(cause.of, Group)]
            engine = self.kernel([ReachRow(label) for label in labels], kernel=kernel) if labels else None
            used = frozenset(range(len(self.graph.motion_inputs)))
            self._gather(p, used, kernel)
            for some in _chunks(p.shape[1], t.size):
                x = self.inputs(p[:, some], t, used, kernel)
                reach = dict(zip(labels, engine.over(x, p[:, some]), strict=True)) if engine else {}
                for row, cause in zip(first[1:, some], self.causes[1:], strict=True):
                    bad = cause.fails(self.graph, x, reach)
                    row[:] = np.where(bad.any(axis=1), t[bad.argmax(axis=1)], np.inf)
        met = np.where(np.isfinite(first).any(axis=0), first.argmin(axis=0), -1)
        return Failures(first.min(axis=0), met)

    def finding(self, cause: int, count: int, samples: int, sample: int, time: float, values: Array) -> Finding:
        """That ``count`` of ``samples`` fail by one of the causes; the first is number ``sample``, at a time (s), with
        ``values`` (names,) of the varied parameters."""
        data = {"count": count, "samples": samples, "sample": sample, "time": f"{time:.6g}"}
        return self.causes[cause].finding(self, data, time, np.asarray(values, dtype=float))

    def _evaluate(self, kernel: Kernel, p: Array, t: Array, out: Array | None) -> Array:
        samples, times = p.shape[1], t.shape[-1]
        if out is None:
            out = np.empty((len(kernel.program.outputs), samples, times))
        used = kernel.program.used[0]
        if t.ndim == 1 and not self._has_own_inputs(used):
            kernel.over(self._drives(p, t, used=used), p, out)
        else:
            self._gather(p, used, kernel.name)
            for some in _chunks(samples, times):
                x = self.inputs(p[:, some], t if t.ndim == 1 else t[some], used, kernel.name)
                kernel.over(x, p[:, some], out[:, some])
        out[:, np.isnan(p).any(axis=0)] = np.nan
        return out

    def _has_own_inputs(self, used: frozenset[int]) -> bool:
        """Whether samples have used inputs of their own."""
        laws = any(law.names & self.varying for law in self.compiled.laws.values())
        return laws or any(row >= self.graph.first_unknown for row in used)

    def inputs(self, p: Array, t: Array, used: frozenset[int], kernel: str) -> Array:
        """The per-pose inputs at times ``t`` (times,) or (samples, times), as far as they are ``used``: (inputs,
        samples, times)."""
        first = len(self.graph.motion_inputs)
        actions, pursued = any(row >= first for row in used), self._pursuer(used, kernel)
        x = self._drives(p, t, (p.shape[1], t.shape[-1]), None if actions or pursued else used)
        if pursued is not None:
            x[pursued.rows] = pursued.coordinates(x, p, t)
        if actions:
            self._supply(x, p, t, kernel)
        return x

    def _drives(
        self, p: Array, t: Array, shape: tuple[int, ...] | None = None, used: frozenset[int] | None = None
    ) -> Array:
        """The inputs with the drives' values and rates and the branches alone: (inputs, *shape); of the drives all, or
        those alone of which rows are ``used``."""
        x = np.full((len(self.graph.inputs), *(shape or t.shape)), np.nan)
        nominal, width = self.compiled.quantities.parameters, self.graph.width
        for i, drive in enumerate(self.graph.drives):
            if used is not None and used.isdisjoint(range(i * width, (i + 1) * width)):
                continue
            law = self.compiled.laws[drive]
            given: dict[str, float | Array] = {name: nominal[name] for name in law.names - self.varying}
            given |= {name: p[self.row[name], :, None] for name in law.names & self.varying}
            for k, row in enumerate(law.at(t, given).d, start=i * width):
                x[k] = row
        for i, group in enumerate(self.graph.branched, start=len(self.graph.drives) * width):
            x[i] = self.compiled.assembly.branches[group]
        return x

    def _gather(self, p: Array, used: frozenset[int], kernel: str) -> None:
        """Let what follows the higher groups know all samples, where it is asked for some at a time."""
        if (pursued := self._pursuer(used, kernel)) is not None:
            pursued.gather(p)

    def _pursuer(self, used: frozenset[int], kernel: str) -> Pursued | None:
        """What follows the higher groups with a kernel, where inputs that are ``used`` depend on them."""
        higher_groups = self.compiled.structure.higher_groups
        if not higher_groups or not any(row >= self.graph.first_unknown for row in used):
            return None
        return _made_once(self._pursued, kernel, lambda: self._pursuing(kernel))

    def _pursuing(self, kernel: str) -> Pursued:
        """What follows the higher groups with a kernel."""
        assembly, higher_groups = self.compiled.assembly, self.compiled.structure.higher_groups
        pursuit = Pursuit(self.graph, higher_groups, assembly.size(), kernel)
        start = np.concatenate([assembly.starts[higher_group] for higher_group in higher_groups])
        return Pursued(pursuit, start, self.compiled.parameters, self._drives)

    def _supply(self, x: Array, p: Array, t: Array, kernel: str) -> None:
        """Put the inputs of acting elements and followers into those of the motion."""
        tables = self.compiled.tables
        supply = _made_once(self._supplies, kernel, lambda: Supply(self.graph, tables, kernel, self.compiled.laws))
        quantities = self.compiled.quantities
        x[supply.first :] = 0.0
        if "t" in supply.rows:
            x[supply.rows["t"]] = t
        motion = frozenset(range(supply.first))
        for name, turns in supply.turns.items():
            sampled = Sampled(quantities, dict(zip(self.row, p, strict=True)), p.shape[1])
            start_angle = supply.start_angle(name, sampled.value)
            x[supply.rows[f"turns/{name}"]] = turns_of(
                turns.kernel, start_angle, x, t, p, lambda p, t: self.inputs(p, t, motion, kernel)
            )
        given = dict(zip(self.row, p[:, :, None], strict=True))
        supply.look_up(x, lambda of: of.over(x, p), given)
        supply.fill_follower_inputs(x, given)


def _altered(quantities: Quantities, name: str) -> Quantities:
    """The numbers with another value of a parameter, near its own."""
    value = quantities.parameters[name]
    return Sampled(quantities, {name: np.array([value + 1e-3 * (abs(value) or 1.0)])}, 1)


def _made_once(made: dict[Key, Made], key: Key, make: Callable[[], Made]) -> Made:
    """What is made once for a key."""
    if key not in made:
        with _MAKING:
            if key not in made:
                made[key] = make()
    return made[key]


def _chunks(samples: int, times: int) -> Iterator[slice]:
    """Some samples at a time."""
    step = max(1, min(MOST, CHUNK // max(times, 1)))
    return (slice(first, first + step) for first in range(0, samples, step))
