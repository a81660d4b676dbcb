"""Springs and counterweights in the report: drawn between their points, plotted, named in the structure."""

from __future__ import annotations

from pathlib import Path

import linkwright as lw
from linkwright.report.build import report_data

SPRUNG = Path(__file__).parents[1] / "model" / "data" / "sprung.yaml"


def test_springs_are_drawn_plotted_and_named() -> None:
    job = lw.run(SPRUNG)
    assert job.cycle is not None
    data = report_data(lw.load(SPRUNG), job.outcomes)
    looks = {spring["name"]: spring["look"] for spring in data["scene"]["springs"]}
    assert looks == {"pull": "coil", "wire": "coil", "lift": "strut", "shock": "strut"}
    (shock,) = (spring for spring in data["scene"]["springs"] if spring["name"] == "shock")
    assert (shock["links"], shock["points"]) == (("frame", "rocker"), ("A", "E"))
    shown = {series["name"] for plot in data["plots"] for series in plot["series"]}
    assert {"pull.length", "lift.force", "shock.force", "hold.torque", "wound.torque"} <= shown
    said = {str(fact["name"]): str(fact["sentence"]) for fact in data["structure"]}
    assert said["Counterweights"] == "cw on crank; cp on coupler"
    springs = dict(text.split(" ", 1) for text in said["Springs"].split("; "))
    pull = job.cycle.result["pull.force"][0]  # in tension
    assert springs["pull"] == f"from K to E, pulls with {pull:.6g} N at the start"
    hold = job.cycle.result["hold.torque"][0]
    assert springs["hold"] == (
        f"between coupler and rocker, turns coupler counter-clockwise with {-hold:.6g} N·m at the start"
    )
    assert said["Mass"] == "all moving links: crank, coupler, rocker"
