"""Springs and varying loads at random: as sections of a model file in SI, and as forces for the oracle."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from helpers.newton_euler import Extra, Oracle, State
from helpers.plain import FRAME, XY, Plain, turned
from helpers.random_mechanisms import Source

Array = NDArray[np.float64]
Acting = tuple[dict[str, Any], list[Extra], list[tuple[tuple[str, str], tuple[str, str]]]]
"""Sections of a model file, the same as forces, and the ends of the springs between points."""


def acting(plain: Plain, source: Source, springs: int = 2, loads: int = 2) -> Acting:
    """Springs of any law, loads of any kind."""
    sections: dict[str, Any] = {"springs": {}, "loads": {}, "tables": {}, "windows": {}}
    extra: list[Extra] = []
    ends: list[tuple[tuple[str, str], tuple[str, str]]] = []
    for i in range(springs):
        make = _twist if source.pick((False, False, True)) else _pull
        entry, force, both = make(plain, source, sections["tables"], f"T{i}")
        sections["springs"][f"K{i}"] = entry
        extra.append(force)
        ends += both
    for i in range(loads):
        entry, force = _load(plain, source, sections, f"V{i}")
        sections["loads"][f"V{i}"] = entry
        extra.append(force)
    return {name: section for name, section in sections.items() if section}, extra, ends


def _where(plain: Plain, link: str, point: str) -> XY:
    x, y, angle = plain.start[link]
    dx, dy = turned(plain.links[link].points[point], angle)
    return x + dx, y + dy


def _pull(plain: Plain, source: Source, tables: dict[str, Any], table: str) -> Any:
    places = [(link, p) for link, entry in plain.links.items() for p in entry.points]
    a = source.pick(places)
    far = [b for b in places if b[0] != a[0] and math.dist(_where(plain, *a), _where(plain, *b)) > 0.4]
    b = source.pick(far) if far else next(b for b in places if b[0] != a[0])
    length = math.dist(_where(plain, *a), _where(plain, *b))
    entry: dict[str, Any] = {"from": a[1], "to": b[1], "in": [a[0], b[0]]}
    law, damping = _law(source, entry, tables, table, length, "force"), 0.0
    if law is None or source.pick((False, True)):
        damping = entry["damping"] = source.uniform(0.5, 20.0)

    def force(oracle: Oracle, s: State) -> list[tuple[str, Array, Array, float]]:
        places = [oracle.point(s.q, *end) for end in (a, b)]
        speeds = [oracle.velocity(s, link, plain.links[link].points[p]) for link, p in (a, b)]
        gap = places[1] - places[0]
        along = gap / np.linalg.norm(gap)
        pull = damping * float(along @ (speeds[1] - speeds[0])) + (law(float(np.linalg.norm(gap))) if law else 0.0)
        return [(a[0], pull * along, places[0], 0.0), (b[0], -pull * along, places[1], 0.0)]

    return entry, force, [(a, b)]


def _twist(plain: Plain, source: Source, tables: dict[str, Any], table: str) -> Any:
    turns = source.pick(plain.moving)
    on = source.pick([link for link in plain.links if link != turns])
    there = plain.start[turns][2] - plain.start[on][2]
    entry: dict[str, Any] = {"turns": turns, "on": on}
    law, damping = _law(source, entry, tables, table, there, "torque"), 0.0
    if law is None or source.pick((False, True)):
        damping = entry["damping"] = source.uniform(0.5, 5.0)

    def force(oracle: Oracle, s: State) -> list[tuple[str, Array, Array, float]]:
        (_, _, angle), (_, _, base) = oracle.pose(s.q, turns), oracle.pose(s.q, on)
        rate = oracle.pose(s.v, turns)[2] - oracle.pose(s.v, on)[2]
        torque = damping * rate + (law(angle - base) if law else 0.0)
        return [(turns, np.zeros(2), np.zeros(2), -torque), (on, np.zeros(2), np.zeros(2), torque)]

    return entry, force, []


def _law(source: Source, entry: dict[str, Any], tables: dict[str, Any], table: str, at: float, effort: str) -> Any:
    """The law of a spring near a length or angle, put into its entry; None for a damper alone."""
    way = source.pick(("linear", "linear", "table", "gas", "none"))
    if way == "gas" and effort == "force":
        n, r, push = source.pick((1.0, 1.3)), source.uniform(1.1, 1.8), source.uniform(5.0, 40.0)
        low, high = 0.4 * at, 1.9 * at
        entry |= {"gas": push, "progression": r, "length": [low, high]} | ({} if n == 1.0 else {"exponent": n})
        # p V^n from the two ends: volumes over the rod's section.
        big = (high - low) / (1 - r ** (-1 / n))
        return lambda x: -push * (big / (big - high + x)) ** n
    if way == "table":
        x = at + np.linspace(-3.0, 5.0, 9) + (0.0 if effort == "torque" else max(0.0, 3.0 - at))
        y = [source.uniform(-20.0, 20.0) for _ in x]
        between = source.pick(("linear", "cubic"))
        unit = "m" if effort == "force" else "rad"
        value = "N" if effort == "force" else "N*m"
        points = [[f"{float(a)!r} {unit}", f"{b!r} {value}"] for a, b in zip(x, y, strict=True)]
        tables[table] = {"points": points, "between": between}
        entry[effort] = table
        spline = CubicSpline(x, y)
        return lambda v: float(np.interp(v, x, y) if between == "linear" else spline(v))
    if way == "linear":
        k, preload = source.uniform(1.0, 50.0), source.pick((0.0, 0.0, 4.0))
        free = at + source.uniform(-0.9, 0.9) if effort == "torque" else max(0.0, at + source.uniform(-2.0, 0.9))
        entry |= {"stiffness": k, "free": free} | ({"preload": preload} if preload else {})
        return lambda x: preload + k * (x - free)
    return None


def _load(plain: Plain, source: Source, sections: dict[str, Any], name: str) -> Any:
    link = source.pick(plain.moving)
    point = source.pick(list(plain.links[link].points))
    drive = source.pick(list(plain.drives))
    law, attribute = plain.drives[drive].law, "angle" if plain.drives[drive].kind == "turns" else "s"
    rate = "omega" if attribute == "angle" else "v"
    unit = "rad" if attribute == "angle" else "m"
    c, d = source.uniform(-20.0, 20.0), source.uniform(-8.0, 8.0)
    local = plain.links[link].points[point]

    def speed(oracle: Oracle, s: State) -> Array:
        return oracle.velocity(s, link, local)

    # The first point of that name is the one that a signal is read off; on a pin it moves alike.
    ways: dict[str, tuple[str, Any]] = {
        "time": (f"{c!r} N*sin(3 rad/s*t) + {d!r} N/s*t", lambda o, s: c * math.sin(3 * s.t) + d * s.t),
        "speed": (f"{-abs(c)!r} N*s/m*{point}.vx + {d!r} N", lambda o, s: -abs(c) * speed(o, s)[0] + d),
        "rate": (
            f"{c!r} N*s/{unit}*{drive}.{rate}*step5(t, 0.1 s, 0, 0.3 s, 1)",
            lambda o, s: c * law(s.t, 1) * _step((s.t - 0.1) / 0.2),
        ),
        "place": (
            f"min({c!r} N/m*{point}.y, {d!r} N) + 2 N/m*abs({point}.x)",
            lambda o, s: min(c * o.at(s.q, link, local)[1], d) + 2 * abs(o.at(s.q, link, local)[0]),
        ),
        "angle": (f"{c!r} N*cos(2*{link}.angle)", lambda o, s: c * math.cos(2 * o.pose(s.q, link)[2])),
    }
    x = law(0.0) + np.linspace(-1.5, 1.5, 7)
    y = [source.uniform(-20.0, 20.0) for _ in x]
    points = [[f"{float(a)!r} {unit}", f"{b!r} N"] for a, b in zip(x, y, strict=True)]
    ways["table"] = (f"{name}T({drive}.{attribute})", lambda o, s: float(np.interp(law(s.t), x, y)))
    way = source.pick(list(ways))
    if way == "table":
        sections["tables"][f"{name}T"] = {"points": points, "between": "linear"}
    text, value = ways[way]
    entry: dict[str, Any] = {"on": link, "at": point, "force": [text, f"0.5*({text})"]}
    turning = source.pick((False, True))
    if turning:
        entry["in"] = link
    window: tuple[float, float] | None = None
    if source.pick((False, False, True)):
        window = (0.07, 0.23)
        sections["windows"][f"{name}W"] = list(window)
        entry["window"] = f"{name}W"

    def force(oracle: Oracle, s: State) -> list[tuple[str, Array, Array, float]]:
        size = float(value(oracle, s)) if window is None or window[0] <= s.t <= window[1] else 0.0
        vector = size * np.array([1.0, 0.5])
        if turning:
            vector = oracle.arm(s.q, link, tuple(vector))
        return [(link, vector, oracle.at(s.q, link, local), 0.0)]

    return entry, force


def _step(u: float) -> float:
    u = min(max(u, 0.0), 1.0)
    return 10 * u**3 - 15 * u**4 + 6 * u**5


def apart(oracle: Oracle, states: list[State], ends: Any) -> float:
    """The smallest length of the springs between points."""
    lengths = [float(np.linalg.norm(oracle.point(s.q, *a) - oracle.point(s.q, *b))) for s in states for a, b in ends]
    return min(lengths, default=1.0)


__all__ = ["FRAME", "acting", "apart"]
