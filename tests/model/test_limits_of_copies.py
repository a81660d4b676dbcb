"""Copies that multiply: a few lines can stand for any number of links, so what they may make has limits."""

from __future__ import annotations

import time
import tracemalloc
from typing import Any

import pytest

import linkwright as lw
from linkwright.findings import Finding

FEW_SECONDS, SOME_MEMORY = 10.0, 100e6


def copies(of: str, count: int, join: bool) -> dict[str, Any]:
    joined: dict[str, Any] = {"join": {"A": "A"}} if join else {}
    return {f"c{k}": {"of": of, **joined} for k in range(count)}


def multiplied(levels: int, count: int, inner: dict[str, Any], join: bool = False) -> dict[str, Any]:
    """Sub-assemblies that consist of copies of the next one each; the file has one copy of the first."""
    made = {f"s{k}": {**inner, "copies": copies(f"s{k + 1}", count, join)} for k in range(levels - 1)}
    return {
        "subassemblies": {**made, f"s{levels - 1}": inner},
        "links": {"frame": {"points": {"A": [0, 0]}}},
        "copies": copies("s0", 1, join),
    }


LINKS = {"links": {"rod": {"points": {"A": [0, 0], "C": [90, 0]}}, "rocker": {"points": {"B": [0, 0], "C": [70, 0]}}}}
SHARED = {"ports": ["A"], "links": {"A": {"points": {"H": [1, 2]}}}}
CASES: dict[str, tuple[dict[str, Any], str]] = {
    "10^8 empty ones": (multiplied(8, 10, {}), "subassembly.too-many"),
    "10^8 with links": (multiplied(8, 10, LINKS), "subassembly.too-many"),
    "100^4 with links": (multiplied(4, 100, LINKS), "subassembly.too-many"),
    "10^8 that add points to one link": (multiplied(8, 10, SHARED, join=True), "subassembly.too-many"),
    "10^50": (multiplied(50, 10, LINKS), "subassembly.deep"),
    "one in the other, 400 deep": (multiplied(400, 1, LINKS), "subassembly.deep"),
}


def findings(data: dict[str, Any]) -> list[Finding]:
    return lw.check(lw.Document.model_validate(data))


@pytest.mark.parametrize("case", CASES)
def test_what_copies_make_is_limited_in_time_and_memory(case: str) -> None:
    data, code = CASES[case]
    findings(multiplied(1, 1, LINKS))  # imports aren't counted
    tracemalloc.start()
    before = time.process_time()
    found = findings(data)
    spent, (_, peak) = time.process_time() - before, tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert [finding.code for finding in found if finding.code.startswith("subassembly.")] == [code]
    assert spent < FEW_SECONDS
    assert peak < SOME_MEMORY


def test_a_number_of_copies_within_the_limits_is_placed() -> None:
    """Of ten copies of ten each and so on a thousand are too many with those that they stand in; of nine 820 aren't."""
    assert "subassembly.too-many" in {finding.code for finding in findings(multiplied(4, 10, {}))}
    data = multiplied(4, 9, {})
    assert not {finding.code for finding in findings(data)} & {"subassembly.too-many", "subassembly.deep"}
