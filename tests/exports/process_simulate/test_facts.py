"""Facts of a hinge against closed forms of its four-bar, energies and sampling."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely

from linkwright.compilation import compile_mechanism, examine
from linkwright.exports.process_simulate.facts import Facts, HingeFacts, check_facts, facts, hand_force, panel_of
from linkwright.kernels import Compiled
from linkwright.kernels.laws import values_at
from linkwright.model.document import Document, load, plain

EXAMPLES = Path(__file__).parents[3] / "examples"
OUTLINE = tuple(f"P{i}" for i in range(1, 9))
OPENING = np.radians(70.0)
G, PUSH, PROGRESSION, SHORT, LONG = 9.80665, 320.0, 1.3, 0.28, 0.5


@pytest.fixture(scope="module")
def hinge() -> Compiled:
    return compile_mechanism(load(EXAMPLES / "bonnet_hinge.yaml"))


@pytest.fixture(scope="module")
def told(hinge: Compiled) -> HingeFacts:
    start = values_at(hinge.laws, 0.0)["hinge"]
    return facts(hinge, Facts(handle="H", outline=OUTLINE), start - OPENING, start)


class FourBar:
    """The hinge by complex numbers, x and z of the vehicle in m, at turns ``phi`` of the rear strut from closed."""

    def __init__(self, phi: Any) -> None:
        at = plain(load(EXAMPLES / "bonnet_hinge.yaml"))["sketch"]
        self.place = {name: complex(x, z) / 1000 for name, (x, _, z) in at.items()}
        a, d, b, c = (self.place[name] for name in "ADBC")
        self.a, self.d, self.b = a, d, a + (b - a) * np.exp(1j * np.asarray(phi))
        reach = np.abs(d - self.b)
        along = (abs(c - b) ** 2 - abs(c - d) ** 2 + reach**2) / (2 * reach)
        side = np.sign(((c - b) * np.conj(d - b)).imag)
        self.c = self.b + (d - self.b) / reach * (along + 1j * side * np.sqrt(abs(c - b) ** 2 - along**2))
        self.turn = np.angle((self.c - self.b) / (c - b))

    def panel(self, point: str) -> Any:
        """A point of the panel."""
        return self.b + (self.place[point] - self.place["B"]) * np.exp(1j * self.turn)

    def energy(self) -> Any:
        """Of weights and gas springs (isothermal: force times the length above a fixed one is constant), in J."""
        dead = (PROGRESSION * SHORT - LONG) / (PROGRESSION - 1)
        height = 16 * self.panel("G") + 0.6 * (self.a + self.b) / 2 + 0.4 * (self.d + self.c) / 2
        length = np.abs(self.panel("S") - self.place["K"])
        return G * height.imag - PUSH * (LONG - dead) * np.log(length - dead)


def test_the_opening_is_that_of_the_coupler(told: HingeFacts) -> None:
    assert told.panel == "panel"
    assert told.value[[0, -1]] == pytest.approx([-OPENING, 0.0])
    assert np.abs(told.opening + FourBar(told.value).turn).max() < 1e-12


def test_the_instant_centre_is_where_the_struts_lines_meet(told: HingeFacts) -> None:
    bar = FourBar(told.value)
    u, v = bar.b - bar.a, bar.c - bar.d
    t = (np.conj(bar.d - bar.a) * v).imag / (np.conj(u) * v).imag
    meet = bar.a + t * u
    assert np.abs(told.pole[0] + 1j * told.pole[1] - meet).max() < 1e-11


def test_the_least_transmission_angle_is_that_of_coupler_and_front_strut(told: HingeFacts) -> None:
    def angle(phi: Any) -> Any:
        bar = FourBar(phi)
        return np.arcsin(np.abs(((bar.c - bar.b) / (bar.c - bar.d)).imag) / np.abs((bar.c - bar.b) / (bar.c - bar.d)))

    phi = np.linspace(-OPENING, 0.0, 100_001)
    (least,) = told.transmission
    assert least.angle == pytest.approx(angle(phi).min(), abs=1e-9)
    assert least.time is not None
    assert angle(least.time) == pytest.approx(least.angle, abs=1e-12)


def test_the_hand_force_is_the_slope_of_the_energy_along_the_path(told: HingeFacts) -> None:
    """Central differences of the energy over the way of the handle; truncation is some 1e-8 of the force."""
    h = 1e-5
    before, after = FourBar(told.value - h), FourBar(told.value + h)
    # The bonnet opens while the drive's value falls.
    force = (before.energy() - after.energy()) / np.abs(before.panel("H") - after.panel("H"))
    assert told.hand is not None
    assert np.abs(told.hand - force).max() < 1e-5
    assert told.hand[-1] > 0 > told.hand[0]


def test_a_cylinder_s_hand_force_is_the_slope_of_the_energy() -> None:
    """A sliding drive: the energy is that of gravity and of the payload."""
    boom = compile_mechanism(load(EXAMPLES / "boom_cylinder.yaml"))
    t, h = np.linspace(-0.1, 0.3, 9), 1e-5
    found = hand_force(boom, "raise", "tip", t)
    ends = []
    for moved in (t - h, t + h):
        potential, x, y = boom.evaluate(["energy.potential", "tip.x", "tip.y"], moved / 0.05)
        ends.append((potential + 15e3 * y, x + 1j * y))
    (before, there), (after, here) = ends
    assert found is not None
    assert np.abs(found - (after - before) / np.abs(here - there)).max() < 1e-3
    assert found.min() > 1e4


def test_the_gas_spring_pushes_by_its_length(told: HingeFacts) -> None:
    bar = FourBar(told.value)
    dead = (PROGRESSION * SHORT - LONG) / (PROGRESSION - 1)
    push = PUSH * (LONG - dead) / (np.abs(bar.panel("S") - bar.place["K"]) - dead)
    assert told.springs["gas"] == pytest.approx(push, rel=1e-12)


def test_the_swept_area_holds_all_poses_and_nothing_else(told: HingeFacts) -> None:
    """Off by the sagitta within a step (1.4e-5 m of the front edge over 180 steps): points of the panel in random poses
    lie in it, and random points of it lie in the panel in some pose."""
    random = np.random.default_rng(5)

    def panels(phi: Any) -> Any:
        bar = FourBar(phi)
        ring = np.array([bar.panel(name) for name in OUTLINE]).T
        return shapely.polygons(np.stack([ring.real, ring.imag], axis=-1))

    sagitta = 2e-5
    assert shapely.covers(shapely.buffer(told.swept, sagitta), panels(random.uniform(-OPENING, 0.0, 400))).all()
    x0, y0, x1, y1 = told.swept.bounds
    spots = shapely.points(random.uniform([x0, y0], [x1, y1], (600, 2)))
    inside = spots[shapely.contains(told.swept, spots)]
    tree = shapely.STRtree(panels(np.linspace(-OPENING, 0.0, 3001)))
    _, distance = tree.query_nearest(inside, return_distance=True, all_matches=False)
    assert inside.size > 150
    assert distance.max() < 2.5e-4  # half a step of the samples


def test_another_zero_pose_shifts_what_is_told(hinge: Compiled, told: HingeFacts) -> None:
    start = values_at(hinge.laws, 0.0)["hinge"]
    open_first = facts(hinge, Facts(handle="H"), start - OPENING, start, zero=start - OPENING)
    assert open_first.value == pytest.approx(told.value + OPENING, abs=1e-12)
    assert open_first.opening == pytest.approx(told.opening[0] - told.opening, abs=1e-12)
    assert told.hand is not None
    assert open_first.hand == pytest.approx(-told.hand, rel=1e-9)
    (least,), (same,) = open_first.transmission, told.transmission
    assert least.time == pytest.approx((same.time or 0.0) + OPENING)


def test_facts_as_plain_data(told: HingeFacts) -> None:
    data = json.loads(json.dumps(told.as_dict(), allow_nan=False))
    assert data["opening"]["max"] == pytest.approx(51.176, abs=1e-3)
    assert data["hand"]["max_at"] == pytest.approx(0.0, abs=1e-9)
    bar = FourBar(np.linspace(-OPENING, 0.0, 20_001))
    corners = 1000 * np.array([bar.panel(name) for name in OUTLINE])
    bounds = [corners.real.min(), corners.imag.min(), corners.real.max(), corners.imag.max()]
    assert data["swept"]["bounds"] == pytest.approx(bounds, abs=0.02)  # the sagitta of a step


def test_no_part_of_a_cylinder_is_the_panel() -> None:
    assert panel_of(compile_mechanism(load(EXAMPLES / "boom_cylinder.yaml")), Facts()) == "boom"


def changed(name: str = "bonnet_hinge", **sections: Any) -> Compiled:
    compiled, findings = examine(Document.model_validate({**plain(load(EXAMPLES / f"{name}.yaml")), **sections}))
    assert compiled is not None, findings
    return compiled


def test_no_forces_and_forces_in_time_have_no_hand_force(hinge: Compiled) -> None:
    still = changed("four_bar", measures={}, require={}, studies={}, loads={}, gravity=None)
    assert hand_force(still, next(iter(still.mechanism.drives)), "C", np.zeros(1)) is None
    wind = {"wind": {"on": "panel", "at": "H", "force": ["10 N*t/(1 s)", 0]}}
    assert hand_force(changed(loads=wind), "hinge", "H", np.zeros(1)) is None


@pytest.mark.parametrize(
    ("options", "code", "key"),
    [
        ({"panel": "pannel"}, "name.unknown", "panel"),
        ({"handle": "HH"}, "name.unknown", "handle"),
        ({"handle": "K"}, "export.handle", "handle"),
        ({"panel": "panel", "outline": ["A", "P1", "P2"]}, "name.unknown-point", "outline"),
        ({"outline": ["P1", "P2"]}, "export.outline", "outline"),
        ({"outline": ["P1", "P5", "P2", "P6"]}, "export.outline", "outline"),
    ],
)
def test_wrong_options_are_told(hinge: Compiled, options: dict[str, Any], code: str, key: str) -> None:
    found = check_facts(hinge, Facts(**options), ("exports", "process-simulate", "sheet"))
    assert [(finding.code, finding.path[-1]) for finding in found] == [(code, key)]
    assert all(finding.what and finding.mend for finding in found)
