"""Springs, dampers and counterweights against closed forms; tolerances are a few times the round-off."""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np
import pytest

from helpers.compiled import compiled_from
from helpers.examples import UNITS
from linkwright.results import Run, certify

T = np.linspace(0.0, 1.9, 41)


def block(law: str, **sections: Any) -> dict[str, Any]:
    """A block of 2 kg on a level rail, its place a law of time (m)."""
    return {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"O": [0, 0]}},
            "block": {"points": {"P": [0, 0]}, "mass": 2, "shape": "point P"},
        },
        "joints": {"rail": {"prismatic": ["frame", "block"], "line": ["O at 0", "P at 0"]}},
        "drives": {"push": {"slides": "block", "on": "frame", "position": law}},
    } | sections


def lever(**sections: Any) -> dict[str, Any]:
    """A lever of 3 kg turning about A at 1 rad/s, its centre of mass 0.4 m out; a post 0.5 m above A."""
    return {
        "linkwright": 1,
        "units": UNITS,
        "gravity": [0, -9.81],
        "links": {
            "frame": {"points": {"A": [0, 0], "K": [0, 0.5]}},
            "lever": {"points": {"A": [0, 0], "E": [0.3, 0]}, "mass": 3, "com": [0.4, 0], "inertia": 0.2},
        },
        "drives": {"motor": {"turns": "lever", "on": "frame", "speed": 1, "start": 0.1}},
    } | sections


def test_a_mass_on_a_spring_and_damper_driven_harmonically() -> None:
    """F = (k - m w^2) X sin wt + c w X cos wt: S. S. Rao, Mechanical Vibrations, ch. 3; at resonance c alone."""
    k, c, x = 50.0, 7.0, 0.2
    for w in (3.0, 5.0, 11.0):
        springs = {"s": {"from": "O", "to": "P", "stiffness": k, "free": 1.0, "damping": c}}
        law = f"1 + {x}*sin(({w} rad/s)*t)"
        (force, length, energy) = compiled_from(block(law, springs=springs)).evaluate(
            ["push.force", "s.length", "s.energy"], T
        )
        s = x * np.sin(w * T)
        assert force == pytest.approx((k - 2 * w**2) * s + c * w * x * np.cos(w * T), abs=1e-12)
        assert length == pytest.approx(1 + s, abs=1e-15)
        assert energy == pytest.approx(k / 2 * s**2, abs=1e-14)


def test_a_damper_dissipates_pi_c_w_x_squared_a_cycle() -> None:
    """S. S. Rao, Mechanical Vibrations, sec. 2.6 (energy dissipated in viscous damping)."""
    c, x, w = 7.0, 0.2, 2 * np.pi
    data = block(f"1 + {x}*sin(({w!r} rad/s)*t)", springs={"d": {"from": "O", "to": "P", "damping": c}})
    data["measures"] = {"mean": {"mean": "push.power"}, "damper": {"mean": "d.power"}}
    from linkwright.measures import measure_all

    measures, _ = measure_all(Run(compiled_from(data), 0.0, 1.0, 20))
    work = np.pi * c * w * x**2
    assert [m.found[0].value for m in measures] == pytest.approx([work, -work], rel=1e-12)


def test_a_zero_free_length_spring_balances_a_lever_at_all_angles() -> None:
    """k h a = m g r: J. L. Herder, Energy-free Systems, Delft 2001, ch. 1; no torque beside none of inertia."""
    k = 3 * 9.81 * 0.4 / (0.5 * 0.3)
    compiled = compiled_from(lever(springs={"s": {"from": "K", "to": "E", "stiffness": k, "free": 0}}))
    t = np.linspace(0.0, 2 * np.pi, 73)
    torque, potential, elastic = compiled.evaluate(["motor.torque", "energy.potential", "energy.elastic"], t)
    assert np.abs(torque).max() < 1e-13 * 3 * 9.81 * 0.4
    assert np.ptp(potential + elastic) < 1e-13 * np.ptp(potential)
    assert certify(Run(compiled, 0.0, 6.0, 40)).sound(1e-9)


