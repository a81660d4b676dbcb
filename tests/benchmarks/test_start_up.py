"""The start-up benchmark gives every figure, and no figure of a command that fails."""

from __future__ import annotations

from pathlib import Path

import pytest
import start_up

SOURCE = Path(__file__).parents[2] / "src"


def test_every_command_is_measured_in_both_states(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(start_up, "COMMANDS", {"python": ("-c", ""), "help": ("-m", "linkwright", "--help")})
    start_up.main(["--repeat", "1", "--before", str(SOURCE)])
    rows = [line.split() for line in capsys.readouterr().out.splitlines()]
    assert [row[:2] for row in rows] == [[name, state] for name in ("python", "help") for state in ("now", "before")]
    assert all(float(row[2]) > 0 for row in rows)


def test_a_state_is_that_of_its_folder(tmp_path: Path) -> None:
    (tmp_path / "linkwright").mkdir()
    (tmp_path / "linkwright" / "__init__.py").write_text("raise SystemExit(3)", "utf-8")
    with pytest.raises(RuntimeError, match="ended with 3"):
        start_up.seconds(("-c", "import linkwright"), tmp_path)
