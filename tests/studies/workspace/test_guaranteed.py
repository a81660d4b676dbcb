"""Errors and guaranteed regions against differences, closed forms and the mechanisms at the corners of tolerances."""

from __future__ import annotations

from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import shapely
from scipy.optimize import brentq

from helpers.compiled import compiled_from
from helpers.examples import UNITS
from linkwright.compilation import compile_mechanism
from linkwright.expressions.units import LENGTH
from linkwright.kernels import Compiled
from linkwright.model.document import load
from linkwright.studies.accuracy.contributors import Contributor, Contributors
from linkwright.studies.accuracy.options import AccuracyOptions
from linkwright.studies.accuracy.stated_contributors import contributors
from linkwright.studies.cycle.options import CycleOptions
from linkwright.studies.workspace.causes import Causes
from linkwright.studies.workspace.curves import curves
from linkwright.studies.workspace.errors import Errors, errors
from linkwright.studies.workspace.farthest import farthest
from linkwright.studies.workspace.guaranteed import edge_shifts, edges, guaranteed
from linkwright.studies.workspace.mesh import DriveBox, mesh
from linkwright.studies.workspace.region_search import reached
from linkwright.studies.workspace.regions import Region
from linkwright.studies.workspace.sheet import ModeSheet
from linkwright.studies.workspace.solving import reaches

EXAMPLE = Path(__file__).parents[3] / "examples" / "five_bar_workspace.yaml"
TURNS = DriveBox((0.0, 0.0), (2 * np.pi, 2 * np.pi), (True, True))
LENGTHS = {"a": 1.0, "b": 1.2, "c": 1.1, "d": 1.0, "e": 1.0}


def five_bar(**lengths: float) -> Compiled:
    """Cranks a and d, couplers b and c, base e (m); P is off the first coupler."""
    data: dict[str, Any] = {
        "linkwright": 1,
        "units": UNITS,
        "parameters": LENGTHS | lengths,
        "links": {
            "frame": {"points": {"O1": [0, 0], "O4": ["e", 0]}},
            "crank1": {"points": {"O1": [0, 0], "B": ["a", 0]}},
            "link2": {"points": {"B": [0, 0], "C": ["b", 0], "P": [0.5, 0.4]}},
            "link3": {"points": {"D": [0, 0], "C": ["c", 0]}},
            "crank4": {"points": {"O4": [0, 0], "D": ["d", 0]}},
        },
        "assembly": {"C": "left of B-D"},
        "drives": {
            "motor": {"turns": "crank1", "on": "frame", "speed": 1, "start": 2.0},
            "servo": {"turns": "crank4", "on": "frame", "speed": 1, "start": 1.0},
        },
    }
    return compiled_from(data)


def sheet_of(compiled: Compiled, point: str = "P", deviations: np.ndarray | float = 0.0) -> ModeSheet:
    return ModeSheet(compiled, point, ("motor", "servo"), (1.0,), compiled.parameters + deviations)


def deviating(compiled: Compiled, names: str, within: float) -> Contributors:
    """Independent lengths within plus or minus so much."""
    every = []
    for name in names:
        direction = np.array([float(one == name) for one in compiled.graph.parameters])
        limits = (-within, within, 0.0, within / 3)
        every.append(Contributor(name, direction, 1.0, *limits, np.asarray, LENGTH, "m", 1.0, "", "normal"))
    return Contributors(tuple(every), np.eye(len(every)))


def region_of(sheet: ModeSheet, box: DriveBox, steps: int, chord: float) -> Region:
    """A region on one mesh, for mechanisms whose outer pins never meet."""
    made = mesh(sheet, box, steps)
    segments = curves(sheet, made, chord)
    return Region(sheet, box, reached(sheet, box, made, segments, chord)[0], tuple(segments), made, steps, 0.0)


def test_farthest_of_all_corners() -> None:
    rng = np.random.default_rng(3)
    slopes, ends = rng.normal(size=(2, 5, 40)), np.sort(rng.normal(size=(2, 5, 1)), axis=0)
    brute = [np.hypot(*(slopes * np.array(corner)[:, None]).sum(axis=1)) for corner in product(*ends[:, :, 0].T)]
    np.testing.assert_allclose(farthest(slopes, *ends), np.max(brute, axis=0), rtol=1e-12)


