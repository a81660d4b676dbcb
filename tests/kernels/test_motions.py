"""Motion laws as drives' laws: rates in time, derivatives by parameters, breaks, the words of `check`."""

from __future__ import annotations

from typing import Any

import mpmath as mp
import numpy as np
import pytest

from helpers.differences import derivatives
from laws.texts import value
from linkwright.compilation import examine
from linkwright.kernels import Compiled
from linkwright.kernels.tangents import Tangents
from linkwright.model.document import Document
from linkwright.notation import Jet
from linkwright.notation.duals import Dual
from linkwright.report.structure_summary import facts
from linkwright.results import Run
from model.given import four_bar

SEGMENTS = [
    {"rise": 12, "over": 90, "law": "modified_sine"},
    {"dwell": 150},
    {"fall": 12, "over": 90, "formula": "u - sin(360 deg*u)/(2*pi)"},
    {"dwell": 30},
]


def compiled(position: str, segments: Any = SEGMENTS, **law: Any) -> Compiled:
    laws = {"swing": {"over": "angle", "of": "angle", "segments": segments, **law}}
    data = four_bar(
        laws=laws,
        parameters={"w": "30 deg/s", "h": 1.5, "p": 20},
        drives={"motor": {"turns": "crank", "on": "frame", "position": position}},
    )
    made, findings = examine(Document.model_validate(data))
    assert not [str(finding) for finding in findings]
    assert made is not None
    return made


def test_rates_in_time_against_differences() -> None:
    law = compiled("p + h*swing(w*t + 3 deg*sin(w*t))").laws["motor"]
    t = np.array([0.4, 1.2, 2.2, 8.4, 9.7, 13.1])
    for k in range(4):
        wanted = derivatives(lambda at, k=k: np.asarray(law(at).d[k]), t, 2e-3)
        assert np.asarray(law(t).d[k + 1]) == pytest.approx(wanted, abs=1e-9)


def test_derivatives_by_parameters() -> None:
    """By w, which stands in the law's argument, and by h, through duals, against differences of the law itself."""
    made = compiled("p + h*swing(w*t)")
    t, nominal = np.array([0.4, 1.2, 2.2, 8.4, 9.7]), made.laws["motor"].parameters
    for name, step in (("w", 1e-3), ("h", 1e-2)):
        given = {**nominal, name: Dual(nominal[name], 1.0)}
        rows = made.laws["motor"].at(t, given).d
        for k in range(4):

            def moved(by: Any, k: int = k, name: str = name) -> Any:
                return np.array([made.laws["motor"].at(t, {**nominal, name: nominal[name] + b}).d[k] for b in by]).T

            wanted = derivatives(moved, np.zeros(1), step)[:, 0]
            assert rows[k].slope == pytest.approx(wanted, rel=1e-6, abs=1e-7), (name, k)
    along = np.eye(len(made.graph.parameters))
    values, slopes = Tangents(made, along).evaluate(["C.x"], t)
    which = made.graph.parameters.index("h")
    other = compiled("p + (h + 0.001)*swing(w*t)").evaluate(["C.x"], t)[0]
    assert slopes[0, which] == pytest.approx((other - values[0]) / 1e-3, abs=1e-4)


def test_joins_are_breaks_of_forces_in_every_period() -> None:
    run = Run(compiled("swing(w*t)"), 0.0, 20.0, 100)
    assert run.breaks == pytest.approx([3, 8, 11, 12, 15])
    once = Run(compiled("swing(w*t - 30 deg)", SEGMENTS[:2], beyond="hold"), 0.0, 20.0, 100)
    assert once.breaks == pytest.approx([1, 4])


def test_a_formula_is_told_as_text() -> None:
    motion = compiled("swing(w*t)").motions["swing"]
    for start, stop, text in motion.pieces():
        x = 0.3 * start + 0.7 * stop
        assert float(value(text, mp.mpf(x))) == pytest.approx(float(motion.at(x)), abs=1e-15)
    jet = motion(Jet([np.array([4.5]), np.ones(1)]))
    assert jet.d[1] == pytest.approx(motion.at([4.5], 1))


def test_check_says_what_jumps() -> None:
    said = {str(fact["name"]): str(fact["sentence"]) for fact in facts(compiled("swing(w*t)"))}["Motion laws"]
    assert said.startswith("swing: the jerk jumps at 0 deg by 0.001143")
    assert "velocity -0.266667 to 0.234614 deg/deg" in said
    smooth = [{"rise": 12, "over": 180, "law": "poly_56789"}, {"fall": 12, "over": 180, "law": "poly_56789"}]
    said = {str(fact["name"]): str(fact["sentence"]) for fact in facts(compiled("swing(w*t)", smooth))}["Motion laws"]
    assert said.startswith("swing: continuous up to and including jerk; velocity")
