"""Maps against closed forms, brute force and the mechanism's own kinetostatics."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from helpers.compiled import compiled_from
from helpers.examples import UNITS
from linkwright.expressions import units as u
from linkwright.studies.workspace.curves import curves
from linkwright.studies.workspace.maps import chained
from linkwright.studies.workspace.mesh import DriveBox, mesh
from linkwright.studies.workspace.quality import QualityTask, quality
from linkwright.studies.workspace.sheet import ModeSheet
from studies.workspace.models import arm, five_bar

TURNS = DriveBox((0.0, 0.0), (2 * np.pi, 2 * np.pi), (True, True))
RANDOM = np.random.default_rng(5).uniform([[0.4], [0.2]], [[2.9], [2.7]], (2, 200))


def sheet_of(sign: float = 1.0) -> ModeSheet:
    return ModeSheet(five_bar(1, 1.2, 1.1, 1, 1), "C", ("motor", "servo"), (sign,))


def legs(q: np.ndarray) -> np.ndarray:
    """J of a five-bar with cranks 1, couplers 1.2 and 1.1, base 1: what a coupler's pins share along it, (2, 2, n)."""
    pin1, pin2 = np.stack([np.cos(q[0]), np.sin(q[0])]), np.stack([1 + np.cos(q[1]), np.sin(q[1])])
    base = pin2 - pin1
    d = np.hypot(*base)
    along = (d**2 + 1.2**2 - 1.1**2) / (2 * d)
    aside = np.sqrt(1.2**2 - along**2)
    c = pin1 + (along * base + aside * np.stack([-base[1], base[0]])) / d
    arms = np.stack([c - pin1, c - pin2])
    turned = np.stack([np.stack([-pin1[1], pin1[0]]), np.stack([-pin2[1], pin2[0] - 1])])
    found = np.linalg.solve(
        np.moveaxis(arms, 2, 0), np.eye(2)[None] * np.moveaxis((arms * turned).sum(1), 1, 0)[..., None]
    )
    return np.moveaxis(found, 0, 2)


def inside() -> tuple[np.ndarray, np.ndarray]:
    """Poses well inside the sheet with their J."""
    with np.errstate(invalid="ignore"):
        reach = sheet_of().place(RANDOM)[1]
    q = RANDOM[:, reach > 0.02]
    assert q.shape[1] > 50
    return q, legs(q)


def test_figures_are_those_of_the_couplers_closed_form() -> None:
    q, j = inside()
    task = QualityTask(speeds=(2.0, 3.0), efforts=(4.0, 7.0), force=(1.5, -2.5))
    found = quality(sheet_of(), TURNS, task, steps=4).maps.figures(q)
    by_pose = np.moveaxis(j, 2, 0)
    np.testing.assert_allclose(found["condition"], np.linalg.cond(by_pose), rtol=1e-9)
    np.testing.assert_allclose(found["manipulability"], np.abs(np.linalg.det(by_pose)), rtol=1e-9)
    np.testing.assert_allclose(found["effort motor"], 1.5 * j[0, 0] - 2.5 * j[1, 0], rtol=1e-8, atol=1e-9)
    np.testing.assert_allclose(found["effort servo"], 1.5 * j[0, 1] - 2.5 * j[1, 1], rtol=1e-8, atol=1e-9)
    ways = np.stack([np.cos(angles := np.linspace(0, np.pi, 20001)), np.sin(angles)])
    for k in range(0, q.shape[1], 25):
        most = 1 / np.abs(np.linalg.solve(j[:, :, k], ways) / [[2.0], [3.0]]).max(axis=0)
        assert found["speed"][k] == pytest.approx(most.max(), rel=1e-3)
        assert found["speed any way"][k] == pytest.approx(most.min(), rel=1e-5)
        most = 1 / np.abs(j[:, :, k].T @ ways / [[4.0], [7.0]]).max(axis=0)
        assert found["force"][k] == pytest.approx(most.max(), rel=1e-3)
        assert found["force any way"][k] == pytest.approx(most.min(), rel=1e-5)


def test_jacobian_is_the_change_of_place() -> None:
    q, _ = inside()
    sheet, h = sheet_of(), 1e-6
    step = np.array([[[h], [0]], [[0], [h]]])
    differences = np.stack([(sheet.place(q + s)[0] - sheet.place(q - s)[0]) / (2 * h) for s in step], axis=1)
    np.testing.assert_allclose(sheet.look(q).jacobian, differences, rtol=1e-6, atol=1e-8)


def test_a_size_of_force_alone_counts_in_its_worst_direction() -> None:
    q, j = inside()
    found = quality(sheet_of(), TURNS, QualityTask(force=3.0), steps=4).maps.figures(q)
    np.testing.assert_allclose(found["effort servo"], 3 * np.hypot(j[0, 1], j[1, 1]), rtol=1e-8)


def test_isotropic_pose_of_a_symmetric_five_bar() -> None:
    """On the middle axis J is isotropic where the couplers are square to each other: then so are their velocities, and
    both cranks drive alike. The transmission angle is right there."""
    sheet = ModeSheet(five_bar(1, 1.2, 1.2, 1, 1), "C", ("motor", "servo"), (1.0,))
    angle = np.arccos(0.5 - 1.2 * np.sqrt(0.5))
    found = quality(sheet, TURNS, steps=4).maps.figures(np.array([[angle], [np.pi - angle]]))
    assert found["x"][0] == pytest.approx(0.5)
    assert found["condition"][0] == pytest.approx(1.0, abs=1e-7)
    assert found["transmission"][0] == pytest.approx(np.pi / 2, abs=1e-7)


