#!/usr/bin/env python3
"""Makes the virtual environment of this checkout when needed and runs one command in it.

    python3 dev.py run FILE [options]   any linkwright command: run, check, schema, ...
    python3 dev.py --help               this text, then linkwright's own help

    python3 dev.py test [options]       the tests (pytest's options)
    python3 dev.py lint                 ruff check, ruff format --check, mypy
    python3 dev.py smoke [names]        examples, and the snippets of README.md and docs/
    python3 dev.py web [--check]        the pages' scripts from web/: built, or checked against their sources
    python3 dev.py all                  what CI does: lint, web --check, smoke, test
    python3 dev.py bench [options]      benchmarks/run.py; with a FILE, linkwright's own bench of its kernels

The environment is .venv beside this file, or the folder that LINKWRIGHT_VENV names. The
system's Python is left alone. The first call takes about a minute, later ones set up nothing
until pyproject.toml changes.
"""

import contextlib
import hashlib
import importlib.util
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import IO

OLDEST = (3, 11)
# Before anything that an older Python stumbles over: it has to get as far as the message.
if sys.version_info < OLDEST:
    found = ".".join(map(str, sys.version_info[:3]))
    sys.stderr.write(f"dev.py: linkwright needs Python 3.11 or newer; {sys.executable} is Python {found}\n")
    sys.exit(2)

ROOT = Path(__file__).resolve().parent
VENV = Path(os.environ.get("LINKWRIGHT_VENV") or ROOT / ".venv").expanduser().absolute()
PYTHON = VENV / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
STAMP = VENV / "linkwright-stamp.json"
LOCK = VENV / "linkwright-lock"

BASE = "base"  # stands for the install without extras in a set of extras


class SetupError(Exception):
    """The environment can't be had: a line for the user and the exit code."""

    def __init__(self, message: str, code: int) -> None:
        super().__init__(message)
        self.code = code


def stamp_key() -> str:
    """A hash of what an install depends on: pyproject.toml, this checkout's place, the venv's Python."""
    parts = [(ROOT / "pyproject.toml").read_bytes(), os.fsencode(ROOT), os.fsencode(PYTHON.resolve())]
    return hashlib.sha256(b"\0".join(parts)).hexdigest()


def installed() -> set[str]:
    """The extras that are installed and up to date; empty when nothing is."""
    try:
        stamp = json.loads(STAMP.read_text(encoding="utf-8"))
        return set(stamp["extras"]) if stamp["key"] == stamp_key() else set()
    except (OSError, ValueError, KeyError, TypeError):
        return set()


def write_stamp(extras: set[str]) -> None:
    part = STAMP.with_suffix(".part")
    part.write_text(json.dumps({"key": stamp_key(), "extras": sorted(extras)}), encoding="utf-8")
    part.replace(STAMP)


@contextlib.contextmanager
def locked() -> Iterator[None]:
    """Waits for the lock of the environment; the system frees it when the process ends, however it ends."""
    with LOCK.open("a+b") as handle:
        if sys.platform == "win32":
            import msvcrt

            handle.seek(0)
            while True:
                with contextlib.suppress(OSError):  # it gives up after ten seconds; setting up takes longer
                    msvcrt.locking(handle.fileno(), msvcrt.LK_LOCK, 1)
                    break
        else:
            import fcntl

            with contextlib.suppress(OSError):  # a file system without locks
                fcntl.flock(handle, fcntl.LOCK_EX)
        yield


def quietly(*command: str | Path) -> subprocess.CompletedProcess[str]:
    """Runs a command of the set-up; what it says is kept for the case that it fails."""
    return subprocess.run(
        [str(word) for word in command],
        cwd=ROOT,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        encoding="utf-8",
        errors="replace",
    )


def must(done: subprocess.CompletedProcess[str], what: str) -> None:
    if done.returncode:
        raise SetupError(f"{done.stdout}dev.py: {what} failed, see above", done.returncode)


def pip(*arguments: str) -> subprocess.CompletedProcess[str]:
    return quietly(PYTHON, "-m", "pip", "install", "--progress-bar", "off", *arguments)


def refuse_without_ensurepip() -> None:
    if importlib.util.find_spec("ensurepip") is None or importlib.util.find_spec("venv") is None:
        package = f"python{sys.version_info[0]}.{sys.version_info[1]}-venv"
        raise SetupError(
            f"dev.py: {sys.executable} can't make virtual environments (no ensurepip); "
            f"on Debian and Ubuntu: sudo apt install {package}",
            2,
        )


def make_venv() -> None:
    """Makes the environment if it isn't there, and mends one without pip or with its Python gone."""
    if not PYTHON.exists():
        for link in PYTHON.parent.glob("python*"):
            if not link.exists():  # it points at a Python that was taken away; venv would leave it so
                link.unlink()
        must(quietly(sys.executable, "-m", "venv", VENV), f"making {VENV}")
    if quietly(PYTHON, "-m", "pip", "--version").returncode:
        must(quietly(PYTHON, "-m", "ensurepip", "--upgrade"), f"installing pip in {VENV}")


def chinese() -> bool:
    """Whether the system speaks Chinese, as ``src/linkwright/cli/language.py`` decides."""
    names = (os.environ.get(name) for name in ("LC_ALL", "LC_MESSAGES", "LANG", "LANGUAGE"))
    system = next(filter(None, names), None)
    if system is None and sys.platform == "win32":
        import ctypes

        return bool(ctypes.windll.kernel32.GetUserDefaultUILanguage() & 0x3FF == 0x04)
    return (system or "").lower().startswith("zh")


