"""Commands, options, files and names that aren't there: what is said of them."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner

from app.models import SOUND
from linkwright.cli import cli

SAID = {
    "chek model.yaml": "There is no command 'chek'. Did you mean 'check'? All of them: accuracy,",
    "simulate model.yaml": "Did you mean 'run'?",
    "frobnicate": "There is no command 'frobnicate'. Write one of these: accuracy,",
    "model.yaml": "'model.yaml' is a file. Did you mean 'linkwright run model.yaml'?",
    "reactions model.yaml": "'studies: {reactions: {}}'",
    "mjcf model.yaml": "Did you mean 'linkwright export FILE --to mjcf'?",
    "wiper": "Did you mean 'linkwright new wiper'?",
    "sweep model.yaml --worker 2": "has no option '--worker'. Did you mean '--workers'?",
    "run model.yaml --output x": "Did you mean '--out'?",
    "run modle.yaml": "Did you mean 'model.yaml'?",
    "run model": "Did you mean 'model.yaml'?",
    "run wiper.yaml": "'linkwright new wiper' writes it to a file.",
    "run nowhere/a.yaml": "nowhere/a.yaml doesn't exist",
    "new wipper": "Did you mean 'wiper'?",
    "export model.yaml": "mjcf, motor-expressions, process-simulate",
    "export model.yaml --to mujoco": "Did you mean 'mjcf'?",
    "export model.yaml --to process-simulate --dialect wizrd": "Did you mean 'wizard'?",
    "bench model.yaml --kernel lvm": "Did you mean 'llvm'?",
}


@pytest.mark.parametrize("command", SAID)
def test_what_is_meant_is_named(command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "model.yaml").write_text(SOUND)
    monkeypatch.chdir(tmp_path)
    done = CliRunner().invoke(cli, command.split(), catch_exceptions=False)
    assert done.exit_code == 2 and SAID[command] in done.stderr
