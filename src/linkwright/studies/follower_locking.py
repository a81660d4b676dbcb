"""Where the contact of a follower holds it fast: the common normal is square to the follower's way."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.findings import Finding, Term
from linkwright.kernels import Compiled
from linkwright.results import Run
from linkwright.results.claims import SINGULAR
from linkwright.studies.assembly_checks import drive_value, row_of

Array = NDArray[np.float64]


def angles(compiled: Compiled) -> Iterator[tuple[str, str]]:
    """The pressure angles of all contacts, with their followers."""
    for name, follower in compiled.mechanism.followers.items():
        yield from ((f"{name}.{attribute}", name) for attribute in follower.pressures)


def square(pressure: Array) -> NDArray[np.bool_]:
    """Whether a contact holds its follower fast at a pressure angle (rad), or would have to draw it up."""
    return ~(np.cos(pressure) > SINGULAR)


def locked(run: Run) -> list[Finding]:
    """A finding for each follower that locks, where it first does so: the contact's force has no bound there."""
    found: dict[str, Finding] = {}
    for row, name in angles(run.compiled):
        t, pressure = row_of(run, row)
        bad = square(pressure)
        if not bad.any() or name in found:
            continue
        first = int(np.argmax(bad))
        time = float(t[first])
        good = float(t[first - 1]) if first else time
        for _ in range(60):
            middle = 0.5 * (good + time)
            if square(run.compiled.evaluate([row], np.array([middle]))[0])[0]:
                time = middle
            else:
                good = middle
        before = run.compiled.evaluate([row], np.array([good]))[0, 0]
        # Where a face turns as fast as the cam, the contact goes to infinity: the angle jumps by half a turn there.
        why = Term("face-fast" if np.cos(before) > 0.5 else "normal-square")
        follower = run.compiled.mechanism.followers[name]
        data: dict[str, Any] = {"joint": name, "kind": follower.title, "why": why, "time": f"{time:.6g}"}
        path = run.compiled.mechanism.path_of(name)
        found[name] = Finding(follower.locks, path, data | drive_value(run, time))
    return [*found.values()]
