"""What a mechanism is made of, and what a certificate says, as lines of text for `check`, the report and Python."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwright.elements import JointKind
from linkwright.elements.cylinder import end_of, links_of
from linkwright.elements.entries import NOUNS
from linkwright.escape import printed
from linkwright.expressions import units as u
from linkwright.findings import CLAUSES, Joined, Said, Text
from linkwright.kernels import Compiled
from linkwright.kernels.motions import rate_unit
from linkwright.laws.curve import ROUND_OFF
from linkwright.model.plane import LinkagePlane
from linkwright.notation import MAX_ORDER
from linkwright.report import understood
from linkwright.report.data import Fact
from linkwright.structure import Driven, Group, Topology


def _fact(name: str, text: Text) -> Fact:
    return {"name": Said(f"fact.{name}"), "sentence": text}


def _higher(name: str, kind: JointKind, links: tuple[str, ...]) -> Said:
    return Said("fact.higher.text", name=name, kind=kind.title, links=Joined(links))


def facts(compiled: Compiled) -> list[Fact]:
    """The structure in sentences: links, inferred pins, slides, mobility, order of solution."""
    topology: Topology = compiled.structure.topology
    m = compiled.mechanism
    lines = [_fact("links", Said("fact.links.text", moving=len(topology.moving), names=Joined(topology.moving)))]
    pins = [Said("fact.pin", name=pin.name, links=Joined(pin.links)) for pin in topology.pins.values()]
    lines.append(_fact("pins", Said("fact.pins.text", pins=Joined(pins, CLAUSES) if pins else "-")))
    slides = [Said("fact.pin", name=name, links=Joined(joint.links)) for name, joint in m.prismatic_joints()]
    if slides:
        lines.append(_fact("slides", Joined(slides, CLAUSES)))
    higher = [c for c in topology.but_pins if not c.kind.places]
    if higher:
        lines.append(_fact("higher", Joined((_higher(c.joint, c.kind, c.links) for c in higher), CLAUSES)))
    pinned = {point for pin in topology.pins.values() for _, point in pin.members}
    pinned |= {end_of(link) for name in m.cylinders for link in links_of(name)}  # no names of the file's
    pinned |= {end for c in higher for end in m.joints[c.joint].joint_points}
    lone = [point for point in compiled.quantities.signals.links_of_points if point not in pinned]
    if lone:
        lines.append(_fact("lone", Said("fact.lone.text", points=Joined(lone))))
    if copies := [copy for copy in compiled.copies if copy.path[0] == "copies"]:
        said = (Said("fact.copy", name=str(copy.path[1]), of=copy.of) for copy in copies)
        lines.append(_fact("copies", Joined(said, CLAUSES)))
    if compiled.plane is not None:
        lines.append(_fact("plane", _plane(compiled, compiled.plane)))
    if m.sketch:
        lines.append(_fact("parameters", Joined(_parameters(compiled))))
    motors = len(compiled.graph.motors)
    mobility = Said(
        "fact.mobility.text",
        mobility=compiled.structure.mobility,
        moving=len(topology.moving),
        joints=topology.joint_count,
        drives=Said("fact.mobility.followers", drives=motors, followers=len(m.followers)) if m.followers else motors,
        loops=topology.loops,
    )
    if motors:
        lines.append(_fact("drives", Joined(understood.drives(compiled), "\n")))
    lines.append(_fact("mobility", mobility))
    if order := _order(compiled):
        lines.append(_fact("order", Joined(order, CLAUSES)))
    masses = [link for link in topology.moving if m.has_mass(link)]
    without = [link for link in topology.moving if link not in masses]
    if masses:
        key = "fact.mass.some" if without else "fact.mass.all"
        lines.append(_fact("mass", Said(key, links=Joined(masses), without=Joined(without))))
    acting: dict[str, list[Text]] = understood.acting(compiled)
    laws: list[Text] = [law_fact(compiled, name) for name in compiled.motions]
    for name, said_of in (*((section, acting[section]) for section in reversed(NOUNS)), ("laws", laws)):
        if said_of:
            lines.append(_fact(name, Joined(said_of, CLAUSES)))
    return [*lines, _fact("gravity", understood.gravity(compiled))]


def law_fact(compiled: Compiled, name: str) -> Said:
    """How smooth a motion law is, where and by how much the first derivative that isn't continuous jumps, and its
    peaks."""
    motion, law, quantities = compiled.motions[name], compiled.mechanism.laws[name], compiled.quantities
    unit, size = quantities.unit_of(law.axis)
    order, continuity = motion.continuity + 1, Said("fact.law.smooth")
    if order <= MAX_ORDER:
        rate, one = rate_unit(quantities, law, order)
        rough = [join for join in motion.joins if join.jumps[order]]
        places = [
            Said(
                "fact.law.jump",
                at=f"{join.at / size:.6g} {unit}",
                jump=f"{join.jumps[order] / one:.6g} {printed(rate)}",
            )
            for join in rough
        ]
        continuity = Said("fact.law.jumps", what=Said(f"fact.law.{order}"), places=Joined(places))
    peaks = []
    for k in range(1, MAX_ORDER + 1):
        rate, one = rate_unit(quantities, law, k)
        noise = ROUND_OFF * motion.curve.sizes[k]
        values = (extreme.value if abs(extreme.value) > noise else 0.0 for extreme in motion.extremes(k))
        low, high = (f"{value / one:.6g}" for value in values)
        peaks.append(Said("fact.law.peak", what=Said(f"fact.law.{k}"), low=low, high=f"{high} {printed(rate)}"))
    return Said("fact.law", name=name, continuity=continuity, peaks=Joined(peaks))


def _parameters(compiled: Compiled) -> list[str]:
    """Names and values, in the units in which results go out."""
    quantities = compiled.quantities
    units = {name: quantities.unit_of(quantities.dimensions.of(name)) for name in quantities.parameters}
    return [
        f"{n} = {value / units[n][1]:.10g} {printed(units[n][0])}".strip() for n, value in quantities.parameters.items()
    ]


def _plane(compiled: Compiled, plane: LinkagePlane) -> Said:
    """Where the sketch lies in the vehicle."""
    unit, size = compiled.quantities.unit_of(u.LENGTH)
    vectors = {key: _triple(getattr(plane, key)) for key in ("normal", "x", "y")}
    off = [f"{name} {value / size:.4g}" for name, value in plane.deviations.items() if abs(value) > 1e-9 * size]
    how = Said("fact.plane.fitted", points=Joined(plane.fitted)) if plane.fitted else Said("fact.plane.stated")
    said = Said("fact.plane.off", points=Joined(off), unit=unit) if off else Said("fact.plane.flat")
    return Said("fact.plane.text", how=how, origin=_triple(plane.origin / size), unit=unit, off=said, **vectors)


def _triple(parts: NDArray[np.float64]) -> str:
    return "({})".format(", ".join(f"{round(float(part), 9) + 0.0:.6g}" for part in parts))


def _order(compiled: Compiled) -> list[Said]:
    lines = []
    for step in compiled.structure.steps:
        if isinstance(step, Driven):
            said = {"link": step.link, "drive": step.drive, "base": step.base}
            if (follower := compiled.mechanism.followers.get(step.drive)) is not None:
                lines.append(Said("fact.order.follower", kind=follower.title, **said))
                continue
            key = "output" if compiled.mechanism.drives[step.drive].output else "driven"
            lines.append(Said(f"fact.order.{key}", **said))
            continue
        links = Joined(step.links)
        mode = compiled.assembly.rules.get(step, "") if isinstance(step, Group) else ""
        key = "fact.order.mode" if mode else "fact.order.group"
        lines.append(Said(key, links=links, signature=step.signature, mode=mode))
    return lines
