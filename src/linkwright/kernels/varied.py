"""Many parameter sets of one compiled mechanism: its signals over samples and poses, without a loop over samples.

What a sample gives doesn't depend, to the last bit, on which others are computed with it. The groups' branches are
those of the nominal parameters.
"""

from __future__ import annotations

import threading
from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.kernels.compiled import Compiled
from linkwright.kernels.registry import KERNELS, Kernel
from linkwright.model.findings import Finding, raise_errors
from linkwright.model.sampled import Sampled, dependent
from linkwright.model.unknown import near
from linkwright.notation import MAX_ORDER

Array = NDArray[np.float64]

CHUNK = 1 << 18
"""Poses of which the inputs are held at once."""

_MAKING = threading.Lock()
"""Graphs and their symbols are made by one thread at a time."""


class Varied:
    """A compiled mechanism over many sets of values of the named parameters. All of it may be called from several
    threads."""

    def __init__(self, compiled: Compiled, names: Sequence[str]) -> None:
        self.compiled, self.graph, self.names = compiled, compiled.graph, tuple(names)
        raise_errors(self._refused())
        self.varying = dependent(compiled.quantities, frozenset(self.names))
        self.row = {name: i for i, name in enumerate(self.graph.parameters)}
        self._kernels: dict[tuple[tuple[str, ...], bool, str], Kernel] = {}

    def _refused(self) -> list[Finding]:
        known = self.graph.parameters
        unknown = [name for name in self.names if name not in known]
        return [
            Finding("name.unknown-parameter", ("parameters", name), {"name": name, "near": near(name, known)})
            for name in unknown
        ]

    def parameters(self, values: Array) -> Array:
        """All parameters (parameters, samples) from the values of the varied ones, (names, samples), both in SI.

        Those that are expressions of varied ones follow. A sample with which the model makes no sense comes out as NaN.
        """
        values = np.asarray(values, dtype=float)
        sampled = Sampled(self.compiled.quantities, dict(zip(self.names, values, strict=True)))
        p = sampled.rows(values.shape[1])
        p[:, np.broadcast_to(sampled.wrong, values.shape[1])] = np.nan
        return p

    def kernel(self, signals: Sequence[str], rates: bool = False, kernel: str = "numpy") -> Kernel:
        """The kernel of some signals, kept."""
        key = (tuple(signals), rates, kernel)
        if key not in self._kernels:
            with _MAKING:
                self._kernels[key] = KERNELS[kernel](self.graph.program(*key[:2]))
        return self._kernels[key]

    def evaluate(
        self,
        signals: Sequence[str],
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

    def at(self, signals: Sequence[str], p: Array, t: Array, rates: bool = False, kernel: str = "numpy") -> Array:
        """Signals of each sample at its own times ``t`` (samples, times): (signals, samples, times), or with rates
        (signals, 2, samples, times)."""
        found = self._evaluate(self.kernel(signals, rates, kernel), p, np.asarray(t, dtype=float), None)
        return found.reshape(len(signals), 2, *t.shape) if rates else found

    def _evaluate(self, kernel: Kernel, p: Array, t: Array, out: Array | None) -> Array:
        samples, times = p.shape[1], t.shape[-1]
        if out is None:
            out = np.empty((len(kernel.program.outputs), samples, times))
        shared = t.ndim == 1 and not self._own()
        if shared:
            kernel.over(self.inputs(p, t), p, out)
        else:
            for some in _chunks(samples, times):
                kernel.over(self.inputs(p[:, some], t if t.ndim == 1 else t[some]), p[:, some], out[:, some])
        out[:, np.isnan(p).any(axis=0)] = np.nan
        return out

    def _own(self) -> bool:
        """Whether samples have inputs of their own."""
        return any(law.names & self.varying for law in self.compiled.laws.values())

    def inputs(self, p: Array, t: Array) -> Array:
        """The per-pose inputs: (inputs, times) where all samples share them, or (inputs, samples, times)."""
        shape = t.shape if t.ndim == 1 and not self._own() else (p.shape[1], t.shape[-1])
        x = np.full((len(self.graph.inputs), *shape), np.nan)
        self._laws(x, p, t)
        first = len(self.graph.drives) * (MAX_ORDER + 2)
        for i, group in enumerate(self.graph.branched, start=first):
            x[i] = self.compiled.assembly.branches[group]
        return x

    def _laws(self, x: Array, p: Array, t: Array) -> None:
        """Put the drives' values and rates into the inputs."""
        nominal = self.compiled.quantities.parameters
        for i, drive in enumerate(self.graph.drives):
            law = self.compiled.laws[drive]
            given: dict[str, float | Array] = {name: nominal[name] for name in law.names - self.varying - {"t"}}
            given |= {name: p[self.row[name], :, None] for name in law.names & self.varying}
            for k, row in enumerate(law.at(t, given).d, start=i * (MAX_ORDER + 2)):
                x[k] = row


def _chunks(samples: int, times: int) -> Iterator[slice]:
    """Some samples at a time."""
    step = max(1, CHUNK // max(times, 1))
    return (slice(first, first + step) for first in range(0, samples, step))
