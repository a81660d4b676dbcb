"""What a cam study's options are along the lift: an angle of a follower on a pin, a length of one on a slide."""

from __future__ import annotations

from collections.abc import Callable

from linkwright.elements.cam_contact import cam_followers
from linkwright.expressions.typed_fields import Context, Quantity, Sign
from linkwright.expressions.units import Dimension


def turning(c: Context) -> bool | None:
    """Whether the follower of the study's cam turns; ``None`` where it isn't clear which cam is meant."""
    named, cams = c.entries[0].cam, [*c.mechanism.cams]
    follower = cam_followers(c.mechanism).get(named or (cams[0] if len(cams) == 1 else ""))
    return None if follower is None else follower.turning


def along(dimension: Callable[[bool], Dimension], sign: Sign = Sign.ANY) -> Quantity:
    """A quantity whose dimension follows from whether the follower turns."""
    return Quantity(lambda c: None if (turns := turning(c)) is None else dimension(turns), sign)
