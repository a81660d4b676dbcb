"""A drive's law: its value and rates at times, at the nominal parameters or at others."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions.typed_fields import Path
from linkwright.findings import Finding, ModelError, Term
from linkwright.model.quantities import LARGEST
from linkwright.notation import Jet

Array = NDArray[np.float64]
Parameters = Mapping[str, Any]
"""Values (SI) by name: numbers, or arrays that broadcast with the times."""


@dataclass(frozen=True)
class DriveLaw:
    """A drive's value and rates (SI): ``of(times (s), parameters, strict)``; where it has none, NaN, or if ``strict``
    :class:`ModelError`. ``names`` are the parameters on which it depends, ``plays`` the offsets of joints (see
    :class:`linkwright.graph.geometry.Geometry`) that move it, asked as parameters are where they are given."""

    of: Callable[[Array, Parameters, bool], Jet]
    parameters: Parameters
    names: frozenset[str] = frozenset()
    plays: frozenset[str] = field(default=frozenset(), kw_only=True)

    def __call__(self, t: Array) -> Jet:
        """At the nominal parameters."""
        return self.of(t, self.parameters, True)

    def at(self, t: Array, parameters: Parameters) -> Jet:
        """At other parameters; NaN where it has no value."""
        return self.of(t, parameters, False)


_RATES = (Term("law-value"), Term("law-velocity"), Term("jump-acceleration"))
"""What must be finite."""


def must_be_finite(code: str, path: Path, data: Mapping[str, Any], t: Array, jet: Jet) -> None:
    """Raise a finding where value, velocity or acceleration at some times (s) isn't a number below the largest one."""
    for k, row in enumerate(jet.d[:3]):
        bad = ~(np.abs(np.broadcast_to(np.asarray(row, dtype=float), t.shape)) < LARGEST)
        if bad.any():
            raise ModelError([Finding(code, path, {**data, "time": float(t[bad][0]), "what": _RATES[k]})])
