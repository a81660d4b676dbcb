"""Columns of the matrix: the forms of drives."""

from __future__ import annotations

import math
import re
from collections.abc import Callable

import numpy as np

from combinations.mechanisms import Mechanism, add_to_frame
from combinations.motions import Faults, column, differences, named, reference, same_power, swing, swinging
from combinations.performing import Data, run
from linkwright.app.job import examine_document
from linkwright.laws.registry import LAWS
from linkwright.model.document import parse_document


@column("acceleration", "drive")
def _acceleration(mechanism: Mechanism) -> Faults:
    motor = {"turns": "crank", "on": "frame", "speed": "30 deg/s", "acceleration": "40 deg/s^2"}
    found = run(swinging(mechanism, **motor, start=f"{mechanism.start} deg")).cycle.result
    yield from differences(true := reference(named(mechanism)), found)
    yield from same_power(true, found)


@column("law", "drive")
def _law(mechanism: Mechanism) -> Faults:
    """A motion law by its closed form, u - sin(2 pi u)/(2 pi)."""
    data = swinging(mechanism, turns="crank", on="frame", position=f"{mechanism.start} deg + along(t)")
    data["laws"] = {**data.get("laws", {}), "along": law({"rise": 40, "over": 1, "law": "cycloidal"})}
    result = run(data).cycle.result
    u = result.t
    expected = np.radians(mechanism.start + 40 * (u - np.sin(2 * np.pi * u) / (2 * np.pi)))
    if not np.abs(result["crank.angle"] - expected).max() <= 1e-12:
        yield "the crank doesn't follow the law"


def law(*segments: Data) -> Data:
    """A law over the time that holds its last value."""
    return {"over": "time", "of": "angle", "beyond": "hold", "segments": [*segments]}


@column("all laws", "drive")
def _all_laws(mechanism: Mechanism) -> Faults:
    """Every registered law, one after the other, and every other kind of segment, in less than a second."""
    blend = {"rise": 1, "over": 0.02, "match": "acceleration"}
    segments: list[Data] = []
    for name, one in LAWS.items():
        rise = {"rise": 3, "over": 0.02, "law": name}
        meets = [rise, {"fall": 3, "over": 0.02, "law": name}] if one.mirrored else [rise]
        segments += [blend, *meets, blend] if min(one.continuity) < 1 else meets
    segments += [
        {"dwell": 0.02},
        {"rise": -10, "over": 0.05, "fractions": [0.25, 0.5, 0.25, 0]},
        {"rise": -5, "over": 0.05, "powers": [3, 4, 5]},
        {"rise": 5, "over": 0.05, "formula": "u - sin(2*pi*u)/(2*pi)"},
        {"control": [0, 0, 0, 2, 4, 4, 4], "over": 0.05},
        {"rise": 5, "over": 0.05, "law": "poly_345", "skew": 0.4},
        {"rise": 5, "over": 0.05, "match": "acceleration", "via": [[0.02, 2]]},
        {"dwell": 0.02},
        {"harmonics": [[1, 0], [-1, 0]], "over": 0.05},
        {"dwell": 0.02},
    ]
    data = swinging(mechanism, turns="crank", on="frame", position=f"{mechanism.start} deg + along(t)")
    data["laws"] = {**data.get("laws", {}), "along": law(*segments)}
    result = run(data).cycle.result
    if not np.isclose(result["crank.angle"][-1] - result["crank.angle"][0], np.radians(total(segments)), atol=1e-9):
        yield "the crank doesn't end where the law does"


def total(segments: list[Data]) -> float:
    """Where a law ends."""
    rises = (one.get("rise", 0) - one.get("fall", 0) + one.get("control", [0])[-1] for one in segments)
    return float(sum(rises))


@column("table", "drive")
def _table(mechanism: Mechanism) -> Faults:
    """A cubic spline through the motion's points is nearly the motion."""
    data = swinging(mechanism, turns="crank", on="frame", position=f"{mechanism.start} deg + along(t)")
    t = np.linspace(0, 1, 11)
    points = [[float(u), float(30 * u + 20 * u * u)] for u in t]
    data["tables"] = {**data.get("tables", {}), "along": {"points": points}}
    result = run(data).cycle.result
    if not np.allclose(result["crank.angle"], reference(named(mechanism))["crank.angle"], atol=2e-3):
        yield "the crank doesn't follow the table"


def pushed(mechanism: Mechanism) -> Data:
    """A block that a rod ties to the crank is driven along the frame."""
    q = swing(mechanism)
    data = swinging(mechanism, slides="block", on="frame", position=f"r*cos{q} + sqrt((150 mm)^2 - (r*sin{q})^2)")
    data["links"]["push"] = {"points": {"B": [0, 0], "W": [150, 0]}}
    data["links"]["block"] = {"points": {"W": [0, 0]}}
    way = {"prismatic": ["frame", "block"], "line": ["A at 0 deg", "W at 0 deg"]}
    data["joints"] = {**data.get("joints", {}), "way": way}
    return data