def ensure(wanted: set[str]) -> None:
    """Brings the environment up to pyproject.toml with at least the extras wanted.

    The stamp is away while pip works, so that an interrupted install is redone.
    """
    if wanted <= installed():
        return
    if not PYTHON.exists():
        refuse_without_ensurepip()
    VENV.mkdir(parents=True, exist_ok=True)
    with locked():
        have = installed()
        missing = wanted - have
        if not missing:  # another call has installed it meanwhile
            return
        name = ".venv" if VENV == ROOT / ".venv" else str(VENV)
        line = f"updating {name}" if PYTHON.exists() else f"setting up {name} (once, about a minute)"
        if chinese():
            line = f"正在更新 {name}" if PYTHON.exists() else f"正在创建 {name}（仅首次，约一分钟）"
        print(line, file=sys.stderr, flush=True)
        make_venv()
        STAMP.unlink(missing_ok=True)
        extras = ",".join(sorted(missing - {BASE}))
        done = pip("-e", f".[{extras}]" if extras else ".")
        if done.returncode and have:
            write_stamp(have)  # pip refused before it changed anything; what was there still holds
        must(done, "pip install")
        if "test" in missing:
            install_engines()
        write_stamp(have | missing)


def install_engines() -> None:
    """Installs the engines that tests compare with where there is a wheel; their tests skip elsewhere."""
    import tomllib

    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    for engine in project.get("optional-dependencies", {}).get("engines", []):
        if pip("--only-binary", ":all:", engine).returncode:
            print(f"no wheel of {engine} here: the tests against it are skipped", file=sys.stderr)


def run(*command: str, cwd: Path | None = None, said: IO[str] | None = None) -> int:
    """Runs the environment's Python, in the user's folder and to the user's terminal unless told; a signal becomes 128
    + its number."""
    errors = None if said is None else subprocess.STDOUT
    code = subprocess.run([str(PYTHON), *command], cwd=cwd, stdout=said, stderr=errors).returncode
    return 128 - code if os.name != "nt" and code < 0 else code


def linkwright(arguments: list[str]) -> int:
    return run("-m", "linkwright", *arguments)


def test(arguments: list[str]) -> int:
    own = ("-n", "-p", "-x", "-s", "--pdb", "--trace", "--dist", "--numprocesses", "--exitfirst")
    # Neighbours stay together with worksteal: they share fixtures and compiled kernels.
    workers = [] if any(argument.startswith(own) for argument in arguments) else ["-n", "auto", "--dist", "worksteal"]
    return run("-m", "pytest", *workers, *arguments, cwd=ROOT)


def lint(arguments: list[str], said: IO[str] | None = None) -> int:
    checks = (["ruff", "check"], ["ruff", "format", "--check"], ["mypy"], ["mypy", "dev.py", "tools"])
    return first_failure(run("-m", *check, *arguments, cwd=ROOT, said=said) for check in checks)


def smoke(arguments: list[str]) -> int:
    return run("tools/smoke.py", *arguments, cwd=ROOT)


def web(arguments: list[str], said: IO[str] | None = None) -> int:
    return run("tools/web.py", *arguments, cwd=ROOT, said=said)


def bench(arguments: list[str]) -> int:
    if any(argument.endswith((".yaml", ".yml")) for argument in arguments):
        return linkwright(["bench", *arguments])
    return run("benchmarks/run.py", *arguments, cwd=ROOT)


def everything(arguments: list[str]) -> int:
    """All of it, also after a failure; the tests last, so that their summary closes the output.

    mypy keeps one core busy: smoke runs beside it, and lint and web have their say afterwards.
    """
    codes = {}
    with tempfile.TemporaryFile("w+", encoding="utf-8", errors="replace") as said, ThreadPoolExecutor(1) as beside:
        linted = beside.submit(lint, [], said)
        checked = beside.submit(web, ["--check"], said)
        print("--- smoke", flush=True)
        codes["smoke"] = smoke([])
        codes["lint"], codes["web"] = linted.result(), checked.result()
        said.seek(0)
        print(f"--- lint, web\n{said.read()}--- test", flush=True)
    codes["test"] = test([])
    failed = [name for name, code in codes.items() if code]
    if failed:
        print(f"failed: {', '.join(failed)}", flush=True)
    return first_failure(codes.values())


def first_failure(codes: Iterable[int]) -> int:
    return next(filter(None, list(codes)), 0)


TASKS: dict[str, tuple[Callable[[list[str]], int], set[str]]] = {
    "test": (test, {BASE, "test"}),
    "lint": (lint, {BASE, "dev"}),
    "smoke": (smoke, {BASE, "test"}),
    "web": (web, {BASE, "test"}),
    "bench": (bench, {BASE, "test"}),
    "all": (everything, {BASE, "dev", "test"}),
}


def main(arguments: list[str]) -> int:
    command = arguments[0] if arguments else "help"
    if command in ("help", "-h", "--help"):
        print(__doc__, flush=True)
        if command != "--help":
            return 0
    try:
        if command in TASKS:
            task, extras = TASKS[command]
            ensure(extras)
            return task(arguments[1:])
        ensure({BASE})
        return linkwright(arguments)
    except SetupError as error:
        print(error, file=sys.stderr)
        return error.code
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
