"""Random mechanisms of each family, of the 500 in benchmarks/workspace_random.py, against inverse kinematics."""

from __future__ import annotations

import pytest

from helpers.reach import tried
from helpers.reach.judging import RIGHT

SEEDS = {
    "five-bar, nearly equal": (192, 305, 320, 357),
    "five-bar, near change": (198, 321, 396),
    "five-bar, limited": (232, 247, 275, 331),
    "five-bar, any": (3, 107, 351),
    "two cylinders": (6, 59),
    "two slides": (39,),
    "crank with slide": (19,),
    "four-bar with arm": (213, 266),
}
"""Those of each family that take the least time; the first one always."""
CELLS = 768
"""A raster coarser than the benchmark's 2048 tells areas to some 1e-4."""


@pytest.mark.parametrize(
    ("family", "seed"),
    [
        pytest.param(family, seed, marks=[pytest.mark.long] if place else [])
        for family, seeds in SEEDS.items()
        for place, seed in enumerate(seeds)
    ],
)
def test_both_regions_are_certified_and_right(family: str, seed: int) -> None:
    found = tried(seed, CELLS)
    assert found.family == family
    assert found.outcome == RIGHT, found.verdicts