def test_errors_are_differences_weighted_by_the_files_tolerances() -> None:
    """Superposition of the single deviations, as in Peng and Zi 2010, equations 8 and 9."""
    document = load(EXAMPLE)
    compiled = compile_mechanism(document)
    cycle = CycleOptions.model_validate({"period": "2 s"})
    who = contributors(compiled, AccuracyOptions.model_validate({"outputs": ["P.x"]}, context={"cycle": cycle}))
    maps = errors(sheet_of(compiled), TURNS, Causes(who), steps=5)
    q = np.stack(np.meshgrid(*maps.axes, indexing="ij")).reshape(2, -1)
    differences = []
    for one in who.every:
        step = 1e-6 * one.direction
        there, back = (sheet_of(compiled, deviations=sign * step).place(q)[0] for sign in (1, -1))
        differences.append((there - back) / 2e-6)
    slopes, half = np.stack(differences, axis=1), np.array([[2e-5] * 4 + [3e-5, 2e-5, np.radians(0.1)]]).T
    assert set(who.names) == {"l1", "l2", "l3", "l4", "l5", "r2", "alpha"}
    values = {name: one.values.ravel() for name, one in maps.maps.items()}
    for k, axis in enumerate("xy"):
        worst = (np.abs(slopes[k]) * half).sum(axis=0)
        np.testing.assert_allclose(values[f"error {axis} most"], worst, rtol=1e-6)
        np.testing.assert_allclose(values[f"error {axis} least"], -worst, rtol=1e-6)
        np.testing.assert_allclose(values[f"spread {axis}"], np.hypot.reduce(slopes[k] * half), rtol=1e-6)
    np.testing.assert_allclose(values["error worst"], farthest(slopes, -half, half), rtol=1e-6)
    covariances = np.moveaxis(np.einsum("aij,bij->abj", slopes * half, slopes * half), 2, 0)
    np.testing.assert_allclose(values["spread worst"] ** 2, np.linalg.eigvalsh(covariances)[:, 1], rtol=1e-6)


def coupler_in_line(t: float, lengths: dict[str, float]) -> np.ndarray:
    """C of a five-bar with its couplers in one line (a four-bar with the coupler b + c), at an angle of crank 1."""
    a, b, c, d, e = lengths.values()
    pin = a * np.array([np.cos(t), np.sin(t)])
    base = pin - [e, 0]
    far = np.hypot(*base)
    along = (far**2 + d**2 - (b + c) ** 2) / (2 * far)
    other = np.array([e, 0]) + along * base / far - np.sqrt(d**2 - along**2) * np.array([-base[1], base[0]]) / far
    return np.asarray(pin + b / (b + c) * (other - pin))


def test_rim_moves_as_the_coupler_curve_does() -> None:
    compiled = five_bar()
    found = Errors(sheet_of(compiled, "C"), Causes(deviating(compiled, "abcde", 1e-3)), 10)
    q, normals, expected = [], [], []
    for t in (2.6, 2.8, 3.0):
        bend = coupler_in_line(t, LENGTHS)
        other = np.array([np.cos(t), np.sin(t)]) + 2.3 / 1.2 * (bend - [np.cos(t), np.sin(t)])
        servo = np.arctan2(other[1], other[0] - 1)
        sheet = found.sheet
        inward = next(s for s in (1e-3, -1e-3) if sheet.place(np.array([[t], [servo + s]]))[1][0] > 0)
        root = brentq(
            lambda v, t=t, sheet=sheet: sheet.place(np.array([[t], [v]]))[1][0] - 1e-14, servo - inward, servo + inward
        )
        tangent = coupler_in_line(t + 1e-6, LENGTHS) - coupler_in_line(t - 1e-6, LENGTHS)
        normal = np.array([tangent[1], -tangent[0]]) / np.hypot(*tangent)
        q.append([t, root])
        normals.append(normal)
        ways = [(LENGTHS | {n: v + 1e-6}, LENGTHS | {n: v - 1e-6}) for n, v in LENGTHS.items()]
        expected.append([normal @ (coupler_in_line(t, up) - coupler_in_line(t, down)) / 2e-6 for up, down in ways])
    drives = np.repeat(np.array(q).T[:, None], 2, axis=1)
    shifts = edge_shifts(found, "modes", drives, np.array(normals).T)
    np.testing.assert_allclose(shifts[:, 0], np.transpose(expected), atol=2e-6)


def test_singular_curve_moves_as_the_stretched_leg_does() -> None:
    """Crank 1 and P's arm of the coupler in line: a circle about O1, which widens by what the crank does."""
    compiled = five_bar()
    box = DriveBox((0.3, 0.2), (2.5, 2.9))
    region = region_of(sheet_of(compiled), box, 20, 1e-3)
    found = Errors(region.sheet, Causes(deviating(compiled, "abe", 1e-3)), 10)
    (one,) = [edge for edge in edges(region, found) if edge.kind == "singular"]
    radius, reach = np.hypot(*one.ends[:, 0]), np.hypot(0.5, 0.4)
    stretched = np.abs(radius - 1 - reach) < 1e-6
    assert stretched.sum() > 5
    close = np.isclose(one.shifts[:, 0, stretched].T, [1.0, 0.0, 0.0], atol=1e-5).all(axis=1)
    assert close.mean() > 0.9  # at corners other curves are near


