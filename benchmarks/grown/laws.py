"""Laws of drives and followers: every way in which a file states how a value goes on from its start."""

from __future__ import annotations

import random
from collections.abc import Callable
from typing import Any

from grown.plane import Data, Growing, rounded
from linkwright.laws import LAWS

MIRRORED = tuple(name for name, law in LAWS.items() if law.mirrored)
JUMPING = "constant_velocity"
Value = Callable[[], float]
"""A value at the start, known when all axes are."""


def law(g: Growing, start: Value, size: float, unit: str, full: bool = False) -> Data:
    """The keys of a drive that states its law: from ``start`` on by about ``size`` within a second; with ``full``, a
    turn a second is possible."""
    form = g.random.choice(FORMS)
    if full and g.random.random() < 0.6:
        form = _speed
        size = g.random.choice((360.0, -360.0))
    return form(g, start, size, unit)


def _speed(g: Growing, start: Value, size: float, unit: str) -> Data:
    return {"speed": size, "start": start}


def _acceleration(g: Growing, start: Value, size: float, unit: str) -> Data:
    return {"speed": rounded(size / 2), "acceleration": rounded(-size / 2), "start": start}


def _wave(g: Growing, start: Value, size: float, unit: str) -> Data:
    phase, turns = g.random.randrange(0, 360, 15), g.random.choice((1, 1, 2))
    wave = f"sin({turns}*360 deg*t/(1 s) + {phase} deg) - sin({phase} deg)"
    return {"position": lambda: f"{rounded(start())} {unit} + {size / 2} {unit}*({wave})"}


def _step(g: Growing, start: Value, size: float, unit: str) -> Data:
    begin, end = rounded(g.random.uniform(0, 0.3)), rounded(g.random.uniform(0.5, 1))
    step = f"step5(t, {begin} s, 0 {unit}, {end} s, {size} {unit})"
    return {"position": lambda: f"{rounded(start())} {unit} + {step}"}


def _table(g: Growing, start: Value, size: float, unit: str) -> Data:
    name = periodic(g, size, unit)
    shift = g.random.choice(("t", "t", "t + 0.25 s", "2*t"))
    before = "" if shift != "t + 0.25 s" else f" - {name}(0.25 s)"
    return {"position": lambda: f"{rounded(start())} {unit} + {name}({shift}){before}"}


def _motion(g: Growing, start: Value, size: float, unit: str) -> Data:
    name = motion_law(g, size, unit)
    called = "t" if g.section("laws")[name]["over"] == "time" else "360 deg*t/(1 s)"
    return {"position": lambda: f"{rounded(start())} {unit} + {name}({called})"}


FORMS = (_speed, _acceleration, _wave, _wave, _step, _step, _table, _motion, _motion)


def periodic(g: Growing, size: float, unit: str) -> str:
    """A table over a second that begins and ends with 0."""
    name, random_ = g.name("tab"), g.random
    values = [0.0, *(rounded(size * random_.uniform(-0.6, 0.6)) for _ in range(random_.randrange(4, 7))), 0.0]
    points = [[f"{rounded(i / (len(values) - 1))} s", f"{value} {unit}"] for i, value in enumerate(values)]
    g.section("tables")[name] = {"points": points, "period": "1 s"}
    if random_.random() < 0.5:
        g.section("tables")[name]["between"] = random_.choice(("cubic", "quintic"))
    return name


def motion_law(g: Growing, size: float, unit: str, over: str | None = None, rest: float = 0.0) -> str:
    """A motion law that begins and ends with 0: of a period of 360 deg or 1 s, with a dwell of a share ``rest`` first.
    Rises go up by ``size`` (down where it is negative)."""
    name = g.name("law")
    over = over or g.random.choice(("angle", "time"))
    whole = 360.0 if over == "angle" else 1.0
    per = "deg" if over == "angle" else "s"
    shares = [g.random.uniform(0.5, 1.5) for _ in range(4)]
    widths = [rest * whole] if rest else []
    widths += [share / sum(shares) * (1 - rest) * whole for share in shares]
    segments = ([{"dwell": f"{rounded(widths.pop(0))} {per}"}] if rest else []) + excursion(g, size, unit, widths, per)
    g.section("laws")[name] = {"over": over, "of": "angle" if unit == "deg" else "length", "segments": segments}
    if over == "time" and g.random.random() < 0.15:
        g.section("laws")[name]["beyond"] = g.random.choice(("repeat", "hold"))
    return name


