"""The laws of followers: how a joint has its link follow a drive."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.expressions.typed_fields import Path
from linkwright.findings import Finding, ModelError
from linkwright.graph.geometry import Geometry
from linkwright.kernels.law import Array, DriveLaw, Parameters, must_be_finite
from linkwright.kernels.motions import StatedMotion
from linkwright.model.quantities import Quantities
from linkwright.notation import Jet


@dataclass(frozen=True)
class FollowerLaw(DriveLaw):
    """The law of a follower; ``follower_value`` gives its value from that of its motor (rad or m) with its rates."""

    name: str = ""
    path: Path = ()
    motor: str = ""
    motor_sign: int = 1
    follower_value: Callable[[Jet, Parameters], Jet] | None = None
    total: float = 0.0
    """What of a motion law places a second contact."""

    def ratio(self, angle: Any, speed: Any, parameters: Parameters) -> tuple[Any, Any]:
        """The derivative of the follower's value by the motor's (by ``motor_sign``), and its rate in time, at that
        (rad) and speed (rad/s); these and the parameters may be duals."""
        assert self.follower_value is not None
        with np.errstate(all="ignore"):
            value = self.follower_value(Jet([angle, 1.0, 0.0]), parameters)
            return self.motor_sign * value.d[1], self.motor_sign * value.d[2] * speed

    def along(self, angle: float) -> tuple[float, float]:
        """The follower's value (rad or m) and its derivative by the motor's, at a value of that (rad)."""
        assert self.follower_value is not None
        value, slope = self.follower_value(Jet([angle, 1.0]), self.parameters).d
        return float(value), float(slope)

    def driven_by(self, motor: DriveLaw) -> FollowerLaw:
        """The same follower with another law of its motor."""
        follower_value = self.follower_value
        assert follower_value is not None

        def of(t: Array, parameters: Parameters, strict: bool) -> Jet:
            with np.errstate(all="ignore"):
                value = follower_value(motor.of(t, parameters, strict), parameters)
            if strict:
                must_be_finite("joint.not-finite", self.path, {"name": self.name, "motor": self.motor}, t, value)
            return value

        return replace(self, of=of, names=self.names | motor.names)


def follower_law(
    quantities: Quantities, name: str, motions: Mapping[str, StatedMotion], motor: DriveLaw
) -> FollowerLaw:
    """The law of a follower, by the law of its motor."""
    follower = quantities.mechanism.followers[name]
    noted = Noting(quantities.parameters)
    with np.errstate(all="ignore"):  # what has no start is told by :func:`follower_faults`
        relation = follower.relation(Geometry(quantities, noted), motions)

    def follower_value(value: Jet, parameters: Parameters) -> Jet:
        try:
            return relation.value(Geometry(quantities, parameters), value)
        except ZeroDivisionError:  # by a plain number
            return Jet.constant(np.nan, value.order)

    with np.errstate(all="ignore"):
        follower_value(Jet.constant(0.0, 1), noted)
    made = FollowerLaw(
        motor.of, quantities.parameters, frozenset(noted.asked), name, quantities.mechanism.path_of(name),
        follower.motor, follower.motor_sign, follower_value, relation.total,
    )  # fmt: skip
    return made.driven_by(motor)


def follower_faults(
    quantities: Quantities, motions: Mapping[str, StatedMotion], drives: Mapping[str, DriveLaw], named: bool = True
) -> Iterator[Finding]:
    """What is wrong with the laws and numbers of followers, and with their values at the start. Unless all elements are
    ``named`` rightly there is no geometry: with the laws alone then."""
    geometry = Geometry(quantities, quantities.parameters)
    for name, follower in quantities.mechanism.followers.items():
        path = quantities.mechanism.path_of(name)
        for key, law in follower.laws.items():
            if law in motions:
                faults = follower.law_faults(quantities, law, motions[law], (*path, key))
                yield from (finding for finding, _ in faults)
        if not named:
            continue
        wrong = [*follower.faults(quantities, geometry, motions, path)]
        yield from wrong
        if not wrong and name in drives:
            try:
                drives[name](np.zeros(1))
            except ModelError as error:
                yield from error.findings


def recomposed(laws: Mapping[str, DriveLaw], motors: Mapping[str, DriveLaw]) -> dict[str, DriveLaw]:
    """Other laws of the motors, and those of the followers that they move."""
    return {
        n: law.driven_by(motors[law.motor]) if isinstance(law, FollowerLaw) else motors[n] for n, law in laws.items()
    }


class Noting(dict[str, float]):
    """Parameters that note which of them are asked."""

    def __init__(self, parameters: Mapping[str, float]) -> None:
        super().__init__(parameters)
        self.asked: set[str] = set()

    def __getitem__(self, name: str) -> float:
        self.asked.add(name)
        return super().__getitem__(name)
