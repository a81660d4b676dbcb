"""Random redundant mechanisms against an independent solver: motion, drive torque, which reactions are determined and
those that are; how redundant joints share a load against elastic joints of rising stiffness."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from helpers.redundant import SPEED, Bodies, Solver, random_redundant
from linkwright.compilation import examine
from linkwright.model.document import Document
from linkwright.results.certificate import certify
from linkwright.results.run import Run

T = np.linspace(0.0, 0.15, 4)
SEEDS = [pytest.param(seed, marks=[] if seed < 30 else pytest.mark.long) for seed in range(200)]


def compiled(b: Bodies, **more: Any) -> Any:
    made, findings = examine(Document.model_validate({**b.document(), **more}))
    assert made is not None, [(f.code, f.path, dict(f.data)) for f in findings]
    return made, findings


def rows_of(solver: Solver, joint: str, link: str, attribute: str, q: np.ndarray) -> np.ndarray:
    """A component of the force of a link on its joint (the pin, or the other link), over the multipliers."""
    found = np.zeros(len(solver.rows))
    j, i = solver.jacobian(q), solver.index.get(link)
    for k, (own, _, _) in enumerate(solver.rows):
        if own == joint:
            if i is not None:
                found[k] = -j[k, i + "xy".index(attribute)]
            else:  # of the frame: the opposite of what all others do
                found[k] = sum(j[k, other + "xy".index(attribute)] for other in solver.index.values())
    return found


@pytest.mark.parametrize("seed", SEEDS)
def test_a_random_redundant_mechanism(seed: int) -> None:
    b = random_redundant(seed)
    solver = Solver(b)
    made, findings = compiled(b)
    assert [f.code for f in findings] == ["structure.redundant-joints"]
    assert made.structure.redundant == len(solver.rows) - len(solver.q0)
    points = [(link, p) for link in b.moving for p in b.places[link]]
    names = [f"{p}.{a}" for _, p in points for a in ("x", "y")]
    there = made.evaluate(names, T).reshape(len(points), 2, T.size)
    (torque,) = made.evaluate(["motor.torque"], T)
    signals = made.quantities.signals
    contacts = {(c.joint, c.link): c for c in signals.contacts}
    reactions = {
        key: made.possible_rows([f"force({c.link}, {c.on}, {c.joint}).{a}" for a in "xy"], T)
        for key, c in contacts.items()
    }
    q, touched, left = solver.q0, dict.fromkeys([(*key, a) for key in contacts for a in "xy"], 0.0), []
    for n, t in enumerate(T):
        q = solver.pose(q, float(t))
        for (link, p), own in zip(points, there, strict=True):
            np.testing.assert_allclose(own[:, n], solver.at(q, link, b.local(link, p)), atol=1e-9)
        v, a = solver.rates(q)
        forces, states = solver.balance(q, solver.wrenches(q, v, a))
        scale = np.abs(forces).max() + 1.0
        np.testing.assert_allclose(torque[n], forces[solver.drive], atol=1e-9 * scale)
        for joint, link in contacts:
            for k, axis in enumerate("xy"):
                row = rows_of(solver, joint, link, axis, q)
                touched[joint, link, axis] = max(touched[joint, link, axis], float(np.abs(row @ states).max()))
                left.append((joint, link, axis, reactions[joint, link][k, n], float(row @ forces), scale))
    undetermined = {(*key, a) for key in contacts for a in "xy" if (*key, a) in made.structure.self_stress.components}
    assert undetermined == {key for key, size in touched.items() if size > 1e-6}
    for joint, link, axis, value, expected, scale in left:
        if (joint, link, axis) not in undetermined:
            assert value == pytest.approx(expected, abs=1e-9 * scale), (joint, link, axis)
    assert certify(Run(made, 0.0, 0.15, 20)).sound()


# How redundant joints share a load.


def elastic_reactions(solver: Solver, q: np.ndarray, w: np.ndarray, stiffness: np.ndarray) -> np.ndarray:
    """The multipliers of all rows where each joint is a spring and the drive is held: Newton on the poses and on the
    drive's multiplier, links that move apart by finite distances (not a linear system of compliances)."""
    joints = np.arange(len(solver.rows)) != solver.drive
    k, held, n = stiffness[joints], q[solver.index[solver.b.crank] + 2], q.size
    t, torque, unit = (held - solver.start) / SPEED, 0.0, np.eye(q.size)

    def gradient(pose: Any, torque: float) -> Any:
        j, gaps = solver.jacobian(pose), solver.residual(pose, t)
        return j[joints].T @ (k * gaps[joints]) + j[solver.drive] * torque - w

    for _ in range(30):
        h = 1e-7
        bent = np.array([(gradient(q + h * e, torque) - gradient(q - h * e, torque)).real / (2 * h) for e in unit]).T
        j, gaps = solver.jacobian(q), solver.residual(q, t).real
        system = np.block([[bent, j[[solver.drive]].T], [j[[solver.drive]], np.zeros((1, 1))]])
        step = np.linalg.solve(system, [*gradient(q, torque).real, gaps[solver.drive]])
        q, torque = q - step[:n], torque - step[n]
        if np.abs(step[:n]).max() < 1e-15:
            break
    forces = -stiffness * solver.residual(q, t).real
    forces[solver.drive] = -torque
    return np.asarray(forces)


