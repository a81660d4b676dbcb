"""The motion of a cam's follower as text in t: the motor turns, the arm follows the law, piece by piece."""

from __future__ import annotations

from pathlib import Path

import linkwright as lw

EXAMPLE = Path(__file__).parents[2] / "examples" / "cam_linkage.yaml"


def test_a_follower_is_written_as_its_law_at_the_motors_angle() -> None:
    done = lw.export(EXAMPLE, "motor-expressions")
    motors = done.summary["motors"]
    follower = motors["pushing"]
    assert follower["unit"] == "deg"
    assert len(follower["pieces"]) == 7  # modified sine 4, dwell, polynomial, dwell
    assert follower["max_error"] < 1e-11
    assert motors["motor"]["pieces"][0]["text"] == "540*t"
