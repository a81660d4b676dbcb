"""Sketches in the vehicle's coordinates: the plane of a linkage whose points have three coordinates.

The plane is that of least squares through the pinned points: its normal is the last right singular vector of their
coordinates about their mean (Golub and Van Loan, Matrix Computations, on total least squares). Every point is then
projected onto it. The plane holds at the nominal parameters; coordinates in it stay expressions of the file's.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from itertools import chain, combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Place, Position
from linkwright.expressions.language import Name, nodes
from linkwright.expressions.written import FrozenDict
from linkwright.findings import Finding, Joined
from linkwright.model.mechanism import FRAME, Mechanism
from linkwright.model.parts import Link, Parameter
from linkwright.model.pins import pins
from linkwright.model.quantities import LARGEST, Quantities

Array = NDArray[np.float64]

AXES = "xyz"
PAIRS = {0: (1, 2), 1: (0, 2), 2: (0, 1)}
"""The two axes of the vehicle that a picture shows, by the third one, which is nearest to the normal."""
STRAIGHT = 1e-3
"""Points whose width is below this share of their length lie in a line: it doesn't tell a plane."""
DOUBTFUL, NO_PLANE = 1e-3, 0.02
"""How far a pinned point may be off, over the size of the linkage, without a warning; and at all."""
SAME = 1e-9
"""Points nearer than this share of the size coincide; parts of a direction that small are none."""


@dataclass(frozen=True)
class LinkagePlane:
    """Where the plane of a sketch lies in the vehicle, all (3,), lengths in m.

    ``origin`` is the place of the plane's own origin, the point nearest to the vehicle's; ``x`` and ``y`` are the unit
    vectors of its axes, ``normal`` is x × y: angles count positive about it by the right hand. ``deviations`` (m) say
    how far each sketched point lies off, positive along the normal; ``fitted`` names those by which the plane was
    found, none where it is given.
    """

    origin: Array
    normal: Array
    x: Array
    y: Array
    deviations: Mapping[str, float]
    fitted: tuple[str, ...]

    def place(self, x: Any, y: Any) -> Array:
        """Places of the plane, by their coordinates in it (m), in the vehicle's axes: (3, ...)."""
        parts = zip(self.origin, self.x, self.y, strict=True)
        return np.array([o + ex * np.asarray(x) + ey * np.asarray(y) for o, ex, ey in parts])

    def as_dict(self, size: float = 1.0) -> dict[str, Any]:
        """Plain data, lengths over ``size`` (m)."""
        return {
            "origin": (self.origin / size).tolist(),
            "normal": self.normal.tolist(),
            "x": self.x.tolist(),
            "y": self.y.tolist(),
            "deviations": {name: value / size for name, value in self.deviations.items()},
            "fitted": [*self.fitted],
        }


@dataclass(frozen=True)
class Flat:
    """A mechanism whose sketch lies in its plane; ``findings`` are errors and warnings on the way there."""

    mechanism: Mechanism
    plane: LinkagePlane | None = None
    findings: tuple[Finding, ...] = ()


def in_plane(m: Mechanism) -> Flat:
    """The mechanism with the two coordinates in the plane for the three in the vehicle."""
    spatial = [name for name, place in m.sketch.items() if place.third is not None]
    if not spatial:
        unused = m.plane is not None
        return Flat(m, findings=(Finding("sketch.plane-unused", ("plane",)),) if unused else ())
    if len(spatial) < len(m.sketch):
        others = [name for name in m.sketch if name not in spatial]
        data = {"three": Joined(spatial[:10]), "two": Joined(others[:10])}
        return _given_up(m, [Finding("sketch.mixed", ("sketch", others[0]), data)])
    quantities = Quantities(_probe(m))
    if quantities.findings:
        found = [_file_path(finding) for finding in quantities.findings]
        return _given_up(m, [finding for i, finding in enumerate(found) if finding not in found[:i]])
    places = {name: np.array([quantities.value(p, u.LENGTH) for p in at.parts]) for name, at in m.sketch.items()}
    wild = [name for name, place in places.items() if not (np.abs(place) < LARGEST).all()]
    if wild:
        texts = {name: ", ".join(part.text for part in m.sketch[name].parts)[:60] for name in wild}
        return _given_up(m, [Finding("value.not-finite", ("sketch", n), {"text": text}) for n, text in texts.items()])
    plane = _plane(m, places)
    if plane is None:
        return _given_up(m, [Finding("sketch.in-line", ("sketch",))])
    findings = [*_coincident(m, plane, places), *_off(m, plane, places, quantities)]
    if any(finding.severity == "error" for finding in findings):
        return _given_up(m, findings)
    return Flat(_projected(m, plane, places), plane, tuple(findings))


