"""Drives of links that share no joint with what they are moved against: motion, reactions and efforts against the full
Newton-Euler system, whose only knowledge of a drive is its law; closed forms; what is refused."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from helpers.compiled import compiled_from
from helpers.examples import UNITS, four_bar, heavy_four_bar, slider_crank
from helpers.newton_euler import Oracle
from helpers.plain import XY, Law, Plain, PlainDrive, PlainLink
from linkwright.compilation import examine
from linkwright.model.document import Document
from linkwright.results.certificate import certify
from linkwright.results.run import Run
from linkwright.structure import decompose

EXAMPLES = Path(__file__).parents[2] / "examples"
T = np.linspace(0.0, 1.0, 21)
G = (0.0, -9.81)


def entry(drive: PlainDrive) -> dict[str, Any]:
    law = drive.law
    text = f"{law.q0!r} + {law.q1!r}*t/(1 s) + {law.amp!r}*sin({law.w!r}*t/(1 s) + {law.phase!r})"
    if drive.track is None:
        return {drive.kind: drive.link, "on": drive.on, "position": text}
    point, base, angle = drive.track
    return {"moves": drive.link, "at": point, "on": drive.on, "along": f"{base} at {angle!r}", "position": text}


def document(plain: Plain) -> dict[str, Any]:
    links = {
        name: {"points": {p: list(at) for p, at in link.points.items()}}
        | ({"mass": link.mass, "com": list(link.com), "inertia": link.inertia} if link.mass else {})
        for name, link in plain.links.items()
    }
    joints = {
        name: {"prismatic": list(s.links), "line": [f"{p} at {a!r}" for p, a in zip(s.points, s.angles, strict=True)]}
        for name, s in plain.slides.items()
    }
    drives = {name: entry(drive) for name, drive in plain.drives.items()}
    return {
        "linkwright": 1,
        "units": dict(UNITS),
        "gravity": list(G),
        "links": links,
        "joints": joints,
        "drives": drives,
        "assembly": dict(plain.assembly),
    }


def body(points: dict[str, XY], seed: int) -> PlainLink:
    random = np.random.default_rng(seed)
    com = (float(random.normal(scale=0.2)), float(random.normal(scale=0.2)))
    return PlainLink(points, float(random.uniform(0.5, 3)), com, float(random.uniform(0.05, 0.4)))


def pins(links: dict[str, PlainLink]) -> dict[str, tuple[tuple[str, str], ...]]:
    members: dict[str, list[tuple[str, str]]] = {}
    for name, link in links.items():
        for point in link.points:
            members.setdefault(point, []).append((name, point))
    return {point: tuple(of) for point, of in members.items() if len(of) > 1}


def placed(points: dict[str, XY], *ends: tuple[str, str]) -> dict[str, tuple[float, float, float]]:
    """Poses of links of which the first point is the origin and the second lies on the x axis."""
    return {"frame": (0.0, 0.0, 0.0)} | {
        f"{a}{b}": (*points[a], math.atan2(points[b][1] - points[a][1], points[b][0] - points[a][0])) for a, b in ends
    }


def five_bar(drives: dict[str, PlainDrive]) -> Plain:
    """A five-bar whose links are named by their points, drawn as a house."""
    at = {"A": (0.0, 0.0), "B": (-0.3, 1.0), "C": (0.8, 1.9), "D": (1.9, 1.0), "E": (1.5, 0.0)}
    ends = (("A", "B"), ("B", "C"), ("E", "D"), ("D", "C"))
    links = {"frame": PlainLink({"A": at["A"], "E": at["E"], "O": (0.2, -0.1)})}
    for k, (a, b) in enumerate(ends):
        links[f"{a}{b}"] = body({a: (0.0, 0.0), b: (math.dist(at[a], at[b]), 0.0)}, k)
    links["BC"].points["P"] = (0.9, -0.3)
    assembly = {name: list(at[name]) for name in "BCD"}
    return Plain(links, pins(links), {}, drives, placed(at, *ends), assembly, gravity=G)


def angle(plain: Plain, link: str, on: str = "frame") -> float:
    return plain.start[link][2] - plain.start[on][2]


def along(plain: Plain, link: str, track: tuple[str, str, float], on: str = "frame") -> float:
    """Where a point lies along a line at the start."""

    def place(name: str, point: str) -> np.ndarray:
        x, y, turn = plain.start[name]
        px, py = plain.links[name].points[point]
        return np.array([x + math.cos(turn) * px - math.sin(turn) * py, y + math.sin(turn) * px + math.cos(turn) * py])

    heading = plain.start[on][2] + track[2]
    away = place(link, track[0]) - place(on, track[1])
    return float(away @ [math.cos(heading), math.sin(heading)])


FREE = five_bar({})
P_ALONG_X, P_ALONG_Y = ("P", "O", 0.3), ("P", "O", 0.3 + math.pi / 2)
ON_CRANK = ("C", "A", -0.4)


def wave(start: float, amp: float, w: float = 2.0) -> Law:
    return Law(start, amp=amp, w=w)


CASES: dict[str, dict[str, PlainDrive]] = {
    "a coupler's angle and a crank": {
        "tilt": PlainDrive("turns", "BC", "frame", wave(angle(FREE, "BC"), 0.15)),
        "motor": PlainDrive("turns", "ED", "frame", wave(angle(FREE, "ED"), 0.2, 3.0)),
    },
    "two links of one group on each other": {
        "tilt": PlainDrive("turns", "DC", "AB", wave(angle(FREE, "DC", "AB"), 0.15)),
        "other": PlainDrive("turns", "BC", "frame", wave(angle(FREE, "BC"), 0.1, 3.0)),
    },
    "a point in two directions": {
        "x": PlainDrive("slides", "BC", "frame", wave(along(FREE, "BC", P_ALONG_X), 0.1), P_ALONG_X),
        "y": PlainDrive("slides", "BC", "frame", wave(along(FREE, "BC", P_ALONG_Y), 0.1, 3.0), P_ALONG_Y),
    },
    "a point along a line of a moving link, and an angle": {
        "far": PlainDrive("slides", "BC", "ED", wave(along(FREE, "BC", ("P", "E", -0.4), "ED"), 0.1), ("P", "E", -0.4)),
        "tilt": PlainDrive("turns", "DC", "frame", wave(angle(FREE, "DC"), 0.1, 3.0)),
    },
}


@pytest.mark.parametrize("name", CASES)
def test_against_newton_and_euler(name: str) -> None:
    plain = five_bar(CASES[name])
    oracle = Oracle(plain)
    states = oracle.follow(T)
    run = Run(compiled_from(document(plain)), 0.0, 1.0, 100)
    for link in plain.moving:
        for signal, k in (("omega", 2),):
            found = run.evaluate([f"{link}.{signal}"], T)[0]
            assert found == pytest.approx([oracle.pose(s.v, link)[k] for s in states], rel=1e-8, abs=1e-9)
        found = run.evaluate([f"{link}.alpha"], T)[0]
        assert found == pytest.approx([oracle.pose(s.a, link)[2] for s in states], rel=1e-8, abs=1e-8)
    forces = [oracle.forces(s) for s in states]
    size = max(abs(v) for f in forces for r in f.reactions.values() for v in r[:2])
    for drive, entry in run.compiled.mechanism.drives.items():
        found = run.evaluate([f"{drive}.{entry.effort}"], T)[0]
        assert found == pytest.approx([f.efforts[drive] for f in forces], abs=1e-8 * size)
    for pin, members in plain.pins.items():
        (a, _), (b, _) = members
        found = run.evaluate([f"force({a}, {b}, {pin}).x", f"force({a}, {b}, {pin}).y"], T)
        expected = np.array([f.reactions[pin, b][:2] for f in forces]).T  # of the pin on the second link
        assert np.abs(found - expected).max() < 1e-8 * size
    certificate = certify(run)
    assert certificate.sound(), certificate.residuals
    assert (certificate.mobility, certificate.gruebler) == (2, 2)


def test_a_bucket_that_its_drive_keeps_level() -> None:
    """Pinned to a boom and turned against the frame: the torque balances weight and inertia about the pin."""
    bucket = {"points": {"B": [0, 0]}, "mass": 20, "com": [0.08, -0.03], "inertia": 0.2}
    data: dict[str, Any] = {
        "linkwright": 1,
        "units": dict(UNITS),
        "gravity": list(G),
        "links": {"frame": {"points": {"A": [0, 0]}}, "boom": {"points": {"A": [0, 0], "B": [0.5, 0]}}, "hand": bucket},
        "drives": {
            "lift": {"turns": "boom", "on": "frame", "position": "0.3 + 0.7*sin(2*t/(1 s))"},
            "level": {"turns": "hand", "on": "frame", "position": "9*t/(1 s) + 0.2*sin(3*t/(1 s))"},
        },
    }
    data["links"]["boom"] |= {"mass": 10, "com": [0.25, 0], "inertia": 0.4}
    run = Run(compiled_from(data), 0.0, 1.0, 100)
    q, dq, ddq = (0.3 + 0.7 * np.sin(2 * T), 1.4 * np.cos(2 * T), -2.8 * np.sin(2 * T))
    p, dp, ddp = (9 * T + 0.2 * np.sin(3 * T), 9 + 0.6 * np.cos(3 * T), -1.8 * np.sin(3 * T))
    arm, arm_dd = 0.5 * np.exp(1j * q), 0.5 * (1j * ddq - dq**2) * np.exp(1j * q)
    com, com_dd = (0.08 - 0.03j) * np.exp(1j * p), (1j * ddp - dp**2) * (0.08 - 0.03j) * np.exp(1j * p)
    force = 20 * (arm_dd + com_dd + 9.81j)  # of the boom on the bucket

    def moment(at: Any, of: Any) -> Any:
        return np.imag(np.conj(at) * of)

    level = moment(com, force) + 0.2 * ddp
    centre = 0.5 * arm
    boom = moment(centre, 10 * (0.5 * arm_dd + 9.81j)) + 0.4 * ddq + moment(arm, force)
    found = run.evaluate(["level.torque", "lift.torque", "level.angle", "hand.angle"], T)
    assert found == pytest.approx(np.array([level, boom, p, p]), rel=1e-11, abs=1e-11)


def test_it_is_the_crank_s_drive_seen_from_the_coupler() -> None:
    """The torque at the coupler does the same work as that at the crank: by the ratio of the rates."""
    at_crank = Run(compiled_from(heavy_four_bar()), 0.0, 1.0, 100)
    found = at_crank.evaluate(["coupler.angle", "coupler.omega", "crank.omega", "motor.torque"], T)
    data = heavy_four_bar(assembly={"B": [0.88, 0.48], "C": [3.0, 2.6]})
    # The coupler's angle over time as a spline through many values: exact where it is asked at its own knots.
    knots = np.linspace(-0.05, 1.05, 441)
    angles = at_crank.compiled.evaluate(["coupler.angle"], knots)[0]
    data["tables"] = {
        "swing": {"points": [[float(t), float(a)] for t, a in zip(knots, angles, strict=True)], "between": "quintic"}
    }
    data["drives"] = {"motor": {"turns": "coupler", "on": "frame", "position": "swing(t)"}}
    at_coupler = Run(compiled_from(data), 0.0, 1.0, 100)
    other = at_coupler.evaluate(["coupler.angle", "coupler.omega", "crank.omega", "motor.torque"], T)
    assert other[:3] == pytest.approx(found[:3], rel=1e-7, abs=1e-7)
    assert other[3] * other[1] == pytest.approx(found[3] * found[2], rel=1e-5, abs=1e-4)


def test_a_cylinder_that_keeps_a_bucket_level() -> None:
    """The bucket's angle is the output of its cylinder, whose force balances the moment about the bucket's pin."""
    run = Run(compiled_example("levelled_bucket"), 0.0, 4.0, 100)
    t = np.linspace(0.0, 4.0, 15)
    names = [
        "bucket.angle",
        "N.x",
        "N.y",
        "Q.x",
        "Q.y",
        "B.x",
        "B.y",
        "com(bucket).x",
        "com(bucket).y",
        "com(bucket).ax",
        "com(bucket).ay",
        "level.s",
        "level.v",
        "level.force",
        "N.vx",
        "N.vy",
        "Q.vx",
        "Q.vy",
    ]
    angle, nx, ny, qx, qy, bx, by, cx, cy, ax, ay, s, v, force, nvx, nvy, qvx, qvy = run.evaluate(names, t)
    assert angle == pytest.approx(0.0, abs=1e-12)
    n, q, b, c = (x + 1j * y for x, y in ((nx, ny), (qx, qy), (bx, by), (cx, cy)))
    along = (q - n) / np.abs(q - n)
    assert s == pytest.approx(np.abs(q - n), rel=1e-12)
    assert v == pytest.approx(np.real(np.conj(along) * (qvx - nvx + 1j * (qvy - nvy))), abs=1e-12)
    # Without the cylinder's own masses: the test takes them out of the file.
    data = light("levelled_bucket")
    force = Run(compiled_from(data), 0.0, 4.0, 100).evaluate(["level.force"], t)[0]
    weight = 1800 * (ax + 1j * (ay + 9.80665))
    needed = np.imag(np.conj(c - b) * weight)  # the bucket doesn't turn
    assert force * np.imag(np.conj(q - b) * along) == pytest.approx(needed, rel=1e-9)


def compiled_example(name: str) -> Any:
    compiled, findings = examine(lw.load(EXAMPLES / f"{name}.yaml"))
    assert compiled is not None, findings
    return compiled


def light(name: str) -> dict[str, Any]:
    from ruamel.yaml import YAML

    data: dict[str, Any] = YAML(typ="safe").load((EXAMPLES / f"{name}.yaml").read_text(encoding="utf-8"))
    for cylinder in data["cylinders"].values():
        cylinder.pop("barrel")
        cylinder.pop("rod")
    return {key: value for key, value in data.items() if key not in ("measures", "require", "studies")}


def codes(data: dict[str, Any]) -> list[str]:
    _, findings = examine(Document.model_validate(data))
    return [f.code for f in findings if f.severity == "error"]


@pytest.mark.parametrize(
    ("drives", "expected"),
    [
        ({"motor": {"turns": "piston", "on": "frame", "speed": 1, "start": 0}}, ["structure.drive-angle-fixed"]),
        (
            {"motor": {"moves": "rod", "at": "C", "on": "frame", "along": "F at 0", "speed": 1, "start": 3}},
            ["assembly.no-sketch"],
        ),
        (
            {
                "motor": {"turns": "crank", "on": "frame", "speed": 1, "start": 0},
                "more": {"turns": "rod", "on": "frame", "speed": 1, "start": 0},
            },
            ["structure.drive-too-many"],
        ),
        (
            {
                "motor": {"turns": "crank", "on": "frame", "speed": 1, "start": 0},
                "more": {"turns": "rod", "on": "crank", "speed": 1, "start": 0},
                "most": {"turns": "rod", "on": "frame", "speed": 1, "start": 0},
            },
            ["structure.drive-angle-fixed"],
        ),
    ],
)
def test_what_is_refused(drives: dict[str, Any], expected: list[str]) -> None:
    assert codes(slider_crank(drives=drives, assembly={})) == expected


@pytest.mark.parametrize(
    ("drive", "code"),
    [
        ({"moves": "coupler", "on": "frame", "position": 1}, "drive.point"),
        ({"turns": "coupler", "at": "B", "on": "frame", "position": 1}, "drive.point"),
        ({"moves": "coupler", "at": "B", "along": "A at 0", "position": 1}, "drive.on"),
        (
            {"moves": "coupler", "turns": "crank", "at": "B", "along": "A at 0", "on": "frame", "position": 1},
            "drive.kind",
        ),
        ({"moves": "coupler", "at": "X", "along": "A at 0", "on": "frame", "position": 1}, "name.unknown-point"),
        ({"moves": "coupler", "at": "B", "along": "X at 0", "on": "frame", "position": 1}, "name.unknown-point"),
    ],
)
def test_entries_that_are_wrong(drive: dict[str, Any], code: str) -> None:
    try:
        found = codes(four_bar(drives={"motor": drive}))
    except lw.ModelError as error:
        found = [f.code for f in error.findings]
    except ValueError as error:
        found = [str(error)]
    assert any(code in one for one in found), found


def test_several_groups_stay_in_closed_form() -> None:
    """A drive of an angle that no joint gives takes Newton for its own links alone."""
    data = four_bar()
    data["links"]["coupler"]["points"]["P"] = [1, 1]
    data["links"]["hand"] = {"points": {"P": [0, 0]}}
    data["drives"]["level"] = {"turns": "hand", "on": "rocker", "speed": 0, "start": 0}
    steps = decompose(Document.model_validate(data)).steps
    assert [getattr(step, "signature", "") for step in steps] == ["", "RRR", "R-A"]
    run = Run(compiled_from(data), 0.0, 7.0, 100)
    found = run.evaluate(["hand.omega", "rocker.omega"], np.linspace(0, 7, 30))
    assert found[0] == pytest.approx(found[1], abs=1e-12)
    assert certify(run).sound()
