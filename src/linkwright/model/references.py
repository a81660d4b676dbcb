"""Names of elements among the fields of an entry: each must be that of an element of its kind."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any, NamedTuple

from pydantic import BaseModel

from linkwright.elements.points import links_of_points
from linkwright.expressions.typed_fields import Context, Path
from linkwright.expressions.unknown import near, unknown, unknown_point
from linkwright.findings import Finding
from linkwright.model.mechanism import FRAME, Mechanism
from linkwright.model.pins import pins, shared_pins
from linkwright.model.stiffness import JOINTS
from linkwright.model.walk import Reference, references


class ElementKind(NamedTuple):
    """The elements that a :class:`~linkwright.expressions.typed_fields.Ref` may name: those that are ``known`` in a
    mechanism, and the ``section`` of the file where they mostly stand. A finding on another name says that it is none
    of what is ``called`` so, or has a ``code`` of its own."""

    known: Callable[[Mechanism], Iterable[str]]
    section: str
    called: str = ""
    code: str = ""


def _slides(m: Mechanism) -> list[str]:
    return [name for name, _ in m.prismatic_joints()]


KINDS: Mapping[str, ElementKind] = {
    "link": ElementKind(lambda m: m.links, "links", "link"),
    "moving": ElementKind(lambda m: [link for link in m.links if link != FRAME], "links", "link"),
    "point": ElementKind(lambda m: [*links_of_points(m), *shared_pins(m)], "links.points", "point"),
    "pivot": ElementKind(
        lambda m: [*links_of_points(m), *(n for n, joint in m.joints.items() if joint.revolute)],
        "links.points",
        "point",
    ),
    "pin": ElementKind(lambda m: pins(m), "links.points", "pin"),
    "slide": ElementKind(_slides, "joints", "slide"),
    "extended": ElementKind(lambda m: [*_slides(m), *m.cylinders], "cylinders", "slide"),
    "output": ElementKind(
        lambda m: [*_slides(m), *m.paths, *(link for link in m.links if link != FRAME)], "joints", code="drive.output"
    ),
    "drive": ElementKind(lambda m: m.movers, "drives", "drive"),
    "motor": ElementKind(lambda m: m.drives, "drives", "drive"),
    "law": ElementKind(lambda m: m.laws, "laws", "law"),
    "cam": ElementKind(lambda m: m.cams, "cams", "cam"),
    "subassembly": ElementKind(lambda m: m.subassemblies, "subassemblies", "subassembly"),
    "window": ElementKind(lambda m: m.windows, "windows", "window"),
    "touching": ElementKind(
        lambda m: [
            *(name for name, joint in m.joints_but_pins() if joint.touching is not None),
            *(name for name, follower in m.followers.items() if follower.touching is not None),
        ],
        "joints",
        "touching",
    ),
    "acting": ElementKind(lambda m: [one.name for one in m.acting() if one.kind.acts], "loads", "acting"),
    "elastic": ElementKind(
        lambda m: [*pins(m), *(name for name, _ in m.joints_but_pins()), *m.links, JOINTS], "joints", "elastic"
    ),
    "measure": ElementKind(lambda m: m.measures, "measures", "measure"),
    "parameter": ElementKind(lambda m: m.parameters, "parameters", code="name.unknown-parameter"),
}
"""The kinds by name."""


def option_faults(mechanism: Mechanism, options: BaseModel, path: Path) -> list[Finding]:
    """The names among the options of a study or an export, at their ``path``, that no element has."""
    return reference_faults(references(options, Context(mechanism, path)))


def reference_faults(found: Iterable[Reference]) -> list[Finding]:
    """The names that no element has, each told once; of a point of a link that isn't known, the link alone is told."""
    faults: dict[tuple[Any, ...], Finding] = {}
    known: dict[str, tuple[str, ...]] = {}
    for context, name, ref in found:
        m, path, kind = context.mechanism, context.path, KINDS[ref.kind]
        if (link := ref.link_at(context)) is not None:
            if link in m.links and name not in m.links[link].points:
                faults.setdefault((path, name), unknown_point(path, link, name, m.links[link].points))
            continue
        if ref.kind not in known:
            known[ref.kind] = tuple(kind.known(m))
        if name not in known[ref.kind]:
            faults.setdefault((path, name), _fault(kind, path, name, known[ref.kind]))
    return [*faults.values()]


def _fault(kind: ElementKind, path: tuple[Any, ...], name: str, known: Iterable[str]) -> Finding:
    if not kind.code:
        return unknown(kind.called, path, name, known)
    return Finding(kind.code, path, {"name": name[:60], "near": near(name, known)})
