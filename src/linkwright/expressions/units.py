"""Units at the border: what a written unit means in SI, and the units that a file declares.

Inside, everything is in metres, kilograms, seconds, radians. Pint defines the units; a short list of words is
accepted, so that a typo is a finding and not some exotic unit.
"""

from __future__ import annotations

import math
import re
from fractions import Fraction
from functools import cache, lru_cache
from typing import Any, NamedTuple

from linkwright.escape import printed

# Accepted words and the pint unit each stands for. "r" is a revolution, as in r/min.
_WORDS = {
    **{w: w for w in ("m", "mm", "cm", "dm", "km", "um", "nm", "ft", "kg", "g", "mg", "lb", "s", "ms", "min")},
    **{w: w for w in ("rad", "mrad", "deg", "rpm", "Hz", "kHz", "N", "mN", "kN", "MN", "lbf", "kgf")},
    **{w: w for w in ("Pa", "kPa", "MPa", "GPa", "hPa", "bar", "mbar", "psi", "J", "mJ", "kJ", "W", "mW", "kW")},
    "in": "inch", "inch": "inch", "h": "hour", "us": "us", "µm": "um", "μm": "um", "°": "deg", "rev": "revolution",
    "r": "revolution", "turn": "revolution", "tonne": "metric_ton", "Nm": "N*m", "Nmm": "N*mm", "kNm": "kN*m",
    "arcmin": "arcminute", "arcsec": "arcsecond", "%": "percent",
}  # fmt: skip


def is_unit(word: str) -> bool:
    """Whether ``word`` is one of the accepted unit words."""
    return word in _WORDS


def unit_words() -> list[str]:
    """All accepted unit words."""
    return sorted(_WORDS)


class Dimension(NamedTuple):
    """Powers of length, mass, time and angle. The angle's power steers bare numbers only (a radian is 1)."""

    length: Fraction | int = 0
    mass: Fraction | int = 0
    time: Fraction | int = 0
    angle: Fraction | int = 0

    def times(self, other: Dimension, power: Fraction | int = 1) -> Dimension:
        return Dimension(*(a + power * b for a, b in zip(self, other, strict=True)))

    @property
    def physical(self) -> Dimension:
        """Without the angle."""
        return self._replace(angle=0)


PURE = Dimension()
LENGTH, MASS, TIME, ANGLE = Dimension(1), Dimension(0, 1), Dimension(0, 0, 1), Dimension(0, 0, 0, 1)
SPEED, ACCELERATION, JERK = Dimension(1, 0, -1), Dimension(1, 0, -2), Dimension(1, 0, -3)
OMEGA, ALPHA, ANGULAR_JERK = Dimension(0, 0, -1, 1), Dimension(0, 0, -2, 1), Dimension(0, 0, -3, 1)
FORCE, TORQUE, PRESSURE = Dimension(1, 1, -2), Dimension(2, 1, -2), Dimension(-1, 1, -2)
STIFFNESS, DAMPING = Dimension(0, 1, -2), Dimension(0, 1, -1)
TORSIONAL_STIFFNESS, TORSIONAL_DAMPING = Dimension(2, 1, -2, -2), Dimension(2, 1, -1, -2)
INERTIA, POWER = Dimension(2, 1, 0), Dimension(2, 1, -3)
ENERGY = Dimension(2, 1, -2, -1)  # told from a torque by "per radian", so that it prints in joules

# How the unit of each quantity is spelled with the words that a file declares.
_RECIPES: dict[Dimension, str] = {
    PURE: "", LENGTH: "{length}", MASS: "{mass}", TIME: "{time}", ANGLE: "{angle}",
    Dimension(2): "{length}^2", Dimension(3): "{length}^3",
    SPEED: "{length}/{time}", ACCELERATION: "{length}/{time}^2", JERK: "{length}/{time}^3",
    OMEGA: "{angle}/{time}", ALPHA: "{angle}/{time}^2", ANGULAR_JERK: "{angle}/{time}^3",
    FORCE: "{force}", TORQUE: "{torque}", PRESSURE: "{pressure}", INERTIA: "{mass}*{length}^2",
    STIFFNESS: "{force}/{length}", TORSIONAL_STIFFNESS: "{torque}/{angle}",
    DAMPING: "{force}*{time}/{length}", TORSIONAL_DAMPING: "{torque}*{time}/{angle}",
    Dimension(0, 0, -1): "1/{time}", Dimension(0, 0, 1, -1): "{time}/{angle}",
    Dimension(1, 0, 0, -1): "{length}/{angle}", Dimension(-1, 0, 0, 1): "{angle}/{length}",
}  # fmt: skip

SI = {"length": "m", "mass": "kg", "time": "s", "angle": "rad", "force": "N", "torque": "N*m", "pressure": "Pa"}
BASES = tuple(SI)
_FOLLOWING = {"torque": "{force}*{length}", "pressure": "{force}/{length}^2"}
"""The units of what follows from force and length."""
BASE_DIMENSIONS = dict(zip(BASES, (LENGTH, MASS, TIME, ANGLE, FORCE, TORQUE, PRESSURE), strict=True))


class UnitError(ValueError):
    """A unit that can't be read or isn't declared."""


@lru_cache(maxsize=1)
def _registry() -> Any:
    import pint

    return pint.UnitRegistry(cache_folder=None)


