"""A second contact that holds a cam's follower: against Newton and Euler's equations with the contact that bears, at the
place and with the normal of the second disc's own profile; against the force balance along the lift; grooves."""

from __future__ import annotations

import cmath
import math
from typing import Any

import numpy as np
import pytest

from helpers.cams import SIGNS, newton_euler, pair, pose
from helpers.compiled import compiled_from
from linkwright.cam.closing import conjugate, yoke
from linkwright.cam.contact import Side
from linkwright.cam.pairs import disc, frame
from linkwright.results import Run, certify

TURN = 2 * np.pi / 7
OWN, B = 0.005 + 0.002j, 0.085 + 0.03j
YOKE = [
    {"rise": 0.008, "over": 1.3, "law": "poly_4567"},
    {"dwell": f"{math.pi - 1.3!r}"},
    {"fall": 0.008, "over": 1.3, "law": "poly_4567"},
    {"dwell": f"{math.pi - 1.3!r}"},
]
KINDS = [
    ("swinging", "roller", {}),
    ("swinging", "roller", {"base": 0.036, "roller": 0.01}),
    ("swinging", "roller", "stated"),
    ("swinging", "knife", "stated"),
    ("swinging", "face", {}),
    ("swinging", "face", "stated"),
    ("sliding", "roller", {}),
    ("sliding", "roller", "stated"),
    ("sliding", "knife", {"base": 0.05}),
    ("sliding", "face", {"base": 0.03}),
    ("sliding", "face", "stated"),
    ("sliding", "roller", "yoke"),
    ("sliding", "face", "yoke"),
]


def closed(guide: str, touch: str, how: Any, side: int, sense: int, inverted: bool = False) -> tuple[Any, Any]:
    """A model with a second contact, and a function that gives its second side from the first one's disc."""
    data = pair(guide, touch, side, sense, inverted)
    data["loads"]["push"]["force"] = [3.0, "-20 + 300*sin(2*motor.angle)"]
    cam, points, lengths = data["cams"]["rider"], data["links"]["arm"]["points"], {}
    if how == "yoke":
        data["laws"]["lift"]["segments"] = YOKE
        cam["closed"] = "yoke"
        return data, lambda made: yoke(made).second
    cam |= {"closed": "conjugate", "second": {}}
    if isinstance(how, dict):
        cam["second"] = lengths = how
        if not how:
            del cam["second"]
        return data, lambda made: conjugate(made, **lengths).second
    way = side * cmath.exp(0.7j)
    if touch == "face":
        heading = 0.2 + 1.25 * side if guide == "swinging" else 0.7 - math.pi / 2
        at = OWN + 0.06 * cmath.exp(1j * heading) + 0.004 * side * 1j * cmath.exp(1j * heading)
        at = at if guide == "swinging" else B - 0.085 * way
        cam["second"] = {"face": f"C at {heading!r}"}
        lengths = {"between": 1.25, "face": 0.004} if guide == "swinging" else {"between": 0.085}
    elif guide == "swinging":
        at = OWN + 0.078 * cmath.exp(1j * (cmath.phase(B - OWN) + 1.3 * side))
        cam["second"], lengths = {"at": "C"}, {"between": 1.3, "arm": 0.078}
    else:
        at = B - 0.1 * way - 0.004j * way
        cam["second"] = {"at": "C"}
    points["C"] = [at.real, at.imag]
    if touch == "roller":
        cam["second"]["roller"] = lengths["roller"] = 0.009

    def made(first: Any) -> Side:
        more = {"between": 0.1, "offset": first.follower.offset + 0.004} if "offset" in dir(first.follower) else {}
        return conjugate(first, **lengths, **more).second

    return data, made


def pressing(c: Any, side: Side, t: Any, sense: int) -> tuple[Any, Any]:
    """Place and normal of the contact on some side, in the frame, from the disc's profile."""
    look = side.look(sense * c.evaluate(["motor.angle"], t)[0] + 0.4)
    at, turned = pose(c, "disc", t)
    axes = frame(c, "rider")
    mirror = np.array([[1.0], [-1.0 if side.mirrored else 1.0]])
    place, normal = (
        np.array([np.broadcast_to(p.d[0], t.shape) for p in v]) * mirror for v in (look.pitch, look.normal)
    )
    x, n = axes.placed(place), axes.placed(normal) - axes.placed(np.zeros((2, 1)))
    return at + (x[0] + 1j * x[1]) * turned, (n[0] + 1j * n[1]) * turned


@pytest.mark.parametrize(("guide", "touch", "how"), KINDS)
def test_reactions_are_those_of_the_contact_that_bears(guide: str, touch: str, how: Any) -> None:
    """Force, torque and all reactions by six equations with the contact whose force comes out positive; proofs hold."""
    for (side, sense), inverted in zip(SIGNS, (False, True, True, False), strict=True):
        data, other = closed(guide, touch, how, side, sense)
        c, t = compiled_from(data), np.linspace(0.03, 0.87, 12)
        first = disc(c, "rider")
        push = 3.0 + 1j * (-20 + 300 * np.sin(2 * c.evaluate(["motor.angle"], t)[0]))
        one = newton_euler(c, data, t, pressing(c, Side(first), t, sense), push)
        two = newton_euler(c, data, t, pressing(c, other(first), t, sense), push)
        assert (one[0] * two[0] < 0).all()
        assert 2 <= (two[0] > 0).sum() <= 10
        two[0] *= -1
        wanted = np.where(two[0] < 0, two, one)
        guided = "xy" if guide == "swinging" else ()
        names = ["rider.force", "motor.torque", "force(frame, disc).x", "force(frame, disc).y"]
        names += [f"force(frame, arm).{axis}" for axis in guided]
        reported = c.evaluate(names, t)
        assert np.abs(reported - wanted[: len(names)]).max() < 1e-9 * np.abs(wanted[:4]).max()
        if not guided:
            x, y, ax, ay = c.evaluate([f"force(frame, arm).{axis}" for axis in ("x", "y")] + ["A.x", "A.y"], t)
            assert x + 1j * y == pytest.approx(1j * np.exp(2j) * wanted[4], abs=1e-9 * np.abs(wanted).max())
        run = Run(compiled_from(closed(guide, touch, how, side, sense, inverted)[0]), 0.0, TURN, 60)
        assert max(certify(run).residuals.values()) < 1e-12
        assert run.evaluate(["rider.force"], run.t)[0].min() < 0
