"""What the oracle expects of every signal of a mechanism, under the names that linkwright gives them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from hypothesis import assume
from numpy.typing import NDArray

from helpers.newton_euler import Extra, Oracle, State
from helpers.plain import Plain

Array = NDArray[np.float64]
Rows = dict[str, Array]


def oracle_states(plain: Plain, t: Array, extra: Sequence[Extra] = ()) -> tuple[Oracle, list[State]]:
    """The oracle and its states at increasing times."""
    oracle = Oracle(plain, extra)
    return oracle, oracle.follow(t)


def regular_states(plain: Plain, t: Array) -> tuple[Oracle, list[State]]:
    """The oracle's states; a drawn mechanism that comes near a singular pose is left out."""
    try:
        oracle, states = oracle_states(plain, t)
    except np.linalg.LinAlgError:
        assume(False)
        raise
    assume(all(np.isfinite(s.q).all() and np.abs(s.a).max() < 50 for s in states))
    assume(min(oracle.regularity(s) for s in states) > 0.03)
    return oracle, states


def expected_motion(oracle: Oracle, states: Sequence[State]) -> dict[str, Rows]:
    """Positions, velocities and accelerations of all points, centres of mass, slides and links, by order."""
    plain = oracle.plain
    orders: dict[str, Rows] = {"position": {}, "velocity": {}, "acceleration": {}}
    seen = set(plain.links["frame"].points)
    for link in plain.moving:
        places = {n: at for n, at in plain.links[link].points.items() if n not in seen}
        seen |= set(places)
        if plain.links[link].mass is not None:
            places[f"com({link})"] = plain.mass(link)[1]
        for name, local in places.items():
            rows = {
                "position": [oracle.at(s.q, link, local) for s in states],
                "velocity": [oracle.velocity(s, link, local) for s in states],
                "acceleration": [oracle.acceleration(s, link, local) for s in states],
            }
            for (order, values), letter in zip(rows.items(), ("", "v", "a"), strict=True):
                for k, axis in enumerate("xy"):
                    orders[order][f"{name}.{letter}{axis}"] = np.array(values)[:, k]
        for order, attribute, values in (
            ("velocity", "omega", [oracle.pose(s.v, link)[2] for s in states]),
            ("acceleration", "alpha", [oracle.pose(s.a, link)[2] for s in states]),
        ):
            orders[order][f"{link}.{attribute}"] = np.array(values)
    for name, slide in plain.slides.items():
        (a, b), (pa, pb) = slide.links, slide.points
        travel = []
        for s in states:
            heading = oracle.pose(s.q, a)[2] + slide.angles[0]
            along = np.array([np.cos(heading), np.sin(heading)])
            travel.append((oracle.point(s.q, b, pb) - oracle.point(s.q, a, pa)) @ along)
        orders["position"][f"{name}.s"] = np.array(travel)
    return orders


def expected_angles(oracle: Oracle, states: Sequence[State]) -> Rows:
    """Angles of the links, continuous from the start."""
    return {f"{link}.angle": np.array([oracle.pose(s.q, link)[2] for s in states]) for link in oracle.plain.moving}


def expected_forces(oracle: Oracle, states: Sequence[State]) -> Rows:
    """All reactions (of a link on a pin or on the other link), efforts, powers and the shaking wrench."""
    plain = oracle.plain
    results = [oracle.forces(s) for s in states]
    rows: Rows = {}
    for pin, members in plain.pins.items():
        links = [link for link, _ in members]
        for link in links:
            on = pin if len(links) > 2 else next(other for other in links if other != link)
            values = -np.array([r.reactions[pin, link] for r in results])
            for k, axis in enumerate("xy"):
                rows[f"force({link}, {on}, {pin}).{axis}"] = values[:, k]
    for name, slide in plain.slides.items():
        for link, on in (slide.links, slide.links[::-1]):
            values = -np.array([r.reactions[name, link] for r in results])
            headings = np.array([oracle.pose(s.q, slide.links[0])[2] + slide.angles[0] for s in states])
            rows[f"force({link}, {on}, {name}).x"] = values[:, 0]
            rows[f"force({link}, {on}, {name}).y"] = values[:, 1]
            rows[f"force({link}, {on}, {name}).normal"] = (
                -np.sin(headings) * values[:, 0] + np.cos(headings) * values[:, 1]
            )
            rows[f"force({link}, {on}, {name}).moment"] = values[:, 2]
    for name, drive in plain.drives.items():
        effort = np.array([r.efforts[name] for r in results])
        rows[f"{name}.{'torque' if drive.kind == 'turns' else 'force'}"] = effort
        rows[f"{name}.power"] = effort * np.array([drive.law(s.t, 1) for s in states])
    for k, attribute in enumerate(("x", "y", "moment")):
        rows[f"shaking.{attribute}"] = np.array([r.shaking[k] for r in results])
    return rows


def expected_energies(oracle: Oracle, states: Sequence[State]) -> Rows:
    """Kinetic energy, and potential energy of gravity about the frame's origin."""
    plain = oracle.plain
    g = np.array(plain.gravity or (0.0, 0.0))
    kinetic, potential = np.zeros(len(states)), np.zeros(len(states))
    for link in plain.moving:
        mass, centre, inertia = plain.mass(link)
        for i, s in enumerate(states):
            v = oracle.velocity(s, link, centre)
            kinetic[i] += 0.5 * mass * (v @ v) + 0.5 * inertia * oracle.pose(s.v, link)[2] ** 2
            potential[i] -= mass * float(g @ oracle.at(s.q, link, centre))
    return {"energy.kinetic": kinetic, "energy.potential": potential}


def worst(found: Array, rows: Rows, floor: float) -> tuple[float, str]:
    """The largest difference over the largest expected value (at least ``floor``), and the row where it is."""
    expected = np.array(list(rows.values()))
    errors = np.abs(found - expected).max(axis=1) / max(floor, float(np.abs(expected).max(initial=0.0)))
    index = int(errors.argmax())
    return float(errors[index]), list(rows)[index]
