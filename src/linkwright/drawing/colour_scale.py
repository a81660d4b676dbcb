"""Colours for a continuous value that are seen on light and on dark pages alike: of middle lightness, in OKLCH
(B. Ottosson, A perceptual color space for image processing, 2020). Blue and orange, which the colour-blind tell apart,
are the ends of a range, and opposite values of a turn; between these one side is lighter than the other."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

BLUE, ORANGE = np.radians(262.0), np.radians(52.0)
MIDDLE, SWING, CHROMA = 0.63, 0.07, 0.125
TO_LMS = np.array(
    [[1.0, 0.3963377774, 0.2158037573], [1.0, -0.1055613458, -0.0638541728], [1.0, -0.0894841775, -1.2914855480]]
)
TO_RGB = np.array(
    [
        [4.0767416621, -3.3077115913, 0.2309699292],
        [-1.2684380046, 2.6097574011, -0.3413193965],
        [-0.0041960863, -0.7034186147, 1.7076147010],
    ]
)
"""Ottosson's matrices, from Lab to the cube roots of cone responses, and from these to linear sRGB."""


def colours(shares: Array, turn: bool) -> list[str]:
    """Colours as ``#rrggbb`` at shares 0 .. 1 (n,) of a range; of a whole ``turn`` both ends have the same."""
    shares = np.asarray(shares, dtype=float)
    if turn:  # blue, green, orange, purple and blue again
        angle = BLUE - 2 * np.pi * shares
        light = MIDDLE + SWING * np.sin(2 * np.pi * shares)
    else:  # from blue by green to orange, rising
        angle = BLUE + (ORANGE - BLUE) * shares
        light = MIDDLE + SWING * (2 * shares - 1)
    rgb = _rgb(light, CHROMA * np.cos(angle), CHROMA * np.sin(angle))
    return [f"#{r:02x}{g:02x}{b:02x}" for r, g, b in np.rint(255 * rgb).astype(int).tolist()]


def _rgb(light: Array, a: Array, b: Array) -> Array:
    """OKLab as sRGB (n, 3) in 0 .. 1; what lies outside is cut off."""
    linear = (np.stack([light, a, b], axis=-1) @ TO_LMS.T) ** 3 @ TO_RGB.T
    linear = np.clip(linear, 0.0, 1.0)
    return np.asarray(np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055))
