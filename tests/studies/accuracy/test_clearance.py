"""Clearances against a link of the clearance's length, closed forms, statics, and displacements in all directions."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import quad
from scipy.optimize import brentq

from elements.slots import SLOTS, lever
from helpers.compiled import compiled_from
from linkwright.expressions.language import Node, parse
from linkwright.kernels import Compiled
from linkwright.kernels.parameter_batch import Varied
from linkwright.measures import bound_measures, measure_all
from linkwright.model.document import load, plain
from linkwright.results import Run
from linkwright.studies.accuracy.clearance import Plays
from linkwright.studies.accuracy.clearance_figures import play_effects, state_plays, unaffected
from linkwright.studies.accuracy.clearance_options import check_clearances
from linkwright.studies.accuracy.derivatives import Derivatives
from linkwright.studies.accuracy.figures import curves, figures
from linkwright.studies.accuracy.options import AccuracyOptions
from linkwright.studies.accuracy.outcome import AccuracyOutcome
from linkwright.studies.accuracy.signal_sensitivities import Slopes
from linkwright.studies.accuracy.stated_contributors import contributors
from linkwright.studies.batch_plan import Measuring
from studies.models import TURN, four_bar, slider_crank

Array = NDArray[np.float64]
EXAMPLES = Path(__file__).parents[3] / "examples"
PINS = {"A": 0.02, "B": 0.03, "O2": 0.01, "O4": 0.015}
SHIFTS = {name: 1e-3 * c for name, c in PINS.items()}


def options(clearances: Mapping[str, Any], **more: Any) -> AccuracyOptions:
    return AccuracyOptions.model_validate({"clearances": clearances, **more}, context={"cycle": TURN})


def plays(data: Mapping[str, Any], clearances: Mapping[str, Any], **more: Any) -> Plays:
    compiled = compiled_from(data)
    return Plays(compiled, Run(compiled, 0.0, 1.0, 60), options(clearances, **more))


def tree(compiled: Compiled, text: str) -> Node:
    return compiled.quantities.dimensions.bind(parse(text), None)


def massless(data: dict[str, Any], **sections: Any) -> dict[str, Any]:
    """The mechanism without masses, loads and springs."""
    links = {
        name: {key: value for key, value in link.items() if key == "points"} for name, link in data["links"].items()
    }
    left_out = ("loads", "springs", "gravity", "counterweights", "measures", "require", "windows", "studies")
    return {**{key: value for key, value in data.items() if key not in left_out}, "links": links, **sections}


def sliding(**sections: Any) -> dict[str, Any]:
    """The slider-crank with points M behind, and Q off the line of its slider."""
    data = slider_crank(**sections)
    data["links"]["slider"] = {**data["links"]["slider"], "points": {"C": [0, 0], "M": [-25, 0], "Q": [30, 40]}}
    return data


# By virtual work, with the drives held: a gap opened by w in a joint moves a load's point by force . w / load.

THREE = {
    "units": four_bar()["units"],
    "links": {
        "frame": {"points": {"A": [0, 0], "D": [130, 0], "F": [180, -30]}},
        "crank": {"points": {"A": [0, 0], "B": [35, 0]}},
        "coupler": {"points": {"B": [0, 0], "C": [100, 0]}},
        "rocker": {"points": {"D": [0, 0], "C": [80, 0]}},
        "pusher": {"points": {"C": [0, 0], "E": [110, 0], "P": [50, 20]}},
        "arm": {"points": {"F": [0, 0], "E": [70, 0]}},
    },
    "assembly": {"C": "left of B-D", "E": "right of C-F"},
    "drives": four_bar()["drives"],
}
STATICS: dict[str, tuple[dict[str, Any], str, str, dict[str, Any]]] = {
    "four-bar": (four_bar(), "coupler", "P", PINS),
    "slider": (
        sliding(),
        "slider",
        "Q",
        {"A": 0.1, "B": 0.1, "C": 0.1, "guide": {"clearance": 0.1, "length": 60, "centre": "F"}},
    ),
    "three links on a pin": (THREE, "pusher", "P", {"C": 0.1, "E": 0.1, "B": 0.1}),
    "one of them with the pin": (THREE, "pusher", "P", {"C": {"clearance": 0.1, "in": "coupler"}}),
    **{f"a pin in a slot, {slot}": (lever(slot), "lever", "T", {"slot": 0.1, "C": 0.1}) for slot in SLOTS},
    "a cluster": (plain(load(EXAMPLES / "class_four.yaml")), "top", "W", dict.fromkeys("OABCDEPQ", 0.1)),
}


@pytest.mark.parametrize("name", STATICS)
def test_an_output_moves_with_a_gap_as_the_joint_is_loaded_by_it(name: str) -> None:
    data, link, point, clearances = STATICS[name]
    load = {"on": link, "at": point, "force": ["0.6 N", "0.8 N"]}
    found = plays(massless(data, loads={"unit": load}), clearances)
    t = found.run.t
    slope = found.gaps.at([tree(found.compiled, f"0.6*{point}.x + 0.8*{point}.y")], t).slope[0]
    rows = {row: jet.d[0] for row, jet in found.gaps.needed_rows(t).items()}
    forces = np.array([part for one in found.held for seat in one.forces(rows) for part in seat])
    assert np.abs(forces).max() > 0.1
    np.testing.assert_allclose(slope, forces, atol=1e-11 * np.abs(forces).max())
    # So the loaded point gives way in the direction of the load, by all that the joints allow.
    shift, bound = found.curve(tree(found.compiled, f"0.6*{point}.x + 0.8*{point}.y"), t)
    np.testing.assert_allclose(shift, bound, rtol=1e-12)


def test_links_that_go_along_with_their_pin_move_nothing() -> None:
    found = plays(THREE, {"C": 0.1})
    slope = found.gaps.at([tree(found.compiled, "P.x"), tree(found.compiled, "E.y")], found.run.t).slope
    assert [one.links for one in found.held] == [("C", "coupler"), ("C", "rocker"), ("C", "pusher")]
    np.testing.assert_allclose(slope[:, 0::2].sum(axis=1), 0, atol=1e-12)
    np.testing.assert_allclose(slope[:, 1::2].sum(axis=1), 0, atol=1e-12)


# The massless link: the mechanism itself with a link of the clearance's length in a joint, from its first link there to
# its second. What is left of the deviation once the linear one is taken away falls with the square of the clearance.

POSES = np.array([0.03, 0.22, 0.4, 0.61, 0.85])


def gapped(lengths: Mapping[str, str], angles: Mapping[str, str], **sections: Any) -> Compiled:
    """The four-bar with such links in the joints A, B and O4, at angles to the first link of each."""
    data, second, drives = massless(four_bar(), **sections), {"A": "coupler", "B": "rocker", "O4": "rocker"}, {}
    first = {"A": "crank", "B": "coupler", "O4": "frame"}
    for joint, link in second.items():
        points = data["links"][link]["points"]
        points[f"{joint}_"] = points.pop(joint)
        data["links"][f"gap{joint}"] = {"points": {joint: [0, 0], f"{joint}_": [lengths[joint], 0]}}
        drives[f"turn{joint}"] = {"turns": f"gap{joint}", "on": first[joint], "position": angles[joint]}
    return compiled_from({**data, "drives": {**data["drives"], **drives}, "assembly": {"B_": "left of A_-O4_"}})


def falls_with_the_square(left: list[Array], linear: Array) -> None:
    """What is left at a clearance, its half and its quarter."""
    assert np.abs(left[0]).max() < 0.01 * np.abs(linear).max()
    for coarse, fine in pairwise(left):
        np.testing.assert_allclose(fine, coarse / 4, atol=0.01 * np.abs(coarse).max())


def test_joints_rest_as_links_along_their_reactions() -> None:
    signals = ["P.x", "P.y", "rocker.angle"]
    found = plays(four_bar(), {name: PINS[name] for name in ("A", "B", "O4")})
    nominal = found.compiled.evaluate(signals, POSES)
    linear = np.array([found.curve(tree(found.compiled, name), POSES)[0] for name in signals])
    crank, coupler = found.compiled.evaluate(["crank.angle", "coupler.angle"], POSES)
    against = {"A": crank, "B": coupler, "O4": 0 * crank}
    angles = {}
    for one in found.held:
        x, y = found.compiled.evaluate([f"force({one.links[1]}, {one.links[0]}).{axis}" for axis in "xy"], POSES)
        angles[one.joint] = np.arctan2(y, x) - against[one.joint]
    left = []
    for share in (1, 0.5, 0.25):
        lengths = {name: f"{share * c} mm" for name, c in PINS.items()}
        real = [
            gapped(lengths, {j: f"{angle[i]:.17g} rad" for j, angle in angles.items()}).evaluate(
                signals, POSES[i : i + 1]
            )[:, 0]
            for i in range(POSES.size)
        ]
        left.append(np.array(real).T - nominal - share * linear)
    for row, size in enumerate(np.abs(linear).max(axis=1)):
        falls_with_the_square([some[row] for some in left], size)


def test_figures_over_all_directions() -> None:
    """The place of a figure moves with the displacement, which is held for it."""
    measures = {
        "top": {"max": "P.y"},
        "at": {"value": "P.x", "where": "max P.y"},
        "level": {"rms": "P.y"},
        "high": {"mean": "P.x", "window": "up"},
    }
    sections = {"measures": measures, "windows": {"up": {"motor.angle": ["60 deg", "200 deg"]}}}
    found = plays(four_bar(**sections), {"A": 0.05})
    effects, _ = play_effects(found, bound_measures(found.compiled.quantities))
    turned = np.linspace(0, 2 * np.pi, 72, endpoint=False)
    still = {"B": "0 deg", "O4": "0 deg"}
    compiled = gapped(
        {"A": "gap", "B": "0 mm", "O4": "0 mm"},
        {"A": "phi - 360 deg*t/(1 s)", **still},
        **sections,
        parameters={**four_bar()["parameters"], "gap": "0.05 mm", "phi": "0 deg"},
    )
    varied = Varied(compiled, ["gap", "phi"])
    many = Measuring(varied, Run(compiled, 0.0, 1.0, 60))
    shares = (1.0, 0.5, 0.25)
    figures = [
        many.evaluate(varied.parameters(np.stack([0 * turned + share * 5e-5, turned]))).figures for share in shares
    ]
    moved = Derivatives(found.run, found.gaps)
    nominal = {result.name: result.found[0].value for result in measure_all(found.run)[0]}
    for name in measures:
        linear = 5e-5 * moved.of(name)[0].sides[:, 0] @ np.stack([np.cos(turned), np.sin(turned)])
        left = [
            some[name][""].values - nominal[name] - share * linear for some, share in zip(figures, shares, strict=True)
        ]
        falls_with_the_square(left, linear)
        if name in ("top", "at"):  # the directions of means are free at each time
            assert effects[name, ""].bound == pytest.approx(np.abs(linear).max(), rel=2e-3)
        else:
            assert effects[name, ""].bound > np.abs(linear).max()
        assert abs(effects[name, ""].shift) < effects[name, ""].bound


# A slider-crank without masses, a force P on its slider at C: the guide takes N = P tan(beta) across, at C.

PRESS = {"press": {"on": "slider", "at": "C", "along": "guide", "force": "-150 N"}}
R, L, E, ARM, C = 0.05, 0.16, 0.02, 0.025, 3e-5


def across(t: Array | float) -> Any:
    """How far C lies across the line from B to the guide's line (m)."""
    return E - R * np.sin(2 * np.pi * t)


