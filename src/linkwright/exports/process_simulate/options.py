"""The options of the export to Process Simulate, and what is wrong with them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Annotated

from pydantic import Field

from linkwright.elements.fields import Interval, freeze
from linkwright.exports.joints import unfollowed
from linkwright.exports.process_simulate.dialects import DIALECTS
from linkwright.exports.process_simulate.facts import Facts, check_facts
from linkwright.exports.process_simulate.functions import MOST, PATH, Wish
from linkwright.exports.process_simulate.joints import ToolJoint, driving, joints_of, named
from linkwright.exports.process_simulate.mirror import Mirror
from linkwright.expressions import units as u
from linkwright.expressions.dimensions import Wanted
from linkwright.expressions.fields import Expression, Frozen, FrozenDict
from linkwright.expressions.fields import Name as NameField
from linkwright.expressions.typed_fields import Context, Quantity, of_drive
from linkwright.expressions.unknown import unknown
from linkwright.findings import Finding, Joined
from linkwright.kernels import Compiled
from linkwright.studies.limits.study import WIDEST
from linkwright.studies.numbers import constant, interval
from linkwright.studies.sampling_options import one_of

ALLOWED = re.compile(r"[A-Za-z_][A-Za-z0-9_]{0,59}")
"""Names that every tool takes: what else Process Simulate would take isn't known."""
VALUES = {"T": u.ANGLE, "D": u.LENGTH}
"""The dimensions of what joints count."""

Which = one_of("process-simulate", "dialect", [*DIALECTS], "export.choice")


def _motor(c: Context) -> str:
    """The one drive that isn't a cam's follower."""
    motors = [*c.mechanism.drives]
    return motors[0] if len(motors) == 1 else ""


_MOVED = of_drive(u.ANGLE, u.LENGTH, _motor)


def _of_stops(c: Context) -> Wanted | None:
    """What the driving joint counts: the one named as master, else that which the drive moves."""
    options, m = c.entry, c.mechanism
    if options.master is None:
        return _MOVED.dimension_at(c)
    called = {tool: joint for joint, tool in options.names.items()}
    meant = called.get(options.master, options.master)
    return u.LENGTH if meant in dict(m.prismatic_joints()) else u.ANGLE


class ProcessSimulateOptions(Frozen):
    """In which dialect, over which range, and what the joints are called in the tool."""

    dialect: Which = "seed"  # type: ignore[valid-type]
    names: Annotated[dict[NameField, str], freeze] = Field(
        default_factory=FrozenDict, examples=[{"A": "j2", "B": "j3", "C": "j4"}]
    )
    master: NameField | None = Field(None, examples=["j2"])
    mirror: Mirror | None = None
    zero: Annotated[Expression | None, _MOVED] = None
    range: Annotated[Interval | None, _MOVED] = None
    stops: Annotated[Interval | None, Quantity(_of_stops)] = None
    flipped: tuple[NameField, ...] = ()
    left_out: tuple[NameField, ...] = ()
    decimals: int = Field(9, ge=9, le=15)
    longest: int | None = Field(None, ge=20)
    approximate: float | None = Field(None, gt=0, le=1)

    sheet: Facts = Facts()

    def wish(self, compiled: Compiled) -> Wish:
        """What is asked for, in SI. Raises DimensionError where a value doesn't fit."""
        (drive,) = compiled.graph.motors
        quantities, dimension, master = compiled.quantities, compiled.quantities.drive_dimension(drive), None
        zero = None if self.zero is None else quantities.value(self.zero, dimension)
        if self.master is not None:
            master = self.named_master(joints_of(compiled.structure))

        def two(ends: tuple[Expression, Expression] | None, of: u.Dimension) -> tuple[float, float] | None:
            return ends and (quantities.value(ends[0], of), quantities.value(ends[1], of))

        stops = two(self.stops, dimension if master is None else VALUES[master.kind])
        return Wish(
            drive, self.dialect, zero, two(self.range, dimension), stops, self.decimals, self.names, self.flipped,
            self.left_out, self.longest, self.approximate, None if master is None else master.joint,
            self.mirror,
        )  # fmt: skip

    def named_master(self, joints: list[ToolJoint]) -> ToolJoint | None:
        """The joint that ``master`` names: by its name in the model, else in the tool."""
        meant = [self.master, *(joint for joint, name in self.names.items() if name == self.master)]
        return next((j for name in meant for j in joints if j.joint == name), None)


