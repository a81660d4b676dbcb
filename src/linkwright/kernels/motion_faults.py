"""What is wrong with motion laws where a drive or a follower asks them, and with those of many samples."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from linkwright.elements.follower import Follower
from linkwright.expressions.language import Call, nodes
from linkwright.findings import Finding, Term
from linkwright.kernels.motions import MotionReader, StatedMotion, rate_unit
from linkwright.laws import Motion, MotionError
from linkwright.laws.motion import jumping
from linkwright.model.mechanism import Mechanism
from linkwright.model.quantities import Quantities
from linkwright.model.sampled import Sampled

MOST = 8
"""How often a law is made anew without the samples of which something was wrong."""


def jump(quantities: Quantities, name: str, motion: Motion, path: tuple[str | int, ...]) -> Iterator[Finding]:
    """The first jump of the value or velocity of a motion law, if there is one."""
    law = quantities.mechanism.laws[name]
    for join in motion.joins:
        if join.continuity < 1:
            order = join.continuity + 1
            (unit, size), (rate, one) = quantities.unit_of(law.axis), rate_unit(quantities, law, order)
            at, jump = f"{join.at / size:.6g} {unit}", f"{join.jumps[order] / one:.6g} {rate}"
            data = {"law": name, "what": Term(("law-value", "law-velocity")[order]), "at": at, "jump": jump}
            yield Finding("drive.law-jumps", path, data)
            return


def law_faults(sampled: Sampled, motions: Mapping[str, StatedMotion]) -> list[Finding]:
    """What is wrong with the motion laws of many samples, each fault once; the samples are noted."""
    askers, findings = asking(sampled.mechanism), []
    for name, law in motions.items():
        if not any(isinstance(sampled.parameters[own], np.ndarray) for own in law.names):
            continue
        for _ in range(MOST):  # the next kind of fault shows where no sample has those before
            reader = MotionReader(
                sampled, sampled.mechanism.laws[name], {n: sampled.column(n) for n in sampled.parameters}
            )
            try:
                with np.errstate(all="ignore"):
                    found = [*_jump_faults(sampled, name, law, reader.motion(), askers.get(name, []))]
            except MotionError as error:
                found = [(reader.finding(name, fault), fault.where) for fault in error.faults]
            findings += [finding for finding, where in found if sampled.bad(np.ravel(where))]
            if not found:
                break
    return findings


Asker = tuple[tuple[str, ...], Follower | None]
"""Where a law is asked for, and the follower that asks it, if it is one."""


def asking(m: Mechanism) -> dict[str, list[Asker]]:
    """Of each law, the drives and followers that ask it."""
    found: dict[str, list[Asker]] = {}
    stated = [(("drives", name, "position"), drive.position) for name, drive in m.drives.items() if drive.position]
    stated += [(("paths", name, key), position) for name, path in m.paths.items() for key, position in path.stated]
    for place, position in stated:
        for called in {n.name for n in nodes(position.node) if isinstance(n, Call)} & m.laws.keys():
            found.setdefault(called, []).append((place, None))
    for name, follower in m.followers.items():
        for key, law in follower.laws.items():
            found.setdefault(law, []).append(((*m.path_of(name), key), follower))
    return found


def _jump_faults(
    sampled: Sampled, name: str, law: StatedMotion, made: Motion, askers: list[Asker]
) -> Iterator[tuple[Finding, Any]]:
    """What is wrong with a law of samples for those that ask it, and in which samples."""
    wrong = np.broadcast_to(np.ravel(jumping(made)), sampled.samples)
    for path, follower in askers:
        if wrong.any():
            own = {n: np.broadcast_to(sampled.parameters[n], sampled.samples)[wrong.argmax()] for n in law.names}
            alone = law.at_parameters({n: float(value) for n, value in own.items()})
            yield from ((finding, wrong) for finding in jump(sampled, name, alone, path))
        if follower is not None:
            yield from follower.law_faults(sampled, name, made, path)