def _given_up(m: Mechanism, findings: Iterable[Finding]) -> Flat:
    """With any places: what else is wrong with the mechanism can then be told too."""
    anywhere = {name: Place([f"{i} m", f"{i * i} m"]) for i, name in enumerate(m.sketch)}
    return Flat(m.model_copy(update={"sketch": FrozenDict(anywhere), "plane": None}), None, tuple(findings))


def _probe(m: Mechanism) -> Mechanism:
    """A mechanism that holds the sketch's coordinates alone, as points of its frame."""
    pairs = {name: ((at.first.raw, at.second.raw), (at.parts[2].raw, 0)) for name, at in m.sketch.items()}
    points = {f"{name}/{i}": Position(pair) for name, both in pairs.items() for i, pair in enumerate(both)}
    links = FrozenDict({FRAME: Link.model_construct(points=FrozenDict(points))})
    return Mechanism.model_construct(units=m.units, parameters=m.parameters, plane=m.plane, links=links)


def _file_path(finding: Finding) -> Finding:
    """A finding on the probe, at its place in the file."""
    if finding.path[:1] != ("links",):
        return finding
    name = str(finding.path[3]).partition("/")[0]
    return Finding(finding.code, ("sketch", name), finding.data)


def _plane(m: Mechanism, places: Mapping[str, Array]) -> LinkagePlane | None:
    """The plane that the file states, else that of least squares; none where the points don't tell it."""
    stated, joining = m.plane, _joining(m)
    fitted: tuple[str, ...] = ()
    if stated is not None and stated.axes is not None:
        x, y = (np.eye(3)[AXES.index(axis)] for axis in stated.axes)
    elif stated is not None and stated.normal is not None:
        x, y = _axes(np.array(stated.normal))
    else:
        pinned = tuple(name for name in places if name in joining)
        for fitted in (pinned, tuple(places)):
            if (normal := _normal(np.array([places[name] for name in fitted]))) is not None:
                x, y = _axes(normal)
                break
        else:
            return None
    normal = np.cross(x, y) + 0.0  # no negative zeros
    level = float(np.mean([places[n] @ normal for n in fitted or [n for n in places if n in joining] or places]))
    off = {name: float(place @ normal) - level for name, place in places.items()}
    return LinkagePlane(level * normal + 0.0, normal, x, y, FrozenDict(off), fitted)


def _joining(m: Mechanism) -> set[str]:
    """The points in which links meet."""
    ends = chain.from_iterable((cylinder.from_, cylinder.to) for cylinder in m.cylinders.values())
    return {*ends, *(point for pin in pins(m).values() for _, point in pin.members)}


def _normal(points: Array) -> Array | None:
    """The direction in which the points (points, 3) are flattest; none where they lie in a line."""
    if len(points) < 3:
        return None
    _, widths, directions = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)
    return directions[2] if widths[1] > STRAIGHT * widths[0] else None


def _axes(normal: Array) -> tuple[Array, Array]:
    """Unit vectors of the plane's axes: x along the projection of the vehicle's x (of its y where that is the normal),
    y so that the next axis of the vehicle points upwards."""
    normal = _snapped(normal / np.linalg.norm(normal))
    first, second = PAIRS[max((1, 2, 0), key=lambda axis: round(abs(float(normal[axis])), 9))]
    x = _snapped(np.eye(3)[first] - normal[first] * normal)
    y = _snapped(np.cross(normal, x))
    return x, y if y[second] > 0 else -y + 0.0


