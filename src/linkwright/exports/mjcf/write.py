"""The text of the model: bodies, joints, sites, constraints, actuators, a keyframe.

Elements and attributes as in MuJoCo's XML reference, https://mujoco.readthedocs.io/en/stable/XMLreference.html.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from xml.etree import ElementTree as ET

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.exports.mjcf.masses import Mass
from linkwright.exports.mjcf.poses import TreeDrive
from linkwright.exports.mjcf.tree import Hold, JointTree
from linkwright.graph.geometry import Geometry, extent
from linkwright.kernels import Compiled
from linkwright.notation import Pair
from linkwright.structure import FRAME
from linkwright.words import say

Array = NDArray[np.float64]

STIFF = 2 * math.pi * 50
"""The angular frequency (rad/s) at which an actuator could swing the mechanism's whole mass, at its full size."""
ROTOR = 0.1
"""The inertia on a driven joint, over that: a drive moves the links, and hardly the links it."""
CLOSED = "0.99 0.999 0.001"
"""How hard a loop is closed (solimp): MuJoCo's own figures let it open ten times as far."""
THICK = 1 / 60
"""The radius of links as drawn, over the mechanism's size."""
COLOURS = ("0.20 0.47 0.75 1", "0.85 0.50 0.15 1", "0.25 0.60 0.30 1", "0.70 0.25 0.30 1", "0.50 0.40 0.70 1")
GREY = "0.5 0.5 0.5 1"
STILL = np.array([0.0, 0.0, 1.0, 0.0])
"""Where the frame is: x, y, cosine and sine."""


@dataclass(frozen=True)
class Start:
    """The mechanism at t = 0, and how far its slides go.

    Each joint's coordinate and rate; each drive's value; each moving link's x, y, cosine and sine; each slide's least
    and largest travel (m).
    """

    q: Array
    v: Array
    controls: Array
    poses: Mapping[str, Array]
    travels: Mapping[str, tuple[float, float]]


