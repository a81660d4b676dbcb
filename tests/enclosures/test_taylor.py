"""Taylor models hold the exact values of the functions that they enclose."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from mpmath import mpf

from helpers.exact import BINARY, CONDITIONS, EXACT, arity
from linkwright.enclosures import taylor
from linkwright.enclosures.panels import Panels
from linkwright.enclosures.taylor import FUNCTIONS, TaylorModel, lift

ON = Panels(np.array([0.0]), np.array([2.0]))
places = st.floats(-1, 1)
small = st.floats(-2, 2) | st.sampled_from([0.0, 1.0, -1.0, 0.5])


@st.composite
def models(draw: Any) -> TaylorModel:
    """A model with its first coefficient anywhere and the others falling."""
    terms = draw(st.integers(1, 5))
    scale = draw(st.sampled_from([1.0, 0.1, 0.01, 1e-6]))
    c = np.array([[draw(small) * (scale if k else 1.0)] for k in range(terms)])
    return TaylorModel(c, np.array([draw(st.sampled_from([0.0, 1e-15, 1e-6]))]), ON)


def exact(model: TaylorModel, h: float) -> Any:
    """The polynomial's value."""
    return sum(mpf(float(c[0])) * mpf(h) ** k for k, c in enumerate(np.broadcast_to(model.c, (len(model.c), 1))))


def holds(found: TaylorModel, value: Any, h: float) -> bool:
    bound = float(np.broadcast_to(found.r, 1)[0])
    return not np.isfinite(bound) or abs(exact(found, h) - value) <= mpf(bound)


def test_every_registered_function_has_its_reference() -> None:
    assert set(FUNCTIONS) == set(EXACT)


@pytest.mark.parametrize("name", sorted(FUNCTIONS))
@settings(max_examples=50, deadline=None)
@given(data=st.data(), h=places, share=places)
def test_function_holds_the_exact_value(name: str, data: st.DataObject, h: float, share: float) -> None:
    n = arity(name)
    args, points = [], []
    for i in range(n):
        if name in CONDITIONS and (i == 0 or name.startswith("logical")):
            flag = data.draw(st.sampled_from([0.0, 1.0]))
            args.append(TaylorModel(np.array([[flag]]), np.zeros(1), ON) if data.draw(st.booleans()) else _open())
            points.append(mpf(flag))
        else:
            model = data.draw(models())
            args.append(model)
            points.append(exact(model, h) + mpf(share) * mpf(float(model.r[0])))
    with np.errstate(all="ignore"):
        found = FUNCTIONS[name](*args)
    value = EXACT[name](*points)
    if value is None:
        assert not np.isfinite(found.r).all()
    else:
        assert holds(found, value, h)


def _open() -> TaylorModel:
    return TaylorModel(np.array([[0.5]]), np.array([0.5]), ON)


@pytest.mark.parametrize("name", sorted(BINARY))
@settings(max_examples=50, deadline=None)
@given(a=models(), b=models(), h=places, s=places, r=places)
def test_operator_holds_the_exact_value(name: str, a: Any, b: Any, h: float, s: float, r: float) -> None:
    p, q = (exact(m, h) + mpf(share) * mpf(float(m.r[0])) for m, share in ((a, s), (b, r)))
    with np.errstate(all="ignore"):
        found = BINARY[name](a, b)
    if name == "/" and q == 0:
        assert not np.isfinite(found.r).all()
    else:
        assert holds(found, BINARY[name](p, q), h)


@settings(max_examples=150, deadline=None)
@given(a=models(), power=st.integers(-4, 7) | st.sampled_from([0.5, -0.5, 1.5, -2.25]), h=places, s=places)
def test_powers(a: Any, power: float, h: float, s: float) -> None:
    point = exact(a, h) + mpf(s) * mpf(float(a.r[0]))
    assume(point > 0 or (power == int(power) and (point != 0 or power >= 0)))
    with np.errstate(all="ignore"):
        assert holds(a**power, point ** mpf(power), h)


