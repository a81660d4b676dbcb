"""The reader knows exactly what each dialect has, and refuses the rest."""

from __future__ import annotations

import math

import numpy as np
import pytest

from linkwright.exports.process_simulate.evaluator import NotInDialect, evaluate, read

JOINTS = {"j1": "T", "s": "D"}
AT = {"j1": np.array([0.3, -0.7]), "s": np.array([12.0, 0.5])}


@pytest.mark.parametrize(
    ("dialect", "text", "value"),
    [
        ("seed", "acos(0.5*cos(T(j1)-0.1))-1.25", lambda t, s: math.acos(0.5 * math.cos(t - 0.1)) - 1.25),
        ("seed", "-T(j1)+2*(D(s)-1)/4", lambda t, s: -t + (s - 1) / 2),
        ("seed", "sqrt(25-D(s)/3*sin(T(j1)))", lambda t, s: math.sqrt(25 - s / 3 * math.sin(t))),
        ("seed", "8/4/2-1-1", lambda t, s: -1.0),
        ("wizard", "atan2(sin(T(j1)),D(s))+(-1)(1.5)", lambda t, s: math.atan2(math.sin(t), s) - 1.5),
        ("wizard", "(-1)(2*D(s)+T(j1))*3", lambda t, s: -3 * (2 * s + t)),
        ("wizard", "acos((-1)(0.25)) + 2 * ( T( j1 ) + D(s) )", lambda t, s: math.acos(-0.25) + 2 * (t + s)),
    ],
)
def test_what_a_dialect_has_is_read(dialect: str, text: str, value: object) -> None:
    expected = [value(t, s) for t, s in zip(AT["j1"], AT["s"], strict=True)]  # type: ignore[operator]
    got = np.broadcast_to(read(text, dialect, JOINTS)(AT), 2)
    assert got == pytest.approx(expected, abs=1e-15)


@pytest.mark.parametrize(
    ("dialect", "text"),
    [
        ("seed", "atan2(1,T(j1))"),  # no such function
        ("seed", "asin(T(j1))"),
        ("seed", "arccos(T(j1))"),
        ("seed", "tan(T(j1))"),
        ("seed", "T(j1)^2"),
        ("seed", "T(j1)**2"),
        ("seed", "1e-5*T(j1)"),  # no exponent
        ("seed", "1.5E3"),
        ("seed", "2T(j1)"),  # no juxtaposition
        ("seed", "(-1)(T(j1))"),
        ("seed", "2*-T(j1)"),  # a sign at the start of a sum only
        ("seed", "+T(j1)"),
        ("seed", ".5"),
        ("seed", "5."),
        ("seed", "T(j2)"),  # no such joint
        ("seed", "D(j1)"),  # of the other kind
        ("seed", "T(s)"),
        ("seed", "j1"),
        ("seed", "cos(T(j1)"),
        ("seed", "cos T(j1)"),
        ("seed", "acos(0.5,1)"),
        ("seed", ""),
        ("seed", "T(j1) T(j1)"),
        ("seed", '"T(j1)"'),
        ("wizard", "cos(T(j1))"),
        ("wizard", "sqrt(D(s))"),
        ("wizard", "T(j1)-1"),  # no binary minus
        ("wizard", "-T(j1)"),
        ("wizard", "(-1)"),
        ("wizard", "(-2)(T(j1))"),
        ("wizard", "atan2(T(j1))"),
        ("wizard", "T(j1)+(-1)T(j1)"),
    ],
)
def test_what_a_dialect_lacks_is_refused(dialect: str, text: str) -> None:
    with pytest.raises(NotInDialect):
        read(text, dialect, JOINTS)


def test_functions_ask_only_for_joints_before_them() -> None:
    kinds = {"a": "T", "b": "T", "c": "T"}
    at = np.array([0.5, 1.0])
    assert evaluate([("b", "2*T(a)"), ("c", "T(b)+T(a)")], "seed", kinds, "a", at)[1] == pytest.approx(3 * at)
    with pytest.raises(NotInDialect):
        evaluate([("b", "T(c)"), ("c", "T(a)")], "seed", kinds, "a", at)