class Writer:
    """Writes one mechanism."""

    def __init__(
        self, compiled: Compiled, tree: JointTree, driven: Sequence[TreeDrive], masses: Mapping[str, Mass], start: Start
    ) -> None:
        self.compiled, self.tree, self.driven, self.masses, self.start = compiled, tree, driven, masses, start
        assert compiled.assembly.start is not None
        self.geometry: Geometry = compiled.assembly.start.geometry
        self.size = extent(compiled.structure.topology, self.geometry)
        self._layers = {link: i for i, link in enumerate(compiled.mechanism.links)}

    def text(self, timestep: float) -> str:
        """The whole file, with a time step (s) for MuJoCo."""
        root = ET.Element("mujoco", model=self.compiled.mechanism.title)
        root.append(ET.Comment(" " + say("mjcf.comment").replace("--", "-") + " "))
        ET.SubElement(root, "compiler", angle="radian", autolimits="true")
        gravity = self.geometry.gravity()
        option = ET.SubElement(
            root, "option", timestep=_text(timestep), gravity=_text(gravity.x, gravity.y, 0), integrator="implicitfast"
        )
        ET.SubElement(option, "flag", contact="disable")
        ET.SubElement(ET.SubElement(root, "visual"), "global", azimuth="90", elevation="-90")
        default = ET.SubElement(root, "default")
        ET.SubElement(default, "geom", contype="0", conaffinity="0", group="1")
        ET.SubElement(default, "site", size=_text(1.2 * THICK * self.size), rgba="0.1 0.1 0.1 1")
        world = ET.SubElement(root, "worldbody")
        ET.SubElement(world, "light", pos=_text(0, 0, 3 * self.size), dir="0 0 -1", directional="true")
        self._contents(world, FRAME)
        self._below(world, FRAME)
        self._write_loop_closures(root, timestep)
        self._actuators(root)
        keyframe = ET.SubElement(root, "keyframe")
        key = ET.SubElement(keyframe, "key", name="start", qpos=_text(*self.start.q), qvel=_text(*self.start.v))
        if self.driven:
            key.set("ctrl", _text(*self.start.controls))
        ET.indent(root)
        return ET.tostring(root, encoding="unicode") + "\n"

    def _below(self, parent: ET.Element, link: str) -> None:
        for i, hold in enumerate(self.tree.holds):
            if hold.parent != link:
                continue
            x, y, turn = _relative_pose(self.start.poses[hold.child], self.start.poses.get(link, STILL))
            body = ET.SubElement(
                parent, "body", name=body_name(hold.child), pos=_text(x, y, 0), euler=_text(0, 0, turn)
            )
            body.append(self._joint(hold, float(self.start.q[i])))
            mass = self.masses[hold.child]
            ET.SubElement(
                body,
                "inertial",
                pos=_text(*mass.centre, 0),
                mass=_text(mass.mass),
                diaginertia=_text(*[mass.inertia] * 3),
            )
            self._contents(body, hold.child)
            self._below(body, hold.child)

    def _joint(self, hold: Hold, ref: float) -> ET.Element:
        """The joint in the child's frame; ``ref`` is its coordinate in the pose in which the bodies are written."""
        given = {"name": hold.name, "ref": _text(ref)}
        if any(motor.hold == hold for motor in self.driven):
            given["armature"] = _text(ROTOR * self._total_inertia(hold))
        if hold.turns:
            pin = self.compiled.structure.topology.pins[hold.joint]
            at = self.geometry.point(hold.child, pin.point(hold.child))
            return ET.Element("joint", given, pos=_text(at.x, at.y, 0), axis="0 0 1")
        foot, heading = self.geometry.line(hold.joint, hold.child)
        # The travel counts from the first link's point to the second's.
        sign = 1 if self.compiled.mechanism.joints[hold.joint].links[1] == hold.child else -1
        axis = _text(sign * heading.x, sign * heading.y, 0)
        return ET.Element("joint", given, type="slide", pos=_text(foot.x, foot.y, 0), axis=axis)

    def _contents(self, body: ET.Element, link: str) -> None:
        """The link's points as sites; to be seen, capsules between them on a layer of the link's own, and its rails."""
        points = {name: self.geometry.point(link, name) for name in self.compiled.mechanism.links[link].points}
        layer = self._layers[link]
        z, colour = 2 * layer * THICK * self.size, GREY if link == FRAME else COLOURS[layer % len(COLOURS)]
        thin = THICK * self.size / 2
        ends = []  # what is drawn from where to where
        if link != FRAME:
            (_, first), *others = points.items()
            ends += [(first, at, 2 * thin) for _, at in others]
        for joint, (low, high) in self.start.travels.items():
            if link == self.compiled.mechanism.joints[joint].links[0]:
                foot, heading = self.geometry.line(joint, link)
                from_, to = (Pair(foot.x + s * heading.x, foot.y + s * heading.y) for s in (low, high))
                ends.append((from_, to, thin))
        for a, b, radius in ends:
            if math.hypot(a.x - b.x, a.y - b.y) > thin:  # MuJoCo refuses the shortest
                fromto = _text(a.x, a.y, z, b.x, b.y, z)
                ET.SubElement(body, "geom", type="capsule", fromto=fromto, size=_text(radius), rgba=colour)
        for at in [*points.values()][: None if link == FRAME else 1]:
            ET.SubElement(body, "geom", type="sphere", pos=_text(at.x, at.y, z), size=_text(2 * thin), rgba=colour)
        for name, at in points.items():
            ET.SubElement(body, "site", name=site_name(link, name), pos=_text(at.x, at.y, 0))

    def _write_loop_closures(self, root: ET.Element, timestep: float) -> None:
        if not self.tree.cuts:
            return
        equality = ET.SubElement(root, "equality")
        hold = {"solref": _text(2 * timestep, 1), "solimp": CLOSED}  # MuJoCo takes no shorter time constant
        for cut in self.tree.cuts:
            pin = self.compiled.structure.topology.pins[cut.joint]
            sites = [site_name(link, pin.point(link)) for link in (cut.parent, cut.child)]
            ET.SubElement(equality, "connect", hold, name=cut.name, site1=sites[0], site2=sites[1])

    def _actuators(self, root: ET.Element) -> None:
        if not self.driven:
            return
        actuator = ET.SubElement(root, "actuator")
        for motor in self.driven:
            given = {"name": motor.drive, "joint": motor.hold.name, "gear": _text(motor.sign)}
            ET.SubElement(
                actuator, "position", given, kp=_text(STIFF**2 * self._total_inertia(motor.hold)), dampratio="1"
            )

    def _total_inertia(self, hold: Hold) -> float:
        """The mass of all links, or their moment of inertia at the mechanism's full size, as a joint could feel it."""
        mass = sum(mass.mass for mass in self.masses.values())
        return mass * self.size**2 if hold.turns else mass


def body_name(link: str) -> str:
    """A link's name as a body: MuJoCo keeps one to itself."""
    return "world:link" if link == "world" else link


def site_name(link: str, point: str) -> str:
    """A point of a link as a site."""
    return f"{link}:{point}"


def _relative_pose(pose: Array, other: Array) -> tuple[float, float, float]:
    """A pose (x, y, cosine, sine) in the axes of another: x, y, angle."""
    (x, y, c, s), (x0, y0, c0, s0) = pose, other
    dx, dy = x - x0, y - y0
    return c0 * dx + s0 * dy, c0 * dy - s0 * dx, math.atan2(s * c0 - c * s0, c * c0 + s * s0)


def _text(*numbers: float) -> str:
    return " ".join(repr(float(number) + 0.0).removesuffix(".0") for number in numbers)
