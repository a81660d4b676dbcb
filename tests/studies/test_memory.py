"""Memory stays within a stated share: what a run takes for each value, and the words for what would take more."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

import linkwright as lw
from helpers.examples import heavy_four_bar
from linkwright import _machine
from linkwright.findings import ModelError
from linkwright.model.document import Document, dump, parse_document
from linkwright.studies import kept_values
from linkwright.studies.kept_values import BYTES

PEAK = """
import resource, sys
from pathlib import Path
import linkwright as lw
job = lw.run(Path(sys.argv[1]), sys.argv[2])
assert job.exit_code == 0
run = job.outcomes["cycle"].result.run
print(run.t.size * len(run.compiled.quantities.signals.by_text), resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
"""


def peak(folder: Path, samples: int) -> tuple[int, int]:
    """The values of a run whose results are written, and the most memory (bytes) that its process took."""
    data = {**heavy_four_bar(), "studies": {"cycle": {"turns": "1 motor", "samples": samples}}}
    file = folder / f"{samples}.yaml"
    file.write_text(dump(Document.model_validate(data)), "utf-8")
    done = subprocess.run(
        [sys.executable, "-c", PEAK, str(file), str(folder / str(samples))], capture_output=True, text=True, check=True
    )
    values, kilobytes = map(int, done.stdout.split())
    return values, 1024 * kilobytes


@pytest.mark.skipif(sys.platform != "linux", reason="the peak is told in other units elsewhere")
def test_a_value_takes_no_more_memory_than_is_counted(tmp_path: Path) -> None:
    (few, least), (many, most) = (peak(tmp_path, samples) for samples in (1_000, 40_000))
    assert many > 2_000_000
    assert most - least < BYTES * (many - few)


def test_the_share_is_that_of_the_smallest_limit(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    container = tmp_path / "memory.max"
    monkeypatch.setattr(_machine, "_LIMITS", (str(container), str(tmp_path / "none")))
    monkeypatch.setattr(_machine, "_own_limit", lambda: None)
    monkeypatch.setattr(_machine, "_physical_memory", lambda: 8 << 30)
    assert _machine.memory_to_keep() == 2 << 30
    container.write_text("max\n")
    assert _machine.memory() == 8 << 30
    container.write_text(f"{1 << 30}\n")
    assert _machine.memory() == 1 << 30
    monkeypatch.setattr(_machine, "_own_limit", lambda: 1 << 29)
    assert _machine.memory() == 1 << 29
    assert _machine.memory_to_keep() > 0


@pytest.mark.parametrize(("gigabytes", "refused"), [(1.0, False), (0.1, True)])
def test_a_run_that_would_take_more_is_refused_before_it_begins(
    gigabytes: float, refused: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(kept_values, "memory_to_keep", lambda: int(gigabytes * 1e9))
    data = {**heavy_four_bar(), "studies": {"cycle": {"turns": "1 motor", "samples": 20_000}}}
    findings = lw.check(parse_document(data))
    assert [f.code for f in findings] == (["study.too-many-values"] if refused else [])
    if refused:
        assert "20,000 rows" in findings[0].what and "0.1 GB" in findings[0].what
        most = int(findings[0].mend.split("to ")[1].split(" ")[0].replace(",", ""))
        data["studies"] = {"cycle": {"turns": "1 motor", "samples": most}}
        assert not lw.check(parse_document(data))


def test_a_sweep_that_would_keep_more_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    data = heavy_four_bar(parameters={"a": 1.0})
    data["links"]["crank"]["points"]["B"] = ["a", 0]
    data["measures"] = {"most": {"max": "motor.torque"}, "least": {"min": "motor.torque"}}
    data["studies"] = {
        "cycle": {"turns": "1 motor", "samples": 12},
        "sweep": {"vary": {"a": {"from": 0.9, "to": 1.1, "count": 5000}}},
    }
    monkeypatch.setattr(kept_values, "memory_to_keep", lambda: 5000 * BYTES)
    with pytest.raises(ModelError) as caught:
        lw.sweep(parse_document(data))
    assert [f.code for f in caught.value.findings] == ["study.too-many-values"]
