"""The benchmark of proofs proves an example's extremes and says what it cost."""

import proofs
import pytest


def test_a_row_of_the_table(capsys: pytest.CaptureFixture[str]) -> None:
    proofs.table("four_bar_allocation")
    head, row = capsys.readouterr().out.splitlines()
    assert row.split()[:3] == ["four_bar_allocation", "1", "1"]
    assert len(row.split()) == 7
    assert "search ms" in head
