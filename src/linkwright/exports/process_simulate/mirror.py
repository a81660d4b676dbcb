"""Two hinges that mirror each other, such as those of a bonnet: the names and signs of their joints."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from linkwright.exports.process_simulate.joints import ToolJoint
from linkwright.expressions.fields import Frozen
from linkwright.studies.sampling_options import one_of

SUFFIXES = ("_l", "_r")
Signs = one_of("process-simulate", "mirror.signs", ["mirrored", "same"], "export.choice")


class Mirror(Frozen):
    """How the joints of the two hinges are called and count in the tool."""

    suffixes: tuple[str, str] | None = None
    prefixes: tuple[str, str] | None = None
    signs: Signs = "mirrored"  # type: ignore[valid-type]

    @property
    def distinct(self) -> bool:
        """Whether the two sides' joints have different names."""
        return any(pair is not None and pair[0] != pair[1] for pair in (self.prefixes, self.suffixes)) or (
            self.prefixes is None and self.suffixes is None
        )

    def side(self, joints: Sequence[ToolJoint], second: bool) -> list[ToolJoint]:
        """The joints as one of the two hinges has them."""
        none = ("", "")
        before = (self.prefixes or none)[second]
        after = (self.suffixes or (none if self.prefixes else SUFFIXES))[second]
        turned = -1.0 if second and self.signs == "mirrored" else 1.0
        return [
            replace(j, name=f"{before}{j.name}{after}", sign=j.sign * (turned if j.kind == "T" else 1.0))
            for j in joints
        ]
