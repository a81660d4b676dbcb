"""Cams in the report: profile and roller on their links, touching in every pose; plots of the contact."""

from __future__ import annotations

from pathlib import Path

import numpy as np

import linkwright as lw
from linkwright.report.build import report_data

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
        assert -1e-9 < gap < 0.05  # mm; the profile has points only every 2 deg
    shown = {series["name"] for plot in data["plots"] for series in plot["series"]}
    assert {"pushing.force", "pushing.pressure", "motor.torque", "motor.power"} <= shown
    assert "pushing.power" not in shown
