"""Results transform as they must when the mechanism is turned, moved, mirrored, enlarged, renamed or rewritten."""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from typing import Any

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from helpers import plain as p
from helpers.compiled import compiled_of, regular
from helpers.plain import FRAME, Plain, Writer
from helpers.random_mechanisms import DURATION, mechanisms
from linkwright.kernels import Compiled
from linkwright.model.signals import Signal

Array = NDArray[np.float64]
T = np.linspace(0.0, DURATION, 3)
VECTORS = {"point", "com", "force", "shaking"}


def signals_of(compiled: Compiled) -> list[Signal]:
    """All signals but the arm of a slide's force, a quotient that may be anything where the force is nil."""
    return [s for s in compiled.quantities.signals.all() if s.attribute != "arm"]


def rows_of(compiled: Compiled) -> dict[str, Array]:
    names = [signal.text for signal in signals_of(compiled)]
    return dict(zip(names, compiled.evaluate(names, T), strict=True))


def other_axis(signal: Signal) -> str:
    """The name of a vector's other component."""
    last = {"x": "y", "y": "x"}[signal.attribute[-1]]
    return signal.text[:-1] + last


def component(signal: Signal) -> str:
    """x or y for a component of a vector, else nothing."""
    return signal.attribute[-1] if signal.kind in VECTORS and signal.attribute[-1] in "xy" else ""


def compare(
    base: Compiled,
    other: Compiled,
    expected: Callable[[Signal, dict[str, Array]], Array],
    tolerance: float = 1e-9,
    name: Callable[[str], str] = lambda text: text,
) -> None:
    """Every signal of ``other`` against what ``expected`` makes of the base's rows, to 1e-9 of the row or its peers."""
    rows = rows_of(base)
    signals = signals_of(base)
    found = other.evaluate([name(signal.text) for signal in signals], T)
    force = max(float(np.abs(rows[s.text]).max()) for s in signals if s.kind in ("force", "shaking", "drive"))
    for signal, row in zip(signals, found, strict=True):
        wanted = expected(signal, rows)
        error = np.abs(row - wanted)
        if signal.attribute == "angle":
            error = np.abs(np.remainder(row - wanted + np.pi, 2 * np.pi) - np.pi)
        statics = signal.kind in ("force", "shaking") or signal.attribute in ("torque", "force", "power")
        scale = max(1.0, float(np.abs(wanted).max()), 10 * force if statics else 0.0)
        assert error.max() < tolerance * scale, signal.text


def start(data: Any) -> tuple[Plain, Compiled]:
    plain = data.draw(mechanisms())
    compiled = compiled_of(plain)
    regular(compiled, T)
    return plain, compiled


@settings(max_examples=20)
@given(st.data())
def test_rotation_in_the_plane(data: Any) -> None:
    plain, base = start(data)
    angle = data.draw(st.sampled_from((0.5, -2.2, math.pi / 2)))
    c, s = math.cos(angle), math.sin(angle)

    def expected(signal: Signal, rows: dict[str, Array]) -> Array:
        row = rows[signal.text]
        if axis := component(signal):
            return c * row + (-s if axis == "x" else s) * rows[other_axis(signal)]
        if signal.attribute != "angle":
            return row
        if signal.kind == "drive":
            drive = plain.drives[signal.owners[0]]
            return row + angle * ((drive.on == FRAME) - (drive.link == FRAME))
        return row + angle

    compare(base, compiled_of(p.rotated(plain, angle)), expected)


