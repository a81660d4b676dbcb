"""Motions that can't be followed: intervals to round-off, what is missing, and singular poses."""

from __future__ import annotations

import json
import math
import re
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import linkwright as lw
from graph.test_higher_groups import triad
from linkwright.app import write
from linkwright.app.job import summary_text
from linkwright.model.document import Document
from studies.models import CRANK, codes, cycle_of, four_bar, job_of, slider_crank, speakable


def limit(a: float, d: float, reach: float) -> float:
    """The crank angle (rad, 0..pi) at which A is ``reach`` away from O4."""
    return math.acos((a**2 + d**2 - reach**2) / (2 * a * d))


def numbers(text: str) -> list[float]:
    return [float(n) for n in re.findall(r"-?\d+(?:\.\d+)?", text)]


@settings(max_examples=12)
@given(st.floats(55, 90), st.floats(45, 90), st.floats(45, 90), st.sampled_from([1, -1]), st.integers(2, 400))
def test_limits_of_a_four_bar_that_can_not_turn_over(a: float, b: float, c: float, sign: int, samples: int) -> None:
    """Too short to span the far side: from acos((a^2 + d^2 - (b + c)^2)/(2 a d)) to its mirror image."""
    d = 100.0
    b, c = sorted((b, c), reverse=True)
    if b + c > a + d - 1 or b - c > d - a - 1 or b + c < d - a + 1:
        return
    drives = {"motor": {**CRANK, "speed": f"{60 * sign} rpm"}}
    data = four_bar(a, b, c, d, drives=drives, studies={"cycle": {"turns": "1 motor", "samples": samples}})
    job = job_of(data)
    assert job.exit_code == 1
    (failure,) = job.cycle.failures
    assert (failure.code, failure.path[0]) == ("motion.cannot-assemble", "links")
    angle = limit(a, d, b + c)
    assert failure.data["start"] == pytest.approx(angle / (2 * math.pi), abs=1e-9)
    assert failure.data["stop"] == pytest.approx(1 - angle / (2 * math.pi), abs=1e-9)
    assert float(failure.data["from"]) == pytest.approx(sign * math.degrees(angle), rel=1e-5)
    assert float(failure.data["to"]) == pytest.approx(sign * (360 - math.degrees(angle)), rel=1e-5)
    assert float(failure.data["by"]) == pytest.approx(a + d - b - c, rel=1e-3)
    assert (failure.data["drive"], failure.data["unit"], failure.data["length_unit"]) == ("motor", "deg", "mm")
    assert failure.data["short"].key == "term.gap-wide"


def test_the_sentence_says_where_how_much_and_what_to_do() -> None:
    (failure,) = cycle_of(four_bar(60, 70, 50, 100)).failures
    assert speakable(failure)
    assert {"coupler", "rocker"} <= set(re.findall(r"\w+", failure.what))
    found = numbers(failure.what)
    assert any(n == pytest.approx(93.8226, abs=1e-3) for n in found)
    assert any(n == pytest.approx(266.177, abs=1e-3) for n in found)
    assert 40.0 in found
    assert "deg" in failure.what
    assert "mm" in failure.what


def test_too_near_instead_of_too_far() -> None:
    """The crank brings A nearer to O4 than the difference of coupler and rocker."""
    drives = {"motor": {**CRANK, "start": "90 deg"}}
    (failure,) = cycle_of(four_bar(60, 130, 70, 100, drives=drives)).failures
    angle = limit(60, 100, 60)
    assert failure.data["start"] == pytest.approx(0.75 - angle / 2 / math.pi, abs=1e-9)
    assert failure.data["stop"] == pytest.approx(0.75 + angle / 2 / math.pi, abs=1e-9)
    assert float(failure.data["by"]) == pytest.approx(20.0)
    assert failure.data["short"].key == "term.gap-narrow"


