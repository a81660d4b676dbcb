"""Forces through cam pairs: against Newton and Euler's equations of both links, hand formulas, drives instead."""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from helpers.cams import FOLLOWERS, GUIDES, SIGNS, moment, newton_euler, pair, pose
from helpers.compiled import compiled_from
from helpers.differences import derivative
from linkwright.cam.cams_of_mechanism import disc, frame
from linkwright.model.document import Document
from linkwright.results import Run, certify

TURN = 2 * np.pi / 7


def touching(c: Any, data: dict[str, Any], t: Any, sense: int = 1) -> tuple[Any, Any]:
    """Place and common normal of the contact in the frame: of a roller or edge square to the way of its centre past
    the cam, differentiated numerically; of a face where the disc's profile has it."""
    at, turned = pose(c, "disc", t)
    if "face" not in data["cams"]["rider"]:

        def past(t: Any) -> Any:
            (o, e), b = pose(c, "disc", t), c.evaluate(["B.x", "B.y"], t)
            return (b[0] + 1j * b[1] - o) / e

        b, axes = past(t), frame(c, "rider")
        way = derivative(lambda x: past(x).real, t, 2e-4) + 1j * derivative(lambda x: past(x).imag, t, 2e-4)
        normal = 1j * way / np.abs(way)
        outward = ((b - complex(*axes.origin)) / normal).real
        return at + b * turned, normal * turned * np.sign(outward)
    look = disc(c, "rider").look(sense * c.evaluate(["motor.angle"], t)[0] + 0.4)
    axes = frame(c, "rider")
    place, normal = (np.array([np.broadcast_to(p.d[0], t.shape) for p in v]) for v in (look.pitch, look.normal))
    x, n = axes.placed(place), axes.placed(normal) - axes.placed(np.zeros((2, 1)))
    return at + (x[0] + 1j * x[1]) * turned, (n[0] + 1j * n[1]) * turned


@pytest.mark.parametrize("touch", FOLLOWERS)
@pytest.mark.parametrize("guide", GUIDES)
def test_forces_are_those_of_newton_and_euler(guide: str, touch: str) -> None:
    for side, sense in SIGNS:
        data = pair(guide, touch, side, sense)
        c = compiled_from(data)
        t = np.linspace(0.03, 0.87, 5)
        names = ["rider.force", "motor.torque", "force(frame, disc).x", "force(frame, disc).y"]
        reported, wanted = c.evaluate(names, t), newton_euler(c, data, t, touching(c, data, t, sense))[:4]
        assert np.abs(reported - wanted).max() < 1e-8 * np.abs(wanted).max()


@pytest.mark.parametrize("touch", FOLLOWERS)
@pytest.mark.parametrize("guide", GUIDES)
def test_the_proofs_hold_and_power_passes_through(guide: str, touch: str) -> None:
    """Equilibrium of each link by the contact's own place and normal, power, and energy over a turn."""
    for (side, sense), inverted in zip(SIGNS, (False, True, True, False), strict=True):
        run = Run(compiled_from(pair(guide, touch, side, sense, inverted)), 0.0, TURN, 60)
        assert max(certify(run).residuals.values()) < 1e-12


def test_hand_formulas() -> None:
    """A sliding roller follower: F = P / cos(pressure); a flat one F = P; a swinging one F L cos(pressure) = M, P and M
    being what masses and loads ask for along the guide and about the pivot."""
    t = np.linspace(0.0, TURN, 13)
    for guide, touch in (("sliding", "roller"), ("sliding", "face"), ("swinging", "roller")):
        for side, sense in SIGNS:
            c = compiled_from(pair(guide, touch, side, sense))
            names = [
                "rider.force",
                "rider.pressure",
                "com(arm).ax",
                "com(arm).ay",
                "arm.alpha",
                "com(arm).x",
                "com(arm).y",
            ]
            force, pressure, ax, ay, alpha, x, y = c.evaluate(names, t)
            missing = 1.1 * (ax + 1j * ay - (0.4 - 9.81j)) - (3.0 - 20.0j)
            if guide == "sliding":
                wanted = side * (missing * np.exp(-2j)).real
                assert np.abs(force * np.cos(pressure) - wanted).max() < 1e-12 * np.abs(force).max()
                if touch == "face":
                    assert np.abs(pressure).max() < 1e-12
                continue
            tip = c.evaluate(["T.x", "T.y"], t)
            pivot, length = 0.09 + 0.01j, np.hypot(0.08, 0.028)
            turning = moment(x + 1j * y - pivot, 1.1 * (ax + 1j * ay - (0.4 - 9.81j))) + 2e-3 * alpha - 0.3
            turning -= moment(tip[0] + 1j * tip[1] - pivot, 3.0 - 20.0j)
            wanted = -side * turning / length
            assert np.abs(force * np.cos(pressure) - wanted).max() < 1e-12 * np.abs(force).max()


