"""Transfer coefficients of the two papers that ask for them, against differences in 40 digits.

Chen Chun, *Influence of dimensional errors on the motion accuracy of planar four-bars* (in Chinese), article
1007-4414(2005)01-0047-02: its loop (3), the coefficients of (4). Peng Liping, Zi Bin, *Workspace of a hybrid-driven
planar five-bar parallel mechanism* (in Chinese), Journal of Mechanical Transmission 34(4), 2010, 20-23: its equations
(5), (7), (10). docs/validation/transfer_coefficients.md goes through both line by line.

The differences are central, with steps of 1e-15, of closed forms in 40 digits: good to 20 digits. The tolerance is
1e-12 of the largest coefficient of a pose, lengths being of the order of one; reached is 5e-14 at determinants down to
0.1.
"""

from __future__ import annotations

import contextlib
import io
import math
import re
from collections.abc import Iterator, Sequence
from decimal import Decimal, localcontext
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mpmath import mp
from numpy.typing import NDArray

import linkwright as lw
from helpers.compiled import compiled_from
from helpers.examples import four_bar
from linkwright.kernels import Compiled
from linkwright.kernels.parameter_batch import Varied
from linkwright.kernels.tangents import Tangents

Array = NDArray[np.float64]
EXAMPLES = Path(__file__).parents[2] / "examples"

DIGITS = 40
"""Cosines and sines are mpmath's, the arithmetic is that of decimals: ten times as quick."""
STEP = Decimal(10) ** -15
MECHANISMS = 1000
DETERMINANT = 0.1
"""The least normalised determinant of the dyad: the sine of its transmission angle."""
TOLERANCE = 1e-12
SIDES = ("right", "left")

Half = tuple[Decimal, Decimal]
"""Numerator and denominator of the tangent of half an angle."""


def between(a: Half, b: Half) -> Decimal:
    """The small angle from a to b, each given by the tangent of its half."""
    return 2 * (a[1] * b[0] - a[0] * b[1]) / (a[0] * b[0] + a[1] * b[1])


def shifted(numbers: Sequence[Decimal], i: int) -> list[list[Decimal]]:
    """Number i less and more by a step."""
    return [[*numbers[:i], numbers[i] + side * STEP, *numbers[i + 1 :]] for side in (-1, 1)]


def along(compiled: Compiled, names: Sequence[str]) -> Tangents:
    """The tangents by some independent parameters."""
    rows = [compiled.graph.parameters.index(name) for name in names]
    return Tangents(compiled, np.eye(len(compiled.graph.parameters))[:, rows])


@pytest.fixture(autouse=True)
def _digits() -> Iterator[None]:
    with mp.workdps(DIGITS + 5), localcontext(prec=DIGITS):
        yield


def cosine_sine(angle: float | Decimal) -> list[Decimal]:
    """In all digits."""
    number = mp.mpf(angle) if isinstance(angle, float) else mp.mpf(str(angle))
    return [Decimal(mp.nstr(v, DIGITS)) for v in mp.cos_sin(number)]


# The four-bar: l1 e1 + l2 e2 = l3 e3 + l4, the crank at phi1 (equation 3).


def outputs(l1: Decimal, l2: Decimal, l3: Decimal, l4: Decimal, c: Decimal, s: Decimal) -> tuple[Half, Half]:
    """Half of phi3 in both assemblies, C right of B-D first, at a crank angle with cosine c and sine s; from
    l2^2 = |l4 - l1 e1 + l3 e3|^2."""
    x, y = l4 - l1 * c, -l1 * s
    k, a, b = x * x + y * y + l3 * l3 - l2 * l2, 2 * l3 * x, 2 * l3 * y
    root = (a * a + b * b - k * k).sqrt()
    return (root - b, k - a), (-root - b, k - a)


def output_slopes(lengths: Sequence[float], phi1: float) -> list[tuple[float, list[float]]]:
    """Of both assemblies phi3 and its derivatives by l1 .. l4 and phi1."""
    sizes, (c, s), (dc, ds) = [Decimal(v) for v in lengths], cosine_sine(phi1), cosine_sine(STEP)
    turned = [[*sizes, c * dc + side * s * ds, s * dc - side * c * ds] for side in (1, -1)]
    around = [[outputs(*v) for v in two] for two in (*(shifted([*sizes, c, s], i) for i in range(4)), turned)]
    found = []
    for which, (up, down) in enumerate(outputs(*sizes, c, s)):
        slopes = [float(between(one[which], other[which]) / (2 * STEP)) for one, other in around]
        found.append((2 * math.atan2(up, down), slopes))
    return found


def sine_of_transmission(l1: Array, l2: Array, l3: Array, l4: Array, phi1: Array) -> Array:
    """From the triangle of coupler, rocker and diagonal; 0 where there is none."""
    cosine = (l2 * l2 + l3 * l3 - l1 * l1 - l4 * l4 + 2 * l1 * l4 * np.cos(phi1)) / (2 * l2 * l3)
    return np.sqrt(np.maximum(1 - cosine**2, 0))


