"""Mechanisms with two drives whose workspace has a closed form or is small, as the data of model files (m, deg)."""

from __future__ import annotations

from typing import Any

from linkwright.app.job import Job, examine_document, perform
from linkwright.findings import Finding
from linkwright.model.document import parse_document

UNITS = {"length": "mm", "angle": "deg", "time": "s"}


def arm(a: float = 40, b: float = 30, **options: Any) -> dict[str, Any]:
    """Two links in a row, each turned by a motor: the tip E reaches the annulus between |a - b| and a + b (mm)."""
    return {
        "linkwright": 1,
        "name": "Arm <2R>",
        "units": UNITS,
        "parameters": {"a": a, "b": b},
        "links": {
            "frame": {"points": {"A": [0, 0]}},
            "upper": {"points": {"A": [0, 0], "B": ["a", 0]}},
            "fore": {"points": {"B": [0, 0], "E": ["b", 0]}},
        },
        "drives": {
            "shoulder": {"turns": "upper", "on": "frame", "speed": "60 rpm", "start": "30 deg"},
            "elbow": {"turns": "fore", "on": "upper", "speed": "30 rpm", "start": "60 deg"},
        },
        "studies": {"workspace": {"point": "E", "chord": 1e-4, **options}},
    }


def polar(**options: Any) -> dict[str, Any]:
    """A turning guide and a slide on it, 50 .. 80 mm away: an annulus, or with the angle limited a sector of one."""
    data = arm()
    data["links"] = {
        "frame": {"points": {"A": [0, 0]}},
        "upper": {"points": {"A": [0, 0]}},
        "fore": {"points": {"E": [0, 0]}},
    }
    data["joints"] = {"guide": {"prismatic": ["upper", "fore"], "line": ["A at 0 deg", "E at 0 deg"]}}
    data["drives"]["elbow"] = {"slides": "fore", "on": "upper", "position": "60 mm"}
    return data | {"studies": {"workspace": {"point": "E", "chord": 1e-4, **options}}}


def five_bar(**options: Any) -> dict[str, Any]:
    """A symmetric five-bar: cranks 10, couplers 12, base 10 (mm). Its pin C is the working point."""
    data = arm()
    data["parameters"] = {"l": 12, "base": 10}
    data["links"] = {
        "frame": {"points": {"A": [0, 0], "F": ["base", 0]}},
        "left": {"points": {"A": [0, 0], "B": [10, 0]}},
        "right": {"points": {"F": [0, 0], "D": [10, 0]}},
        "first": {"points": {"B": [0, 0], "C": ["l", 0]}},
        "second": {"points": {"D": [0, 0], "C": ["l", 0]}},
    }
    data["assembly"] = {"C": "left of D-B"}
    data["drives"] = {
        "motor": {"turns": "left", "on": "frame", "speed": "60 rpm", "start": "100 deg"},
        "servo": {"turns": "right", "on": "frame", "speed": "30 rpm", "start": "80 deg"},
    }
    return data | {"studies": {"workspace": {"point": "C", "chord": 1e-4, **options}}}


def four_bar(**options: Any) -> dict[str, Any]:
    """A crank-rocker of one drive; P lies on the coupler."""
    data = arm()
    data["parameters"] = {"l": 40}
    data["links"] = {
        "frame": {"points": {"A": [0, 0], "D": [50, 0]}},
        "crank": {"points": {"A": [0, 0], "B": [15, 0]}},
        "coupler": {"points": {"B": [0, 0], "C": ["l", 0], "P": [20, 20]}},
        "rocker": {"points": {"D": [0, 0], "C": [35, 0]}},
    }
    data["assembly"] = {"C": "left of B-D"}
    data["drives"] = {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": "30 deg"}}
    return data | {"studies": {"workspace": {"point": "P", "chord": 1e-5, **options}}}


def performed(data: dict[str, Any]) -> Job:
    """The study performed."""
    document = parse_document(data)
    assert document is not None
    return perform(examine_document(document))


def findings(data: dict[str, Any]) -> list[Finding]:
    """All that is wrong with a file."""
    return performed(data).examined.findings