def test_a_drive_that_turns_back_in_a_gap_is_told_how_far_it_went() -> None:
    """From the gap's edge to the worst of it, not from the edge to the edge."""
    drives = {"motor": {"turns": "crank", "on": "frame", "position": "60 deg*sin(360 deg*t/(1 s))"}}
    studies = {"cycle": {"duration": "0.5 s"}}
    (failure,) = cycle_of(four_bar(60, 30, 50, 100, drives=drives, studies=studies)).failures
    assert failure.code == "motion.cannot-assemble"
    edge = limit(60, 100, 80)
    assert float(failure.data["from"]) == pytest.approx(math.degrees(edge), rel=1e-5)
    assert float(failure.data["to"]) == pytest.approx(60, abs=1e-9)


def test_two_gaps_in_one_turn() -> None:
    """Too far on the far side and too near on the near side."""
    drives = {"motor": {**CRANK, "start": "60 deg"}}
    outcome = cycle_of(four_bar(80, 100, 40, 100, drives=drives))
    far, near = sorted(outcome.failures, key=lambda f: f.data["start"])
    assert far.data["start"] == pytest.approx(math.degrees(limit(80, 100, 140)) / 360 - 1 / 6, abs=1e-9)
    assert near.data["start"] == pytest.approx(1 - math.degrees(limit(80, 100, 60)) / 360 - 1 / 6, abs=1e-9)
    assert near.data["stop"] == pytest.approx(1 + math.degrees(limit(80, 100, 60)) / 360 - 1 / 6, abs=1e-9)


def test_each_turn_has_its_gap() -> None:
    outcome = cycle_of(four_bar(60, 70, 50, 100, studies={"cycle": {"turns": "3 motor", "samples": 90}}))
    starts = [f.data["start"] for f in outcome.failures]
    assert starts == pytest.approx([k + limit(60, 100, 120) / 2 / math.pi for k in range(3)], abs=1e-9)


def test_a_gap_narrower_than_the_samples_is_found() -> None:
    """3 thousandths of a degree, between two samples of a coarse run."""
    b_plus_c = 160 - 1e-8
    for samples in (7, 61):
        data = four_bar(60, 90, b_plus_c - 90, 100, studies={"cycle": {"turns": "1 motor", "samples": samples}})
        (failure,) = cycle_of(data).failures
        assert failure.code == "motion.cannot-assemble"
        assert failure.data["start"] == pytest.approx(limit(60, 100, b_plus_c) / 2 / math.pi, abs=1e-8)
        assert 0 < failure.data["stop"] - failure.data["start"] < 1e-4


@pytest.mark.parametrize(("r", "l", "e"), [(50.0, 40.0, 0.0), (50.0, 60.0, 20.0)])
def test_limits_of_a_slider_crank(r: float, l: float, e: float) -> None:  # noqa: E741
    """The rod spans a height of l at most: sin(angle) in (e - l)/r .. (e + l)/r."""
    outcome = cycle_of(slider_crank(r, l, e))
    angles = []
    if e + l < r:
        top = math.asin((e + l) / r)
        angles.append((top, math.pi - top))
    if l - e < r:
        low = math.asin((l - e) / r)
        angles.append((math.pi + low, 2 * math.pi - low))
    assert len(outcome.failures) == len(angles)
    for failure, (start, stop) in zip(sorted(outcome.failures, key=lambda f: f.data["start"]), angles, strict=True):
        assert failure.data["start"] == pytest.approx(start / 2 / math.pi, abs=1e-9)
        assert failure.data["stop"] == pytest.approx(stop / 2 / math.pi, abs=1e-9)
        assert float(failure.data["by"]) == pytest.approx(r + (e if math.sin(start) < 0 else -e) - l, rel=1e-3)


