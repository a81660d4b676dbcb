"""The cycle's options, each with what is wrong with it; its warnings; several drives."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from linkwright.results import certify
from studies.models import CRANK, UNITS, codes, cycle_of, four_bar, job_of, refused, slider_crank, speakable

RAISE = {"turns": "crank", "on": "frame", "position": "30 deg + 20 deg*t/(1 s)"}
TABLE = {"points": [["0 s", "0 deg"], ["0.3 s", "10 deg"], ["0.6 s", "30 deg"], ["1 s", "40 deg"]]}


def cycle(**options: Any) -> dict[str, Any]:
    return {"studies": {"cycle": options}}


@pytest.mark.parametrize(
    ("options", "stop"),
    [
        ({"turns": "1 motor"}, 1.0),
        ({"turns": "2 motor"}, 2.0),
        ({"turns": "1.5e1 motor"}, 15.0),
        ({"turns": ".5 motor"}, 0.5),
        ({"turns": "0.25 motor"}, 0.25),
        ({"turns": "  3   motor "}, 3.0),
        ({"duration": "0.3 s"}, 0.3),
        ({"duration": 0.3}, 0.3),
        ({"duration": "1 s/2"}, 0.5),
        ({"duration": "300 ms"}, 0.3),
        ({"duration": "2*T"}, 0.5),
        ({"period": "1 s"}, 1.0),
        ({"period": "4*T"}, 1.0),
    ],
)
def test_how_long(options: dict[str, Any], stop: float) -> None:
    outcome = cycle_of(slider_crank(parameters={"r": 50, "l": 160, "e": 20, "T": "0.25 s"}, **cycle(**options)))
    assert outcome.done
    assert not outcome.warnings
    assert (outcome.result.run.start, outcome.result.run.stop) == (0.0, pytest.approx(stop, rel=1e-15))


def test_samples_are_steps() -> None:
    result = cycle_of(slider_crank(**cycle(turns="1 motor", samples=7))).result
    assert result.t == pytest.approx(np.arange(8) / 7)
    assert cycle_of(slider_crank(**cycle(turns="1 motor"))).result.t.size == 201


@pytest.mark.parametrize("speed", ["-60 rpm", "60 rpm", "-360 deg/s", "1 r/s"])
def test_turns_of_either_direction(speed: str) -> None:
    drives = {"motor": {**CRANK, "speed": speed}}
    assert cycle_of(slider_crank(drives=drives, **cycle(turns="3 motor"))).result.run.stop == pytest.approx(3.0)


@pytest.mark.parametrize(
    ("options", "key"),
    [
        ({}, "period"),
        ({"period": "1 s", "turns": "1 motor"}, "period"),
        ({"period": "1 s", "duration": "1 s"}, "period"),
        ({"turns": "one motor"}, "turns"),
        ({"turns": "motor"}, "turns"),
        ({"turns": "1"}, "turns"),
        ({"turns": "1 engine"}, "turns"),
        ({"turns": "-1 motor"}, "turns"),
        ({"turns": "0 motor"}, "turns"),
        ({"turns": 3}, "turns"),
        ({"turns": "1 motor", "samples": 1}, "samples"),
        ({"turns": "1 motor", "samples": 0}, "samples"),
        ({"turns": "1 motor", "samples": -5}, "samples"),
        ({"turns": "1 motor", "samples": 2.5}, "samples"),
        ({"turns": "1 motor", "samples": "many"}, "samples"),
        ({"turns": "1 motor", "samples": 10_000_000}, "samples"),
        ({"turns": "1 motor", "steps": 10}, "steps"),
        ({"duration": "0 s"}, "duration"),
        ({"duration": "-1 s"}, "duration"),
        ({"period": "-1 s"}, "period"),
        ({"duration": "1 s/0"}, "duration"),
        ({"duration": "1e30 s"}, "duration"),
    ],
    ids=str,
)
def test_a_bad_option_is_named(options: dict[str, Any], key: str) -> None:
    (finding,) = refused(slider_crank(**cycle(**options)))
    assert finding.code in ("study.options", "file.expected", "file.unknown-key", "name.unknown", "value.not-finite")
    assert finding.path[:2] == ("studies", "cycle")
    assert finding.data.get("key", finding.path[-1]) == key


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"duration": "1e300 s"}, "1e+300 s, but the limit is 1e+12 s"),
        ({"turns": "1e300 motor"}, "1e+300 s, but the limit is 1e+12 s"),
        ({"turns": "1e400 motor"}, "inf s, but the limit is 1e+12 s"),
        ({"duration": "1/0"}, "'1/0'"),
        ({"duration": "-1e300 s"}, "it must be positive"),
        ({"turns": "2 moter"}, "'moter'"),
    ],
    ids=str,
)
def test_what_is_wrong_with_a_length(options: dict[str, Any], said: str) -> None:
    (finding,) = refused(slider_crank(**cycle(**options)))
    assert said in finding.what


def test_turns_of_an_accelerating_drive_are_refused() -> None:
    drives = {"motor": {"turns": "crank", "on": "frame", "speed": 0, "start": 0, "acceleration": "5 rad/s^2"}}
    (finding,) = refused(slider_crank(drives=drives, **cycle(turns="1 motor")))
    assert (finding.code, finding.data["key"]) == ("study.options", "turns")


@pytest.mark.parametrize("duration", ["1 mm", "foo", "t", "crank.angle", "B.x/B.vx", "60 rpm", "1 s +", [1], True])
def test_a_length_of_time_that_is_none(duration: Any) -> None:
    for finding in refused(slider_crank(**cycle(duration=duration))):
        assert finding.path[:2] == ("studies", "cycle")


def test_all_bad_options_at_once() -> None:
    found = refused(slider_crank(**cycle(turns=1, samples="x", colour="red")))
    assert {f.path[-1] for f in found} == {"turns", "samples", "colour"}


def test_turns_of_a_drive_that_does_not_turn_steadily() -> None:
    for drive in (RAISE, {**CRANK, "speed": "0 rpm"}):
        assert codes(refused(slider_crank(drives={"motor": drive}, **cycle(turns="1 motor")))) == ["study.options"]


def test_an_unknown_study_is_refused_with_the_known_ones() -> None:
    (finding,) = refused(slider_crank(studies={"cylce": {"turns": "1 motor"}}))
    assert (finding.code, finding.path) == ("study.unknown", ("studies", "cylce"))
    assert "cycle" in finding.mend


def test_no_study_at_all() -> None:
    job = job_of(slider_crank(studies={}))
    assert codes(job.examined.findings) == ["study.none"]
    assert job.exit_code == 2
    assert not lw.check(lw.Document.model_validate(slider_crank(studies={})))


@pytest.mark.parametrize("options", [{"turns": "1 motor", "samples": 2}, {"turns": "40 motor", "samples": 50}], ids=str)
def test_the_certificate_does_not_depend_on_samples(options: dict[str, Any]) -> None:
    """However coarse the table, work and energy are compared exactly."""
    for data in (slider_crank(**cycle(**options)), four_bar(**cycle(**options))):
        certificate = cycle_of(data).result.certificate
        assert certificate is not None
        assert certificate.sound(), certificate.residuals


# Periodic or not.


def test_a_period_that_does_not_close_is_warned_of() -> None:
    job = job_of(slider_crank(**cycle(period="0.9 s")))
    assert job.cycle is not None
    (warning,) = job.cycle.warnings
    assert (warning.code, warning.severity) == ("motion.not-periodic", "warning")
    assert warning.path == ("studies", "cycle", "period")
    assert warning.data["element"] in ("A", "B", "C", "F")
    assert speakable(warning)
    assert not job.cycle.failures
    assert job.exit_code == 0


def test_the_warning_says_how_far() -> None:
    """Half a turn on, B is across the crank's circle: 100 mm away, farther than C's way there."""
    (warning,) = cycle_of(slider_crank(**cycle(period="0.5 s"))).warnings
    assert (warning.data["element"], warning.data["unit"]) == ("B", "mm")
    assert float(warning.data["distance"]) == pytest.approx(100.0, rel=1e-3)


@pytest.mark.parametrize("period", ["1 s", "2 s", "5 s"])
def test_whole_turns_are_periodic(period: str) -> None:
    assert not cycle_of(slider_crank(**cycle(period=period))).warnings


def test_duration_and_turns_promise_no_period() -> None:
    assert not cycle_of(slider_crank(**cycle(duration="0.9 s"))).warnings
    assert not cycle_of(slider_crank(**cycle(turns="0.9 motor"))).warnings


# A drive's law that ends, or breaks, on the way.


def drive(position: str, **sections: Any) -> Any:
    drives = {"motor": {"turns": "crank", "on": "frame", "position": position}}
    return job_of(slider_crank(drives=drives, **cycle(duration="2 s", samples=20), **sections))


@pytest.mark.parametrize(
    ("position", "code"),
    [
        ("lift(t)", "drive.outside-table"),
        ("lift(t)*2 - lift(t/2)", "drive.outside-table"),
        ("1 rad*sqrt(1 - t/(1 s))", "drive.not-finite"),
        ("1 rad/(1 - t/(1 s))", "drive.not-finite"),
        ("1 rad*log(1.5 - t/(1 s))", "drive.not-finite"),
    ],
)
def test_a_law_that_ends_on_the_way_is_a_finding(position: str, code: str) -> None:
    """At t = 0 all is well; the run is refused or fails, by the drive's name, and nothing is raised."""
    job = drive(position, tables={"lift": TABLE})
    findings = [*job.examined.findings, *(job.cycle.failures if job.cycle else ())]
    assert codes(findings) == [code]
    assert findings[0].path[:2] == ("drives", "motor")
    assert speakable(findings[0])
    assert job.exit_code in (1, 2)


