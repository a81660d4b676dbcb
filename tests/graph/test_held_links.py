"""Dyads whose sides are links that drives hold on each other: every kind, either side, against the full equations."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from helpers.compiled import compiled_of
from helpers.expected import expected_forces, expected_motion, regular_states, worst
from helpers.plain import FRAME, Plain, document_of
from helpers.random_mechanisms import DURATION, DYADS, Seeded, Sketch, sketched
from linkwright.model.document import Document
from linkwright.results.certificate import certify
from linkwright.results.run import Run
from linkwright.structure import decompose

T = np.linspace(0.0, DURATION, 4)
HELD = (("R", ""), ("", "R"), ("P", ""), ("", "P"), ("R", "P"), ("PP", ""), ("RP", "R"), ("P", "PR"), ("", "RRR"))
"""By which joints the links of each side are held on each other."""


def held_dyad(seed: int, kind: str, held: tuple[str, str]) -> Plain:
    """A driven link, and a dyad on it and the frame: its outer joint, its drives, its inner joint, all drawn anyhow."""
    s = Sketch(Seeded(seed))
    bases = [s.drive(s.source.pick("RP"), FRAME), FRAME]
    if s.flag():
        bases.reverse()
    meeting = []
    for base, letter, holds in zip(bases, (kind[0], kind[2]), held, strict=True):
        link = s.link()
        s.outer(letter, base, link, s.anywhere(), s.angle())
        for hold in holds:
            link = s.drive(hold, link)
        meeting.append(link)
    s.outer(kind[1], *meeting, s.anywhere(), s.angle())
    return s.finish()


@pytest.mark.parametrize("kind", DYADS)
@settings(max_examples=6)
@given(seed=st.integers(0, 10**6), held=st.sampled_from(HELD))
def test_motion_and_forces(kind: str, seed: int, held: tuple[str, str]) -> None:
    """Motion and forces to 1e-8 of the largest; the certificate agrees. No pose that is regular is refused."""
    plain = held_dyad(seed, kind, held)
    structure = decompose(Document.model_validate(document_of(plain)))
    assert not structure.findings
    (group,) = structure.groups
    assert group.signature in (kind, kind[::-1])
    assert not structure.higher_groups
    plain = sketched(plain, [group.links[0]] if group.modes > 1 else [])
    oracle, states = regular_states(plain, T)
    compiled = compiled_of(plain)
    for order, rows in expected_motion(oracle, states).items():
        error, name = worst(compiled.evaluate(list(rows), T), rows, 1.0)
        assert error < 1e-8, (order, name)
    forces = expected_forces(oracle, states)
    error, name = worst(compiled.evaluate(list(forces), T), forces, 1e-3)
    assert error < 1e-8, name
    assert certify(Run(compiled, 0.0, DURATION, 20)).sound(1e-9)
