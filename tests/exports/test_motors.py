"""Motors' texts: the table of a published example, every function of laws, and an evaluator that takes nothing else."""

from __future__ import annotations

import csv
import io
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from linkwright.exports import Exported
from linkwright.exports.motors import target
from linkwright.formulas.evaluate import value
from linkwright.model.document import read_document

EXAMPLES = Path(__file__).parents[2] / "examples"
ARM = """\
linkwright: 1
units: {length: mm, angle: deg, time: s}
parameters: {m: 15, w: 15 deg}
links:
  frame: {points: {O: [0, 0]}}
  arm: {points: {O: [0, 0], B: [100, 0]}}
tables:
  wave: {points: [[0, 0], [90, 8], [200, -3], [300, 4]], period: 360}
  way: {points: [[-1 s, 5], [1 s, 9], [2.5 s, -2], [4 s, 0], [6 s, 3], [9 s, 4], [40 s, 5]], between: quintic}
laws:
  swing:
    over: angle
    of: angle
    segments:
      - {rise: m, over: 90, law: cycloidal}
      - {dwell: 180}
      - {fall: m, over: 75, law: cycloidal}
      - {dwell: 15}
  feed:
    over: time
    of: angle
    beyond: advance
    segments: [{rise: 60, over: 1, law: modified_sine}, {dwell: 0.5}]
  once:
    over: time
    of: angle
    beyond: hold
    segments: [{rise: 20, over: 1.5, formula: "(2*u - 1)*(1 - abs(2*u - 1)/2) + 1/2"}]
drives:
  motor:
    turns: arm
    on: frame
    LAW
"""


def model(law: str) -> lw.Document:
    """An arm turned by a law: its position, or lines that begin with its speed."""
    lines = law if law.startswith("position") else law.replace(", ", "\n    ")
    document, source = read_document(ARM.replace("LAW", lines).encode())
    assert document is not None, source.findings
    return document


def exported(law: str, **options: Any) -> Exported:
    return lw.export(model(law), "motor-expressions", **options)


def pieces(found: Exported) -> list[tuple[str, float, float, str]]:
    """Domain, start, stop, text as the table has them."""
    text = found.files["motors.csv"]
    assert isinstance(text, str)
    domains = [piece["domain"] for motor in found.summary["motors"].values() for piece in motor["pieces"]]
    rows = [*csv.reader(io.StringIO(text))][1:]
    return [(domain, float(r[2]), float(r[3]), r[4]) for domain, r in zip(domains, rows, strict=True)]


def by_python(text: str, t: float, unit: float) -> float:
    """The value of a text by Python's own arithmetic; ``unit`` is that of an angle in rad."""
    names: dict[str, Any] = {"t": t, "sqrt": math.sqrt, "ln": math.log}
    names |= {f.__name__: lambda x, f=f: f(x * unit) for f in (math.sin, math.cos, math.tan)}
    names |= {f.__name__: lambda x, f=f: f(x) / unit for f in (math.asin, math.acos)}
    return float(eval(text.replace("^", "**"), names))


LAWS = {
    "speed: 60 rpm, start: 40 deg": 1,
    "speed: -3 rpm, start: 0 deg, acceleration: 20 deg/s^2": 1,
    "position: 20 deg*sin(180 deg*t/(1 s) + 30 deg)*cos(w*t/(1 s))^2": 1,
    "position: step5(t, 1 s, 0, 2 s, 90 deg) + step5(2*t, 6 s, 0 deg, 8 s, -90 deg)": 5,
    "position: wave(250*t/(1 s) - 100)": None,
    "position: 2*way(2.5 s - t/2)": None,
    "position: way(t*t/(1 s))": None,
    "position: abs(way(t)) - min(max(t/(1 s), 2), 4)*1 deg": None,
    "position: wave(step5(t, 1 s, 0 deg, 3 s, 500 deg))": None,
    "position: swing(120 deg*t/(1 s)) + feed(t)": None,
    "position: once(t - 1 s)": 4,
    "position: once(5 s - t) - feed(-t)": None,
    "position: atan2(sin(90 deg*t/(1 s)), cos(90 deg*t/(1 s)))": None,
    "position: 1 deg*(exp(-t/(1 s))*hypot(t, 1 s)/(1 s) + log(1 + t/(1 s))^2/sqrt(1 + t/(1 s)))": 1,
    "position: atan(3*t/(1 s)) - asin(t/(9 s)) + acos(t/(8 s)) + tan(10 deg*t/(1 s))*1 deg": 1,
    "position: 3 deg*(t/(1 s) - 2)^3 - 1 deg*(1 - t/(1 s))/(t/(1 s) + 1) + (t/(1 s) + 1)^(-2)*1 deg": 1,
}


