"""NC code of a groove by the study: what is written of it, and what isn't."""

from __future__ import annotations

import json
import math
import re
from typing import Any

import numpy as np
import pytest

from helpers.charts import graph, plane, titled
from helpers.heat_seal import NC, findings, heat_seal, performed
from helpers.shown import blocks, heads, rows
from linkwright.cam.nc.posts import Grbl, Post
from linkwright.presentation.blocks import Table
from linkwright.presentation.charts import Lines, Region
from linkwright.report.cam_shapes import cam_shapes
from linkwright.studies.cam.charts import charts
from linkwright.studies.cam.files import FILES
from linkwright.studies.cam.picture import picture, still
from linkwright.studies.cam.report import report

GROOVE = {"closed": "groove"}


def test_a_groove_and_what_is_written_of_it() -> None:
    job = performed(heat_seal(GROOVE, nc=NC | {"post": ["fanuc", "grbl"]}, steps=90))
    assert job.cam is not None and job.exit_code == 0
    entry = json.loads(json.dumps(job.summary["cam"]["nc"], allow_nan=False))
    assert all(one["written"] and one["lift_error"] < 2e-3 for one in entry.values())
    least, most = entry["fanuc"]["play_mm"]
    assert -4e-3 < least < most < 4e-3  # 2e-3 deg of an arm of 90 mm are 3 um on each flank
    (table,) = [one for one in blocks(report(job.cam), Table) if one.name == "nc"]
    assert heads(table).index("Clearance, mm") == heads(table).index("Excess material, mm") + 1
    assert [row[0] for row in rows(table)] == ["fanuc", "grbl"]
    drawn = titled(charts(job.cam))
    profile, flank, path = plane(drawn["Cutter path"]).layers
    assert isinstance(profile, Region) and isinstance(flank, Lines) and isinstance(path, Lines)
    assert np.hypot(*profile.rings[0]).max() < np.hypot(*np.hstack(path.lines)).max() < np.hypot(*flank.lines[0]).max()
    (error,) = [graph(content) for title, content in drawn.items() if "on both flanks" in title]
    assert [str(row.name) for row in error.rows] == [
        f"{side} flank, {end}" for side in ("inner", "outer") for end in ("bottom", "top")
    ]
    comments = re.findall(r"\((.*)\)", str(FILES["cam_fanuc.nc"].make(job.cam)))[1:]  # without the model's name
    assert len(comments) > 4 and not [one for one in comments if one != one.upper()]  # older controls stop at others
    assert "(SLOT, RAMP" in str(FILES["cam_fanuc.nc"].make(job.cam))
    assert FILES["cam_siemens.mpf"].make(job.cam) is None


@pytest.mark.parametrize(
    ("closed", "blank", "code"),
    [
        ("groove", {}, "cam.groove-blank"),
        ("force", {"radius": 100, "groove": 8}, "cam.groove-blank"),
        ("groove", {"radius": 100, "groove": 12}, "cam.groove-deep"),
        ("groove", {"radius": 100}, "cam.together"),
    ],
)
def test_plates_that_hold_no_groove(closed: str, blank: dict[str, Any], code: str) -> None:
    found = findings(heat_seal({"closed": closed}, blank={"thickness": 12, **blank}))
    assert [finding.code for finding in found] == [code]


def test_the_plate_around_a_groove() -> None:
    """Its outer flank reaches to 95.852 mm, a roller's diameter beyond the profile's 55.852 mm."""
    for radius, codes in ((95.8, ["cam.plate"]), (95.9, [])):
        outcome = performed(heat_seal(GROOVE, blank={"thickness": 12, "radius": radius, "groove": 8})).cam
        assert outcome is not None and [finding.code for finding in outcome.failures] == codes
        assert (FILES["cam.step"].make(outcome) is None) == bool(codes)
    slot = outcome.first.outer_area - outcome.area
    assert outcome.first.volume == pytest.approx(0.012 * math.pi * radius**2 * 1e-6 - 0.008 * slot, rel=1e-12)


@pytest.mark.parametrize(
    ("nc", "code"),
    [
        ({"cutter": 20.5}, "nc.wide-cutter"),
        ({"cutter": 4, "allowance": 4.1}, "nc.allowance"),
        ({"compensation": True, "cutter": 15, "lead": 25, "post": "fanuc"}, "nc.groove-lead"),
    ],
)
def test_what_does_not_fit_into_a_groove(nc: dict[str, Any], code: str) -> None:
    (finding,) = findings(heat_seal(GROOVE, nc=NC | nc))
    assert finding.code == code and finding.what and finding.mend


def test_an_undercut_outer_flank_is_told_once_with_what_mends_it() -> None:
    turns = {"sense": "counter-clockwise", "roller": 12, "base": 40}
    law = ({"rise": 25, "over": 25}, {"dwell": 155}, {"fall": 25, "over": 60}, {"dwell": 120})

    def groove(**cam: float) -> dict[str, Any]:
        data = heat_seal(GROOVE | turns | cam, nc=NC, steps=90)
        data["laws"]["swing"]["segments"] = [{"law": "cycloidal"} | one if "over" in one else one for one in law]
        return data

    job = performed(groove())
    (finding,) = job.found
    assert finding.code == "cam.undercut" and "outer flank" in finding.what
    assert not FILES["cam_grbl.nc"].make(job.cam)  # type: ignore[arg-type]
    base = float(str(finding.data["base"]).split()[0])
    assert not performed(groove(base=base)).found and performed(groove(base=0.999 * base)).found


def test_both_flanks_are_drawn() -> None:
    outcome = performed(heat_seal(GROOVE)).cam
    assert outcome is not None
    assert len(cam_shapes(outcome.compiled, 1.0)["cam"]) == 2
    for text in (picture(outcome), still(outcome)):
        (flank,) = re.findall(r'<polygon class="flank" points="([^"]+)"', text)
        (profile,) = re.findall(r'<polygon class="profile" points="([^"]+)"', text)
        wide = [np.ptp([float(p.split(",")[0]) for p in line.split()]) for line in (profile, flank)]
        (roller,) = re.findall(r'<circle class="follower"[^>]* r="([0-9.]+)"', text)[:1]
        assert wide[1] - wide[0] == pytest.approx(4 * float(roller), abs=0.1)  # a roller's width on either side


def test_a_wrong_depth_is_never_written(monkeypatch: pytest.MonkeyPatch) -> None:
    """A lost decimal of all depths leaves the contours as they are."""
    monkeypatch.setattr(Grbl, "text", lambda *given: Post.text(*given).replace("Z-12.", "Z-1.2"))
    job = performed(heat_seal(nc=NC, steps=90))
    assert [finding.code for finding in job.found] == ["nc.depth"]
    assert "1.2 mm deep, but 12 mm" in job.found[0].what
    assert job.cam is not None and FILES["cam_grbl.nc"].make(job.cam) is None
