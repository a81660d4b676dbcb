"""Forty random mechanisms, those of benchmarks/workspace_random.py with the first seeds, against inverse kinematics."""

from __future__ import annotations

import pytest

from helpers.reach import tried
from helpers.reach.judging import RIGHT

SEEDS = range(40)
"""34 five-bars of four families, six of the other four."""
CELLS = 768
"""A raster coarser than the benchmark's 2048 tells areas to some 1e-4."""


@pytest.mark.parametrize("seed", SEEDS)
def test_both_regions_are_certified_and_right(seed: int) -> None:
    found = tried(seed, CELLS)
    assert found.outcome == RIGHT, found.verdicts
