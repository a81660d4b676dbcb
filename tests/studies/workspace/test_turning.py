"""Full turns of two drives: against closed forms, the paper's discriminant, and sampled positions by circles."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from helpers.compiled import compiled_from
from linkwright import load
from linkwright.compilation import compile_mechanism
from linkwright.graph.rows import Radicand, ReachRow
from linkwright.kernels import KERNELS, Compiled
from linkwright.studies.workspace.mesh import DriveBox
from linkwright.studies.workspace.sheet import ModeSheet
from linkwright.studies.workspace.turning import TurningValues, turnings

Array = NDArray[np.float64]
EXAMPLES = Path(__file__).parents[3] / "examples"
TURN = 2 * np.pi
ROUND = DriveBox((0.0, 0.0), (TURN, TURN), (True, True))
DRIVES = {
    "motor": {"turns": "crank1", "on": "frame", "speed": "1 rad/s", "start": "90 deg"},
    "servo": {"turns": "crank4", "on": "frame", "position": "60 deg"},
}
CRANKS = {
    "frame": {"points": {"O1": [0, 0], "O4": ["l5", 0]}},
    "crank1": {"points": {"O1": [0, 0], "B": ["l1", 0]}},
    "crank4": {"points": {"O4": [0, 0], "D": ["l4", 0]}},
}
FIVE_BAR = {
    **CRANKS,
    "link2": {"points": {"B": [0, 0], "C": ["l2", 0]}},
    "link3": {"points": {"D": [0, 0], "C": ["l3", 0], "P": [0.6, 0.5]}},
}
FIVE = {"l1": 0.8, "l2": 2.6, "l3": 2.8, "l4": 1.0, "l5": 3.0}


def model(
    links: Mapping[str, Any], parameters: Mapping[str, float], assembly: Mapping[str, str], **more: Any
) -> Compiled:
    drives = more.pop("drives", DRIVES)
    units = {"length": "m", "angle": "rad", "time": "s"}
    data = {"linkwright": 1, "units": units, "parameters": dict(parameters), "links": dict(links), "drives": drives}
    return compiled_from({**data, **({"assembly": dict(assembly)} if assembly else {}), **more})


def sheets(compiled: Compiled, point: str = "B", parameters: Array | None = None) -> list[ModeSheet]:
    """All modes."""
    signs = product((1.0, -1.0), repeat=len(compiled.graph.branched))
    return [ModeSheet(compiled, point, ("motor", "servo"), branches, parameters) for branches in signs]


@pytest.fixture(scope="module")
def five_bar() -> Compiled:
    return model(FIVE_BAR, FIVE, {"C": "left of B-D"})


def discriminant(lengths: Array, q1: Array, q4: Array) -> Array:
    """Of the paper's quadratic equation in tan(theta3/2), its condition (6): Peng and Zi, Journal of Mechanical
    Transmission 34(4), 2010, (5) and (6)."""
    l1, l2, l3, l4, l5 = lengths
    a = l1**2 + l3**2 + l4**2 + l5**2 - l2**2
    b = 2 * l4 * l5 * np.cos(q4) - 2 * l1 * l4 * np.cos(q4 - q1) - 2 * l1 * l5 * np.cos(q1)
    c = 2 * l3 * l4 * np.cos(q4) + 2 * l3 * l5 - 2 * l1 * l3 * np.cos(q1)
    d = 2 * l3 * l4 * np.sin(q4) - 2 * l1 * l3 * np.sin(q1)
    return np.asarray(4 * d**2 - 4 * (a + b + c) * (a + b - c))


def independent(lengths: Array) -> NDArray[np.bool_]:
    """Whether both cranks turn fully and independently: the couplers span the least and the largest distance of their
    outer pins, three vectors of fixed lengths and any directions apart."""
    l1, l2, l3, l4, l5 = lengths
    total, longest = l1 + l4 + l5, np.maximum(np.maximum(l1, l4), l5)
    least = np.maximum(0.0, 2 * longest - total)
    return np.asarray((total <= l2 + l3) & (least >= np.abs(l2 - l3)))


def where(lengths: Array, drive: str) -> list[tuple[float, float]]:
    """The values of the other drive at which a drive of the five-bar turns fully: with r its crank and e the distance
    of its pivot from the other crank's end, the outer pins are between |e - r| and e + r apart."""
    l1, l2, l3, l4, l5 = lengths.tolist()
    r, s, sign = (l1, l4, 1.0) if drive == "motor" else (l4, l1, -1.0)
    bounds = [(0.0, min(r - abs(l2 - l3), l2 + l3 - r)), (r + abs(l2 - l3), l2 + l3 - r)]
    found: list[tuple[float, float]] = []
    for low, high in bounds:
        # e^2 = s^2 + l5^2 + 2 s l5 cos q; from the other side of the frame the cosine has the other sign
        least, most = (sign * (max(e, 0.0) ** 2 - s**2 - l5**2) / (2 * s * l5) for e in (low, high))
        least, most = min(least, most), max(least, most)
        if high < low or least > 1 or most < -1:
            continue
        a, b = (float(np.arccos(np.clip(c, -1, 1))) for c in (most, least))
        if a == 0 and b == np.pi:
            return [(0.0, TURN)]
        if a == 0:
            found.append((TURN - b, TURN + b))
        elif b == np.pi:
            found.append((a, TURN - a))
        else:
            found += [(a, b), (TURN - b, TURN - a)]
    return sorted(found)


