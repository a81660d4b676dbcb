"""Builds the wheel, installs it alone into an environment of its own, and runs the founding cases from an empty folder.

    python tools/wheel_cases.py [names]

Each is what a user does after an install: `linkwright new NAME`, `linkwright run NAME.yaml`. It must end with 0 and
without findings, its certificate sound, and its page must name the paper. The other packages are those of the Python
that runs this, but for the linkwright of this checkout. The wheel is built by the hatchling that is installed; where
there is none, pip fetches it.
"""

import importlib.util
import json
import os
import subprocess
import sys
import sysconfig
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from html import escape
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
AT_ONCE = 2
TIMEOUT = 300.0  # seconds for one command
SOUND = 1e-9

CASES = {
    "accuracy": "尺寸误差对平面四杆机构运动精度的影响",
    "cam": "A quickly entity modeling method for planar cam based on Pro/Mechanism",
    "feeder": "Kinematics and Dynamics Simulation Analysis of Packaging Paper Feeding Mechanism",
    "five-bar": "Study on the workspace of hybrid-driven planar five-bar parallel mechanism",
    "hinge": "Kinematic Setup of Four-Bar Mechanism Based on Tecnomatix",
}
"""Models of the gallery and the titles of their papers."""


class Failure(Exception):
    """What went wrong, in words."""


def call(words: list[str | Path], place: Path) -> str:
    """Runs a command as a user does: no variable leads to this checkout or its Python."""
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "VIRTUAL_ENV"))}
    done = subprocess.run(
        [str(word) for word in words],
        cwd=place,
        env=kept | {"PYTHONUTF8": "1"},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        encoding="utf-8",
        timeout=TIMEOUT,
    )
    if done.returncode:
        raise Failure(f"{' '.join(map(str, words))} ends with {done.returncode}:\n{done.stdout}")
    return done.stdout


def install_wheel(folder: Path) -> Path:
    """An environment with the wheel in it; the folder of its commands."""
    alone = ["--no-build-isolation"] if importlib.util.find_spec("hatchling") else []
    pip = [sys.executable, "-m", "pip", "--disable-pip-version-check"]
    call([*pip, "wheel", "-q", "--no-deps", *alone, "-w", folder / "wheel", ROOT], folder)
    (wheel,) = (folder / "wheel").glob("linkwright-*.whl")
    call([sys.executable, "-m", "venv", "--without-pip", folder / "env"], folder)
    commands = folder / "env" / ("Scripts" if os.name == "nt" else "bin")
    call([*pip, "--python", commands / "python", "install", "-q", "--no-deps", "--no-index", wheel], folder)
    where = "import sysconfig; print(sysconfig.get_path('purelib'))"
    packages = Path(call([commands / "python", "-c", where], folder).strip())
    (packages / "others.pth").write_text(sysconfig.get_path("purelib") + "\n", encoding="utf-8")
    found = call([commands / "python", "-c", "import linkwright; print(linkwright.__file__)"], folder).strip()
    if not Path(found).is_relative_to(packages):
        raise Failure(f"linkwright comes from {found}, not from the wheel")
    return commands


def run_case(name: str, commands: Path, folder: Path) -> tuple[bool, str]:
    """Starts and runs one case in an empty folder; whether that went well, and a line or more on it."""
    place, start = folder / name, time.perf_counter()
    place.mkdir()
    try:
        call([commands / "linkwright", "new", name], place)
        call([commands / "linkwright", "run", f"{name}.yaml"], place)
        check_results(place / f"{name}_linkwright", CASES[name])
    except (Failure, subprocess.TimeoutExpired) as problem:
        return False, f"FAIL {name}: {problem}"
    return True, f"ok   {time.perf_counter() - start:6.1f} s  {name}"


def check_results(results: Path, paper: str) -> None:
    """Looks at the results. Raises :class:`Failure`."""
    summary = json.loads((results / "summary.json").read_text(encoding="utf-8"))
    if summary["findings"] or not summary["done"]:
        raise Failure(f"findings: {summary['findings']}")
    certificate = summary["certificate"]
    if max(certificate[proof] or 0.0 for proof in ("closure", "equilibrium", "power", "work")) > SOUND:
        raise Failure(f"the certificate isn't sound: {certificate}")
    page = (results / "report.html").read_text(encoding="utf-8")
    source = page.partition('<p class="source">')[2].partition("</p>")[0]
    if escape(paper) not in source:
        raise Failure(f"the page doesn't name its paper, {paper}")


def main(names: list[str]) -> int:
    with tempfile.TemporaryDirectory(prefix="linkwright-wheel-") as name, ThreadPoolExecutor(AT_ONCE) as pool:
        folder = Path(name)
        try:
            commands = install_wheel(folder)
        except Failure as problem:
            print(f"FAIL {problem}")
            return 1
        outcomes = list(pool.map(partial(run_case, commands=commands, folder=folder), names or CASES))
    print("\n".join(line for _, line in outcomes))
    return 0 if all(well for well, _ in outcomes) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