def normal(t: Array | float) -> Any:
    """The force of the slider on the guide (N)."""
    return 150 * across(t) / np.sqrt(L**2 - across(t) ** 2)


@pytest.mark.parametrize(("length", "tilts"), [(60, False), (40, True)])
def test_a_slider_rests_on_one_side_or_tilted(length: float, tilts: bool) -> None:
    guide = {"guide": {"clearance": 0.03, "length": length, "centre": "M"}}
    found = plays(massless(sliding(), loads=PRESS), guide)
    t = found.run.t
    side = np.sign(normal(t))
    # The force acts 25 mm ahead of M, the middle of the guide: within the half of 60 mm, beyond that of 40 mm.
    at_m, tilt = (0 * t, side * 2 * C / 0.04) if tilts else (side * C, 0 * t)
    at_c, slope = at_m + ARM * tilt, -across(t) / np.sqrt(L**2 - across(t) ** 2)
    (joint,) = found.joints()
    np.testing.assert_allclose(joint.shift, [at_m, tilt], atol=1e-15)
    np.testing.assert_allclose(joint.reaction, np.abs(normal(t)) * max(1, 2 * ARM / (1e-3 * length)), rtol=1e-11)
    for text, effect in (("rod.angle", at_c / np.sqrt(L**2 - across(t) ** 2)), ("guide.s", slope * at_c)):
        np.testing.assert_allclose(found.curve(tree(found.compiled, text), t)[0], effect, atol=1e-16)
    shift, bound = found.curve(tree(found.compiled, "Q.y"), t)
    np.testing.assert_allclose(shift, at_c + 0.03 * tilt, atol=1e-16)
    # At worst the slider lies against one side, or in either corner; Q is 55 mm ahead of M.
    np.testing.assert_allclose(bound, max(C, 0.055 * 2 * C / (1e-3 * length)), rtol=1e-12)