def of(found: list[TurningValues], drive: str) -> TurningValues:
    (one,) = [turning for turning in found if turning.drive == drive]
    return one


def test_the_room_is_the_paper_s_discriminant(five_bar: Compiled) -> None:
    """Delta = 4 (l2 + l3)^2 room, at any lengths and angles, also where it doesn't close; so is the reach,
    16 d^2 (l2^2 + l3^2) reach with d the distance of the outer pins."""
    rng = np.random.default_rng(1)
    group = five_bar.structure.groups[0].label
    engine = KERNELS["numpy"](five_bar.graph.program([Radicand(group), ReachRow(group)]))
    for _ in range(5):
        lengths, q = rng.uniform(0.5, 3, 5), rng.uniform(0, TURN, (2, 200))
        sheet = sheets(five_bar, parameters=lengths)[0]
        room, reach = engine.run(sheet.inputs(q), lengths)
        l1, l2, l3, l4, l5 = lengths
        d = np.abs(l5 + l4 * np.exp(1j * q[1]) - l1 * np.exp(1j * q[0]))
        expected = discriminant(lengths, *q)
        assert np.allclose(4 * (l2 + l3) ** 2 * room, expected, rtol=0, atol=1e-11 * np.abs(expected).max())
        assert np.allclose(16 * d**2 * (l2**2 + l3**2) * reach, expected, rtol=0, atol=1e-11 * np.abs(expected).max())


def test_independent_full_turns_of_random_five_bars() -> None:
    """The closed form says the same as the paper's discriminant at its worst angles, for 10^5 five-bars; the paper's
    condition on the lengths implies it, and not conversely."""
    rng = np.random.default_rng(2)
    lengths = rng.uniform(0.1, 1, (5, 100_000))
    lengths[1:3, ::2] += 0.5  # else few turn
    lengths[2, ::4] = lengths[1, ::4]
    expected = independent(lengths)
    l1, _, _, l4, l5 = lengths
    # The pins are farthest and nearest with the cranks along the frame, or nearest where both ends can meet.
    with np.errstate(invalid="ignore"):
        meet = [
            np.arccos((l1**2 + l5**2 - l4**2) / (2 * l1 * l5)),
            np.pi - np.arccos((l4**2 + l5**2 - l1**2) / (2 * l4 * l5)),
        ]
    places = [np.zeros((2, l1.size)) + np.array(two)[:, None] for two in product((0.0, np.pi), repeat=2)]
    worst = np.fmin.reduce([discriminant(lengths, *q) for q in [*places, np.array(meet)]])
    assert ((worst >= -1e-13) == expected).all()
    for _ in range(10):
        assert (discriminant(lengths[:, expected], *rng.uniform(0, TURN, (2, expected.sum()))) >= 0).all()

    ordered = np.sort(lengths, axis=0)
    shorter = ordered[4] + ordered[0] + ordered[1] < ordered[2] + ordered[3]
    paper = shorter & (l5 == ordered[4]) & (np.maximum(l1, l4) == ordered[1])
    assert 100 < paper.sum() < expected.sum() < lengths.shape[1] / 2
    assert expected[paper].all() and (expected & ~paper).sum() > 1000


def test_intervals_of_random_five_bars(five_bar: Compiled) -> None:
    """Every end to 1e-9 rad as in closed form, for both drives; and whole where both turn independently."""
    rng = np.random.default_rng(3)
    counts: set[int] = set()
    for i in range(12):
        lengths = rng.uniform(0.4, 1.2, 5) * (1, 1.5, 1.5, 1, 1.5) if i else np.array(list(FIVE.values()))
        found = turnings(sheets(five_bar, parameters=lengths), ROUND)
        assert [one.mode for one in found] == [{}, {}]  # the same in both modes
        for one in found:
            assert one.whole == independent(lengths)
            expected = where(lengths, one.drive)
            assert len(one.intervals) == len(expected)
            counts.add(len(expected))
            assert np.allclose(one.intervals, expected, rtol=0, atol=1e-9) or one.whole
    assert counts >= {0, 1, 2}


