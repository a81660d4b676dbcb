"""Reactions of structures against statics by hand, and against the method of joints for random trusses."""

from __future__ import annotations

import csv
import io
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import linkwright as lw
from helpers.shown import blocks, rows
from linkwright.app.job import Job
from linkwright.presentation.blocks import Table
from linkwright.studies.reactions.outcome import ReactionsOutcome
from linkwright.studies.reactions.report import reactions_csv, report
from studies.models import UNITS, codes, four_bar, job_of, speakable

EXAMPLE = Path(__file__).parents[3] / "examples" / "bracket.yaml"


def structure(links: Any, loads: Any, joints: Any = None, **sections: Any) -> dict[str, Any]:
    sections = {"studies": {"reactions": {}}, **sections}
    return {"units": UNITS, "links": links, "joints": joints or {}, "loads": loads, **sections}


def solved(data: Any) -> ReactionsOutcome:
    job = job_of(data)
    assert job.exit_code == 0, [str(f) for f in [*job.examined.findings, *job.found]]
    outcome = job.outcomes["reactions"]
    assert isinstance(outcome, ReactionsOutcome)
    assert max(outcome.closure, outcome.equilibrium) < 1e-12
    assert all(speakable(finding) for finding in outcome.warnings)
    return outcome


def values(outcome: ReactionsOutcome) -> dict[str, float | None]:
    return {reaction.name: reaction.value for reaction in outcome.reactions if reaction.direction is None}


def refused(data: Any) -> list[str]:
    job: Job = job_of(data)
    assert job.exit_code != 0
    findings = [*job.examined.findings, *job.found]
    assert all(speakable(finding) for finding in findings)
    return codes(findings)


def beam(**sections: Any) -> dict[str, Any]:
    """A beam of 1 m on a pin and a roller, 300 N down at 0.4 m and 50 N to the right."""
    links = {
        "frame": {"points": {"A": [0, 0], "F": [0, 0]}},
        "beam": {"points": {"A": [0, 0], "B": [1000, 0], "P": [400, 0]}},
        "roller": {"points": {"B": [0, 0]}},
    }
    joints = {"rail": {"prismatic": ["frame", "roller"], "line": ["F at 0 deg", "B at 0 deg"]}}
    loads = {"push": {"on": "beam", "at": "P", "force": [50, -300]}}
    return structure(links, loads, joints, assembly={"B": "ahead of A along rail"}, **sections)


def test_a_simply_supported_beam() -> None:
    outcome = solved(beam())
    assert outcome.states == 0
    found = values(outcome)
    assert found["force(frame, beam).x"] == pytest.approx(-50)
    assert found["force(frame, beam).y"] == pytest.approx(180)
    assert found["force(frame, roller).normal"] == pytest.approx(120)
    assert found["force(frame, roller).moment"] == pytest.approx(0, abs=1e-12)
    assert found["force(beam, roller).y"] == pytest.approx(-120)


@pytest.mark.parametrize("angle", [0.0, 30.0, 90.0, -60.0])
def test_a_beam_on_two_pins_is_indeterminate_along_itself(angle: float) -> None:
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    links = {
        "frame": {"points": {"A": [0, 0], "B": [1000 * c, 1000 * s]}},
        "beam": {"points": {"A": [0, 0], "B": [1000, 0]}, "mass": 20, "shape": "rod A-B"},
    }
    outcome = solved(structure(links, {}, gravity=[0, "-10 m/s^2"]))
    assert outcome.states == 1
    assert codes(outcome.warnings) == ["reactions.indeterminate"]
    across = 100 * c  # half the weight's part across the beam, at each pin
    normal = (-s, c)
    for joint in ("A", "B"):
        parts = [r for r in outcome.reactions if r.joint == joint]
        known = [r for r in parts if r.value is not None]
        if len(known) == 1 and known[0].direction is None:  # the beam lies along an axis
            axis = normal[0] if known[0].name.endswith(".x") else normal[1]
            assert known[0].value == pytest.approx(across * axis, abs=1e-9)
        else:
            (only,) = known
            assert only.direction is not None
            turned = math.cos(only.direction) * normal[0] + math.sin(only.direction) * normal[1]
            assert abs(turned) == pytest.approx(1)
            assert only.value == pytest.approx(across * turned)
    assert "indeterminate" in [cell for table in blocks(report(outcome), Table) for row in rows(table) for cell in row]
    lines = list(csv.reader(io.StringIO(reactions_csv(outcome))))
    assert any(line[2] == "" for line in lines[1:])