def test_coefficients_of_random_four_bars() -> None:
    names, t = ["l1", "l2", "l3", "l4", "phi1"], np.array([0.0, 0.7, 1.3])
    data: Any = four_bar(*names[:4], parameters=dict(zip(names, (1, 3, 3, 4, 0.5), strict=True)))  # type: ignore[arg-type]
    data["drives"]["motor"]["start"] = "phi1"
    both = [Tangents(compiled_from(data | {"assembly": {"C": f"{side} of B-D"}}), np.eye(5)) for side in SIDES]
    rng = np.random.default_rng(2005)
    drawn = np.vstack([rng.uniform(0.3, 3, (4, 25 * MECHANISMS)), rng.uniform(0, 2 * np.pi, 25 * MECHANISMS)])
    sines = np.array([sine_of_transmission(*drawn[:4], drawn[4] + time) for time in t])
    some = drawn[:, (sines > DETERMINANT).all(axis=0)][:, :MECHANISMS]
    assert some.shape[1] == MECHANISMS
    for row in Varied(both[0].compiled, names).parameters(some).T:
        expected = [output_slopes(row[:4].tolist(), float(row[4] + time)) for time in t]
        for which, tangents in enumerate(both):
            values, slopes = tangents.at_parameters(row).evaluate(["rocker.angle"], t)
            for k in range(t.size):
                angle, wanted = expected[k][which]
                assert math.sin((values[0, k] - angle) / 2) == pytest.approx(0, abs=1e-13)
                assert np.abs(slopes[0, :, k] - wanted).max() < TOLERANCE * np.abs(wanted).max()


def test_coefficients_of_the_function_generator() -> None:
    """The example: what Freudenstein's equation asks for, the coefficients over its range, equation (4)'s limit."""
    compiled = lw.compile(lw.load(EXAMPLES / "four_bar_accuracy.yaml"))
    names, t = list(compiled.graph.parameters), np.linspace(0, 1, 7)
    slopes = Tangents(compiled, np.eye(len(names))).evaluate(["rocker.angle"], t)[1][0]
    rows = [names.index(name) for name in ("l1", "l2", "l3", "l4", "phi1")]
    lengths, phi1, swing = compiled.parameters[rows[:4]], compiled.parameters[rows[4]], math.radians(60)
    for k, time in enumerate(t):
        expected = np.array(output_slopes(lengths.tolist(), phi1 + swing * time)[1][1])
        assert np.abs(slopes[rows, k] - expected).max() < TOLERANCE * np.abs(expected).max()
    x = 1.5 - 0.5 * np.cos(np.radians([30, 90, 150]))
    phi, psi = math.radians(90) + swing * (x - 1), math.radians(90) * np.log2(x)
    one, two, three = np.linalg.solve(np.column_stack([np.cos(psi), -np.cos(phi), 0 * x + 1]), np.cos(phi - psi))
    l1, l3 = 50 / one, 50 / two
    wanted = [l1, math.sqrt(l1**2 + l3**2 + 2500 - 2 * l1 * l3 * three), l3, 50]
    np.testing.assert_allclose(lengths * 1e3, wanted, atol=0.005)


# The five-bar of equations (1) to (7): theta3 is the angle of l3 from C to D, link3's own is from D to C.


def working_points(
    numbers: Sequence[Decimal], first: Sequence[Decimal], fourth: Sequence[Decimal]
) -> list[tuple[Half, list[Decimal]]]:
    """In both assemblies, C left of B-D first: half of theta3 by (5), the working point by (7).

    ``numbers`` are l1 .. l5, r2, the cosine and the sine of alpha; ``first`` and ``fourth`` those of theta1 and theta4.
    """
    (l1, l2, l3, l4, l5, r2, ca, sa), (c1, s1), (c4, s4) = numbers, first, fourth
    a = l1 * l1 + l3 * l3 + l4 * l4 + l5 * l5 - l2 * l2
    b = 2 * l4 * l5 * c4 - 2 * l1 * l4 * (c4 * c1 + s4 * s1) - 2 * l1 * l5 * c1
    c, d = 2 * l3 * (l4 * c4 + l5 - l1 * c1), 2 * l3 * (l4 * s4 - l1 * s1)
    root = (d * d - (a + b + c) * (a + b - c)).sqrt()
    found = []
    for up, down in ((d - root, a + b + c), (d + root, a + b + c)):
        square = up * up + down * down
        cosine, sine = (down * down - up * up) / square, 2 * up * down / square
        x = l5 + l4 * c4 - r2 * (cosine * ca + sine * sa)
        found.append(((up, down), [x, l4 * s4 - r2 * (sine * ca - cosine * sa)]))
    return found


