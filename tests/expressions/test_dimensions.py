"""What bare numbers and bare parameters mean: the five rules of inference, and where a conflict is told."""

from __future__ import annotations

import math
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from linkwright.expressions import units as u
from linkwright.findings import Finding
from linkwright.model.document import Document
from linkwright.model.quantities import Quantities
from model.given import DATA, four_bar, quantities

MM, DEG = 1e-3, math.pi / 180


def model(parameters: dict[str, Any] | None = None, **sections: Any) -> Quantities:
    return quantities(four_bar(parameters=parameters or {}, **sections))


def links(**points: Any) -> dict[str, Any]:
    """The four-bar's links, with further points on the coupler."""
    base = four_bar()["links"]
    return {**base, "coupler": {"points": {**base["coupler"]["points"], **points}}}


def drive(position: Any) -> dict[str, Any]:
    return {"motor": {"turns": "crank", "on": "frame", "position": position}}


def point(q: Quantities, name: str = "P", link: str = "coupler") -> tuple[float, float]:
    position = q.mechanism.links[link].points[name]
    return q.value(position.first, u.LENGTH), q.value(position.second, u.ANGLE if position.polar else u.LENGTH)


def at_one_second(q: Quantities, **values: float) -> float:
    """The value of the motor's position at t = 1 s."""
    from linkwright.expressions.language import evaluate

    position = q.mechanism.drives["motor"].position
    assert position is not None
    names = {"t": 1.0, **q.parameters, **values}
    return float(evaluate(q.bind(position, u.ANGLE), lambda name: names[name.text]))


# Bare numbers (rule 2).


@pytest.mark.parametrize(
    ("written", "metres"),
    [
        ("20", 20 * MM),
        ("20 mm", 20 * MM),
        ("2 m", 2.0),
        ("2*10", 20 * MM),
        ("10/2", 5 * MM),
        ("1/20", 0.05 * MM),
        ("10/(1 + 1)", 5 * MM),
        ("(1 + 1)*10", 20 * MM),
        ("20*(1 + cos(60))", 30 * MM),
        ("(cos(60) + 1)*20", 30 * MM),
        ("20*(1 + (1 - cos(60)))/2", 15 * MM),
        ("20*max(0.5, cos(60))", 10 * MM),
        ("20*step5(0.5, 0, 0, 1, cos(60))", 5 * MM),
        ("20 + 2 m", 2 + 20 * MM),
        ("2*10 mm + 3", 23 * MM),
        ("-20", -20 * MM),
        ("-(20 + 1)", -21 * MM),
        ("10^2", 100 * MM),
        ("2^3*10", 80 * MM),
        ("2^0.5*10", math.sqrt(2) * 10 * MM),
        ("sqrt(16)", 4 * MM),
        ("sqrt(9 mm^2)", 3 * MM),
        ("abs(-5) + max(1, 2)", 7 * MM),
        ("hypot(3, 4)", 5 * MM),
        ("20*sin(30)", 10 * MM),
        ("20*sin(30 deg)", 10 * MM),
        ("pi*20", math.pi * 20 * MM),
        ("20*pi/4", 5 * math.pi * MM),
        ("50 % * 30", 15 * MM),
        ("0", 0.0),
        ("20*exp(0)", 20 * MM),
        ("step5(0.5, 0, 0, 1, 20)", 10 * MM),
    ],
)
def test_bare_numbers_as_a_length(written: str, metres: float) -> None:
    q = model(links=links(P=[written, 0]))
    assert not q.findings
    assert point(q)[0] == pytest.approx(metres, rel=1e-14)


@pytest.mark.parametrize(
    ("written", "radians"),
    [
        ("90", math.pi / 2),
        ("pi/2", math.pi / 2),
        ("2*pi", 2 * math.pi),
        ("pi/2 + 90", math.pi),
        ("90 + pi/2", math.pi),
        ("90 deg + 1 rad", math.pi / 2 + 1),
        ("30*(1 + cos(60))", math.pi / 4),
        ("atan2(1, 1)", math.pi / 4),
        ("atan2(1, 1) + 45", math.pi / 2),
        ("acos(0.5)", math.pi / 3),
        ("0.25 r", math.pi / 2),
    ],
)
def test_bare_numbers_as_an_angle(written: str, radians: float) -> None:
    """Degrees where they are declared; but pi counts radians (rule 3)."""
    q = model(links=links(P=f"10 at {written}"))
    assert not q.findings
    assert point(q)[1] == pytest.approx(radians, rel=1e-14)


