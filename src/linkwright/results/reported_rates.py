"""Reported rates against what they are rates of: over panels of the motion, their integrals are the changes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwright.model.signals import Signals

Array = NDArray[np.float64]

CHAINS = (
    *((f"{before}{axis}", f"{after}{axis}") for before, after in (("", "v"), ("v", "a"), ("a", "j")) for axis in "xy"),
    *(("angle", "omega"), ("omega", "alpha"), ("alpha", "jerk")),
    *(("s", "v"), ("v", "a"), ("a", "j"), ("length", "v")),
)
"""Attributes of one element of which the second is the rate of the first."""


def rates(signals: Signals) -> dict[str, list[str]]:
    """By the name of each rate the signals of the same element that it is the rate of."""
    of_element: dict[tuple[str, tuple[str, ...]], dict[str, str]] = {}
    for signal in signals.all():
        of_element.setdefault((signal.kind, signal.owners), {})[signal.attribute] = signal.text
    found: dict[str, list[str]] = {}
    for names in of_element.values():
        for value, rate in CHAINS:
            if value in names and rate in names:
                found.setdefault(names[rate], []).append(names[value])
    return found
