"""The functions of all joints, as trees: the structure's steps in order."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from linkwright.exports.process_simulate.dialects import Dialect
from linkwright.exports.process_simulate.dyads import solve
from linkwright.exports.process_simulate.joints import ToolJoint, driving
from linkwright.exports.process_simulate.linkage import MM, Linkage, Refused, shared_pin, wedge
from linkwright.exports.process_simulate.trees import Array, Tree, multiply, number
from linkwright.graph.geometry import Geometry
from linkwright.structure import Driven, Group, HigherGroup, Structure, Wedge

Fit = Callable[[Linkage, HigherGroup], None]
"""Gives the joints of a higher group functions of another kind."""


def linkage(
    structure: Structure,
    geometry: Geometry,
    branches: Mapping[Group, float],
    joints: list[ToolJoint],
    dialect: Dialect,
    drive: str,
    zero: float,
    poses: Array,
    fit: Fit | None = None,
    followers: Mapping[str, Tree] | None = None,
) -> Linkage:
    """The links and functions of a mechanism with one drive, whose value at the zero pose is ``zero`` (rad or m).

    ``poses`` are values of the driving joint since then (rad or mm), as the tool counts it; ``followers`` of cams have
    theirs from the driving joint's. Raises :class:`Refused` where a joint has no function in the dialect.
    """
    links = Linkage(structure, geometry, branches, joints, poses)
    name, moved, on = driving(structure, drive)
    turns = structure.topology.mechanism.prescribed(drive).turns is not None
    links.drive(name, on, moved, zero * (1.0 if turns else MM))
    for follower, tree in (followers or {}).items():
        name, moved, on = driving(structure, follower)
        found, sign = links.between(name, on, moved)
        if found is None:
            raise Refused(shared_pin(follower, name))
        links.set_function(found, multiply(number(sign), tree))
    for step in structure.steps:
        if isinstance(step, Driven):
            links.place_by_drive(step.joint, step.base, step.link)
            links.finish()
        elif isinstance(step, Group):
            solve(links, dialect, step)
        elif isinstance(step, Wedge):
            raise Refused(wedge(step))
        elif fit is not None:
            fit(links, step)
    return links
