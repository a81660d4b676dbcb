"""The SCCA family: acceleration rises as a sine, stays constant, falls as a cosine, rests at zero, and mirrors that.

After R. L. Norton, Cam Design and Manufacturing Handbook, 2nd ed., ch. 3 (sine-constant-cosine-acceleration); closed
forms of the peak factors there and in :func:`factors`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from linkwright.laws.curve import Curve
from linkwright.laws.numbers import plain, settled
from linkwright.laws.pieces import Piece, Wave
from linkwright.laws.registry import LAWS, Law
from linkwright.notation import Scalar
from linkwright.notation.duals import value_of
from linkwright.notation.jets import call

MEMBERS: dict[str, tuple[float, float, float, float]] = {
    "parabolic": (0, 1, 0, 0),
    "simple_harmonic": (0, 0, 1, 0),
    "cycloidal": (1 / 2, 0, 1 / 2, 0),
    "modified_trapezoid": (1 / 4, 1 / 2, 1 / 4, 0),
    "modified_sine": (1 / 4, 0, 3 / 4, 0),
    "ms_cv20": (0.2, 0, 0.6, 0.2),
    "ms_cv33": (1 / 6, 0, 1 / 2, 1 / 3),
    "mcv50": (1 / 8, 0, 3 / 8, 1 / 2),
    "cycloidal_cv50": (1 / 4, 0, 1 / 4, 1 / 2),
}
"""Fractions b (sine), c (constant), d (cosine), z (zero) of the named members."""


def scca(b: Scalar, c: Scalar, d: Scalar, z: Scalar) -> Curve:
    """The member of given fractions, b + c + d + z = 1."""
    return scca_by_widths(b / 2, c / 2, d / 2, z, d / 2, c / 2, b / 2)


def scca_by_widths(*widths: Scalar) -> Curve:
    """A member that needn't be symmetric, from the widths of its seven zones, whose sum is 1.

    Sine, constant, cosine with positive acceleration; zero; cosine, constant, sine with negative acceleration, whose
    size follows from the velocity's return to zero.
    """
    up, down = (_gain(widths[:3]), _gain(widths[:3:-1]))
    ratio = up / down
    # The acceleration of each zone, as amplitude, then share of a quarter wave (0: sine from 0, 1: cosine from 1).
    zones = [(1.0, 0), (1.0, None), (1.0, 1), (0.0, None), (-ratio, 0), (-ratio, None), (-ratio, 1)]
    pieces: list[Piece] = []
    at: Scalar = 0.0
    speed: Scalar = 0.0
    value: Scalar = 0.0
    for i, ((size, kind), width) in enumerate(zip(zones, widths, strict=True)):
        if plain(width) and width <= 0:
            continue
        stop = 1.0 if not any(np.any(value_of(w) > 0) for w in widths[i + 1 :]) else at + width
        if kind is None:
            piece = Piece(at, stop, (value, speed, size / 2), (), at)
        else:
            # Of a sample without this zone any rate will do.
            rate = 1 / (2 * (width if plain(width) else call("where", value_of(width) == 0, 1.0, width)))
            omega = math.pi * rate
            amplitude = -size / omega**2
            # The integral of sin is -cos/w + 1/w, of cos it is sin/w.
            piece = (
                Piece(at, stop, (value, speed + size / omega), (Wave(amplitude, rate),), at)
                if kind == 0
                else Piece(at, stop, (value - amplitude, speed), (Wave(amplitude, rate, True),), at)
            )
        pieces.append(piece)
        speed = speed + size * width * (1.0 if kind is None else 2 / math.pi)
        value = settled(piece.at(np.asarray(at + width) if plain(at + width) else at + width, 0))
        at = at + width
    return Curve(tuple(pieces)).transformed(0.0, 1.0, 1 / value)


def _gain(widths: Sequence[Scalar]) -> Scalar:
    """The velocity that an acceleration of 1 gives over sine, constant and cosine zones."""
    sine, constant, cosine = widths
    return 2 / math.pi * (sine + cosine) + constant


def factors(b: float, c: float, d: float, z: float) -> tuple[float, float, float, float]:
    """Cv, Ca, and the jerks at the ends and at the crossover, in closed form."""
    v1 = b / math.pi
    v2 = v1 + c / 2
    v3 = v2 + d / math.pi
    rise = b**2 / (2 * math.pi) - b**2 / math.pi**2 + v1 * c / 2 + c**2 / 8
    rise += v2 * d / 2 + d**2 / math.pi**2 + v3 * z / 2
    ca = 1 / (2 * rise)
    return ca * v3, ca, math.pi * ca / b if b else math.inf, math.pi * ca / d if d else math.inf


_SINGLE = {
    "simple_harmonic": Piece(0.0, 1.0, (0.5,), (Wave(-0.5, 1.0, True),)),
    "cycloidal": Piece(0.0, 1.0, (0.0, 1.0), (Wave(-0.5 / math.pi, 2.0),)),
}
"""Members whose zones are one and the same formula."""

for _name, _fractions in MEMBERS.items():
    LAWS[_name] = Law((_SINGLE[_name],) if _name in _SINGLE else scca(*_fractions).parts, _name)
