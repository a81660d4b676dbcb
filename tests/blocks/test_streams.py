"""Random streams of units."""

from __future__ import annotations

import numpy as np

from linkwright.blocks import generator


def test_a_stream_is_its_units_whoever_draws_first() -> None:
    forward = [generator(7, unit).standard_normal(5) for unit in range(4)]
    backward = [generator(7, unit).standard_normal(5) for unit in reversed(range(4))][::-1]
    assert np.array_equal(forward, backward)
    assert len(np.unique(forward)) == 20
    assert not np.array_equal(generator(8, 0).standard_normal(5), forward[0])


def test_a_stream_is_numpys_child_sequence() -> None:
    children = np.random.SeedSequence(7).spawn(3)
    assert np.array_equal(generator(7, 2).random(9), np.random.default_rng(children[2]).random(9))


def test_a_stream_stays_as_it_is() -> None:
    """PCG64 seeded with SeedSequence(1, spawn_key=(2,)): a change here changes every study ever made."""
    assert generator(1, 2).integers(0, 1 << 32, 3).tolist() == [1832170131, 1001450238, 162171870]
