"""Studies killed and interrupted again and again at random moments, then resumed: the files are byte for byte those of
a study that nothing stopped. Every registered study that keeps what it has done is among them."""

from __future__ import annotations

import json
import multiprocessing
import os
import random
import signal
import sys
import time
from collections.abc import Iterator
from dataclasses import replace
from multiprocessing.context import ForkServerContext
from pathlib import Path
from typing import Any

import pytest

import linkwright as lw
from helpers.longer import mostly_long
from helpers.workspaces import arm
from linkwright.app.job import examine_file
from linkwright.app.manifest import NAME
from linkwright.studies import STUDIES, RunContext
from studies.models import slider_crank

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="signals are POSIX's")

EXAMPLES = Path(__file__).parents[2] / "examples"
TIMES = [2, pytest.param(6, marks=pytest.mark.long)]
"""How often a study is stopped: killed and interrupted in turns."""


def sampled(**studies: Any) -> dict[str, Any]:
    measures = {"stroke": {"span": "guide.s"}}
    parameters = {"r": {"value": 50, "tolerance": 0.1}, "l": {"value": 160, "tolerance": 0.2}}
    made = slider_crank(measures=measures, studies={"cycle": {"turns": "1 motor", "samples": 16}, **studies})
    return made | {"parameters": made["parameters"] | parameters}


VARY = {"r": {"normal": 50, "sigma": 0.1}, "l": {"uniform": [155, 165]}}
SWEEP = {"vary": VARY, "outputs": ["stroke", "C.x"], "samples": 40_000, "kernel": "numpy"}
CASES: dict[str, tuple[str, dict[str, Any]]] = {
    "sweep": ("sweep", sampled(sweep=SWEEP)),
    "sweep, all values kept": ("sweep", sampled(sweep={**SWEEP, "samples": 20_000, "keep": "all"})),
    "accuracy": ("accuracy", sampled(accuracy={"outputs": ["stroke", "C.x"], "samples": 40_000, "kernel": "numpy"})),
    "workspace": ("workspace", arm(chord=1e-4, quality={"steps": 30}, **{"for": {"b": [*range(20, 26)]}})),
}
"""Of each way to keep what is done: the command, and a model whose study takes a second."""


def command(*words: str) -> None:
    """The program in a process of its own, which has imported everything."""
    sys.argv = ["linkwright", *words]
    with Path(os.devnull).open("w") as nowhere:
        sys.stdout = sys.stderr = nowhere
        from linkwright.__main__ import main

        main()


@pytest.fixture(scope="module")
def processes() -> Iterator[ForkServerContext]:
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload(
        ["linkwright.app", "linkwright.cli", "linkwright.cli.show", "linkwright.report.page"]
    )
    yield context


def contents(folder: Path) -> dict[str, bytes]:
    """All files of a folder but the manifest and the lock; of a DXF its entities, as its head has a time."""
    found = {str(p.relative_to(folder)): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}
    for name in found:
        if name.endswith(".dxf"):
            found[name] = found[name].partition(b"ENTITIES")[2].partition(b"ENDSEC")[0]
    return {name: content for name, content in found.items() if name not in (NAME, ".linkwright.lock")}


@pytest.mark.parametrize("times", TIMES)
@pytest.mark.parametrize("case", mostly_long(CASES, lambda case: case != "sweep"))
def test_stopped_at_random_moments(
    case: str, times: int, processes: ForkServerContext, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if "kept" in case:
        pytest.importorskip("zarr")
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1700000000")
    study, model = CASES[case]
    lw.save(lw.Document.model_validate(model), tmp_path / "model.yaml")
    random_ = random.Random(case)

    def begun(out: str) -> Any:
        words = [study, str(tmp_path / "model.yaml"), "--out", str(tmp_path / out)]
        process = processes.Process(target=command, args=words)
        process.start()
        return process

    start = time.monotonic()
    whole = begun("whole")
    whole.join()
    took = time.monotonic() - start
    assert whole.exitcode == 0
    codes = []
    for number in range(times):
        process = begun("out")
        process.join(random_.uniform(0.2, 0.7) * took)
        sent = (signal.SIGKILL, signal.SIGINT)[number % 2]
        if process.pid is not None and process.is_alive():
            os.kill(process.pid, sent)
        process.join()
        codes.append(process.exitcode)
        assert process.exitcode in (0, 130, -sent)
    last = begun("out")
    last.join()
    assert last.exitcode == 0
    assert contents(tmp_path / "out") == contents(tmp_path / "whole")
    assert any(codes), "it was never stopped"
    written = json.loads((tmp_path / "out" / NAME).read_text("utf-8"))["written"]["studies"]
    assert (written["state"], written.get("resumable", {})) == ("done", {})


def test_every_study_that_keeps_what_it_has_done_is_among_them(tmp_path: Path) -> None:
    """All others are performed, and keep nothing."""
    for name in {*STUDIES} - {study for study, _ in CASES.values()}:
        kept: list[str] = []
        site = RunContext(folder=EXAMPLES, out=tmp_path, keep=lambda path, study, kept=kept: kept.append(path.name))
        for path in sorted(EXAMPLES.glob("*.yaml"), key=lambda path: path.stat().st_size):
            examined = examine_file(path)
            asked = [task for task in examined.tasks if task.study.name == name]
            if asked and examined.exit_code == 0:
                asked[0].study.run(examined.compiled, asked[0].options, replace(site, document=examined.document))
                break
        else:
            pytest.fail(f"no example performs the study {name}")
        assert kept == [], f"{name} keeps what it has done: it belongs among the cases"