def test_limits_of_sliding_links() -> None:
    """A rod through a block that is hinged at Q, 30 mm beside its line: the hinge must stay 30 mm away from B."""
    data = slider_crank()
    data["links"] = {
        "frame": {"points": {"A": [0, 0], "Q": [70, 0]}},
        "crank": {"points": {"A": [0, 0], "B": [50, 0]}},
        "rod": {"points": {"B": [0, 0]}},
        "block": {"points": {"Q": [0, 30]}},
    }
    data["joints"] = {"sleeve": {"prismatic": ["rod", "block"], "line": ["B at 0 deg", "Q at 0 deg"]}}
    data["links"]["rod"]["points"]["K"] = [0, 30]
    data["joints"]["sleeve"]["line"] = ["K at 0 deg", "Q at 0 deg"]
    data["assembly"] = {"Q": "ahead of B along sleeve"}
    data["drives"] = {"motor": {**CRANK, "start": "90 deg"}}
    (failure,) = cycle_of(data).failures
    angle = limit(50, 70, 30)
    assert failure.code == "motion.cannot-assemble"
    assert failure.data["start"] == pytest.approx(0.75 - angle / 2 / math.pi, abs=1e-9)
    assert failure.data["stop"] == pytest.approx(0.75 + angle / 2 / math.pi, abs=1e-9)
    assert float(failure.data["by"]) == pytest.approx(10.0)


def second_loop(rod: float) -> dict[str, Any]:
    """A four-bar that can't turn over, whose rocker moves a slide by a rod."""
    data = four_bar(60, 70, 50, 100)
    data["links"]["frame"]["points"]["F"] = [0, 60]
    data["links"]["rod"] = {"points": {"B": [0, 0], "E": [rod, 0]}}
    data["links"]["slider"] = {"points": {"E": [0, 0]}}
    data["joints"] = {"rail": {"prismatic": ["frame", "slider"], "line": ["F at 0 deg", "E at 0 deg"]}}
    data["assembly"] = {"B": "left of A-O4", "E": "ahead of B along rail"}
    return data


def test_a_gap_behind_a_gap() -> None:
    """A second group that fails next to where the first one does: both limits to round-off, no place twice."""
    a, b, c, d, height, rod = 60.0, 70.0, 50.0, 100.0, 60.0, 20.0
    data = second_loop(rod)
    data["drives"] = {"motor": {**CRANK, "start": "60 deg"}}
    outcome = cycle_of(data)
    angle = np.radians(np.linspace(60, 420, 3_600_001))
    pin = a * np.exp(1j * angle)
    reach = np.abs(d - pin)
    along = (b**2 - c**2 + reach**2) / (2 * reach)
    with np.errstate(invalid="ignore"):
        y = (pin + (d - pin) / reach * (along + 1j * np.sqrt(b**2 - along**2))).imag
        first, second = np.isnan(y), np.abs(y - height) > rod
    by_links = {"coupler": first, "rod": second & ~first}
    for name, bad in by_links.items():
        found = [f for f in outcome.failures if name in str(f.data["links"])]
        edges = np.flatnonzero(np.diff(np.concatenate([[False], bad, [False]]).astype(int))).reshape(-1, 2)
        wanted = [(angle[i] - angle[0], angle[min(j, angle.size - 1)] - angle[0]) for i, j in edges]
        assert len(found) == len(wanted), (name, found, wanted)
        for failure, (start, stop) in zip(sorted(found, key=lambda f: f.data["start"]), wanted, strict=True):
            assert failure.data["start"] * 2 * math.pi == pytest.approx(start, abs=1e-5)
            assert failure.data["stop"] * 2 * math.pi == pytest.approx(stop, abs=1e-5)


