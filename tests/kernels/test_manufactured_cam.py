"""Followers on cams that are cut already: against the follower rolled over the given contour, and differences."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from helpers.cams import pair
from helpers.compiled import compiled_from
from helpers.differences import OFFSETS, WEIGHTS
from linkwright.cam.cams_of_mechanism import disc, frame
from linkwright.cam.disc import Disc
from linkwright.cam.rolling import rolled
from linkwright.elements.cam_contact import cam_followers
from linkwright.elements.cam_contact.contact import base_circle_turns, seat
from linkwright.graph.geometry import Geometry
from linkwright.kernels import manufactured_cam as cut_module
from linkwright.kernels.manufactured_cam import with_cut_cams
from linkwright.kernels.parameter_batch import Varied
from linkwright.kernels.tangents import Tangents

CASES = [
    ("swinging", "roller"),
    ("swinging", "knife"),
    ("swinging", "face"),
    ("sliding", "roller"),
    ("sliding", "face"),
]
NAMES = ["ax", "bx", "by", "rr", "rb", "sy", "ph"]
T = np.linspace(0.02, 0.85, 9)


def mechanism(guide: str, touch: str, side: int = 1, sense: int = 1) -> dict[str, Any]:
    """A pair whose centre distance, arm, roller, base circle, guide and phase are parameters."""
    data = pair(guide, touch, side, sense)
    data["parameters"] = {"ax": 0.09, "bx": 0.085, "by": 0.03, "rr": 0.012, "rb": 0.04, "sy": -0.05, "ph": 0.4}
    data["links"]["arm"]["points"]["B"] = ["bx", "by"]
    data["links"]["frame"]["points"]["S"] = [-0.02, "sy"]
    if guide == "swinging":
        data["links"]["frame"]["points"]["A"] = ["ax", 0.01]
    cam = data["cams"]["rider"]
    cam |= {"base": "rb", "phase": "ph"}
    if touch == "roller":
        cam["roller"] = "rr"
    return data


def lifts(c: Any, value: str, side: int, values: Any) -> Any:
    """The follower's lift over time from its value, of other parameters: what it is above its own start."""
    drive = cam_followers(c.mechanism)["rider"]
    nominal = c.quantities.parameters
    here = seat(Geometry(c.quantities, nominal | values), drive)
    found = Varied(with_cut_cams(c), tuple(values))
    p = found.parameters(np.array([[v] for v in values.values()]))
    y = found.evaluate([f"rider.{value}"], p, T)[0, 0]
    return here.sign * (y + base_circle_turns(Geometry(c.quantities, nominal), drive) - here.offset) - here.start


@pytest.mark.parametrize(("guide", "touch"), [("swinging", "roller"), ("swinging", "face"), ("sliding", "roller")])
def test_it_is_the_follower_rolled_over_the_contour(guide: str, touch: str) -> None:
    """Tenths of a millimetre off: exact, not to first order. The contour has 200000 points."""
    for side, sense in ((1, 1), (-1, 1)):
        c = compiled_from(mechanism(guide, touch, side, sense))
        plan = disc(c, "rider")
        radius = 0.012 if touch == "roller" else 0.0
        contour = plan.look(np.linspace(0, 2 * np.pi, 200_001)[:-1]).offset(-radius)
        changes = {"bx": 0.0853, "by": 0.0296, **({"ax": 0.0904} if guide == "swinging" else {"sy": -0.0503})}
        changes |= {"rr": 0.0122} if touch == "roller" else {}
        made = disc(c, "rider", c.quantities.parameters | changes)
        theta = sense * (0.3 + sense * 7 * T) + 0.4
        if guide == "swinging":  # the line of centres turns with the pivot, the cam's link doesn't
            theta = theta - sense * (np.arctan2(0.03, changes["ax"] - 0.01) - np.arctan2(0.03, 0.08))
        wanted = rolled(Disc(made.follower, plan.lift, plan.sense, plan.joins), contour, theta % (2 * np.pi))
        found = lifts(c, "angle" if guide == "swinging" else "s", side, changes)
        assert np.abs(wanted - c.motions["lift"].at(theta)).max() > 1e-5
        assert np.abs(found - wanted).max() < 1e-8


