"""The page on robustness is what its script makes of what was measured."""

from __future__ import annotations

import json

import robustness
from fuzz import Counts
from fuzz_cases import KINDS
from fuzz_judge import Verdict
from fuzz_plants import PLANTS


def test_the_page_is_made_by_the_script() -> None:
    measured = json.loads(robustness.MEASURED.read_text("utf-8"))
    text = robustness.PAGE.read_text("utf-8")
    assert robustness.page(text, measured) == text


def test_all_classes_were_tried_all_planted_faults_found_and_failures_spoken_of() -> None:
    measured = json.loads(robustness.MEASURED.read_text("utf-8"))
    counts = measured["counts"]
    assert {*counts["cases"]} == {*KINDS} and min(counts["cases"].values()) > 0
    assert sum(counts["failed"].values()) == len(counts["failures"])
    text = robustness.PAGE.read_text("utf-8")
    assert all(str(seed) in text for seed, _ in counts["failures"])
    assert {*measured["plants"]} == {*PLANTS} and min(measured["plants"].values()) > 0


def test_a_fault_that_is_not_found_is_said() -> None:
    assert "| not detected |" in robustness.plants_table({})


def test_runs_are_added_up() -> None:
    first, second = Counts(), Counts()
    first.add(Verdict("text", 1, 2, ("file.yaml",), ["raised"], 3.0, 1.0))
    second.add(Verdict("text", 2, 0, ("nothing found",), [], 1.0, 7.0))
    second.add(Verdict("tree", 3, 2, ("file.expected",), ["raised"]))
    both = robustness.added([first.as_dict(), second.as_dict()])
    assert (both["cases"], both["codes"]) == ({"text": 2, "tree": 1}, ["file.expected", "file.yaml"])
    assert (both["slowest"]["seconds"], both["largest"]["mebibytes"]) == (3.0, 7)
    assert both["failures"] == [(1, "text"), (3, "tree")]
