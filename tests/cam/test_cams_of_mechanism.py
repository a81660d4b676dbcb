"""The disc of a cam pair against the mechanism as it is solved: the follower's contact, seen from the cam's link."""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np
import pytest
import shapely

from helpers.cams import FOLLOWERS, GUIDES, closed_pair, pair
from helpers.compiled import compiled_from
from linkwright.cam.cams_of_mechanism import disc, frame, second
from linkwright.cam.contact import NoContact
from linkwright.cam.followers import NoFollower
from linkwright.graph.rows import BodyPlace

EVERY = [*product(GUIDES, FOLLOWERS, (1, -1), (1, -1))]


def seen(c: Any, t: Any, point: str = "B") -> tuple[Any, Any]:
    """The follower's point in the cam's link, and the direction of its x axis there, as complex numbers."""
    own = f"{point}.x", f"{point}.y"
    rows = (*BodyPlace.all("disc"), *BodyPlace.all("arm"), *own)
    v = c.evaluate(rows, t)
    own = v[2] - 1j * v[3]
    return (v[8] - v[0] + 1j * (v[9] - v[1])) * own, (v[6] + 1j * v[7]) * own


@pytest.mark.parametrize(("guide", "touch", "side", "sense"), EVERY)
def test_the_follower_is_on_the_disc_all_round(guide: str, touch: str, side: int, sense: int) -> None:
    c = compiled_from(pair(guide, touch, side, sense))
    made, axes = disc(c, "rider"), frame(c, "rider")
    t = np.linspace(0.0, 2 * np.pi / 7, 97)
    theta = sense * c.evaluate(["motor.angle"], t)[0] + 0.4
    look = made.look(theta % (2 * np.pi))
    curve = axes.placed(np.array([np.broadcast_to(part.d[0], t.shape) for part in look.pitch]))
    here, turned = seen(c, t)
    size = np.abs(here).max()
    if touch != "face":
        assert np.abs(here - (curve[0] + 1j * curve[1])).max() < 1e-12 * size
        return
    # The face is a line through B that touches the disc's profile.
    heading = turned * np.exp(1j * (0.2 if guide == "swinging" else 0.7 + np.pi / 2))
    away = (curve[0] + 1j * curve[1] - here) / heading
    assert np.abs(away.imag).max() < 1e-12 * size
    normal = np.array([np.broadcast_to(part.d[0], t.shape) for part in look.normal])
    square = axes.placed(normal) - axes.placed(np.zeros((2, 1)))
    assert np.abs(((square[0] + 1j * square[1]) / heading).real).max() < 1e-12
    assert abs(away.real).max() > 1e-3  # it wanders along the face


@pytest.mark.parametrize("touch", FOLLOWERS)
@pytest.mark.parametrize("guide", GUIDES)
def test_pressure_angle_and_lift_are_the_discs(guide: str, touch: str) -> None:
    for side, sense in product((1, -1), (1, -1)):
        c = compiled_from(pair(guide, touch, side, sense))
        t = np.linspace(0.0, 0.9, 41)
        value = "angle" if guide == "swinging" else "s"
        pressure, motor, own = c.evaluate(["rider.pressure", "motor.angle", f"rider.{value}"], t)
        look = disc(c, "rider").look(sense * motor + 0.4)
        assert pressure == pytest.approx(np.broadcast_to(look.pressure.d[0], t.shape), abs=1e-12)
        sign = -side if guide == "swinging" else side
        assert np.ptp(own - sign * look.lift.d[0]) < 1e-14


def test_a_motor_that_turns_the_carrier_on_the_cam_is_the_same() -> None:
    t = np.linspace(0.0, 0.9, 7)
    one, other = (compiled_from(pair("swinging", "roller", sense=-1, inverted=inverted)) for inverted in (False, True))
    names = ["rider.angle", "rider.force", "rider.pressure", "T.ax"]
    assert other.evaluate(names, t) == pytest.approx(one.evaluate(names, t), rel=1e-12)
    assert other.evaluate(["motor.torque"], t) == pytest.approx(-one.evaluate(["motor.torque"], t), rel=1e-11)
    assert disc(other, "rider").sense == disc(one, "rider").sense == -1


def test_a_stated_sense_goes_before_that_of_the_motor() -> None:
    data = pair("swinging", "roller")
    data["cams"]["rider"]["sense"] = "clockwise"
    c = compiled_from(data)
    assert disc(c, "rider").sense == -1