@pytest.mark.parametrize(("guide", "touch"), CASES)
def test_its_derivatives_are_those_of_its_values(guide: str, touch: str) -> None:
    """By each parameter, of the follower's motion and of the forces through it, at any time; nominal values stay."""
    c = compiled_from(mechanism(guide, touch))
    made = with_cut_cams(c)
    value, rate = ("angle", "alpha") if guide == "swinging" else ("s", "a")
    signals = [f"rider.{value}", f"rider.{rate}", "rider.force", "motor.torque"]
    assert made.evaluate(signals, T) == pytest.approx(c.evaluate(signals, T), rel=1e-11, abs=1e-11)
    size = len(c.graph.parameters)
    names = [name for name in NAMES if name in c.graph.parameters]
    directions = np.eye(size)
    _, slopes = Tangents(made, directions).evaluate(signals, T)
    nominal, step = np.array([c.quantities.parameters[name] for name in names]), 2e-5
    aside = (np.eye(len(names))[:, :, None] * OFFSETS * step).reshape(len(names), -1)
    varied = Varied(made, names)
    moved = varied.evaluate(signals, varied.parameters(nominal[:, None] + aside), T)
    numeric = np.einsum("spot,o->spt", moved.reshape(len(signals), len(names), OFFSETS.size, T.size), WEIGHTS) / step
    exact = slopes[:, [c.graph.parameters.index(name) for name in names]]
    scale = np.abs(numeric).max(axis=2) + np.abs(c.evaluate(signals, T)).max(axis=1, keepdims=True)
    assert (np.abs(exact - numeric).max(axis=2) / scale).max() < 1e-6


def test_its_steps_are_enough(monkeypatch: pytest.MonkeyPatch) -> None:
    """Three tenths of a millimetre off; twice the steps, all in all derivatives, give the same."""
    found = []
    for orders in (cut_module.ORDERS, (3,) * 10):
        monkeypatch.setattr(cut_module, "ORDERS", orders)
        made = Varied(with_cut_cams(compiled_from(mechanism("swinging", "roller"))), ("ax", "rr"))
        p = made.parameters(np.array([[0.0903], [0.0123]]))
        found.append(made.evaluate(["rider.angle", "rider.alpha", "rider.jerk"], p, T))
    assert found[0] == pytest.approx(found[1], rel=1e-10, abs=1e-12)


def test_a_wider_roller_lifts_along_the_common_normal() -> None:
    """To first order n . dC = dr: the lift grows by dr over the arm's part along the normal."""
    c = compiled_from(mechanism("swinging", "roller"))
    pressure = c.evaluate(["rider.pressure"], T)[0]
    k = c.graph.parameters.index("rr")
    _, slopes = Tangents(with_cut_cams(c), np.eye(len(c.graph.parameters))[:, [k]]).evaluate(["rider.angle"], T)
    assert slopes[0, 0] == pytest.approx(-1 / (np.hypot(0.08, 0.028) * np.cos(pressure)), rel=1e-10)


def test_a_face_out_of_square_rests_on_the_profile() -> None:
    """A hundredth of a radian: all points of the contour lie below the face, and one of them on it."""
    data = mechanism("sliding", "face")
    data["parameters"]["fa"] = 0.7 + np.pi / 2
    data["cams"]["rider"]["face"] = "B at fa"
    c = compiled_from(data)
    varied = Varied(with_cut_cams(c), ("fa",))
    (found,) = varied.evaluate(["rider.s"], varied.parameters(np.array([[0.71 + np.pi / 2]])), T)[0]
    made, axes = disc(c, "rider"), frame(c, "rider")
    profile = axes.placed(made.look(np.linspace(0, 2 * np.pi, 100_001)).offset(0.0))
    spots = (profile[0] + 1j * profile[1] - (0.004 + 0.003j))[:, None] * np.exp(1j * (0.3 + 7 * T)) + (0.01 - 0.02j)
    at = np.exp(2.0j) * found + (-0.02 - 0.05j) + (0.08 + 0.028j) * np.exp(1.3j)  # the face's point
    above = ((spots - at) * np.exp(-2.01j)).real.max(axis=0)
    assert np.abs(above).max() < 1e-9
