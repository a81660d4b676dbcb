"""Every registered law: its ends, its derivatives, its text, its symmetry, and its peak factors as published.

The factors are those of R. L. Norton, Cam Design and Manufacturing Handbook, 2nd ed., ch. 3 and 4, and of
H. A. Rothbart, Cam Design Handbook (the 8th-degree law), where a closed form is known by that form (1e-12), else to
the digits printed.
"""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest

from laws.texts import value
from linkwright.laws import LAWS, Law, of_powers, scca, scca_by_widths
from linkwright.laws.scca import MEMBERS, factors
from linkwright.notation import Jet
from linkwright.notation.duals import Dual

PI = math.pi
EVERY = pytest.mark.parametrize("law", LAWS.values(), ids=LAWS)
INSIDE = np.array([0.03, 0.11, 0.21, 0.37, 0.46, 0.58, 0.69, 0.83, 0.97])
# name: Cv, Ca, jerk at the ends, jerk of the other sign (at the crossover), relative tolerance
TABLE = {
    "parabolic": (2, 4, 0, 0, 1e-12),
    "simple_harmonic": (PI / 2, PI**2 / 2, 0, 15.503, 1e-4),
    "cycloidal": (2, 2 * PI, 4 * PI**2, 4 * PI**2, 1e-12),
    "modified_trapezoid": (2, 8 * PI / (2 + PI), 61.4260, 61.4260, 1e-6),
    "modified_sine": (1.75960, 4 * PI**2 / (4 + PI), 69.4664, 23.1555, 3e-6),
    "ms_cv20": (1.52754, 5.99863, 94.226, 31.409, 2e-5),
    "ms_cv33": (1.40409, 6.61660, 124.720, 41.573, 2e-5),
    "mcv50": (1.27526, 8.01268, 201.381, 67.127, 2e-5),
    "cycloidal_cv50": (4 / 3, 8.37758, 105.276, 105.276, 4e-6),
    "poly_23": (1.5, 6, -12, 12, 1e-12),
    "poly_345": (1.875, 10 / math.sqrt(3), 60, 30, 1e-12),
    "poly_4567": (2.1875, 84 / (5 * math.sqrt(5)), 0, 52.5, 1e-12),
    "poly_56789": (2.46094, 9.37198, 0, 78.75, 2e-6),
    "double_harmonic": (2.04052, PI**2, 0, 42.41, 1e-4),
    "gutman_13": (2, 2 * PI * math.sqrt(2 / 3), 59.218, 59.218, 1e-5),
    "freudenstein_13": (2, 5.38559, 50.758, 50.758, 2e-6),
    "eighth_degree": (1.77666, 5.2683, 36.585, None, 1e-5),
    "constant_velocity": (1, math.inf, 0, 0, 1e-12),
}


def test_the_table_has_every_law() -> None:
    assert set(TABLE) == set(LAWS)


@pytest.mark.parametrize("name", TABLE)
def test_peak_factors_are_those_of_the_literature(name: str) -> None:
    law, (velocity, acceleration, end, crossover, tolerance) = LAWS[name], TABLE[name]
    assert law.factor(1) == pytest.approx(velocity, rel=tolerance)
    assert law.factor(2) == pytest.approx(acceleration, rel=tolerance)
    assert law.end_derivatives()[0][3] == pytest.approx(end, rel=tolerance, abs=1e-10)
    if crossover is not None:
        assert -law.peaks(3)[0].value == pytest.approx(crossover, rel=tolerance, abs=1e-10)


@pytest.mark.parametrize(("name", "jerk"), [("poly_4567", 42.0), ("poly_56789", 360 / 7), ("double_harmonic", 20.5755)])
def test_the_largest_jerk_where_it_is_not_at_an_end(name: str, jerk: float) -> None:
    assert LAWS[name].peaks(3)[1].value == pytest.approx(jerk, rel=1e-5 if name == "double_harmonic" else 1e-12)


def test_signed_peaks_of_the_double_harmonic() -> None:
    low, high = LAWS["double_harmonic"].peaks(2)
    assert (low.value, low.at) == pytest.approx((-(PI**2), 1.0), rel=1e-12)
    assert high.value == pytest.approx(5.5517, rel=1e-5)


@EVERY
def test_a_law_goes_from_0_to_1(law: Law) -> None:
    assert law.at([0.0, 1.0]) == pytest.approx([0, 1], abs=1e-14)
    slope = 1.0 if law.name == "constant_velocity" else 0.0
    assert [end[1] for end in law.end_derivatives()] == pytest.approx([slope, slope], abs=1e-13)
    assert law.end_derivatives()[1][2] == pytest.approx(
        {"double_harmonic": -(PI**2), "eighth_degree": -5.2683, "simple_harmonic": -(PI**2) / 2, "parabolic": -4,
         "poly_23": -6}.get(law.name, 0.0), rel=1e-12, abs=1e-11)  # fmt: skip
    assert law.symmetric == (not law.mirrored)
    assert law.mirrored == (law.name in ("double_harmonic", "eighth_degree"))