def check(compiled: Compiled, options: ProcessSimulateOptions) -> Iterator[Finding]:
    """What is wrong with options that are well-formed, and what of the mechanism functions can't hold."""
    drives = compiled.graph.motors
    joints = joints_of(compiled.structure)
    known = [j.joint for j in joints]
    for key, names in (("names", options.names), ("flipped", options.flipped), ("left_out", options.left_out)):
        yield from (unknown("joint", (*PATH, key), name, known) for name in names if name not in known)
    told = [j for j in named(joints, options.names, (), options.left_out) if not j.left_out]
    if options.mirror is not None and not options.mirror.distinct:
        yield Finding("functions.mirror-names", (*PATH, "mirror"), {})
    elif options.mirror is not None:
        told = [j for second in (False, True) for j in options.mirror.side(told, second)]
    yield from _names(told)
    if len(told) > MOST:
        yield Finding("functions.too-many", PATH, {"count": len(told), "limit": MOST})
    if len(drives) != 1:
        yield Finding("functions.drives", ("drives",), {"count": len(drives), "names": Joined(drives)})
        return
    if any(c.kind.prescribed for c in compiled.structure.topology.drivable_joints(drives[0])):
        yield Finding("export.drive", ("drives", drives[0]), {"name": "process-simulate", "drive": drives[0]})
        return
    moved = _driven_joint(compiled, drives[0], joints) if options.master is None else options.named_master(joints)
    if moved is None and options.master is not None:
        yield unknown("joint", (*PATH, "master"), options.master, [*known, *options.names.values()])
    if moved is not None and moved.joint in options.left_out:
        code = "functions.left-out" if options.master is None else "functions.master-left-out"
        yield Finding(code, (*PATH, "left_out"), {"joint": moved.joint, "drive": drives[0]})
    if not any(j != moved and j.joint not in options.left_out for j in joints):
        yield Finding("functions.no-dependent", ("joints",), {"drive": drives[0]})
    yield from unfollowed(compiled, "process-simulate")
    yield from _values(compiled, options, drives[0], moved)
    yield from check_facts(compiled, options.sheet, (*PATH, "sheet"))


def _driven_joint(compiled: Compiled, drive: str, joints: list[ToolJoint]) -> ToolJoint | None:
    """The joint that a drive moves."""
    of, link, on = driving(compiled.structure, drive)
    return next((j for j in joints if j.of == of and {j.parent, j.child} == {link, on}), None)


def _names(joints: list[ToolJoint]) -> Iterator[Finding]:
    first: dict[str, str] = {}
    for j in joints:
        if not ALLOWED.fullmatch(j.name):
            yield Finding("functions.name", (*PATH, "names"), {"joint": j.joint, "name": j.name[:60]})
        if j.name in first:
            data = {"name": j.name[:60], "joints": Joined([first[j.name], j.joint])}
            yield Finding("functions.same-name", (*PATH, "names"), data)
        first.setdefault(j.name, j.joint)


def _values(
    compiled: Compiled, options: ProcessSimulateOptions, drive: str, driving: ToolJoint | None
) -> Iterator[Finding]:
    quantities, dimension = compiled.quantities, compiled.quantities.drive_dimension(drive)
    stops = dimension if driving is None else VALUES[driving.kind]
    if options.range is not None and options.stops is not None:
        yield Finding("functions.two-ranges", (*PATH, "stops"), {})
    every = (("zero", options.zero, dimension), ("range", options.range, dimension), ("stops", options.stops, stops))
    for key, ends, of in every:
        if ends is None:
            continue
        unit, size = quantities.unit_of(of)
        widest = WIDEST[True] if of == u.ANGLE else WIDEST[False] * compiled.assembly.size()
        if isinstance(ends, Expression):
            value, found = constant(quantities, ends, of, (*PATH, key))
            given = None if value is None else (value, value)
        else:
            given, found = interval(quantities, ends, of, (*PATH, key))
        yield from found
        if given is None:
            continue
        low, high = given
        if high - low > widest or (key != "range" and max(abs(low), abs(high)) > widest):
            data = {"drive": drive, "limit": f"{widest / size:.4g}", "unit": unit}
            yield Finding("study.wide-range", (*PATH, key), data)