def _snapped(direction: Array) -> Array:
    """A unit vector without parts that are round-off."""
    kept = np.where(np.abs(direction) > SAME * np.abs(direction).max(), direction, 0.0)
    return np.asarray(kept / np.linalg.norm(kept))


def _size(places: Mapping[str, Array], names: Iterable[str]) -> float:
    points = np.array([places[name] for name in names])
    return float(np.linalg.norm(np.ptp(points, axis=0)))


def _coincident(m: Mechanism, plane: LinkagePlane, places: Mapping[str, Array]) -> Iterator[Finding]:
    """Points of a link that its axes or its pins need apart, and that lie behind each other."""
    joining, size = _joining(m), _size(places, places)
    for name, link in m.links.items():
        known = [point for point, position in link.points.items() if position.sketched and point in places]
        needed = [point for i, point in enumerate(known) if point in joining or (i < 2 and name != FRAME)]
        for a, b in combinations(needed, 2):
            step = places[b] - places[a]
            if np.hypot(step @ plane.x, step @ plane.y) <= SAME * size:
                yield Finding("sketch.coincident", ("sketch", b), {"a": a, "b": b, "link": name})


def _off(m: Mechanism, plane: LinkagePlane, places: Mapping[str, Array], quantities: Quantities) -> Iterator[Finding]:
    """Pinned points too far off the plane: beyond what the file allows, else beyond a share of the size."""
    asked = m.plane is not None and m.plane.within is not None
    names = plane.fitted or (tuple(name for name in places if name in _joining(m)) if asked else ())
    if not names:
        return
    worst = max(names, key=lambda name: abs(plane.deviations[name]))
    off, size = abs(plane.deviations[worst]), _size(places, names)
    limit = NO_PLANE * size
    if asked:
        assert m.plane is not None
        assert m.plane.within is not None
        limit = quantities.value(m.plane.within, u.LENGTH)
    unit, length = quantities.unit_of(u.LENGTH)
    normal = ", ".join(f"{part:.6g}" for part in plane.normal)
    told = [f"{value / length:.4g}" for value in (off, limit)]
    data = {"name": worst, "off": told[0], "limit": told[1], "unit": unit, "normal": normal}
    if not off <= limit:
        yield Finding("sketch.no-plane", ("sketch", worst), data)
    elif not asked and off > DOUBTFUL * size:
        yield Finding("sketch.off-plane", ("sketch", worst), data, severity="warning")


def _projected(m: Mechanism, plane: LinkagePlane, places: Mapping[str, Array]) -> Mechanism:
    """The sketch in the plane. Numbers become metres; a coordinate that has a name in it stays an expression, and has
    one of its own (``plane_A_x``) where several are mixed in it."""
    derived: dict[str, Parameter] = {}
    sketch: dict[str, Place] = {}
    for name, at in m.sketch.items():
        named = any(isinstance(part, Name) for given in at.parts for part in nodes(given.node))
        pair: list[Any] = []
        for key, axis in (("x", plane.x), ("y", plane.y)):
            used = [(text.text, float(share)) for text, share in zip(at.parts, axis, strict=True) if share]
            if len(used) == 1 and used[0][1] == 1.0:
                pair.append(used[0][0])
            elif not named:
                pair.append(f"{float(places[name] @ axis)!r} m")
            else:
                terms = " + ".join(f"({text})*({share!r})" for text, share in used)
                derived[f"plane_{name}_{key}"] = Parameter(value=Expression(terms))
                pair.append(f"plane_{name}_{key}")
        sketch[name] = Place(pair)
    parameters = FrozenDict({**m.parameters, **derived, **m.parameters})
    return m.model_copy(update={"sketch": FrozenDict(sketch), "parameters": parameters, "plane": None})
