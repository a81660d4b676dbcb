"""The cut into atoms: a fixed tiling of samples x poses."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from linkwright.blocks import UNIT, Cut
from linkwright.blocks.work import LARGEST


@given(st.integers(0, 5 * UNIT), st.integers(0, 3000))
def test_atoms_tile_the_work_in_order(samples: int, poses: int) -> None:
    cut = Cut(samples, poses)
    seen = np.zeros((samples, poses), np.int8)
    before = (0, -1)
    for atom in range(cut.atoms):
        here = (cut.unit(atom), cut.range(atom))
        assert here > before
        before = here
        s, p = cut.sample_slice(atom), cut.pose_slice(atom)
        assert s.start % UNIT == 0
        assert s.stop - s.start <= UNIT
        assert cut.size(atom) == seen[s, p].size > 0
        seen[s, p] += 1
    assert (seen == 1).all()
    assert sum(cut.size(atom) for atom in range(cut.atoms)) == samples * poses


@pytest.mark.parametrize("samples", [1, 100, UNIT, 100_000, 10**7])
@pytest.mark.parametrize("poses", [1, 2, 360, 361, 10**6])
def test_atoms_are_neither_large_nor_few(samples: int, poses: int) -> None:
    cut = Cut(samples, poses)
    assert cut.size(0) <= LARGEST
    if samples * poses > 10**7:
        assert cut.atoms >= 16
    assert cut.ranges * cut.width - poses < cut.width  # no empty range


def test_the_cut_of_a_study_stays_as_it_is() -> None:
    """Stored states and random streams hang on it: another cut is another format of the checkpoint."""
    cut = Cut(100_000, 360)
    assert (UNIT, cut.units, cut.ranges, cut.width, cut.atoms) == (4096, 25, 3, 120, 75)
    assert (Cut(1, 10**6).atoms, Cut(1, 10**6).width) == (8, 125_000)


def test_less_than_nothing_is_refused() -> None:
    with pytest.raises(ValueError, match="negative"):
        Cut(-1, 3)
