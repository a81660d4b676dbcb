"""Which numbers change what is fixed where a mechanism is drawn: asked for many at once as for each alone."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from helpers.models import EXAMPLES
from linkwright.compilation import compile_named
from linkwright.kernels.drawn_constants import ELSEWHERE, OFF, Constants, DrawnConstants, _with
from linkwright.model.document import load
from linkwright.model.named_numbers import named_numbers
from linkwright.model.quantities import Quantities

FOLDER = EXAMPLES[0].parent


class Counted(DrawnConstants):
    """The same, with the number of poses assembled."""

    asked = 0

    def _assembled(self, moved: Quantities) -> Constants | None:
        self.asked += 1
        return super()._assembled(moved)

    def alone(self, name: str) -> str | None:
        """The first joint whose constants a number changes by itself, each share at each place."""
        for base, constants in self.bases:
            for share in (OFF, -OFF):
                there = self._assembled(_with(base, {name: self._off(base, name, share)}))
                changed: Mapping[str, Any] = there or constants
                for joint, before in constants.items():
                    if not self._same(changed.get(joint, ()), before):
                        return joint
        return None


def test_many_numbers_are_asked_as_each_alone() -> None:
    """With the same answers, by fewer poses: most numbers of a file change nothing."""
    alone = together = 0
    for example in ("geared_five_bar", "planetary_train", "rack_and_pinion", "phase_differential"):
        named = named_numbers(load(FOLDER / f"{example}.yaml"))
        drawn = Counted(compile_named(named, FOLDER))
        names = drawn._free(drawn.compiled.quantities)
        assert len(drawn.bases) == 2 and drawn.asked <= len(ELSEWHERE)
        drawn.asked = 0
        wanted = {name: drawn.alone(name) for name in names}
        alone, drawn.asked = alone + drawn.asked, 0
        found = drawn.joints_that_ask(names)
        together += drawn.asked
        assert {name: found.get(name) for name in names} == wanted
        assert 0 < len(found) < len(names)
    assert together < 0.6 * alone


def test_without_constants_nothing_is_assembled() -> None:
    drawn = Counted(compile_named(named_numbers(load(FOLDER / "four_bar.yaml")), FOLDER))
    assert drawn.joints_that_ask(["a", "b"]) == {} and drawn.asked == 0