@pytest.mark.parametrize(
    "lengths",
    [(0.8, 2.3, 2.6, 1.1, 3.0), (0.1, 0.7, 0.8, 0.3, 1.1), (0.8, 2.0, 3.2, 1.0, 3.0), (0.8, 2.4, 2.4, 1.0, 3.0)],
)
def test_change_points_are_no_ends(five_bar: Compiled, lengths: tuple[float, ...]) -> None:
    """Where the modes only meet, by equality in one of the two conditions, the drives go on; one coupler by 1e-9
    shorter, and they don't."""
    at = np.array(lengths)
    assert all(one.whole for one in turnings(sheets(five_bar, parameters=at), ROUND))
    shorter = turnings(sheets(five_bar, parameters=at - [0, 1e-9, 0, 0, 0]), ROUND)
    assert not any(one.whole for one in shorter) and all(one.intervals for one in shorter)


def test_pins_that_nearly_meet(five_bar: Compiled) -> None:
    """Couplers that differ by 1e-5 of their length: the motor can't turn within 1e-5 rad of where the pins meet."""
    lengths = np.array([1.0, 1.2, 1.20001, 1.0, 1.0])
    found = of(turnings(sheets(five_bar, parameters=lengths), ROUND), "motor")
    assert len(found.intervals) == 3
    assert np.allclose(found.intervals, where(lengths, "motor"), rtol=0, atol=1e-9)


def along(first: str, second: str, *points: str) -> dict[str, Any]:
    return {"prismatic": [first, second], "line": [f"{point} at 0 deg" for point in points]}


def test_a_rod_to_a_slider_on_the_other_crank() -> None:
    """RRP: the rod's pin is at most l1 + l5 |sin q| off the servo's line; at least the distance of B from O4."""
    links = {**CRANKS, "link2": {"points": {"B": [0, 0], "C": ["l2", 0]}}, "block": {"points": {"C": [0, 0]}}}
    rail = {"guide": along("crank4", "block", "O4", "C")}
    lengths = {"l1": 1.0, "l2": 2.0, "l4": 1.0, "l5": 1.5}
    found = turnings(sheets(model(links, lengths, {"C": "ahead of B along guide"}, joints=rail)), ROUND)
    a, b = np.arcsin(2 / 3), np.arccos((1 + 2.25 - 4) / 3)
    expected = [(np.pi - a, np.pi + a), (TURN - a, TURN + a)]
    assert np.allclose(of(found, "motor").intervals, expected, rtol=0, atol=1e-12)
    assert np.allclose(of(found, "servo").intervals, [(TURN - b, TURN + b)], rtol=0, atol=1e-12)


def test_links_that_slide_on_each_other() -> None:
    """RPR: the pins of the cranks stay farther apart than the slide is off them."""
    links = {**CRANKS, "rod": {"points": {"B": [0, 0]}}, "tube": {"points": {"D": [0, 0], "T": [0, 0.2]}}}
    lengths = {"l1": 1.0, "l4": 1.0, "l5": 1.5}
    compiled = model(links, lengths, {"D": "ahead of B along slide"}, joints={"slide": along("rod", "tube", "B", "T")})
    a, b = np.arccos((1.2**2 - 3.25) / 3), np.arccos((0.8**2 - 3.25) / 3)
    expected = [(b, TURN - b), (TURN - a, TURN + a)]
    assert np.allclose(of(turnings(sheets(compiled), ROUND), "motor").intervals, expected, rtol=0, atol=1e-12)


def test_lines_that_become_parallel() -> None:
    """PRP: a block slides on both cranks; at every value of the servo the motor meets its direction, and the block runs
    away. Within less than a half turn apart it doesn't."""
    links = {**CRANKS, "a": {"points": {"C": [0, 0]}}, "b": {"points": {"C": [0, 0]}}}
    rails = {"first": along("crank1", "a", "O1", "C"), "second": along("crank4", "b", "O4", "C")}
    compiled = model(links, {"l1": 1.0, "l4": 1.0, "l5": 1.5}, {}, joints=rails)
    assert [one.intervals for one in turnings(sheets(compiled), ROUND)] == [(), ()]
    part = DriveBox((1.0, 0.0), (2.0, TURN), (False, True))
    expected = [(2.0, 1 + np.pi), (2 + np.pi, 1 + TURN)]
    found = turnings(sheets(compiled), part)
    assert np.allclose(of(found, "motor").intervals, expected, rtol=0, atol=1e-9)
    assert of(found, "servo").intervals == ()


