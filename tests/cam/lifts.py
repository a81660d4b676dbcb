"""Lifts over a turn for tests: exact trigonometric ones, and the rise, dwell, return of the heat-seal cam."""

from __future__ import annotations

import math

from linkwright.notation import Jet


def harmonic(size: float, second: float = 0.0, phase: float = 0.0) -> object:
    """0 .. about 2 size, smooth over the turn."""

    def lift(theta: Jet) -> Jet:
        return size * (1.0 - theta.cos()) + second * (1.0 - (2.0 * theta + phase).cos())

    return lift


def cycloidal(u: Jet) -> Jet:
    """The cycloidal law."""
    return u - (u * (2 * math.pi)).sin() / (2 * math.pi)


HEAT_SEAL = [0.0, math.radians(90), math.radians(270), math.radians(345)]


def heat_seal(theta: Jet) -> Jet:
    """Rise 12 deg in 90 deg, dwell 180 deg, return in 75 deg, dwell 15 deg."""
    t, high = theta.d[0], math.radians(12)
    _, a, b, c = HEAT_SEAL
    rise, fall = cycloidal(theta / a) * high, high - cycloidal((theta - b) / (c - b)) * high
    up, down = Jet.constant(high, theta.order), Jet.constant(0.0, theta.order)
    return rise.where(t < a, up.where(t < b, fall.where(t < c, down)))