def truss(load: Any) -> dict[str, Any]:
    """A triangle of side 1 m on a pin A and a roller B, its apex C above."""
    links = {
        "frame": {"points": {"A": [0, 0], "F": [0, 0]}},
        **{name: {"points": dict.fromkeys(name.upper(), "sketch")} for name in ("ab", "ac", "bc")},
        "roller": {"points": {"B": [0, 0]}},
    }
    links["frame"]["points"]["A"] = "sketch"
    joints = {"rail": {"prismatic": ["frame", "roller"], "line": ["F at 0 deg", "B at 0 deg"]}}
    sketch = {"A": [0, 0], "B": [1000, 0], "C": [500, 500 * math.sqrt(3)]}
    return structure(links, {"load": load}, joints, sketch=sketch)


def test_a_triangle_truss() -> None:
    """P down at the apex: 1/(2 sin 60 deg) of it in compression in the rafters, 1/(2 tan 60 deg) in the tie."""
    outcome = solved(truss({"on": "ac", "at": "C", "force": [0, -1000]}))
    bars = {bar.link: bar.force for bar in outcome.bars}
    assert bars == pytest.approx({"ab": 500 / math.tan(math.pi / 3), "bc": -500 / math.sin(math.pi / 3)})
    found = values(outcome)
    assert found["force(frame, roller).normal"] == pytest.approx(500)
    assert found["force(frame, A).y"] == pytest.approx(500)
    assert found["force(frame, A).x"] == pytest.approx(0, abs=1e-9)


@settings(max_examples=25, deadline=None)
@given(st.integers(2, 6), st.randoms(use_true_random=False), st.booleans())
def test_random_trusses_by_the_method_of_joints(count: int, random: Any, more: bool) -> None:
    """Each joint on two bars from joints before it, and one bar too many or not; equilibrium of the joints alone."""
    places = {"A": np.array([0.0, 0.0]), "B": np.array([1.0, 0.0])}
    ends: list[tuple[str, str]] = []
    for i in range(count):
        a, b = random.sample(list(places), 2)
        place = np.array([random.uniform(-1, 2), random.uniform(0.2, 2)])
        arms = [place - places[a], place - places[b]]
        lengths = [np.hypot(*arm) for arm in arms]
        assume(
            min(lengths) > 0.2
            and abs(arms[0][0] * arms[1][1] - arms[0][1] * arms[1][0]) > 0.2 * lengths[0] * lengths[1]
        )
        places[f"C{i}"] = place
        ends += [(a, f"C{i}"), (b, f"C{i}")]
    if more:
        others = [(a, b) for a in places for b in list(places)[2:] if a < b and (a, b) not in ends]
        assume(others)
        ends.append(random.choice(others))
        assume(np.hypot(*(places[ends[-1][0]] - places[ends[-1][1]])) > 0.2)
    free = list(places)[2:]
    force = np.array([30.0, -70.0])
    matrix, right = np.zeros((2 * len(free), len(ends))), np.zeros(2 * len(free))
    for column, pair in enumerate(ends):
        for end, other in (pair, pair[::-1]):
            if end in free:
                axis = places[other] - places[end]
                matrix[2 * free.index(end) : 2 * free.index(end) + 2, column] = axis / np.hypot(*axis)
    right[-2:] = -force
    spare = len(ends) - np.linalg.matrix_rank(matrix)
    assert spare == more
    tensions = np.linalg.lstsq(matrix, right, rcond=None)[0]
    _, _, v = np.linalg.svd(matrix)
    open_ = np.abs(v[len(ends) - spare :]).max(axis=0, initial=0.0) > 1e-8
    links: dict[str, Any] = {"frame": {"points": {"A": "sketch", "B": "sketch"}}}
    links |= {f"bar{i}": {"points": dict.fromkeys(pair, "sketch")} for i, pair in enumerate(ends)}
    loaded = next(i for i, pair in enumerate(ends) if free[-1] in pair)
    loads = {"load": {"on": f"bar{loaded}", "at": free[-1], "force": force.tolist()}}
    sketch = {name: (1000 * place).tolist() for name, place in places.items()}
    outcome = solved(structure(links, loads, sketch=sketch))
    assert outcome.states == spare
    for bar in outcome.bars:
        i = int(bar.link.removeprefix("bar"))
        assert (bar.force is None) == open_[i]
        if bar.force is not None:
            assert bar.force == pytest.approx(tensions[i], rel=1e-8, abs=1e-8 * np.abs(tensions).max())
    assert len(outcome.bars) == len(ends) - 1


