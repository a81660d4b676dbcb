"""Whether two meshes have the same curves."""

from __future__ import annotations

import numpy as np
import pytest

from linkwright.studies.workspace.curves import Traced
from linkwright.studies.workspace.path_similarity import alike

STEP = np.array([0.1, 0.1])


def circles(pieces: int, *circles: tuple[float, float, float]) -> Traced:
    """Circles (x, y, radius) of so many chords each."""
    turn = np.exp(2j * np.pi * np.arange(pieces + 1) / pieces)
    at = np.concatenate([np.stack([x + r * turn[:-1], x + r * turn[1:]]) + 1j * y for x, y, r in circles], axis=1)
    nothing = np.empty((2, 0))
    singular = tuple(np.stack([end.real, end.imag]) for end in at)
    return {"singular": (singular[0], singular[1]), "modes": (nothing, nothing)}


@pytest.mark.parametrize(
    ("fine", "same"),
    [
        (circles(60, (0, 0, 1), (3, 0, 1)), True),
        (circles(60, (0, 0.02, 1), (3, 0, 1)), True),  # within the mesh's steps
        (circles(60, (0, 0, 1)), False),
        (circles(60, (0, 0, 1), (3, 0, 1), (3, 0, 0.95)), False),  # a curve more, near to one that both have
        (circles(60, (0, 0, 1), (3, 0.5, 1)), False),
    ],
)
def test_curves_are_counted_and_compared(fine: Traced, same: bool) -> None:
    coarse = circles(31, (0, 0, 1), (3, 0, 1))
    assert alike(coarse, fine, STEP) == same
    assert alike(fine, coarse, STEP) == same


def test_curves_of_one_mesh_alone() -> None:
    one = circles(31, (0, 0, 1))
    other = {"singular": one["modes"], "modes": one["singular"]}
    assert alike(one, one, STEP) and not alike(one, other, STEP) and not alike(other, one, STEP)
