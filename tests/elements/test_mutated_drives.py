"""Files with drives without joints, paths, differentials and static friction, changed at random with fixed seeds: they
are refused with words, or they run; never an exception."""

from __future__ import annotations

import copy
import random
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from ruamel.yaml import YAML

from linkwright.compilation import compile_mechanism
from linkwright.findings import ModelError
from linkwright.kernels import Compiled
from linkwright.model.document import parse_document
from linkwright.report.structure_summary import facts

EXAMPLES = Path(__file__).parents[2] / "examples"
NAMES = ("levelled_bucket", "pick_and_place", "phase_differential", "lifting_crank")
SECTIONS = {
    "drives": ["turns", "slides", "extends", "moves", "at", "along", "on", "output", "speed", "start", "position"],
    "paths": ["moves", "at", "on", "line", "arc", "x", "y", "speed", "start", "acceleration", "position"],
    "joints": ["differential", "weights", "on", "prismatic", "line"],
    "friction": ["pin", "slide", "radius", "length", "coefficient", "static", "viscous"],
}
NASTY: list[Any] = [
    None, "", "frame", "crank", "P", "B", "transfer", "guide", "tilt", "bucket", -1, 0, 1, 1e300, "nan", "1/0", [], {},
    True, ["crank"], ["main", "crank", "cage"], ["frame", "crank", "crank"], [1, 1, -2], [1, "x", 0], [[0, 0], [0, 0]],
    [[0, 0], ["10 mm", 5]], {"centre": [0, 0], "radius": 100}, {"centre": "0 at 0", "radius": 0, "from": 1}, "10 deg",
    "10 mm", "B at 90 deg", "P at 1/0", "t", "10 mm*t/(1 s)", "sin(t)", "motor.angle", "60 rpm",
    "step5(t, 0 s, 0, 1 s, 1)",
]  # fmt: skip


def base(name: str) -> dict[str, Any]:
    data: dict[str, Any] = YAML(typ="safe").load((EXAMPLES / f"{name}.yaml").read_text(encoding="utf-8"))
    return {key: value for key, value in data.items() if key not in ("measures", "require", "studies")}


def changed(data: dict[str, Any], pick: random.Random) -> dict[str, Any]:
    """The same with one or two keys of such entries taken away, added or given another value."""
    made = copy.deepcopy(data)
    for _ in range(pick.choice([1, 1, 2])):
        section = pick.choice([key for key in SECTIONS if made.get(key)])
        entry = made[section][pick.choice(sorted(made[section]))]
        if entry and pick.random() < 0.3:
            entry.pop(pick.choice(sorted(entry)))
        if pick.random() < 0.8:
            entry[pick.choice(SECTIONS[section])] = copy.deepcopy(pick.choice(NASTY))
    return made


def compiled(data: dict[str, Any]) -> Compiled | None:
    """The mechanism; ``None`` where it is refused, and each problem can be said."""
    try:
        return compile_mechanism(parse_document(data))
    except ModelError as error:
        assert error.findings
        assert all(finding.what and finding.mend for finding in error.findings)
        return None


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("seeds", [range(60), pytest.param(range(60, 800), marks=pytest.mark.long)], ids=str)
def test_mutated_files_are_refused_or_run(name: str, seeds: range) -> None:
    data, outcomes = base(name), {"refused": 0, "run": 0}
    for seed in seeds:
        made = compiled(changed(data, random.Random(seed)))
        outcomes["run" if made else "refused"] += 1
        if made is not None:
            assert [str(text) for fact in facts(made) for text in fact.values()]
            efforts = [f"{drive}.{entry.effort}" for drive, entry in made.mechanism.drives.items()]
            if seed % 4 == 0:
                try:
                    made.evaluate(efforts, np.linspace(0.0, 0.3, 4))
                except ModelError as error:  # what can't be followed so far
                    assert error.findings
    assert min(outcomes.values()) > 0.02 * len(seeds), outcomes
