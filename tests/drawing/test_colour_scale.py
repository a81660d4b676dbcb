"""Colours of a continuous value: seen on light and dark, ends that meet where they mean the same."""

from __future__ import annotations

import numpy as np
import pytest

from linkwright.drawing.colour_scale import colours


def luminance(colour: str) -> float:
    """Relative luminance of WCAG 2.1."""
    rgb = np.array([int(colour[i : i + 2], 16) for i in (1, 3, 5)]) / 255
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    return float(linear @ [0.2126, 0.7152, 0.0722])


@pytest.mark.parametrize("turn", [True, False])
def test_contrast_on_white_and_on_dark(turn: bool) -> None:
    for colour in colours(np.linspace(0, 1, 101), turn):
        light = luminance(colour)
        assert 1.05 / (light + 0.05) > 2.5  # on white
        assert (light + 0.05) / (luminance("#171d24") + 0.05) > 3.3  # on the dark page


def test_a_turn_closes_and_a_range_does_not() -> None:
    first, *_, last = colours(np.linspace(0, 1, 9), True)
    assert first == last
    rising = colours(np.linspace(0, 1, 9), False)
    assert len({*rising}) == 9
    assert luminance(rising[-1]) > 1.2 * luminance(rising[0])


def test_neighbours_are_near() -> None:
    rgb = np.array([[int(c[i : i + 2], 16) for i in (1, 3, 5)] for c in colours(np.linspace(0, 1, 361), True)])
    assert np.abs(np.diff(rgb, axis=0)).max() <= 10