def test_where_pins_meet_the_boundary_follows_them() -> None:
    """Equal couplers on cranks that meet at the apex of a triangle: C is on a circle about it, of radius b; the crank
    pins part by c - b along the coupler's direction u, and each stays on its own circle."""
    compiled = five_bar(b=1.2, c=1.2)
    found = Errors(sheet_of(compiled, "C"), Causes(deviating(compiled, "abcde", 1e-3)), 10)
    angles, pit = np.linspace(0.3, 6.0, 8), np.radians([[60], [120]])
    q = [pit + 3e-6 * np.stack([np.cos(angles + step), np.sin(angles + step)]) for step in (0, 0.01)]
    u = (found.sheet.place(q[0])[0] - np.array([[0.5], [np.sqrt(0.75)]])) / 1.2
    across = [[-np.sqrt(0.75), 0.5], [-np.sqrt(0.75), -0.5]]  # the ways of both crank pins
    outward = np.array([[0.5, np.sqrt(0.75)], [-0.5, np.sqrt(0.75)]])
    # B + t1 across1 + da outward1 + db u = C = D + t2 across2 + dd outward2 + dc u + de (1, 0)
    matrix = np.stack([across[0], np.negative(across[1])], axis=1)
    right = [-outward[0][:, None] + 0 * u, -u, u, outward[1][:, None] + 0 * u, np.array([[1.0], [0.0]]) + 0 * u]
    own = [outward[0][:, None] + 0 * u, u, 0 * u, 0 * u, 0 * u]
    expected = [
        ((np.outer(across[0], np.linalg.solve(matrix, r)[0]) + o) * u).sum(0) for r, o in zip(right, own, strict=True)
    ]
    np.testing.assert_allclose(edge_shifts(found, "pins", np.stack(q, axis=1), u)[:, 0], expected, atol=1e-4)


def test_all_mechanisms_within_tolerances_reach_the_guaranteed_part() -> None:
    """Those at the corners of the tolerances reach its border but for terms of second order; most places that are a
    little farther out some of them don't reach."""
    compiled, box, within = five_bar(), DriveBox((0.3, 0.2), (2.5, 2.9)), 2e-3
    who = deviating(compiled, "be", within)
    region = region_of(sheet_of(compiled), box, 20, 1e-4)
    made = guaranteed(region, Causes(who))
    assert 0 <= made.least < made.most < 5 * within
    parts = edges(region, Errors(region.sheet, Causes(who), 10))
    middles = np.concatenate([one.ends.mean(axis=1) for one in parts], axis=1)
    outward = np.concatenate([one.outward for one in parts], axis=1)
    width = np.concatenate([e.width for e in parts])
    steps = mesh(region.sheet, box, 40)
    true = ~reaches(region.sheet, box, steps, middles + 5e-4 * outward, 1e-7)[0]  # not a gap between coarse chords
    some = np.flatnonzero(true & (width > 5e-4))[::4]
    inner = shapely.boundary(made.shape.buffer(-50 * within**2)).simplify(1e-3)
    places = np.concatenate([shapely.get_coordinates(inner).T, (middles - 0.8 * width * outward)[:, some]], axis=1)
    found = []
    for corner in product((-within, within), repeat=2):
        sheet = sheet_of(compiled, deviations=who.directions @ corner)
        found.append(reaches(sheet, box, mesh(sheet, box, 40), places, 1e-7)[0])
    reached_by_all = np.all(found, axis=0)
    assert reached_by_all[: -some.size].all()
    assert reached_by_all[-some.size :].mean() < 0.1


def test_where_the_point_is_precise() -> None:
    compiled = five_bar()
    box, who = DriveBox((0.3, 0.2), (2.5, 2.9)), deviating(compiled, "abcde", 1e-3)
    region = region_of(sheet_of(compiled), box, 20, 1e-4)
    made = guaranteed(region, Causes(who), limit=3e-3, steps=100)
    assert 0.05 < made.precise.area / made.shape.area < 0.95
    q = np.random.default_rng(2).uniform(np.array([box.low]).T, np.array([box.high]).T, (2, 4000))
    found = Errors(region.sheet, Causes(who), 4000)(q)
    inner = shapely.contains_xy(made.precise.buffer(-0.01), found["x"], found["y"])
    assert inner.sum() > 50
    assert found["error worst"][inner].max() < 3.02e-3
