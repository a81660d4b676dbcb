"""Where a dyad can't close, its links stand as near to each other as they can: what is missing is its shortfall."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from helpers.compiled import compiled_from
from helpers.examples import four_bar, slider_crank
from linkwright.kernels import Compiled
from linkwright.kernels.numpy_blocks import NumpyKernel

UNITS = {"length": "m", "angle": "rad", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"}


def rows(compiled: Compiled, **changed: float) -> np.ndarray:
    """What the program gives over a turn, at other parameters: (4 links + 3 dyads, times)."""
    t = np.linspace(0.0, 6.0, 41)
    p = np.array([changed.get(name, value) for name, value in compiled.quantities.parameters.items()])
    return NumpyKernel(compiled.graph.nearest_poses).run(compiled.inputs(t), p)


def nearest(compiled: Compiled, **changed: float) -> dict[str, np.ndarray]:
    """The poses of all links (x, y, cos, sin)."""
    moving = compiled.structure.topology.moving
    found = rows(compiled, **changed)[: 4 * len(moving)].reshape(len(moving), 4, -1)
    return dict(zip(moving, found, strict=True))


def spans(compiled: Compiled, **changed: float) -> np.ndarray:
    """Of the only dyad the distance that it must span, the least and the most that it can (m), -1 without a limit."""
    return rows(compiled, **changed)[-3:]


def place(pose: np.ndarray, x: float, y: float = 0.0) -> np.ndarray:
    """A point of a link over the poses."""
    return np.array([pose[0] + pose[2] * x - pose[3] * y, pose[1] + pose[3] * x + pose[2] * y])


def with_parameters(data: dict[str, Any], **values: float) -> dict[str, Any]:
    return data | {"parameters": {name: f"{value} m" for name, value in values.items()}}


def test_where_it_closes_it_is_the_motion() -> None:
    compiled = compiled_from(four_bar())
    t = np.linspace(0.0, 6.0, 41)
    true = compiled.evaluate(compiled.graph.pose_rows, t).reshape(-1, 4, t.size)
    np.testing.assert_allclose(np.array([*nearest(compiled).values()]), true, atol=1e-14)


@pytest.mark.parametrize(("coupler", "inside"), [(0.6, False), (9.0, True)])
def test_two_pinned_links(coupler: float, inside: bool) -> None:
    """Links too short point at each other; links too different lie along the line of their pins."""
    data = with_parameters(four_bar(), coupler=3.0)
    data["links"]["coupler"]["points"]["C"] = ["coupler", 0]
    compiled = compiled_from(data)
    poses = nearest(compiled, coupler=coupler)
    crank_pin = place(poses["crank"], 1.0)
    far = np.hypot(*(np.array([[4.0], [0.0]]) - crank_pin))
    missing = np.maximum(far - (coupler + 3.0), 0.0) if not inside else np.maximum(abs(coupler - 3.0) - far, 0.0)
    gap = np.hypot(*(place(poses["coupler"], coupler) - place(poses["rocker"], 3.0)))
    assert missing.max() > 0.1
    limits = np.broadcast_to([[abs(coupler - 3.0)], [coupler + 3.0]], (2, far.size))
    np.testing.assert_allclose(spans(compiled, coupler=coupler), [far, *limits], rtol=1e-14)
    np.testing.assert_allclose(gap, missing, atol=1e-12)
    for pose in poses.values():
        np.testing.assert_allclose(np.hypot(pose[2], pose[3]), 1.0, atol=1e-14)
    np.testing.assert_allclose(place(poses["coupler"], 0.0), crank_pin, atol=1e-14)
    np.testing.assert_allclose(
        place(poses["rocker"], 0.0), np.broadcast_to([[4.0], [0.0]], crank_pin.shape), atol=1e-14
    )


def test_a_link_that_doesn_t_reach_its_slide() -> None:
    data = with_parameters(slider_crank(), rod=3.0)
    data["links"]["rod"]["points"]["C"] = ["rod", 0]
    compiled = compiled_from(data)
    poses = nearest(compiled, rod=0.4)
    pin = place(poses["crank"], 1.0)
    missing = np.maximum(np.abs(pin[1]) - 0.4, 0.0)
    gap = np.hypot(*(place(poses["rod"], 0.4) - place(poses["piston"], 0.0)))
    assert missing.max() > 0.5
    limits = np.broadcast_to([[0.0], [0.4]], (2, missing.size))
    np.testing.assert_allclose(spans(compiled, rod=0.4), [np.abs(pin[1]), *limits], atol=1e-14)
    np.testing.assert_allclose(gap, missing, atol=1e-12)
    np.testing.assert_allclose(place(poses["piston"], 0.0)[1], 0.0, atol=1e-14)
