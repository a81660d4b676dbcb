"""One sample of many as a run of its own, for what isn't computed of many at once."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy

import numpy as np
from numpy.typing import NDArray

from linkwright.graph.rows import Named
from linkwright.kernels import Compiled
from linkwright.kernels.parameter_batch import Varied
from linkwright.results.run import Run

Array = NDArray[np.float64]


class _Sample(Compiled):
    """A compiled mechanism with the parameters ``p`` (parameters,) of a sample, as far as a run asks it."""

    def __init__(self, varied: Varied, p: Array, kernel: str) -> None:
        self.__dict__.update(varied.compiled.__dict__)
        self.quantities = copy(varied.compiled.quantities)
        self.quantities.parameters = dict(zip(varied.graph.parameters, p.tolist(), strict=True))
        if not np.isnan(p).any():
            own = self.quantities.parameters
            self.motions = {name: law.at_parameters(own) for name, law in self.motions.items()}  # type: ignore[misc]
        self.varied, self.parameters, self.kernel = varied, p, kernel

    def possible_rows(self, names: Sequence[Named], t: Array, rates: bool = False) -> Array:
        """The named rows at times ``t``, as :class:`Varied` gives them."""
        shape = (len(names), 2, t.size) if rates else (len(names), t.size)
        return self.varied.signals_at(names, self.parameters[:, None], t[None], rates, self.kernel).reshape(shape)


def sample_run(varied: Varied, run: Run, p: Array, stop: float, kernel: str = "numpy") -> Run:
    """A run of the sample ``p`` (parameters,) up to ``stop`` (s), looked at as closely as ``run``."""
    found = Run(_Sample(varied, p, kernel), run.start, stop, run.steps)
    found.grid = run.grid
    return found
