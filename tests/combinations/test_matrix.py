"""The matrix: every kind of element by every study, form of drive, export, the page, copies, change points.

Each cell is right or refused by a finding with a place and a fix, as docs/validation/matrix.md has it.
"""

from __future__ import annotations

import warnings
from typing import Any

import pytest

from combinations import table
from combinations.columns import COLUMNS
from combinations.mechanisms import MECHANISMS
from combinations.performing import REFUSED, RIGHT, UNPROVEN, WRONG, RefusedError, judged
from helpers.longer import mostly_long
from linkwright.elements.kind_modules import KIND_MODULES
from linkwright.exports import TARGETS
from linkwright.findings import Finding
from linkwright.studies import STUDIES

CELLS = [(row, name) for row in MECHANISMS for name in COLUMNS]
USUAL = 16
"""Of so many cells one is tried in every run: along diagonals, so that all rows and columns are."""


def usual(place: tuple[str, str]) -> bool:
    return ([*MECHANISMS].index(place[0]) + 5 * [*COLUMNS].index(place[1])) % USUAL == 0


def test_every_kind_has_a_mechanism() -> None:
    covered = {kind for mechanism in MECHANISMS.values() for kind in mechanism.kinds}
    assert {*KIND_MODULES} - covered == set(), "kinds of elements without a mechanism in combinations/mechanisms.py"
    assert covered <= {*KIND_MODULES}


def test_every_study_and_export_has_a_column() -> None:
    groups = {group: {name for name, one in COLUMNS.items() if one.group == group} for group in table.GROUPS}
    assert {*STUDIES} - groups["study"] == set(), "studies without a column in combinations/columns.py"
    assert {*TARGETS} == groups["export"]
    assert {column.group for column in COLUMNS.values()} == {*table.GROUPS}


@pytest.mark.parametrize("row", MECHANISMS)
def test_every_mechanism_is_valid(row: str) -> None:
    """Refusals are those of combinations, not of a mechanism that is wrong itself."""
    assert table.kept()[row]["cycle"] == []


@pytest.mark.parametrize("place", mostly_long(CELLS, usual), ids=", ".join)
def test_a_cell(place: tuple[str, str]) -> None:
    row, name = place
    found = table.cell(row, name)
    assert found.verdict != WRONG, "\n".join(found.faults)
    assert [*found.codes] == table.kept()[row][name]


def test_the_page_is_made_of_the_outcomes() -> None:
    outcomes = table.kept()
    assert {row: [*cells] for row, cells in outcomes.items()} == {row: [*COLUMNS] for row in MECHANISMS}
    text = table.PAGE.read_text("utf-8")
    assert table.page(text, outcomes) == text


# What cells are held to.


def refusing(*findings: Finding) -> Any:
    def perform() -> list[str]:
        raise RefusedError(findings)

    return perform


UNKNOWN = Finding("motion.stuck", ("links", "rod"), {"time": 1, "drive": "m", "value": 2, "unit": "deg", "group": "g"})


def test_what_is_right_refused_and_wrong() -> None:
    assert judged(list).verdict == RIGHT
    assert judged(lambda: ["off"]).verdict == WRONG
    assert judged(refusing(UNKNOWN)).verdict == REFUSED
    assert judged(refusing()).verdict == WRONG
    placeless = Finding(UNKNOWN.code, (), UNKNOWN.data)
    assert judged(refusing(placeless)).verdict == WRONG
    failed = Finding(UNPROVEN[0], ("studies", "cycle"), {"figure": 1, "check": "closure"})
    assert judged(refusing(failed)).verdict == WRONG


def test_an_exception_and_a_warning_are_wrong() -> None:
    assert judged(lambda: [str(1 // 0)]).verdict == WRONG
    assert judged(lambda: [warnings.warn("divide", RuntimeWarning, stacklevel=1) or ""]).verdict == WRONG