def test_springs_and_gravity_act_too() -> None:
    """A spring of 200 N (300 mm, relaxed at 200 mm, 2 N/mm) holds the boom's end up."""
    data = lw.load(EXAMPLE).model_dump(exclude_defaults=True, by_alias=True)
    data["links"]["frame"]["points"]["S"] = [900, 300]
    data["springs"] = {"lift": {"from": "S", "to": "E", "stiffness": "2 N/mm", "free": 200}}
    found = values(solved(data))
    vertical = (500 * 900 + 8 * 9.80665 * 450 - 200 * 900) / 600
    assert found["force(frame, tie).y"] == pytest.approx(vertical)
    assert found["force(frame, tie).x"] == pytest.approx(-vertical * 600 / 450)


def test_loads_that_vary_are_taken_at_a_time() -> None:
    sections = {
        "studies": {"reactions": {"at": "2 s"}},
        "tables": {"f": {"points": [[0, 0], [4, 400]], "between": "linear"}},
    }
    data = beam(**sections)
    data["loads"] = {"push": {"on": "beam", "at": "P", "force": ["0 N", "-1 N*f(t/(1 s))"]}}
    assert values(solved(data))["force(frame, roller).normal"] == pytest.approx(0.4 * 200)
    data["studies"] = {"reactions": {"at": "9 s"}}
    assert refused(data) == ["reactions.not-finite"]
    data["studies"] = {"reactions": {"at": "-1 s"}}
    assert refused(data) == ["reactions.time"]
    data["studies"] = {"reactions": {"at": "3 mm"}}
    assert len(refused(data)) == 1


def three_cranks(force: Any) -> dict[str, Any]:
    """A platform on three equal upright legs: as many constraints as freedoms, and it moves all the same."""
    points = {"A": [0, 0], "B": [500, 0], "C": [900, 0]}
    tops = {f"{name}2": [x, 400] for name, (x, _) in points.items()}
    links: dict[str, Any] = {"frame": {"points": dict.fromkeys(points, "sketch")}}
    links |= {f"leg{name}": {"points": dict.fromkeys((name, f"{name}2"), "sketch")} for name in points}
    links["plate"] = {"points": dict.fromkeys(tops, "sketch")}
    return structure(links, {"load": {"on": "plate", "at": "A2", "force": force}}, sketch=points | tops)


def test_a_structure_that_would_move_is_refused_by_its_links() -> None:
    job = job_of(three_cranks([10, -100]))
    assert job.exit_code == 1
    (finding,) = job.found
    assert finding.code == "reactions.moves"
    assert set(str(finding.data["links"]).split(", ")) == {"legA", "legB", "legC", "plate"}


def test_a_structure_that_stands_by_chance_says_so() -> None:
    outcome = solved(three_cranks([0, -100]))
    assert "reactions.neutral" in codes(outcome.warnings)
    bars = {bar.link: bar.force for bar in outcome.bars}
    assert bars == pytest.approx({"legA": -100, "legB": 0, "legC": 0}, abs=1e-9) or None in bars.values()


def test_what_can_not_be_done_is_refused() -> None:
    loose = beam()
    del loose["links"]["roller"], loose["joints"]["rail"], loose["assembly"]
    assert refused(loose) == ["structure.loose"]
    driven = four_bar(studies={"reactions": {}})
    assert refused(driven) == ["reactions.drives"]
    assert refused(beam(studies={"reactions": {}, "cycle": {"duration": "1 s"}})) == ["study.alone"]
    assert refused(beam(studies={"reactions": {}}, exports={"mjcf": {}})) == ["study.alone"]
    long = structure(
        {
            "frame": {"points": {"A": [0, 0], "B": [1000, 0]}},
            "beam": {"points": {"A": [0, 0], "B": [1010, 0]}},
        },
        {"load": {"on": "beam", "at": [500, 0], "force": [0, -1]}},
    )
    assert refused(long) == ["reactions.not-closed"]


