"""Enclosures: proven bounds of signals over stretches of time."""

from linkwright.enclosures import functions, pieces  # noqa: F401  (register what Taylor models call)
from linkwright.enclosures.motion import Enclosure
from linkwright.enclosures.panels import Panels
from linkwright.enclosures.proofs import Claim, Proof, Refuted, prove, prove_all, sign
from linkwright.enclosures.taylor import TaylorModel

__all__ = ["Claim", "Enclosure", "Panels", "Proof", "Refuted", "TaylorModel", "prove", "prove_all", "sign"]