@pytest.mark.parametrize(
    ("written", "radians"),
    [
        ("20*t/(1 s)", 20 * DEG),
        ("90 deg + 20 deg*sin(180 deg*t/(2 s))", 110 * DEG),
        ("90 + 20*sin(180*t/(2 s))", 110 * DEG),
        ("30 deg*sin(2*pi*t/(4 s))", 30 * DEG),
        ("30 deg*sin(2*pi*0.25 Hz*t)", 30 * DEG),
        ("60 rpm*t", 2 * math.pi),
        ("2*pi*t/(1 s)", 2 * math.pi),
        ("step5(t, 0 s, 0, 2 s, 90)", 45 * DEG),
        ("step5(t, 0, 0, 2, 90)", 45 * DEG),
        ("1 rad/s^2*t^2/2", 0.5),
    ],
)
def test_laws_of_a_drive(written: str, radians: float) -> None:
    q = model(drives=drive(written))
    assert not q.findings
    assert at_one_second(q) == pytest.approx(radians, rel=1e-14)


def test_the_law_of_a_slide() -> None:
    """The design's own example: 1100 + 20*t/(1 s) as a length in mm."""
    q = quantities(
        four_bar(
            joints={"rail": {"prismatic": ["frame", "crank"], "line": ["A at 0", "A at 0"]}},
            drives={"raise": {"slides": "crank", "on": "frame", "position": "1100 + 20*t/(1 s)"}},
        )
    )
    from linkwright.expressions.language import evaluate

    position = q.mechanism.drives["raise"].position
    assert position is not None
    assert not q.findings
    assert evaluate(q.bind(position, u.LENGTH), lambda _: 1.0) == pytest.approx(1.12, rel=1e-14)


# Bare parameters (rule 1).


def test_a_parameter_takes_its_unit_from_where_it_is_used() -> None:
    q = model(
        {"AB": 40, "m": 2, "phi": 30, "n": 60, "T": 2, "k": 3},
        links={
            **links(P="AB at phi"),
            "crank": {"points": {"A": [0, 0], "B": ["AB", 0]}, "mass": "m^2*k", "shape": "rod A-B"},
        },
        drives={"motor": {"turns": "crank", "on": "frame", "speed": "n", "start": "phi"}},
        windows={"w": [0, "T"]},
    )
    assert not q.findings
    assert {name: q.dimensions.of(name) for name in ("AB", "m", "phi", "n", "T", "k")} == {
        "AB": u.LENGTH,
        "m": u.PURE,
        "phi": u.ANGLE,
        "n": u.OMEGA,
        "T": u.TIME,
        "k": u.MASS,
    }
    assert q.parameters["AB"] == pytest.approx(40 * MM)
    assert q.parameters["phi"] == pytest.approx(30 * DEG)
    assert q.parameters["n"] == pytest.approx(60 * DEG)
    assert q.parameters["T"] == 2.0


def test_units_may_be_written_on_the_parameter_instead() -> None:
    q = model({"AB": "4 cm", "n": "60 rpm"}, links=links(P=["AB", 0]))
    assert not q.findings
    assert q.parameters == {"AB": pytest.approx(0.04), "n": pytest.approx(2 * math.pi)}


def test_derived_parameters() -> None:
    q = model({"BD": "CD + 5", "CD": 80, "half": "BD/2", "ratio": "BD/CD"}, links=links(P=["half", 0]))
    assert not q.findings
    assert q.dimensions.of("CD") == u.LENGTH
    assert q.parameters["BD"] == pytest.approx(85 * MM)
    assert q.parameters["half"] == pytest.approx(42.5 * MM)
    assert q.dimensions.of("ratio").physical == u.PURE
    assert q.parameters["ratio"] == pytest.approx(85 / 80)


def test_the_cosine_rule_over_bare_lengths() -> None:
    angle = "acos((b^2 + d^2 - e^2)/(2*b*d))"
    q = model({"b": 3, "d": 4, "e": 5}, links=links(P=f"d at {angle}"))
    assert not q.findings
    assert {q.dimensions.of(name) for name in "bde"} == {u.LENGTH}
    assert point(q)[1] == pytest.approx(math.pi / 2)


def test_a_bore_is_inferred_from_a_gas_force() -> None:
    """-gas(engine.angle)*pi/4*bore^2 is a force, gas a pressure: bore is a length."""
    from linkwright.model.document import load

    q = Quantities(load(DATA / "slider_crank_gas.yaml"))
    assert not q.findings
    assert q.dimensions.of("bore") == u.LENGTH
    assert {q.dimensions.of(name) for name in ("r", "l", "e")} == {u.LENGTH}


def test_what_nothing_settles_is_a_pure_number() -> None:
    q = model({"spare": 5, "other": "2*spare"})
    assert not q.findings
    assert q.parameters == {"spare": 5.0, "other": 10.0}


