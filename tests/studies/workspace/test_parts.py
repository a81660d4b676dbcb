"""The sections of a workspace study's options: each has its options, which check themselves, and its performer."""

from __future__ import annotations

import pytest
from pydantic import BaseModel

from linkwright.studies.workspace.options import SECTIONS, WorkspaceOptions
from linkwright.studies.workspace.parts import PERFORMERS


def test_each_section_has_one_performer_in_the_same_order() -> None:
    assert tuple(PERFORMERS) == SECTIONS


@pytest.mark.parametrize("key", SECTIONS)
def test_a_section_is_data_that_checks_itself(key: str) -> None:
    (options,) = [kind for kind in WorkspaceOptions.model_fields[key].annotation.__args__ if kind is not type(None)]  # type: ignore[union-attr]
    assert issubclass(options, BaseModel)
    assert callable(options.check)  # type: ignore[attr-defined]
    assert not hasattr(options, "perform")
