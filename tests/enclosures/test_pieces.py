"""Motion laws and tables followed by Taylor models hold the values that they have at samples."""

from typing import Any

import numpy as np
import pytest

from linkwright.enclosures.bounds import evaluated
from linkwright.enclosures.panels import Panels
from linkwright.enclosures.taylor import FUNCTIONS, TaylorModel, along
from linkwright.laws import LAWS, Dwell, Rise, TableLaw, motion
from linkwright.laws.curve import composed
from linkwright.laws.pieces import Formula
from linkwright.notation import Jet

H = np.linspace(-0.999, 0.999, 21)


def holds(found: TaylorModel, true: Any, on: Panels, size: float) -> float:
    """The share of panels that are decided; all of them must hold the true values."""
    t = (on.mid + on.half * H[:, None]).ravel()
    value = np.asarray(true(t)).reshape(H.size, -1)
    c = np.broadcast_to(found.c, (len(found.c), on.count))
    away = np.abs(value - evaluated(c[:, None, :], H[:, None])) - found.r
    known = np.broadcast_to(np.isfinite(found.r), on.count)
    assert (away[:, known] <= 1e-13 * size).all()
    return float(known.mean())


def panels(a: float, b: float, count: int) -> Panels:
    ends = np.linspace(a, b, count + 1)
    return Panels(ends[:-1], ends[1:])


def jet(at: Any, t: np.ndarray, order: int) -> np.ndarray:
    return np.asarray(composed(Jet([t, np.ones_like(t), *[np.zeros_like(t)] * 3]), at).d[order])


@pytest.mark.parametrize("beyond", ["repeat", "advance", "hold"])
@pytest.mark.parametrize("name", ["cycloidal", "modified_sine", "poly_345", "scca" if "scca" in LAWS else "poly_4567"])
@pytest.mark.parametrize("order", [0, 1, 2])
def test_motion_laws(beyond: str, name: str, order: int) -> None:
    fall = [] if beyond == "advance" else [Rise(0.9, -2.0, LAWS[name])]
    law = motion([Rise(1.3, 2.0, LAWS[name]), Dwell(0.4), *fall], 0.5, beyond=beyond)  # type: ignore[arg-type]
    for count, share in ((40, 0.7), (400, 0.9)):
        on = panels(-1.0, 6.0, count)
        t = TaylorModel.time(on)
        found = composed(Jet([t, 1.0, 0.0, 0.0, 0.0]), law.at).d[order]
        found = found if isinstance(found, TaylorModel) else TaylorModel.number(found)
        assert holds(found, lambda at: jet(law.at, at, order), on, 30.0) > share


def test_joins_at_edges_are_sharp() -> None:
    """At a join where a panel ends, the acceleration jumps, and neither side sees the other."""
    law = motion([Rise(1.0, 2.0, LAWS["poly_23"]), Dwell(1.0), Rise(1.0, -2.0, LAWS["poly_23"])])
    on = Panels(np.array([0.5, 1.0]), np.array([1.0, 1.5]), 1e-12)
    found = law.at(TaylorModel.time(on), 2)
    low, high = found.range()
    assert high[0] < 0.01
    assert low[0] == pytest.approx(-12, abs=1e-6)
    assert (low[1], high[1]) == (pytest.approx(0, abs=1e-9), pytest.approx(0, abs=1e-9))


def test_formulas() -> None:
    from linkwright.laws import Curve, Motion

    part = Formula(lambda u: u * u * u.sin() if isinstance(u, Jet) else u, lambda x: x, 0.2, 1.1, 3.0, 0.4)
    law = Motion(Curve((part,)), (0.2, 1.3), "repeat")
    on = panels(0.3, 1.2, 7)
    with np.errstate(all="ignore"):
        found = law.curve.parts[0]
        model = along(law, TaylorModel.time(on), 1)
    assert holds(model, lambda t: found.at(t, 1), on, 5.0) == 1.0


@pytest.mark.parametrize("degree", [1, 3, 5])
@pytest.mark.parametrize("period", [None, 3.0])
@pytest.mark.parametrize("what", ["or_nan", "integral"])
def test_tables(degree: int, period: float | None, what: str) -> None:
    rng = np.random.default_rng(4)
    x = np.sort(rng.uniform(0, 2.8, 12))
    table = TableLaw(x, rng.normal(size=12), degree, period)
    a, b = (x[0], x[-1]) if period is None else (-4.0, 9.0)
    on = panels(a, b, 600)
    t = TaylorModel.time(on)
    for order in (0, 1):
        with np.errstate(all="ignore"):
            found = getattr(table, what)(Jet([t, 1.0, 0.0])).d[order]

        def true(at: np.ndarray, order: int = order) -> np.ndarray:
            return np.asarray(getattr(table, what)(Jet([at, np.ones_like(at), np.zeros_like(at)])).d[order])

        assert holds(found, true, on, 1e3) > (0.85 if order <= degree - 1 or what == "integral" else 0.0)


def test_a_table_is_held_at_its_ends_to_round_off() -> None:
    table = TableLaw(np.array([0.0, 1.0, 2.0]), np.array([1.0, 3.0, 2.0]), 1)
    on = Panels(np.array([0.0, 1.5]), np.array([0.5, 2.5]), 1e-14)
    found = table.or_nan(Jet([TaylorModel.time(on)])).d[0]
    assert list(np.isfinite(found.r)) == [True, False]


def test_smooth_arguments() -> None:
    """A law asked with a function of time that turns back at an end of a piece."""
    law = motion([Rise(1.0, 2.0, LAWS["cycloidal"]), Rise(1.0, -2.0, LAWS["cycloidal"])])
    on = panels(0.0, 6.0, 300)
    with np.errstate(all="ignore"):
        found = law.at(1.0 - FUNCTIONS["cos"](TaylorModel.time(on)) * 0.5, 0)
    assert holds(found, lambda t: law.at(1.0 - 0.5 * np.cos(t), 0), on, 2.0) > 0.95