@settings(max_examples=20)
@given(st.data())
def test_translation(data: Any) -> None:
    plain, base = start(data)
    dx, dy = data.draw(st.tuples(st.floats(-3, 3), st.floats(-3, 3)))
    weight = sum(plain.mass(link)[0] for link in plain.moving)
    gx, gy = plain.gravity or (0.0, 0.0)

    def expected(signal: Signal, rows: dict[str, Array]) -> Array:
        row = rows[signal.text]
        if signal.kind in ("point", "com") and signal.attribute in "xy":
            return row + (dx if signal.attribute == "x" else dy)
        if signal.text == "shaking.moment":
            return row + dx * rows["shaking.y"] - dy * rows["shaking.x"]
        if signal.text == "energy.potential":
            return row - weight * (gx * dx + gy * dy)
        return row

    compare(base, compiled_of(p.translated(plain, (dx, dy))), expected)


@settings(max_examples=20)
@given(st.data())
def test_reflection(data: Any) -> None:
    """y to -y: angles, rates of turn, torques and moments change sign, and left becomes right."""
    plain, base = start(data)
    turning = {"angle", "omega", "alpha", "jerk", "torque", "moment", "normal"}

    def expected(signal: Signal, rows: dict[str, Array]) -> Array:
        odd = signal.attribute in turning or component(signal) == "y"
        return -rows[signal.text] if odd else rows[signal.text]

    compare(base, compiled_of(p.mirrored(plain)), expected)


@settings(max_examples=20)
@given(st.data())
def test_scale(data: Any) -> None:
    """All lengths k times as long, times kept: forces k times as large, torques and powers k squared."""
    plain, base = start(data)
    k = data.draw(st.sampled_from((0.001, 0.3, 7.0)))
    squared = {"moment", "torque", "power", "kinetic", "potential"}
    kept = {"angle", "omega", "alpha", "jerk"}

    def expected(signal: Signal, rows: dict[str, Array]) -> Array:
        power = 2 if signal.attribute in squared else 0 if signal.attribute in kept else 1
        return rows[signal.text] * k**power

    other = compiled_of(p.scaled(plain, k))

    def unscaled(signal: Signal, rows: dict[str, Array]) -> Array:
        return expected(signal, rows)

    compare(base, other, unscaled)


@settings(max_examples=20)
@given(st.data())
def test_units_of_the_file(data: Any) -> None:
    """The same mechanism written in millimetres, inches, degrees, pounds, minutes; with parameters and arithmetic."""
    plain, base = start(data)
    units = {
        "length": data.draw(st.sampled_from(("m", "mm", "cm", "inch"))),
        "angle": data.draw(st.sampled_from(("rad", "deg"))),
        "mass": data.draw(st.sampled_from(("kg", "g", "lb"))),
        "time": data.draw(st.sampled_from(("s", "ms", "min"))),
        "force": data.draw(st.sampled_from(("N", "kN", "lbf"))),
        "torque": data.draw(st.sampled_from(("N*m", "N*mm"))),
    }
    writer = Writer(units, random.Random(data.draw(st.integers(0, 10**6))).randrange)
    compare(base, compiled_of(plain, writer.document), lambda signal, rows: rows[signal.text])


@settings(max_examples=15)
@given(st.data())
def test_names_do_not_matter(data: Any) -> None:
    plain, base = start(data)
    alphabet = {"L": "zahn", "P": "Gelenk", "S": "轨", "M": "moteur", "F": "load", "Q": "q_", "K": "k", "O": "o"}

    def new(name: str) -> str:
        return f"{alphabet[name[0]]}_{name[1:]}" if name[0] in alphabet else name

    import re

    def text(name: str) -> str:
        return re.sub(r"\b[LPSMQKO]\w*", lambda m: new(m.group()), name)

    compare(base, compiled_of(p.renamed(plain, new)), lambda signal, rows: rows[signal.text], name=text)


@settings(max_examples=20)
@given(st.data())
def test_the_order_of_the_file_does_not_matter(data: Any) -> None:
    plain, base = start(data)
    shuffle = random.Random(data.draw(st.integers(0, 10**6)))

    def order(names: list[str]) -> list[str]:
        return shuffle.sample(names, len(names))

    compare(base, compiled_of(p.reordered(plain, order)), lambda signal, rows: rows[signal.text])
