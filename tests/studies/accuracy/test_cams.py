"""Accuracy of a linkage on a cam: the profile is cut, deviations act through the contact, also in random samples."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

import linkwright as lw
from helpers.cams import GUIDES, pair
from helpers.compiled import compiled_from
from helpers.differences import derivative
from helpers.examples import four_bar
from linkwright.cam.cams_of_mechanism import disc, frame
from linkwright.compilation import examine
from linkwright.kernels.manufactured_cam import with_cut_cams
from linkwright.model.document import parse_document
from linkwright.results import Run
from linkwright.studies.accuracy.clearance import Plays
from linkwright.studies.registry import read_studies
from studies.accuracy.test_clearance import massless, options, tree

STEP = 2e-5


def document(cam: dict[str, Any] | None = None, **accuracy: Any) -> lw.Document:
    data = pair("swinging", "roller", **(cam or {}))
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


PLAY = {
    "swinging": {"shaft": 1e-4, "A": 1e-4},
    "sliding": {"shaft": 1e-4, "guide": {"clearance": 1e-4, "length": 0.05}},
}


def found_of(data: dict[str, Any], clearances: dict[str, Any]) -> tuple[Plays, Any]:
    """Clearances of a linkage on a cam that is cut, and an output of it."""
    compiled = with_cut_cams(compiled_from(data))
    found = Plays(compiled, Run(compiled, 0.0, 2 * np.pi / 7, 60), options(clearances))
    return found, tree(compiled, "0.6*T.x + 0.8*T.y")


@pytest.mark.parametrize("touch", ["roller", "face"])
@pytest.mark.parametrize("guide", GUIDES)
def test_an_output_moves_with_a_gap_as_the_joint_is_loaded_by_it(guide: str, touch: str) -> None:
    """Virtual work: a unit load at the output makes forces in shaft, pivot, slide and the roller's pin, through the
    contact's normal. They are the derivatives by the gaps, which come from the cut profile."""
    for side, sense, inverted in ((1, 1, False), (-1, 1, True), (1, -1, True)):
        load = {"on": "arm", "at": "T", "force": ["0.6 N", "0.8 N"]}
        data = massless(pair(guide, touch, side, sense, inverted), loads={"unit": load})
        if guide == "sliding" and sense > 0:
            data["joints"]["guide"] = {"prismatic": ["frame", "arm"], "line": ["S at 2.0", "A at 0.7"]}
        loaded(data, PLAY[guide] | ({"B": 1e-4} if touch == "roller" else {}))


def loaded(data: dict[str, Any], clearances: dict[str, Any]) -> None:
    """A unit load at T makes the forces by whose joints' gaps T moves in the direction of the load."""
    found, output = found_of(data, clearances)
    t = found.run.t
    slope = found.gaps.at([output], t).slope[0]
    rows = {row: jet.d[0] for row, jet in found.gaps.needed_rows(t).items()}
    forces = np.array([part for one in found.held for seat in one.forces(rows) for part in seat])
    assert np.abs(forces).max(axis=1).min() > 1e-3
    np.testing.assert_allclose(slope, forces, atol=1e-13 * np.abs(forces).max())
    # So it gives way in the direction of the load, by all that the joints allow.
    shift, bound = found.curve(output, t)
    np.testing.assert_allclose(shift, bound, rtol=1e-11)


def test_gaps_where_the_coupler_carries_cam_and_follower() -> None:
    data = four_bar(0.6, 1.1, 0.8, 1.0)
    data["assembly"] = {"B": "left of A-D"}
    data["links"]["coupler"]["points"]["E"] = [0.2, 0.15]
    data["links"]["arm"] = {"points": {"E": [0, 0], "F": [0.6, 0], "T": [0.7, 0.2]}}
    data["laws"] = pair("swinging", "roller")["laws"]
    cam = {"cam": "rocker", "follower": "arm", "on": "coupler", "base": 0.4, "roller": 0.08, "at": "F"}
    data["cams"] = {"rider": cam | {"law": "lift", "side": "left of C-E"}}
    data["drives"] = {"motor": {"turns": "rocker", "on": "coupler", "position": "1.05 + 0.35*sin(7 rad*t/(1 s))"}}
    data["loads"] = {"unit": {"on": "arm", "at": "T", "force": [0.6, 0.8]}}
    loaded(data, dict.fromkeys("ABCDEF", 1e-3))


