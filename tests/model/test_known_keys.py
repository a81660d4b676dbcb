"""The keys that may stand at a place, read off the types."""

from __future__ import annotations

import pytest

from linkwright.exports import TARGETS
from linkwright.model.document import Document
from linkwright.model.known_keys import keys_at
from linkwright.studies import STUDIES


@pytest.mark.parametrize(
    ("path", "known"),
    [
        ((), {"links", "studies", "exports"}),
        (("links", "crank"), {"points", "mass", "com", "inertia", "shape"}),
        (("links",), set()),
        (("parameters", "AB", "tolerance"), {"limits", "distribution"}),
        (("laws", "lift", "segments", 0), {"rise", "over", "from"}),
        (("cams", "seal", "second"), {"base", "roller", "at", "face"}),
        (("springs", "s"), {"from", "in", "stiffness"}),
    ],
)
def test_the_keys_of_a_place(path: tuple[str | int, ...], known: set[str]) -> None:
    found = keys_at(Document, path)
    assert known <= {*found} and bool(known) == bool(found)


def test_those_of_several_kinds_are_joined() -> None:
    assert {"count", "normal", "sigma"} <= {*keys_at(STUDIES["sweep"].options, ("vary", "AB"))}


@pytest.mark.parametrize("owner", [*STUDIES.values(), *TARGETS.values()], ids=lambda owner: owner.name)
def test_every_study_and_target_has_some(owner: object) -> None:
    assert keys_at(owner.options, ())  # type: ignore[attr-defined]
