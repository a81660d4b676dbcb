"""What a certificate says, check by check."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from linkwright.findings import CLAUSES, SENTENCES, Joined, Said, Text
from linkwright.presentation.blocks import Check
from linkwright.results import Certificate
from linkwright.results.certificate import PROVEN

CLOSE = 1e-2
"""A foretold pose corrected by less than this (rad, or over the size) can't have been mistaken for another mode's."""
FAR = 1e-3
"""A normalised determinant over this is well away from a singular pose."""


def checks(certificate: Certificate, time: Text) -> list[Check]:
    """What the certificate verifies, in words; ``time`` is the time of the nearest singular pose with its unit.

    Only what can fail stands here; what else is to be said of a run is one of its :func:`remarks`.
    """
    return [check for made in CHECKS for check in made(certificate, time)]


def remarks(certificate: Certificate) -> list[Text]:
    """What is to be said of a run that is no check: that it has no forces, which kernel computed it."""
    c = certificate
    said = [Said("proof.note.forces")] if c.equilibrium is None else []
    return [*said, Said("proof.note.kernel", poses=c.poses, kernel=c.kernel, reason=c.choice.reason)]


def _residuals(c: Certificate, time: Text) -> Iterator[Check]:
    for name, value in c.residuals.items():
        yield _proof(name, f"{value:.1e}", value < PROVEN, poses=c.poses)


def _mobility(c: Certificate, time: Text) -> Iterator[Check]:
    yield _proof("mobility", str(c.mobility), c.mobility == c.gruebler, rank=c.rank, gruebler=c.gruebler)


def _nearest(c: Certificate, time: Text) -> Iterator[Check]:
    if (near := c.nearest) is not None:
        figure, ok = f"{near.determinant:.4g}", near.determinant > FAR
        check = _proof("nearest", figure, ok, group=near.group, time=time)
        apart = [Said("proof.nearest.apart")] if c.changes else []
        yield replace(check, sentence=Joined([check.sentence, *apart], SENTENCES))


def _branches(c: Certificate, time: Text) -> Iterator[Check]:
    if kept := [str(rule) for rule in c.branches.values() if rule]:
        text = Said(f"proof.branches.{'changed' if c.changes else 'text'}", branches=Joined(kept, CLAUSES))
        yield Check(Said("proof.branches"), str(len(kept)), text, ok=True)


def _continuation_check(c: Certificate, time: Text) -> Iterator[Check]:
    if c.followed:
        steps, worst = (max(column) for column in zip(*c.followed.values(), strict=True))
        groups = Joined(c.followed)
        yield _proof("followed", f"{worst:.1e}", worst < CLOSE, groups=groups, steps=steps)


CHECKS: tuple[Callable[[Certificate, Text], Iterator[Check]], ...] = (
    _residuals,
    _mobility,
    _nearest,
    _branches,
    _continuation_check,
)
"""In the order in which they are shown; each gives a line, or none where there is nothing of its kind."""


def _proof(name: str, figure: str, ok: bool, **data: object) -> Check:
    return Check(Said(f"proof.{name}"), figure, Said(f"proof.{name}.text", **data), ok)
