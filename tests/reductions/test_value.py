"""Values at the ends of a run and of a window are reported at those ends, also where a load begins or stops there."""

from __future__ import annotations

import pytest

from helpers.runs import example_run
from linkwright.measures import measure_all


def test_the_start_of_a_run_where_a_load_begins_is_at_0() -> None:
    """The load of the example begins at the start, so the value is that just after it."""
    run = example_run("chinese_names.yaml")
    found = {result.name: result for result in measure_all(run)[0]}
    stated, swept = found["理论行程"].found[0], found["行程"].found[0]
    assert (stated.time, stated.side) == (0.0, "")
    assert stated.value == pytest.approx(swept.value, rel=1e-12)
