"""Every reported signal is checked: some formula covers each, and a fault in any of them is seen."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from helpers.models import EXAMPLES
from helpers.runs import example_run
from linkwright.elements import belt, coupling, differential, friction, gears, pin_in_slot, pitch, rack, rolling, spring
from linkwright.elements.cam_contact import contact as cam_contact
from linkwright.elements.follower import FOLLOWERS
from linkwright.elements.force import FORCES
from linkwright.elements.geneva import contact as geneva_contact
from linkwright.elements.joint import KINDS
from linkwright.graph import power, view
from linkwright.graph.motion import Motion
from linkwright.notation import Pair
from linkwright.results import certify
from linkwright.results.independent_check import Reports
from linkwright.results.signal_check import SignalCheck

Array = NDArray[np.float64]

CYCLES = [path.name for path in EXAMPLES if "\n  cycle:" in path.read_text(encoding="utf-8")]
"""The examples with a motion."""
OF_KINDS = {
    "belt_drive.yaml": "belt",
    "conjugate_cam.yaml": "cam",
    "coupled_cranks.yaml": "coupling",
    "curved_slot.yaml": "pin_in_slot",
    "geared_five_bar.yaml": "gears",
    "geneva_drive.yaml": "geneva",
    "phase_differential.yaml": "differential",
    "rack_and_pinion.yaml": "rack",
    "rolling_wheel.yaml": "rolling",
    "scotch_yoke_friction.yaml": "friction",
    "tailgate.yaml": "spring",
    "welded_bracket.yaml": "weld",
}
"""An example for each kind of element that has signals of its own."""
SEEN = 1e-9
CLOSE = 1e-10


def checked(name: str) -> SignalCheck:
    """The check of an example's cycle."""
    run = example_run(name)
    compiled = run.compiled
    return SignalCheck(run, Reports(compiled, run.t[compiled.passages.bounded(run.t)]))


def test_each_kind_with_signals_has_an_example() -> None:
    """A kind that is added comes with an example, and so meets all tests here."""
    joints = {one.name for one in KINDS.values() if ours(type(one)) and one.entry is not None}
    forces = {one.name for one in FORCES.values() if ours(type(one)) and "signals" in vars(type(one))}
    followers = {one.kind for one in FOLLOWERS.values() if ours(one)}
    assert joints | forces | followers == {*OF_KINDS.values()}


def ours(kind: type) -> bool:
    """Whether a kind isn't another package's."""
    return kind.__module__.startswith("linkwright.")


def with_long(every: list[str], short: list[str]) -> list[object]:
    """All, those beyond the short list only in long runs."""
    return [name if name in short else pytest.param(name, marks=pytest.mark.long) for name in every]


@pytest.mark.parametrize("name", with_long(CYCLES, [*OF_KINDS]))
def test_every_signal_is_covered_and_true(name: str) -> None:
    check = checked(name)
    assert {*check.signals} - check.proven() == set()
    assert max(check.misfits().values()) < CLOSE


FAULTS: dict[str, Callable[[Array, float], Array]] = {
    "a thousandth too large": lambda values, size: values * (1 + 1e-3),
    "of the wrong sign": lambda values, size: -values,
    "shifted": lambda values, size: values + 1e-3 * size,
    "not a number": lambda values, size: values * np.nan,
}


@pytest.mark.parametrize("name", with_long(CYCLES, [*OF_KINDS]))
def test_a_fault_in_any_signal_is_seen(name: str) -> None:
    """Of forces equilibrium proves efforts and what is shaken: those faults are seen by :mod:`.test_certificate`."""
    check, unseen, planted = checked(name), list[tuple[str, str]](), 0
    for signal in check.misfits():
        honest, size = check.values[signal], check.scales[signal]
        for fault, planting in FAULTS.items():
            if not differs(check, signal, planting(honest, size)):
                continue
            check.values[signal] = planting(honest, size)
            misfit = check.misfit(signal)
            if misfit is not None and misfit < SEEN:
                unseen.append((signal, fault))
            planted += 1
        check.values[signal] = honest
    assert unseen == []
    assert planted > len(check.signals)


def differs(check: SignalCheck, signal: str, planted: Array) -> bool:
    """Whether a fault changes a signal by more than round-off (of jerks near a change point) where it has a meaning."""
    with np.errstate(invalid="ignore"):  # of what is infinite
        off = (planted - check.values[signal])[: check.reports.count]
    says = np.ones(off.shape, dtype=bool)
    for formula in check.formulas(check.signals[signal]):
        says &= np.isfinite(formula.value)
        if formula.period:
            off = off - formula.period * np.round(off / formula.period)
    return bool((~(np.abs(off) <= 1e-6 * check.scales[signal]))[says].any())


# Faults in the source: formulas of the program that are wrong by a thousandth, not only what comes out of them.


