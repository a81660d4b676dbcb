"""Random mechanisms with two drives whose P's places are known by inverse kinematics in closed form, and a judge of
what the workspace study says of them. Nothing here but :mod:`helpers.reach.product` knows the product.

case = make(seed)
verdicts = judged(case.mechanism, raster(case.mechanism).truths, studied(case))
"""

from __future__ import annotations

from helpers.reach.cases import FAMILIES, Case, make
from helpers.reach.judging import Claim, Verdict, judge, judged
from helpers.reach.mechanisms import Chain, FiveBar, Guide, TwoCylinders, TwoSlides
from helpers.reach.product import Outcome, studied, tried
from helpers.reach.raster import Truth, raster

__all__ = [
    "FAMILIES",
    "Case",
    "Chain",
    "Claim",
    "FiveBar",
    "Guide",
    "Outcome",
    "Truth",
    "TwoCylinders",
    "TwoSlides",
    "Verdict",
    "judge",
    "judged",
    "make",
    "raster",
    "studied",
    "tried",
]
