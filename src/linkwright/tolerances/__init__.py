"""Tolerances: classes of standards, how deviations are distributed within limits, thermal expansion of materials."""

from linkwright.tolerances import iso286, iso2768
from linkwright.tolerances.classes import Limits, NoTolerance, ToleranceClass, examples, tolerance_class
from linkwright.tolerances.distributions import DISTRIBUTIONS, Deviation
from linkwright.tolerances.expansion import EXPANSION

__all__ = [
    "DISTRIBUTIONS",
    "EXPANSION",
    "Deviation",
    "Limits",
    "NoTolerance",
    "ToleranceClass",
    "examples",
    "iso286",
    "iso2768",
    "tolerance_class",
]
