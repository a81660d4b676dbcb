"""Mechanisms on which regions were once wrong: their areas, parts and holes, certified."""

from __future__ import annotations

import pytest

from helpers.reach.cases import Case
from helpers.reach.known import KNOWN, Known
from helpers.reach.product import studied

SLOW = ("area 1", "area 9", "area 14", "nan 22", "parts 10")
"""Which take longest."""
CASES = [pytest.param(one, id=one.name, marks=[pytest.mark.long] if one.name in SLOW else []) for one in KNOWN]


@pytest.mark.parametrize("known", CASES)
def test_regions_that_were_wrong_are_certified_and_right(known: Known) -> None:
    """To the raster's error (five standard deviations) beside the certificate's bounds."""
    found = studied(Case(0, "known", known.mechanism))
    for claim, area, parts, holes in zip(found, known.areas, known.parts, known.holes, strict=True):
        assert claim.certified and claim.certified_parts and claim.certified_holes
        low, high = claim.area
        assert low - known.error <= area <= high + known.error
        assert claim.shape.area == pytest.approx(area, abs=known.error + 1e-4 * claim.shape.length)
        assert (claim.parts, claim.holes) == (parts, holes)
