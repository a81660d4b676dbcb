"""The linkage drawn for a sheet: links with their numbers, joints with the names that the tool has for them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.drawing.charts import points
from linkwright.escape import markup
from linkwright.kernels import Compiled
from linkwright.presentation.lettering import columns
from linkwright.structure import FRAME
from linkwright.studies.drive_sweep import sweeping

Array = NDArray[np.float64]

WIDTH, TALLEST, MARGIN = 430.0, 330.0, 40.0
LETTER, LINE, RADIUS = 8.0, 15.0, 8.0
"""Width and height of a letter of a name; radius of the circle of a link's number."""
AWAY = (17.0, 24.0, 34.0, 48.0)
"""How far from a joint its name may stand."""
ROUND = np.array([[np.cos(a), np.sin(a)] for a in np.linspace(0.0, 2 * np.pi, 16, endpoint=False)])


def anchors(compiled: Compiled) -> dict[str, str]:
    """The point of each joint, by the joint's name: of a slide that of its second line. Slides first: drawn over their
    blocks, pins stay seen."""
    found = {}
    for name, joint in compiled.mechanism.prismatic_joints():
        assert joint.line is not None
        found[name] = joint.line[1].point
    return found | {pin.name: pin.members[0][1] for pin in compiled.structure.topology.pins.values()}


def skeleton(compiled: Compiled) -> dict[str, list[str]]:
    """The points of each link in which joints are."""
    found: dict[str, list[str]] = {name: [] for name in compiled.mechanism.links}
    for pin in compiled.structure.topology.pins.values():
        for link, point in pin.members:
            found[link].append(point)
    for _, joint in compiled.mechanism.prismatic_joints():
        assert joint.line is not None
        for link, line in zip(joint.links, joint.line, strict=True):
            found[link].append(line.point)
    return {name: list(dict.fromkeys(of)) for name, of in found.items()}


def places(compiled: Compiled, drive: str, names: Iterable[str], values: Sequence[float]) -> list[dict[str, Array]]:
    """Where points are (2,), in m, with a drive at some values less that at the start."""
    names = list(dict.fromkeys(names))
    rows = [f"{name}.{axis}" for name in names for axis in "xy"]
    found = sweeping(compiled, drive).evaluate(rows, np.array(values)).reshape(-1, 2, len(values))
    return [dict(zip(names, np.moveaxis(found, 2, 0)[i], strict=True)) for i in range(len(values))]


def linkage(
    compiled: Compiled,
    drive: str,
    ends: tuple[float, float],
    driven: str,
    labels: Mapping[str, Sequence[str]],
    title: str,
) -> str:
    """The linkage at the first of two values of the drive less that at the start (the zero pose), and dashed at the
    second. ``driven`` is the link that the driving joint moves, ``labels`` the names to be written at each joint."""
    bones, at = skeleton(compiled), anchors(compiled)
    names = [point for of in bones.values() for point in of]
    poses = places(compiled, drive, names, ends)
    room = _Room(np.array([place for pose in poses for place in pose.values()]))
    here, there = ({name: room.to_picture(place) for name, place in pose.items()} for pose in poses)
    shapes = [_ground(here[point]) for point in bones[FRAME]]
    for look, pose in (("there", there), ("here", here)):
        for link, of in bones.items():
            if link != FRAME or look == "here":
                kind = "fixed" if link == FRAME else "driven" if link == driven else ""
                shapes.append(_body([pose[point] for point in of], f"{look} {kind}".strip()))
    drawn = {joint: here[point] for joint, point in at.items()}
    slides = _headings(compiled, drive, ends[0])
    single: dict[str, list[Array]] = {}
    for name in slides:
        slide = compiled.mechanism.joints[name]
        (x, y), (u, v) = line = [here[of_link.point] for of_link in slide.line or ()]
        shapes.append(f'<path class="guide" d="M{x:.1f} {y:.1f}L{u:.1f} {v:.1f}"/>')
        single |= dict(zip(slide.links, (line, line[::-1]), strict=True))
    for joint, place in drawn.items():
        pin = f'<circle class="pin" cx="{place[0]:.1f}" cy="{place[1]:.1f}" r="4"/>'
        shapes.append(_slide(place, slides[joint]) if joint in slides else pin)
    placing = _Placing(room, [here[p] for p in names], list(_segments(bones, here)))
    for number, (link, of) in enumerate(bones.items(), start=1):
        spots = [here[point] for point in of]
        if len(spots) == 1 and link in single:  # barrels, rods and blocks: along their slide
            spots.append(spots[0] + 0.8 * (single[link][1] - single[link][0]))
        if spots:
            shapes.append(placing.number(number, spots, link))
    for joint, place in drawn.items():
        if labels.get(joint):
            shapes.append(placing.label(", ".join(labels[joint]), place))
    return (
        f'<svg class="linkage" viewBox="0 0 {room.width:.0f} {room.height:.0f}" role="img" '
        f'aria-label="{markup(title)}">{"".join(shapes)}</svg>'
    )


