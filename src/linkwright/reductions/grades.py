"""How sure a reported number is: enclosed, searched or sampled."""

from __future__ import annotations

from enum import Enum

from linkwright.data_classes import dataclass


class ProofKind(Enum):
    """*Enclosed*: proven by intervals. *Searched*: on exact rates between the steps of a grid. *Sampled*: the value at
    one given time."""

    ENCLOSED = "enclosed"
    SEARCHED = "searched"
    SAMPLED = "sampled"


@dataclass(frozen=True)
class Grade:
    """A kind, the ``width`` (s) below which a feature may hide from a search (``None`` of the others), and the
    ``reason`` why a proof that was tried remained open."""

    kind: ProofKind
    width: float | None = None
    reason: str = ""


SAMPLED = Grade(ProofKind.SAMPLED)
