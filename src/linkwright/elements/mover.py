"""What prescribes the motion of a link on another: drives, and joints that have a link follow a drive."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Protocol

import numpy as np

from linkwright.elements.joint import Applied, Array, JointGeometry, JointReports
from linkwright.elements.prescribed import Track
from linkwright.expressions import units as u
from linkwright.expressions.units import Dimension

TURN = {"angle": u.ANGLE, "omega": u.OMEGA, "alpha": u.ALPHA, "jerk": u.ANGULAR_JERK}
"""An angle and its rates, as signals are called."""
TRAVEL = {"s": u.LENGTH, "v": u.SPEED, "a": u.ACCELERATION, "j": u.JERK}
"""A length and its rates."""


class MoverReports(JointReports, Protocol):
    """What a run reports."""

    @property
    def count(self) -> int:
        """The number of times."""

    @property
    def rows(self) -> Mapping[Any, Array]:
        """The reported signals by their texts: those of all drives and followers among them."""

    def joint_of(self, mover: str) -> str:
        """The joint at which a drive or follower moves its link."""


class Mover(Protocol):
    """A prescribed motion of ``link`` on ``on``: about the pin that they share, or along their line; or of a point
    along a line, or of the angle of links that share no pin (:mod:`linkwright.elements.prescribed`)."""

    @property
    def link(self) -> str:
        """The link that is moved."""

    @property
    def on(self) -> str:
        """The link against which the motion is measured."""

    @property
    def turns(self) -> str | None:
        """The link that is moved where the value is an angle."""

    @property
    def slides(self) -> str | None:
        """The link that is moved where the value is a length."""

    @property
    def moves(self) -> str | None:
        """The link where the value is the place of one of its points along a line of ``on``."""

    @property
    def at(self) -> str | None:
        """This point."""

    def track(self, geometry: JointGeometry) -> Track:
        """This point and this line."""

    @property
    def output(self) -> str | None:
        """The joint or link that follows the law in place of its own value."""

    @property
    def value(self) -> str:
        """The signal of its value."""

    @property
    def effort(self) -> str:
        """The signal of what it exerts."""

    @property
    def rate(self) -> str:
        """The signal of its speed."""

    @property
    def signals(self) -> Mapping[str, Dimension]:
        """The attributes of ``NAME.`` with their dimensions (SI)."""

    def applied(self, reports: Any, name: str) -> list[Applied]:
        """What the reported effort does to the links: its proof, which asks none of the other methods."""


class MoverSignals:
    """How the signals of a mover are called, by whether its value is an angle or a length."""

    def track(self, geometry: JointGeometry) -> Track:
        """No mover but those of points has one."""
        raise NotImplementedError

    @property
    def value(self: Mover) -> str:
        """The signal of its value: ``angle`` or ``s``."""
        return "angle" if self.turns else "s"

    @property
    def rate(self: Mover) -> str:
        """The signal of its speed: ``omega`` or ``v``."""
        return "omega" if self.turns else "v"

    @property
    def effort(self: Mover) -> str:
        """The signal of what it exerts: ``torque`` or ``force``."""
        return "torque" if self.turns else "force"


def exerted(mover: Mover, reports: MoverReports, name: str, effort: Array) -> list[Applied]:
    """What an effort (N m, N) at the joint of a drive or follower does to its two links."""
    none = np.zeros((2, reports.count))
    if mover.turns:
        return [(mover.link, none, none, effort), (mover.on, none, none, -effort)]
    if mover.moves:
        point, _, angle = mover.track(reports.geometry)
        place = reports.point_position(mover.link, point)
        along = reports.rotated(mover.on, (np.cos(float(angle)), np.sin(float(angle))))
    else:
        place, along = reports.line(reports.joint_of(name), mover.on)
    return [(mover.link, effort * along, place, 0.0), (mover.on, -(effort * along), place, 0.0)]