def _headings(compiled: Compiled, drive: str, value: float) -> dict[str, float]:
    """The direction (rad) of each slide with the drive at a value less that at the start."""
    start = compiled.assembly.start
    slides = {name: joint.links[0] for name, joint in compiled.mechanism.prismatic_joints()}
    if not slides or start is None:
        return {}
    moving = [f"{link}.angle" for link in slides.values() if link != FRAME]
    found = (
        dict(zip(moving, sweeping(compiled, drive).evaluate(moving, np.array([value]))[:, 0], strict=True))
        if moving
        else {}
    )
    return {n: float(found.get(f"{k}.angle", 0.0) + start.geometry.heading_angle(n, k)) for n, k in slides.items()}


class _Room:
    """A picture that holds some places (n, 2)."""

    def __init__(self, every: Array) -> None:
        low, high = every.min(axis=0), every.max(axis=0)
        span = np.maximum(high - low, 1e-9 * max(float((high - low).max()), 1e-9))
        self.scale = min((WIDTH - 2 * MARGIN) / span[0], (TALLEST - 2 * MARGIN) / span[1])
        self.width, self.height = WIDTH, float(span[1] * self.scale + 2 * MARGIN)
        self.middle = (low + high) / 2

    def to_picture(self, place: Array) -> Array:
        """Where a place (m) lies in the picture."""
        x, y = (place - self.middle) * self.scale
        return np.array([self.width / 2 + x, self.height / 2 - y])


def _segments(bones: Mapping[str, Sequence[str]], at: Mapping[str, Array]) -> Iterator[tuple[Array, Array]]:
    for of in bones.values():
        ring = [at[point] for point in of]
        yield from zip(ring, ring[1:] if len(ring) < 3 else [*ring[1:], ring[0]], strict=False)


def _body(of: Sequence[Array], look: str) -> str:
    """A link: a bar, or the hull of its joints."""
    if len(of) < 2:
        return ""
    ring = np.array(of if len(of) == 2 else _hull(of))
    shape = "polyline" if len(of) == 2 else "polygon"
    return f'<{shape} class="link {look}" points="{points(ring[:, 0], ring[:, 1])}"/>'


def _hull(of: Sequence[Array]) -> Array:
    import shapely

    shape = shapely.convex_hull(shapely.multipoints(np.array(of)))
    return np.array(shape.exterior.coords if shape.geom_type == "Polygon" else shape.coords)


def _ground(place: Array) -> str:
    x, y = place
    hatch = "".join(f"M{x + k:.1f} {y + 12:.1f}l-4 5" for k in (-6, -1, 4, 9))
    return f'<path class="ground" d="M{x:.1f} {y:.1f}l-9 12h18zM{x - 12:.1f} {y + 12:.1f}h24{hatch}"/>'


