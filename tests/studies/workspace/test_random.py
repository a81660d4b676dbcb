"""Forty random mechanisms of the 500 in benchmarks/workspace_random.py, against inverse kinematics."""

from __future__ import annotations

import pytest

from helpers.reach import tried
from helpers.reach.judging import RIGHT

SEEDS = {
    "five-bar, nearly equal": (192, 272, 282, 301, 305, 320, 357, 461),
    "five-bar, near change": (198, 245, 264, 283, 297, 321, 396, 401),
    "five-bar, limited": (232, 247, 270, 275, 331, 402, 430, 444),
    "five-bar, any": (3, 107, 163, 210, 332, 351, 408),
    "two cylinders": (6, 59, 299),
    "two slides": (39, 279),
    "crank with slide": (19, 206),
    "four-bar with arm": (213, 266),
}
"""Those of each family that take the least time."""
CELLS = 768
"""A raster coarser than the benchmark's 2048 tells areas to some 1e-4."""


@pytest.mark.parametrize(("family", "seed"), [(family, seed) for family, seeds in SEEDS.items() for seed in seeds])
def test_both_regions_are_certified_and_right(family: str, seed: int) -> None:
    found = tried(seed, CELLS)
    assert found.family == family
    assert found.outcome == RIGHT, found.verdicts