def extended(mechanism: Mechanism) -> Data:
    """A cylinder between the frame and the crank's pin is driven."""
    q = swing(mechanism)
    data = swinging(mechanism, extends="ram", position=f"hypot(r*cos{q} + 140 mm, r*sin{q} + 50 mm)")
    add_to_frame(data, "S0", [-140, -50])
    data["cylinders"] = {**data.get("cylinders", {}), "ram": {"from": "S0", "to": "B"}}
    return data


def moved(mechanism: Mechanism) -> Data:
    """The crank's pin is driven along a line of the frame."""
    motor = {"moves": "crank", "at": "B", "along": "A at 0 deg", "on": "frame"}
    return swinging(mechanism, **motor, position=f"r*cos{swing(mechanism)}")


def assembled(mechanism: Mechanism, data: Data) -> Data:
    """The file with the assembly modes that its groups ask for, as the findings on it say: the groups differ with the
    drive. Each is that of the motion with the motor on the crank."""
    true, q = reference(named(mechanism)), math.radians(mechanism.start)
    radius = float(true["B.x"][0]) / math.cos(q)
    places = {"W": [1e3 * (radius * math.cos(q) + math.sqrt(0.15**2 - (radius * math.sin(q)) ** 2)), 0]}
    lean = math.radians(mechanism.start - 50)
    places["P"] = [1e3 * radius * math.cos(q) + 40 * math.cos(lean), 1e3 * radius * math.sin(q) + 40 * math.sin(lean)]
    places |= {
        n[:-2]: [1e3 * float(true[n][0]), 1e3 * float(true[n[:-1] + "y"][0])] for n in true.names if n.endswith(".x")
    }
    if mechanism.drawn:
        data["assembly"] = {
            point: places[point] for link in data["links"].values() for point in link["points"] if point in places
        }
        for point in mechanism.data["links"]["frame"]["points"]:
            data["assembly"].pop(point, None)
    for _ in range(8):
        document = parse_document(data)
        assert document is not None
        rules = data.setdefault("assembly", {})
        before = dict(rules)
        for finding in examine_document(document).findings:
            if finding.code == "assembly.unused":
                rules.pop(finding.path[1], None)
            elif finding.code.startswith("assembly."):
                for point in re.findall(r"'?(\w+): ", finding.mend.partition("assembly: ")[2]):
                    if point in places:
                        rules[point] = places[point]
        if rules == before:
            break
    return data


FORMS = {"slides": pushed, "extends": extended, "moves": moved}


def _form(form: str) -> Callable[[Mechanism], Faults]:
    def perform(mechanism: Mechanism) -> Faults:
        found = run(assembled(mechanism, FORMS[form](mechanism))).cycle.result
        yield from differences(true := reference(named(mechanism)), found)
        yield from same_power(true, found)

    return perform


def _output(form: str) -> Callable[[Mechanism], Faults]:
    """A drive of the form with a law of the mechanism's output, along which that goes at constant speed."""

    def perform(mechanism: Mechanism) -> Faults:
        true = reference(named(mechanism))
        data = FORMS[form](mechanism) if form in FORMS else swinging(mechanism)
        rates = {"angle": ("omega", "rad"), "s": ("v", "m")}
        attribute = mechanism.signal.rpartition(".")[2]
        rate, unit = rates[attribute]
        value = float(true[mechanism.signal][0])
        speed = float(true[f"{mechanism.output}.{rate}"][0])
        data["drives"]["motor"] |= {
            "position": f"{value!r} {unit} + {speed!r} {unit}/s*t".replace(f"{unit}/s*t", f"{unit}*t/(1 s)"),
            "output": mechanism.output,
        }
        data["studies"]["cycle"]["duration"] = "0.2 s"
        result = run(assembled(mechanism, data)).cycle.result
        off = result[mechanism.signal] - (value + speed * result.t)
        off -= 2 * math.pi * np.round(off / (2 * math.pi)) if attribute == "angle" else 0
        if not np.abs(off).max() <= 1e-9:
            yield f"the output isn't where the law says, by {np.abs(off).max():.1e}"

    return perform


for _name in FORMS:
    column(_name, "drive")(_form(_name))
for _name in ("turns", *FORMS):
    column(f"{_name} with output", "drive")(_output(_name))


@column("path", "drive")
def _path(mechanism: Mechanism) -> Faults:
    """Two drives move the tip of an arm on the crank's pin so that the crank goes as ever."""
    q = swing(mechanism)
    lean = f"({mechanism.start - 50} deg + 15 deg*t/(1 s))"
    data = swinging(mechanism, turns="crank", on="frame", output="way")
    data["links"]["arm"] = {"points": {"B": [0, 0], "P": [40, 0]}}
    data["drives"]["servo"] = {"turns": "arm", "on": "crank", "output": "way"}
    data["paths"] = {
        "way": {"moves": "arm", "at": "P", "x": f"r*cos{q} + 40 mm*cos{lean}", "y": f"r*sin{q} + 40 mm*sin{lean}"}
    }
    found = run(assembled(mechanism, data)).cycle.result
    yield from differences(true := reference(named(mechanism)), found)
    yield from same_power(true, found)
