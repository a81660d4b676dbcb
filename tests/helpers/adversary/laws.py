"""Cases of steps, motion laws and tables: peaks at joins and knots, on some cranks that don't touch each other."""

from __future__ import annotations

import math
import random
from itertools import pairwise
from typing import Any

import mpmath
import numpy as np
from mpmath import mpf

from helpers.adversary.cases import LENGTHS, RELATIVE, ROUNDS, SAMPLES, UNITS, Batch, Case, Wanted
from helpers.adversary.features import Draw
from helpers.adversary.trees import ROUND

# Of a rise of 1 in a time of 1: the highest speed, acceleration, jerk, and whether the lowest are their opposites.
# Jerks with an end in an infinite one are left out.
LAWS: dict[str, dict[str, tuple[float, float]]] = {
    "parabolic": {"omega": (0, 2), "alpha": (-4, 4)},
    "simple_harmonic": {"omega": (0, math.pi / 2), "alpha": (-(math.pi**2) / 2, math.pi**2 / 2)},
    "cycloidal": {
        "omega": (0, 2),
        "alpha": (-2 * math.pi, 2 * math.pi),
        "jerk": (-4 * math.pi**2, 4 * math.pi**2),
    },
    "poly_345": {"omega": (0, 1.875), "alpha": (-10 / math.sqrt(3), 10 / math.sqrt(3)), "jerk": (-30, 60)},
    "poly_4567": {"omega": (0, 35 / 16), "alpha": (-84 / (5 * math.sqrt(5)), 84 / (5 * math.sqrt(5)))},
}
UNIT = {"omega": "rad/s", "alpha": "rad/s^2", "jerk": "rad/s^3"}
STEEP = 400
"""How fast a law's highest rate changes by the share of the rise, at most: what carries the round-off of times on."""


def _document(cranks: int, length: float, samples: int) -> dict[str, Any]:
    names = [f"crank{i}" for i in range(cranks)]
    return {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"A": [0, 0]}},
            **{name: {"points": {"A": [0, 0], f"B{i}": [1, 0]}} for i, name in enumerate(names)},
        },
        "drives": {f"motor{i}": {"turns": name, "on": "frame", "position": "t/(1 s)"} for i, name in enumerate(names)},
        "windows": {},
        "measures": {},
        "studies": {"cycle": {"duration": f"{length!r} s", "samples": samples}},
    }


def _span(d: Draw) -> tuple[float, float]:
    """A stretch of w that begins or ends at an end of the run, on a sample or anywhere."""
    kind = d.pick("start", "end", "sample", "any", "any")
    if kind == "start":
        return 0.0, d.w
    if kind == "end":
        return d.length - d.w, d.length
    if kind == "sample":
        low = float(np.linspace(0, d.length, d.samples + 1)[d.source.randrange(d.samples)])
    else:
        low = d.uniform(0, 0.95) * d.length
    low = min(low, d.length - d.w)
    return low, low + d.w


def law_batch(seed: int, source: random.Random, count: int) -> Batch:
    """step5 and motion laws with one short rise."""
    length, samples, cranks = source.choice(LENGTHS), source.choice(SAMPLES), 6
    batch = Batch(seed, _document(cranks, length, samples))
    batch.document["laws"] = {}
    for i in range(cranks):
        d = Draw(source, length, samples)
        d.w = length * d.log(-7, -1)
        low, high = _span(d)
        rise, law = d.sign() * d.uniform(0.2, 2), d.pick("step5", *LAWS)
        took = mpf(high) - mpf(low)
        if law == "step5":
            position, rates = f"step5(t, {low!r} s, 0, {high!r} s, {rise!r})", LAWS["poly_345"]
        else:
            segments = [{"dwell": f"{low!r} s"}] if low > 0 else []
            segments += [{"rise": rise, "over": f"{float(took)!r} s", "law": law}]
            if (rest := length - low - float(took)) > 1e-9 * length:
                segments.append({"dwell": f"{rest!r} s"})
            batch.document["laws"][f"law{i}"] = {
                "over": "time", "of": "angle", "beyond": "hold", "segments": segments
            }  # fmt: skip
            position, rates = f"law{i}(t)", LAWS[law]
        batch.document["drives"][f"motor{i}"]["position"] = position
        for k, (rate, (least, most)) in enumerate(rates.items(), 1):
            size = mpf(rise) / took**k
            ends = sorted(float(size * factor) for factor in (least, most))
            slack = RELATIVE * (ends[1] - ends[0]) + ROUNDS * ROUND * length / float(took) * STEEP * abs(float(size))
            reduction = d.pick("extremes", "max", "min", "span")
            numbers = {
                "extremes": {"min": Wanted(ends[0], slack), "max": Wanted(ends[1], slack)},
                "max": {"": Wanted(ends[1], slack)},
                "min": {"": Wanted(ends[0], slack)},
                "span": {"": Wanted(ends[1] - ends[0], 2 * slack)},
            }[reduction]
            family = "step" if law == "step5" else "motion law"
            width = 0.3 * float(took)
            batch.add(Case(family, f"m{i}_{rate}", {reduction: f"motor{i}.{rate}"}, numbers, width, width / length))
    if not batch.document["laws"]:
        del batch.document["laws"]
    return batch