def test_a_file_without_freedom_names_the_study() -> None:
    data = beam(studies={"cycle": {"duration": "1 s"}})
    assert refused(data) == ["model.no-freedom"]


def test_no_loads_and_measures_are_told() -> None:
    data = beam(measures={"m": {"max": "P.x"}})
    del data["loads"]
    outcome = solved(data)
    assert codes(outcome.warnings) == ["reactions.no-load", "reactions.measures"]


def test_two_ways_to_put_it_together_need_a_sketch() -> None:
    """Three bars from the frame to one joint: no dyads, and mirrored below without a sketch."""
    points = {"A": [0, 0], "B": [600, 0], "C": [1000, 0]}
    top = [500, 400]
    lengths = {name: math.dist(place, top) for name, place in points.items()}
    links: dict[str, Any] = {"frame": {"points": points}}
    links |= {f"bar{name}": {"points": {name: [0, 0], "D": [length, 0]}} for name, length in lengths.items()}
    loads = {"load": {"on": "barA", "at": "D", "force": [0, -100]}}
    assert refused(structure(links, loads)) == ["reactions.several-poses"]
    for assembly in ({"D": [480, 380]}, {"D": "left of A-B"}):
        outcome = solved(structure(links, loads, assembly=assembly))
        assert outcome.states == 1
        assert outcome.compiled.evaluate(["D.y"], np.zeros(1))[0, 0] == pytest.approx(0.4)


def test_written(tmp_path: Path) -> None:
    job = lw.run(EXAMPLE, tmp_path)
    vertical = (500 * 900 + 8 * 9.80665 * 450) / 600
    entry = job.summary["reactions"]
    assert entry["degree"] == 0
    assert entry["bars"]["tie"]["value"] == pytest.approx(vertical / 0.6)
    assert "reactions" in (tmp_path / "report.html").read_text(encoding="utf-8")
    rows = list(csv.DictReader((tmp_path / "reactions.csv").open(encoding="utf-8")))
    found = {row["reaction"]: float(row["value"]) for row in rows}
    assert found["force(frame, boom).y"] == pytest.approx(500 + 8 * 9.80665 - vertical)
    assert found["tension of tie"] == pytest.approx(vertical / 0.6)


@pytest.mark.parametrize("free", [0, 30, 350, -700])
def test_angles_that_act_on_a_structure(free: float) -> None:
    """A torsional spring, over whole turns from its free angle, and a load that follows a link's angle: a boom on a tie
    by the moments about its pin."""
    long, tied, high = 100.0, 128.0, 80.0
    data = {
        "linkwright": 1,
        "units": {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"},
        "links": {
            "frame": {"points": {"A": [0, 0], "S": [0, high]}},
            "boom": {"points": {"A": [0, 0], "B": [long, 0]}},
            "tie": {"points": {"S": [0, 0], "B": [tied, 0]}},
        },
        "assembly": {"B": [100, 5]},
        "springs": {"twist": {"turns": "boom", "on": "frame", "stiffness": "2 N*m/rad", "free": f"{free} deg"}},
        "loads": {"weight": {"on": "boom", "at": "B", "force": ["0 N", "-3 N*cos(boom.angle)"]}},
        "studies": {"reactions": {}},
    }
    outcome = lw.run(lw.Document.model_validate(data)).outcomes["reactions"]
    (force,) = (bar.force for bar in outcome.bars if bar.link == "tie")
    y = (long**2 - tied**2 + high**2) / (2 * high)
    x = math.sqrt(long**2 - y**2)
    angle = math.atan2(y, x)
    twisted = math.remainder(angle - math.radians(free), 2 * math.pi)
    moment = -2.0 * twisted - 3.0 * math.cos(angle) * x / 1000
    arm = (x * (high - y) + y * x) / tied / 1000
    assert force == pytest.approx(-moment / arm, rel=1e-12)
