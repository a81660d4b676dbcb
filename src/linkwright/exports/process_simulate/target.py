"""The export to Process Simulate: each dependent joint's value as text in the driving joint's, proven."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from linkwright.exports.process_simulate.facts import facts
from linkwright.exports.process_simulate.functions import PATH, JointFunction, JointFunctions, make
from linkwright.exports.process_simulate.linkage import Refused
from linkwright.exports.process_simulate.masters import STILL
from linkwright.exports.process_simulate.options import ProcessSimulateOptions, check
from linkwright.exports.process_simulate.sheet import sheet
from linkwright.exports.process_simulate.text_files import check_table, pasteable, snippet
from linkwright.exports.registry import Exported, register
from linkwright.findings import Finding, Joined
from linkwright.kernels import Compiled
from linkwright.studies import RunContext
from linkwright.words import say


@register
class ProcessSimulate:
    """Joint functions for Siemens Tecnomatix Process Simulate."""

    name = "process-simulate"
    example = "{dialect: seed}"
    options = ProcessSimulateOptions

    def check(self, compiled: Compiled, options: ProcessSimulateOptions) -> list[Finding]:
        """What is wrong with options that are well-formed, and what of the mechanism functions can't hold."""
        return [*check(compiled, options)]

    def export(self, compiled: Compiled, options: ProcessSimulateOptions, site: RunContext) -> Exported:
        """Text to paste, a C# snippet, a table to check them by, a sheet that shows what goes where."""
        try:
            made = make(compiled, options.wish(compiled))
        except Refused as refused:
            return Exported(failures=[refused.finding])
        title, told = compiled.mechanism.title, facts(compiled, options.sheet, *made.range, made.zero)
        files = {
            "joint_functions.txt": pasteable(made, title),
            "joint_functions.cs": snippet(made, title),
            "check_table.csv": check_table(made),
            "joint_functions.html": sheet(compiled, made, told),
        }
        summed = {**summary(made, compiled), "facts": told.as_dict()}
        if compiled.plane is not None:
            summed["plane"] = compiled.plane.as_dict(told.units["length"][1])
        return Exported(files, summed, sentences(made), [], [*made.warnings, *_still(made)])


def _still(made: JointFunctions) -> Iterator[Finding]:
    """A warning where joints stay as they are: pivots may stand in one place by mistake."""
    still = [f.joint for f in made.functions if not f.helper and max(map(abs, f.limits)) < STILL]
    if still:
        yield Finding("functions.still", PATH, {"joints": Joined(dict.fromkeys(still))}, severity="warning")


def summary(made: JointFunctions, compiled: Compiled) -> dict[str, Any]:
    """The functions as plain values."""
    unit, size = compiled.quantities.drive_unit(made.motion.drive)
    every = (made.driving, *made.functions)
    return {
        "dialect": made.dialect,
        "decimals": made.decimals,
        "driving": {**_joint(made.driving), "drive": made.motion.drive},
        "range": {"from": made.range[0] / size, "to": made.range[1] / size, "zero": made.zero / size, "unit": unit},
        "functions": {f.name: f.text for f in made.functions},
        "limits": {f.name: {"low": f.limits[0], "high": f.limits[1], "unit": _unit(f)} for f in every},
        "joints": {f.name: _joint(f) for f in made.functions},
        "max_error": made.max_error,
        "fitted": made.fitted,
    }


def _joint(function: JointFunction) -> dict[str, Any]:
    if function.helper:
        return {"name": function.name, "kind": function.kind, "helper": True}
    return {
        "name": function.name,
        "kind": function.kind,
        "joint": function.joint,
        "parent": function.parent,
        "child": function.child,
        "sign": function.sign,
        "mirrored": function.mirrored,
        "error": function.error,
    }


def _unit(function: JointFunction) -> str:
    return "rad" if function.kind == "T" else "mm"


def sentences(made: JointFunctions) -> list[str]:
    """What is told on the terminal."""
    longest = max(len(f.text) for f in made.functions)
    data = {"count": len(made.functions), "dialect": made.dialect, "error": f"{made.max_error:.1e}"}
    told = [say("functions.done", **data, decimals=made.decimals, longest=longest)]
    return [*told, say("functions.fitted").removeprefix("# ")] if made.fitted else told
