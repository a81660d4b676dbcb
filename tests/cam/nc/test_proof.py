"""Each post's file read back: what the follower does on the milled cam; and files that are wrong."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from tests.cam.lifts import HEAT_SEAL, harmonic, heat_seal

from linkwright.cam.disc import Disc
from linkwright.cam.followers import SwingingFlat, SwingingRoller, TranslatingFlat, TranslatingRoller
from linkwright.cam.nc.job import MillingJob, passes
from linkwright.cam.nc.path import Sharp
from linkwright.cam.nc.posts import POSTS
from linkwright.cam.nc.preflight import faults, warnings
from linkwright.cam.nc.proof import prove
from linkwright.cam.nc.reader import read

DISC = Disc(SwingingRoller(0.039, 0.020, 0.085, 0.090), heat_seal, -1, HEAT_SEAL)
JOB = MillingJob(8.0, 12.0, 2e-5, 12.0, 400.0, 100.0, 6000.0, start=math.radians(200), spring=False)
ANGLES = 720


def milled(disc: Disc, job: MillingJob, post: str = "fanuc") -> str:
    return POSTS[post].text(job, list(passes(disc, job)))


@pytest.mark.parametrize("post", POSTS)
def test_each_post_makes_the_cam_within_its_tolerance(post: str) -> None:
    assert not list(faults(DISC, JOB, POSTS[post]))
    assert not list(warnings(DISC, JOB))
    text = milled(DISC, JOB, post)
    proof = prove(DISC, text, 0.008, ANGLES)
    assert not proof.faults
    assert 0 < proof.worst < JOB.tolerance
    assert max(proof.gouge, proof.rest) < JOB.tolerance * 0.09
    assert 30 < proof.time < 300
    assert max(map(len, text.splitlines())) <= POSTS[post].longest


@pytest.mark.parametrize(
    "change",
    [
        {"climb": False},
        {"allowance": 0.3, "step": 4.0, "spring": True},
        {"compensation": True, "lead": 10.0},
        {"compensation": True, "lead": 10.0, "climb": False},
        {"arcs": False},
        {"cutter": 20.0},
    ],
    ids=str,
)
def test_the_ways_to_mill(change: dict[str, Any]) -> None:
    job, disc = replace(JOB, **change), replace(DISC, sense=1)
    proof = prove(disc, milled(disc, job), job.cutter / 1e3, ANGLES)
    assert not proof.faults
    assert proof.worst < job.tolerance
    turning = sum(m.turn * m.sweep for m in proof.moves if m.turn)
    assert (turning < 0) == job.climb or not job.arcs  # clockwise around the outside is climbing with M3


@pytest.mark.parametrize(
    ("follower", "lift", "tolerance"),
    [
        (TranslatingRoller(0.04, 0.01, 0.01), harmonic(0.006, 0.001, 0.3), 1e-6),
        (TranslatingFlat(0.04), harmonic(0.006, 0.001, 0.3), 1e-6),
        (SwingingFlat(0.04, 0.09, 0.008), harmonic(0.06, 0.01, 0.5), 1e-5),
    ],
)
def test_other_followers(follower: Any, lift: Any, tolerance: float) -> None:
    disc, job = Disc(follower, lift), replace(JOB, tolerance=tolerance)
    assert [w.key for w in warnings(disc, job)] == ["nc.no-dwell"]
    proof = prove(disc, milled(disc, job), 0.008, ANGLES)
    assert not proof.faults
    assert proof.worst < tolerance


@pytest.mark.parametrize("cutter", [100.0, 200.0])
def test_large_cutters(cutter: float) -> None:
    """Contours smoothed by 1e-5 of these radii would be off by more than is allowed; 5 um too much is seen."""
    disc = Disc(TranslatingRoller(0.2, 0.03), harmonic(0.01))
    job = replace(JOB, cutter=cutter, tolerance=6e-7, start=0.0)
    text = milled(disc, job)
    proof = prove(disc, text, cutter / 1e3, ANGLES)
    assert not proof.faults
    assert max(proof.worst, proof.gouge, proof.rest) < job.tolerance
    assert prove(disc, text, cutter / 1e3 + 5e-6, ANGLES).gouge == pytest.approx(5e-6, abs=job.tolerance)


def test_a_wrong_cutter_is_caught() -> None:
    proof = prove(DISC, milled(DISC, JOB), 0.0081, ANGLES)
    assert proof.gouge == pytest.approx(1e-4, rel=0.03)
    assert proof.error.min() < -1e-4 / 0.09
    assert prove(DISC, milled(DISC, JOB), 0.0079, ANGLES).rest == pytest.approx(1e-4, rel=0.03)


def test_a_lost_decimal_is_caught() -> None:
    lines = milled(DISC, JOB).splitlines()
    number = next(k for k in range(60, len(lines)) if re.match(r"X-?\d+\.\d+ Y-?\d\d\.\d+ I", lines[k]))
    lost = re.sub(r"Y(-?\d)(\d)\.", r"Y\1.\2", lines[number])
    proof = prove(DISC, "\n".join([*lines[:number], lost, *lines[number + 1 :]]), 0.008, ANGLES)
    assert [(f.key, f.line) for f in proof.faults][:1] == [("nc.radius", number + 1)]


def test_a_lost_decimal_of_chords_is_caught() -> None:
    job = replace(JOB, arcs=False)
    lines = milled(DISC, job).splitlines()
    number = next(k for k in range(len(lines) - 60, 0, -1) if re.match(r"X-?\d\d\.\d+ Y", lines[k]))
    lost = re.sub(r"X(-?\d)(\d)\.", r"X\1.\2", lines[number])
    proof = prove(DISC, "\n".join([*lines[:number], lost, *lines[number + 1 :]]), 0.008, ANGLES)
    assert proof.gouge > 1e-3


def test_arcs_reversed_are_caught() -> None:
    text = milled(DISC, JOB)
    swapped = text.replace("G2 ", "G9 ").replace("G3 ", "G2 ").replace("G9 ", "G3 ")
    proof = prove(DISC, swapped, 0.008, ANGLES)
    assert proof.faults or proof.worst > 100 * JOB.tolerance


@pytest.mark.parametrize(
    ("text", "key"),
    [
        ("G1 X0 Y0 Z0", "nc.no-unit"),
        ("G21\nX1 Y0 Z0", "nc.no-motion"),
        ("G21\nM3 S1\nG1 X1 Y0 Z0", "nc.no-feed"),
        ("G21\nG1 F5 X1 Y0 Z0", "nc.no-spindle"),
        ("G21\nM3 S1\nG0 X0 Y0 Z0\nG2 F5 X1 Y0 R1", "nc.no-centre"),
        ("G21\nM3 S1\nG0 X0 Y0 Z0\nG2 F5 X1 Y0 I3 J0", "nc.radius"),
        ("G21\nM3 S1\nG0 X0 Y0 Z0 I3", "nc.centre-on-line"),
        ("G21 G18", "nc.unknown"),
        ("G21 M7654", "nc.unknown"),
        ("G21 X1 X2", "nc.twice"),
        ("G21 X#1", "nc.unreadable"),
        ("M30\nG21", "nc.after-end"),
        ("G21", "nc.no-end"),
    ],
)
def test_what_a_control_would_stop_at(text: str, key: str) -> None:
    assert key in [fault.key for fault in read(text).faults]


def test_modal_words() -> None:
    """Units, increments and modal motions as RS-274 has them: the same square four ways."""
    metric = "G21 G90\nM3\nG0 X0 Y0 Z0\nG1 F100 X25.4\nY25.4\nX0\nY0\nM2"
    others = [
        "G20 G90\nM3\nG0 X0 Y0 Z0\nG1 F3.937007874 X1\nY1\nX0\nY0\nM2",
        "G21 G90\nM3\nG0 X0 Y0 Z0\nG91 G01 F100 X25.4\nY25.4\nX-25.4\nY-25.4\nM2",
        "(a) G21 ; b\nM3\nG0 X0 Y0 Z0\nN10 g1 f100 x25.40\nY25.4\n\nX0\nY0\nM02",
    ]
    wanted = read(metric)
    assert not wanted.faults
    for text in others:
        found = read(text)
        assert not found.faults
        for a, b in zip(found.moves, wanted.moves, strict=True):
            assert np.allclose((*a.start, *a.end, a.feed), (*b.start, *b.end, b.feed), atol=1e-9)


@pytest.mark.parametrize(
    ("disc", "change", "post", "key"),
    [
        (Disc(SwingingRoller(0.02, 0.030, 0.085, 0.090), heat_seal, 1, HEAT_SEAL), {}, "fanuc", "nc.undercut"),
        (Disc(TranslatingRoller(0.03, 0.01), harmonic(0.008, 0.015)), {"cutter": 80.0}, "fanuc", "nc.concave"),
        (DISC, {"cutter": 1e-9}, "fanuc", "nc.small-cutter"),
        (DISC, {"compensation": True, "lead": 10.0}, "grbl", "nc.no-compensation"),
        (DISC, {"compensation": True}, "fanuc", "nc.short-lead"),
        (DISC, {"decimals": 6}, "fanuc", "nc.decimals"),
        (DISC, {"tolerance": 1e-6}, "fanuc", "nc.fine"),
    ],
)
def test_what_is_refused_before(disc: Disc, change: dict[str, Any], post: str, key: str) -> None:
    assert key in [fault.key for fault in faults(disc, replace(JOB, **change), POSTS[post])]


def test_too_fine_a_path_says_where() -> None:
    with pytest.raises(Sharp) as error:
        list(passes(DISC, replace(JOB, tolerance=1e-7, decimals=2)))
    assert 0 <= error.value.theta <= 2 * math.pi
