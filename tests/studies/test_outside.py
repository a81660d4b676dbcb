"""A study of another package: one file, made known by an entry point, with no other file changed."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from helpers.outside import linkwright, table, without_kinds

EXAMPLE = Path(__file__).parents[2] / "examples" / "four_bar.yaml"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    text = EXAMPLE.read_text(encoding="utf-8")
    start = text.index("\nstudies:")
    model = f"{text[:start]}\nstudies: {{shaking: {{over: 0.5 s, samples: 48}}}}\n"
    (tmp_path / "model.yaml").write_text(model, encoding="utf-8")
    return tmp_path


def run(folder: Path, *words: str) -> dict[str, Any]:
    """A command's summary."""
    done = linkwright(folder, *words, "--json")
    assert done.returncode == 0, done.stderr
    summary: dict[str, Any] = json.loads(done.stdout)
    return summary


def test_it_is_run_shown_and_written(folder: Path) -> None:
    found = run(folder, "run", "model.yaml", "--out", "out")["shaking"]
    columns, t = table(folder / "out" / "shaking.csv")
    force = np.hypot(columns["x [N]"], columns["y [N]"])
    assert (t.size, found["largest"]) == (49, pytest.approx(force.max(), rel=1e-12))
    done = linkwright(folder, "run", "model.yaml", "--out", "out")
    assert f"Largest shaking force: {force.max():.6g} N (numpy kernel)." in done.stdout
    assert "Harmonics of the shaking force" in done.stdout
    page = (folder / "out" / "report.html").read_text(encoding="utf-8")
    section = re.search(r'<section id="shaking">.*?</section>', page, re.DOTALL)
    assert section is not None
    assert all(part in section[0] for part in ("<h2>Shaking force</h2>", "Amplitude, N", "data-chart="))
    assert 'href="#shaking"' in page


def test_its_command_takes_its_settings(folder: Path) -> None:
    assert "Look at the shaking force of a cycle." in linkwright(folder, "--help").stdout
    helped = linkwright(folder, "shaking", "--help").stdout
    assert "--samples" in helped and "--kernel" in helped and "--workers" not in helped
    plain, fine = (run(folder, "shaking", "model.yaml", *more)["shaking"] for more in ((), ("--samples", "96")))
    assert fine["largest"] >= plain["largest"]
    llvm = run(folder, "shaking", "model.yaml", "--kernel", "llvm")["shaking"]
    assert (llvm["kernel"], llvm["largest"]) == ("llvm", pytest.approx(plain["largest"], rel=1e-12))


def test_its_options_are_checked_and_in_the_schema(folder: Path) -> None:
    schema = json.loads(linkwright(folder, "schema").stdout)
    assert "over" in schema["properties"]["studies"]["properties"]["shaking"]["properties"]
    text = (folder / "model.yaml").read_text(encoding="utf-8").replace("0.5 s", "0.5 mm").replace("48", "2")
    (folder / "model.yaml").write_text(text, encoding="utf-8")
    done = linkwright(folder, "check", "model.yaml")
    assert done.returncode == 2 and "Traceback" not in done.stderr
    assert "studies.shaking" in done.stderr


def test_without_the_package_nobody_knows_it(folder: Path) -> None:
    done = without_kinds(folder, "check", "model.yaml")
    assert done.returncode == 2 and "There is no study called 'shaking'." in done.stderr
