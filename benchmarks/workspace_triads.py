"""Workspaces whose way back is a triad, of random mechanisms: ``python benchmarks/workspace_triads.py``.

A crank, a coupler guided by a rocker, a slider or a rocking block, and a driven arm on it, of any lengths
(tests/studies/workspace/models.py), which knows their motion by complex numbers. Of each: poses at random places, that
must lead there by the forward motion and be no fewer than signs along the coupler's way tell; cells of three sizes, in
which what is said to be reached or not must hold at random places. With ``--regions`` also whole regions with the
drives in ranges: certified or not, the time, and random poses of the forward motion, that must lie inside.

``[--count 30] [--seed 0] [--regions 0]``. Exit code 1 where anything is wrong.
"""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path

import numpy as np
import shapely

sys.path.append(str(Path(__file__).resolve().parent.parent / "tests"))

from linkwright.studies.workspace.mesh import DriveBox
from linkwright.studies.workspace.region_enclosure import enclosed
from studies.workspace.models import ArmOnCoupler, random_arm
from studies.workspace.test_platforms import PART, WHOLE, places_on, poses

PLACES, CELLS, LOOKS = 150, 150, 8
SIZES = 2e-2, 4e-3, 5e-4
INSIDE = 1e-5


def poses_of(shape: ArmOnCoupler, seed: int) -> tuple[int, int, int]:
    """How many places; at how many a pose leads elsewhere, or poses are missed."""
    random = np.random.default_rng(seed)
    z = random.uniform(-1.5, 1.8, PLACES) + 1j * random.uniform(-1.5, 1.5, PLACES)
    places = places_on(shape.sheet(1.0), WHOLE)
    values, depth = places.drives(np.stack([z.real, z.imag]))
    off = [np.abs(shape.placed(one, 1.0) - z) for one in values]
    number, sure = poses(shape, z, WHOLE, 1.0)
    elsewhere = (np.array(off) > 1e-9) & (depth > 0)
    return z.size, int(elsewhere.any(axis=0).sum()), int(((depth > 0).sum(axis=0) < number)[sure].sum())


def cells_of(shape: ArmOnCoupler, seed: int) -> tuple[int, int, int]:
    """How many places of cells; how many of them contradict what is said of their cells; how many cells are reached."""
    random, places = np.random.default_rng(seed), places_on(shape.sheet(1.0), PART if seed % 2 else WHOLE)
    count = wrong = decided = 0
    for size in SIZES:
        at = random.uniform([[-0.8], [-1.0]], [[1.6], [1.0]], (2, CELLS))
        half = np.full(CELLS, size)
        forms, of = places.forms(at, half, np.zeros(CELLS, dtype=int))
        low, high = forms.bounds
        sure, may = (
            np.isin(np.arange(CELLS), of[(low > 0).all(axis=0)]),
            np.isin(np.arange(CELLS), of[~(high < 0).any(axis=0)]),
        )
        for u, v in random.uniform(-1, 1, (LOOKS, 2)):
            depth = places.depth(at + half * np.array([[u], [v]]))
            wrong += int((((depth > 1e-12) & ~may) | (sure & ~(depth > 0))).sum())
            count += CELLS
        decided += int(sure.sum())
    return count, wrong, decided


def region_of(shape: ArmOnCoupler, seed: int) -> tuple[str, bool]:
    """What comes of a region with the drives in ranges; whether it is wrong in silence."""
    random = np.random.default_rng(seed)
    theta = np.linspace(0, 2 * np.pi, 400)
    middle = float(random.choice(theta[np.isfinite(shape.coupler(theta, 1.0)[1])]))
    box = DriveBox((middle - 0.6, -0.8), (middle + 0.6, 0.8), (False, False))
    start = time.perf_counter()
    found = enclosed(places_on(shape.sheet(1.0), box), 1e-5)
    took = time.perf_counter() - start
    if found is None:
        return f"searched, {took:.0f} s", False
    at = shape.placed(random.uniform(box.low, box.high, (4000, 2)).T, 1.0)
    at = at[np.isfinite(at)]
    away = shapely.distance(found.shape, shapely.points(at.real, at.imag))
    area, (low, high) = found.shape.area, found.certificate.area or (0.0, 0.0)
    wrong = bool((away > INSIDE).any()) or not low - INSIDE <= area <= high + INSIDE
    faults = ", ".join(one.kind for one in found.certificate.faults)
    told = f"{'certified' if found.certificate.certified else faults}, {area:.6g} m2 in {low:.6g} .. {high:.6g}"
    return f"{told}, {took:.0f} s{', contradicted' if wrong else ''}", wrong and found.certificate.certified


def main() -> int:
    """Print the figures."""
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name, usual in (("count", 30), ("seed", 0), ("regions", 0)):
        asked.add_argument(f"--{name}", type=int, default=usual)
    given = asked.parse_args()
    seeds = range(given.seed, given.seed + given.count)
    shapes = [random_arm(seed) for seed in seeds]
    places, elsewhere, missed = np.sum([poses_of(*one) for one in zip(shapes, seeds, strict=True)], axis=0).tolist()
    print(f"{places} places: {elsewhere} with a pose that leads elsewhere, {missed} at which poses are missed")
    looks, wrong, reached = np.sum([cells_of(*one) for one in zip(shapes, seeds, strict=True)], axis=0).tolist()
    print(f"{looks} places of cells: {wrong} contradict them; {reached} cells are reached")
    silent = 0
    for seed in range(given.seed, given.seed + given.regions):
        told, bad = region_of(random_arm(seed), seed)
        silent += bad
        print(f"region {seed} ({random_arm(seed).leg}): {told}", flush=True)
    return int(bool(elsewhere or missed or wrong or silent))


if __name__ == "__main__":
    sys.exit(main())
