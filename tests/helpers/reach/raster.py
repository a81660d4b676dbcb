"""The places that a mechanism's P reaches as a raster, refined along their boundary: areas, parts and holes.

Samples of a place's bits (mechanisms.py) at the centres of square cells, on axes that are turned so that no boundary
runs along them. Cells beside one of other bits are halved; what is found to differ from its neighbour on the way draws
its neighbours in, so that a narrow feature that was seen once is followed over its length. On the finest cells along
the boundary the area is a random sample's (one place in each of SUB x SUB squares), with its standard deviation. A
feature that isn't seen at all lies between the first cells: with an area of n of these it stays unseen with a
probability of about exp(-n).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from helpers.reach.circles import Points
from helpers.reach.mechanisms import Bits, Mechanism

LOOK = 512
"""Cells a side of the first look, which finds how far P's places go."""
FIRST = 2048
"""Cells a side before any is halved."""
HALVED = 1
"""How often cells are halved: 4096 a side."""
SUB = 4
"""Samples of a boundary cell, a side: 16384 a side."""
TILT = np.exp(0.2971j)
BLOCK = 1 << 17
UNSEEN = 6.0
"""First cells' areas that unseen features may have in all."""
SIGMAS = 5.0
CORE = 40
"""Cells that are left of a feature, taken a cell off all around, where it certainly is one."""
DUST = 8
"""Cells of a feature that is nothing: dots at the tip of a cusp."""
CROSS = ndimage.generate_binary_structure(2, 1)
SQUARE = ndimage.generate_binary_structure(2, 2)
AROUND = tuple((i, k) for i in (-1, 0, 1) for k in (-1, 0, 1) if i or k)


@dataclass(frozen=True)
class Truth:
    """What one mode reaches: area and its error; the fewest and the most parts and holes that the raster allows."""

    area: float
    error: float
    parts: tuple[int, int]
    holes: tuple[int, int]
    cell: float


@dataclass(eq=False)
class Raster:
    """Bits of the finest cells, and of samples of those along the boundary (cells, samples); ``cell`` is their side."""

    mechanism: Mechanism
    corner: complex
    cell: float
    bits: Bits
    edge: Bits
    inner: NDArray[np.bool_]
    first: float

    def area(self, wanted: Callable[[Bits], NDArray[np.bool_]]) -> tuple[float, float]:
        """Area of the places whose bits are wanted, and its error."""
        share = wanted(self.edge).mean(axis=1)
        whole = np.count_nonzero(wanted(self.bits[self.inner]))
        deviation = np.sqrt(np.sum(share * (1 - share)) / SUB**2)
        return float((whole + share.sum()) * self.cell**2), float(
            SIGMAS * deviation * self.cell**2 + UNSEEN * self.first**2
        )

    @cached_property
    def truths(self) -> dict[str, Truth]:
        """What each mode reaches, by its word."""
        return {word: self._truth(mode) for mode, word in enumerate(self.mechanism.modes)}

    def _truth(self, mode: int) -> Truth:
        def wanted(bits: Bits) -> NDArray[np.bool_]:
            return (bits >> mode & 1).astype(bool)

        area, error = self.area(wanted)
        here = wanted(self.bits)
        parts = counted(here, CROSS)
        fewest, most = counted(~here, SQUARE)
        return Truth(area, error, parts, (fewest - 1, most - 1), self.cell)  # one is all that lies around


def counted(here: NDArray[np.bool_], joined: NDArray[np.bool_]) -> tuple[int, int]:
    """The fewest and the most components that a mask has if its edge may lie a cell off."""
    wide, narrow = grown(here), ~grown(~here)
    labels, count = ndimage.label(wide, joined)
    cores = ndimage.label(narrow, joined)[0]
    sizes = np.bincount(cores[narrow])
    solid = sizes >= CORE
    in_wide = np.zeros(count + 1, bool)
    in_wide[labels[solid[cores] & narrow]] = True
    some = np.bincount(labels[here], minlength=count + 1) >= DUST
    some[0] = False
    return int(in_wide.sum()), int(solid.sum()) + int((some & ~in_wide).sum())


