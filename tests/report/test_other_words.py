"""Other words by which the signals of a plot are looked for on the page."""

from __future__ import annotations

import pytest

from linkwright.report.page import ALSO_CALLED
from linkwright.words import LANGUAGES, catalogue


@pytest.mark.parametrize("language", LANGUAGES)
def test_all_that_the_catalogue_has_are_asked_for(language: str) -> None:
    """By their list, as asking for one that isn't there would import all texts."""
    known = {key.replace("plot.also.", "plot.") for key in catalogue(language) if key.startswith("plot.also.")}
    assert known == {*ALSO_CALLED}