@pytest.mark.parametrize("position", ["1 rad/0", "step5(t, 1 s, 0 deg, 1 s, 90 deg)", "1 rad*sqrt(-1 - t/(1 s))"])
def test_a_law_without_a_value_is_refused(position: str) -> None:
    job = drive(position)
    assert job.exit_code == 2
    assert codes(job.examined.findings) == ["drive.not-finite"]


def test_a_table_as_long_as_the_run_is_enough() -> None:
    tables = {"lift": {"points": [*TABLE["points"], ["2 s", "50 deg"]]}}
    assert drive("lift(t)", tables=tables).exit_code == 0


# Several drives.


def five_bar(**sections: Any) -> dict[str, Any]:
    """Two cranks of 8 and 10 mm, 30 mm apart, joined by rods of 26 and 28 mm."""
    return {
        "units": UNITS,
        "links": {
            "frame": {"points": {"O": [0, 0], "Q": [30, 0]}},
            "crank": {"points": {"O": [0, 0], "B": [8, 0]}, "mass": 0.01, "shape": "rod O-B"},
            "left": {"points": {"B": [0, 0], "C": [26, 0]}, "mass": 0.03, "shape": "rod B-C"},
            "right": {"points": {"D": [0, 0], "C": [28, 0]}, "mass": 0.03, "shape": "rod D-C"},
            "arm": {"points": {"Q": [0, 0], "D": [10, 0]}, "mass": 0.01, "shape": "rod Q-D"},
        },
        "assembly": {"C": "left of B-D"},
        "drives": {
            "motor": {"turns": "crank", "on": "frame", "speed": "30 rpm", "start": "0 deg"},
            "servo": {"turns": "arm", "on": "frame", "position": "90 deg + 20 deg*sin(180 deg*t/(1 s))"},
        },
        "studies": {"cycle": {"period": "2 s", "samples": 90}},
        **sections,
    }


