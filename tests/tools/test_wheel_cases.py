"""tools/wheel_cases.py: the founding cases from an installed wheel; they are the gallery's models with a source."""

import importlib.util
import subprocess
import sys
from pathlib import Path

import pytest

from linkwright import gallery

TOOL = Path(__file__).resolve().parents[2] / "tools" / "wheel_cases.py"


CASES = ["accuracy", "cam", "feeder", "hinge"]


@pytest.mark.parametrize("cases", [CASES, pytest.param([*CASES, "five-bar"], marks=pytest.mark.long)], ids=len)
def test_an_installed_package_starts_each_case_and_its_page_names_the_paper(cases: list[str]) -> None:
    """Workspaces take longest; they are held to the paper in ``tests/validation/test_peng_zi_workspace.py`` too."""
    done = subprocess.run([sys.executable, TOOL, *cases], capture_output=True, encoding="utf-8", timeout=570)
    assert done.returncode == 0, done.stdout + done.stderr


def test_the_cases_are_the_models_with_a_source() -> None:
    spec = importlib.util.spec_from_file_location("wheel_cases_under_test", TOOL)
    assert spec is not None and spec.loader is not None
    tool = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(tool)
    assert [*tool.CASES] == [name for name in gallery.names() if "\nsource:" in gallery.text(name)]
