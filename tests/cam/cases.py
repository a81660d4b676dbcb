"""Each registered follower with a lift of lowest 0, for tests of its forces."""

from __future__ import annotations

from typing import Any

from tests.cam.lifts import harmonic

from linkwright.cam.disc import Disc
from linkwright.cam.followers import (
    FOLLOWERS,
    SwingingFlat,
    SwingingRoller,
    TranslatingFlat,
    TranslatingKnife,
    TranslatingRoller,
)

MADE: list[tuple[Any, Any]] = [
    (TranslatingRoller(40e-3, 10e-3, 12e-3), harmonic(6e-3, 0.5e-3, 0.3)),
    (TranslatingKnife(40e-3, offset=5e-3), harmonic(6e-3, 0.5e-3, 0.3)),
    (SwingingRoller(39e-3, 20e-3, 85e-3, 90e-3), harmonic(0.1, 0.01, 0.5)),
    (TranslatingFlat(40e-3), harmonic(6e-3, 0.5e-3, 0.3)),
    (SwingingFlat(40e-3, 90e-3, 8e-3), harmonic(0.06, 0.01, 0.5)),
]
EVERY = [Disc(follower, lift, sense) for follower, lift in MADE for sense in (1, -1)]
NAMES = [f"{disc.follower.name} {disc.sense:+}" for disc in EVERY]

assert {disc.follower.name for disc in EVERY} == set(FOLLOWERS)
