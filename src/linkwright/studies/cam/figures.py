"""The figures of a cam study by name, with what they are."""

from __future__ import annotations

from linkwright.data_classes import dataclass
from linkwright.expressions import units as u

Range = tuple[float, float]

FIGURES = {
    "profile_curvature_max": u.PURE.times(u.LENGTH, -1),
    "profile_radius_min": u.LENGTH,
    "pitch_radius_min": u.LENGTH,
    "hollow_radius_min": u.LENGTH,
    "pressure_angle_max": u.ANGLE,
    "radius_min": u.LENGTH,
    "radius_max": u.LENGTH,
    "face_near": u.LENGTH,
    "face_far": u.LENGTH,
}
"""Those of a disc; what it doesn't have is left out."""
OF_FACE, OF_ROLLER = {"face_near", "face_far"}, {"pitch_radius_min", "hollow_radius_min"}
"""Those that only a flat face, and that only a roller or an edge may have."""
SECOND = "second_"
"""What the names begin with that are of the second disc."""


def closed_by(closed: str, turns: bool) -> dict[str, u.Dimension]:
    """Those of what else keeps the follower on, by the word of the file; ``turns``: the follower does."""
    pair = {SECOND + name: dimension for name, dimension in FIGURES.items()}
    pair |= {"second_base": u.LENGTH, "between": u.ANGLE if turns else u.LENGTH}
    yoke = dict.fromkeys(("yoke_span_min", "yoke_span_max", "play"), u.LENGTH)
    return {"conjugate": pair, "yoke": yoke}.get(closed, {})


def every(turns: bool) -> dict[str, u.Dimension]:
    """Those of the discs and of what keeps the follower on, whatever it is."""
    return FIGURES | closed_by("conjugate", turns) | closed_by("yoke", turns)


def along_lift(turns: bool) -> tuple[u.Dimension, u.Dimension, u.Dimension]:
    """What inertia, rate and load along the lift are."""
    return (u.INERTIA, u.TORSIONAL_STIFFNESS, u.TORQUE) if turns else (u.MASS, u.STIFFNESS, u.FORCE)


def of_forces(turns: bool) -> dict[str, u.Dimension]:
    """The figures of forces by name, with their dimensions."""
    _, rate, load = along_lift(turns)
    return {
        "contact_force_min": u.FORCE,
        "contact_force_max": u.FORCE,
        "shaft_torque_max": u.TORQUE,
        "hertz_pressure_max": u.PRESSURE,
        "roller_speed_max": u.OMEGA,
        "lift_off_speed": u.OMEGA,
        "spring_preload_min": load,
        "spring_rate_min": rate,
        "second_contact_force_max": u.FORCE,
        "second_hertz_pressure_max": u.PRESSURE,
        "second_roller_speed_max": u.OMEGA,
    }


@dataclass(frozen=True)
class CamFigure:
    """A figure (SI) and the cam angle (rad) at which it is taken; ``wanted`` are the least and the largest value that
    are required."""

    name: str
    value: float
    theta: float
    dimension: u.Dimension
    wanted: Range | None = None

    @property
    def kept(self) -> bool:
        """Whether the requirement is met, or there is none."""
        return self.wanted is None or self.wanted[0] <= self.value <= self.wanted[1]