def test_a_narrow_gap_just_before_another() -> None:
    """The rod fails a ten-thousandth of a radian before coupler and rocker do: it is the first to fail."""
    a, b, c, d, height = 60.0, 70.0, 50.0, 100.0, 60.0
    last = limit(a, d, b + c)

    def pin(angle: float) -> complex:
        start = a * complex(math.cos(angle), math.sin(angle))
        reach = abs(d - start)
        along = (b**2 - c**2 + reach**2) / (2 * reach)
        return start + (d - start) / reach * complex(along, math.sqrt(b**2 - along**2))

    data = second_loop(height - pin(last - 1e-4).imag)
    data["drives"] = {"motor": {**CRANK, "start": "60 deg"}}
    first = min(cycle_of(data).failures, key=lambda f: f.data["start"])
    assert "rod" in str(first.data["links"])
    assert first.data["start"] * 2 * math.pi == pytest.approx(last - 1e-4 - math.radians(60), abs=1e-7)
    assert first.data["stop"] * 2 * math.pi == pytest.approx(last - math.radians(60), abs=1e-7)


def test_by_a_sliding_drive() -> None:
    """A piston drives the crank: it can't go farther than rod and crank reach."""
    data = slider_crank(50, 160, 0)
    data["drives"] = {"piston": {"slides": "slider", "on": "frame", "start": "150 mm", "speed": "100 mm/s"}}
    data["assembly"] = {"B": "left of A-C"}
    data["studies"] = {"cycle": {"duration": "1 s", "samples": 20}}
    (failure,) = cycle_of(data).failures
    assert failure.data["start"] == pytest.approx(0.6, abs=1e-9)
    assert failure.data["stop"] == pytest.approx(1.0)
    assert (failure.data["drive"], failure.data["unit"]) == ("piston", "mm")
    assert float(failure.data["from"]) == pytest.approx(210.0)
    assert float(failure.data["by"]) == pytest.approx(40.0)


def test_what_is_known_stays_and_the_rest_is_blank(tmp_path: Any) -> None:
    job = job_of(four_bar(60, 70, 50, 100, measures={"m": {"max": "B.y"}}, require={"m": ">= 0 mm"}))
    result = job.cycle.result
    gap = (result.t > job.cycle.failures[0].data["start"]) & (result.t < job.cycle.failures[0].data["stop"])
    assert np.isnan(result["B.x"][gap]).all()
    assert np.isnan(result["motor.torque"][gap]).all()
    assert np.isfinite(result["B.x"][~gap]).all()
    assert np.isfinite(result["A.x"]).all()
    assert result.certificate is None
    assert job.cycle.measures == []
    assert not job.cycle.done
    write(job, tmp_path)
    summary = json.loads((tmp_path / "summary.json").read_text("utf-8"))
    assert (summary["done"], summary["certificate"], summary["measures"]) == (False, None, {})
    assert [f["code"] for f in summary["findings"]] == ["motion.cannot-assemble"]
    lines = (tmp_path / "cycle.csv").read_text("utf-8").splitlines()
    column = lines[0].split(",").index("B.x [mm]")
    assert [line.split(",")[column] == "" for line in lines[1:]] == gap.tolist()
    assert "nan" not in "\n".join(lines[1:])


def test_at_the_start_it_is_refused_before_anything_runs() -> None:
    job = job_of(four_bar(60, 70, 50, 100, drives={"motor": {**CRANK, "start": "170 deg"}}))
    (finding,) = job.examined.findings
    assert finding.code == "assembly.cannot-close"
    distance = abs(60 * np.exp(1j * math.radians(170)) - 100)
    assert float(finding.data["distance"]) == pytest.approx(distance, rel=1e-5)
    assert float(finding.data["by"]) == pytest.approx(distance - 120, rel=1e-3)
    assert finding.data["unit"] == "mm"
    assert speakable(finding)
    assert job.exit_code == 1
    assert job.cycle is None


# Singular poses.