def table_batch(seed: int, source: random.Random, count: int) -> Batch:
    """Loads from tables with a narrow peak: linear ones with the peak at a knot, cubic ones with it beside."""
    length, samples, cranks = source.choice(LENGTHS), source.choice(SAMPLES), 10
    batch = Batch(seed, _document(cranks, length, samples))
    batch.document["tables"], batch.document["loads"] = {}, {}
    for i in range(cranks):
        d = Draw(source, length, samples)
        cubic = i % 3 == 2
        d.w = length * (d.log(-3.5, -1) if cubic else d.log(-7, -1))
        x, y = _knots(d, cubic)
        between = "cubic" if cubic else "linear"
        batch.document["tables"][f"table{i}"] = {
            "points": [[a, b] for a, b in zip(x, y, strict=True)],
            "between": between,
        }
        load = {"on": f"crank{i}", "torque": f"-table{i}(t/(1 s))"}
        batch.document["loads"][f"load{i}"] = load
        ends, mean, square = _spline(x, y, length) if cubic else _polygon(x, y)
        steep = max(abs(b - a) / (q - p) for (p, q), (a, b) in zip(pairwise(x), pairwise(y), strict=True))
        size = ends[1] - ends[0]
        slack = RELATIVE * size + ROUNDS * ROUND * (length * steep + 8 * size)
        if cubic:
            slack += 1e-8 * size  # a spline's equations lose digits where knots lie close
        reduction = d.pick("extremes", "extremes", "max", "min", "mean", "rms")
        numbers = {
            "extremes": {"min": Wanted(ends[0], slack), "max": Wanted(ends[1], slack)},
            "max": {"": Wanted(ends[1], slack)},
            "min": {"": Wanted(ends[0], slack)},
            "mean": {"": Wanted(mean, 1e-8 * math.sqrt(square) if cubic else RELATIVE * math.sqrt(square))},
            "rms": {"": Wanted(math.sqrt(square), (1e-8 if cubic else RELATIVE) * math.sqrt(square))},
        }[reduction]
        family = "cubic table" if cubic else "linear table"
        batch.add(Case(family, f"m{i}", {reduction: f"motor{i}.torque"}, numbers, d.w, d.w / length))
    return batch


def _knots(d: Draw, cubic: bool) -> tuple[list[float], list[float]]:
    kind = d.pick("middle", "middle", "sample", "start", "end")
    peak = d.sign() * d.uniform(1, 20)
    low = [d.uniform(-0.3, 0.3) for _ in range(4)]
    w = d.w
    if kind == "start" and not cubic:
        return [0.0, w, d.length], [peak, low[0], low[1]]
    if kind == "end" and not cubic:
        return [0.0, d.length - w, d.length], [low[0], low[1], peak]
    a = d.uniform(0.15, 0.85) * d.length
    if kind == "sample" and d.samples > 8:
        a = float(np.linspace(0, d.length, d.samples + 1)[d.source.randrange(d.samples // 4, 3 * d.samples // 4)])
    if cubic:  # the peak lies between the two knots in the middle
        x = [0.0, 0.5 * (a - w), a - w, a - 0.4 * w, a + 0.3 * w, a + w, 0.5 * (a + w + d.length), d.length]
        return x, [low[0], 0.0, low[1], peak, 0.9 * peak, low[2], 0.0, low[3]]
    return [0.0, a - w, a, a + d.uniform(0.5, 1) * w, d.length], [low[0], low[1], peak, low[2], low[3]]


def _polygon(x: list[float], y: list[float]) -> tuple[tuple[float, float], float, float]:
    """The least and greatest value of straight lines, their mean and mean square."""
    px, py = [mpf(v) for v in x], [mpf(v) for v in y]
    parts = [(p, q, a, b) for (p, q), (a, b) in zip(pairwise(px), pairwise(py), strict=True)]
    length = px[-1] - px[0]
    mean = sum((q - p) * (a + b) / 2 for p, q, a, b in parts) / length
    square = sum((q - p) * (a * a + a * b + b * b) / 3 for p, q, a, b in parts) / length
    return (min(y), max(y)), float(mean), float(square)


def _spline(x: list[float], y: list[float], length: float) -> tuple[tuple[float, float], float, float]:
    """The same of a cubic spline, its third derivative continuous at the second and the last but one knot."""
    n = len(x) - 1
    h = [mpf(b) - mpf(a) for a, b in pairwise(x)]
    rows, right = mpmath.matrix(n + 1, n + 1), mpmath.matrix(n + 1, 1)
    for i in range(1, n):  # the second derivatives m at the knots
        rows[i, i - 1], rows[i, i], rows[i, i + 1] = h[i - 1], 2 * (h[i - 1] + h[i]), h[i]
        right[i] = 6 * ((mpf(y[i + 1]) - y[i]) / h[i] - (mpf(y[i]) - y[i - 1]) / h[i - 1])
    rows[0, 0], rows[0, 1], rows[0, 2] = h[1], -(h[0] + h[1]), h[0]
    rows[n, n - 2], rows[n, n - 1], rows[n, n] = h[n - 1], -(h[n - 2] + h[n - 1]), h[n - 2]
    m = mpmath.lu_solve(rows, right)
    values, mean, square = [mpf(v) for v in y], mpf(0), mpf(0)
    for i in range(n):
        c3, c2 = (m[i + 1] - m[i]) / (6 * h[i]), m[i] / 2
        c1 = (mpf(y[i + 1]) - y[i]) / h[i] - h[i] * (2 * m[i] + m[i + 1]) / 6
        piece = [mpf(y[i]), c1, c2, c3]
        under = c2 * c2 - 3 * c3 * c1
        if under > 0 and c3 != 0:
            turning = [(-c2 + s * mpmath.sqrt(under)) / (3 * c3) for s in (-1, 1)]
            values += [sum(c * u**k for k, c in enumerate(piece)) for u in turning if 0 < u < h[i]]
        mean += sum(c * h[i] ** (k + 1) / (k + 1) for k, c in enumerate(piece))
        square += sum(
            c * e * h[i] ** (k + j + 1) / (k + j + 1) for k, c in enumerate(piece) for j, e in enumerate(piece)
        )
    return (float(min(values)), float(max(values))), float(mean / length), float(square / length)