def _slide(place: Array, angle: float) -> str:
    """A block that slides along a line of the direction ``angle`` (rad)."""
    x, y = place
    turned = f"translate({x:.1f} {y:.1f}) rotate({-np.degrees(angle):.1f})"
    return f'<path class="pin" transform="{turned}" d="M-8-5h16v10h-16zM-14 0h6M8 0h6"/>'


class _Placing:
    """Finds room for texts: away from joints, links and each other."""

    def __init__(self, room: _Room, joints: Sequence[Array], segments: Sequence[tuple[Array, Array]]) -> None:
        self.room, self.joints = room, np.array(joints)
        steps = np.linspace(0.0, 1.0, 25)[:, None]
        ways = [a + (b - a) * steps for a, b in segments]
        self.ways = np.concatenate(ways) if ways else np.empty((0, 2))
        self.taken: list[tuple[Array, Array]] = []

    def number(self, number: int, of: Sequence[Array], link: str) -> str:
        """A link's number on it."""
        middle = np.mean(of, axis=0) if len(of) > 1 else of[0] + np.array([0.0, 2.2 * RADIUS])
        half = np.array([RADIUS, RADIUS])
        across = np.array([1.0, 0.0])
        if len(of) > 1 and np.linalg.norm(of[1] - of[0]) > 0:
            along = (of[1] - of[0]) / np.linalg.norm(of[1] - of[0])
            across = np.array([-along[1], along[0]])
        x, y = min(
            (middle + k * RADIUS * across for k in (0.0, 1.6, -1.6, 3.0, -3.0)), key=lambda p: self.cost(p, half, 0.0)
        )
        self.taken.append((np.array([x, y]), half))
        return (
            f'<g class="number"><title>{markup(link)}</title><circle cx="{x:.1f}" cy="{y:.1f}" r="{RADIUS:.0f}"/>'
            f'<text x="{x:.1f}" y="{y + 4:.1f}" text-anchor="middle">{number}</text></g>'
        )

    def label(self, text: str, at: Array) -> str:
        """A joint's name near it, with a line to it where it stands off."""
        half = np.array([LETTER * columns(text) / 2 + 3, LINE / 2 + 1])
        beside = 0.8 * half[0] * np.sign(np.round(ROUND, 6)) * [1, 0]
        spots = [(spot, way) for way in AWAY for spot in at + way * ROUND + beside]
        place, way = min(spots, key=lambda spot: self.cost(spot[0], half, spot[1]))
        self.taken.append((place, half))
        (x, y), (left, top), (w, h) = place, place - half, 2 * half
        edge = np.clip(at, place - half, place + half)
        leader = f'<path d="M{at[0]:.1f} {at[1]:.1f}L{edge[0]:.1f} {edge[1]:.1f}"/>' if way > AWAY[0] else ""
        return (
            f'<g class="name">{leader}<rect x="{left:.1f}" y="{top:.1f}" width="{w:.1f}" height="{h:.1f}" rx="3"/>'
            f'<text x="{x:.1f}" y="{y + 4.5:.1f}" text-anchor="middle">{markup(text)}</text></g>'
        )

    def cost(self, place: Array, half: Array, way: float) -> float:
        """How bad a place is for a text of half the size ``half``, ``way`` from what it names."""

        def within(spots: Array, more: float) -> int:
            return int((np.abs(spots - place) <= half + more).all(axis=1).sum()) if len(spots) else 0

        size = np.array([self.room.width, self.room.height])
        outside = float(np.maximum(0.0, np.abs(place - size / 2) + half - size / 2).sum())
        over = sum(bool((np.abs(place - other) < half + wide).all()) for other, wide in self.taken)
        return (
            100.0 * over + 30.0 * within(self.joints, 5.0) + 3.0 * within(self.ways, 1.0) + 10.0 * outside + 0.2 * way
        )
