"""Two mechanisms with closed forms, as documents: a slider-crank and a four-bar."""

from __future__ import annotations

import json
import re
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import linkwright as lw
from linkwright.app import examine_file
from linkwright.app.job import Job, examine_document, perform
from linkwright.expressions.language import parse
from linkwright.findings import Finding
from linkwright.measures import MeasureResult
from linkwright.studies.cycle.outcome import CycleOutcome

Array = NDArray[np.float64]
UNITS = {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"}
CRANK = {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": "0 deg"}
TURN = {"turns": "1 motor"}


def slider_crank(r: float = 50, l: float = 160, e: float = 20, **sections: Any) -> dict[str, Any]:  # noqa: E741
    """A crank of radius r, a rod l, a slide at the height e (mm); guide.s is the slider's x. One turn in 1 s."""
    return {
        "units": UNITS,
        "parameters": {"r": r, "l": l, "e": e},
        "links": {
            "frame": {"points": {"A": [0, 0], "F": [0, "e"]}},
            "crank": {"points": {"A": [0, 0], "B": ["r", 0]}, "mass": 1.5, "shape": "disc 60 mm at A"},
            "rod": {"points": {"B": [0, 0], "C": ["l", 0]}, "mass": 0.8, "shape": "rod B-C"},
            "slider": {"points": {"C": [0, 0]}, "mass": 1.2, "shape": "point C"},
        },
        "joints": {"guide": {"prismatic": ["frame", "slider"], "line": ["F at 0 deg", "C at 0 deg"]}},
        "assembly": {"C": "ahead of B along guide"},
        "drives": {"motor": CRANK},
        "studies": {"cycle": {**TURN, "samples": 60}},
        **sections,
    }


def four_bar(a: float = 40, b: float = 120, c: float = 80, d: float = 100, **sections: Any) -> dict[str, Any]:
    """Crank a, coupler b, rocker c on a ground d (mm), B to the left of A-O4. One turn in 1 s."""
    return {
        "units": UNITS,
        "gravity": [0, "-9.80665 m/s^2"],
        "parameters": {"a": a, "b": b, "c": c, "d": d},
        "links": {
            "frame": {"points": {"O2": [0, 0], "O4": ["d", 0]}},
            "crank": {"points": {"O2": [0, 0], "A": ["a", 0]}, "mass": 0.2, "shape": "rod O2-A"},
            "coupler": {"points": {"A": [0, 0], "B": ["b", 0], "P": [60, 30]}, "mass": 0.5, "shape": "rod A-B"},
            "rocker": {"points": {"O4": [0, 0], "B": ["c", 0]}, "mass": 0.3, "shape": "rod O4-B"},
        },
        "assembly": {"B": "left of A-O4"},
        "drives": {"motor": CRANK},
        "studies": {"cycle": {**TURN, "samples": 60}},
        **sections,
    }


def trammel(**sections: Any) -> dict[str, Any]:
    """A bar of 100 mm (A-B) between two rails at right angles; K, 20 mm from A, draws an ellipse. One turn in 1 s."""
    rails = (("x", "foot", "A", 0), ("y", "head", "B", 90))
    return {
        "units": UNITS,
        "links": {
            "frame": {"points": {"O": [0, 0]}},
            "foot": {"points": {"A": [0, 0]}},
            "head": {"points": {"B": [0, 0]}},
            "bar": {"points": {"A": [0, 0], "B": [100, 0], "K": [20, 0]}},
        },
        "joints": {
            rail: {"prismatic": ["frame", link], "line": [f"O at {angle} deg", f"{point} at {angle} deg"]}
            for rail, link, point, angle in rails
        },
        "assembly": {"A": [50, 0], "B": [0, 87]},
        "drives": {"motor": {"turns": "bar", "on": "foot", "speed": "60 rpm", "start": "120 deg"}},
        "studies": {"cycle": {**TURN, "samples": 60}},
        **sections,
    }


def slider_x(angle: Any, r: float = 50, l: float = 160, e: float = 20) -> Any:  # noqa: E741
    """The slider's x of :func:`slider_crank` at a crank angle (rad)."""
    return r * np.cos(angle) + np.sqrt(l**2 - (r * np.sin(angle) - e) ** 2)


def job_of(data: Mapping[str, Any]) -> Job:
    """A model file's data, examined and performed; findings stand in the job."""
    return perform(examine_document(lw.Document.model_validate(dict(data))))


def refused(data: Mapping[str, Any]) -> list[Finding]:
    """What is wrong with a model file that can't be used; its form, its names and its values alike."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "model.yaml"
        path.write_text(json.dumps({"linkwright": 1, **data}, indent=1), "utf-8")  # JSON is YAML too
        job = perform(examine_file(path))
    assert job.exit_code == 2
    assert job.cycle is None
    assert job.examined.findings
    assert all(finding.line and speakable(finding) for finding in job.examined.findings)
    return job.examined.findings


def cycle_of(data: Mapping[str, Any]) -> CycleOutcome:
    """The outcome of a cycle that can be run."""
    job = job_of(data)
    assert all(finding.severity == "note" for finding in job.examined.findings)
    assert job.cycle is not None
    return job.cycle


def measured(data: Mapping[str, Any], **measures: Any) -> dict[str, MeasureResult]:
    """The measures of a mechanism, by name."""
    outcome = cycle_of({**data, "measures": measures})
    assert not outcome.failures
    return {m.name: m for m in outcome.measures}


def value(data: Mapping[str, Any], label: str = "", **measure: Any) -> float:
    """One measure in its unit."""
    return measured(data, m=measure)["m"].shown(label)


def at(run: Any, text: str, t: Array) -> Array:
    """An expression of signals at any times (s) of a run, in SI."""
    node = run.compiled.quantities.dimensions.bind(parse(text), None)
    return np.asarray(run.jets(node, t).d[0])


def codes(findings: Any) -> list[str]:
    """The codes of some findings."""
    return [finding.code for finding in findings]


def speakable(finding: Finding) -> bool:
    """Whether a finding's sentences are there, and no number in them is a NaN."""
    text = f"{finding.what} {finding.mend}"
    return not re.search(r"\bnan\b", text) and len(finding.what) > 10 and len(finding.mend) > 5