def test_an_arm_turns_whatever_it_does() -> None:
    """No group can't close where there is none."""
    links = {name: CRANKS[name] for name in ("frame", "crank1")} | {"crank4": {"points": {"B": [0, 0], "P": [1, 0]}}}
    drives = {"motor": DRIVES["motor"], "servo": {**DRIVES["servo"], "on": "crank1"}}
    compiled = model(links, {"l1": 1.0, "l5": 2.0}, {}, drives=drives)
    found = turnings([ModeSheet(compiled, "P", ("motor", "servo"), ())], ROUND)
    assert [(one.whole, one.intervals) for one in found] == [(True, ((0.0, TURN),))] * 2


def test_limited_ranges(five_bar: Compiled) -> None:
    """A servo with a range: its intervals end there; a motor with one needs to go through that only."""
    lengths = np.array([0.8, 2.2, 2.4, 1.0, 3.0])
    end = np.arccos((3.8**2 - 10) / 6)
    servo = DriveBox((0.0, 0.0), (TURN, 1.0), (True, False))
    motor = of(turnings(sheets(five_bar, parameters=lengths), servo), "motor")
    assert np.allclose(motor.intervals, [(end, 1.0)], rtol=0, atol=1e-12) and not motor.whole
    ahead = DriveBox(
        (-0.5, 0.0), (0.5, TURN), (False, True)
    )  # the crank points at the other one: far less is to be spanned
    assert of(turnings(sheets(five_bar, parameters=lengths), ahead), "motor").whole


def circles(p: Array, q: Array, r1: float, r2: float, sign: float) -> Array:
    """The point left (+1) of the line from p to q at these distances from them, NaN where there is none."""
    d = np.abs(q - p)
    along = (r1**2 - r2**2 + d**2) / (2 * d)
    with np.errstate(invalid="ignore"):
        return np.asarray(p + (q - p) / d * (along + 1j * sign * np.sqrt(r1**2 - along**2)))


def test_modes_apart() -> None:
    """Where a rocker hung on the five-bar's coupler closes depends on the mode of the five-bar, not on its own. Against
    positions by circles at 4000 values of the drive that turns."""
    links = {
        **FIVE_BAR,
        "frame": {"points": {"O1": [0, 0], "O4": ["l5", 0], "O6": [1.5, 1.5]}},
        "link5": {"points": {"P": [0, 0], "Q": [1.3, 0]}},
        "link6": {"points": {"O6": [0, 0], "Q": [1.9, 0]}},
    }
    found = turnings(sheets(model(links, FIVE, {"C": "left of B-D", "Q": "left of P-O6"}), "Q"), ROUND)
    assert [one.mode for one in found] == [{"link2-link3": 1}, {"link2-link3": -1}] * 2
    assert [len(one.intervals) for one in found] == [1, 1, 1, 0]
    circle = np.linspace(0, TURN, 4001)

    def closes(one: TurningValues, value: float) -> bool:
        q1, q2 = (circle, np.full(4001, value))[:: 1 if one.drive == "motor" else -1]
        b, d = FIVE["l1"] * np.exp(1j * q1), FIVE["l5"] + FIVE["l4"] * np.exp(1j * q2)
        p = d + (circles(b, d, FIVE["l2"], FIVE["l3"], one.mode["link2-link3"]) - d) / FIVE["l3"] * (0.6 + 0.5j)
        return bool(np.isfinite(circles(p, np.full(4001, 1.5 + 1.5j), 1.3, 1.9, 1.0)).all())

    for one in found:
        assert not one.whole
        for low, high in one.intervals:
            assert [closes(one, end + off) for end in (low, high) for off in (-1e-5, 1e-5)] == [
                False,
                True,
                True,
                False,
            ]
        for value in np.linspace(0.01, TURN, 60):
            inside = any(low <= q <= high for low, high in one.intervals for q in (value, value + TURN))
            assert closes(one, value) == inside


def test_the_example_with_a_partial_interval() -> None:
    """l1 + l4 + l5 = 48 > l2 + l3 = 46 mm: the motor turns where the servo's pin is at most 38 mm from its pivot."""
    compiled = compile_mechanism(load(EXAMPLES / "five_bar_partial.yaml"))
    motor = of(turnings(sheets(compiled, "P"), ROUND), "motor")
    end = np.degrees(np.arccos((38**2 - 30**2 - 10**2) / (2 * 10 * 30)))
    entry = motor.as_dict(compiled.quantities)
    (interval,) = entry.pop("intervals")
    assert np.allclose(interval, [end, 360 - end], rtol=0, atol=1e-9)
    assert entry == {"drive": "motor", "other": "servo", "mode": {}, "unit": "deg", "whole": False}
    values = np.degrees(compiled.evaluate(["servo.angle"], np.linspace(0, 4, 401))[0])
    assert end < values.min() and values.max() < 360 - end  # the file's law stays there