def test_forces_at_rest_and_their_rates() -> None:
    """At standstill the normal is known as well as in motion; rates follow it."""
    for guide, touch in product(GUIDES, ("roller", "face")):
        t = np.array([0.0, 0.5])
        names = ["rider.force", "motor.torque", "rider.pressure"]
        rest, slow = (compiled_from(pair(guide, touch, speed=speed)).evaluate(names, t[:1]) for speed in (0.0, 1e-6))
        assert rest == pytest.approx(slow, rel=1e-9)
        c = compiled_from(pair(guide, touch))
        t = np.array([0.11, 0.6])
        _, rates = c.rates(names, t)
        numeric = derivative(lambda x, c=c, names=names: c.evaluate(names, x), t, 1e-4)
        assert rates == pytest.approx(numeric, rel=1e-7, abs=1e-6)


def linkage(cam: bool) -> dict[str, Any]:
    """A swinging follower that pushes a slider through a coupler; with the cam, or with a drive in its place."""
    data = pair("swinging", "roller")
    data["links"]["frame"]["points"]["G"] = [0.05, 0.14]
    data["links"]["rod"] = {"points": {"T": [0, 0], "D": [0.15, 0]}, "mass": 0.4, "shape": "rod T-D"}
    data["links"]["ram"] = {"points": {"D": [0, 0]}, "mass": 2, "shape": "point D"}
    data["joints"]["rail"] = {"prismatic": ["frame", "ram"], "line": ["G at 0.1", "D at 0"]}
    data["assembly"] = {"D": "ahead of T along rail"}
    data["springs"] = {"back": {"from": "B", "to": "O", "stiffness": 300, "free": 0.01}}
    if not cam:
        away, arm = "hypot(0.08 m, 0.03 m)", "hypot(0.08 m, 0.028 m)"
        start = f"acos(({away}^2 + {arm}^2 - (0.052 m)^2)/(2*{away}*{arm}))"
        offset = "atan2(-0.03 m, -0.08 m) - atan2(0.028 m, 0.08 m)"
        data["drives"]["rider"] = {
            "turns": "arm",
            "on": "frame",
            "position": f"{offset} - {start} - lift(0.7 + 7 rad/s*t)",
        }
        del data["cams"]
    return data


def test_a_cam_in_a_linkage_is_a_drive_in_its_place_but_for_where_the_effort_acts() -> None:
    c, d = compiled_from(linkage(True)), compiled_from(linkage(False))
    t = np.linspace(0.0, TURN, 21)
    alike = [f"D.{a}{x}" for a in ("", "v", "a", "j") for x in "xy"] + [
        "rail.s",
        "force(rod, ram).x",
        "force(frame, ram).normal",
    ]
    assert c.evaluate(alike, t) == pytest.approx(d.evaluate(alike, t), rel=1e-9, abs=1e-9)
    torque, own = d.evaluate(["rider.torque", "motor.torque"], t)
    force, motor, x, y = c.evaluate(["rider.force", "motor.torque", "B.x", "B.y"], t)
    place, normal = touching(c, linkage(True), t)
    at = x + 1j * y
    assert np.abs(at - place).max() < 1e-15
    assert force * moment(at - (0.09 + 0.01j), normal) == pytest.approx(torque, rel=1e-7, abs=1e-7)
    assert motor == pytest.approx(own + force * moment(at - (0.01 - 0.02j), normal), rel=1e-7, abs=1e-7)
    held = ["force(frame, arm).x", "force(frame, arm).y"]
    change = c.evaluate(held, t) - d.evaluate(held, t)
    assert change == pytest.approx(-force * np.array([normal.real, normal.imag]), abs=1e-6)
    assert max(certify(Run(c, 0.0, TURN, 60)).residuals.values()) < 1e-12


def test_a_follower_that_would_have_to_be_pulled_is_told() -> None:
    """Without the load that presses it on, and held by a groove where the file says so."""
    data = linkage(True) | {"studies": {"cycle": {"period": TURN}}}
    assert not lw.run(Document.model_validate(data)).cycle.warnings
    data["loads"]["push"]["force"] = [0, 60]
    (warning,) = lw.run(Document.model_validate(data)).cycle.warnings
    assert (warning.code, warning.path) == ("cam.lifts-off", ("cams", "rider"))
    c = compiled_from(data)
    assert float(warning.data["force"]) == pytest.approx(
        -c.evaluate(["rider.force"], np.linspace(0, TURN, 721)).min(), rel=1e-3
    )
    data["cams"]["rider"]["closed"] = "groove"
    assert not lw.run(Document.model_validate(data)).cycle.warnings
