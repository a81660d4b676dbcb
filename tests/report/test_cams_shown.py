"""Cams in the report: profile and roller on their links, touching in every pose; plots of the contact."""

from __future__ import annotations

from pathlib import Path

import numpy as np

import linkwright as lw
from helpers.cams import closed_pair
from helpers.compiled import compiled_from
from linkwright.report.build import report_data
from linkwright.report.cam_shapes import cam_shapes

EXAMPLE = Path(__file__).parents[2] / "examples" / "cam_linkage.yaml"


def test_profile_and_roller_are_drawn_touching() -> None:
    job = lw.run(EXAMPLE)
    data = report_data(lw.load(EXAMPLE), job.outcomes)
    links = {link["name"]: link for link in data["scene"]["links"]}
    assert {name for name, link in links.items() if "outlines" in link} == {"disc", "crank"}

    def placed(name: str, k: int) -> np.ndarray:
        pose = links[name]["pose"]
        x, y, c, s = (pose[key][k] for key in ("x", "y", "c", "s"))
        return np.array(links[name]["outlines"][0]) @ np.array([[c, s], [-s, c]]) + [x, y]

    for k in range(0, 361, 30):
        roller, profile = placed("crank", k), placed("disc", k)
        gap = np.hypot(*(profile - roller.mean(axis=0)).T).min() - 15
        assert -1e-9 < gap < 0.08  # mm; the profile has points only every 2 deg
    shown = {series["name"] for plot in data["plots"] for series in plot["series"]}
    assert {"pushing.force", "pushing.pressure", "motor.torque", "motor.power"} <= shown
    assert "pushing.power" not in shown


def test_both_discs_and_both_rollers_are_drawn() -> None:
    data = closed_pair("swinging", "roller")
    shapes = cam_shapes(compiled_from(data), 1.0)
    assert [len(shapes[link]) for link in ("disc", "arm")] == [2, 2]
    circle = np.array(shapes["arm"][1])
    middle = np.array(data["links"]["arm"]["points"]["C"])
    assert np.abs(np.hypot(*(circle - middle).T) - 0.009).max() < 1e-12
    assert len(cam_shapes(compiled_from(closed_pair("sliding", "face")), 1.0)["disc"]) == 2
