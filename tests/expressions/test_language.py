"""Expressions: their grammar, their values, what is refused, and that nothing in them hangs."""

from __future__ import annotations

import math
import time

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from linkwright.expressions.language import (
    FUNCTIONS,
    Binary,
    Call,
    ExpressionError,
    Name,
    Negative,
    Node,
    Number,
    evaluate,
    nodes,
    parse,
    text_of,
)
from linkwright.notation import Jet
from linkwright.symbols import ExpressionStage, Symbol

VALUES = {"a": 2.0, "b": 3.0, "AB": 155.0, "曲柄": 7.0}


def value(text: str) -> float:
    return float(evaluate(parse(text), lambda name: VALUES[name.text]))


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("1 + 2*3", 7),
        ("2*3 + 1", 7),
        ("8 - 3 - 2", 3),
        ("8/4/2", 1),
        ("2^3^2", 512),
        ("2**3", 8),
        ("-2^2", -4),
        ("(-2)^2", 4),
        ("2^-1", 0.5),
        ("--2", 2),
        ("+-+2", -2),
        ("a*-b", -6),
        (".5 + 5.", 5.5),
        ("1e3 + 1.5E-1", 1000.15),
        ("a−b", -1),
        ("a·b × 2", 12),
        ("曲柄 + 1", 8),
        ("max(a, b) + min(a, b)", 5),
        ("hypot(3, 4)", 5),
        ("sqrt(16) + abs(-1)", 5),
        ("step5(0.5, 0, 0, 1, 10)", 5),
        ("step5(-1, 0, 2, 1, 10)", 2),
        ("atan2(1, -1)", 3 * math.pi / 4),
        ("sin(pi/2) + cos(0) + tan(0) + asin(0) + acos(1) + atan(0)", 2),
        ("exp(0) + log(1)", 1),
    ],
)
def test_arithmetic(text: str, expected: float) -> None:
    assert value(text) == pytest.approx(expected, rel=1e-15)


@pytest.mark.parametrize(
    ("text", "unit"),
    [
        ("155 mm", "mm"),
        ("155mm", "mm"),
        ("1e3mm", "mm"),
        ("-40 r/min", "r/min"),
        ("3 N*m", "N*m"),
        ("9.8 m/s^2", "m/s^2"),
        ("50 %", "%"),
        ("90°", "°"),
        ("3 µm", "µm"),
    ],
)
def test_units_bind_to_the_number_before_them(text: str, unit: str) -> None:
    assert [n.unit for n in nodes(parse(text)) if isinstance(n, Number)] == [unit]


def test_what_follows_a_unit_as_a_factor() -> None:
    assert parse("20 mm*AB") == Binary("*", Number(20.0, "mm"), Name("AB"))
    assert parse("20 mm*t/(1 s)") == Binary("/", Binary("*", Number(20.0, "mm"), Name("t")), Number(1.0, "s"))
    assert parse("5 mm*sin(3 deg)") == Binary("*", Number(5.0, "mm"), Call("sin", (Number(3.0, "deg"),)))
    assert parse("2 mm*(r)") == Binary("*", Number(2.0, "mm"), Name("r"))
    assert parse("1/20 mm") == Binary("/", Number(1.0), Number(20.0, "mm"))