@st.composite
def expressions(draw: Any, depth: int = 4) -> Callable[[Any, dict[str, Callable[..., Any]]], Any]:
    """A random expression of t: from t and a table of functions, None where it has no value."""
    kind = draw(
        st.sampled_from(["t", "number", *BINARY, *sorted(set(FUNCTIONS) - {*CONDITIONS, "equal", "not_equal"})])
    )
    if depth == 0 or kind in ("t", "number"):
        number = draw(st.floats(-3, 3))
        return (lambda t, f: t) if kind == "t" or depth == 0 else (lambda t, f: f["number"](number))
    args = [draw(expressions(depth - 1)) for _ in range(2 if kind in BINARY else arity(kind))]

    def value(t: Any, f: dict[str, Callable[..., Any]]) -> Any:
        given_ = [arg(t, f) for arg in args]
        return None if any(g is None for g in given_) else f[kind](*given_)

    return value


def _quotient(a: Any, b: Any) -> Any:
    return a / b if b != 0 else None


@settings(max_examples=300, deadline=None)
@given(
    f=expressions(), start=st.floats(-3, 3), width=st.sampled_from([1e-3, 0.05, 0.5]), hs=st.lists(places, min_size=6)
)
def test_expressions_hold_their_exact_values(f: Any, start: float, width: float, hs: list[float]) -> None:
    on = Panels(np.array([start]), np.array([start + width]))
    with np.errstate(all="ignore"):
        found = lift(f(TaylorModel.time(on), {**FUNCTIONS, **BINARY, "number": lift}))
    for h in hs:
        t = mpf(float(on.mid[0])) + mpf(float(on.half[0])) * mpf(h)
        try:
            value = f(t, {**EXACT, **BINARY, "/": _quotient, "number": mpf})
        except OverflowError:
            continue
        if value is None:
            assert not np.isfinite(found.r).all()
        else:
            assert holds(found, value, h)


@pytest.mark.parametrize("order", [2, 4, 7])
def test_the_error_falls_by_the_order(order: int) -> None:
    """Half the panel: the bound falls by 2^(order + 1), until round-off is left."""

    def bound(width: float) -> float:
        t = TaylorModel.time(Panels(np.array([0.9 - width]), np.array([0.9 + width]), order=order))
        f = FUNCTIONS["sqrt"](2.0 + FUNCTIONS["sin"](t)) / (1.0 + t * t)
        return float(f.r[0])

    assert 2 ** (order + 0.5) < bound(0.1) / bound(0.05) < 2 ** (order + 2)


def test_planted_faults_are_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    """A term that is dropped, or round-off that isn't counted, leaves the exact value outside."""

    def cube() -> bool:
        t = TaylorModel.time(Panels(np.array([0.1]), np.array([0.4]), order=2))
        found = t * t * t
        return all(
            holds(found, (mpf(float(t.c[0, 0])) + mpf(float(t.c[1, 0])) * mpf(h)) ** 3, h) for h in (-1.0, 0.3, 1.0)
        )

    assert cube()
    with monkeypatch.context() as patch:
        patch.setattr(taylor, "rounding", lambda a, b: np.zeros(1))
        patch.setattr(taylor, "UP", 1.0)
        third = TaylorModel.number(0.1) * TaylorModel.number(0.1)
        assert not holds(third, mpf(0.1) ** 2, 0.0)
    whole = taylor.product
    with monkeypatch.context() as patch:
        patch.setattr(taylor, "product", lambda a, b: whole(a, b)[:3])
        assert not cube()


def test_what_may_vanish_stays_undecided() -> None:
    t = TaylorModel.time(Panels(np.array([-1.0]), np.array([1.0])))
    with np.errstate(all="ignore"):
        for found in (1.0 / t, FUNCTIONS["log"](t), FUNCTIONS["sqrt"](t), FUNCTIONS["sqrt"](t * t)):
            assert not np.isfinite(found.r).any()
            assert not np.isfinite(((found + 1.0) * 0.5 - found).r).any()
