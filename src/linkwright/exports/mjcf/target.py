"""The target ``mjcf``: a model of MuJoCo, and the positions of its joints over the motion."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from linkwright.elements.entries import NOUNS
from linkwright.exports.followed import duration, follow_motion
from linkwright.exports.joints import unjointed, unwritten
from linkwright.exports.mjcf.masses import written_masses
from linkwright.exports.mjcf.poses import TreeDrive, coordinates, motors
from linkwright.exports.mjcf.proof import missed
from linkwright.exports.mjcf.tree import Hold, spanning
from linkwright.exports.mjcf.write import Start, Writer
from linkwright.exports.numbers import positive
from linkwright.exports.registry import Exported, register
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Frozen
from linkwright.expressions.typed_fields import Quantity
from linkwright.findings import Finding, Joined
from linkwright.kernels import Compiled
from linkwright.model.csv_text import head, numbers_text
from linkwright.model.mechanism import FOLLOWING
from linkwright.studies import RunContext
from linkwright.words import say

Array = NDArray[np.float64]

PROVEN = 1e-9
"""How far (m) loops may be open and links off their places, with the joints set to their positions."""
INSTANT = 1e-9
"""How long a motion is looked at (s) where nobody says: its start alone is written."""


class MjcfOptions(Frozen):
    """What MuJoCo needs that a mechanism doesn't say."""

    tiny_mass: Annotated[Expression | None, Quantity(u.MASS)] = None
    timestep: Annotated[Expression | None, Quantity(u.TIME)] = None
    duration: Annotated[Expression | None, Quantity(u.TIME)] = None
    samples: int = Field(200, ge=1, le=100_000)


@register
class Mjcf:
    """MuJoCo's XML, with a table of joint positions."""

    name = "mjcf"
    example = "{duration: 2 s}"
    options = MjcfOptions

    def check(self, compiled: Compiled, options: MjcfOptions) -> list[Finding]:
        """Options without a value."""
        findings = [*_tiny_mass(compiled, options)[1], *_timestep(compiled, options)[1]]
        findings += duration(compiled, None, self.name, options.duration)[1]
        findings += unwritten(compiled, self.name)
        findings += unjointed(compiled, self.name)
        if closing := compiled.structure.topology.closing_slides:
            data = {"name": self.name, "joints": Joined(closing)}
            findings.append(Finding("export.cannot-close-slides", ("exports", self.name), data))
        return findings

    def export(self, compiled: Compiled, options: MjcfOptions, site: RunContext) -> Exported:
        """The model, proven over the motion."""
        stop, findings = duration(compiled, site.document, self.name, options.duration)
        run, kept = follow_motion(compiled, site.document, stop or INSTANT, options.samples)
        if findings or kept:
            return Exported(failures=[*findings, *kept])
        tree = spanning(compiled.structure.topology)
        driven = motors(compiled, tree)
        t = run.t if stop else run.t[:1]
        q, v = coordinates(run, tree.holds, driven, t)
        if lost := [hold.name for hold, row in zip(tree.holds, q, strict=True) if not np.isfinite(row).all()]:
            data = {"name": self.name, "joints": Joined(lost), "duration": f"{run.stop:.6g}"}
            return Exported(failures=[Finding("export.too-long", ("exports", self.name, "duration"), data)])
        controls = np.array([motor.sign * q[tree.holds.index(motor.hold)] for motor in driven]).reshape(-1, t.size)
        moving = compiled.structure.topology.moving
        rows = run.compiled.evaluate(compiled.graph.pose_rows, t).reshape(-1, 4, t.size)
        poses = dict(zip(moving, rows, strict=True))
        masses, warnings = written_masses(compiled, _tiny_mass(compiled, options)[0])
        slides = zip(tree.holds, q, strict=True)
        travels = {hold.joint: (float(row.min()), float(row.max())) for hold, row in slides if not hold.turns}
        start = Start(q[:, 0], v[:, 0], controls[:, 0], {link: row[:, 0] for link, row in poses.items()}, travels)
        text = Writer(compiled, tree, driven, masses, start).text(_timestep(compiled, options)[0])
        error = missed(text, {hold.name: row for hold, row in zip(tree.holds, q, strict=True)}, poses)
        if not error <= PROVEN:
            data = {"name": self.name, "error": f"{error:.1e}", "unit": "m"}
            return Exported(failures=[Finding("export.unproven", ("exports", self.name), data)])
        summary = {
            "joints": [hold.name for hold in tree.holds],
            "loops": [cut.name for cut in tree.cuts],
            "actuators": [motor.drive for motor in driven],
            "poses": int(t.size),
            "max_error": error,
            "unit": "m",
        }
        told = say("mjcf.told", bodies=len(moving), loops=len(tree.cuts), poses=t.size, error=f"{error:.1e}")
        files = {"mechanism.xml": text, "positions.csv": _table(tree.holds, driven, t, q, controls)}
        return Exported(files, summary, (told,), [], [*warnings, *_left_out(compiled)])


def _tiny_mass(compiled: Compiled, options: MjcfOptions) -> tuple[float, list[Finding]]:
    return positive(compiled, Mjcf.name, "tiny_mass", options.tiny_mass, u.MASS, 1e-3)


def _timestep(compiled: Compiled, options: MjcfOptions) -> tuple[float, list[Finding]]:
    return positive(compiled, Mjcf.name, "timestep", options.timestep, u.TIME, 1e-3)


def _left_out(compiled: Compiled) -> list[Finding]:
    """Warnings on what acts in the mechanism and isn't written, or isn't as it is."""
    acting = [one for one in compiled.mechanism.acting() if one.kind.acts]
    left = [("export.left-out", section, [one.name for one in acting if one.section == section]) for section in NOUNS]
    paths = [compiled.mechanism.path_of(name) for name in compiled.mechanism.followers]
    left += [("export.followers", of, [name for section, name in paths if section == of]) for of in FOLLOWING]
    return [
        Finding(code, (section,), {"names": Joined(names)}, severity="warning")
        for code, section, names in left
        if names
    ]


def _table(holds: Sequence[Hold], driven: Sequence[TreeDrive], t: Array, q: Array, controls: Array) -> str:
    """The joints' coordinates and the actuators' controls over the motion."""
    heads = [head("t", "s"), *(head(hold.name, "rad" if hold.turns else "m") for hold in holds)]
    heads += [head(f"ctrl {m.drive}", "rad" if m.hold.turns else "m") for m in driven]
    return numbers_text(heads, np.vstack([t, q, controls]))