def test_a_counterweight_balances_a_lever_and_its_bearing() -> None:
    weights = {"w": {"on": "lever", "mass": 4, "at": "0.3 at 3.141592653589793"}}
    compiled = compiled_from(lever(counterweights=weights))
    t = np.linspace(0.0, 6.0, 31)
    names = ["motor.torque", "com(lever).x", "com(lever).y", "force(frame, lever).x", "force(frame, lever).y"]
    torque, x, y, fx, fy = compiled.evaluate(names, t)
    assert np.abs([torque, x, y, fx]).max() < 1e-13
    assert fy == pytest.approx(7 * 9.81, rel=1e-14)
    assert certify(Run(compiled, 0.0, 6.0, 40)).sound(1e-9)


def test_counterweights_add_by_parallel_axes() -> None:
    """The same as one link with the sums put in by hand, on a link with and without mass of its own."""
    weights = {
        "a": {"on": "lever", "mass": 2, "at": [-0.1, 0.2], "inertia": 0.05},
        "b": {"on": "lever", "mass": 1, "at": "E"},
    }
    own = lever()["links"]["lever"]
    for bare in (False, True):
        parts = [(2, np.array([-0.1, 0.2]), 0.05), (1, np.array([0.3, 0.0]), 0.0)]
        parts += [] if bare else [(3, np.array([0.4, 0.0]), 0.2)]
        mass = sum(m for m, _, _ in parts)
        centre = sum(m * c for m, c, _ in parts) / mass
        inertia = sum(i + m * float((c - centre) @ (c - centre)) for m, c, i in parts)
        links = lever()["links"]
        one = {**links, "lever": own | {"mass": mass, "com": [*map(float, centre)], "inertia": float(inertia)}}
        two = {**links, "lever": {"points": own["points"]} if bare else own}
        drive = {"motor": {"turns": "lever", "on": "frame", "position": "sin((2 rad/s)*t)"}}
        names = ["motor.torque", "force(frame, lever).x", "energy.kinetic", "energy.potential", "com(lever).ay"]
        found = compiled_from(lever(links=two, counterweights=weights, drives=drive)).evaluate(names, T)
        assert found == pytest.approx(compiled_from(lever(links=one, drives=drive)).evaluate(names, T), rel=1e-12)


@pytest.mark.parametrize("n", [1.0, 1.25, 1.4])
def test_a_gas_spring_keeps_p_times_v_to_the_n(n: float) -> None:
    """Both stated forces; p V^n constant between (volumes from the two ends); energy by quadrature in 30 digits."""
    push, r, low, high = 400.0, 1.35, 0.21, 0.36
    entry = {"from": "O", "to": "P", "gas": push, "progression": r, "length": [low, high], "exponent": n}
    compiled = compiled_from(block("0.36 - 0.15*t/(2 s)", springs={"g": entry}))
    t = np.array([0.0, 0.5, 1.3, 2.0])
    force, energy, length = compiled.evaluate(["g.force", "g.energy", "g.length"], t)
    assert force[[0, -1]] == pytest.approx([-push, -push * r], rel=1e-14)
    column = (high - low) / (1 - r ** (-1 / n))
    volume = column - (high - length)
    assert -force * volume**n == pytest.approx(np.full(4, push * column**n), rel=1e-13)
    for x, e in zip(length, energy, strict=True):
        with mpmath.workdps(30):
            stored = mpmath.quad(lambda z: push * (column / (column - (high - z))) ** n, [x, high])
        assert e == pytest.approx(float(stored), rel=1e-12, abs=1e-13)


