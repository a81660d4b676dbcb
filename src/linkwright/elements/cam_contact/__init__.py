"""Cams as joints: a plate cam on a link that a drive turns, and the follower that rides on it by a law."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from linkwright.elements.cam_contact.follower import CamFollower


def cam_followers(m: Any) -> dict[str, CamFollower]:
    """The followers of a mechanism's cams by name."""
    return {name: m.followers[name] for name in m.cams if name in m.followers}
