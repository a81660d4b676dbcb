"""Accuracy of a linkage on a cam: the profile is cut, deviations act through the contact, also in random samples."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import linkwright as lw
from helpers.cams import pair
from linkwright.kernels import examine
from linkwright.model.document import parse_document
from linkwright.studies.registry import read_studies

STEP = 2e-5


def document(**accuracy: Any) -> lw.Document:
    data = pair("swinging", "roller")
    data["parameters"] = {
        "rr": {"value": 0.012, "tolerance": STEP},
        "arm": {"value": 0.085, "tolerance": STEP},
        "ph": {"value": 0.4, "tolerance": 1e-4},
    }
    data["links"]["arm"]["points"]["B"] = ["arm", 0.03]
    data["cams"]["rider"] |= {"roller": "rr", "phase": "ph"}
    data["measures"] = {
        "tip": {"value": "T.x", "where": "start"},
        "force": {"value": "rider.force", "where": "start"},
    }
    data["studies"] = {"cycle": {"period": 2 * np.pi / 7, "samples": 60}, "accuracy": accuracy}
    found = parse_document(data)
    assert found is not None
    return found


def test_lines_vertices_and_samples_agree() -> None:
    """All ways of the study see the same cut cam: linear, at the vertices, by random samples."""
    outcome = lw.accuracy(document(samples=500, seed=1))
    assert not outcome.failures
    for name in ("tip", "force"):
        figure = outcome.figures[name]
        random = figure.monte_carlo
        assert random is not None
        assert random.sigma == pytest.approx(figure.sigma, rel=0.1)
        assert abs(random.mean - figure.nominal) < 0.2 * figure.sigma
        assert figure.searched is not None
        assert figure.searched.low == pytest.approx(figure.worst[0], rel=0.01)
        # The roller's radius alone: along the common normal, not by another cam.
        assert (np.abs(figure.coefficients[0]) > 0).all()


def test_a_clearance_at_the_joints_of_a_cam_is_refused() -> None:
    made = document(clearances={"A": 1e-5, "shaft": 1e-5})
    compiled, _ = examine(made)
    assert compiled is not None
    tasks, findings = read_studies(made.studies)
    assert not findings
    task = next(task for task in tasks if task.study.name == "accuracy")
    found = task.study.check(compiled, task.options)
    assert [(f.code, f.path[-1], f.data["cam"]) for f in found] == [
        ("clearance.cam", n, "rider") for n in ("A", "shaft")
    ]
