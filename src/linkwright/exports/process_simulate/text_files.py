"""What carries joint functions to the tool: text to paste, a C# snippet, and a table to check them by."""

from __future__ import annotations

import math

import numpy as np

from linkwright.escape import csharp, line
from linkwright.exports.process_simulate.functions import JointFunction, JointFunctions
from linkwright.model.csv_text import table_text
from linkwright.words import say

ROWS = 24
"""Equal steps of the check table."""


def pasteable(made: JointFunctions, title: str) -> str:
    """Each joint with its function in a line of its own."""
    lines = [
        line(say("functions.head", title=title, dialect=made.dialect)),
        say("functions.units"),
        say("functions.proof", error=f"{made.max_error:.1e}", decimals=made.decimals),
        *([say("functions.master", master=made.driving.name, drive=made.motion.drive)] * made.motion.turned_round),
        *([say("functions.mirror", master=made.driving.name, follower=made.follower)] if made.follower else []),
        *([say("functions.fitted")] if made.fitted else []),
        *([say("functions.compared")] if any(">=" in function.text for function in made.functions) else []),
        "",
        f"# {line(describe(made.driving))}",
        "",
    ]
    for function in made.functions:
        lines += [f"# {line(describe(function))}", function.text, ""]
    return "\n".join(lines)


def describe(function: JointFunction) -> str:
    """A joint in words: what it turns or slides, and between which limits."""
    if function.helper:
        return say("functions.helper", name=function.name, limits=_limits(function))
    key = "functions.joint" if function.text else "functions.driving"
    way = say(f"functions.{function.kind}{'+' if function.sign > 0 else '-'}")
    known = {"name": function.name, "kind": function.kind, "joint": function.joint, "parent": function.parent}
    error = f"{function.error:.1e} {'rad' if function.kind == 'T' else 'mm'}"
    return say(key, **known, child=function.child, way=way, limits=_limits(function), error=error)


def _limits(function: JointFunction) -> str:
    size, unit = (180 / math.pi, "deg") if function.kind == "T" and not function.helper else (1.0, "mm")
    low, high = (round(size * limit, 6) + 0.0 for limit in function.limits)
    return f"{low:.6f} .. {high:.6f} {'' if function.helper else unit}".rstrip()


def snippet(made: JointFunctions, title: str) -> str:
    """The functions set by the tool's API, as C#."""
    lines = [
        f"// {line(say('functions.head', title=title, dialect=made.dialect).removeprefix('# '))}",
        f"// {line(say('functions.snippet'))}",
        "static void SetJointFunctions(System.Collections.Generic.IDictionary<string, TxJoint> joints)",
        "{",
    ]
    for function in made.functions:
        lines += [
            f"    // {line(describe(function))}",
            f'    joints["{csharp(function.name)}"].KinematicsFunction = "{csharp(function.text)}";',
        ]
    return "\n".join([*lines, "}", ""])


def check_table(made: JointFunctions) -> str:
    """Values of the driving joint over its range, those at the zero pose among them, and what the solver gives for
    every other joint (deg or mm)."""
    low, high = made.driving.limits
    poses = np.unique([*np.linspace(low, high, ROWS + 1), *([0.0] if low <= 0 <= high else [])])
    joints = [j for j in made.motion.told if any(f.joint == j.joint for f in made.functions)]
    values = made.motion.values(joints, poses)
    columns = [(made.driving.kind, made.driving.name, poses)]
    columns += [(j.kind, j.name, row) for j, row in zip(joints, values, strict=True)]
    header = [f"{kind}({name}) [{'deg' if kind == 'T' else 'mm'}]" for kind, name, _ in columns]
    shown = [np.degrees(row) if kind == "T" else row for kind, _, row in columns]
    return table_text(
        header, [[f"{round(float(value), 9) + 0.0:.9f}" for value in row] for row in zip(*shown, strict=True)]
    )