def point_slopes(sizes: Sequence[float], theta1: float, theta4: float) -> list[tuple[float, Array, Array, Array]]:
    """Of both assemblies theta3, its derivatives by l1 .. l5, the working point, and the derivatives of x and y by
    l1 .. l5, alpha, r2: (2, 7)."""
    *lengths, _, r2 = (Decimal(v) for v in sizes)
    first, fourth, (ca, sa), (dc, ds) = (cosine_sine(v) for v in (theta1, theta4, sizes[5], STEP))
    numbers = [*lengths, r2, ca, sa]
    pairs = [shifted(numbers, i) for i in range(5)]
    pairs.append([[*lengths, r2, ca * dc + side * sa * ds, sa * dc - side * ca * ds] for side in (1, -1)])
    pairs.append(shifted(numbers, 5))
    around = [[working_points(v, first, fourth) for v in two] for two in pairs]
    found = []
    for which, ((up, down), place) in enumerate(working_points(numbers, first, fourth)):
        two = [(less[which], more[which]) for less, more in around]
        turns = np.array([float(between(less[0], more[0]) / (2 * STEP)) for less, more in two[:5]])
        wanted = np.array([[float((more[1][i] - less[1][i]) / (2 * STEP)) for less, more in two] for i in (0, 1)])
        found.append((2 * math.atan2(up, down), turns, np.array(place, dtype=float), wanted))
    return found


def by_the_paper(theta3: float, alpha: float, r2: float, theta4: float, turns: Array) -> Array:
    """(10), from dtheta3/dl1 .. dl5: the derivatives of x and y by l1 .. l5, alpha, r2: (2, 7)."""
    u, fourth, fifth = theta3 - alpha, np.eye(5)[3], np.eye(5)[4]
    dx = fifth + fourth * math.cos(theta4) + r2 * math.sin(u) * turns
    dy = fourth * math.sin(theta4) - r2 * math.cos(u) * turns
    return np.array(
        [
            [*dx, -r2 * math.sin(u), -math.cos(u)],
            [*dy, r2 * math.cos(u), -math.sin(u)],
        ]
    )


def test_coefficients_of_the_working_point_of_random_five_bars() -> None:
    names = ["l1", "l2", "l3", "l4", "l5", "alpha", "r2"]
    document = lw.load(EXAMPLES / "five_bar_workspace.yaml")
    other = document.model_dump(by_alias=True, exclude_none=True, mode="json") | {"assembly": {"C": "right of B-D"}}
    both = [along(compiled, names) for compiled in (lw.compile(document), compiled_from(other))]
    rng = np.random.default_rng(2010)
    draws = 8 * MECHANISMS
    paper = np.array([[0.8], [2.6], [2.8], [1.0], [3.0], [math.radians(60)], [2.0]])
    drawn = paper * rng.uniform(0.4, 2, (7, draws))
    drawn[:, 0] = paper[:, 0]  # the paper's own lengths, a hundredfold: all derivatives are of the order of one
    times = rng.uniform(0, 2, draws)
    theta1 = math.pi * times
    theta4 = math.pi / 2 + math.pi * times + math.radians(40) * np.sin(math.pi * times)
    way = drawn[4] + drawn[3] * np.exp(1j * theta4) - drawn[0] * np.exp(1j * theta1)
    cosine = (drawn[1] ** 2 + drawn[2] ** 2 - np.abs(way) ** 2) / (2 * drawn[1] * drawn[2])
    some = np.flatnonzero(1 - cosine**2 > DETERMINANT**2)[:MECHANISMS]
    assert (some.size, some[0]) == (MECHANISMS, 0)
    for k, row in zip(some, Varied(both[0].compiled, names).parameters(drawn[:, some]).T, strict=True):
        sizes = [float(v) for v in drawn[:, k]]
        expected = point_slopes(sizes, float(theta1[k]), float(theta4[k]))
        for tangents, (theta3, turns, place, wanted) in zip(both, expected, strict=True):
            signals = ["link3.angle", "P.x", "P.y"]
            values, slopes = tangents.at_parameters(row).evaluate(signals, times[[k]])
            np.testing.assert_allclose(values[1:, 0], place, atol=1e-13)
            formula = by_the_paper(theta3, sizes[5], sizes[6], float(theta4[k]), turns)
            for found, reference in ((slopes[1:, :, 0], wanted), (slopes[1:, :, 0], formula)):
                assert np.abs(found - reference).max() < TOLERANCE * np.abs(wanted).max()
            assert np.abs(slopes[0, :5, 0] - turns).max() < TOLERANCE * np.abs(turns).max()


def test_the_page_shows_what_its_snippets_print(monkeypatch: pytest.MonkeyPatch) -> None:
    """docs/validation/transfer_coefficients.md; its snippets hold each line of the papers to the coefficients."""
    monkeypatch.chdir(EXAMPLES.parent)
    page = (EXAMPLES.parent / "docs" / "validation" / "transfer_coefficients.md").read_text(encoding="utf-8")
    pairs = re.findall(r"```python\n(.*?)```\s*```text\n(.*?)```", page, re.S)
    assert len(pairs) == page.count("```python") == 3
    names: dict[str, Any] = {}
    for snippet, shown in pairs:
        with contextlib.redirect_stdout(io.StringIO()) as said:
            exec(snippet, names)
        assert said.getvalue() == shown
    for formula, ours in ((names["x"], names["ours"][0]), (names["y"], names["ours"][1])):
        np.testing.assert_allclose(ours, formula, rtol=0, atol=1e-13 * np.abs(formula).max())