def test_contact_is_lost_where_an_end_of_the_guide_is_all_but_unloaded() -> None:
    found = plays(
        massless(sliding(), loads=PRESS), {"guide": {"clearance": 0.03, "length": 60, "centre": "M"}}, contact=0.03
    )
    least = 0.03 * np.sqrt(quad(lambda t: normal(t) ** 2, 0, 1, epsabs=1e-12)[0])
    expected = []
    for zero in (np.arcsin(E / R) / (2 * np.pi), 0.5 - np.arcsin(E / R) / (2 * np.pi)):
        # The end behind takes the share 1/2 - 25/60 of N, the other one more: it is out of contact for a shorter time.
        levels = (-least / (0.5 - ARM / 0.06), least / (0.5 - ARM / 0.06))
        ends = [brentq(lambda t, at=at: normal(t) - at, zero - 0.11, zero + 0.11, xtol=1e-15) for at in levels]
        expected.append(sorted(ends))
    (joint,) = found.joints()
    assert {cause for *_, cause in joint.lost} == {"contact.guide-turned"}
    np.testing.assert_allclose([span[:2] for span in joint.lost], sorted(expected), atol=1e-10)


@pytest.mark.parametrize(
    ("x", "y", "cause", "middles", "half"),
    [
        # |F|^2 = cos^2 + y^2 with the RMS sqrt(1/2 + y^2), of which 0.05 is the limit.
        (
            "cos(motor.angle)*1 N",
            0.01,
            "turned",
            (0.25, 0.75),
            np.arcsin(np.sqrt(0.0025 * 0.5001 - 1e-4)) / (2 * np.pi),
        ),
        ("(1.01 + cos(motor.angle))*1 N", 0, "light", (0.5,), np.arccos(1.01 - 0.05 * np.sqrt(1.5201)) / (2 * np.pi)),
        ("cos(motor.angle)*1 N", 0.2, "", (), 0),
    ],
)
def test_causes_of_lost_contact(x: str, y: float, cause: str, middles: tuple[float, ...], half: float) -> None:
    loads = {"pull": {"on": "crank", "at": "A", "force": [x, f"{y} N"]}}
    (joint,) = plays(massless(four_bar(), loads=loads), {"O2": 0.1}).joints()
    assert [name for *_, name in joint.lost] == [f"contact.pin-{cause}"] * len(middles)
    np.testing.assert_allclose([span[:2] for span in joint.lost], [(m - half, m + half) for m in middles], atol=1e-11)


