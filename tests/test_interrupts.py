"""No module that a run imports passes over an interrupt: those that would are deaf to it."""

from __future__ import annotations

import ast
import subprocess
import sys
from pathlib import Path

import pytest

from app.models import SOUND
from linkwright.cli import cli
from linkwright.interrupts import SWALLOWING

ONLY_AT_IMPORT = ("ruamel/yaml/main.py",)
ONLY_OF_TAGS = ("ruamel/yaml/constructor.py",)  # which a model file can't have


def swallows(handler: ast.ExceptHandler) -> bool:
    everything = handler.type is None or (isinstance(handler.type, ast.Name) and handler.type.id == "BaseException")
    return everything and not any(isinstance(node, ast.Raise) for node in ast.walk(handler))


def test_modules_that_swallow_interrupts_are_deaf(tmp_path: Path) -> None:
    path = tmp_path / "model.yaml"
    path.write_text(SOUND, "utf-8")
    with pytest.raises(SystemExit) as end:
        cli(["run", str(path), "-q"])
    assert end.value.code == 0
    found = set()
    for needed in ("click", "numpy", "pydantic", "pydantic_core", "ruamel"):
        modules = [module for name, module in sys.modules.items() if name.split(".")[0] == needed]
        for file in {Path(module.__file__) for module in modules if getattr(module, "__file__", None)}:
            if file.suffix == ".py" and "except" in (text := file.read_text("utf-8")):
                handlers = [node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.ExceptHandler)]
                if any(map(swallows, handlers)):
                    found.add(file.as_posix().partition("/site-packages/")[2])
    assert found == {*SWALLOWING, *ONLY_AT_IMPORT, *ONLY_OF_TAGS}


WHILE_BUILT = """\
import os, signal, time
from pydantic import BaseModel, TypeAdapter
from pydantic_core import core_schema
from linkwright.interrupts import install

class Striking:
    def __repr__(self):
        os.kill(os.getpid(), signal.SIGINT)
        return "striking"

class Chosen:
    @classmethod
    def __get_pydantic_core_schema__(cls, source, handler):
        return core_schema.literal_schema([Striking()])

install()
try:
    BUILD
    time.sleep(5)
except KeyboardInterrupt:
    print("interrupted")
"""


@pytest.mark.parametrize(
    "build", ["type('Model', (BaseModel,), {'__annotations__': {'a': Chosen}})", "TypeAdapter(Chosen)"]
)
def test_an_interrupt_while_pydantic_builds_a_validator_is_one(build: str) -> None:
    command = [sys.executable, "-c", WHILE_BUILT.replace("BUILD", build)]
    result = subprocess.run(command, capture_output=True, encoding="utf-8", timeout=60, check=False)
    assert (result.stdout, result.stderr) == ("interrupted\n", "")
