"""Grids over triangles."""

from __future__ import annotations

import numpy as np

from linkwright.studies.workspace.raster import _places_in_triangles


def test_a_triangle_without_an_area_holds_nothing() -> None:
    """And NumPy warns of nothing, which would be seen on the user's terminal."""
    flat, sound = np.zeros((2, 3)), np.array([[0.0, 2.0, 0.0], [0.0, 0.0, 2.0]])
    places, which, shares = _places_in_triangles(np.stack([flat, sound], axis=1), np.arange(3.0), np.arange(3.0))
    assert set(which.tolist()) == {1}
    assert places.size == 6
    assert np.allclose(shares.sum(axis=1), 1)
