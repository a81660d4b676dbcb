"""What a certificate says, check by check."""

from __future__ import annotations

from collections.abc import Callable

from linkwright.findings import CLAUSES, SENTENCES, Joined, Said, Text
from linkwright.presentation.blocks import Check
from linkwright.results import Certificate


def checks(certificate: Certificate, time: Text) -> list[Check]:
    """What the certificate verifies, in words; ``time`` is the time of the nearest singular pose with its unit.

    Only what can fail stands here; what else is to be said of a run is one of its :func:`remarks`.
    """
    return [
        Check(
            Said(f"proof.{claim.name}"),
            claim.figure,
            SENTENCES_OF.get(claim.name, _residual)(certificate, claim.name, time),
            claim.holds,
        )
        for claim in certificate.claims()
    ]


def remarks(certificate: Certificate) -> list[Text]:
    """What is to be said of a run that is no check: that it has no forces, which kernel computed it."""
    c = certificate
    said = [Said("proof.note.forces")] if c.equilibrium is None else []
    return [*said, Said("proof.note.kernel", poses=c.poses, kernel=c.kernel, reason=c.choice.reason)]


def _residual(c: Certificate, name: str, time: Text) -> Text:
    return Said(f"proof.{name}.text", poses=c.poses)


def _signals(c: Certificate, name: str, time: Text) -> Text:
    return Said("proof.signals.text", poses=c.poses, signal=c.signal)


def _mobility(c: Certificate, name: str, time: Text) -> Text:
    redundant = Said("proof.mobility.redundant", gruebler=c.gruebler, redundant=c.redundant)
    return Said("proof.mobility.text", rank=c.rank, gruebler=redundant if c.redundant else c.gruebler)


def _nearest(c: Certificate, name: str, time: Text) -> Text:
    assert c.nearest is not None
    apart = [Said("proof.nearest.apart")] if c.changes else []
    return Joined([Said("proof.nearest.text", group=c.nearest.group, time=time), *apart], SENTENCES)


def _branches(c: Certificate, name: str, time: Text) -> Text:
    kept = [str(rule) for rule in c.branches.values() if rule]
    return Said(f"proof.branches.{'changed' if c.changes else 'text'}", branches=Joined(kept, CLAUSES))


def _followed(c: Certificate, name: str, time: Text) -> Text:
    steps = max(steps for steps, _ in c.followed.values())
    return Said("proof.followed.text", groups=Joined(c.followed), steps=steps)


SENTENCES_OF: dict[str, Callable[[Certificate, str, Text], Text]] = {
    "signals": _signals,
    "mobility": _mobility,
    "nearest": _nearest,
    "branches": _branches,
    "followed": _followed,
}
"""What is said of the checks that aren't residuals."""