def test_a_load_that_sets_in_turns_a_joint_over_at_once() -> None:
    loads = {
        "always": {"on": "crank", "at": "A", "force": ["1 N", "0 N"]},
        "sometimes": {"on": "crank", "at": "A", "force": ["-3 N", "0 N"], "window": "half"},
    }
    data = massless(four_bar(), loads=loads, windows={"half": ["0.25 s", "0.5 s"]})
    (joint,) = plays(data, {"O2": 0.1}).joints()
    assert [cause for *_, cause in joint.lost] == ["contact.pin-at-once"] * 2
    np.testing.assert_allclose([span[:2] for span in joint.lost], [[0.25] * 2, [0.5] * 2], atol=1e-7)


def test_measures_add_up_what_the_curve_shows() -> None:
    measures = {
        "stroke": {"span": "P.x"},
        "ends": {"extremes": "P.x"},
        "mean": {"mean": "P.x"},
        "fast": {"max": "P.vx"},
    }
    measures |= {"quiet": {"dwell": "P.x", "within": 1}, "moving": {"mean": "P.x", "window": "right"}}
    found = plays(four_bar(measures=measures, windows={"right": {"P.x": [40, 60]}}), PINS)
    effects, lacking = play_effects(found, bound_measures(found.compiled.quantities))
    assert [*effects] == [("stroke", ""), ("ends", "min"), ("ends", "max"), ("mean", "")]
    assert [*lacking] == ["fast", "quiet", "moving"]
    assert {str(w.data["names"]): w.severity for w in unaffected(lacking | {"slow": lacking["fast"]})} == {
        "fast, slow": "warning",
        "quiet": "warning",
        "moving": "warning",
    }
    low, high, stroke = (effects[key] for key in (("ends", "min"), ("ends", "max"), ("stroke", "")))
    assert stroke.shift == pytest.approx(high.shift - low.shift, rel=1e-12)
    assert stroke.bound == pytest.approx(high.bound + low.bound, rel=1e-12)
    assert sum(stroke.shifts.values()) == pytest.approx(stroke.shift, rel=1e-12)
    places = {result.name: result.found for result in measure_all(found.run)[0]}["ends"]
    for place, effect in zip(places, (low, high), strict=True):
        assert place.time is not None
        shift, _ = found.curve(tree(found.compiled, "P.x"), np.array([place.time]))
        assert shift[0] == pytest.approx(effect.shift, rel=1e-9)
    t = np.linspace(0, 1, 2000, endpoint=False)  # a whole turn: the trapezoidal rule converges at once
    shift, most = found.curve(tree(found.compiled, "P.x"), t).mean(axis=1)
    assert (effects["mean", ""].shift, effects["mean", ""].bound) == pytest.approx((shift, most), rel=1e-6)