MAX_POWER = 9
"""The highest power that a unit may carry."""

_FACTOR = r"[^\s*/^0-9]+(?:\^[1-9])?"
_UNIT = re.compile(rf"\s*(?:1\s*/\s*)?{_FACTOR}(?:\s*[*/]\s*{_FACTOR})*\s*")


@lru_cache(maxsize=512)
def unit(text: str) -> tuple[float, Dimension]:
    """The SI value of one ``text`` (such as ``mm``, ``N*m``, ``1/s``, ``r/min``) and its dimension.

    Raises :class:`UnitError` with the word that isn't a unit, or the whole text where its form is wrong.
    """
    if text.strip() in ("", "1"):
        return 1.0, PURE
    if not _UNIT.fullmatch(text):
        raise UnitError(text.strip())
    factor, dimension, op = 1.0, PURE, "*"
    for word, power_text, next_op in re.findall(r"([^\s*/^]+)(?:\^(\d))?\s*([*/]?)\s*", text):
        if word != "1":
            one, of = _word(word)
            power = int(power_text or 1) * (1 if op == "*" else -1)
            factor *= one**power
            dimension = dimension.times(of, power)
        op = next_op
    if not 1e-60 < factor < 1e60:
        raise UnitError(text.strip())
    return factor, dimension


def words_of(text: str) -> list[str]:
    """The words of a unit, in order: ``N*m/s^2`` has N, m and s."""
    return re.findall(r"[^\s*/^0-9]+", text)


@lru_cache(maxsize=256)
def _word(word: str) -> tuple[float, Dimension]:
    if word not in _WORDS:
        raise UnitError(word)
    known = _BUILT_IN.get(word)
    if known is not None:
        return known
    quantity = (1 * _registry().parse_units(_WORDS[word])).to_base_units()
    powers = {str(name): Fraction(power).limit_denominator(12) for name, power in quantity.dimensionality.items()}
    angular = quantity.units == _registry().parse_units("rad") or word in {"rpm"}
    dimension = Dimension(
        powers.get("[length]", 0), powers.get("[mass]", 0), powers.get("[time]", 0), 1 if angular else 0
    )
    return float(quantity.to_base_units().magnitude), dimension


# The commonest words need no registry (a third of a second to load); a test holds them to pint.
_BUILT_IN: dict[str, tuple[float, Dimension]] = {
    "m": (1.0, LENGTH), "mm": (1e-3, LENGTH), "kg": (1.0, MASS), "s": (1.0, TIME), "rad": (1.0, ANGLE),
    "N": (1.0, FORCE), "Nm": (1.0, TORQUE), "Pa": (1.0, PRESSURE), "W": (1.0, POWER), "J": (1.0, TORQUE),
    "deg": (math.pi / 180, ANGLE), "rpm": (math.pi / 30, OMEGA), "r": (2 * math.pi, ANGLE),
    "min": (60.0, TIME), "kN": (1e3, FORCE), "bar": (1e5, PRESSURE),
}  # fmt: skip


def unit_text(dimension: Dimension, declared: dict[str, str], strict: bool = True) -> str:
    """The unit of a dimension in the declared words; undeclared bases are an error, or SI if not ``strict``.

    Torque and pressure follow from force and length when they aren't declared themselves. Raises :class:`UnitError`
    with the base that isn't declared (``length``), or with an empty text where no unit is usual for the dimension.
    """
    if dimension == ENERGY:
        return "J"
    if dimension == POWER:
        return "W"
    recipe = _RECIPES.get(dimension, _RECIPES.get(dimension.physical, _composed(dimension)))
    if recipe is None:
        raise UnitError("")
    words: dict[str, str] = {}
    for base in re.findall(r"{(\w+)}", recipe):
        word = declared.get(base)
        if word is None and base in _FOLLOWING and {"force", "length"} <= declared.keys():
            word = _FOLLOWING[base].format(**declared)
        if word is None:
            if strict:
                raise UnitError(base)
            word = SI[base]
        words[base] = word
    return recipe.format(**words)


def squared(unit: str) -> str:
    """The unit of areas in print where lengths have this unit: ``mm`` as mm²; nothing where they have none."""
    return printed(f"{unit}^2") if unit else ""


@cache
def _composed(dimension: Dimension) -> str | None:
    """The recipe of a dimension without mass in whole powers; with mass it could go by force or by mass."""
    whole = all(Fraction(p).denominator == 1 and abs(Fraction(p)) <= MAX_POWER for p in dimension)
    words = ("{length}", "{mass}", "{time}", "{angle}")
    return None if dimension.mass or not whole else _product(words, dimension)


def _product(words: tuple[str, ...], powers: Dimension) -> str:
    over = [f"{w}^{p}" if p != 1 else w for w, p in zip(words, powers, strict=True) if p > 0]
    under = [f"{w}^{-p}" if p != -1 else w for w, p in zip(words, powers, strict=True) if p < 0]
    return "/".join(["*".join(over) or "1", *under])


def si_text(dimension: Dimension) -> str:
    """Any dimension in base units, for messages: ``m^2*kg``; empty for a pure number."""
    return "" if dimension == PURE else _product(("m", "kg", "s", "rad"), dimension)
