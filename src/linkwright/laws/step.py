"""The 3-4-5 step, as designers know it from ADAMS' STEP5."""

from __future__ import annotations

from typing import Any

import numpy as np

from linkwright.notation import Jet
from linkwright.notation.jets import call


def step5(x: Any, x0: Any, h0: Any, x1: Any, h1: Any) -> Any:
    """From h0 at x0 to h1 at x1 by 10 u^3 - 15 u^4 + 6 u^5, constant outside; smooth to the acceleration.

    Takes numbers or jets; the result has the dimension of h0 and h1, and is NaN where x0 = x1.
    """
    if isinstance(x1 - x0, int | float) and x1 == x0:
        return (h0 + h1) * np.nan
    width = x1 - x0
    u = (x - x0) / (np.where(width == 0, np.nan, width) if isinstance(width, np.ndarray) else width)
    if isinstance(u, Jet):
        zero, one = Jet.constant(0.0, u.order), Jet.constant(1.0, u.order)
        u = zero.where(u.d[0] <= 0, one.where(u.d[0] >= 1, u))
    else:
        u = call("fmin", call("fmax", u, 0.0), 1.0)
    return h0 + (h1 - h0) * (u * u * u * (u * (u * 6.0 - 15.0) + 10.0))