def circles_meet(b: complex, d: complex) -> complex:
    """C, to the left of B-D, 26 mm from B and 28 mm from D."""
    reach = abs(d - b)
    along = (26**2 - 28**2 + reach**2) / (2 * reach)
    return b + (d - b) / reach * complex(along, np.sqrt(26**2 - along**2))


def test_two_drives() -> None:
    measures = {"reach": {"extremes": "C.x"}, "motor": {"mean": "motor.power"}, "servo": {"extremes": "servo.angle"}}
    outcome = cycle_of(five_bar(measures=measures))
    assert outcome.done
    assert not outcome.warnings
    result = outcome.result
    b = 8 * np.exp(1j * np.pi * result.t)
    d = 30 + 10 * np.exp(1j * (np.pi / 2 + np.radians(20) * np.sin(np.pi * result.t)))
    c = np.array([circles_meet(*pair) for pair in zip(b, d, strict=True)])
    assert result.shown("C.x")[0] == pytest.approx(c.real, rel=1e-12)
    assert result.shown("C.y")[0] == pytest.approx(c.imag, rel=1e-12)
    found = {m.name: m for m in outcome.measures}
    assert found["servo"].shown("max") == pytest.approx(110.0, rel=1e-12)
    assert found["servo"].shown("min") == pytest.approx(70.0, rel=1e-12)
    assert found["reach"].shown("max") >= c.real.max()
    # Over a whole period the two drives together do no work against masses without gravity or loads.
    powers = [result[f"{name}.power"] for name in ("motor", "servo")]
    assert abs((powers[0] + powers[1])[:-1].mean()) < 1e-6 * np.abs(powers).max()


