"""The certificate: sound for every random mechanism, and it catches a report that isn't true."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

import linkwright as lw
from helpers.compiled import compiled_from, compiled_of, regular
from helpers.examples import UNITS, feeder, four_bar, heavy_four_bar, slider_crank
from helpers.random_mechanisms import DURATION, RECIPES, mechanisms
from linkwright.compilation import compile_mechanism
from linkwright.graph.rows import BodyPlace, Named
from linkwright.kernels import Compiled
from linkwright.model.document import load
from linkwright.results import Result
from linkwright.results.certificate import RESIDUALS, Certificate, certify, rank
from linkwright.results.independent_check import Reports
from linkwright.results.margins import Nearest
from linkwright.results.run import Run
from linkwright.studies.cycle.study import unproven
from linkwright.studies.cycle.verification import checks
from linkwright.words import in_language

Array = NDArray[np.float64]
EXAMPLES = Path(__file__).parents[2] / "examples"
SPRUNG = Path(__file__).parents[1] / "model" / "data" / "sprung.yaml"


@pytest.mark.parametrize("recipe", RECIPES)
@settings(max_examples=6)
@given(data=st.data())
def test_random_mechanisms_are_proven(recipe: str, data: Any) -> None:
    """Every residual below 1e-9; mobility by rank, by Gruebler and by the number of drives agree."""
    plain = data.draw(mechanisms(recipe))
    compiled = compiled_of(plain)
    regular(compiled, np.linspace(0.0, DURATION, 9))
    certificate = certify(Run(compiled, 0.0, DURATION, 20))
    assert certificate.closure < 1e-11
    assert certificate.sound(1e-9), certificate.residuals
    assert certificate.mobility == certificate.gruebler == len(plain.drives)
    assert certificate.loops == compiled.structure.topology.loops
    assert certificate.rank == 2 * compiled.structure.topology.joint_count
    assert set(certificate.branches) == {group.label for group in compiled.structure.groups}
    heavy = any(link.mass is not None for link in plain.links.values()) or plain.loads
    assert (certificate.equilibrium is None) == (not heavy)


FOLLOWED = ["cam_linkage", "conjugate_cam", "coupled_cranks", "geneva_drive", "groove_cam", "heat_seal_cam"]


@pytest.mark.parametrize("name", [*FOLLOWED, "welded_bracket"])
def test_a_follower_takes_one_freedom(name: str) -> None:
    """Plate cams, Geneva drives, couplings and welds move by one motor alone, in dwells too."""
    compiled = lw.compile(EXAMPLES / f"{name}.yaml")
    assert compiled.mechanism.followers
    topology = compiled.structure.topology
    constraints = rank(Reports(compiled, np.array([0.0, 0.1137, 0.2719, 0.4131, 0.83])))
    assert 3 * len(topology.moving) - constraints == topology.gruebler == len(compiled.mechanism.drives) == 1


def test_the_feeder_is_proven_over_a_whole_cycle() -> None:
    certificate = certify(Run(compiled_from(feeder()), 0.0, 1.5, 200))
    assert certificate.residuals.keys() == {"closure", "equilibrium", "power", "work", "signals"}
    assert max(certificate.residuals.values()) < 1e-12
    assert (certificate.mobility, certificate.gruebler, certificate.loops, certificate.rank) == (1, 1, 2, 14)
    assert (certificate.poses, certificate.kernel) == (201, "numpy")
    assert certificate.branches["coupler-rocker"] == "C: left of B-D"


def test_nothing_to_balance_without_mass_and_loads() -> None:
    certificate = certify(Run(compiled_from(four_bar()), 0.0, 1.0, 20))
    assert (certificate.equilibrium, certificate.power, certificate.work) == (None, None, None)
    assert list(certificate.residuals) == ["closure", "signals"]


# The nearest singular pose.


def test_nearest_determinant_of_a_four_bar_by_hand() -> None:
    """|sin| of the angle between coupler and rocker: least where the crank lies along the ground."""
    compiled = compiled_from(four_bar(1, 3, 3.2, 4))
    certificate = certify(Run(compiled, 0.0, 2 * np.pi, 30))
    b, c = 3.0, 3.2
    sines = [np.sqrt(1 - ((b * b + c * c - d * d) / (2 * b * c)) ** 2) for d in (3.0, 5.0)]
    assert certificate.nearest is not None
    assert certificate.nearest.group == "coupler-rocker"
    assert certificate.nearest.determinant == pytest.approx(min(sines), rel=1e-12)
    at = {3.0: 2 * np.pi - 0.5, 5.0: np.pi - 0.5}[(3.0, 5.0)[int(np.argmin(sines))]]
    assert certificate.nearest.time == pytest.approx(at, abs=1e-7)


def test_nearest_sees_a_passage_through_a_singular_pose_between_samples() -> None:
    """An elliptic trammel whose two lines become parallel for an instant."""
    data: dict[str, Any] = {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"A": [0, 0], "F": [0, 0]}},
            "crank": {"points": {"A": [0, 0], "B": [0.2, 0.1]}},
            "block": {"points": {"C": [0, 0]}},
            "rail": {"points": {"C": [0, 1], "G": [0, 0]}},
        },
        "joints": {
            "slot": {"prismatic": ["crank", "block"], "line": ["B at 0", "C at 0"]},
            "bed": {"prismatic": ["frame", "rail"], "line": ["F at 0", "G at 0"]},
        },
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": 1, "start": -1}},
    }
    certificate = certify(Run(compiled_from(data), 0.0, 2.0, 7))
    assert certificate.nearest is not None
    assert certificate.nearest.determinant < 1e-9
    assert certificate.nearest.time == pytest.approx(1.0, abs=1e-7)


def test_nearest_sees_the_outer_pins_of_a_lever_and_its_block_meet() -> None:
    """A crank pin passes through the lever's pivot: the lever's angle is undefined there and jumps by 180 deg."""
    data: dict[str, Any] = {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [1, 0]}},
            "crank": {"points": {"A": [0, 0], "B": [1, 0]}},
            "block": {"points": {"B": [0, 0]}},
            "lever": {"points": {"D": [0, 0]}},
        },
        "joints": {"slot": {"prismatic": ["lever", "block"], "line": ["D at 0", "B at 0"]}},
        "assembly": {"B": "ahead of D along slot"},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": 1, "start": -1}},
    }
    compiled = compiled_from(data)
    before, after = compiled.evaluate(["lever.angle"], np.array([1 - 1e-6, 1 + 1e-6]))[0]
    assert abs(after - before) == pytest.approx(np.pi, abs=1e-5)
    certificate = certify(Run(compiled, 0.0, 2.0, 101))
    assert certificate.nearest is not None
    assert certificate.nearest.determinant < 0.01


def test_a_mechanism_without_groups_has_no_nearest() -> None:
    data = {
        "linkwright": 1,
        "units": UNITS,
        "links": {"frame": {"points": {"A": [0, 0]}}, "fan": {"points": {"A": [0, 0], "T": [1, 0]}}},
        "drives": {"motor": {"turns": "fan", "on": "frame", "speed": 5, "start": 0}},
    }
    certificate = certify(Run(compiled_from(data), 0.0, 1.0, 10))
    assert certificate.nearest is None
    assert certificate.branches == {}
    assert (certificate.mobility, certificate.loops) == (1, 0)


# Lies.


def lie(monkeypatch: pytest.MonkeyPatch, row: Named, wrong: Callable[[Array], Array]) -> list[Named]:
    """From now on one row is reported as ``wrong`` makes it. Returns a list that notes each time it happens."""
    honest, told = Compiled.possible_rows, list[Named]()

    def evaluate(compiled: Compiled, names: Any, t: Array, rates: bool = False) -> Array:
        y = honest(compiled, names, t, rates)
        for i, name in enumerate(names):
            if name == row:
                told.append(name)
                y[i] = wrong(y[i])
        return y

    monkeypatch.setattr(Compiled, "possible_rows", evaluate)
    return told


BY = 1e-6
FEEDER_LIES: dict[Named, str] = {
    "force(frame, crank, A).x": "equilibrium",
    "force(coupler, rocker, C).y": "equilibrium",
    "force(rocker, coupler, C).x": "equilibrium",
    "force(guide, slider, slide).x": "equilibrium",
    "force(frame, guide, rail).moment": "equilibrium",
    "com(guide).ax": "equilibrium",
    "com(rocker).ay": "equilibrium",
    "rocker.alpha": "equilibrium",
    "shaking.x": "equilibrium",
    "shaking.moment": "equilibrium",
    "motor.torque": "equilibrium",
    BodyPlace("coupler", "x"): "closure",
    BodyPlace("rocker", "x"): "closure",
    BodyPlace("rocker", "cos"): "closure",
    BodyPlace("guide", "sin"): "closure",
    BodyPlace("slider", "x"): "closure",
    "motor.omega": "power",
    "rocker.omega": "power",
    "E.vx": "power",
    "energy.kinetic": "work",
}
ZERO_ROWS: set[Named] = {BodyPlace("guide", "sin")}
"""Rows that are zero throughout, which no factor makes wrong."""


def residual(certificate: Certificate, name: str) -> float:
    value = getattr(certificate, name)
    assert value is not None
    return float(value)


@pytest.mark.parametrize(("row", "which"), FEEDER_LIES.items())
def test_a_report_a_millionth_wrong_is_caught(row: Named, which: str, monkeypatch: pytest.MonkeyPatch) -> None:
    run = Run(compiled_from(feeder()), 0.0, 1.3, 60)
    honest = residual(certify(run), which)
    nought = row in ZERO_ROWS
    told = lie(monkeypatch, row, lambda y: y + BY if nought else y * (1 + BY))
    certificate = certify(run)
    assert told
    assert honest < 1e-13
    assert residual(certificate, which) > 1e-9
    assert not certificate.sound()


@pytest.mark.parametrize(("row", "which"), [("push.force", "equilibrium"), ("push.v", "power")])
def test_a_sliding_drive_is_audited_too(row: Named, which: str, monkeypatch: pytest.MonkeyPatch) -> None:
    data = slider_crank(gravity=[0, -9.81])
    data["links"]["rod"] |= {"mass": 2, "shape": "rod B-C"}
    data["links"]["crank"] |= {"mass": 1, "shape": "rod A-B"}
    data["drives"] = {"push": {"slides": "piston", "on": "frame", "start": 3.2, "speed": 0.1}}
    data["assembly"] = {"B": "left of A-C"}
    run = Run(compiled_from(data), 0.0, 1.0, 40)
    assert certify(run).sound(1e-12)
    told = lie(monkeypatch, row, lambda y: y * (1 + BY))
    assert residual(certify(run), which) > 1e-9
    assert told


@pytest.mark.parametrize("row", ["force(frame, crank, A).x", BodyPlace("coupler", "x"), "E.vx", "motor.torque"])
def test_a_report_that_is_not_a_number_is_not_sound(row: Named, monkeypatch: pytest.MonkeyPatch) -> None:
    run = Run(compiled_from(feeder()), 0.0, 1.3, 20)
    lie(monkeypatch, row, lambda y: np.nan * y)
    assert not certify(run).sound()


def test_a_wrong_branch_for_an_instant_is_caught(monkeypatch: pytest.MonkeyPatch) -> None:
    """At one pose the reported pose of a link is that of the other assembly mode."""
    compiled = compiled_from(heavy_four_bar())
    other = compiled_from(heavy_four_bar(assembly={"C": "right of B-D"}))
    run = Run(compiled, 0.0, 1.0, 30)
    for row in (BodyPlace("rocker", "cos"), BodyPlace("rocker", "sin")):
        there = other.evaluate([row], run.t)[0]
        lie(monkeypatch, row, lambda y, there=there: np.where(np.arange(y.size) == 15, there[15], y))
    assert certify(run).closure > 0.01


SPRUNG_LIES: dict[Named, str] = {
    "pull.force": "equilibrium",
    "lift.force": "equilibrium",
    "wound.torque": "equilibrium",
    "E.vx": "equilibrium",
    "energy.elastic": "work",
    "motor.omega": "power",
}


@pytest.mark.parametrize(("row", "which"), SPRUNG_LIES.items())
def test_a_lie_about_springs_and_what_loads_follow_is_caught(
    row: Named, which: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = Run(compile_mechanism(load(SPRUNG)), 0.0, 0.8, 60)
    assert residual(certify(run), which) < 1e-12
    told = lie(monkeypatch, row, lambda y: y * (1 + BY))
    assert residual(certify(run), which) > 1e-9
    assert told


def test_powers_that_are_all_round_off_are_no_misfit() -> None:
    """A crank of no length moves nothing: forces of kilonewtons, powers of 1e-12 W."""
    data = slider_crank(r=0, rod=0.14)
    data["links"]["rod"] |= {"mass": 0.6, "shape": "rod B-C"}
    data["joints"]["bore"]["line"] = ["F at -0.6381805223434866", "C at 1.5707963267948966"]
    data["drives"]["motor"] |= {"speed": 314.1592653589793, "start": 0}
    data["loads"] = {"push": {"on": "piston", "at": "C", "along": "bore", "force": "-20 kN*sin(50 rad/s*t)"}}
    certificate = certify(Run(compiled_from(data), 0.0, 0.04, 40))
    assert certificate.sound(1e-9), certificate.residuals


def test_what_newton_solves_is_followed_closely() -> None:
    """Steps and corrections of a higher group's path; a mechanism of dyads has none."""
    from graph.test_higher_groups import triad

    certificate = certify(Run(compiled_from(triad()), 0.0, 3.0, 60))
    ((steps, correction),) = certificate.followed.values()
    assert steps > 5
    assert 0 < correction < 1e-2
    assert certify(Run(compiled_from(four_bar()), 0.0, 1.0, 10)).followed == {}