def larger(honest: Callable[..., Any]) -> Callable[..., Any]:
    """The same with what it returns a thousandth too large; of several numbers the first."""

    def planted(*args: Any, **given: Any) -> Any:
        value = honest(*args, **given)
        if isinstance(value, Pair):
            return Pair(value.x * (1 + 1e-3), value.y)
        return (value[0] * (1 + 1e-3), *value[1:]) if isinstance(value, tuple) else value * (1 + 1e-3)

    return planted


SOURCES: dict[str, tuple[str, Any, str]] = {
    "speed of pitch circles": ("geared_five_bar.yaml", pitch.WheelsKind, "pitch_speed"),
    "force of teeth": ("geared_five_bar.yaml", gears.Gears, "force_signal"),
    "radii of gears": ("geared_five_bar.yaml", gears.Gears, "radii"),
    "line of action": ("geared_five_bar.yaml", gears.GearsEntry, "line_of_action"),
    "speed of a belt": ("belt_drive.yaml", pitch.WheelsKind, "pitch_speed"),
    "strands of a belt": ("belt_drive.yaml", belt.Belt, "force_signal"),
    "sum of both strands": ("belt_drive.yaml", belt.InnerBelt, "carried"),
    "radii of pulleys": ("belt_drive.yaml", belt.BeltEntry, "sizes"),
    "signals of a rack": ("rack_and_pinion.yaml", rack.Rack, "signal"),
    "radius of a pinion": ("rack_and_pinion.yaml", rack.RackEntry, "pitch_radius"),
    "force of a rolling disc": ("rolling_wheel.yaml", rolling.Rolling, "signal"),
    "signals of a slot": ("curved_slot.yaml", pin_in_slot.PinInSlot, "signal"),
    "travel in an arc": ("curved_slot.yaml", pin_in_slot.CircularSlot, "travel"),
    "torque of a differential": ("phase_differential.yaml", differential.Differential, "signal"),
    "lever of friction": ("scotch_yoke_friction.yaml", friction, "_arm"),
    "speed of friction": ("scotch_yoke_friction.yaml", friction, "_speed"),
    "signals of friction": ("scotch_yoke_friction.yaml", friction.Frictions, "signal"),
    "force of a spring": ("tailgate.yaml", spring, "_effort"),
    "energy of a spring": ("tailgate.yaml", spring.Springs, "energy"),
    "length of a spring": ("tailgate.yaml", spring, "_stretch"),
    "law of a cam": ("conjugate_cam.yaml", cam_contact.CamPair, "start"),
    "arm of a Geneva drive": ("geneva_drive.yaml", geneva_contact, "either"),
    "relation of a coupling": ("coupled_cranks.yaml", coupling, "_value"),
    "travel of a slide": ("scotch_yoke.yaml", Motion, "travel"),
    "power of what acts": ("tailgate.yaml", power, "power_of_wrench"),
}
"""By what is wrong the example that has it, and the function of the program."""
SIGNALS = [
    ("link", "omega", "tailgate.yaml"),
    ("link", "jerk", "tailgate.yaml"),
    ("point", "ax", "tailgate.yaml"),
    ("com", "jy", "tailgate.yaml"),
    ("drive", "power", "tailgate.yaml"),
    ("drive", "alpha", "conjugate_cam.yaml"),
    ("drive", "pressure", "conjugate_cam.yaml"),
    ("force", "normal", "scotch_yoke_friction.yaml"),
    ("shaking", "moment", "tailgate.yaml"),
    ("energy", "kinetic", "tailgate.yaml"),
    ("energy", "potential", "tailgate.yaml"),
    ("energy", "elastic", "tailgate.yaml"),
    ("power", "supplied", "tailgate.yaml"),
    ("slide", "a", "rack_and_pinion.yaml"),
]
"""Kinds of elements and attributes whose formula is wrong, and the example that has them."""


@pytest.mark.parametrize("fault", SOURCES)
def test_a_fault_in_the_source_is_seen(fault: str, monkeypatch: pytest.MonkeyPatch) -> None:
    name, owner, function = SOURCES[fault]
    honest = owner.__dict__[function] if isinstance(owner, type) else getattr(owner, function)
    monkeypatch.setattr(
        owner, function, property(larger(honest.fget)) if isinstance(honest, property) else larger(honest)
    )
    assert not certify(example_run(name)).sound()


@pytest.mark.parametrize(("kind", "attribute", "name"), SIGNALS)
def test_a_fault_in_the_formula_of_a_signal_is_seen(
    kind: str, attribute: str, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    honest = view._SIGNALS[kind]

    def planted(of: Any, signal: Any) -> Any:
        value = honest(of, signal)
        return value * (1 + 1e-3) if signal.attribute == attribute else value

    monkeypatch.setitem(view._SIGNALS, kind, planted)
    assert not certify(example_run(name)).sound()
