"""Rows of programs: their labels, the orders they need, and what names them."""

from __future__ import annotations

import numpy as np
import pytest

from helpers.compiled import compiled_from
from helpers.examples import four_bar
from linkwright.expressions.dimensions import DimensionError
from linkwright.expressions.language import ExpressionError
from linkwright.graph.rows import (
    BodyPlace,
    CoordinateRate,
    Determinant,
    Gap,
    OutputLever,
    Radicand,
    RawAngle,
    ReachRow,
    Row,
    SignalRow,
    Slope,
    Span,
    Strength,
    TableArgument,
    WindowRow,
    determinants,
    reaches,
    spans,
)

LABELS: dict[Row, str] = {
    ReachRow("a-b"): "reach:a-b",
    Span("a-b"): "span:a-b",
    Radicand("a-b"): "room:a-b",
    Determinant("a-b"): "determinant:a-b",
    Gap("a-b", 1): "gap:a-b:1",
    Slope("a-b", 3): "slope:a-b:3",
    CoordinateRate("a-b", 0): "rate:a-b:0",
    BodyPlace("crank", "cos"): "crank:cos",
    OutputLever(): "drives over outputs:",
    RawAngle("crank"): "raw/crank",
    Strength("loads", "push"): "loads/push",
    WindowRow("stroke"): "window/stroke",
    TableArgument(2): "argument/2",
}


def test_labels() -> None:
    """They stand in programs and in generated code."""
    assert {row: row.label for row in LABELS} == LABELS


def test_rows_of_different_kinds_differ() -> None:
    assert len({*LABELS}) == len(LABELS)
    assert ReachRow("a-b") != Span("a-b")
    assert ReachRow("a-b") == ReachRow("a-b")


def test_a_program_takes_signals_by_name_and_other_rows() -> None:
    compiled = compiled_from(four_bar())
    graph = compiled.graph
    (group,) = compiled.structure.groups
    program = graph.program(["C.x", ReachRow(group.label)], rates=True)
    assert program.outputs == ("C.x", "d(C.x)", f"reach:{group.label}", f"d(reach:{group.label})")
    signal = SignalRow(graph.signal("C.x"))
    assert signal.label == "C.x"
    t = np.linspace(0.0, 1.0, 7)
    assert np.array_equal(compiled.evaluate([signal], t), compiled.evaluate(["C.x"], t))
    assert graph.signals(["C.x", ReachRow(group.label)]) == [signal.signal, None]


@pytest.mark.parametrize("text", ["reach:coupler-rocker", "crank:x", "raw/crank", "loads/push", "nothing.x", "crank"])
def test_only_signals_have_texts(text: str) -> None:
    with pytest.raises((ExpressionError, DimensionError, AssertionError)):
        compiled_from(four_bar()).graph.program([text])


def test_each_kind_of_signal_has_an_order() -> None:
    graph = compiled_from(four_bar()).graph
    orders = {graph.order([signal.text]) for signal in graph.quantities.signals.all()}
    assert orders == {0, 1, 2, 3}
    assert [graph.order([text]) for text in ("C.x", "C.vx", "rocker.alpha", "motor.torque", "C.jy")] == [0, 1, 2, 2, 3]
    assert graph.order([]) == 0


def test_rows_of_a_structure() -> None:
    structure = compiled_from(four_bar()).structure
    labels = [group.label for group in structure.groups]
    assert [row.group for row in reaches(structure)] == labels
    assert [row.group for row in determinants(structure)] == labels
    assert [row.group for row in spans(structure)] == [g.label for g in structure.groups if g.has_span]