def test_other_parameters_and_those_that_make_no_cam() -> None:
    data = pair("swinging", "roller") | {"parameters": {"rb": 0.04}}
    data["cams"]["rider"]["base"] = "rb"
    c = compiled_from(data)
    assert disc(c, "rider", {"rb": 0.05}).follower.base == 0.05
    with pytest.raises(NoFollower):
        disc(c, "rider", {"rb": 0.5})


def gaps(curve: Any, here: Any, heading: Any, touch: str) -> Any:
    """How far a polygon (2, n) lies from places in its plane, or from lines through these; inside negative."""
    if touch == "face":
        away = (curve[0] + 1j * curve[1])[None, :] - here[:, None]
        across = (away / heading[:, None]).imag
        inward = np.sign(across.mean(axis=1))[:, None]
        return (inward * across).min(axis=1)
    body = shapely.Polygon(curve.T)
    places = shapely.points(here.real, here.imag)
    inside = touch == "roller" and shapely.contains(body, places)
    return shapely.distance(body.exterior, places) * np.where(inside, -1, 1)


@pytest.mark.parametrize(("guide", "touch", "side", "sense"), EVERY)
def test_a_rigid_follower_touches_both_discs_all_round(guide: str, touch: str, side: int, sense: int) -> None:
    """Both of its contacts as the mechanism is solved, seen from the cam's link, against polygons of both profiles."""
    c = compiled_from(closed_pair(guide, touch, side, sense))
    made, axes = second(c, "rider"), frame(c, "rider")
    turn = np.linspace(0.0, 2 * np.pi, 8_000, endpoint=False)
    t = np.linspace(0.0, 2 * np.pi / 7, 31)
    slope = 0.2 if guide == "swinging" else 0.7 + np.pi / 2
    for one, where, point, extra in ((made.first, axes, "B", 0.0), (made.disc, axes.mirrored, "C", 1.2 * side)):
        roller = one.follower.radius
        curve = where.placed(one.look(turn).offset(-roller))
        here, turned = seen(c, t, point)
        heading = turned * np.exp(1j * (slope + (extra if guide == "swinging" else 0.0)))
        gap = gaps(curve, here, heading, touch)
        assert np.abs(gap - roller).max() < 1e-8
    assert made.disc.follower.radius == (0.009 if touch == "roller" else 0.0)
    assert made.disc.follower.base != made.first.follower.base


@pytest.mark.parametrize(("guide", "touch"), [*product(GUIDES, FOLLOWERS)])
def test_a_base_circle_says_where_the_second_contact_is(guide: str, touch: str) -> None:
    """With the base circle that follows from a place, the second disc is on the first one's arm, or of its size."""
    data = closed_pair(guide, touch)
    made = second(compiled_from(data), "rider")
    lengths = vars(made.disc.follower)
    stated = data["cams"]["rider"]["second"]
    data["cams"]["rider"]["second"] = {"base": lengths["base"]} | {k: v for k, v in stated.items() if k == "roller"}
    again = second(compiled_from(data), "rider")
    kept = {k: v for k, v in vars(made.first.follower).items() if k not in ("base", "roller")}
    assert vars(again.disc.follower) == lengths | kept
    del data["cams"]["rider"]["second"]
    bare = second(compiled_from(data), "rider")
    assert vars(bare.disc.follower) == vars(made.first.follower)
    start = bare.first.follower.start
    assert bare.between == pytest.approx(2 * start + bare.total, rel=1e-14)


def test_a_second_contact_that_other_parameters_put_on_the_first_ones_side() -> None:
    data = closed_pair("swinging", "roller")
    x, y = data["links"]["arm"]["points"]["C"]
    data["parameters"] = {"x": x, "y": y}
    data["links"]["arm"]["points"]["C"] = ["x", "y"]
    c = compiled_from(data)
    longer = second(c, "rider", {"x": 1.1 * x - 5e-4, "y": 1.1 * y - 2e-4}).disc.follower
    assert longer.arm == pytest.approx(0.088) and longer.base != second(c, "rider").disc.follower.base
    with pytest.raises(NoContact, match=r"cam\.second-side"):
        second(c, "rider", {"x": 0.1, "y": 0.05})
