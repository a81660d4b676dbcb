"""Columns of the matrix: the studies."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from combinations.mechanisms import Mechanism, add_to_frame
from combinations.motions import CLOSE, SAMPLES, Faults, column, start_of, swinging, turning
from combinations.performing import run


@column("cycle", "study")
def _cycle(mechanism: Mechanism) -> Faults:
    """A revolution; its average power is what loads and friction take."""
    job = run(turning(mechanism), files=True)
    result = job.cycle.result
    if not np.allclose(result["crank.omega"], 2 * math.pi, rtol=1e-12):
        yield "the crank doesn't turn as the motor is told"
    travel = figures_of(job.cycle.measures)["travel"]
    sampled = float(np.ptp(result[mechanism.signal]))
    if not travel >= sampled * (1 - 1e-9):
        yield f"the travel {travel} is less than that of the samples, {sampled}"


@column("limits", "study")
def _limits(mechanism: Mechanism) -> Faults:
    data = turning(mechanism)
    data["studies"] = {"limits": {"samples": 90}}
    job = run(data, files=True)
    ranges = job.summary["limits"]["drives"]["motor"]["ranges"]
    if not any(abs(one["high"]["at"] - one["low"]["at"] - 360) < 1e-9 for one in ranges):
        yield "the motor turns fully, but limits says that it doesn't"


@column("modes", "study")
def _modes(mechanism: Mechanism) -> Faults:
    data = turning(mechanism)
    data["studies"] = {"modes": {"drive": "motor"}}
    run(data, files=True)
    yield from ()


@column("sweep", "study")
def _sweep(mechanism: Mechanism) -> Faults:
    """Each sample is a run of the file with its value."""
    data = turning(mechanism)
    size = mechanism.nominal
    values = [size - 0.01, size, size + 0.01]
    data["studies"]["sweep"] = {"vary": {mechanism.varied: values}, "outputs": ["travel", "torque", mechanism.signal]}
    sweep = run(data, files=True).outcomes["sweep"]
    if sweep.failed:
        yield f"{sweep.failed} samples fail"
        return
    other = turning(mechanism)
    other["parameters"][mechanism.varied] = {"value": values[-1]}
    expected = figures_of(run(other).cycle.measures)
    for row, statistics in zip(sweep.table.figures, sweep.measures, strict=True):
        if mechanism.drawn and statistics.column.measure != "travel":
            continue  # of all samples what the drawn pose fixes is that of the nominal lengths
        yield from alike(statistics.column.name, float(row[-1]), expected)


def figures_of(measures: Any) -> dict[str, float]:
    """The figures of measures, as other studies name them."""
    return {f"{one.name} {found.label}".strip(): found.value for one in measures for found in one.found}


def alike(name: str, value: float, expected: dict[str, float]) -> Faults:
    """Whether a figure is that of the run."""
    size = max(abs(other) for other in expected.values())
    if not abs(value - expected[name]) <= CLOSE * size:
        yield f"{name} is {value}, in the run {expected[name]}"


@column("accuracy", "study")
def _accuracy(mechanism: Mechanism) -> Faults:
    """What it has as nominal is what the run gives."""
    data = turning(mechanism)
    data["studies"]["accuracy"] = {"outputs": ["travel", "torque", mechanism.signal], "samples": 40, "poses": SAMPLES}
    job = run(data, files=True)
    expected = figures_of(job.cycle.measures)
    for name, figure in job.accuracy.every.items():
        if name in expected:
            yield from alike(name, figure.nominal, expected)


@column("cam", "study")
def _cam(mechanism: Mechanism) -> Faults:
    data = turning(mechanism)
    data["studies"] = {"cam": {"steps": 90}}
    run(data, files=True)
    yield from ()


@column("reactions", "study")
def _reactions(mechanism: Mechanism) -> Faults:
    """A strut that holds the crank in place of the motor has the motor's torque at rest."""
    data = mechanism.data
    x, y = start_of(mechanism)
    data["parameters"]["hold_length"] = f"hypot({x} + 50, {y} - 40)"
    add_to_frame(data, "S0", [-50, 40])
    data["links"]["holder"] = {"points": {"S0": [0, 0], "B": ["hold_length", 0]}}
    if "sketch" not in data:  # lengths follow from its points
        data.setdefault("assembly", {})["B"] = [x, y]
    data["studies"] = {"reactions": {}}
    outcome = run(data, files=True).outcomes["reactions"]
    (force,) = (bar.force for bar in outcome.bars if bar.link == "holder")
    still = swinging(mechanism, turns="crank", on="frame", position=f"{mechanism.start} deg")
    still["studies"] = {"cycle": {"duration": "1 ms", "samples": 2}}
    torque = run(still).cycle.result["motor.torque"]
    q, radius = math.radians(mechanism.start), mechanism.radius
    bx, by = radius * math.cos(q), radius * math.sin(q)
    away = math.hypot(-50 - bx, 40 - by)
    arm = 1e-3 * (bx * (40 - by) - by * (-50 - bx)) / away
    if not abs(force * arm - torque[0]) <= 1e-9 * max(abs(torque[0]), 1e-3):
        yield f"the strut holds the crank with {force * arm} N m, the motor with {torque[0]}"


@column("workspace", "study")
def _workspace(mechanism: Mechanism) -> Faults:
    """The curve of the crank's pin is its circle."""
    data = turning(mechanism)
    data["studies"] = {"workspace": {"point": "B", "chord": 1e-3}}
    job = run(data, files=True)
    curve = job.summary["workspace"]["curves"][0]
    radius = mechanism.radius
    if abs(curve["length"] / (2 * math.pi * radius) - 1) > 1e-2:
        yield f"the circle of B is {curve['length']} long"


@column("workspace of two drives", "study")
def _region(mechanism: Mechanism) -> Faults:
    """An arm on the crank's pin reaches a ring."""
    data = turning(mechanism)
    data["links"]["arm"] = {"points": {"B": [0, 0], "P": [20, 0]}}
    data["drives"]["servo"] = {"turns": "arm", "on": "crank", "speed": "10 rpm", "start": 0}
    data["studies"] = {"workspace": {"point": "P", "chord": 1e-3}}
    job = run(data, files=True)
    radius = mechanism.radius
    ring = math.pi * ((radius + 20) ** 2 - (radius - 20) ** 2)
    area = job.summary["workspace"]["union"][0]["area"]
    if abs(area / ring - 1) > 1e-2:
        yield f"the ring is {area} large instead of {ring}"
