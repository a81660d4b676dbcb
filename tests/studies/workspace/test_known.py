"""Mechanisms on which regions were once wrong: their areas, parts and holes, certified."""

from __future__ import annotations

import pytest

from helpers.reach.cases import Case
from helpers.reach.known import KNOWN, Known
from helpers.reach.product import studied


@pytest.mark.parametrize("known", KNOWN, ids=lambda known: known.name)
def test_regions_that_were_wrong_are_certified_and_right(known: Known) -> None:
    """To the raster's error (five standard deviations) beside the certificate's bounds."""
    found = studied(Case(0, "known", known.mechanism))
    for claim, area, parts, holes in zip(found, known.areas, known.parts, known.holes, strict=True):
        assert claim.certified and claim.certified_parts and claim.certified_holes
        low, high = claim.area
        assert low - known.error <= area <= high + known.error
        assert claim.shape.area == pytest.approx(area, abs=known.error + 1e-4 * claim.shape.length)
        assert (claim.parts, claim.holes) == (parts, holes)
