"""Polynomial laws: of given powers, or of given conditions at both ends and places between."""

from __future__ import annotations

from collections.abc import Sequence
from math import perm, prod

from linkwright.laws.curve import Curve
from linkwright.laws.numbers import solve
from linkwright.laws.pieces import Piece
from linkwright.laws.registry import register
from linkwright.notation import Scalar

Condition = tuple[Scalar, int, Scalar]
"""Place, order of the derivative, its value there."""


def polynomial(conditions: Sequence[Condition]) -> Curve:
    """The polynomial of least degree over 0..1 that meets all conditions."""
    powers = range(len(conditions))
    rows = [[perm(p, order) * (x ** (p - order) if p >= order else 0.0) for p in powers] for x, order, _ in conditions]
    return Curve((Piece(0.0, 1.0, tuple(solve(rows, [value for _, _, value in conditions]))),))


def of_powers(powers: Sequence[int]) -> Curve:
    """The law of given powers: 1 at u = 1, and as many derivatives 0 there as that leaves free.

    Its coefficients are the products of q/(q - p) over all other powers q.
    """
    coefficients = [0.0] * (max(powers) + 1)
    for p in powers:
        others = [q for q in powers if q != p]
        coefficients[p] = prod(others) / prod(q - p for q in others)
    return Curve((Piece(0.0, 1.0, tuple(coefficients)),))


@register("constant_velocity")
def _line() -> Curve:
    return Curve((Piece(0.0, 1.0, (0.0, 1.0)),))


@register("poly_23")
def _cubic() -> Curve:
    return Curve((Piece(0.0, 1.0, (0, 0, 3, -2)),))


@register("poly_345")
def _quintic() -> Curve:
    return Curve((Piece(0.0, 1.0, (0, 0, 0, 10, -15, 6)),))


@register("poly_4567")
def _septic() -> Curve:
    return Curve((Piece(0.0, 1.0, (0, 0, 0, 0, 35, -84, 70, -20)),))


@register("poly_56789")
def _nonic() -> Curve:
    return Curve((Piece(0.0, 1.0, (0, 0, 0, 0, 0, 126, -420, 540, -315, 70)),))


@register("eighth_degree", mirrored=True)
def _eighth() -> Curve:
    """Ends with an acceleration; H. A. Rothbart, Cam Design Handbook, McGraw-Hill 2004."""
    return Curve((Piece(0.0, 1.0, (0, 0, 0, 6.09755, 0, -20.78040, 26.73155, -13.60965, 2.56095)),))
