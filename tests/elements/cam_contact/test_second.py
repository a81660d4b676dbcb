"""A second contact that holds a cam's follower: against Newton and Euler's equations with the contact that bears, where
the second disc's own profile has it; against the force balance along the lift; against a groove."""

from __future__ import annotations

import cmath
import math
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from helpers.cams import SIGNS, newton_euler, pair, pose
from helpers.compiled import compiled_from
from helpers.differences import derivatives
from linkwright.cam.cams_of_mechanism import disc, frame
from linkwright.cam.contact import ContactPlace
from linkwright.cam.form_closure import conjugate, yoke
from linkwright.cam.loads import FollowerLoads, forces
from linkwright.elements.cam_contact.second import base_circle_position
from linkwright.graph.geometry import Geometry
from linkwright.kernels.parameter_batch import Varied
from linkwright.kernels.tangents import Tangents
from linkwright.model.document import Document
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

    def made(first: Any) -> ContactPlace:
        more = {"between": 0.1, "offset": first.follower.offset + 0.004} if "offset" in dir(first.follower) else {}
        return conjugate(first, **lengths, **more).second

    return data, made


def pressing(c: Any, side: ContactPlace, t: Any, sense: int) -> tuple[Any, Any]:
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


@pytest.mark.parametrize("kind", range(len(KINDS)))
def test_reactions_are_those_of_the_contact_that_bears(kind: int) -> None:
    """Force, torque and all reactions by six equations with the contact whose force comes out positive; proofs hold."""
    guide, touch, how = KINDS[kind]
    side, sense = SIGNS[kind % 4]
    data, other = closed(guide, touch, how, side, sense)
    c, t = compiled_from(data), np.linspace(0.03, 0.87, 12)
    first = disc(c, "rider")
    push = 3.0 + 1j * (-20 + 300 * np.sin(2 * c.evaluate(["motor.angle"], t)[0]))
    one = newton_euler(c, data, t, pressing(c, ContactPlace(first), t, sense), push)
    two = newton_euler(c, data, t, pressing(c, other(first), t, sense), push)
    assert (one[0] * two[0] < 0).all()
    assert 2 <= (two[0] > 0).sum() <= 10
    two[0] *= -1
    wanted = np.where(two[0] < 0, two, one)
    names = ["rider.force", "motor.torque", *(f"force(frame, {n}).{a}" for n in ("disc", "arm") for a in "xy")]
    if guide == "sliding":
        normal = 1j * np.exp(2j) * wanted[4]
        wanted[4:] = normal.real, normal.imag
    assert np.abs(c.evaluate(names, t) - wanted).max() < 1e-10 * np.abs(wanted[0]).max()
    run = Run(compiled_from(closed(guide, touch, how, *SIGNS[3 - kind % 4], inverted=True)[0]), 0.0, TURN, 60)
    assert run.evaluate(["rider.force"], run.t)[0].min() < 0
    assert max(certify(run).residuals.values()) < 1e-12


@pytest.mark.parametrize(("guide", "touch", "how"), [KINDS[1], KINDS[9], KINDS[11]])
def test_both_contacts_bear_as_the_balance_along_the_lift_says(guide: str, touch: str, how: Any) -> None:
    data, other = closed(guide, touch, how, 1, 1)
    del data["loads"], data["gravity"]
    c = compiled_from(data)
    first = disc(c, "rider")
    inertia = 2e-3 + 1.1 * abs(0.04 - 0.01j - OWN) ** 2 if guide == "swinging" else 1.1
    found = forces(first, FollowerLoads(inertia), 7.0, steps=24, second=other(first))
    force = c.evaluate(["rider.force"], np.mod(found.theta - 0.7, 2 * np.pi) / 7.0)[0]
    close = 1e-9 * np.abs(force).max()
    assert np.maximum(force, 0.0) == pytest.approx(found.contact, abs=close)
    assert np.maximum(-force, 0.0) == pytest.approx(found.contact_second, abs=close)
    run = Run(c, 0.0, TURN, 60)
    for place in found.reversals:
        assert np.abs(run.breaks - np.mod(place - 0.7, 2 * np.pi) / 7.0).min() < 1e-9


def test_the_pressure_angle_of_the_second_contact() -> None:
    """That of the second disc, positive as it lifts."""
    for kind, (side, sense) in zip((2, 5, 11), SIGNS[1:], strict=True):
        data, other = closed(*KINDS[kind], side, sense)
        c, t = compiled_from(data), np.linspace(0.0, 0.9, 7)
        look = other(disc(c, "rider")).look(sense * c.evaluate(["motor.angle"], t)[0] + 0.4)
        assert c.evaluate(["rider.pressure_second"], t)[0] == pytest.approx(look.pressure.d[0], abs=1e-10)
    c = compiled_from(pair("sliding", "face"))
    assert "rider.pressure_second" not in {signal.text for signal in c.quantities.signals.all()}


def test_the_motor_feels_no_difference_to_a_groove() -> None:
    """By virtual work, while reactions differ where the second contact bears."""
    t = np.linspace(0.0, TURN, 40)
    names = ["motor.torque", "rider.angle", "rider.force", "force(frame, disc).x", "force(frame, disc).y"]
    data, _ = closed("swinging", "roller", "stated", -1, 1)
    pairs = compiled_from(data).evaluate(names, t)
    data["cams"]["rider"]["closed"] = "groove"
    del data["cams"]["rider"]["second"]
    groove = compiled_from(data).evaluate(names, t)
    assert pairs[:2] == pytest.approx(groove[:2], rel=1e-12, abs=1e-12)
    pulls = groove[2] < 0
    assert pairs[2:, ~pulls] == pytest.approx(groove[2:, ~pulls], rel=1e-12)
    assert (np.abs(pairs[3:, pulls] - groove[3:, pulls]).max(axis=0) > 0.1 * np.abs(groove[2, pulls])).all()