def test_no_joint_rests_beyond_the_bound() -> None:
    """The left end of the feeder's stroke is where reactions turn fast, and the place with them."""
    compiled = compiled_from(plain(load(EXAMPLES / "paper_feeder.yaml")))
    found = Plays(compiled, Run(compiled, 0.0, 1.5, 60), options(dict.fromkeys("ABCD", 0.001)))
    effect = play_effects(found, bound_measures(compiled.quantities, ["left_limit_angle"]))[0]["left_limit_angle", ""]
    assert effect.bound > 0
    assert all(abs(shift) <= effect.bounds[name] for name, shift in effect.shifts.items())


def test_an_outcome_is_given_its_plays() -> None:
    measures = {"stroke": {"span": "P.x"}, "ends": {"extremes": "P.x"}, "force": {"max": "force(crank, coupler).x"}}
    compiled = compiled_from(four_bar(measures=measures))
    run, asked = Run(compiled, 0.0, 1.0, 60), options({"A": 0.02}, general="ISO 2768-m")
    deviations = contributors(compiled, asked)
    outcome = AccuracyOutcome(compiled, asked, run, deviations)
    slopes = Slopes(run, deviations.directions)
    outcome.curves = curves(run, slopes, deviations, ["P.y", "P.vy"])
    every = figures(run, slopes, deviations, bound_measures(compiled.quantities))
    state_plays(outcome, asked, bound_measures(compiled.quantities), every)
    assert {name: figure.play is not None for name, figure in every.items()} == {
        "stroke": True,
        "ends min": True,
        "ends max": True,
        "force": False,
    }
    assert outcome.curves["P.y"].play is not None
    assert outcome.curves["P.y"].play.shape == (2, 61)
    assert outcome.curves["P.vy"].play is None
    assert [str(w.data["names"]) for w in outcome.warnings] == ["force, P.vy"]
    assert [joint.joint for joint in outcome.joints] == ["A"]


