"""Slides that leave their travel: where, when and by how much, against closed forms."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest

import linkwright as lw
from linkwright.findings import Finding
from linkwright.model.document import parse_document, read_document
from studies.models import job_of, slider_crank

EXAMPLE = Path(__file__).parents[2] / "examples" / "geneva.yaml"
R, L = 50.0, 160.0


def left(travel: list[Any], **sections: Any) -> list[Finding]:
    data = slider_crank(R, L, 0, **sections)
    data["joints"]["guide"] = data["joints"]["guide"] | {"travel": travel}
    job = job_of(data)
    assert {f.code for f in job.found} <= {"motion.travel"}
    assert job.exit_code == bool(job.found)
    assert job.cycle is not None and job.cycle.result.certificate is not None  # the figures stand all the same
    return list(job.found)


def crank_angle(s: float) -> float:
    """The crank angle (deg, 0..180) at which the slider is at s, in a centric slider-crank: the law of cosines."""
    return math.degrees(math.acos((R**2 + s**2 - L**2) / (2 * R * s)))


@pytest.mark.parametrize("samples", [3, 7, 200])
def test_both_ends_to_round_off_whatever_the_samples(samples: int) -> None:
    """Of a stroke 110 .. 210 mm: below 120 mm around 180 deg, above 200 mm up to a first angle and from its mirror."""
    low, high = left([120, 200], studies={"cycle": {"turns": "1 motor", "samples": samples}})
    assert (low.element, low.severity) == ("joints.guide.travel", "error")
    assert float(low.data["leaves_value"]) == pytest.approx(crank_angle(120), rel=1e-5)
    assert float(low.data["leaves"]) == pytest.approx(crank_angle(120) / 360, rel=1e-5)
    assert [low.data[key] for key in ("travel", "by", "value", "time")] == ["110", "10", "180", "0.5"]
    assert str(low.data["end"]) == "below"
    assert [high.data[key] for key in ("travel", "by", "value", "leaves")] == ["210", "10", "0", "0"]
    assert str(high.data["end"]) == "above"


def test_a_stay_shorter_than_a_step_is_found() -> None:
    """0.2 mm beyond the lower end, for some 8 deg of the turn, on steps of 72 deg."""
    (finding,) = left([110.2, 210], studies={"cycle": {"turns": "1 motor", "samples": 5}})
    assert float(finding.data["leaves_value"]) == pytest.approx(crank_angle(110.2), rel=1e-5)


@pytest.mark.parametrize("travel", [[110, 210], ["l - r", "l + r"], [0, "1 m"]])
def test_a_stroke_that_just_fits(travel: list[Any]) -> None:
    assert left(travel) == []


def test_the_example_and_its_full_turn() -> None:
    """Over a whole turn the pin of a Geneva drive leaves the slot: at 45 deg, and by 2 r at most."""
    document = lw.load(EXAMPLE)
    assert lw.run(document).exit_code == 0
    text = EXAMPLE.read_text("utf-8").replace("0.25 motor", "1 motor")
    whole, _ = read_document(text.encode())
    assert whole is not None
    job = lw.run(whole)
    (finding,) = (f for f in job.found if f.code == "motion.travel")
    assert job.exit_code == 1
    r = 100 * math.sin(math.pi / 4)
    assert float(finding.data["leaves_value"]) == pytest.approx(45, abs=1e-4)
    assert float(finding.data["travel"]) == pytest.approx(100 + r, rel=1e-5)
    assert float(finding.data["by"]) == pytest.approx(100, rel=1e-3)


@pytest.mark.parametrize(
    ("joint", "code"),
    [({"travel": [200, 120]}, "value.not-rising"), ({"travel": ["1 kg", 3]}, "expression.units-conflict")],
)
def test_faults_of_travel(joint: dict[str, Any], code: str) -> None:
    data = slider_crank()
    data["joints"]["guide"] = data["joints"]["guide"] | joint
    assert [f.code for f in lw.check(lw.Document.model_validate(data))] == [code]


def test_pins_have_no_travel() -> None:
    data = slider_crank()
    data["joints"]["p"] = {"revolute": ["crank", "rod"], "at": ["B", "B"], "travel": [0, 1]}
    with pytest.raises(lw.ModelError) as caught:
        parse_document(data)
    assert [f.code for f in caught.value.findings] == ["joint.travel"]