def test_turns_of_one_drive_of_two() -> None:
    assert cycle_of(five_bar(**cycle(turns="2 motor"))).result.run.stop == pytest.approx(4.0)
    assert job_of(five_bar(**cycle(turns="1 servo"))).exit_code == 2


def test_a_windows_value_may_be_of_any_drive() -> None:
    windows = {"up": {"servo.angle": ["90 deg", "180 deg"]}}
    outcome = cycle_of(five_bar(windows=windows, measures={"m": {"extremes": "t", "window": "up"}}))
    assert outcome.measures[0].shown("min") == pytest.approx(0.0, abs=1e-12)
    assert outcome.measures[0].shown("max") == pytest.approx(1.0, abs=1e-9)
    assert cycle_of(five_bar(windows=windows, measures={"m": {"mean": "servo.angle", "window": "up"}})).measures[
        0
    ].shown() == pytest.approx(90 + 20 * 2 / np.pi, rel=1e-9)


def test_one_drive_short_of_the_mobility() -> None:
    drives = dict(five_bar()["drives"])
    drives.pop("servo")
    job = job_of(five_bar(drives=drives, **cycle(turns="1 motor")))
    assert job.exit_code == 1
    assert all(f.code.startswith("structure.") for f in job.examined.findings)


def test_dead_masses_and_no_gravity_need_no_forces() -> None:
    links = {name: {"points": link["points"]} for name, link in four_bar()["links"].items()}
    data = four_bar(links=links)
    data.pop("gravity")
    outcome = cycle_of(data)
    assert outcome.done
    assert outcome.result.certificate is not None
    assert outcome.result.certificate.equilibrium is None
    assert outcome.result["motor.torque"] == pytest.approx(0.0)


@pytest.mark.parametrize("miss", [1e-6, np.nan])
def test_a_run_whose_proof_fails_is_not_done(miss: float, monkeypatch: pytest.MonkeyPatch) -> None:
    """Its figures are there, but the exit code says that they don't hold."""
    monkeypatch.setattr("linkwright.studies.cycle.study.certify", lambda run: replace(certify(run), closure=miss))
    job = job_of(slider_crank(**cycle(turns="1 motor")))
    assert job.exit_code == 1
    (failure,) = job.found
    code = "motion.unproven" if miss == miss else "motion.unknown-between"
    assert (failure.code, failure.element) == (code, "studies.cycle")
    assert speakable(failure)
    assert "closure of the joints" in failure.what


def test_what_fails_turn_by_turn_is_told_of_the_first_turns() -> None:
    """Thousands of turns of a crank that can't turn: not thousands of findings, each with two ends to be found."""
    job = job_of(four_bar(a=65, d=150, studies={"cycle": {"turns": "20000 motor", "samples": 12}}))
    assert job.cycle is not None
    found = codes(job.cycle.failures)
    assert found == ["motion.cannot-assemble"] * 50 + ["motion.more-gaps"]
