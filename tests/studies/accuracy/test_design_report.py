"""Allocation and calibration in units of the file, with what is infinite or unknown as null."""

from __future__ import annotations

from math import inf, nan
from typing import Any

import numpy as np
import pytest

from helpers.shown import tables
from linkwright.app.job import summary_text
from linkwright.studies.accuracy.allocation_outcome import AllocatedTarget, Allocation, Allotted, Optimality
from linkwright.studies.accuracy.calibration_outcome import Calibration, Confounded, Estimate, Observed
from linkwright.studies.accuracy.design_report import (
    allocation_entry,
    calibration_entry,
    design_sentences,
    design_tables,
)

MM, DEG = 1e-3, np.pi / 180


def allocation(**more: Any) -> Allocation:
    items = (
        Allotted("AB", "mm", MM, 50e-6, 20e-6, rounded=19.5e-6, grade="IT8", costs=(0.1, 0.25, 0.26), price=12_500.0),
        Allotted("AD", "mm", MM, 20e-6, 20e-6, fixed=True),
    )
    row = np.ones((1, 2))
    target = AllocatedTarget(
        "swing", "deg", DEG, "rss", 0.06 * DEG, 0.08 * DEG, 0.06 * DEG, 0.058 * DEG, 3 / DEG, row, 0
    )
    given: dict[str, Any] = {
        "costs": (0.1, 0.25, 0.26),
        "bound": 0.255,
        "proven": True,
        "reached": True,
        "loose": False,
    }
    return Allocation(items, (target,), 3.0, optimality=Optimality(0.0, 1e-15, 0.0), **{**given, **more})


def calibration() -> Calibration:
    estimates = (
        Estimate("AB", "mm", MM, 0.155, 20e-6, 1e-6, (18e-6, 22e-6), identified=True),
        Estimate("BC", "mm", MM, 0.395, 10e-6, None, None, identified=False),
    )
    observed = (
        Observed(0, 4, 0.1, 0.2, 0.19999, 0.5, outlier=False),
        Observed(0, 7, 0.2, 0.3, 0.299, 9.0, outlier=True),
    )
    return Calibration(
        estimates, np.array([[1, nan], [nan, nan]]), ("E.x",), (("mm", MM),), observed, (5e-6,), (True,), 3.0, 2, None,
        np.array([2.0, 1e-9]), 1e-6, (Confounded({"AB": 1e-3, "BC": 2e-3}, scaling=False),), False, 0.95, 1e-9,
        before=(60e-6,), after=(4e-6,),
    )  # fmt: skip


def test_the_cheapest_tolerances() -> None:
    entry = allocation_entry(allocation())
    assert entry is not None
    crank = entry["tolerances"]["AB"]
    shown = [crank[key] for key in ("now", "cheapest", "rounded", "price")]
    assert shown == pytest.approx([0.05, 0.02, 0.0195, 12.5])
    assert crank["largest"] is None  # no limit
    swing = entry["targets"]["swing"]
    assert [swing[key] for key in ("wanted", "now", "cheapest", "rounded", "price")] == pytest.approx(
        [0.06, 0.08, 0.06, 0.058, 3]
    )
    assert swing["met"]
    assert entry["cost"]["loss"] == pytest.approx(0.01)
    summary_text(entry)  # refuses what isn't a number


def test_what_can_be_said_of_a_price() -> None:
    shown = tables([*design_tables(allocation(), None)])
    assert shown["allocation"][0] == ["AB", "0.05", "0.02", "0.0195", "IT8", "0.0125", "mm"]
    assert shown["allocation"][1][4] == "fixed"
    assert shown["targets"] == [["swing", "0.06", "0.08", "0.06", "0.058", "0.003", "deg"]]


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ({}, "no other choice of grades is cheaper"),
        ({"proven": False}, "can't be excluded"),
        ({"reached": False}, "the closest ones cost"),
        ({"loose": True}, "the largest tolerances allowed"),
        ({"costs": (inf, 0.25, None)}, "the current ones cost –"),
    ],
)
def test_how_an_allocation_ended(more: dict[str, Any], said: str) -> None:
    assert said in " ".join(map(str, design_sentences(allocation(**more), None)))


def test_estimated_dimensions() -> None:
    entry = calibration_entry(calibration())
    assert entry is not None
    crank, coupler = (entry["parameters"][name] for name in ("AB", "BC"))
    assert (crank["value"], crank["interval"]) == (pytest.approx(155.02), pytest.approx([0.018, 0.022]))
    assert (coupler["identified"], coupler["error"], coupler["interval"]) == (False, None, None)
    assert entry["correlations"] == []
    assert entry["confounded"] == [{"deviations": pytest.approx({"AB": 1, "BC": 2}), "scaling": False}]
    assert [(one["row"], one["measured"]) for one in entry["outliers"]] == [(7, pytest.approx(300))]
    assert entry["outputs"]["E.x"] == pytest.approx(
        {"unit": "mm", "sigma": 5e-3, "sigma_stated": True, "before": 0.06, "after": 4e-3}
    )
    summary_text(entry)


def test_what_can_not_be_told_apart() -> None:
    told = " ".join(map(str, design_sentences(None, calibration())))
    assert "AB, BC aren't identifiable separately" in told
    assert "Row 7, E.x: residual 1" in told
    shown = tables([*design_tables(None, calibration())])
    rows = {row[0]: row for row in shown["calibration"]}
    assert rows["AB"][1:6] == ["155", "155.02", "0.02", "0.018 .. 0.022", "0.001"]
    assert rows["BC"][4:6] == ["not identifiable", "–"]


def test_nothing_where_nothing_is_asked() -> None:
    assert (allocation_entry(None), calibration_entry(None)) == (None, None)
    assert [*design_sentences(None, None), *design_tables(None, None)] == []