def test_without_forces_there_is_only_the_bound() -> None:
    found = plays(massless(four_bar()), {"A": 0.02, "B": 0.03})
    assert [(w.code, w.element) for w in found.warnings] == [
        ("clearance.no-force", f"studies.accuracy.clearances.{name}") for name in "AB"
    ]
    shift, bound = found.curve(tree(found.compiled, "P.x"), found.run.t)
    assert not shift.any()
    assert (bound > 1e-6).all()
    assert all(joint.lost == () and not joint.shift.any() for joint in found.joints())


FAULTS: dict[str, tuple[dict[str, Any], list[tuple[str, str]]]] = {
    "unknown": ({"K": 0.1}, [("clearance.no-joint", "K")]),
    "on one link": ({"Q": 0.1}, [("clearance.one-link", "Q")]),
    "zero": ({"B": 0}, [("clearance.not-positive", "B.clearance")]),
    "unit": ({"B": "1 kg"}, [("expression.units-conflict", "B.clearance")]),
    "signal": ({"B": "C.x"}, [("expression.not-constant", "B.clearance")]),
    "no length": ({"guide": 0.1}, [("clearance.no-length", "guide")]),
    "length of a pin": ({"B": {"clearance": 0.1, "length": 3}}, [("clearance.no-key", "B.length")]),
    "pin of a guide": (
        {"guide": {"clearance": 0.1, "length": 60, "in": "slider"}},
        [("clearance.no-key", "guide.in")],
    ),
    "wide guide": ({"guide": {"clearance": 30, "length": 60}}, [("clearance.short-guide", "guide")]),
    "centre elsewhere": (
        {"guide": {"clearance": 0.1, "length": 60, "centre": "B"}},
        [("clearance.centre", "guide.centre")],
    ),
    "pin elsewhere": ({"B": {"clearance": 0.1, "in": "slider"}}, [("clearance.not-on-pin", "B.in")]),
    "larger than the crank": ({"B": 50}, [("clearance.too-large", "B")]),
    "all at once": (
        {"K": 0.1, "B": -1, "guide": {"clearance": 0, "length": 0}},
        [
            ("clearance.no-joint", "K"),
            ("clearance.not-positive", "B.clearance"),
            ("clearance.not-positive", "guide.clearance"),
            ("clearance.not-positive", "guide.length"),
        ],
    ),
    "two kinds": (
        {"guide": 0.1, "B": {"clearance": 0.1, "centre": "C"}},
        [("clearance.no-length", "guide"), ("clearance.no-key", "B.centre")],
    ),
    "sound": ({"A": "r/1000", "B": 0.1, "guide": {"clearance": 0.1, "length": 60, "centre": "F"}}, []),
}


