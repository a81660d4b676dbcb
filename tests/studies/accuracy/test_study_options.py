"""The accuracy study beside other studies of a file."""

from __future__ import annotations

from pathlib import Path

from linkwright.app.job import examine_document
from linkwright.model.document import load, parse_document, plain

EXAMPLES = Path(__file__).parents[3] / "examples"


def test_of_a_wrong_cycle_only_the_cycle_tells() -> None:
    data = plain(load(EXAMPLES / "four_bar_accuracy.yaml"))
    data["studies"]["cycle"] = {"duration": "1 s", "period": "1 s"}
    document = parse_document(data)
    assert document is not None
    found = examine_document(document).findings
    assert {finding.path[:2] for finding in found} == {("studies", "cycle")}
    data["studies"]["accuracy"]["outputs"] = ["no.such"]
    document = parse_document(data)
    assert document is not None
    assert examine_document(document).exit_code == 2
