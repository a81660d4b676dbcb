"""Motion laws of drives as text for the motors of CAD simulators."""

from linkwright.exports.motors.target import MotorExpressions

__all__ = ["MotorExpressions"]
