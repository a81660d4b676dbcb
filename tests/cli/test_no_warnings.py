"""NumPy's warnings never reach a user: all commands, over examples and the gallery, and sweeps whose samples fail.

pytest makes errors of them (``filterwarnings`` in pyproject.toml); ``linkwright run`` of each file is part of the smoke
run.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import linkwright as lw
from helpers.longer import mostly_long
from linkwright import gallery
from linkwright.app.job import examine_file
from linkwright.cli import cli
from linkwright.exports import TARGETS

EXAMPLES = sorted((Path(__file__).parents[2] / "examples").glob("*.yaml"))
GALLERY = Path(gallery.__file__).parent
MODELS = [*EXAMPLES, *sorted(GALLERY.glob("*.yaml"))]
COMMANDS = [["limits"], ["modes"], *(["export", "--to", name] for name in TARGETS)]

CRANK_AT_ITS_DEAD_CENTRE = """\
linkwright: 1
name: Toggle press
units: {length: m, angle: rad, mass: kg, time: s, force: N, torque: N*m}
links:
  frame: {points: {O: [0, 0], A: [-0.5, 0.55]}}
  crank: {points: {A: [0, 0], B: [0.09, 0]}, mass: 5, com: [0, 0], inertia: 0.05}
  conn: {points: {B: [0, 0], C: [0.42, 0]}, mass: 4, shape: rod B-C}
  up: {points: {C: [0, 0], O: [0.3, 0]}, mass: 6, shape: rod C-O}
assembly: {C: right of B-O}
drives: {motor: {turns: crank, on: frame, speed: 6, start: 0}}
measures: {T: {extremes: motor.torque}}
studies: {cycle: {turns: 1 motor, samples: 72}, limits: {}}
"""

SIX_BAR_THAT_STOPS = """\
linkwright: 1
units: {length: mm, angle: deg, mass: kg, time: s}
parameters: {CE: 210}
sketch: {A: [0, 0], B: [20, 35], C: [110, 75], D: [143, 0], E: [300, 10], F: [0, 10]}
links:
  frame: {points: [A, D, F]}
  crank: {points: [A, B]}
  coupler: {points: [B, C]}
  rocker: {points: [D, C]}
  pusher: {points: [C, E]}
  ram: {points: [E], mass: 1.5, shape: point E}
joints: {guide: {prismatic: [frame, ram], line: [F at 0, E at 0]}}
drives: {motor: {turns: crank, on: frame, speed: 0.06 rpm, start: sketch}}
studies: {cycle: {turns: 1 motor}}
"""


CASES = [
    pytest.param(path, command, id=f"{path.stem}-{command[-1]}", marks=[] if usual else [pytest.mark.long])
    for i, path in enumerate(MODELS)
    for j, command in enumerate(COMMANDS)
    for usual in [(i + j) % len(COMMANDS) == 0]
]
"""All pairs; those usual in which each model comes up once and each command in turn."""


@pytest.mark.parametrize(("path", "command"), CASES)
def test_commands_over_all_models(path: Path, command: list[str], tmp_path: Path) -> None:
    out = ["--out", str(tmp_path)] if command[0] == "export" else []
    done = CliRunner().invoke(cli, [command[0], str(path), *command[1:], *out], catch_exceptions=False)
    assert done.exit_code in (0, 1, 2)
    assert "Warning" not in done.stderr


@pytest.mark.parametrize("path", mostly_long(MODELS, lambda path: path in MODELS[::3]), ids=lambda path: path.stem)
def test_sweeps_over_all_models(path: Path) -> None:
    """Over lengths from a fifth to three times their own: many samples can't be assembled, or not all the way."""
    examined = examine_file(path)
    document, compiled = examined.document, examined.compiled
    assert document is not None and compiled is not None
    if "cycle" not in document.studies:
        pytest.skip("without a cycle")
    links = compiled.structure.topology.moving
    outputs = [f"{link}.{rate}" for link in links[:4] for rate in ("angle", "omega", "alpha")]
    for name in [*document.parameters][:1]:
        _, size = compiled.quantities.unit_of(compiled.quantities.dimensions.of(name))
        vary = {name: np.linspace(0.2, 3, 7) * compiled.quantities.parameters[name] / size}
        try:
            lw.sweep(path, vary, [*outputs, *[*document.measures][:1]], kernel="numpy", poses=12)
        except lw.ModelError as refused:  # what can't be varied
            assert refused.findings


@pytest.mark.parametrize("text", [CRANK_AT_ITS_DEAD_CENTRE, SIX_BAR_THAT_STOPS], ids=["dead-centre", "stops"])
@pytest.mark.parametrize("command", ["run", "limits", "modes"])
def test_motions_that_stop(text: str, command: str, tmp_path: Path) -> None:
    (tmp_path / "model.yaml").write_text(text, "utf-8")
    done = CliRunner().invoke(cli, [command, str(tmp_path / "model.yaml")], catch_exceptions=False)
    assert done.exit_code in (0, 1)
    assert not re.search("Warning|Traceback", done.output)


def test_a_sample_that_stops_in_a_dead_centre() -> None:
    """There an angle's rate is infinite; the others have their values."""
    outcome = lw.sweep(
        GALLERY / "wiper.yaml", {"crank_length": {"from": 8, "to": 120, "count": 17}}, ["sweep"], poses=40
    )
    assert 0 < outcome.failed < 17
    assert outcome.measures[0].count == 17 - outcome.failed
