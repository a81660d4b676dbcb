"""The kinds of this package, a line each: which contract a kind has, in which module, and whether a key chooses it.

A module is imported when its kind is first asked for, so that a file has only those that it needs. Kinds of other
packages aren't listed: their modules register them (:mod:`linkwright.plugins`).
"""

from __future__ import annotations

from typing import Literal, NamedTuple

Contract = Literal["joint", "follower", "force"]


class Listed(NamedTuple):
    """Where a kind is: its contract; its module, within this folder; the section in whose entries its name is the key
    that chooses it, if one does."""

    contract: Contract
    module: str
    section: str | None = None


KIND_MODULES = {
    "belt": Listed("joint", "belt", "joints"),
    "cam": Listed("follower", "cam_contact.follower"),
    "counterweight": Listed("force", "counterweight"),
    "coupling": Listed("follower", "coupling", "joints"),
    "differential": Listed("joint", "differential", "joints"),
    "floating_angle": Listed("joint", "floating"),
    "floating_x": Listed("joint", "floating"),
    "floating_y": Listed("joint", "floating"),
    "friction": Listed("force", "friction"),
    "gears": Listed("joint", "gears", "joints"),
    "geneva": Listed("follower", "geneva", "joints"),
    "load": Listed("force", "load"),
    "pin_in_slot": Listed("joint", "pin_in_slot", "joints"),
    "prescribed_angle": Listed("joint", "prescribed"),
    "prescribed_place": Listed("joint", "prescribed"),
    "prismatic": Listed("joint", "slide"),
    "rack": Listed("joint", "rack", "joints"),
    "revolute": Listed("joint", "pin"),
    "rolling": Listed("joint", "rolling", "joints"),
    "spring": Listed("force", "spring"),
    "weld": Listed("follower", "weld", "joints"),
}
"""By name; within a section in the order in which the schema has their entries."""


def of_contract(contract: Contract) -> dict[str, str]:
    """The modules of the kinds that have a contract, by name."""
    return {name: _path(one) for name, one in KIND_MODULES.items() if one.contract == contract}


def chosen_in(section: str) -> dict[str, str]:
    """The modules of the kinds that a key chooses in a section, by name."""
    return {name: _path(one) for name, one in KIND_MODULES.items() if one.section == section}


def _path(one: Listed) -> str:
    return f"linkwright.elements.{one.module}"
