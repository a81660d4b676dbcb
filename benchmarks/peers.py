"""linkwright against other engines: ``python benchmarks/peers.py [--json] [--poses 1000000] [--rounds 5]``.

Needs the extra ``peers``; an engine that isn't installed is left out, and said.

The paper feeder's 18 outputs (positions, rates, reactions, torque) against Exudyn and MuJoCo, a four-bar against
pylinkage's compiled path. All take turns, in rounds: times are medians, ratios those of the rounds. Errors are the
largest at 60 poses of a turn, against 50 digits (exact.py).

A pose of Exudyn or MuJoCo is a step of integration in time, and small errors need many steps a turn: ``of 200`` is the
ratio where 200 poses a turn are wanted.
"""

from __future__ import annotations

import argparse
import importlib.util
import json
import math
import os
import platform
import statistics
from collections.abc import Iterator, Sequence
from typing import Any

import exact
import numpy as np
from contest import Array, Way, contest, linkwright_ways
from run import FEEDER, OUTPUTS

import linkwright as lw

STEPS = 1800
"""Steps a turn of the engines that integrate in time: Exudyn and MuJoCo's RK4 come to 0.01 N with them."""
WANTED = 200
POSITIONS = ["B.x", "B.y", "C.x", "C.y"]
RATES = [f"{point}.{k}{axis}" for point in "BC" for k in ("", "v", "a") for axis in "xy"]
SHOWN = {"position_mm": "mm", "acceleration_m_s2": "m/s2", "force_N": "N", "torque_Nm": "N m"}
"""The errors that the tables show."""
Figures = dict[str, Any]


def kind(name: str) -> str:
    """Of what kind an output is, with the unit of its error."""
    if name.startswith("force"):
        return "force_N"
    if name.endswith(("torque", "alpha", "omega")):
        return {"torque": "torque_Nm", "omega": "omega_rad_s", "alpha": "alpha_rad_s2"}[name.rpartition(".")[2]]
    return {"": "position_mm", "v": "velocity_m_s", "a": "acceleration_m_s2"}[name.rpartition(".")[2][:-1]]


def errors(names: Sequence[str], found: Array, true: Array) -> dict[str, float | None]:
    """The largest error of each kind; None of what an engine doesn't give."""
    worst: dict[str, float | None] = {}
    for name, off in zip(names, np.abs(found - true).max(axis=1), strict=True):
        unit = kind(name)
        size = off * (1000 if unit == "position_mm" else 1)
        before = worst.get(unit, 0.0)
        worst[unit] = None if before is None or math.isnan(size) else max(before, float(size))
    return worst


def compared(names: Sequence[str], ways: Sequence[Way], true: Array, rounds: int) -> Figures:
    """Times, errors and ratios to linkwright's fastest way."""
    contest(ways, rounds)
    best = min((way for way in ways if way.engine == "linkwright"), key=Way.ns)
    rows = []
    for way in ways:
        assert way.found is not None
        ratios = way.ratios(best)
        row = {"engine": way.engine, "how": way.how, "ns_per_pose": way.ns(), "ratio": statistics.median(ratios)}
        row["ratio_range"] = [min(ratios), max(ratios)]
        if way.steps:
            row["ratio_of_200"] = row["ratio"] * way.steps / WANTED
        rows.append({**row, "errors": errors(names, way.found, true)})
    return {"outputs": len(names), "fastest": best.how, "rows": rows}


def feeder(poses: int, rounds: int, steps: int, skipped: list[str]) -> Figures:
    """The paper feeder against Exudyn and MuJoCo."""
    compiled = lw.compile(lw.load(FEEDER))
    samples = 1.5 * np.arange(1, 61) / 60
    ways = list(linkwright_ways(compiled, OUTPUTS, np.linspace(0.0, 1.5, poses), samples, skipped))
    if there("exudyn", skipped):
        import feeder_exudyn

        ways.append(feeder_exudyn.integrated(steps))
    if there("mujoco", skipped):
        import feeder_mujoco

        ways += feeder_mujoco.ways(compiled, samples, steps)
    return compared(OUTPUTS, ways, exact.reference(exact.feeder, OUTPUTS, samples), rounds)


def four_bars(poses: int, rounds: int, skipped: list[str]) -> Iterator[tuple[str, Figures]]:
    """A four-bar against pylinkage: positions, and with velocities and accelerations."""
    compiled = lw.compile(four_bar())
    t = np.arange(1, poses + 1) / poses
    pick = np.linspace(0, poses - 1, 60).astype(int)
    for what, names in (("four_bar_positions", POSITIONS), ("four_bar_rates", RATES)):
        ways = list(linkwright_ways(compiled, names, t, t[pick], skipped))
        if all(there(package, skipped) for package in ("pylinkage", "numba")):
            import four_bar_pylinkage

            ways.append(four_bar_pylinkage.way(poses, pick, names is RATES))
        yield what, compared(names, ways, exact.reference(exact.four_bar, names, t[pick]), rounds)


def four_bar() -> lw.Document:
    """The four-bar of exact.py."""
    build = lw.Builder("four-bar", length="m", angle="rad")
    for name, value in exact.FOUR_BAR.items():
        build.parameter(name, value)
    return (
        build.frame(A=[0, 0], D=["AD", 0])
        .link("crank", A=[0, 0], B=["AB", 0])
        .link("coupler", B=[0, 0], C=["BC", 0])
        .link("rocker", D=[0, 0], C=["CD", 0])
        .assembly("C", "left of B-D")
        .drive("motor", turns="crank", speed=2 * math.pi, start=0.5)
        .build()
    )


def there(package: str, skipped: list[str]) -> bool:
    """Whether a package is installed; if not, that is noted."""
    if importlib.util.find_spec(package) is not None:
        return True
    skipped.append(f"{package} isn't installed (pip install {package})")
    return False


def measure(poses: int, rounds: int, steps: int = STEPS) -> Figures:
    """All figures."""
    skipped: list[str] = []
    figures: Figures = {"machine": {"python": platform.python_version(), "cores": os.cpu_count()}, "poses": poses}
    figures["paper_feeder"] = feeder(poses, rounds, steps, skipped)
    figures |= four_bars(poses, rounds, skipped)
    return figures | {"skipped": list(dict.fromkeys(skipped))}


def lines(figures: Figures) -> Iterator[str]:
    """The figures as tables."""
    for title in ("paper_feeder", "four_bar_positions", "four_bar_rates"):
        part = figures[title]
        yield f"{title}: {part['outputs']} outputs; ratios to {part['fastest']}"
        for row in part["rows"]:
            of_200 = f"{row['ratio_of_200']:10.3g} of 200" if "ratio_of_200" in row else " " * 17
            line = f"  {row['engine']:10s} {row['how']:44s}{row['ns_per_pose']:10.4g} ns{row['ratio']:10.3g}{of_200}  "
            off = ((unit, row["errors"][unit]) for unit in row["errors"] if unit in SHOWN)
            yield line + ", ".join(f"{'none' if e is None else f'{e:.1e}'} {SHOWN[unit]}" for unit, e in off)
        yield ""
    yield from (f"left out: {reason}" for reason in figures["skipped"])


def main() -> None:
    """Print the figures, as tables or as JSON."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.add_argument("--poses", type=int, default=1_000_000, help="poses of linkwright and pylinkage")
    parser.add_argument("--rounds", type=int, default=5, help="rounds that the medians are taken of")
    options = parser.parse_args()
    figures = measure(options.poses, options.rounds)
    print(json.dumps(figures, indent=2) if options.json else "\n".join(lines(figures)))


if __name__ == "__main__":
    main()