def test_the_rates_of_gaps_are_those_of_their_values() -> None:
    """As displacements are held in the frame while the cam turns; at times away from the joins of the law."""
    found, output = found_of(pair("swinging", "roller"), PLAY["swinging"] | {"B": 1e-4})
    t = np.array([0.05, 0.11, 0.45, 0.6])
    numeric = derivative(lambda x: found.gaps.at([output], x, rates=False).slope[0], t, 1e-4)
    exact = found.gaps.at([output], t).twist[0]
    assert np.abs(exact).max() > 0.1
    np.testing.assert_allclose(exact, numeric, atol=1e-7 * np.abs(exact).max())


def test_a_shaft_off_its_place_moves_the_follower_to_where_the_roller_touches() -> None:
    """The profile as 200 000 points turned about the displaced shaft, the arm turned until the roller touches it."""
    data = pair("swinging", "roller")
    found, _ = found_of(data, {"shaft": 1e-4})
    c, t = found.compiled, np.array([0.12, 0.5, 0.7])
    made, axes = disc(c, "rider"), frame(c, "rider")
    profile = axes.placed(made.look(np.linspace(0, 2 * np.pi, 200_001)).offset(-0.012))
    exact = found.gaps.at([tree(c, "arm.angle")], t).slope[0]
    for k, time in enumerate(t):
        turned, near = c.evaluate(["disc.angle", "arm.angle"], np.array([time]))[:, 0]
        spots = (profile[0] + 1j * profile[1] - (0.004 + 0.003j)) * np.exp(1j * turned) + (0.01 - 0.02j)

        def touching(off: complex, spots: Any = spots, near: float = near) -> float:
            """The arm's angle at which the roller's centre is a radius off the profile."""

            def gap(angle: float) -> float:
                centre = 0.09 + 0.01j + (0.08 + 0.028j) * np.exp(1j * angle)
                return float(np.abs(spots + off - centre).min()) - 0.012

            return float(brentq(gap, near - 0.02, near + 0.02, xtol=1e-15))

        for row, way in enumerate((1e-5, 1e-5j)):
            numeric = (touching(way) - touching(-way)) / 2e-5
            assert exact[row, k] == pytest.approx(numeric, rel=1e-4, abs=1e-4)


def test_the_study_takes_clearances_of_a_cam() -> None:
    outcome = lw.accuracy(document(samples=0, clearances={"A": 1e-5, "shaft": 1e-5, "B": 1e-5}))
    assert not outcome.failures
    play = outcome.figures["tip"].play
    assert play is not None
    assert min(play.bounds[name] for name in ("A", "shaft", "B")) > 1e-6
    assert [joint.links for joint in outcome.joints] == [("frame", "arm"), ("frame", "disc"), ("arm", "rider")]


def refused(made: lw.Document) -> list[tuple[str, Any]]:
    compiled, _ = examine(made)
    assert compiled is not None
    tasks, findings = read_studies(made.studies)
    assert not findings
    task = next(task for task in tasks if task.study.name == "accuracy")
    return [(f.code, f.path[-1]) for f in task.study.check(compiled, task.options)]


def test_clearances_that_a_cam_cannot_have() -> None:
    """A follower that touches on two sides isn't followed; a roller's pin floats, with less play than the radius."""
    assert refused(document(clearances={"B": {"clearance": 0.02, "in": "arm"}})) == [
        ("clearance.no-key", "in"),
        ("clearance.roller", "B"),
    ]
    held = dict.fromkeys(("A", "shaft", "B"), 1e-5)
    found = refused(document({"closed": "conjugate"}, clearances=held))
    assert found == [("clearance.cam", name) for name in held]
