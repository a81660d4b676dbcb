"""What a workspace study says of its regions, held against the raster's truths."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any

import numpy as np
import shapely

from helpers.reach.mechanisms import Mechanism
from helpers.reach.raster import Truth

RIGHT, OPEN, OFF, WRONG = "right", "not certified", "not certified, off", "wrong in silence"
REFUSED, RAISED = "refused", "raised"
OUTCOMES = (RIGHT, OPEN, OFF, WRONG, REFUSED, RAISED)
"""From good to bad; a case is as bad as its worst region."""
SMALL = 12.0
"""A part or hole less wide than so many cells of the raster is looked at itself."""


@dataclass(frozen=True)
class Claim:
    """What the study says of a mode: the area lies in a range; parts and holes; and which of the three it certifies."""

    mode: str
    area: tuple[float, float]
    parts: int
    holes: int
    certified: bool = False
    certified_parts: bool = False
    certified_holes: bool = False
    warned: bool = False
    shape: Any = field(default=None, compare=False, repr=False)


@dataclass(frozen=True)
class Verdict:
    """What became of a mode's claim, and why."""

    mode: str
    outcome: str
    why: str = ""
    warned: bool = False


def claims(regions: Sequence[Mapping[str, Any]], shapes: Sequence[Any], words: Sequence[str]) -> list[Claim]:
    """Claims of the summary's entries (``summary["workspace"]["regions"]``) with their shapes in the file's unit.

    Of a region that is searched for the area is the one that is drawn.
    """
    return [_claim(entry, shape, words) for entry, shape in zip(regions, shapes, strict=True)]


def _claim(entry: Mapping[str, Any], shape: Any, words: Sequence[str]) -> Claim:
    mode = next(word for word in words if word in entry["mode"])
    given = entry["certificate"]
    plain = Claim(mode, (entry["area"], entry["area"]), entry["parts"], entry["holes"], shape=shape)
    low, high = given["area"] if given["area"] is not None else plain.area
    whole = bool(given["certified"])
    return replace(
        plain,
        area=(low, high),
        warned=bool(given["faults"]),
        certified=whole,
        certified_parts=bool(given["parts"]),
        certified_holes=bool(given["holes"]),
    )


def judged(mechanism: Mechanism, truths: Mapping[str, Truth], given: Sequence[Claim]) -> list[Verdict]:
    """A verdict for each mode; one of which nothing is said reaches nothing."""
    said = {claim.mode: claim for claim in given}
    return [
        judge(mechanism, mode, truth, said.get(word, Claim(word, (0.0, 0.0), 0, 0, certified=True)))
        for mode, (word, truth) in enumerate(truths.items())
    ]


def judge(mechanism: Mechanism, mode: int, truth: Truth, claim: Claim) -> Verdict:
    """The verdict on a mode's claim."""
    parts, holes = (partial(tiny_features, mechanism, mode, truth, claim, reached) for reached in (True, False))
    faults = [
        (claim.certified, _area(truth, claim)),
        (claim.certified_parts, _count("parts", truth.parts, claim.parts, parts)),
        (claim.certified_holes, _count("holes", truth.holes, claim.holes, holes)),
    ]
    silent = "; ".join(text for certified, text in faults if certified and text)
    why = silent or "; ".join(text for _, text in faults if text)
    if silent:
        return Verdict(claim.mode, WRONG, why, claim.warned)
    if claim.certified:
        return Verdict(claim.mode, RIGHT, why, claim.warned)
    return Verdict(claim.mode, OFF if why else OPEN, why, claim.warned)


def _area(truth: Truth, claim: Claim) -> str:
    """How the area is off, or nothing."""
    low, high = claim.area
    if low <= high and low - truth.error <= truth.area <= high + truth.error:
        return ""
    off = (low + high) / 2 / truth.area - 1 if truth.area else np.inf
    return f"area {low:.8g} .. {high:.8g}, truth {truth.area:.8g} +- {truth.error:.2g} ({100 * off:+.3g} %)"


def _count(what: str, truth: tuple[int, int], claimed: int, tiny: Callable[[], tuple[int, int]]) -> str:
    """How a count is off, or nothing: more than the raster sees are right where they are there, if narrow."""
    if truth[0] <= claimed <= truth[1]:
        return ""
    if claimed > truth[1]:
        narrow, false = tiny()
        if not false and claimed - narrow <= truth[1]:
            return ""
    seen = str(truth[0]) if truth[0] == truth[1] else f"{truth[0]} .. {truth[1]}"
    return f"{what} {claimed}, truth {seen}"


def tiny_features(mechanism: Mechanism, mode: int, truth: Truth, claim: Claim, reached: bool) -> tuple[int, int]:
    """How many of the claimed parts (or holes, not reached) are narrower than some cells, and how many of these aren't
    there."""
    polygons = [part for part in shapely.get_parts(claim.shape) if part.geom_type == "Polygon"]
    holes = [shapely.Polygon(ring) for part in polygons for ring in part.interiors]
    tiny = [one for one in (polygons if reached else holes) if one.buffer(-SMALL / 2 * truth.cell).is_empty]
    with np.errstate(invalid="ignore", divide="ignore"):
        return len(tiny), sum(not _there(mechanism, mode, one, reached) for one in tiny)


def _there(mechanism: Mechanism, mode: int, shape: Any, reached: bool) -> bool:
    """Whether nearly all places at random in a shape are reached, or not."""
    x, y, far_x, far_y = shape.bounds
    rng = np.random.default_rng(5)
    at = rng.uniform((x, y), (far_x, far_y), (4000, 2))
    inside = at[shapely.contains_xy(shape, *at.T)]
    if not len(inside):
        inside = np.array(shape.representative_point().coords)
    found = mechanism.reached(inside[:, 0] + 1j * inside[:, 1]) >> mode & 1
    return bool(np.mean(found == reached) > 0.9)