@pytest.mark.parametrize("dialect", ["creo", "radians"])
@pytest.mark.parametrize(("law", "count"), LAWS.items())
def test_texts_are_the_law(law: str, count: int | None, dialect: str) -> None:
    """Everywhere, to round-off, by Python and by the evaluator; domains fit together."""
    found = exported(law, duration="6 s", dialect=dialect)
    assert found.done
    rows = pieces(found)
    assert count in (None, len(rows))
    assert [rows[0][1], *(stop for _, _, stop, _ in rows)] == [*(start for _, start, _, _ in rows), 6]
    exact = lw.compile(model(law)).laws["motor"]
    unit = np.pi / 180 if dialect == "creo" else 1.0
    worst = 0.0
    for _, start, stop, text in rows:
        assert "e" not in text.replace("e+", "") and "--" not in text
        t = np.linspace(start, stop, 11)[1:-1]
        wanted = np.broadcast_to(exact(t).d[0], t.shape) * 180 / np.pi
        mine = value(text, t, dialect == "creo")
        assert mine == pytest.approx([by_python(text, float(x), unit) for x in t], abs=1e-10)
        worst = max(worst, float(np.abs(mine - wanted).max()))
    assert worst < 1e-9 and found.summary["motors"]["motor"]["max_error"] < 1e-9
    assert found.summary["max_error"] == pytest.approx(np.deg2rad(found.summary["motors"]["motor"]["max_error"]))


def test_values_and_units() -> None:
    """A slide in the file's unit, an output's law, the table of values."""
    found = lw.export(EXAMPLES / "boom_cylinder.yaml", "motor-expressions", samples=4)
    ((domain, _, _, text),) = pieces(found)
    assert (domain, text) == ("0 <= t <= 4", "1100 + 50*t")
    heads, *rows = csv.reader(io.StringIO(str(found.files["motion.csv"])))
    assert heads == ["t [s]", "raise [mm]"]
    assert np.array(rows, dtype=float) == pytest.approx(np.array([[t, 1100 + 50 * t] for t in range(5)]))
    found = lw.export(EXAMPLES / "press_law.yaml", "motor-expressions")
    assert [text for *_, text in pieces(found)] == ["222 - 40*cos(360*t) + 5*sin(720*t)"]
    assert "the output of motor" in str(found.files["motors.txt"])


def test_nobody_says_how_long() -> None:
    found = exported("speed: 60 rpm, start: 0")
    assert [finding.code for finding in found.failures] == ["export.no-duration"] and not found.files


def test_more_pieces_than_anyone_types() -> None:
    found = exported("position: wave(t*360 deg/(1 s))", duration="2000 s")
    assert found.done and [finding.code for finding in found.warnings] == ["export.too-many-pieces"]
    assert found.summary["motors"] == {} and str(found.files["motion.csv"]).startswith("t [s],motor [deg]\n0.0,")


def test_a_table_that_ends_is_told() -> None:
    with pytest.raises(lw.ModelError, match=r"drive\.outside-table"):
        exported("position: way(t)", duration="50 s")


def test_what_is_not_proven_is_not_given(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(target, "PROVEN", 0.0)
    found = exported("position: 20 deg*sin(1 deg*t/(1 s) + 0.3)", duration="6 s")
    assert [finding.code for finding in found.failures] == ["export.unproven"] and not found.files