def excursion(g: Growing, size: float, unit: str, widths: list[float], per: str) -> list[Data]:
    """Segments up and down again: ``widths`` of the rise, a dwell, the return, a dwell."""
    up, high, down, low = (f"{rounded(width)} {per}" for width in widths)
    height = f"{rounded(size)} {unit}"
    form = g.random.choice(SHAPES)
    made: list[Data] = form(g.random, height, up, down, per)
    if len(made) == 2 and "mirrored" not in form.__name__ and g.random.random() < 0.7:
        made.insert(1, {"dwell": high})
    else:
        low = f"{rounded(widths[1] + widths[3])} {per}"
        if "mirrored" in form.__name__:
            low = f"{rounded(widths[1] + widths[3] + widths[2] - widths[0])} {per}"
    return [*made, {"dwell": low}]


def _by_name(random_: random.Random, height: str, up: str, down: str, per: str) -> list[Data]:
    names = [name for name in LAWS if name not in MIRRORED and name != JUMPING]
    rise, fall = random_.choice(names), random_.choice(names)
    skew = {"skew": random_.choice((0.4, 0.6))} if random_.random() < 0.1 and LAWS[rise].symmetric else {}
    return [{"rise": height, "over": up, "law": rise, **skew}, {"fall": height, "over": down, "law": fall}]


def _mirrored(random_: random.Random, height: str, up: str, down: str, per: str) -> list[Data]:
    name = random_.choice(MIRRORED)
    return [{"rise": height, "over": up, "law": name}, {"fall": height, "over": up, "law": name}]


def _family(random_: random.Random, height: str, up: str, down: str, per: str) -> list[Data]:
    fractions = random_.choice(([0.3, 0.1, 0.4, 0.2], [0.25, 0.5, 0.25, 0], [0.5, 0, 0.5, 0]))
    powers = random_.choice(([3, 4, 5], [4, 5, 6, 7], [2, 3]))
    return [{"rise": height, "over": up, "fractions": fractions}, {"fall": height, "over": down, "powers": powers}]


def _formula(random_: random.Random, height: str, up: str, down: str, per: str) -> list[Data]:
    formula = random_.choice(("u - sin(360 deg*u)/(2*pi)", "10*u^3 - 15*u^4 + 6*u^5", "(1 - cos(180 deg*u))/2"))
    return [{"rise": height, "over": up, "formula": formula}, {"fall": height, "over": down, "law": "poly_345"}]


def _matched(random_: random.Random, height: str, up: str, down: str, per: str) -> list[Data]:
    match = random_.choice(("velocity", "acceleration", "jerk"))
    on_the_fly = {"rise": f"({height})/2", "over": f"({up})/2", "law": JUMPING}
    begin = {"rise": f"({height})/2", "over": f"({up})/2", "match": match}
    return [begin, on_the_fly, {"rise": f"-({height})", "over": down, "match": match}]


def _stated(random_: random.Random, height: str, up: str, down: str, per: str) -> list[Data]:
    via = {"via": [[f"({up})/2", f"({height})/2"]]} if random_.random() < 0.5 else {}
    if via and random_.random() < 0.5:
        via["spline"] = random_.choice(("cubic", "quintic"))
    ends = {"from": [0, 0], "to": [0, 0]} if via.get("spline") != "cubic" else {"from": [0], "to": [0]}
    return [{"rise": height, "over": up, **ends, **via}, {"rise": f"-({height})", "over": down, "from": [0], "to": [0]}]


def _spline(random_: random.Random, height: str, up: str, down: str, per: str) -> list[Data]:
    h = f"({height})"
    control = ["0*" + h, "0*" + h, "0*" + h, f"0.4*{h}", f"0.9*{h}", h, h, h]
    return [{"control": control, "over": up, "degree": random_.choice((4, 5))},
            {"control": [0, 0, 0, f"-0.6*{h}", f"-{h}", f"-{h}", f"-{h}"], "over": down, "degree": 4}]  # fmt: skip


SHAPES: tuple[Any, ...] = (_by_name, _by_name, _by_name, _mirrored, _family, _formula, _matched, _stated, _spline)
