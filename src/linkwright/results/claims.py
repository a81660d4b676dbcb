"""What a certificate claims: check by check whether it holds. Everything that tells a user so, as a mark, a finding, an
exit code or :meth:`Certificate.sound`, asks here."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from linkwright.data_classes import dataclass

if TYPE_CHECKING:
    from linkwright.results.certificate import Certificate

CLOSE = 1e-2
"""A foretold pose corrected by less than this (rad, or over the size) can't have been mistaken for another mode's."""
SINGULAR = 1e-7
"""A group whose margin isn't above this is in a singular pose: rates and forces lose all their digits there."""


@dataclass(frozen=True)
class Claim:
    """One check: its name, its figure as it is shown, what is required of it, and whether that holds."""

    name: str
    figure: str
    required: str
    holds: bool


def claims(certificate: Certificate, tolerance: float) -> list[Claim]:
    """All checks of a certificate that there is something to check for; residuals are to be below ``tolerance``."""
    return [claim for made in CLAIMS for claim in made(certificate, tolerance)]


def _residuals(c: Certificate, tolerance: float) -> Iterator[Claim]:
    for name, value in c.residuals.items():
        yield Claim(name, f"{value:.1e}", f"< {tolerance:.0e}", value < tolerance)


def _mobility(c: Certificate, tolerance: float) -> Iterator[Claim]:
    yield Claim("mobility", str(c.mobility), f"= {c.gruebler}", c.mobility == c.gruebler + c.redundant)


def _nearest(c: Certificate, tolerance: float) -> Iterator[Claim]:
    if (near := c.nearest) is not None:
        yield Claim("nearest", f"{near.determinant:.4g}", f"> {SINGULAR:.0e}", near.determinant > SINGULAR)


def _branches(c: Certificate, tolerance: float) -> Iterator[Claim]:
    # A group leaves the mode of its rule by no other way than a change point: what it passes is told by the sentence.
    if kept := [rule for rule in c.branches.values() if rule]:
        yield Claim("branches", str(len(kept)), "", True)


def _followed(c: Certificate, tolerance: float) -> Iterator[Claim]:
    if c.followed:
        worst = max(correction for _, correction in c.followed.values())
        yield Claim("followed", f"{worst:.1e}", f"< {CLOSE:g}", worst < CLOSE)


CLAIMS: tuple[Callable[[Certificate, float], Iterator[Claim]], ...] = (
    _residuals,
    _mobility,
    _nearest,
    _branches,
    _followed,
)
"""In the order in which they are shown."""
