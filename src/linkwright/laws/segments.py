"""The segments of a motion: dwells, rises by a law, polynomials and splines between given rates, free shapes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field
from itertools import pairwise
from typing import Any, ClassVar, Protocol

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.laws.curve import Curve
from linkwright.laws.numbers import either, first, possible, settled
from linkwright.laws.pieces import Piece
from linkwright.laws.polynomials import polynomial
from linkwright.laws.registry import Law
from linkwright.laws.splines import spline
from linkwright.notation import Scalar
from linkwright.notation.duals import value_of

CLOSEST = 1e-6
"""How close to one another, over a segment, its points may lie."""
MOST = 16
"""The most conditions that one polynomial may have; with more it swings, and round-off grows."""

Rates = tuple[Scalar | None, ...]
"""Derivatives from the first on; None where they are those of the neighbour."""


@dataclass(frozen=True)
class MotionFault:
    """What is wrong with a motion: a code, the segment (None: the motion as a whole), the data of its sentence;
    ``where`` says of which samples."""

    code: str
    segment: int | None = None
    data: dict[str, Any] = field(default_factory=dict)
    where: Any = True


class MotionError(ValueError):
    """A motion that can't be; ``faults`` says all that is wrong."""

    def __init__(self, faults: Sequence[MotionFault]) -> None:
        super().__init__("; ".join(f"{fault.code} in segment {fault.segment}: {fault.data}" for fault in faults))
        self.faults = tuple(faults)


class Segment(Protocol):
    """One stretch of a motion, ``over`` so much of its axis."""

    @property
    def mirrored(self) -> str:
        """The name of its law where that ends with an acceleration, which only its mirror image takes on."""

    @property
    def over(self) -> Scalar: ...

    @property
    def lift(self) -> Scalar:
        """How much further its end lies than its start."""

    @property
    def open(self) -> tuple[Rates, Rates]:
        """The rates at its start and end that it has by itself, or takes from its neighbours (None)."""

    def faults(self, number: int) -> list[MotionFault]:
        """What is wrong with it by itself; it has this number."""

    def curve(self, start: Sequence[Scalar], end: Sequence[Scalar]) -> Curve:
        """From 0 at 0 to ``lift`` at ``over``; ``start`` and ``end`` are the rates asked for in :attr:`open`."""


@dataclass(frozen=True)
class Dwell:
    """At rest."""

    over: Scalar
    lift: ClassVar[float] = 0.0
    mirrored: ClassVar[str] = ""
    open: ClassVar[tuple[Rates, Rates]] = ((), ())

    def faults(self, number: int) -> list[MotionFault]:
        return []

    def curve(self, start: Sequence[Scalar], end: Sequence[Scalar]) -> Curve:
        return Curve((Piece(0.0, self.over, (0.0,)),))


@dataclass(frozen=True)
class Rise:
    """By ``lift`` with a normalised law; ``fall`` runs the law backwards, as the mirror image of a rise."""

    over: Scalar
    lift: Scalar
    law: Curve
    fall: bool = False
    open: ClassVar[tuple[Rates, Rates]] = ((), ())

    @property
    def mirrored(self) -> str:
        return self.law.name if isinstance(self.law, Law) and self.law.mirrored else ""

    def faults(self, number: int) -> list[MotionFault]:
        ends = value_of(self.law.at([0.0, 1.0]))
        wrong = np.any(np.abs(ends - [0.0, 1.0]) > 1e-9, axis=-1, keepdims=not self.law.plain)
        if not np.any(wrong):
            return []
        start, end = (f"{first(ends[..., i : i + 1] if np.ndim(wrong) else ends[i], wrong):.6g}" for i in range(2))
        return [MotionFault("law.not-normal", number, {"start": start, "end": end}, wrong)]

    def curve(self, start: Sequence[Scalar], end: Sequence[Scalar]) -> Curve:
        law = self.law.transformed(1.0, -1.0, -1.0, 1.0) if self.fall else self.law
        return law.transformed(0.0, self.over, self.lift)


@dataclass(frozen=True)
class Blend:
    """A polynomial, or a spline of odd ``degree``, with given rates at its ends through given points.

    ``start`` and ``end`` are velocity, acceleration, ... there, None for what the neighbours have; ``via`` are points
    (way from the start, value above that at the start).
    """

    over: Scalar
    lift: Scalar
    start: Rates = (0.0, 0.0)
    end: Rates = (0.0, 0.0)
    via: tuple[tuple[Scalar, Scalar], ...] = ()
    degree: int | None = None
    mirrored: ClassVar[str] = ""

    @property
    def open(self) -> tuple[Rates, Rates]:
        return self.start, self.end

    def faults(self, number: int) -> list[MotionFault]:
        places = [0.0, *(x for x, _ in self.via), self.over]
        near = [value_of(b - a) < CLOSEST * value_of(self.over) for a, b in pairwise(places)]
        if possible(wrong := either(*near)):
            return [MotionFault("law.via", number, where=wrong)]
        count = 2 + len(self.start) + len(self.end) + len(self.via)
        if self.degree is None and count > MOST:
            return [MotionFault("law.conditions", number, {"count": count, "limit": MOST})]
        half = ((self.degree or 0) - 1) // 2
        if self.degree and (len(self.start) != half or len(self.end) != half):
            return [MotionFault("law.end-rates", number, {"degree": self.degree, "wanted": half})]
        return []

    def curve(self, start: Sequence[Scalar], end: Sequence[Scalar]) -> Curve:
        if self.degree:
            x, y = zip((0.0, 0.0), *self.via, (self.over, self.lift), strict=True)
            return spline(x, y, self.degree, start, end)
        # Solved over 0..1 for a lift of about 1, whatever the units.
        conditions = [(0.0, 0, 0.0), (1.0, 0, self.lift), *((x / self.over, 0, y) for x, y in self.via)]
        for place, given in ((0.0, start), (1.0, end)):
            conditions += [(place, order, rate * self.over**order) for order, rate in enumerate(given, start=1)]
        return polynomial(conditions).transformed(0.0, self.over)


@dataclass(frozen=True)
class Shape:
    """A curve over 0..1 that is stretched over the segment; ``rise`` says exactly how much further it ends."""

    over: Scalar
    shape: Curve
    rise: Scalar | None = None
    mirrored: ClassVar[str] = ""
    open: ClassVar[tuple[Rates, Rates]] = ((), ())

    @property
    def lift(self) -> Scalar:
        return self._end_value(1) - self._end_value(0) if self.rise is None else self.rise

    def _end_value(self, side: int) -> Scalar:
        return settled(self.shape.parts[-side].at(np.asarray(float(side)), 0))

    def faults(self, number: int) -> list[MotionFault]:
        return []

    def curve(self, start: Sequence[Scalar], end: Sequence[Scalar]) -> Curve:
        return self.shape.transformed(0.0, self.over, 1.0, -self._end_value(0))