def test_a_number_of_gears_stays_a_number() -> None:
    q = model({"z": "3 %"}, links=links(P=["10*z", 0]))
    assert not q.findings
    assert point(q)[0] == pytest.approx(0.3 * MM)


# The power of angle (rule 4).


def test_an_arc_is_a_length() -> None:
    q = model({"r": 10, "phi": "180 deg"}, links=links(P=["r*phi", 0], Q="r at phi"))
    assert not q.findings
    assert point(q)[0] == pytest.approx(math.pi * 10 * MM)


def test_a_bare_angle_keeps_its_unit_where_it_also_makes_an_arc() -> None:
    """Lone uses settle the power of angle first, whatever the order in the file."""
    for points in ({"P": ["r*phi", 0], "Q": "r at phi"}, {"Q": "r at phi", "P": ["r*phi", 0]}):
        q = model({"r": 10, "phi": 180}, links=links(**points))
        assert not q.findings
        assert point(q)[0] == pytest.approx(math.pi * 10 * MM)


def test_a_speed_without_radians() -> None:
    q = model(drives={"motor": {"turns": "crank", "on": "frame", "speed": "2*pi*0.5/(1 s)", "start": 0}})
    speed = q.mechanism.drives["motor"].speed
    assert speed is not None
    assert not q.findings
    assert q.value(speed, u.OMEGA) == pytest.approx(math.pi)


# Conflicts.


def only(q: Quantities) -> Finding:
    assert len(q.findings) == 1, [str(finding) for finding in q.findings]
    return q.findings[0]


def test_a_conflict_is_told_at_the_use_that_contradicts_the_definition() -> None:
    crank = {"points": {"A": [0, 0], "B": ["AB", 0]}, "mass": "AB", "shape": "rod A-B"}
    found = only(model({"AB": "40 mm"}, links={**links(), "crank": crank}))
    assert (found.code, found.path) == ("expression.units-conflict", ("links", "crank", "mass"))
    assert found.what == "'AB' has the unit mm, but kg is expected here."


def test_a_conflict_between_uses_is_told_at_the_later_one() -> None:
    crank = {"points": {"A": [0, 0], "B": ["AB", 0]}, "mass": "AB", "shape": "rod A-B"}
    found = only(model({"AB": 40}, links={**links(), "crank": crank}))
    assert found.path == ("links", "crank", "mass")


def test_a_conflict_within_a_sum_names_the_sum() -> None:
    q = model({"AB": "40 mm", "m": "2 kg"}, links=links(P=["2*(AB + m)", 0]))
    found = only(q)
    assert found.code == "expression.units-mixed"
    assert found.data["part"] == "AB + m"
    assert (found.data["given"], found.data["wanted"]) == ("mm", "kg")


def test_a_conflict_in_an_argument_names_the_argument() -> None:
    found = only(model({"AB": "40 mm"}, links=links(P=["AB*sin(AB)", 0])))
    assert (found.code, found.data["part"], found.data["wanted"]) == ("expression.units-conflict", "AB", "deg")


def test_a_conflict_in_a_derived_parameter_is_told_there() -> None:
    found = only(model({"AB": "40 mm", "BC": "AB + 1 kg"}))
    assert found.path == ("parameters", "BC")


def test_every_conflict_is_told() -> None:
    q = model({"m": "2 kg"}, links=links(P=["m", "m"], Q=["3 s", 0]))
    assert [finding.path[-1] for finding in q.findings] == ["P", "Q"]


def test_a_power_must_be_a_number() -> None:
    found = only(model({"AB": "40 mm"}, links=links(P=["1 mm*2^AB", 0])))
    assert found.data["part"] == "AB"
    assert str(found.data["wanted"]) == "1 (a pure number)"


@pytest.mark.parametrize("speed", ["2 Hz", "2*(1 Hz)", "0.1 kHz"])
def test_hertz_leave_open_what_turns(speed: str) -> None:
    q = model(drives={"motor": {"turns": "crank", "on": "frame", "speed": speed, "start": 0}})
    assert only(q).code == "expression.hertz"


def test_a_unit_that_could_be_a_parameter() -> None:
    assert only(model({"r": "3 %"}, links=links(P=["2 mm*r", 0]))).code == "expression.ambiguous-unit"
    q = model({"r": "3 %"}, links=links(P=["2 mm*(r)", 0]))
    assert not q.findings
    assert point(q)[0] == pytest.approx(0.06 * MM)
    rate = {"motor": {"turns": "crank", "on": "frame", "speed": "40 r/min", "start": 0}}
    assert not model({"r": 45}, links=links(P=["r", 0]), drives=rate).findings


