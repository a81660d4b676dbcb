"""The laws of springs in plain NumPy, from the model's own numbers: what the certificate holds reports against."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions import units as u
from linkwright.kernels import Compiled
from linkwright.model.mechanism import Spring
from linkwright.model.places import spring_dimensions
from linkwright.notation import Jet

Array = NDArray[np.float64]


def number(compiled: Compiled, spring: Spring, key: str, default: float = 0.0) -> float:
    """One of a spring's numbers (SI)."""
    given = getattr(spring, key)
    return default if given is None else compiled.quantities.value(given, spring_dimensions(spring)[key])


def elastic_force(compiled: Compiled, spring: Spring, x: Array) -> Array:
    """Force (N, positive in tension) or torque (N m, positive where it turns back) at lengths (m) or angles (rad)."""
    if spring.table:
        return np.asarray(compiled.tables[spring.table].or_nan(Jet([x])).d[0])
    if spring.gas is not None:
        assert spring.length is not None
        short, long = (compiled.quantities.value(edge, u.LENGTH) for edge in spring.length)
        n = number(compiled, spring, "exponent", 1.0)
        # The pressure falls as the volume rises; volumes over the rod's section, extended 1.
        filled = 1 - number(compiled, spring, "progression") ** (-1 / n)
        with np.errstate(invalid="ignore", divide="ignore"):
            volume = 1 - filled * (long - x) / (long - short)
            return np.asarray(-number(compiled, spring, "gas") * np.exp(-n * np.log(volume)))
    if spring.stiffness is None:
        return np.zeros_like(x)
    over = x - number(compiled, spring, "free")
    return number(compiled, spring, "preload") + number(compiled, spring, "stiffness") * over


def damping_force(compiled: Compiled, spring: Spring, rate: Array) -> Array:
    """The force or torque of its damping at rates (m/s, rad/s)."""
    return number(compiled, spring, "damping") * rate