def test_extremes_and_contours_of_an_arm() -> None:
    """J's determinant is l1 l2 sin(elbow)."""
    made = quality(ModeSheet(arm(0.5, 0.4), "P", ("shoulder", "elbow"), ()), TURNS, steps=30)
    most, least = made.maps.greatest("manipulability"), made.maps.least("manipulability")
    assert most is not None and least is not None
    assert most.value == pytest.approx(0.2, rel=1e-12)
    assert np.abs(np.sin(most.drives[1])) == pytest.approx(1.0, abs=1e-9)
    assert least.value == 0
    endless = made.maps.greatest("condition")
    assert endless is not None and endless.value == np.inf
    assert "transmission" not in made.maps.maps
    lines = made.maps.contour("manipulability", 0.1)
    assert len(lines) == 4  # elbows of 30, 150, 210, 330 deg, over a whole turn of the shoulder
    for line in lines:
        np.testing.assert_allclose(np.abs(np.sin(line.drives[1])), 0.5, atol=1e-12)
        assert np.ptp(line.drives[0]) == pytest.approx(2 * np.pi)
        np.testing.assert_allclose(np.hypot(*line.at) ** 2, 0.41 + 0.4 * np.cos(line.drives[1]), atol=1e-12)
    assert made.maps.contour("manipulability", 0.3) == []


def test_outside_there_is_nothing_and_chains_close() -> None:
    made = quality(sheet_of(), TURNS, steps=40)
    reach = sheet_of().place(np.stack(np.meshgrid(*made.maps.axes, indexing="ij")).reshape(2, -1))[1]
    for one in made.maps.maps.values():
        np.testing.assert_array_equal(np.isnan(one.values).ravel(), reach <= 0)
    assert made.maps.maps["manipulability"].dimension == u.LENGTH.times(u.LENGTH)
    assert chained(np.array([[0, 1], [2, 1], [2, 0], [5, 4], [4, 3]])) == [[5, 4, 3], [0, 1, 2, 0]]


def test_loci_are_named_by_the_determinant_that_vanishes() -> None:
    sheet = sheet_of()
    pieces = curves(sheet, mesh(sheet, TURNS, 24), 1e-3)
    kinds = {one.kind: one for one in quality(sheet, TURNS, steps=4, segments=pieces).loci}
    assert set(kinds) == {"limit-position", "uncertain"}
    q = kinds["limit-position"].drives[:, 0]
    q = q[:, sheet.place(q)[1] > 1e-3]
    assert q.shape[1] > 20
    assert np.abs(np.linalg.det(np.moveaxis(legs(q), 2, 0))).max() < 1e-6  # a crank and its coupler in line
    pin1, pin2 = kinds["uncertain"].drives[:, 0]
    apart = np.hypot(1 + np.cos(pin2) - np.cos(pin1), np.sin(pin2) - np.sin(pin1))
    assert np.minimum(np.abs(apart - 2.3), np.abs(apart - 0.1)).max() < 1e-9  # both couplers in line


@pytest.mark.parametrize("slides", [False, True])
def test_efforts_are_those_of_the_force_solver(slides: bool) -> None:
    """A load at the point and the drives' efforts that the mechanism's kinetostatics give at rest. The point presses
    the work with the opposite of what the load puts on it."""
    servo = {"slides": "fourth", "start": 1.3} if slides else {"turns": "fourth", "start": 0.7}
    data: dict[str, Any] = {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"O": [0, 0], "A": [1, 0]}},
            "crank": {"points": {"O": [0, 0], "B": [0.5, 0]}},
            "second": {"points": {"B": [0, 0], "C": [1.2, 0], "P": [0.3, 0.2]}},
            "third": {"points": {"D": [0, 0], "C": [1.1, 0]}},
            "fourth": {"points": {"D": [0, 0]} if slides else {"A": [0, 0], "D": [0.6, 0]}},
        },
        "joints": {"guide": {"prismatic": ["frame", "fourth"], "line": ["O at 0.4", "D at 0"]}} if slides else {},
        "assembly": {"C": "left of B-D"},
        "drives": {
            "motor": {"turns": "crank", "on": "frame", "speed": 0, "start": 2.0},
            "servo": {**servo, "on": "frame", "speed": 0},
        },
        "loads": {"push": {"on": "second", "at": "P", "force": [3.0, -4.0]}},
    }
    compiled = compiled_from(data)
    exact = compiled.evaluate(["motor.torque", "servo.force" if slides else "servo.torque"], np.zeros(1))[:, 0]
    sheet = ModeSheet(compiled, "P", ("motor", "servo"), (1.0,))
    found = quality(sheet, TURNS, QualityTask(force=(-3.0, 4.0)), steps=4).maps
    here = found.figures(np.array([[2.0], [servo["start"]]]))
    assert np.abs(exact).min() > 0.1
    np.testing.assert_allclose([here[f"effort {name}"][0] for name in sheet.drives], exact, rtol=1e-10)
    assert found.maps["effort servo"].dimension == (u.FORCE if slides else u.TORQUE)
    j = sheet.look(np.array([[2.0], [servo["start"]]])).jacobian[:, :, 0]
    scale = np.diag([1 / 1.2, 1.0]) if slides else np.eye(2)  # one turns and one slides: arcs at the largest link
    assert here["condition"][0] == pytest.approx(np.linalg.cond(j @ scale), rel=1e-9)
