"""Derivatives of measures against those of closed forms, taken by mpmath.

The slider-crank's textbook formulas (Norton, *Design of Machinery*, ch. 4, 7, 14; Uicker, Pennock, Shigley) and the
principle of virtual work. Tolerance: 1e-11 of the measure's largest derivative, all numbers being of the order of one.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from mpmath import mp

from helpers.compiled import compiled_from
from helpers.examples import four_bar, slider_crank
from linkwright.kernels.tangents import Tangents
from linkwright.results import Run
from linkwright.studies.accuracy.derivatives import Derivatives
from linkwright.studies.accuracy.signal_sensitivities import Slopes

TOLERANCE = 1e-11
NUMBERS = {"r": 1.0, "b": 3.0, "e": 0.2, "m": 2.0, "w": 1.5, "h": 0.3}
LAST = 2 * np.pi / NUMBERS["w"]
"""The run is a turn."""


def side_lines(r: Any, b: Any, e: Any) -> tuple[Any, Any]:
    """Base of the triangle in the outer and the inner dead centre."""
    return mp.sqrt((b + r) ** 2 - e**2), mp.sqrt((b - r) ** 2 - e**2)


def over(r: Any, w: Any, h: Any) -> Any:
    """Angle of the crank in the run's window."""
    return w * LAST - 2 * mp.pi + 2 * mp.acos(h / r)


OFFSET = {
    "stroke": ({"span": "C.x"}, lambda r, b, e, m, w, h: side_lines(r, b, e)[0] - side_lines(r, b, e)[1]),
    "outer": ({"value": "crank.angle", "where": "max C.x"}, lambda r, b, e, m, w, h: 2 * mp.pi + mp.asin(e / (b + r))),
    "inner": ({"value": "crank.angle", "where": "min C.x"}, lambda r, b, e, m, w, h: mp.pi + mp.asin(e / (b - r))),
    "rod_angle": ({"max": "-rod.angle"}, lambda r, b, e, m, w, h: mp.asin((r - e) / b)),
    # B.x = r cos(0.5 + w t) is over h at both ends of the run, which lasts LAST whatever the speed.
    "mean": (
        {"mean": "B.x", "window": "over"},
        lambda r, b, e, m, w, h: (
            (2 * mp.sqrt(r**2 - h**2) + r * (mp.sin(0.5 + w * LAST) - mp.sin(0.5))) / over(r, w, h)
        ),
    ),
    "way": ({"path": "B", "window": "over"}, lambda r, b, e, m, w, h: r * over(r, w, h)),
    "rms": (
        {"rms": "B.vx"},
        lambda r, b, e, m, w, h: r * w * mp.sqrt(0.5 - (mp.sin(1 + 2 * w * LAST) - mp.sin(1)) / (4 * w * LAST)),
    ),
}
CENTRAL = {
    # Largest acceleration in the outer dead centre: w^2 r (1 + r/b).
    "push": ({"max": "abs(force(rod, piston).x)"}, lambda r, b, e, m, w, h: m * w**2 * r * (1 + r / b)),
    # Extremes asin((r - e)/b) and -asin((r + e)/b): a tie at e = 0.
    "lean": ({"max": "abs(rod.angle)"}, lambda r, b, e, m, w, h: mp.asin((r + abs(e)) / b)),
}


def derivatives(cases: dict[str, Any], **numbers: float) -> Derivatives:
    """Of a slider-crank's measures by r, b, e, m, w, h, over a turn."""
    data: Any = slider_crank("r", "b", "e", parameters=NUMBERS | numbers)  # type: ignore[arg-type]
    data["links"]["piston"] |= {"mass": "m", "shape": "point C"}
    data["drives"]["motor"] |= {"speed": "w"}
    data["windows"] = {"over": {"B.x": ["h", 9]}}
    data["measures"] = {name: measure for name, (measure, _) in cases.items()}
    compiled = compiled_from(data)
    assert compiled.graph.parameters == tuple(NUMBERS)
    run = Run(compiled, 0.0, LAST, 120)
    return Derivatives(run, Slopes(run, np.eye(len(NUMBERS))))


def expected(closed: Callable[..., Any], at: list[float], side: int = 0) -> list[float]:
    """The closed form's partial derivatives."""
    with mp.workdps(30):
        units = np.eye(len(at), dtype=int).tolist()
        return [float(mp.diff(closed, tuple(at), tuple(unit), direction=side)) for unit in units]


@pytest.fixture(scope="module")
def offset() -> Derivatives:
    return derivatives(OFFSET)


@pytest.mark.parametrize("name", OFFSET)
def test_measures_of_an_offset_slider_crank(offset: Derivatives, name: str) -> None:
    (found,) = offset.of(name)
    wanted = expected(OFFSET[name][1], list(NUMBERS.values()))
    assert not found.tie
    np.testing.assert_allclose(found.sides[:, 0], wanted, rtol=0, atol=TOLERANCE * np.abs(wanted).max())


@pytest.mark.parametrize("name", CENTRAL)
def test_measures_of_a_central_slider_crank(name: str) -> None:
    (found,) = derivatives(CENTRAL, e=0.0).of(name)
    at = list((NUMBERS | {"e": 0.0}).values())
    for k, side in enumerate((-1, 1)):
        wanted = expected(CENTRAL[name][1], at, side if name == "lean" else 0)
        np.testing.assert_allclose(found.sides[:, k], wanted, rtol=0, atol=TOLERANCE * np.abs(wanted).max())
    assert found.tie == (name == "lean")


def balancing_torque(l1: Any, l2: Any, l3: Any, l4: Any, phi1: Any, force: Any) -> Any:
    """Of a four-bar with a vertical force on its rocker's end, without masses: M + F dy/dphi1 = 0."""
    way = l4 - l1 * mp.expj(phi1)
    inner = mp.acos((l3**2 + abs(way) ** 2 - l2**2) / (2 * l3 * abs(way)))
    rocker = l3 * mp.expj(mp.arg(-way) - inner)
    coupler = way + rocker
    # The coupler's ends are as fast along it: i l1 e1 . e2 = i l3 e3 . e2 dphi3/dphi1.
    turns = (l1 * mp.expj(phi1) * mp.conj(coupler)).imag / (rocker * mp.conj(coupler)).imag
    return -force * rocker.real * turns


def test_torque_of_a_loaded_four_bar_by_virtual_work() -> None:
    numbers = {"l1": 1.0, "l2": 3.0, "l3": 2.5, "l4": 3.2, "phi1": 0.4, "force": 12.0}
    data: Any = four_bar("l1", "l2", "l3", "l4", parameters=numbers)  # type: ignore[arg-type]
    data["drives"]["motor"]["start"] = "phi1"
    data["loads"] = {"tool": {"on": "rocker", "at": "C", "force": [0, "force"]}}
    t = np.array([0.0, 1.0, 2.2, 4.5])
    values, slopes = Tangents(compiled_from(data), np.eye(6)).evaluate(["motor.torque"], t)
    for k, time in enumerate(t):
        at = [numbers[name] + (time if name == "phi1" else 0) for name in numbers]
        wanted = expected(balancing_torque, at)
        assert values[0, k] == pytest.approx(float(balancing_torque(*at)), rel=1e-13)
        np.testing.assert_allclose(slopes[0, :, k], wanted, rtol=0, atol=TOLERANCE * np.abs(wanted).max())
