"""Random mechanisms compiled, with the poses in which they are looked at."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from hypothesis import assume
from numpy.typing import NDArray

from helpers.plain import Plain, document_of
from linkwright.compilation import compile_mechanism
from linkwright.graph.rows import Determinant, ReachRow
from linkwright.kernels import Compiled
from linkwright.model.document import Document

Array = NDArray[np.float64]


def compiled_from(data: Mapping[str, Any]) -> Compiled:
    """A model file's data, compiled."""
    return compile_mechanism(Document.model_validate(dict(data)))


def compiled_of(plain: Plain, write: Callable[[Plain], dict[str, Any]] = document_of) -> Compiled:
    return compiled_from(write(plain))


def conditioning(compiled: Compiled, t: Array) -> tuple[float, float]:
    """The smallest normalised determinant and the smallest reach of any group at times ``t``."""
    groups = compiled.structure.groups
    if not groups:
        return 1.0, 1.0
    names = [row(group.label) for row in (Determinant, ReachRow) for group in groups]
    rows = np.nan_to_num(compiled.evaluate(names, t), nan=-1.0)
    return float(np.abs(rows[: len(groups)]).min()), float(rows[len(groups) :].min())


def regular(compiled: Compiled, t: Array, determinant: float = 0.15) -> None:
    """Drop an example that comes near a singular pose."""
    worst, reach = conditioning(compiled, t)
    assume(worst > determinant and reach > 0.01)
