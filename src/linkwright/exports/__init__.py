"""Exports: a mechanism written for other tools, each with a proof of what is written."""

from linkwright.exports.registry import TARGETS, Exported, Order, Target, read_exports, register

__all__ = ["TARGETS", "Exported", "Order", "Target", "read_exports", "register"]
