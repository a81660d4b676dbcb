"""Tables whose values vary: against models that are read anew, and their differences."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from helpers.compiled import compiled_from
from helpers.differences import OFFSETS, WEIGHTS
from linkwright.findings import ModelError
from linkwright.kernels import Compiled
from linkwright.kernels.parameter_batch import Varied
from linkwright.kernels.tangents import Tangents

NOMINAL = {"a": 0.3, "b": 0.8, "c": 20.0, "f": 5.0}
T = np.linspace(0.0, 1.9, 23)
SIGNALS = ["arm.angle", "arm.omega", "arm.jerk", "motor.torque", "pull.force"]


def model(given: dict[str, Any], **tables: Any) -> Compiled:
    """An arm that a table moves, loaded by a table over its angle and a spring with one over its length."""
    return compiled_from(
        {
            "units": {"length": "m", "angle": "rad", "time": "s", "mass": "kg", "force": "N", "torque": "N*m"},
            "parameters": given,
            "links": {
                "frame": {"points": {"O": [0, 0], "Q": [0, 0.3]}},
                "arm": {"points": {"O": [0, 0], "P": [0.1, 0]}, "mass": 2, "com": [0.05, 0], "inertia": 1e-3},
            },
            "tables": {
                "move": {"points": [[0, "a"], [0.5, "2*a*b"], [1.1, "b"], [2, "a"]], "period": 2},
                "brake": {"points": [[-1, 0], [0, "c/2"], [1, "c"], [2, 3]], "between": "linear"},
                "law": {"points": [[0.1, 0], [0.3, "f"], [0.5, "b*f"], [0.6, 9]]},
                **tables,
            },
            "drives": {"motor": {"turns": "arm", "on": "frame", "position": "0.5*move(t)"}},
            "loads": {"brake": {"on": "arm", "torque": "-brake(motor.angle)"}},
            "springs": {"pull": {"from": "Q", "to": "P", "force": "law"}},
        }
    )


def test_samples_are_models_read_anew() -> None:
    values = np.array([[0.3, 0.35, 0.25], [0.8, 0.7, 0.9], [20, 22, 10], [5, 5, 7]])
    varied = Varied(model(NOMINAL), [*NOMINAL])
    found = varied.evaluate(SIGNALS, varied.parameters(values), T)
    for i, column in enumerate(values.T.tolist()):
        wanted = model(dict(zip(NOMINAL, column, strict=True))).evaluate(SIGNALS, T)
        assert (np.abs(found[:, i] - wanted).max(axis=1) <= 1e-12 * np.abs(wanted).max(axis=1)).all()


def test_derivatives_are_those_of_samples() -> None:
    base = model(NOMINAL)
    _, exact = Tangents(base, np.eye(4)).evaluate(SIGNALS, T)
    varied, step = Varied(base, [*NOMINAL]), 1e-3
    aside = base.parameters[:, None] + (np.eye(4)[:, :, None] * OFFSETS * step).reshape(4, -1)
    moved = varied.evaluate(SIGNALS, varied.parameters(aside), T).reshape(5, 4, OFFSETS.size, T.size)
    numeric = moved.transpose(0, 1, 3, 2) @ WEIGHTS / step
    scale = np.abs(moved).max(axis=(1, 2, 3))[:, None, None]
    assert (np.abs(exact - numeric) <= 1e-8 * scale).all()


def test_what_a_table_cant_take() -> None:
    """Places and periods stay; a table that no longer closes is a wrong sample."""
    ends = {"points": [[0, "a"], [0.5, 0.1], [1.1, "b"], [2, "d"]], "period": 2}
    varied = Varied(model(NOMINAL | {"d": 0.3}, move=ends), ["a", "d"])
    given = np.array([[0.3, 0.4, 0.4], [0.3, 0.4, 0.3]])
    assert np.isnan(varied.parameters(given)[0]).tolist() == [False, False, True]
    assert [fault.code for fault in varied.faults(given)] == ["table.not-closed"]
    rows = [[0, 0], [0.6, 0.2], [1, 0.1], [1.5, 0]]
    places = [[0, 0], ["d", 0.2], [1, 0.1], [2, 0]]
    for table in ({"points": places}, {"points": rows, "period": "5*d"}):
        with pytest.raises(ModelError) as error:
            Varied(model(NOMINAL | {"d": "0.4 s"}, move=table), ["d"])
        assert [finding.code for finding in error.value.findings] == ["varied.table"]
