"""Straight-line linkages and a dwell: facts of paths against the literature and closed forms.

Hoecken's linkage: R. L. Norton, Design of Machinery, table 3-1 ("Link ratios for smallest attainable errors in
straightness and velocity for various crank-angle ranges of a Hoeken-type fourbar approximate straight-line
linkage"): the range of the crank, L1/L2 and L3/L2 (= L4/L2, the coupler's point at 2 L3 from the crank's pin), the
length of the line over L2, and its largest error of straightness in percent of that length. The rows were carried
over without the book at hand; the lengths, which follow from the ratios, agree in all nine to the last digit. The
error is compared to half a unit of its last digit, or 2 % where the ratios' own three decimals count for more. It is
left out where the figure at hand has one digit only that the ratios don't bear out (20, 80 and 100 deg).

Chebyshev's lambda linkage 1 : 2 : 2.5 is the same linkage; its point has a closed form, see ``lambda_point``.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from scipy.optimize import brentq

import linkwright as lw
from studies.models import UNITS, measured

TABLE = [
    # degrees, L1/L2, L3/L2, length/L2, error in %
    (20, 2.975, 3.963, 0.601, None),
    (40, 2.950, 3.925, 1.193, 0.00004),
    (60, 2.900, 3.850, 1.763, 0.00027),
    (80, 2.825, 3.738, 2.299, None),
    (100, 2.725, 3.588, 2.790, None),
    (120, 2.625, 3.438, 3.238, 0.010),
    (140, 2.500, 3.250, 3.623, 0.023),
    (160, 2.350, 3.025, 3.933, 0.047),
    (180, 2.200, 2.800, 4.181, 0.096),
]


def hoecken(ground: float, coupler: float, low: float, high: float, **measures: Any) -> Any:
    """Measures of a linkage with a crank of 100 mm while the crank goes from low to high (degrees)."""
    long = 100 * coupler
    data = {
        "units": UNITS,
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [100 * ground, 0]}},
            "crank": {"points": {"A": [0, 0], "B": [100, 0]}},
            "coupler": {"points": {"B": [0, 0], "C": [long, 0], "P": [2 * long, 0]}},
            "rocker": {"points": {"D": [0, 0], "C": [long, 0]}},
        },
        "assembly": {"C": "left of B-D"},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": 0}},
        "windows": {"line": {"motor.angle": [low, high]}},
        "studies": {"cycle": {"turns": "1 motor", "samples": 90}},
    }
    return measured(data, **{name: {**entry, "window": "line"} for name, entry in measures.items()})


@pytest.mark.parametrize(("degrees", "ground", "coupler", "length", "error"), TABLE)
def test_hoecken_table(degrees: float, ground: float, coupler: float, length: float, error: float | None) -> None:
    found = hoecken(
        ground, coupler, 180 - degrees / 2, 180 + degrees / 2, error={"straightness": "P"}, length={"span": "P.x"}
    )
    assert found["length"].shown() / 100 == pytest.approx(length, abs=6e-4)
    if error is not None:
        digit = 1e-5 if error < 1e-3 else 1e-3
        percent = 100 * found["error"].shown() / found["length"].shown()
        assert percent == pytest.approx(error, abs=0.5 * digit, rel=0.02)


def lambda_point(angle: Any) -> tuple[Any, Any]:
    """C has one distance (2.5) from B, D and P, so B-D-P is a right angle (Thales) and B-P is 5 long."""
    c, s = mpmath.cos(angle), mpmath.sin(angle)
    factor = mpmath.sqrt(25 / (5 - 4 * c) - 1)
    return 2 + factor * s, factor * (2 - c)


def test_lambda_linkage_in_closed_form() -> None:
    """At 90, 180 and 270 deg the point is at the height 4; in between it is off by the strip's width."""
    assert [float(lambda_point(mpmath.pi * k / 2)[1]) for k in (1, 2, 3)] == pytest.approx([4, 4, 4], abs=1e-14)
    found = hoecken(2, 2.5, 90, 270, width={"straightness": "P"}, length={"path": "P"}, height={"extremes": "P.y"})
    with mpmath.workdps(30):
        top = mpmath.findroot(lambda a: mpmath.diff(lambda b: lambda_point(b)[1], a), 2.2)
        off = lambda_point(top)[1] - 4
        ends = [mpmath.pi / 2, mpmath.pi, 3 * mpmath.pi / 2]
        speed = [lambda a, i=i: mpmath.diff(lambda b: lambda_point(b)[i], a) for i in (0, 1)]
        length = mpmath.quad(lambda a: mpmath.hypot(speed[0](a), speed[1](a)), ends)
    assert found["width"].shown() == pytest.approx(100 * abs(float(off)), rel=1e-11)
    assert found["length"].shown() == pytest.approx(100 * float(length), rel=1e-12)
    assert found["height"].shown("min" if off > 0 else "max") == pytest.approx(400, rel=1e-12)


def test_dwell_of_the_paper_feeder() -> None:
    """examples/paper_feeder_dwell.yaml: how long the slider is within 1 mm of its left end, from its closed form."""
    document = lw.load(Path(__file__).parents[2] / "examples" / "paper_feeder_dwell.yaml")
    (dwell,) = (m for m in lw.run(document).cycle.measures if m.measure.reduction == "dwell")  # type: ignore[union-attr]
    ab, bc, cd, de, ad = 155.0, 395.0, 300.0, 500.0, 300.0

    def inner(along: float) -> float:
        return math.acos((along**2 + ad**2 - cd**2) / (2 * along * ad))

    right, left = inner(bc + ab), inner(bc - ab) - math.pi
    back = 1.5 * (right - left) / (2 * math.pi)
    start = back + 0.25

    def crank(t: float) -> float:
        def step(t: float, a: float, b: float) -> float:
            x = min(max((t - a) / (b - a), 0.0), 1.0)
            return x**3 * (10 - 15 * x + 6 * x * x)

        return (
            right
            + (left - right) * step(t, 0, back)
            + (right - left - 2 * math.pi) * step(t, start, start + 1.5 - back)
        )

    def slider(t: float) -> float:
        b = ab * np.exp(1j * crank(t))
        gap = ad - b
        along = (bc**2 - cd**2 + abs(gap) ** 2) / (2 * abs(gap))
        c = b + gap / abs(gap) * (along + 1j * math.sqrt(bc**2 - along**2))
        return float((ad + de / cd * (c - ad)).real)

    edge = slider((back + start) / 2) + 1.0
    came, went = (brentq(lambda t: slider(t) - edge, a, b, xtol=1e-15) for a, b in ((0.3, back), (start, 1.3)))
    assert dwell.measure.within is not None
    assert dwell.measure.within.text == "1 mm"
    assert dwell.shown() == pytest.approx(went - came, rel=1e-11)
    assert dwell.found[0].time == pytest.approx(came, rel=1e-11)
