"""Every emitter against CasADi's own evaluation of the same program: each example's mechanism once, and seeded random
ones.

To max(1e-11, 1e-13/d^2) of the signal's largest magnitude in the run, d the smallest normalised determinant of a group
at the pose: round-off that a group magnifies by 1/d in its rates, and once more in theirs. Poses beyond REGULAR are
left out, as at a change point there is no figure to agree on.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest

from helpers.compiled import compiled_of, conditioning
from helpers.emitted import EMITTERS, every_emitter
from helpers.random_mechanisms import DURATION, RECIPES, Seeded, build
from linkwright.compilation import compile_mechanism
from linkwright.graph.program import Program
from linkwright.graph.rows import determinants
from linkwright.kernels import Compiled
from linkwright.model.document import load
from linkwright.studies.cycle.options import CycleOptions, span

# An example called so has the links, groups and forces of another: it shows another study or another law of a drive,
# which are no part of a program. To compile it would take seconds and prove nothing new.
REPEATS = ("_accuracy", "_allocation", "_calibration", "_dwell", "_sweep", "_workspace")
FOLDER = Path(__file__).parents[2] / "examples"
STRUCTURES = ("bracket",)
"""Examples without a motion."""
EXAMPLES = [p for p in sorted(FOLDER.glob("*.yaml")) if not p.stem.endswith(REPEATS) and p.stem not in STRUCTURES]
COMPILED = [kernel for kernel in every_emitter() if kernel.values != ("numpy",)]
CHOSEN = (
    "cam_linkage",
    "class_four",
    "conjugate_cam",
    "jansen_leg",
    "pick_and_place",
    "planetary_train",
    "sauer_platform",
    "scotch_yoke",
    "slider_crank_friction",
    "tailgate",
)
"""Examples whose programs have all that those of the others have: compiling takes seconds each."""
TRACED = ("cam_linkage", "class_four", "scotch_yoke")
"""Of these, where compiling takes longest of all."""
REGULAR = 1e-3
ROUND_OFF = 1e-12
Case = tuple[Program, np.ndarray, np.ndarray, np.ndarray, np.ndarray]


def names_of(compiled: Compiled) -> list[str]:
    """What the measures ask for, and some of the forces, torques and accelerations."""
    every = [signal.text for signal in compiled.quantities.signals.all() if signal.attribute != "arm"]
    asked = " ".join(str(measure) for measure in compiled.mechanism.measures.values())
    forces = [name for name in every if name.startswith("force(")]
    rates = [name for name in every if name.endswith((".torque", ".force", ".alpha"))]
    measured = [name for name in every if name in asked]
    return list(dict.fromkeys([*measured[:8], *forces[:2], *rates[:3]]))


def case_of(compiled: Compiled, names: list[str], t: np.ndarray, rates: bool = True) -> Case:
    """A program that solves what it can itself, its inputs at regular poses, CasADi's figures, the bounds of errors."""
    program = compiled.graph.program(names, rates=rates, solve=True)
    labels = determinants(compiled.structure)
    x, p, d = compiled.inputs(t), compiled.parameters, np.ones(t.size)
    if labels:
        d = np.abs(compiled.closed_form_rows(labels, t)).min(axis=0)
    x, d = x[:, ~(d < REGULAR)], d[~(d < REGULAR)]
    closed = compiled.graph.program(names, rates=rates)
    expected = np.array([closed(pose, p) for pose in x.T]).T
    return program, x, p, expected, np.maximum(1e-11, 1e-13 / d**2)


@cache
def of_example(path: Path, rates: bool = True) -> Case:
    document = load(path)
    compiled = compile_mechanism(document, path.parent)
    length, wrong = span(compiled, CycleOptions.model_validate(document.studies["cycle"]))
    assert not wrong
    return case_of(compiled, names_of(compiled), np.linspace(0.0, length, 25), rates)


def agrees(kernel: str, case: Case) -> None:
    program, x, p, expected, bounds = case
    found = EMITTERS[kernel](program).run(x, p)
    unknown = np.isnan(expected)
    assert np.array_equal(np.isnan(found), unknown)
    assert not unknown.all()
    largest = np.abs(np.where(unknown, 0.0, expected)).max(axis=1, keepdims=True)
    # What is only round-off, as the acceleration of a gear at constant speed, is so beside the others.
    largest = np.where(largest < ROUND_OFF * largest.max(), 1e-3 * largest.max(), largest)
    late = (np.where(unknown, 0.0, np.abs(found - expected)) > np.where(unknown, 0.0, bounds * largest)).any(axis=1)
    assert not late.any(), [program.outputs[i] for i in np.flatnonzero(late)]


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_on_every_example(path: Path) -> None:
    agrees("numpy", of_example(path))


@pytest.mark.long
@pytest.mark.parametrize("kernel", COMPILED)
@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_compiled_on_every_example(kernel: str, path: Path) -> None:
    agrees(kernel, of_example(path, rates=False))


@pytest.mark.parametrize(
    ("name", "kernel"),
    [
        pytest.param(name, *kernel.values, marks=[*kernel.marks, *([pytest.mark.long] if slow else [])])
        for name in CHOSEN
        for kernel in COMPILED
        for slow in ["jax" in kernel.values and name not in TRACED]
    ],
)
def test_on_chosen_examples(kernel: str, name: str) -> None:
    """Without rates, which double a program by the same kinds of instructions; the random mechanisms have them."""
    agrees(kernel, of_example(FOLDER / f"{name}.yaml", rates=False))


def parts_of(program: Program) -> set[tuple[str, int]]:
    """What an emitter has to spell: the operations, and the sizes of Newton's stages."""
    stages = [program.block, *(stage.closure for stage in program.solves)]
    operations = {("operation", instruction.op) for stage in stages for instruction in stage.instructions}
    return operations | {("stage", len(stage.rows)) for stage in program.solves}


def test_the_chosen_have_all_parts() -> None:
    """A new example with another operation has to be among them."""
    chosen = set().union(*(parts_of(of_example(FOLDER / f"{name}.yaml", rates=False)[0]) for name in CHOSEN))
    for path in EXAMPLES:
        assert parts_of(of_example(path, rates=False)[0]) <= chosen, path.stem


@cache
def of_recipe(recipe: str) -> Case:
    """The first seed whose mechanism stays away from singular poses."""
    t = np.linspace(0.0, DURATION, 9)
    for seed in range(50):
        compiled = compiled_of(build(recipe, Seeded(seed)))
        worst, reach = conditioning(compiled, t)
        if worst > 0.02 and reach > 0.0:
            return case_of(compiled, names_of(compiled), t)
    raise AssertionError(recipe)


@pytest.mark.parametrize("kernel", every_emitter())
@pytest.mark.parametrize("recipe", RECIPES)
def test_on_random_mechanisms(kernel: str, recipe: str) -> None:
    agrees(kernel, of_recipe(recipe))


def test_a_wrong_figure_is_seen() -> None:
    program, x, p, expected, bounds = of_example(FOLDER / "paper_feeder.yaml")
    row = program.outputs.index("motor.torque")
    pose = int(np.argmax(np.abs(expected[row])))
    wrong = expected.copy()
    wrong[row, pose] *= 1 + 1e-10
    agrees("numpy", (program, x, p, expected, bounds))
    with pytest.raises(AssertionError, match=r"motor\.torque"):
        agrees("numpy", (program, x, p, wrong, bounds))