@EVERY
def test_text_and_derivatives_against_mpmath(law: Law) -> None:
    """The text of each piece says the law, and its derivatives by mpmath are the law's, to the fourth order."""
    pieces = law.pieces()
    assert [piece[1] for piece in pieces[:-1]] == [piece[0] for piece in pieces[1:]]
    assert (pieces[0][0], pieces[-1][1]) == (0.0, 1.0)
    with mp.workdps(40):
        for start, stop, text in pieces:
            for share in (0.2, 0.7):
                x = start + share * (stop - start)
                wanted = [mp.diff(lambda at, text=text: value(text, at), mp.mpf(x), k) for k in range(5)]
                found = [float(law.at(x, k)) for k in range(5)]
                for k in range(5):
                    assert found[k] == pytest.approx(float(wanted[k]), rel=1e-12, abs=2e-13 * law.sizes[k])


@EVERY
def test_on_jets_and_duals(law: Law) -> None:
    """Of u(t) = t^2: the rates of s(u(t)), and their derivatives by a deviation of u's scale."""
    t = np.sqrt(INSIDE)
    jet = law(Jet([INSIDE, 2 * t, np.full(9, 2.0), np.zeros(9), np.zeros(9)]))
    s = [law.at(INSIDE, k) for k in range(5)]
    assert jet.d[0] == pytest.approx(s[0])
    assert jet.d[2] == pytest.approx(4 * INSIDE * s[2] + 2 * s[1])
    assert jet.d[4] == pytest.approx(16 * INSIDE**2 * s[4] + 48 * INSIDE * s[3] + 12 * s[2])
    tangent = law(Jet([Dual(INSIDE, INSIDE), Dual(2 * t, 2 * t), Dual(np.full(9, 2.0), np.full(9, 2.0))]))
    assert tangent.d[1].slope == pytest.approx(2 * t * (INSIDE * s[2] + s[1]))
    assert tangent.d[2].slope == pytest.approx(4 * INSIDE**2 * s[3] + 8 * INSIDE * s[2] + 2 * s[1] + 2 * INSIDE * s[2])


def test_continuity() -> None:
    wanted = {
        "constant_velocity": (0, 4, 0), "parabolic": (1, 1, 1), "simple_harmonic": (1, 4, 1), "poly_23": (1, 4, 1),
        "cycloidal": (2, 4, 2), "modified_trapezoid": (2, 3, 2), "poly_345": (2, 4, 2), "poly_4567": (3, 4, 3),
        "poly_56789": (4, 4, 4), "double_harmonic": (3, 4, 1), "eighth_degree": (2, 4, 1), "ms_cv20": (2, 2, 2),
    }  # fmt: skip
    assert {name: LAWS[name].continuity for name in wanted} == wanted
    assert LAWS["simple_harmonic"].factor(3) == math.inf


def test_a_modified_trapezoid_does_not_jump() -> None:
    """Open packages have one that jumps by a full lift."""
    u = np.linspace(0, 1, 4001)
    assert np.abs(np.diff(LAWS["modified_trapezoid"].at(u))).max() < 2 / 4000 * 1.0001


@pytest.mark.parametrize("fractions", [*MEMBERS.values(), (0.3, 0.1, 0.4, 0.2), (0.1, 0.6, 0.05, 0.25)])
def test_the_scca_family_against_its_closed_form(fractions: tuple[float, float, float, float]) -> None:
    law, (velocity, acceleration, end, crossover) = Law(scca(*fractions).parts), factors(*fractions)
    found = (law.factor(1), law.factor(2))
    assert found == pytest.approx((velocity, acceleration), rel=1e-12)
    b, _, d, _ = fractions
    if b:
        assert law.end_derivatives()[0][3] == pytest.approx(end, rel=1e-12)
    if d:
        assert -law.peaks(3)[0].value == pytest.approx(max(crossover, end if b else 0) if b == d else crossover)
    u = np.linspace(0, 1, 50)
    single = LAWS["cycloidal"] if fractions == MEMBERS["cycloidal"] else LAWS["simple_harmonic"]
    if fractions in (MEMBERS["cycloidal"], MEMBERS["simple_harmonic"]):
        assert law.at(u) == pytest.approx(single.at(u), abs=1e-14)


def test_an_unsymmetric_member() -> None:
    law = Law(scca_by_widths(0.1, 0.1, 0.1, 0.2, 0.2, 0.1, 0.2).parts)
    assert law.at([0.0, 1.0]) == pytest.approx([0, 1], abs=1e-14)
    assert law.end_derivatives()[1][1:3] == pytest.approx([0, 0], abs=1e-12)
    assert law.continuity == (2, 2, 2)
    low, high = law.peaks(2)
    assert high.value / -low.value == pytest.approx((2 / PI * 0.4 + 0.1) / (2 / PI * 0.2 + 0.1), rel=1e-12)


@pytest.mark.parametrize("name", ["cycloidal", "modified_sine", "poly_345"])
def test_a_skewed_law(name: str) -> None:
    law = LAWS[name].skewed(0.4)
    assert law.peaks(1)[1].at == pytest.approx(0.4)
    assert law.at([0.0, 0.4, 1.0]) == pytest.approx([0, 0.4, 1], abs=1e-14)
    assert law.continuity[1] == 2
    low, high = law.peaks(2)
    assert high.value / -low.value == pytest.approx(0.6 / 0.4, rel=1e-12)


def test_powers() -> None:
    u = np.linspace(0, 1, 30)
    for powers, name in (((2, 3), "poly_23"), ((3, 4, 5), "poly_345"), ((5, 6, 7, 8, 9), "poly_56789")):
        assert of_powers(powers).at(u) == pytest.approx(LAWS[name].at(u), abs=1e-13)
