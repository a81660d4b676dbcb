"""What friction does beyond its forces: it jams a mechanism, locks it against its loads, or leaves its forces open."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwright.findings import Finding, Term
from linkwright.results import Run
from linkwright.results.breakaway import resting_stretches, starting, unstarted
from linkwright.results.jamming import followed, laws, meets, several
from linkwright.results.self_locking import locked_stretches
from linkwright.studies.assembly_checks import drive_value
from linkwright.studies.load_checks import NEAR, finding_at, outside_at_rest, telling_times

Array = NDArray[np.float64]

NO_FORCE = 1e-100
"""Efforts (N, N m) below this are none: where nothing presses, the smoothed size of forces leaves some 1e-150."""


class FrictionLaws:
    """The laws of all friction of a run at telling times, followed once for what is found of them."""

    def __init__(self, run: Run) -> None:
        self.run, self.resisting = run, run.compiled.graph.actions.resisting
        if self.resisting:
            self.t = telling_times(run, [])
            self.laws = laws(run.compiled, self.t)
            self.share, self.efforts = followed(self.laws)

    def jammed(self) -> list[Finding]:
        """Where friction jams the mechanism soonest as its coefficients grow, where it gives power, as its coefficient
        is negative, and where its forces aren't those to which its growth leads."""
        if not self.resisting:
            return []
        run, resisting, t = self.run, self.resisting, self.t
        worst = int(np.argmin(self.share))
        if np.isfinite(self.share[worst]):
            code = "friction.jams-meeting" if meets(self.laws.at(worst)) else "friction.jams"
            return [finding_at(run, code, resisting[0].path, float(t[worst]), share=f"{self.share[worst]:.3g}")]
        own = run.compiled.evaluate([f"{one.name}.{one.kind.effort(one.entry)}" for one in resisting], t)
        efforts = self.efforts[: len(resisting)]  # the others follow from the sizes of forces, as those of teeth
        away = np.abs(own - efforts).max(axis=0) / np.maximum(np.abs(efforts).max(axis=0), NO_FORCE)
        late = int(np.argmax(np.nan_to_num(away, nan=np.inf)))
        if not away[late] <= NEAR:
            return [finding_at(run, "friction.unsolved", resisting[0].path, float(t[late]))]
        every = run.compiled.evaluate([f"{one.name}.power" for one in resisting], t)
        for one, power in zip(resisting, every, strict=True):
            if power.max() > NEAR * np.abs(power).max():
                return [finding_at(run, "friction.gives", one.path, float(t[np.argmax(power)]))]
        return []

    def ambiguous(self) -> list[Finding]:
        """A warning where other friction forces obey the same laws."""
        if not self.resisting:
            return []
        open_ = several(self.laws, self.efforts)
        if not open_.any():
            return []
        share, time = f"{100 * float(open_.mean()):.3g}", float(self.t[np.argmax(open_)])
        return [finding_at(self.run, "friction.several", self.resisting[0].path, time, "warning", share=share)]


def starts(run: Run) -> list[Finding]:
    """Where no effort of a drive starts the motion from rest, a warning; where the released mechanism stays at rest, a
    note."""
    found = outside_at_rest(run) if starting(run.compiled) else []
    if found:
        return found
    for drive in starting(run.compiled):
        for sense, times in unstarted(run.compiled, drive, telling_times(run, [])).items():
            if times.size:
                data = {"name": drive, "sense": Term(f"sense-{sense}")}
                code, path = "friction.cannot-start", ("drives", drive)
                found.append(finding_at(run, code, path, float(times[0]), "warning", **data))
        if stretches := resting_stretches(run, drive):
            found.append(_stretches(run, "friction.rests", drive, stretches))
    return found


def self_locking(run: Run) -> list[Finding]:
    """A note for each drive that has to push though loads would drive it without friction: its longest stretch."""
    if not run.compiled.graph.actions.resisting:
        return []
    every = ((drive, locked_stretches(run, drive)) for drive in run.compiled.graph.motors)
    return [_stretches(run, "friction.self-locking", drive, stretches) for drive, stretches in every if stretches]


def _stretches(run: Run, code: str, drive: str, stretches: list[tuple[float, float]]) -> Finding:
    """A note on stretches of time (s): the longest one, their number and share."""
    start, stop = max(stretches, key=lambda one: one[1] - one[0])
    ends = [drive_value(run, time) for time in (start, stop)]
    data = {
        "name": drive,
        "start": f"{start:.6g}",
        "stop": f"{stop:.6g}",
        "drive": ends[0]["drive"],
        "low": ends[0]["value"],
        "high": ends[1]["value"],
        "unit": ends[0]["unit"],
        "count": len(stretches),
        "share": f"{100 * sum(b - a for a, b in stretches) / (run.stop - run.start):.3g}",
    }
    return Finding(code, ("drives", drive), data, severity="note")
