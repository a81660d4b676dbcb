"""Mechanisms written in Python: the same object as a model file gives, by the same validation."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any, Self

from linkwright.findings import Finding, ModelError
from linkwright.model.document import VERSION, Document, parse_document

Point = Any
"""``[x, y]`` or ``"r at angle"``; numbers, or expressions as text."""
Points = Mapping[str, Point] | Iterable[str] | None
"""Points of a link by name; or the names alone, of points of the sketch."""


class Builder:
    """Collects the parts of a model file; each method gives the builder back, so that calls can be chained.

    Names, numbers and expressions are written as in the file; what a bare number means is said by the units
    given here. Nothing is checked before :meth:`build`.
    """

    def __init__(
        self,
        name: str = "mechanism",
        length: str | None = "mm",
        angle: str | None = "deg",
        mass: str | None = "kg",
        time: str | None = "s",
        force: str | None = "N",
        torque: str | None = "N*m",
        pressure: str | None = None,
        note: str | None = None,
        source: str | None = None,
        author: str | None = None,
        revision: str | None = None,
    ) -> None:
        units = {"length": length, "angle": angle, "mass": mass, "time": time, "force": force, "torque": torque}
        head = {"name": name, "note": note, "source": source, "author": author, "revision": revision}
        self._data: dict[str, Any] = _without_none(
            linkwright=VERSION, **head, units=_without_none(**units, pressure=pressure)
        )
        self._twice: list[Finding] = []

    def parameter(self, name: str, value: Any, tolerance: Any = None, note: str | None = None) -> Self:
        """A named value; ``tolerance`` is one number for plus and minus, ``[lower, upper]``, a class, or a
        mapping, as in the file."""
        if tolerance is None and note is None:
            return self._add_entry("parameters", name, value)
        return self._add_entry("parameters", name, _without_none(value=value, tolerance=tolerance, note=note))

    def sketch(self, places: Mapping[str, Point] | None = None, **more: Point) -> Self:
        """The places of points in the frame, at the start of the motion, instead of lengths."""
        for name, place in {**(places or {}), **more}.items():
            self._add_entry("sketch", name, place)
        return self

    def plane(self, axes: str | None = None, *, normal: Iterable[float] | None = None, within: Any = None) -> Self:
        """The plane of a sketch of three coordinates: two axes of the vehicle such as ``"xz"``, or its normal."""
        self._data["plane"] = _without_none(axes=axes, normal=None if normal is None else [*normal], within=within)
        return self

    def frame(self, points: Points = None, **more: Point) -> Self:
        """The link that doesn't move, with its points."""
        return self._add_entry("links", "frame", {"points": _points(points, more)})

    def link(
        self,
        name: str,
        points: Points = None,
        *,
        mass: Any = None,
        com: Point = None,
        inertia: Any = None,
        shape: str | None = None,
        **more: Point,
    ) -> Self:
        """A moving link. Points are given as a mapping, by name (``B=["AB", 0]``), or as a list of sketched ones."""
        rest = _without_none(mass=mass, com=com, inertia=inertia, shape=shape)
        return self._add_entry("links", name, {"points": _points(points, more), **rest})

    def prismatic(self, name: str, first: tuple[str, str], second: tuple[str, str], travel: Any = None) -> Self:
        """A slide: of each of two links its name and its line, such as ``("guide", "G at 90 deg")``; ``travel`` is the
        allowed range ``[lowest, highest]`` of the signal ``NAME.s``."""
        joint = {"prismatic": [first[0], second[0]], "line": [first[1], second[1]]}
        return self._add_entry("joints", name, joint | _without_none(travel=travel))

    def revolute(self, name: str, first: tuple[str, str], second: tuple[str, str]) -> Self:
        """A pin between points of different names: of each of two links its name and its point."""
        return self._add_entry("joints", name, {"revolute": [first[0], second[0]], "at": [first[1], second[1]]})

    def weld(self, name: str, link: str, on: str, angle: Any) -> Self:
        """A weld of ``link`` onto ``on`` at the pin that they share; ``angle`` is that of the first link against
        the second, by their x axes."""
        return self._add_entry("joints", name, {"weld": [link, on], "angle": angle})

    def pin_in_slot(self, name: str, first: tuple[str, str], second: str, **slot: Any) -> Self:
        """A pin in a slot: the link that has the pin and its point, and the slotted link; ``slot`` has the keys of a
        file, such as ``straight="C at 0 deg"`` or ``arc={"centre": "M", "radius": 50}``, ``flank`` and ``travel``."""
        return self._add_entry("joints", name, {"pin_in_slot": [first[0], second], "pin": first[1], **slot})

    def cylinder(
        self,
        name: str,
        start: str,
        end: str,
        *,
        length: Any = None,
        barrel: Mapping[str, Any] | None = None,
        rod: Mapping[str, Any] | None = None,
    ) -> Self:
        """A cylinder from the point ``start`` (barrel) to the point ``end`` (rod); ``barrel`` and ``rod`` say
        their ``mass``, ``com`` and ``inertia``."""
        return self._add_entry(
            "cylinders", name, _without_none(**{"from": start}, to=end, length=length, barrel=barrel, rod=rod)
        )

    def subassembly(
        self, name: str, content: Builder | Mapping[str, Any], ports: Iterable[str] = (), note: str | None = None
    ) -> Self:
        """Elements that are placed as copies (:meth:`copy`): those of another builder, whose units and title don't
        count, or the sections as in a file. The ``ports`` are names that each copy is given."""
        if isinstance(content, Builder):
            self._twice += (replace(f, path=("subassemblies", name, *f.path)) for f in content._twice)
            content = {key: entries for key, entries in content._data.items() if key not in _OF_FILES}
        given = _without_none(note=note, ports=[*ports] or None)
        return self._add_entry("subassemblies", name, {**given, **content})

    def copy(
        self,
        name: str,
        of: str,
        join: Mapping[str, str] | None = None,
        parameters: Mapping[str, Any] | None = None,
        mirrored: bool = False,
        at: Point = None,
    ) -> Self:
        """A copy of a sub-assembly: what each of its ports is joined to, other values of its parameters, whether it is
        the mirror image, and the displacement of its points in the frame."""
        data = {"of": of, "join": join, "parameters": parameters, "mirrored": mirrored or None, "at": at}
        return self._add_entry("copies", name, _without_none(**data))

    def assembly(self, point: str, rule: Any) -> Self:
        """On which side a group is put together: ``("C", "left of B-D")``."""
        return self._add_entry("assembly", point, rule)

    def drive(
        self,
        name: str,
        *,
        turns: str | None = None,
        slides: str | None = None,
        extends: str | None = None,
        on: str | None = None,
        speed: Any = None,
        start: Any = None,
        position: Any = None,
        acceleration: Any = None,
        output: str | None = None,
    ) -> Self:
        """A prescribed motion of the link that it ``turns`` or ``slides``, against the link ``on`` (the frame unless
        given), or of the cylinder or slide that it ``extends``; with ``output``, the law is that of a prismatic joint,
        or of a link on the frame, which the drive is to move."""
        on = on or (None if extends else "frame")
        law = _without_none(turns=turns, slides=slides, extends=extends, on=on, speed=speed, acceleration=acceleration)
        law |= _without_none(start=start, position=position, output=output)
        return self._add_entry("drives", name, law)

    def cam(self, name: str, *, cam: str, follower: str, base: Any, law: str, on: str = "frame", **more: Any) -> Self:
        """A plate cam on the link ``cam`` and the ``follower`` that rides on it; ``more`` says by what it touches
        (``roller`` and ``at``, ``knife`` or ``face``), ``side``, ``phase``, ``sense``, ``closed``, ``second``, as in a
        file."""
        data = {"cam": cam, "follower": follower, "on": on, "base": base, "law": law}
        return self._add_entry("cams", name, data | _without_none(**more))

    def table(
        self,
        name: str,
        points: Any = None,
        *,
        file: str | None = None,
        x: str | None = None,
        y: str | None = None,
        period: Any = None,
        between: str | None = None,
    ) -> Self:
        """A function given by points ``[x, y]``, or by two columns of a CSV file."""
        return self._add_entry(
            "tables", name, _without_none(file=file, points=points, x=x, y=y, period=period, between=between)
        )

    def law(
        self,
        name: str,
        segments: Any,
        *,
        over: str,
        of: str,
        start: Any = None,
        period: Any = None,
        beyond: str | None = None,
    ) -> Self:
        """A function ``over`` an angle or time, ``of`` an angle or length, by segments as in the file."""
        law = _without_none(over=over, of=of, start=start, period=period, beyond=beyond, segments=segments)
        return self._add_entry("laws", name, law)

    def load(
        self,
        name: str,
        on: str,
        *,
        against: str | None = None,
        at: Any = None,
        force: Any = None,
        along: str | None = None,
        torque: Any = None,
        in_: str | None = None,
        window: str | None = None,
    ) -> Self:
        """A force ``[Fx, Fy]`` at a point (or one number ``along`` a slide), or a torque, on a link; the opposite acts
        on the link ``against``, if one is named."""
        data = _without_none(on=on, against=against, at=at, force=force, along=along, torque=torque, window=window)
        return self._add_entry("loads", name, data | ({"in": in_} if in_ is not None else {}))

    def spring(
        self,
        name: str,
        from_: str | None = None,
        to: str | None = None,
        *,
        in_: tuple[str, str] | None = None,
        turns: str | None = None,
        on: str | None = None,
        **law: Any,
    ) -> Self:
        """A spring, damper or gas spring between two points, or a torsional one that ``turns`` a link ``on`` another.

        ``law`` is as in the file: ``stiffness`` and ``free``, ``damping``, ``gas`` and ``progression``, ...
        """
        ends = {"from": from_, "to": to, "in": in_, "turns": turns, "on": on}
        return self._add_entry("springs", name, _without_none(**ends, **law))

    def counterweight(self, name: str, on: str, mass: Any, at: Any, inertia: Any = None) -> Self:
        """A mass added to a link, at a point of it or at coordinates."""
        return self._add_entry("counterweights", name, _without_none(on=on, mass=mass, at=at, inertia=inertia))

    def friction(
        self,
        name: str,
        *,
        pin: str | None = None,
        slide: str | None = None,
        in_: tuple[str, str] | None = None,
        **law: Any,
    ) -> Self:
        """Friction in a pin or slide; ``law`` is as in the file: ``radius`` or ``length``, ``coefficient``,
        ``viscous``."""
        places = {"pin": pin, "slide": slide, "in": in_}
        return self._add_entry("friction", name, _without_none(**places, **law))

    def window(self, name: str, low: Any, high: Any, of: str | None = None) -> Self:
        """A stretch of the motion: from ``low`` to ``high`` in time, or in the value of the signal ``of``."""
        return self._add_entry("windows", name, [low, high] if of is None else {of: [low, high]})

    def measure(self, name: str, **reduction: Any) -> Self:
        """A figure that is asked for: ``measure("stroke", span="E.x")``."""
        return self._add_entry("measures", name, reduction)

    def require(self, measure: str, limit: str) -> Self:
        """A limit on a measure: ``require("stroke", ">= 680 mm")``."""
        return self._add_entry("require", measure, limit)

    def gravity(self, x: Any, y: Any = None, *, along: Any = None) -> Self:
        """Gravity: ``"earth"`` (down is -y), ``"earth", along=[x, y]`` in a direction of any length, or the
        components ``x, y`` of the acceleration in the frame."""
        if along is not None:
            x = "{} along [{}, {}]".format(x, *_listed(along))
        self._data["gravity"] = _listed(x) if y is None else [_listed(x), _listed(y)]
        return self

    def study(self, name: str, **options: Any) -> Self:
        """Something to be computed, with its options."""
        return self._add_entry("studies", name, options)

    def export(self, target: str, **options: Any) -> Self:
        """What is written for another tool, with the target's options."""
        return self._add_entry("exports", target, options)

    def build(self) -> Document:
        """The document. Raises :class:`ModelError` with all findings of form."""
        findings = list(self._twice)
        document = None
        try:
            document = parse_document({"links": {}, **self._data})
        except ModelError as error:
            findings += error.findings
        if findings or document is None:
            raise ModelError(findings)
        return document

    def _add_entry(self, section: str, name: str, entry: Any) -> Self:
        entries = self._data.setdefault(section, {})
        if name in entries:
            self._twice.append(Finding("builder.twice", (section, name), {"name": name}))
        entries[name] = _listed(entry)
        return self


_OF_FILES = ("linkwright", "name", "units", "note", "source", "author", "revision")
"""What a builder says of the file."""


def _points(points: Points, more: Mapping[str, Point]) -> dict[str, Point]:
    given = points if isinstance(points, Mapping) else dict.fromkeys(points or (), "sketch")
    return {**given, **more}


def _without_none(**entries: Any) -> dict[str, Any]:
    """What is given of some keys."""
    return {key: value for key, value in entries.items() if value is not None}


def _listed(value: Any) -> Any:
    """Plain data also where NumPy's arrays and numbers stand in it."""
    if isinstance(value, Mapping):
        return {key: _listed(entry) for key, entry in value.items()}
    if isinstance(value, list | tuple):
        return [_listed(entry) for entry in value]
    return value.tolist() if type(value).__module__ == "numpy" else value