# Some meet the pose exactly, some within round-off, on one side or the other of what can be assembled.
@pytest.mark.parametrize(("a", "b"), [(40, 100), (40, 120), (33.3, 71.9), (100, 40)])
@pytest.mark.parametrize(
    ("start", "samples"),
    [("90 deg", 8), ("30 deg", 36), ("30 deg", 333), ("10 deg", 200), ("1 rad", 37), ("200 deg", 60)],
)
def test_a_parallelogram_in_line_is_never_passed_in_silence(a: float, b: float, start: str, samples: int) -> None:
    """At 0 and 180 deg all four pins are in line: the rocker could go either way, and forces are unbounded."""
    data = four_bar(a, b, a, b, drives={"motor": {**CRANK, "start": start}})
    data["studies"] = {"cycle": {"turns": "1 motor", "samples": samples}}
    job = job_of(data)
    assert job.exit_code == 1
    assert set(codes(job.cycle.failures)) == {"motion.singular"}
    for failure in job.cycle.failures:
        angle = float(failure.data["value"])
        assert abs((angle + 90) % 180 - 90) < 1e-3
        assert failure.data["drive"] == "motor"
        assert speakable(failure)
    summary_text(job.summary)


@pytest.mark.parametrize("crossed", [False, True])
def test_a_part_of_the_turn_that_avoids_the_change_point_is_sound(crossed: bool) -> None:
    drives = {"motor": {**CRANK, "start": "20 deg"}}
    data = four_bar(40, 100, 40, 100, drives=drives, studies={"cycle": {"turns": "0.4 motor", "samples": 40}})
    data["assembly"] = {"B": "right of A-O4" if crossed else "left of A-O4"}
    outcome = cycle_of(data)
    assert outcome.done
    assert outcome.result.certificate is not None
    assert outcome.result.certificate.sound()
    if not crossed:
        assert outcome.result["rocker.angle"] == pytest.approx(outcome.result["crank.angle"], abs=1e-12)


def test_a_dead_centre_of_a_driven_piston_is_singular() -> None:
    """The piston goes to the very end of its stroke and back: no torque of the crank is felt there."""
    data = slider_crank(50, 160, 0)
    position = "185 mm + 25 mm*sin(360 deg*t/(1 s))"
    data["drives"] = {"piston": {"slides": "slider", "on": "frame", "position": position}}
    data["assembly"] = {"B": "left of A-C"}
    data["studies"] = {"cycle": {"duration": "1 s", "samples": 40}}
    job = job_of(data)
    assert job.exit_code == 1
    assert job.cycle.failures
    assert all(speakable(f) for f in job.cycle.failures)
    summary_text(job.summary)


def test_singular_at_the_very_start() -> None:
    """In line at t = 0: refused or failed, but said."""
    job = job_of(four_bar(40, 100, 40, 100))
    findings = [*job.examined.findings, *(job.cycle.failures if job.cycle else ())]
    assert job.exit_code == 1
    assert findings
    assert all(speakable(f) for f in findings)
    summary_text(job.summary)


def test_near_singular_is_sound_and_said() -> None:
    """Half a thousandth longer than a parallelogram's ground: a change point is near but not met."""
    outcome = cycle_of(four_bar(40, 100, 40.02, 100))
    certificate = outcome.result.certificate
    assert outcome.done
    assert certificate is not None
    assert certificate.nearest is not None
    assert 1e-4 < certificate.nearest.determinant < 0.1
    assert certificate.closure < 1e-9


def test_a_group_beyond_the_dyads_stops_at_its_own_dead_point() -> None:
    """Where it can be followed to against the end of its circuit, which is followed by arclength over all joints."""
    data = triad()
    (circuit,) = lw.modes(Document.model_validate(data)).circuits
    (failure,) = cycle_of(data | {"studies": {"cycle": {"duration": "20 s", "samples": 60}}}).failures
    assert speakable(failure)
    assert (failure.code, failure.path[0]) == ("motion.stuck", "links")
    assert set(str(failure.data["links"]).split(", ")) == {"leg1", "leg2", "leg3", "plate"}
    assert 0.2 * failure.data["start"] == pytest.approx(circuit.ranges[0][1], abs=1e-7)
    assert failure.data["stop"] == 20
