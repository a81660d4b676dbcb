"""Laws of few waves: the double harmonic, those of Gutman and Freudenstein; and harmonic series."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi

from linkwright.laws.curve import Curve
from linkwright.laws.numbers import plain, settled
from linkwright.laws.pieces import Piece, Wave
from linkwright.laws.registry import register
from linkwright.notation import Scalar


def _cycloid(first: float, third: float) -> Curve:
    """u - (first sin 2 pi u + third sin 6 pi u)/(2 pi)."""
    return Curve((Piece(0.0, 1.0, (0.0, 1.0), (Wave(-first / (2 * pi), 2.0), Wave(-third / (2 * pi), 6.0))),))


@register("double_harmonic", mirrored=True)
def _double() -> Curve:
    """1/2 [(1 - cos pi u) - 1/4 (1 - cos 2 pi u)]; ends with an acceleration."""
    return Curve((Piece(0.0, 1.0, (0.375,), (Wave(-0.5, 1.0, True), Wave(0.125, 2.0, True))),))


@register("gutman_13")
def _gutman() -> Curve:
    """Gutman's law of the first and third harmonics (Rothbart, Cam Design Handbook, McGraw-Hill 2004)."""
    return _cycloid(15 / 16, 1 / 48)


@register("freudenstein_13")
def _freudenstein() -> Curve:
    """Freudenstein's, of a smaller jerk (Rothbart, as above)."""
    return _cycloid(27 / 28, 1 / 84)


def series(cosines: Sequence[Scalar], sines: Sequence[Scalar]) -> Curve:
    """Sum of a_k (cos 2 pi k u - 1) + b_k sin 2 pi k u, k from 1: from 0 over one whole turn back to 0."""
    waves = [Wave(a, 2.0 * k, True) for k, a in enumerate(cosines, start=1) if not plain(a) or a]
    waves += [Wave(b, 2.0 * k) for k, b in enumerate(sines, start=1) if not plain(b) or b]
    return Curve((Piece(0.0, 1.0, (-settled(sum(cosines)),), tuple(waves)),))
