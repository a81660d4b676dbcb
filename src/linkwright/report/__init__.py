"""The HTML report: one self-contained file with the animated drawing, plots, measures and certificate."""

from linkwright.presentation.payload import compact
from linkwright.report.data import (
    Fact,
    JointData,
    LinkData,
    Plot,
    Pose,
    Problem,
    ReportData,
    Scene,
    Series,
    Time,
    Trace,
)
from linkwright.report.page import page

__all__ = [
    "Fact",
    "JointData",
    "LinkData",
    "Plot",
    "Pose",
    "Problem",
    "ReportData",
    "Scene",
    "Series",
    "Time",
    "Trace",
    "compact",
    "page",
]