def grown(here: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """A mask and all cells that touch it."""
    for one, other in ((np.s_[1:, :], np.s_[:-1, :]), (np.s_[:, 1:], np.s_[:, :-1])):
        wide = here.copy()
        wide[one] |= here[other]
        wide[other] |= here[one]
        here = wide
    return here


@np.errstate(invalid="ignore", divide="ignore")
def raster(mechanism: Mechanism, halved: int = HALVED, first: int = FIRST) -> Raster:
    """The raster of a mechanism."""
    corner, side = _frame(mechanism)
    cell = side / first
    at = _centres(corner, cell, *np.divmod(np.arange(first * first), first))
    bits = looked(mechanism, at).reshape(first, first)
    for _ in range(halved):
        cell /= 2
        bits = _refined(mechanism, corner, cell, bits)
    edge = _edge(bits)
    cells = np.nonzero(edge)
    samples = _sampled(mechanism, corner, cell, cells)
    return Raster(mechanism, corner, cell, bits, samples, ~edge, side / first)


def looked(mechanism: Mechanism, z: Points) -> Bits:
    """The bits of places, in blocks."""
    return np.concatenate([mechanism.reached(z[k : k + BLOCK]) for k in range(0, z.size, BLOCK)] or [np.zeros(0, "u1")])


def _centres(corner: complex, cell: float, i: NDArray[np.intp], k: NDArray[np.intp]) -> Points:
    return np.asarray(corner + TILT * cell * ((i + 0.5) + 1j * (k + 0.5)))


def _frame(mechanism: Mechanism) -> tuple[complex, float]:
    """A square around all that is reached: by a coarse look and by values of the drives at random."""
    centre, radius = mechanism.round
    cell = 2 * radius / LOOK
    corner = centre - TILT * radius * (1 + 1j)
    i, k = np.divmod(np.arange(LOOK * LOOK), LOOK)
    at = _centres(corner, cell, i, k)
    at = at[looked(mechanism, at) > 0]
    rng = np.random.default_rng(0)
    spans = np.array(mechanism.spans)[:, :, None]
    for mode in range(len(mechanism.modes)):
        some = mechanism.placed(rng.uniform(spans[:, 0], spans[:, 1], (2, 100_000)), mode)
        at = np.concatenate([at, some[np.isfinite(some.real)]])
    if not at.size:
        raise ValueError("P reaches no place")
    along = at / TILT
    low = complex(along.real.min(), along.imag.min()) - 2 * cell * (1 + 1j)
    side = max(np.ptp(along.real), np.ptp(along.imag)) + 4 * cell
    return complex(low * TILT), float(side)


def _edge(bits: Bits) -> NDArray[np.bool_]:
    """The cells beside one of other bits."""
    edge = np.zeros(bits.shape, bool)
    for one, other in (
        (np.s_[1:, :], np.s_[:-1, :]),
        (np.s_[:, 1:], np.s_[:, :-1]),
        (np.s_[1:, 1:], np.s_[:-1, :-1]),
        (np.s_[1:, :-1], np.s_[:-1, 1:]),
    ):
        differ = bits[one] != bits[other]
        edge[one] |= differ
        edge[other] |= differ
    return edge


def _refined(mechanism: Mechanism, corner: complex, cell: float, bits: Bits) -> Bits:
    """The bits of cells half as wide: those along the boundary looked at, and theirs in turn where they differ."""
    seen = np.repeat(np.repeat(_edge(bits), 2, axis=0), 2, axis=1)
    bits = np.repeat(np.repeat(bits, 2, axis=0), 2, axis=1)
    size = len(bits)
    new = np.nonzero(seen)
    while new[0].size:
        bits[new] = looked(mechanism, _centres(corner, cell, *new))
        more = []
        for i, k in AROUND:
            beside = np.clip(new[0] + i, 0, size - 1), np.clip(new[1] + k, 0, size - 1)
            differ = ~seen[beside] & (bits[beside] != bits[new])
            more.append(beside[0][differ] * size + beside[1][differ])
        new = np.divmod(np.unique(np.concatenate(more)), size)
        seen[new] = True
    return bits


def _sampled(mechanism: Mechanism, corner: complex, cell: float, cells: tuple[NDArray[np.intp], ...]) -> Bits:
    """Bits of one random place in each of SUB x SUB squares of cells: (cells, samples)."""
    rng = np.random.default_rng(1)
    i, k = np.divmod(np.arange(SUB * SUB), SUB)
    shift = rng.random((2, len(cells[0]), SUB * SUB))
    x, y = cells[0][:, None] + (i + shift[0]) / SUB, cells[1][:, None] + (k + shift[1]) / SUB
    return looked(mechanism, (corner + TILT * cell * (x + 1j * y)).ravel()).reshape(x.shape)
