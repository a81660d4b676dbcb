"""Columns of the matrix: the page, exports, copies, change points."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from combinations.mechanisms import Mechanism
from combinations.motions import (
    CLOSE,
    Faults,
    column,
    differences,
    moving_signals,
    named,
    reference,
    swinging,
    turning,
    usual_size,
)
from combinations.performing import Data, run, written_for
from helpers.pages import run_data
from linkwright.exports import TARGETS
from linkwright.model.document import dump, parse_document
from linkwright.report.build import report_data


@column("keep", "other")
def _keep(mechanism: Mechanism) -> Faults:
    """Where no change point is passed, ``through: keep`` changes nothing."""
    data = turning(mechanism)
    data["studies"]["cycle"]["through"] = "keep"
    yield from differences(reference(named(mechanism), full=True), run(data).cycle.result)


# The page.


@column("page", "other")
def _page(mechanism: Mechanism) -> Faults:
    """With another length, a live page has what a run of the lines has that it offers for that."""
    data = turning(mechanism)
    data["measures"] = {}
    document = parse_document(data)
    assert document is not None
    text = dump(document)
    job = run(data, files=True)
    live: Any = report_data(document, job.outcomes, text=text).get("live")
    if not live:
        yield "the page isn't live"
        return
    program = live["program"]
    numbers = {one["name"]: one for one in live["numbers"]}
    moved = dict(zip(program["free"], program["values"], strict=True))
    if not numbers[mechanism.varied]["locked"]:
        moved[mechanism.varied] *= 1.001
        data["parameters"][mechanism.varied]["value"] = 1e3 * moved[mechanism.varied]
    times = np.array(live["times"])
    found = run_data(live["code"], program, times, np.array([[moved[name] for name in program["free"]]]))
    if found.failures[0] is not None:
        yield f"the page has no motion: {found.failures[0]}"
        return
    true = run(data).cycle.result.run
    rows = true.compiled.evaluate(live["signals"], times * (true.stop / times[-1]))
    first = 4 * len(live["poses"])
    here = found.rows[0, first : first + len(live["signals"])]
    for i, name in enumerate(live["signals"]):
        off = np.abs(here[i] - rows[i])
        if i in live["wrapped"]:
            off = np.abs(np.exp(1j * here[i]) - np.exp(1j * rows[i]))
        size = max(
            float(np.nanmax(np.abs(rows[k]))) for k, unit in enumerate(live["units"]) if unit == live["units"][i]
        )
        # Where a curve jumps or bends, the page may take either side.
        if not np.nanquantile(off, 0.9) <= 1e-7 * max(size, 1e-9):
            yield f"{name} on the page is off by {np.nanquantile(off, 0.9) / size:.1e}"


# Exports.


def _export(target: str) -> Callable[[Mechanism], Faults]:
    def perform(mechanism: Mechanism) -> Faults:
        data = turning(mechanism)
        job = written_for(data, target)
        error = job.summary.get("max_error", 0.0)
        if not error < 1e-8:
            yield f"the export is off by {error}"

    return perform


for _name in TARGETS:
    column(f"{_name}", "export")(_export(_name))


# Copies.


OUTSIDE = ("linkwright", "name", "units", "gravity", "studies", "measures", "stiffness")


def copied(mechanism: Mechanism, **second: Any) -> Data:
    """Two copies of the mechanism with its motor."""
    data = swinging(mechanism)
    unit = {section: data.pop(section) for section in [*data] if section not in OUTSIDE}
    data["links"] = {"frame": {"points": {"Z": [0, 900]}}}
    data["subassemblies"] = {"unit": unit}
    data["copies"] = {"one": {"of": "unit"}, "two": {"of": "unit", **second}}
    return data


@column("copy", "other")
def _copy(mechanism: Mechanism) -> Faults:
    """Both copies move as the mechanism; the second one is displaced."""
    result = run(copied(mechanism, at=[0.3 * 1000, 0])).cycle.result
    true = reference(named(mechanism))
    for name in moving_signals(true):
        for copy, shift in (("one", 0.0), ("two", 0.3)):
            if f"{copy}_{name}" not in result.names:
                continue
            expected = true[name] + (shift if name.endswith(".x") else 0.0)
            off = np.abs(result[f"{copy}_{name}"] - expected).max()
            if not off <= CLOSE * max(1e-3, usual_size(true, name)):
                yield f"{copy}_{name} differs by {off:.1e}"


def element_of(name: str) -> str:
    """The element of a signal."""
    return name.partition(".")[0]


def turned_off(angles: Any, wanted: float) -> float:
    """How far angles are from one, whole turns apart."""
    return float(np.abs(np.exp(1j * angles) - np.exp(1j * wanted)).max())


SIGNS = {"x": -1, "vx": -1, "ax": -1, "omega": -1, "alpha": -1}


@column("mirrored copy", "other")
def _mirrored(mechanism: Mechanism) -> Faults:
    """The second copy moves as the mirror image: links turn the other way round from half a turn, what two moving links
    have between them from 0."""
    result = run(copied(mechanism, mirrored=True)).cycle.result
    true = reference(named(mechanism))
    for name in moving_signals(true):
        attribute = name.rpartition(".")[2]
        if f"two_{name}" not in result.names:
            continue
        sign = -1 if name.startswith(mechanism.circling) else SIGNS.get(attribute, 1)
        expected, found = sign * true[name], result[f"two_{name}"]
        if attribute == "angle":
            links = result.run.compiled.mechanism.links
            half = math.pi if f"two_{element_of(name)}" in links or name == "motor.angle" else None
            off = min(turned_off(found + true[name], end) for end in ((half,) if half else (0.0, math.pi)))
        else:
            off = np.abs(found - expected).max()
        if not off <= CLOSE * max(1e-3, usual_size(true, name)):
            yield f"two_{name} differs by {off:.1e}"
    torque = result["two_motor.torque"] + true["motor.torque"]
    if not np.abs(torque).max() <= CLOSE * max(np.abs(true["motor.torque"]).max(), 1e-6):
        yield "the torque of the mirrored motor isn't the opposite one"