@pytest.mark.parametrize("equal", [True, False])
@pytest.mark.parametrize("seed", [0, 4, 5, 17, *(pytest.param(s, marks=pytest.mark.long) for s in (8, 12, 16, 29, 33))])
def test_shares_are_those_of_ever_stiffer_joints(seed: int, equal: bool) -> None:
    """Springs in place of the joints, stiffer by tenfold: the reactions tend to the shares, the difference by tenfold
    too; what remains at the end is extrapolated."""
    b = random_redundant(seed)
    solver = Solver(b)
    random = np.random.default_rng(seed)
    names = [*dict.fromkeys(joint for joint, _, _ in solver.rows if joint != "motor")]
    # Pins of two links, and rollers: of others the reaction isn't one vector.
    assert not b.slides and all(len(links) == 2 for links in b.pins.values())
    own = dict.fromkeys(names, 1.0) if equal else {name: float(random.uniform(0.3, 3)) for name in names}
    stiffness: Any = "equal" if equal else {name: f"{1e6 * k!r} N/m" for name, k in own.items()}
    made, findings = compiled(b, stiffness=stiffness)
    assert [f.code for f in findings] == ["structure.redundant-joints"]
    assert not made.structure.self_stress.components
    contacts = [(c.joint, c.link, c.on) for c in made.quantities.signals.contacts]
    t = np.array([0.1])
    values = made.evaluate([f"force({link}, {on}, {joint}).{a}" for joint, link, on in contacts for a in "xy"], t)
    q = solver.pose(solver.q0, 0.1)
    w = solver.wrenches(q, *solver.rates(q))
    rows = np.array([rows_of(solver, joint, link, a, q) for joint, link, _ in contacts for a in "xy"])
    k = np.array([own.get(joint, 1.0) for joint, _, _ in solver.rows])
    softer, stiff, stiffer = (rows @ elastic_reactions(solver, q, w, k * of) for of in (1e5, 1e6, 1e7))
    scale = np.abs(stiffer).max() + 1.0
    apart = [np.abs(values[:, 0] - of).max() / scale for of in (softer, stiff, stiffer)]
    assert apart[2] < apart[0] / 50 or apart[0] < 1e-7, apart
    np.testing.assert_allclose(values[:, 0], stiffer + (stiffer - stiff) / 9, atol=1e-6 * scale)


@pytest.mark.parametrize("seed", [5, 8, 84, *(pytest.param(s, marks=pytest.mark.long) for s in range(90))])
def test_a_point_that_is_a_little_off_is_refused_or_proven(seed: int) -> None:
    """One coordinate of one point is wrong by 1e-9 to 0.1 m: what is accepted all the same (a base along its slot, for
    one) is proven, and what nearly fits misses by something of that size."""
    random, data = np.random.default_rng([seed, 7]), random_redundant(seed).document()
    error, links = float(10.0 ** random.uniform(-9, -1)), data["links"]
    points = links[str(random.choice([*links]))]["points"]
    points[str(random.choice([*points]))][int(random.integers(2))] += error
    made, findings = examine(Document.model_validate(data))
    if made is not None:
        assert certify(Run(made, 0.0, 0.1, 8)).sound()
        return
    misses = [float(f.data["miss"]) for f in findings if f.code == "structure.nearly-redundant"]
    assert not misses or 1e-3 < max(misses) / error < 30
