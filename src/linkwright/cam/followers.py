"""Followers of a plate cam: how they are guided, and what touches the cam.

The contact in the fixed frame follows from the lift alone: of a roller or a knife edge the path of its centre, of a
flat face a line. The cam is their envelope in its own frame (reversal). A follower rises away from the cam's centre: a
translating one along +y, a swinging one by turning clockwise about its pivot at (distance, 0).
"""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.notation import Jet
from linkwright.notation.angles import wrapped
from linkwright.notation.registry import Registry

Array = NDArray[np.float64]
Vector = tuple[Jet, Jet]


class NoFollower(ValueError):
    """Lengths with which a follower can't be put onto the base circle; ``key`` and ``data`` say it."""

    def __init__(self, key: str, **data: float) -> None:
        super().__init__(key)
        self.key, self.data = key, data


@dataclass(frozen=True)
class ContactJets:
    """What the follower holds against the cam, in the fixed frame, as jets of the cam angle.

    ``at`` is the centre of a roller or the edge of a knife, ``None`` for a flat face; this has its outward normal (away
    from the cam) ``along``, at the angle ``facing``, and lies ``height`` from the cam's centre.
    """

    at: Vector | None = None
    facing: Jet | None = None
    height: Jet | None = None
    along: Vector | None = None


class CamFollowerGeometry:
    """A guide and what touches. ``base`` is the radius of the cam's base circle (m)."""

    name: ClassVar[str]
    turns: ClassVar[bool] = False
    """Whether the lift is an angle."""
    faced: ClassVar[bool] = False
    """Whether a flat face touches."""
    starts: ClassVar[tuple[float, float]] = (0.0, math.inf)
    """Between what a start may lie (m or rad)."""
    base: float

    @property
    def radius(self) -> float:
        """Of the roller (m); 0 where there is none."""
        return 0.0

    @property
    def start(self) -> float:
        """On the base circle: the height (m) over the cam's centre, or the angle (rad) from the line of centres."""
        raise NotImplementedError

    def base_at(self, start: float) -> float:
        """The radius (m) of the base circle on which it would rest at a start; not positive where there is none."""
        raise NotImplementedError

    def touch(self, lift: Jet) -> ContactJets:
        """The contact at a lift (m or rad)."""
        return self.held(lift + self.start)

    def held(self, value: Jet) -> ContactJets:
        """The contact at a height (m) or an angle (rad), which is the start and the lift; numbers or symbols."""
        raise NotImplementedError

    def velocity(self, at: Vector) -> Vector:
        """The derivative by the lift of the place of the follower's point that is at ``at``."""
        raise NotImplementedError

    def resting(self, x: Array, y: Array) -> Array:
        """The lift (m or rad) at which the follower rests on a point of the fixed frame; NaN where it never does."""
        raise NotImplementedError

    def hanging(self, x: Array, y: Array) -> Array:
        """The lift (m or rad) at which a roller lies against a point of the fixed frame from below, as in a groove
        against the outer flank; NaN where it never does."""
        raise NotImplementedError

    def edge(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Of an edge (a roller without a radius): how far points of the fixed frame lie aside of its way (m, signed),
        and the lift (m or rad) of those that lie on it."""
        raise NotImplementedError


FOLLOWERS: Registry[type[CamFollowerGeometry]] = Registry()


def register(cls: type[CamFollowerGeometry]) -> type[CamFollowerGeometry]:
    """Register a follower under its name."""
    FOLLOWERS[cls.name] = cls
    return cls


class Translating(CamFollowerGeometry):
    """Moves along +y."""

    def velocity(self, at: Vector) -> Vector:
        return Jet.constant(0.0, at[0].order), Jet.constant(1.0, at[0].order)


class Swinging(CamFollowerGeometry):
    """Turns clockwise about its pivot at (``distance``, 0); the arm makes the angle ``start`` + lift with the line from
    the pivot to the cam's centre."""

    turns = True
    distance: float

    @property
    def start(self) -> float:
        """The angle (rad) between arm or face and the line of centres on the base circle."""
        raise NotImplementedError

    def velocity(self, at: Vector) -> Vector:
        return at[1], self.distance - at[0]


@register
@dataclass(frozen=True)
class TranslatingRoller(Translating):
    """A roller on a slide along +y at x = ``offset``."""

    name = "translating_roller"
    base: float
    roller: float
    offset: float = 0.0

    @property
    def radius(self) -> float:
        return self.roller

    @property
    def start(self) -> float:
        """The height (m) of the roller's centre on the base circle."""
        pitch = self.base + self.roller
        if not abs(self.offset) < pitch:
            raise NoFollower("cam.offset", offset=self.offset, limit=pitch)
        return math.sqrt(pitch**2 - self.offset**2)

    def base_at(self, start: float) -> float:
        return math.hypot(self.offset, start) - self.radius

    def held(self, value: Jet) -> ContactJets:
        return ContactJets(at=(Jet.constant(self.offset, value.order), value))

    def resting(self, x: Array, y: Array) -> Array:
        return y + np.sqrt(self.radius**2 - (x - self.offset) ** 2) - self.start

    def hanging(self, x: Array, y: Array) -> Array:
        return y - np.sqrt(self.radius**2 - (x - self.offset) ** 2) - self.start

    def edge(self, x: Array, y: Array) -> tuple[Array, Array]:
        return x - self.offset, y - self.start


@register
@dataclass(frozen=True)
class TranslatingKnife(TranslatingRoller):
    """A knife edge on a slide along +y at x = ``offset``."""

    name = "translating_knife"
    roller: float = 0.0


@register
@dataclass(frozen=True)
class SwingingRoller(Swinging):
    """A roller on an arm of length ``arm``."""

    name = "swinging_roller"
    starts = (0.0, math.pi)
    base: float
    roller: float
    distance: float
    arm: float

    @property
    def radius(self) -> float:
        return self.roller

    @property
    def start(self) -> float:
        pitch, a, arm = self.base + self.roller, self.distance, self.arm
        cosine = (a * a + arm * arm - pitch * pitch) / (2 * a * arm)
        if not -1 < cosine < 1:
            raise NoFollower("cam.reach", distance=a, arm=arm, pitch=pitch, low=abs(a - arm), high=a + arm)
        return math.acos(cosine)

    def base_at(self, start: float) -> float:
        a, arm = self.distance, self.arm
        return math.sqrt(a * a + arm * arm - 2 * a * arm * math.cos(start)) - self.radius

    def held(self, value: Jet) -> ContactJets:
        return ContactJets(at=(self.distance - self.arm * value.cos(), self.arm * value.sin()))

    def resting(self, x: Array, y: Array) -> Array:
        return self._against(x, y, 1)

    def hanging(self, x: Array, y: Array) -> Array:
        return self._against(x, y, -1)

    def _against(self, x: Array, y: Array, above: int) -> Array:
        away = np.hypot(x - self.distance, y)
        between = np.arccos((self.arm**2 + away**2 - self.radius**2) / (2 * self.arm * away))
        return wrapped(np.arctan2(y, self.distance - x) + above * between - self.start)

    def edge(self, x: Array, y: Array) -> tuple[Array, Array]:
        return np.hypot(x - self.distance, y) - self.arm, wrapped(np.arctan2(y, self.distance - x) - self.start)


@register
@dataclass(frozen=True)
class TranslatingFlat(Translating):
    """A flat face square to the slide."""

    name = "translating_flat"
    faced = True
    base: float

    @property
    def start(self) -> float:
        return self.base

    def base_at(self, start: float) -> float:
        return start

    def held(self, value: Jet) -> ContactJets:
        up, none = (Jet.constant(part, value.order) for part in (1.0, 0.0))
        return ContactJets(facing=Jet.constant(math.pi / 2, value.order), height=value, along=(none, up))

    def resting(self, x: Array, y: Array) -> Array:
        return y - self.base


@register
@dataclass(frozen=True)
class SwingingFlat(Swinging):
    """A flat face on an arm, ``face`` (m) from the pivot on the side away from the cam."""

    name = "swinging_flat"
    starts = (-math.pi / 2, math.pi / 2)
    faced = True
    base: float
    distance: float
    face: float = 0.0

    @property
    def start(self) -> float:
        sine = (self.base - self.face) / self.distance
        if not -1 < sine < 1:
            raise NoFollower("cam.face", base=self.base, face=self.face, distance=self.distance)
        return math.asin(sine)

    def base_at(self, start: float) -> float:
        return self.distance * math.sin(start) + self.face

    def held(self, value: Jet) -> ContactJets:
        height = self.distance * value.sin() + self.face
        return ContactJets(facing=math.pi / 2 - value, height=height, along=(value.sin(), value.cos()))

    def resting(self, x: Array, y: Array) -> Array:
        away = np.hypot(x - self.distance, y)
        return wrapped(np.arctan2(y, self.distance - x) - np.arcsin(self.face / away) - self.start)


def cross(a: Vector, b: Vector) -> Jet:
    """The area that two vectors span."""
    return a[0] * b[1] - a[1] * b[0]


def dot(a: Vector, b: Vector) -> Jet:
    """The scalar product."""
    return a[0] * b[0] + a[1] * b[1]


def rotated(angle: Jet, *some: Vector) -> tuple[Vector, ...]:
    """Vectors turned counter-clockwise."""
    cosine, sine = angle.cos(), angle.sin()
    return tuple((cosine * x - sine * y, sine * x + cosine * y) for x, y in some)