# Units that aren't declared.


def test_a_missing_unit_is_told_once_at_the_first_number() -> None:
    q = model(units={"angle": "deg", "time": "s"})
    found = only(q)
    assert (found.code, found.data["base"]) == ("expression.undeclared-unit", "length")
    assert found.data["count"] > 1


def test_zero_needs_no_unit() -> None:
    q = quantities(four_bar(units={}, links={"frame": {"points": {"A": [0, 0], "D": ["1 m", 0.0]}}}, drives={}))
    assert not q.findings


def test_a_wrong_unit_is_told_and_not_missed_too() -> None:
    units = {"length": "kg", "angle": "%", "time": "s^2", "mass": "kg*mm/mm", "force": "N*m", "torque": "bar"}
    q = model(units=units)
    assert {finding.path: finding.data["usual"] for finding in q.findings} == {
        ("units", "length"): "mm",
        ("units", "angle"): "deg",
        ("units", "time"): "s",
        ("units", "mass"): "kg",
        ("units", "force"): "N",
        ("units", "torque"): "N*m",
    }
    assert {finding.code for finding in q.findings} == {"units.wrong"}


def test_an_odd_unit_must_be_written() -> None:
    q = model(measures={"m": {"max": "motor.power^2 + 3"}})
    assert only(q).code == "expression.odd-unit"
    assert only(q).data["dimension"] == "m^4*kg^2/s^6"


# Laws of inference that hold whatever the numbers.


@given(st.permutations(["a", "b", "c", "d"]), st.integers(0, 3))
@settings(max_examples=30)
def test_the_order_of_parameters_doesn_t_matter(order: list[str], which: int) -> None:
    definitions = {"a": 10, "b": "a + 2", "c": "2*b", "d": "c - a"}
    chosen = ["a", "b", "c", "d"][which]
    q = model({name: definitions[name] for name in order}, links=links(P=[chosen, 0]))
    assert not q.findings
    expected = {"a": 10, "b": 12, "c": 24, "d": 14}
    assert q.parameters == {name: pytest.approx(expected[name] * MM) for name in order}


_UNITS = {
    "mm": {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N"},
    "m": {"length": "m", "angle": "rad", "mass": "g", "time": "ms", "force": "kN"},
    "in": {"length": "in", "angle": "r", "mass": "lb", "time": "min", "force": "lbf"},
}


@given(st.sampled_from(sorted(_UNITS)), st.floats(0.1, 1e3), st.floats(0.1, 3))
def test_bare_numbers_follow_the_declared_units(name: str, length: float, angle: float) -> None:
    units = _UNITS[name]
    scale = {key: u.unit(word)[0] for key, word in units.items()}
    data = four_bar(
        units=units,
        parameters={"AB": length, "phi": angle},
        links=links(P="2*AB + 1 at phi/2"),
    )
    q = Quantities(Document.model_validate(data))
    assert not q.findings
    radius, heading = point(q)
    assert radius == pytest.approx((2 * length + 1) * scale["length"], rel=1e-12)
    assert heading == pytest.approx(angle / 2 * scale["angle"], rel=1e-12)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("3 kg", "expression.units-conflict"),
        ("foo", "name.unknown-parameter"),
        ("crank", "name.unknown-parameter"),
        ("t", "expression.not-constant"),
        ("B.x", "expression.not-constant"),
        ("2*B.q", "signal.no-attribute"),
        ("f(1)", "expression.unknown-function"),
        ("c(1 s)", "expression.not-constant"),
        ("3 N/m", "expression.units-conflict"),
    ],
)
def test_values_from_elsewhere_say_what_is_wrong_with_them(text: str, code: str) -> None:
    """Options of studies aren't the model's own: asking for their value names the fault, with units spelled."""
    from linkwright.expressions.dimensions import DimensionError
    from linkwright.expressions.fields import Expression

    q = model(tables={"c": {"points": [["0 s", 1], ["1 s", 2]]}})
    assert not q.findings
    with pytest.raises(DimensionError) as caught:
        q.value(Expression(text), u.TIME)
    assert caught.value.key == code
    finding = Finding(caught.value.key, (), caught.value.data)
    assert "Dimension" not in finding.what + finding.mend


def test_a_value_whose_unit_isn_t_declared() -> None:
    from linkwright.expressions.dimensions import DimensionError
    from linkwright.expressions.fields import Expression

    q = model(units={"length": "mm", "angle": "deg"})
    with pytest.raises(DimensionError) as caught:
        q.value(Expression(3), u.MASS)
    assert Finding(caught.value.key, (), caught.value.data).what