@pytest.mark.parametrize("name", FAULTS)
def test_each_fault_has_its_finding(name: str) -> None:
    clearances, expected = FAULTS[name]
    wrong = list(check_clearances(compiled_from(sliding()), options(clearances).clearances, ()))
    assert [(finding.code, finding.element) for finding in wrong] == expected
    assert all(finding.what and finding.mend for finding in wrong)


# A pin in a slot rests beside its middle: what a slot that lies there does.

BESIDE: dict[str, Callable[[float], dict[str, Any]]] = {
    "straight": lambda off: {"straight": "M at 0 deg"},
    "arc": lambda off: {"arc": {"centre": "M", "radius": 100 - off}},  # to the left is inwards
}


@pytest.mark.parametrize("slot", BESIDE)
@pytest.mark.parametrize("flank", ["both", "left", "right"])
def test_a_pin_rests_on_a_flank_of_its_slot(slot: str, flank: str) -> None:
    clearance, signals = 0.02, ["lever.angle", "T.x"]
    found = plays(lever(slot, flank=flank), {"slot": clearance})
    t = np.array([0.03, 0.22, 0.4, 0.61, 0.85])

    def moved(off: float) -> Array:
        data = lever(slot)
        data["joints"]["slot"] = {"pin_in_slot": ["crank", "lever"], "pin": "B", **BESIDE[slot](off)}
        if slot == "straight":
            data["links"]["lever"]["points"]["M"] = [20, off]
        return compiled_from(data).evaluate(signals, t)

    step = 1e-3
    by = (moved(step) - moved(-step)) / (2 * step)
    (force,) = found.compiled.evaluate(["slot.force"], t)
    # The signal is the force of the slot on the pin, to the left: pushed there the pin lies on the right flank.
    side = {"both": -np.sign(force), "left": 1.0, "right": -1.0}[flank]
    for signal, slope in zip(signals, by, strict=True):
        shift, bound = found.curve(tree(found.compiled, signal), t)
        np.testing.assert_allclose(shift, clearance * side * slope, rtol=1e-7, atol=1e-7 * np.abs(slope).max())
        np.testing.assert_allclose(bound, np.abs(shift), rtol=1e-12)
    (joint,) = found.joints()
    assert joint.links == ("lever", "crank")
    assert joint.shift.shape == (1, 61)
    pressed = joint.reaction > 1e-9 * joint.reaction.max() if flank == "both" else joint.reaction >= 0
    np.testing.assert_allclose(np.abs(joint.shift[0]), 1e-3 * clearance * pressed, rtol=1e-12)
    assert {cause for *_, cause in joint.lost} == {"contact.flank-turned"}


def test_a_flank_needs_no_force_to_be_rested_on() -> None:
    found = plays(massless(lever("straight", flank="left")), {"slot": 0.02})
    assert not found.warnings
    shift, bound = found.curve(tree(found.compiled, "lever.angle"), found.run.t)
    np.testing.assert_allclose(np.abs(shift), bound, rtol=1e-12)
    assert bound.min() > 0
    found = plays(massless(lever("straight")), {"slot": 0.02})
    assert [w.code for w in found.warnings] == ["clearance.no-force"]


def test_a_pin_of_two_names_is_called_after_its_joint() -> None:
    data = four_bar()
    data["links"]["rocker"] = {"points": {"O4": [0, 0], "K": ["c", 0]}}
    data |= {"joints": {"J": {"revolute": ["coupler", "rocker"], "at": ["B", "K"]}}, "assembly": {"J": "left of A-O4"}}
    (finding,) = check_clearances(compiled_from(data), options({"B": 0.1}).clearances, ())
    assert (finding.code, str(finding.data["near"].data["names"])) == ("clearance.no-joint", "J")
    found = plays({**data, "gravity": [0, "-9.8 m/s^2"]}, {"J": 0.1})
    assert found.held[0].links == ("coupler", "rocker")
    assert found.curve(tree(found.compiled, "rocker.angle"), found.run.t)[1].min() > 1e-5
