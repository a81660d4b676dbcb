"""Units: what written units mean, and how quantities are spelled in declared ones."""

from __future__ import annotations

import math

import pint
import pytest

from linkwright.expressions import units as u
from linkwright.expressions.units import Dimension, UnitError, si_text, unit, unit_text

MM = {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"}


@pytest.fixture(scope="module")
def registry() -> pint.UnitRegistry:
    """Pint's own, as it comes."""
    return pint.UnitRegistry(cache_folder=None)


@pytest.mark.parametrize("word", u.unit_words())
def test_every_word_means_what_pint_says(word: str, registry: pint.UnitRegistry) -> None:
    """Also those that are built in so that pint needn't be loaded."""
    name = u._WORDS[word]
    quantity = (1 * registry.parse_units(name)).to_base_units()
    factor, dimension = unit(word)
    assert factor == pytest.approx(quantity.magnitude, rel=1e-15)
    powers = {str(key): power for key, power in quantity.dimensionality.items()}
    assert dimension.physical == Dimension(powers.get("[length]", 0), powers.get("[mass]", 0), powers.get("[time]", 0))


@pytest.mark.parametrize("word", ["rad", "mrad", "deg", "°", "rev", "r", "turn", "arcmin", "arcsec"])
def test_angles_count_as_angles(word: str) -> None:
    assert unit(word)[1] == u.ANGLE


def test_speeds_of_rotation() -> None:
    for text in ("rpm", "r/min", "rev/min", "turn/min"):
        factor, dimension = unit(text)
        assert 40 * factor == pytest.approx(4.18879, abs=5e-6)
        assert dimension == u.OMEGA
    assert unit("Hz") == (1.0, Dimension(0, 0, -1))


@pytest.mark.parametrize(
    ("text", "factor", "dimension"),
    [
        ("mm", 1e-3, u.LENGTH),
        ("N*m", 1.0, u.TORQUE),
        ("Nmm", 1e-3, u.TORQUE),
        ("kg*mm^2", 1e-6, u.INERTIA),
        ("mm/s^2", 1e-3, u.ACCELERATION),
        ("1/s", 1.0, Dimension(0, 0, -1)),
        ("N/mm^2", 1e6, u.PRESSURE),
        ("km/h", 1 / 3.6, u.SPEED),
        ("%", 0.01, u.PURE),
        ("", 1.0, u.PURE),
        ("1", 1.0, u.PURE),
        ("µm", 1e-6, u.LENGTH),
        ("μm", 1e-6, u.LENGTH),
    ],
)
def test_composed_units(text: str, factor: float, dimension: Dimension) -> None:
    assert unit(text) == (pytest.approx(factor, rel=1e-14), dimension)


@pytest.mark.parametrize(
    "text",
    ["furlong", "mm//s", "mm*", "*mm", "mm mm", "mm^", "mm^0", "mm^10", "mm^-1", "2 mm", "km^9*km^9*km^9", "mm^x"],
)
def test_what_is_no_unit(text: str) -> None:
    with pytest.raises(UnitError):
        unit(text)


@pytest.mark.parametrize(
    ("dimension", "text"),
    [
        (u.PURE, ""),
        (u.LENGTH, "mm"),
        (u.OMEGA, "deg/s"),
        (u.ANGULAR_JERK, "deg/s^3"),
        (u.FORCE, "N"),
        (u.TORQUE, "N*m"),
        (u.POWER, "W"),
        (u.ENERGY, "J"),
        (u.INERTIA, "kg*mm^2"),
        (Dimension(0, 1, -2), "N/mm"),
        (Dimension(-1), "1/mm"),
        (Dimension(4), "mm^4"),
        (Dimension(3, 0, -1), "mm^3/s"),
        (Dimension(1, 0, 0, -1), "mm/deg"),
    ],
)
def test_quantities_are_spelled_in_declared_units(dimension: Dimension, text: str) -> None:
    assert unit_text(dimension, MM) == text
    assert unit(text)[1].physical == dimension.physical


def test_torque_follows_from_force_and_length() -> None:
    declared = {"force": "kN", "length": "mm"}
    assert unit_text(u.TORQUE, declared) == "kN*mm"


def test_what_is_not_declared_is_told_by_its_base() -> None:
    with pytest.raises(UnitError, match=r"^mass$"):
        unit_text(u.INERTIA, {"length": "mm"})
    assert unit_text(u.INERTIA, {"length": "mm"}, strict=False) == "kg*mm^2"
    with pytest.raises(UnitError, match=r"^$"):
        unit_text(Dimension(3, 2, -1), MM)


def test_any_dimension_has_a_text() -> None:
    assert si_text(u.PURE) == ""
    assert si_text(Dimension(2, 1, -2)) == "m^2*kg/s^2"
    assert si_text(Dimension(0, 0, -1)) == "1/s"


def test_degrees_are_exact() -> None:
    assert 180 * unit("deg")[0] == math.pi