@pytest.mark.parametrize("between", ["linear", "cubic"])
def test_a_table_spring_stores_the_exact_integral(between: str) -> None:
    table = {"points": [["0.1 m", "-5 N"], ["0.4 m", "10 N"], ["0.9 m", "12 N"], ["1.5 m", "40 N"]], "between": between}
    springs = {"s": {"from": "O", "to": "P", "force": "curve"}}
    data = block("0.8 + 0.6*sin((3 rad/s)*t)", springs=springs, tables={"curve": table})
    compiled = compiled_from(data)
    # The integral by quadrature of the reported force over the reported length, between the table's points.
    nodes, weights = np.polynomial.legendre.leggauss(8)
    for t in (0.2, 0.7, 1.5):
        end = float(compiled.evaluate(["s.length"], np.array([t]))[0, 0])
        edges = np.array([0.1, *[x for x in (0.4, 0.9) if x < end], end])
        x = ((edges[1:] + edges[:-1])[:, None] + np.diff(edges)[:, None] * nodes).ravel() / 2
        at = block("0.1 + t*(1 m/s)", springs=springs, tables={"curve": table})
        (force,) = compiled_from(at).evaluate(["s.force"], x - 0.1)
        total = float(force @ (np.diff(edges)[:, None] * weights / 2).ravel())
        assert compiled.evaluate(["s.energy"], np.array([t]))[0, 0] == pytest.approx(total, rel=1e-12)
    assert certify(Run(compiled, 0.0, 1.9, 30)).sound(1e-10)


def test_a_clock_spring_is_wound_up_over_two_turns() -> None:
    springs = {"c": {"turns": "lever", "on": "frame", "stiffness": 0.5, "free": 0.1, "damping": 0.2, "preload": 1}}
    data = lever(springs=springs)
    del data["gravity"]
    t = np.linspace(0.0, 4 * np.pi, 50)
    torque, angle, energy, power = compiled_from(data).evaluate(["motor.torque", "c.angle", "c.energy", "c.power"], t)
    assert angle == pytest.approx(0.1 + t, abs=1e-12)
    assert torque == pytest.approx(1 + 0.5 * t + 0.2, abs=1e-12)
    assert energy == pytest.approx(t + 0.25 * t**2, abs=1e-12)
    assert power == pytest.approx(-torque, abs=1e-12)


def test_a_force_only_on_the_way_out_works_once_a_turn() -> None:
    """A slider-crank pushes 300 N over its stroke 2 r = 0.2 m, outwards only: 60 J a turn."""
    data: dict[str, Any] = {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"A": [0, 0]}},
            "crank": {"points": {"A": [0, 0], "B": [0.1, 0]}},
            "rod": {"points": {"B": [0, 0], "C": [0.5, 0]}},
            "slide": {"points": {"C": [0, 0]}, "mass": 1.5, "shape": "point C"},
        },
        "joints": {"guide": {"prismatic": ["frame", "slide"], "line": ["A at 0", "C at 0"]}},
        "assembly": {"C": "ahead of B along guide"},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": 10, "start": 0}},
        "windows": {"outward": {"guide.v": [0, 100]}},
        "loads": {"cut": {"on": "slide", "at": "C", "along": "guide", "force": -300, "window": "outward"}},
        "measures": {
            "power": {"mean": "motor.power"},
            "rod": {"extremes": "force(rod, slide).x"},
        },
    }
    from linkwright.measures import measure_all

    run = Run(compiled_from(data), 0.0, 2 * np.pi / 10, 50)
    certificate = certify(run)
    assert certificate.sound(1e-12), certificate.residuals
    measures, _ = measure_all(run)
    assert measures[0].found[0].value == pytest.approx(300 * 0.2 / (2 * np.pi / 10), rel=1e-12)
    # The largest right after the inner dead centre, the smallest right after the outer one.
    inertia = 1.5 * 0.1 * 10**2
    low, high = (found.value for found in measures[1].found)
    assert (low, high) == pytest.approx((-inertia * 1.2, 300 + inertia * 0.8), rel=1e-9)
