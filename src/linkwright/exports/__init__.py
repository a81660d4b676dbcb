"""Exports: a mechanism written for other tools, each with a proof of what is written."""

from linkwright.exports.mjcf import Mjcf  # noqa: F401  (each target registers itself)
from linkwright.exports.motors import MotorExpressions  # noqa: F401
from linkwright.exports.process_simulate import ProcessSimulate  # noqa: F401
from linkwright.exports.registry import TARGETS, Exported, Order, Target, read_exports, register

__all__ = ["TARGETS", "Exported", "Order", "Target", "read_exports", "register"]