def test_rates_and_derivatives_by_parameters() -> None:
    t = np.array([0.1, 0.33, 0.51, 0.75])
    names = ["rider.force", "motor.torque", "force(frame, disc).y", "rider.pressure_second"]
    given = {"rb": 0.041, "rr": 0.012, "across": 0.09, "tip": 0.03}
    shifts = np.kron(np.eye(4), [-2e-5, -1e-5, 1e-5, 2e-5])
    for kind in (1, 5, 7, 11):
        data, _ = closed(*KINDS[kind], 1, -1)
        data["parameters"] = given
        foot, across = ("S", "across - 0.11") if "guide" in data["joints"] else ("A", "across")
        data["links"]["frame"]["points"][foot][0] = across
        data["links"]["arm"]["points"]["B"][1] = "tip"
        data["cams"]["rider"]["base"] = "rb"
        if "roller" in data["cams"]["rider"]:
            data["cams"]["rider"]["roller"] = "rr"
        c = compiled_from(data)
        force, *_ = values = c.evaluate(names, t)
        assert force.min() < 0 < force.max()
        rates = derivatives(lambda t, c=c: c.evaluate(names, t), t, 2e-4)
        assert np.abs(c.rates(names, t)[1] - rates).max() < 1e-8 * np.abs(rates).max()
        varied = Varied(c, [*given])
        p = varied.parameters(np.array([*given.values()])[:, None] + shifts)
        near = varied.evaluate(names, p, t).reshape(len(names), 4, 4, t.size)
        numeric = np.einsum("nkst,s->nkt", near, np.array([1, -8, 8, -1]) / 12e-5)
        found = Tangents(c, np.eye(len(given))).evaluate(names, t)
        assert found[0] == pytest.approx(values, rel=1e-12)
        assert np.abs(found[1] - numeric).max() < 1e-8 * np.abs(numeric).max()


def test_two_cams_in_one_mechanism() -> None:
    """Coupled by a spring: a swinging arm on two discs, and a ram in a yoke on the same shaft."""
    data, _ = closed("swinging", "roller", {}, 1, 1)
    data["links"]["frame"]["points"]["S"] = [-0.02, -0.05]
    data["links"]["ram"] = {"points": {"F": [0, 0], "H": [0.1, -0.015]}, "mass": 0.7, "shape": "point H"}
    data["joints"]["guide"] = {"prismatic": ["frame", "ram"], "line": ["S at 1.7", "F at 0.1"]}
    data["laws"]["beat"] = data["laws"]["lift"] | {"of": "length", "segments": YOKE}
    data["cams"]["beater"] = {"cam": "disc", "follower": "ram", "on": "frame", "base": 0.03, "law": "beat"}
    data["cams"]["beater"] |= {"closed": "yoke", "roller": 0.01, "at": "H"}
    data["springs"] = {"between": {"from": "T", "to": "H", "stiffness": 900, "free": 0.1}}
    data["loads"]["beat"] = {"on": "ram", "at": "H", "force": [0, "200*sin(3*motor.angle)"]}
    run = Run(compiled_from(data), 0.0, TURN, 60)
    forces = run.evaluate(["rider.force", "beater.force"], run.t)
    assert (forces.min(axis=1) < 0).all()
    assert (forces.max(axis=1) > 0).all()
    assert max(certify(run).residuals.values()) < 1e-12


def test_where_the_second_contact_rests() -> None:
    """On its base circle at the largest lift: that which the file gives, or which follows from the place."""
    for kind in (1, 3, 5, 7, 9):
        guide, touch, how = KINDS[kind]
        data, other = closed(guide, touch, how, -1, 1)
        c = compiled_from(data)
        first = disc(c, "rider")
        drive, total = c.mechanism.followers["rider"], c.motions["lift"].extremes(0)[1].value
        found = base_circle_position(Geometry(c.quantities, c.quantities.parameters), drive, total)
        follower = other(first).disc.follower
        assert found == pytest.approx((follower.start, follower.base), rel=1e-11)
        if isinstance(how, dict) and "base" in how:
            assert follower.base == how["base"]


def test_a_yoke_with_play_is_told() -> None:
    """Of the breadths that the law asks for, by a grid."""
    data, _ = closed("sliding", "face", "yoke", 1, 1)
    data["studies"] = {"cycle": {"period": TURN}}
    assert not lw.run(Document.model_validate(data)).cycle.warnings
    segments = data["laws"]["lift"]["segments"] = [dict(segment) for segment in YOKE]
    segments[2]["over"], segments[3]["dwell"] = 1.5, math.pi - 1.5
    job = lw.run(Document.model_validate(data))
    (warning,) = job.cycle.warnings
    assert (warning.code, warning.path) == ("cam.loose", ("cams", "rider"))
    lift = compiled_from(data).motions["lift"].at(np.linspace(0.0, 2 * np.pi, 20001))
    assert float(warning.data["play"].removesuffix(" m")) == pytest.approx(
        np.ptp(lift[:10001] + lift[10000:]), rel=1e-3
    )
