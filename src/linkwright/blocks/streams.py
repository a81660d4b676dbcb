"""Random streams: one for each unit of samples, whoever draws from it and when."""

from __future__ import annotations

import numpy as np


def generator(seed: int, unit: int) -> np.random.Generator:
    """The stream of a unit of samples: independent of those of other units (NumPy's seed sequences, PCG64)."""
    return np.random.Generator(np.random.PCG64(np.random.SeedSequence(seed, spawn_key=(unit,))))