def test_signals() -> None:
    assert parse("E.x") == Name("E.x")
    assert parse("force(frame, crank).x") == Call("force", (Name("frame"), Name("crank")), "x")


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "empty"),
        ("   ", "empty"),
        ("1 +", "a value is missing at the end"),
        ("1 + )", "a value is missing before ')'"),
        ("2 a", "'a' isn't a unit"),
        ("a b", "an operator is missing before 'b'"),
        ("(1", "closing bracket is missing at the end"),
        ("f(1 2)", "closing bracket is missing before '2'"),
        ("1)", "a closing bracket has no opening bracket"),
        ("E.", "a name is missing after the dot"),
        ("E.2", "an operator is missing before '.2'"),
        ("a @ b", "the character @ has no meaning here"),
        ("1:30", "the character : has no meaning here"),
        ("1_000", "'_000' isn't a unit"),
        ("0x10", "'x10' isn't a unit"),
        ("3 mm^99", "the power of a unit is one digit"),
        ("3 mm^a", "the power of a unit is one digit"),
        ("f()", "a value is missing before ')'"),
        ("1e999", "the number 1e999 is too large"),
        ("__import__('os').system('x')", "the character ' has no meaning here"),
        ("1" + "+1" * 300, "nested too deeply"),
        ("(" * 100 + "1" + ")" * 100, "nested too deeply"),
        ("2" + "^2" * 100, "nested too deeply"),
        ("1+" * 2000 + "1", "longer than 2000 characters"),
    ],
)
def test_what_is_no_expression(text: str, reason: str) -> None:
    with pytest.raises(ExpressionError) as caught:
        parse(text)
    assert reason in str(caught.value.reason)


@pytest.mark.parametrize(
    "text", ["2^9999^9999", "10^400", "(-1)^0.5", "1/0", "0/0", "0^-1", "sqrt(-1)", "log(-1)", "(1/0)^0", "2^(1/0)"]
)
def test_what_has_no_value_is_not_finite_and_comes_at_once(text: str) -> None:
    start = time.perf_counter()
    with np.errstate(all="ignore"):
        assert not math.isfinite(value(text))
    assert time.perf_counter() - start < 0.1


_leaves = st.one_of(
    st.floats(0, 1e6).map(Number),
    st.floats(0.01, 1e3).map(lambda v: Number(v, "mm")),
    st.sampled_from(["a", "b", "曲柄"]).map(Name),
    st.just(Name("E.x")),
)


def _branches(below: st.SearchStrategy[Node]) -> st.SearchStrategy[Node]:
    return st.one_of(
        st.builds(Binary, st.sampled_from("+-*/^"), below, below),
        below.map(Negative),
        st.tuples(st.sampled_from(["sin", "abs"]), below).map(lambda p: Call(p[0], (p[1],))),
        st.tuples(below, below).map(lambda p: Call("hypot", p)),
    )


def _plain(node: Node) -> bool:
    """Two signs in a row cancel when they are read."""
    return not any(isinstance(n, Negative) and isinstance(n.of, Negative) for n in nodes(node))


@given(st.recursive(_leaves, _branches, max_leaves=12).filter(_plain))
def test_the_text_of_a_tree_parses_to_that_tree(node: Node) -> None:
    again = parse(text_of(node))
    assert text_of(again) == text_of(node)
    shape = [(type(n), getattr(n, "op", getattr(n, "text", None))) for n in nodes(node)]
    assert [(type(n), getattr(n, "op", getattr(n, "text", None))) for n in nodes(again)] == shape


@given(st.text(max_size=60))
def test_any_text_parses_or_says_why_not(text: str) -> None:
    try:
        parse(text)
    except ExpressionError as error:
        assert str(error.reason)


@pytest.mark.parametrize("name", sorted(FUNCTIONS))
def test_functions_agree_on_numbers_jets_and_symbols(name: str) -> None:
    function = FUNCTIONS[name]
    at = [0.3, 0.7, 0.2, 0.9, 0.4][: function.arity]
    if name == "step5":
        at = [0.3, 0.0, 0.2, 1.0, 0.9]
    plain = float(function.apply(*at))
    jet = function.apply(*[Jet([np.array([v]), np.array([1.0])]) for v in at])
    assert jet.d[0] == pytest.approx(plain, rel=1e-14)
    symbols = Symbol.several("x", len(at))
    if name != "step5":  # its clamp compares numbers
        stage = ExpressionStage(symbols, [], [function.apply(*symbols)])
        assert stage.numbers(at, [])[0] == pytest.approx(plain, rel=1e-14)
    difference = 1e-7
    ahead, back = (float(function.apply(*[v + s * difference for v in at])) for s in (1, -1))
    assert jet.d[1] == pytest.approx((ahead - back) / (2 * difference), abs=1e-7)