# One rule: what fails is told in every way.

FAILING: dict[str, dict[str, Any]] = {
    **{name: {name: 1e-3} for name in (*RESIDUALS, "measures")},
    "mobility": {"mobility": 2},
    "nearest": {"nearest": Nearest("coupler-rocker", 1e-8, 0.5)},
    "followed": {"followed": {"coupler-rocker": (12, 0.5)}},
}
"""By check what makes it fail."""


def all_checks() -> Certificate:
    """A certificate for which there is something to check of every kind."""
    whole = certify(Run(compiled_from(feeder()), 0.0, 1.3, 20))
    return replace(whole, starting=0.0, measures=0.0, followed={"coupler-rocker": (12, 1e-4)})


def test_each_check_is_made_to_fail() -> None:
    """Of modes that are kept there is no figure that could fail: a motion ends where a group would leave its mode."""
    certificate = all_checks()
    names = [claim.name for claim in certificate.claims()]
    assert {*names} == {*FAILING, "branches"} and len(names) == len(FAILING) + 1
    assert certificate.sound() and all(check.ok for check in checks(certificate, "1 s"))


@pytest.mark.parametrize("name", FAILING)
@pytest.mark.parametrize("bad", [False, True])
def test_a_check_that_fails_is_an_error_and_not_sound(name: str, bad: bool) -> None:
    """What is shown as a cross is an error among the failures, which exit 1, and :meth:`Certificate.sound` says so;
    residuals that aren't numbers too."""
    (field, value), run = next(iter(FAILING[name].items())), Run(compiled_from(feeder()), 0.0, 1.3, 20)
    if bad and isinstance(value, float):
        value = np.nan
    certificate = replace(all_checks(), **{field: value})
    failed = [check.name.key for check in checks(certificate, "1 s") if not check.ok]  # type: ignore[union-attr]
    assert failed == [f"proof.{name}"]
    assert not certificate.sound() and [*certificate.unproven()] == [name]
    (finding,) = unproven(Result(run, certificate=certificate))
    codes = ("motion.unproven", "motion.check-fails", "motion.unknown-between")
    assert finding.severity == "error" and finding.code in codes
    for language in ("en", "zh"):
        with in_language(language):
            assert "{" not in finding.what and "{" not in finding.mend
