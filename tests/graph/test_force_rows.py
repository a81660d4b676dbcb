"""Rows of forces with their places: as the elements' own signals and the run have them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from helpers.examples import four_bar
from linkwright.graph.force_rows import AppliedForce, ReactionPlace, Weight

EXAMPLES = Path(__file__).parents[2] / "examples"


def cycle(example: str) -> Any:
    job = lw.run(EXAMPLES / f"{example}.yaml")
    assert job.cycle is not None
    return job.cycle.result


def test_labels() -> None:
    assert AppliedForce("loads", "push", 0, "at_x").label == "loads/push/0/at_x"
    assert Weight("crank", "y").label == "weight/crank/y"
    assert AppliedForce("loads", "push", 0, "moment").label == "loads/push/0/moment"
    assert ReactionPlace("rail", "frame", "x").label == "place/rail/frame/x"


def test_a_load_acts_at_its_point_and_a_weight_is_mass_times_gravity() -> None:
    result = cycle("loader")
    compiled = result.run.compiled
    rows = [AppliedForce("loads", "payload", 0, part) for part in ("x", "y", "at_x", "at_y")]
    values = compiled.evaluate([*rows, Weight("boom", "x"), Weight("boom", "y")], result.t)
    assert values[:2] == pytest.approx(np.outer([0, -15e3], np.ones(result.t.size)))
    assert values[2:4] == pytest.approx(np.array([result["tip.x"], result["tip.y"]]))
    assert values[4:] == pytest.approx(np.outer([0, -420 * 9.81], np.ones(result.t.size)))


def test_a_spring_pulls_both_its_ends_along_its_line() -> None:
    result = cycle("tailgate")
    graph = result.run.compiled.graph
    (lift,) = (one for one in graph.actions.every if one.name == "lift")
    assert graph.acted_on(lift) == ["frame", "lid"]
    rows = [AppliedForce("springs", "lift", i, part) for i in (0, 1) for part in ("x", "y", "at_x", "at_y")]
    fx, fy, x0, y0, gx, gy, x1, y1 = result.run.compiled.evaluate(rows, result.t)
    assert [gx, gy] == [pytest.approx(-fx), pytest.approx(-fy)]
    assert np.hypot(fx, fy) == pytest.approx(np.abs(result["lift.force"]))
    assert fx * (y1 - y0) - fy * (x1 - x0) == pytest.approx(0, abs=1e-9)
    assert [x1, y1] == [pytest.approx(result["E.x"]), pytest.approx(result["E.y"])]


def test_the_reaction_of_a_slide_is_stated_at_the_point_of_its_second_link() -> None:
    result = cycle("paper_feeder")
    rows = [ReactionPlace("rail", "frame", part) for part in "xy"]
    assert result.run.compiled.evaluate(rows, result.t) == pytest.approx(np.array([result["G.x"], result["G.y"]]))


def test_a_torsional_spring_acts_by_opposite_couples() -> None:
    """Its torque signal is positive where it turns its first link clockwise."""
    data = four_bar(springs={"hold": {"turns": "rocker", "on": "coupler", "stiffness": "3 N*m/rad", "free": "0.4 rad"}})
    job = lw.run(lw.Document.model_validate(data | {"studies": {"cycle": {"turns": "1 motor", "samples": 24}}}))
    assert job.cycle is not None
    result = job.cycle.result
    compiled = result.run.compiled
    graph = compiled.graph
    (hold,) = graph.actions.every
    assert graph.acted_on(hold) == ["rocker", "coupler"] and graph.acts_by_couples(hold)
    on, off = compiled.evaluate([AppliedForce("springs", "hold", i, "moment") for i in (0, 1)], result.t)
    between = result["rocker.angle"] - result["coupler.angle"]
    assert on == pytest.approx(-3 * (between - 0.4), abs=1e-9)
    assert off == pytest.approx(-on)


def test_a_force_is_no_couple() -> None:
    graph = cycle("loader").run.compiled.graph
    assert not any(graph.acts_by_couples(one) for one in graph.actions.every if one.name == "payload")
