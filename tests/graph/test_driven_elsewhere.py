"""Random mechanisms driven at any joint: links that can only be placed together, against the full equations.

The oracle tells by itself which poses are regular, so that a mechanism that linkwright can't follow is a failure.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from helpers.compiled import compiled_of
from helpers.examples import UNITS
from helpers.expected import expected_angles, expected_forces, expected_motion, regular_states, worst
from helpers.plain import Plain, document_of
from helpers.random_mechanisms import DURATION, Seeded, build, driven_elsewhere, sketched
from linkwright.compilation import compile_mechanism
from linkwright.model.document import Document
from linkwright.results.certificate import certify
from linkwright.results.run import Run
from linkwright.structure import decompose

T = np.linspace(0.0, DURATION, 4)
CHAINS = (
    "four_bar",
    "slider_crank",
    "driven_slider_crank",
    "inverted_slider_crank",
    "scotch_yoke",
    "elliptic_trammel",
    "six_bar",
)


def stated(plain: Plain) -> Plain:
    """The mechanism with a sketched point on each link whose assembly has to be stated."""
    structure = decompose(Document.model_validate(document_of(plain)))
    assume(not structure.findings)
    dyads = [group.links[0] for group in structure.groups if group.modes > 1]
    return sketched(plain, [*dyads, *(link for higher_group in structure.higher_groups for link in higher_group.links)])


@pytest.mark.parametrize("chain", CHAINS)
@settings(max_examples=8)
@given(seed=st.integers(0, 10**6))
def test_motion_and_forces(chain: str, seed: int) -> None:
    """Motion to 1e-9, forces to 1e-9 of the largest; the certificate agrees."""
    source = Seeded(seed)
    plain = stated(driven_elsewhere(build(chain, source), source))
    oracle, states = regular_states(plain, T)
    compiled = compiled_of(plain)
    for order, rows in expected_motion(oracle, states).items():
        error, name = worst(compiled.evaluate(list(rows), T), rows, 1.0)
        assert error < 1e-9, (order, name)
    rows = expected_forces(oracle, states)
    error, name = worst(compiled.evaluate(list(rows), T), rows, 1e-3)
    assert error < 1e-9, name
    run = Run(compiled, 0.0, DURATION, 20)
    angles = expected_angles(oracle, states)
    difference = run.evaluate(list(angles), T) - np.array(list(angles.values()))
    assert np.abs(difference - difference[:, :1]).max() < 1e-9
    certificate = certify(run)
    assert certificate.sound(1e-9)
    assert certificate.mobility == certificate.gruebler == 1


def trammel_driven_at_a_block() -> dict[str, Any]:
    """Two blocks on crossed rails with a bar between them, turned against one block: A.x = cos, B.y = sin."""
    return {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"O": [0, 0]}},
            "a": {"points": {"A": [0, 0]}},
            "b": {"points": {"B": [0, 0]}},
            "bar": {"points": {"A": [0, 0], "B": [1, 0]}},
        },
        "joints": {
            "level": {"prismatic": ["frame", "a"], "line": ["O at 0", "A at 0"]},
            "upright": {"prismatic": ["frame", "b"], "line": ["O at pi/2", "B at pi/2"]},
        },
        "assembly": {"A": [0.6, 0], "B": [0, 0.8]},
        "drives": {"motor": {"turns": "bar", "on": "a", "speed": 0.5, "start": 2.2}},
    }


def test_a_group_whose_matrix_is_constant() -> None:
    """Both unknowns are travels on fixed rails: the closure's matrix holds plain numbers only."""
    compiled = compile_mechanism(Document.model_validate(trammel_driven_at_a_block()))
    t = np.linspace(0.0, 1.0, 5)
    angle = 2.2 + 0.5 * t
    found = compiled.evaluate(["A.x", "B.y", "A.vx", "B.ay"], t)
    expected = [-np.cos(angle), np.sin(angle), 0.5 * np.sin(angle), -0.25 * np.sin(angle)]
    assert np.abs(found - np.array(expected)).max() < 1e-12
