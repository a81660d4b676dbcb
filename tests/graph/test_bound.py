"""How far a point can get at most, against where it gets at random."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from helpers.compiled import compiled_from
from helpers.examples import UNITS
from helpers.reach import Chain, FiveBar, Guide, TwoCylinders, TwoSlides
from helpers.reach.mechanisms import Mechanism
from linkwright.graph.bound import farthest
from linkwright.kernels import Compiled

MECHANISMS: list[Mechanism] = [
    FiveBar(12.0, 30.0, 27.0, 10.0, 18.0, 14.0, 0.7),
    FiveBar(30.0, 8.0, 9.0, 40.0, 70.0, 5.0, -2.0),
    TwoCylinders(50.0, (40.0, 70.0), (35.0, 60.0)),
    TwoSlides(3 + 25j, (0.2, -0.4), 30.0, 31.0, 18.0, 1.1, (-40.0, 60.0), (-40.0, 40.0)),
    Guide(6.0, 4 + 3j, None, (20.0, 60.0)),
    Chain(15.0, 40.0, 35.0, 50.0, 20.0),
]


def bound(compiled: Compiled, point: str, travels: dict[str, float]) -> float:
    parameters = dict(zip(compiled.graph.parameters, compiled.parameters.tolist(), strict=True))
    return farthest(compiled.graph, point, parameters, travels)


@pytest.mark.parametrize("mechanism", MECHANISMS, ids=lambda one: type(one).__name__)
def test_no_values_of_the_drives_lead_farther(mechanism: Mechanism) -> None:
    spans = np.array(mechanism.spans)[:, :, None]
    q = np.random.default_rng(1).uniform(spans[:, 0], spans[:, 1], (2, 20_000))
    at = [mechanism.placed(q, mode) for mode in range(len(mechanism.modes))]
    compiled = compiled_from(mechanism.document(q[:, np.isfinite(at[0].real)][:, 0]))
    travels = {}
    for drive, span in zip(compiled.graph.drives, mechanism.spans, strict=True):
        if not compiled.mechanism.prescribed(drive).turns:
            travels[compiled.structure.topology.drivable_joints(drive)[0].joint] = max(map(abs, span)) * 1e-3
    found = bound(compiled, "P", travels)
    far = max(float(np.nanmax(abs(one))) for one in at) * 1e-3
    assert far <= found < 4 * far


def arm(elbow: list[float]) -> dict[str, Any]:
    return {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"O": [3, 4]}},
            "upper": {"points": {"O": [0, 0], "A": elbow}},
            "fore": {"points": {"A": [1, 0], "P": [1, 2]}},
        },
        "drives": {
            "shoulder": {"turns": "upper", "on": "frame", "speed": 1, "start": 0},
            "elbow": {"turns": "fore", "on": "upper", "speed": 1, "start": 1.0},
        },
    }


def test_an_arm_gets_as_far_as_its_links_add_up() -> None:
    """O lies 5 from the origin, the links are 1.3 and 2 long."""
    assert bound(compiled_from(arm([1.2, 0.5])), "P", {}) == pytest.approx(5 + 1.3 + 2)


def test_a_point_of_the_frame_stays_where_it_is() -> None:
    assert bound(compiled_from(arm([1, 0])), "O", {}) == pytest.approx(5)


def test_the_shortest_way_counts() -> None:
    """Of a five-bar's pin: over one crank 1 + 2, over the other 6 + 9 + 9."""
    data = FiveBar(1.0, 2.0, 9.0, 9.0, 6.0, 9.0, 0.0).document(np.array([0.0, 2.1])) | {"units": UNITS}
    data["links"]["link3"]["points"]["P"] = [9.0, 0.0]
    compiled = compiled_from(data)
    assert bound(compiled, "C", {}) == pytest.approx(3)
    assert bound(compiled, "P", {}) == pytest.approx(3)


def test_slides_lead_as_far_as_they_travel_and_without_that_nowhere() -> None:
    compiled = compiled_from(
        {
            "linkwright": 1,
            "units": UNITS,
            "links": {
                "frame": {"points": {"O": [1, 0]}},
                "guide": {"points": {"O": [0, 0], "A": [0, 2]}},
                "block": {"points": {"E": [0, 0], "P": [3, 4]}},
            },
            "joints": {"rail": {"prismatic": ["guide", "block"], "line": ["A at 0 deg", "E at 0 deg"]}},
            "drives": {
                "motor": {"turns": "guide", "on": "frame", "speed": 1, "start": 0},
                "ram": {"slides": "block", "on": "guide", "position": 1.0},
            },
        }
    )
    assert bound(compiled, "P", {"rail": 7.0}) == pytest.approx(1 + 2 + 7 + 5)
    assert bound(compiled, "P", {}) == math.inf
    assert bound(compiled, "A", {}) == pytest.approx(3)
