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


def test_those_of_the_kind_that_is_meant() -> None:
    data = {"joints": {"a": {"pin_in_slot": ["p", "q"], "line": "A at 0 deg"}, "b": {"prismatic": ["p", "q"]}, "c": {}}}
    slot, slide, any_joint = ({*keys_at(Document, ("joints", name), data)} for name in data["joints"])
    assert slot == {"pin_in_slot", "pin", "straight", "arc", "curve", "flank", "travel"}
    assert slide == {"prismatic", "line", "travel", "revolute", "at"}
    assert any_joint >= slot | slide


def test_those_of_several_kinds_are_joined() -> None:
    assert {"count", "normal", "sigma"} <= {*keys_at(STUDIES["sweep"].options, ("vary", "AB"))}


@pytest.mark.parametrize("owner", [*STUDIES.values(), *TARGETS.values()], ids=lambda owner: owner.name)
def test_every_study_and_target_has_some(owner: object) -> None:
    assert keys_at(owner.options, ())  # type: ignore[attr-defined]
