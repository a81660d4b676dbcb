"""Efficiency against textbook formulas, and shares that add up; where there is none, that is said by name."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ruamel.yaml import YAML

from linkwright.compilation import compile_mechanism
from linkwright.findings import ModelError
from linkwright.model.document import parse_document
from studies.models import codes, cycle_of, measured, slider_crank

EXAMPLE = YAML(typ="safe").load(
    (Path(__file__).parents[2] / "examples" / "slider_crank_friction.yaml").read_text("utf-8")
)


def slope(alpha: float, mu: float, speed: float = 0.1, **sections: Any) -> dict[str, Any]:
    """A block without mass on a slope (rad), pulled along it; its weight of 50 N acts as a load."""
    return {
        "units": {"length": "mm", "angle": "rad", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"},
        "links": {"frame": {"points": {"A": [0, 0]}}, "block": {"points": {"C": [0, 0]}}},
        "joints": {"plane": {"prismatic": ["frame", "block"], "line": [f"A at {alpha}", "C at 0"]}},
        "drives": {"pull": {"slides": "block", "on": "frame", "position": f"{speed} m/s*t"}},
        "loads": {"weight": {"on": "block", "at": "C", "force": [0, -50]}},
        "friction": {"plane_f": {"slide": "plane", "length": 20, "coefficient": mu}},
        "studies": {"cycle": {"duration": "1 s", "samples": 20}},
        **sections,
    }


@settings(max_examples=8, deadline=None)
@given(st.floats(0.05, 1.3), st.floats(0.02, 0.9), st.sampled_from([0.1, -0.1]))
def test_block_on_a_slope(alpha: float, mu: float, speed: float) -> None:
    """Up: tan a / (tan a + mu); down: 1 - mu / tan a, which is negative where the block locks itself (Beer, Johnston,
    Statics, ch. 8: impending motion on a slope)."""
    found = measured(
        slope(alpha, mu, speed), up={"efficiency": ["weight"]}, lost={"share": ["plane_f"], "useful": ["weight"]}
    )
    ratio = mu / math.tan(alpha)
    expected = 1 / (1 + ratio) if speed > 0 else 1 - ratio
    assert found["up"].shown() == pytest.approx(expected, rel=1e-10, abs=1e-10)
    assert found["up"].shown() + found["lost"].shown() == pytest.approx(1.0, rel=1e-12)


def test_of_the_whole_turn_and_of_the_working_stroke() -> None:
    """Over a turn the useful work over the drive's; over any window it and the shares add up to 1, though masses and
    gravity give and take."""
    useful = {"useful": ["work"]}
    shares = {f"s_{name}": {"share": [name], **useful} for name in EXAMPLE["friction"]}
    measures = {"eta": {"efficiency": ["work"]}, **shares, "all": {"share": [*EXAMPLE["friction"]], **useful}}
    measures |= {f"{name}_out": {**entry, "window": "out"} for name, entry in measures.items()}
    measures |= {"given": {"mean": "motor.power"}, "lost_A": {"mean": "-bearing_A.power"}}
    outcome = cycle_of({**EXAMPLE, "measures": measures})
    assert not outcome.failures
    found = {m.name: m.shown() for m in outcome.measures}
    assert found["eta"] == pytest.approx(200 / found["given"], rel=1e-9)
    assert found["s_bearing_A"] == pytest.approx(found["lost_A"] / found["given"], rel=1e-9)
    for end in ("", "_out"):
        parts = sum(found[f"s_{name}{end}"] for name in EXAMPLE["friction"])
        assert found[f"all{end}"] == pytest.approx(parts, rel=1e-12)
        assert found[f"eta{end}"] + parts == pytest.approx(1.0, abs=1e-10)
    assert found["eta_out"] > found["eta"]  # the return stroke only loses


def test_at_an_instant() -> None:
    """It is an expression, for any reduction."""
    now = "power(weight).dissipated/energy.dissipated"
    found = measured(slope(0.4, 0.1), now={"value": now, "where": "start"}, all={"extremes": now})
    expected = pytest.approx(math.tan(0.4) / (math.tan(0.4) + 0.1), rel=1e-12)
    assert [found["now"].shown(), found["all"].shown("min"), found["all"].shown("max")] == [expected] * 3


@pytest.mark.parametrize(
    ("load", "code"),
    [
        ({"on": "slider", "at": "C", "force": [0, "10 N"]}, "measure.useless"),
        ({"on": "slider", "at": "C", "force": ["10 N", 0]}, "measure.useless"),
        ({"on": "slider", "at": "C", "force": ["-1 N*C.vx/(1 m/s)", 0]}, "measure.energy-from-others"),
    ],
    ids=["across", "both ways alike", "another load drives"],
)
def test_undefined_by_name(load: dict[str, Any], code: str) -> None:
    wind = {"on": "slider", "at": "C", "force": ["5 N*C.vx/(1 m/s)", 0]}
    loads = {"press": load} | ({"wind": wind} if code == "measure.energy-from-others" else {})
    data = slider_crank(
        loads=loads, measures={"a": {"efficiency": ["press"]}, "b": {"share": ["press"], "useful": ["press"]}}
    )
    outcome = cycle_of(data)
    assert codes(outcome.failures) == [code] * 2
    assert not any(measure.found for measure in outcome.measures)


@pytest.mark.parametrize(
    ("measure", "code"),
    [
        ({"efficiency": ["pres"]}, "name.unknown"),
        ({"efficiency": "press"}, "file.expected"),
        ({"efficiency": []}, "file.expected"),
        ({"share": ["press"]}, "measure.useful"),
        ({"efficiency": ["press"], "useful": ["press"]}, "measure.useful"),
        ({"share": ["press"], "useful": ["motor"]}, "name.unknown"),
        ({"efficiency": ["twice"]}, "signal.several-elements"),
        ({"efficiency": ["press"], "unit": "W"}, "measure.unit"),
        ({"max": "power(pres).supplied"}, "name.unknown"),
        ({"max": "power(motor).dissipated"}, "signal.no-attribute"),
        ({"max": "power(press)"}, "expression.unknown-function"),
    ],
)
def test_refused_by_name(measure: dict[str, Any], code: str) -> None:
    data = slider_crank(
        loads={name: {"on": "slider", "at": "C", "force": [1, 0]} for name in ("press", "twice")},
        springs={"twice": {"from": "F", "to": "C", "damping": "1 N*s/m"}},
        measures={"a": measure},
    )
    with pytest.raises(ModelError) as caught:
        compile_mechanism(parse_document({"linkwright": 1, **data}))
    assert code in codes(caught.value.findings)
