"""Input by sketch: derived lengths, assembly and start from one drawn pose."""

from __future__ import annotations

import copy
from typing import Any

import numpy as np
import pytest

from helpers.compiled import compiled_from
from linkwright.compilation import examine
from linkwright.findings import ModelError
from linkwright.model.desugar import spell_out
from linkwright.model.document import Document, dump, load, save

UNITS = {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N"}
PLACES = {"A": [0, 0], "B": [20, 35], "C": [110, 75], "D": [130, 0], "P": [70, 90]}
T = np.linspace(0.0, 1.0, 9)


def sketched(**sections: Any) -> dict[str, Any]:
    return copy.deepcopy(
        {
            "linkwright": 1,
            "units": UNITS,
            "sketch": PLACES,
            "links": {
                "frame": {"points": ["A", "D"]},
                "crank": {"points": ["A", "B"]},
                "coupler": {"points": ["B", "C", "P"]},
                "rocker": {"points": ["D", "C"]},
            },
            "drives": {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": "sketch"}},
        }
        | sections
    )


def spelled_by_hand() -> dict[str, Any]:
    """The same four-bar with lengths worked out here."""
    b, c, d, p = (np.array(PLACES[name], dtype=float) for name in "BCDP")
    along = (c - b) / np.hypot(*(c - b))
    local = [float(along @ (p - b)), float(along[0] * (p - b)[1] - along[1] * (p - b)[0])]
    return {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [130, 0]}},
            "crank": {"points": {"A": [0, 0], "B": [float(np.hypot(*b)), 0]}},
            "coupler": {"points": {"B": [0, 0], "C": [float(np.hypot(*(c - b))), 0], "P": local}},
            "rocker": {"points": {"D": [0, 0], "C": [float(np.hypot(*(c - d))), 0]}},
        },
        "assembly": {"C": "left of B-D"},
        "drives": {
            "motor": {
                "turns": "crank",
                "on": "frame",
                "speed": "60 rpm",
                "start": float(np.degrees(np.arctan2(b[1], b[0]))),
            }
        },
    }


def places_at_start(data: dict[str, Any], names: list[str]) -> np.ndarray:
    rows = [f"{name}.{axis}" for name in names for axis in "xy"]
    return compiled_from(data).evaluate(rows, np.zeros(1))[:, 0].reshape(-1, 2) * 1000


def test_a_sketch_is_the_mechanism_of_its_lengths() -> None:
    names = ["P.x", "P.y", "C.vx", "rocker.alpha", "coupler.omega", "motor.angle"]
    found = compiled_from(sketched()).evaluate(names, T) - compiled_from(spelled_by_hand()).evaluate(names, T)
    assert np.abs(found).max() < 1e-11


def test_lengths_are_named() -> None:
    parameters = compiled_from(sketched()).quantities.parameters
    assert parameters["AB"] == pytest.approx(np.hypot(20, 35) / 1000, rel=1e-15)
    assert parameters["DC"] == pytest.approx(np.hypot(20, 75) / 1000, rel=1e-15)
    assert {"BC", "coupler_P_x", "coupler_P_y"} <= parameters.keys()


def test_a_parameter_of_the_file_takes_the_place_of_a_drawn_length() -> None:
    compiled = compiled_from(sketched(parameters={"DC": 80}))
    assert compiled.quantities.parameters["DC"] == 0.08
    x, y = compiled.evaluate(["C.x", "C.y"], T)
    assert np.abs(np.hypot(x - 0.13, y) - 0.08).max() < 1e-15


@pytest.mark.parametrize("seed", range(25))
def test_the_motion_starts_where_it_is_drawn(seed: int) -> None:
    """Every drawn point, whatever the pose, to round-off over the nearness of the dead centre; polar places too."""
    places = np.random.default_rng(seed).uniform(-100, 100, (5, 2))
    points: dict[str, Any] = dict(zip("ABCDP", places.tolist(), strict=True))
    _, b, c, d, (x, y) = places
    sine = ((c - b)[0] * (d - c)[1] - (c - b)[1] * (d - c)[0]) / np.hypot(*(c - b)) / np.hypot(*(d - c))
    tolerance = 1e-12 / sine**2
    found = places_at_start(sketched(sketch=points), list("ABCDP"))
    assert np.abs(found - places).max() < tolerance
    points["P"] = f"{float(np.hypot(x, y))!r} at {float(np.degrees(np.arctan2(y, x)))!r}"
    assert np.abs(places_at_start(sketched(sketch=points), ["P"]) - [x, y]).max() < tolerance


def test_a_rule_of_the_file_comes_before_the_sketch() -> None:
    """Also where other points of the group are drawn on the other side."""
    found = places_at_start(sketched(assembly={"C": "right of B-D"}), ["C", "P"])
    mirrored = places_at_start(sketched(assembly={"P": [30, -20]}), ["C", "P"])
    assert np.abs(found - mirrored).max() < 1e-12
    assert found[0, 1] < 0


def test_a_triad_takes_its_pose_from_the_sketch() -> None:
    places = {"O": [0, 0], "A1": [20, 0], "A2": [400, 50], "A3": [300, 400], "B1": [60, 140], "B2": [260, 80]}
    places["B3"] = [240, 230]
    legs = {f"leg{i}": {"points": [f"A{i}", f"B{i}"]} for i in (1, 2, 3)}
    links = {"frame": {"points": ["O", "A2", "A3"]}, "crank": {"points": ["O", "A1"]}, **legs}
    data = sketched(sketch=places, links={**links, "plate": {"points": ["B1", "B2", "B3"]}})
    found = places_at_start(data, list(places))
    assert np.abs(found - np.array(list(places.values()))).max() < 1e-9


def test_cylinders_and_slides_start_as_they_are_drawn() -> None:
    links = {
        "frame": {"points": ["O", "K", "F"]},
        "boom": {"points": ["O", "M"]},
        "rod": {"points": ["M", "E"]},
        "ram": {"points": ["E"]},
    }
    data = sketched(
        sketch={"O": [0, 0], "K": [30, -90], "M": [130, -10], "E": [300, 40], "F": [0, 40]},
        links=links,
        joints={"guide": {"prismatic": ["frame", "ram"], "line": ["F at 0", "E at 0"]}},
        cylinders={"lift": {"from": "K", "to": "M"}},
        drives={"pump": {"extends": "lift", "speed": "5 mm/s", "start": "sketch"}},
    )
    s, e = compiled_from(data).evaluate(["lift.s", "E.x"], np.zeros(1))[:, 0] * 1000
    assert s == pytest.approx(np.hypot(100, 80), rel=1e-14)
    assert e == pytest.approx(300, rel=1e-12)
    data["drives"] = {"press": {"slides": "ram", "on": "frame", "position": "sketch + 5 mm*sin(90 deg*t/(1 s))"}}
    assert compiled_from(data).evaluate(["guide.s"], np.zeros(1))[0, 0] == pytest.approx(0.3, rel=1e-14)


def test_the_file_keeps_the_sketch(tmp_path: Any) -> None:
    document = Document.model_validate(sketched())
    save(document, tmp_path / "four_bar.yaml")
    assert load(tmp_path / "four_bar.yaml") == document
    assert "points: [A, B]" in dump(document)
    assert "AB" not in dump(document)
    assert "AB" in spell_out(document).mechanism.parameters


def test_points_may_be_sketched_or_given() -> None:
    data = sketched(sketch={name: PLACES[name] for name in "ABCD"})
    data["links"]["coupler"]["points"] = {"B": "sketch", "C": "sketch", "P": [30, 20]}
    bc = np.array(PLACES["C"]) - PLACES["B"]
    along = bc / np.hypot(*bc)
    expected = np.array(PLACES["B"]) + 30 * along + 20 * np.array([-along[1], along[0]])
    assert np.abs(places_at_start(data, ["P"])[0] - expected).max() < 1e-9


def findings_of(**sections: Any) -> dict[str, str]:
    _, found = examine(Document.model_validate(sketched(**sections)))
    for finding in found:
        assert finding.what
        assert finding.mend
    return {finding.code: finding.element for finding in found}


def test_a_point_that_is_not_drawn() -> None:
    found = findings_of(sketch={name: PLACES[name] for name in "ABDP"})
    assert found["sketch.missing-point"] in ("links.coupler.points", "links.rocker.points")


def test_a_drawn_point_that_no_link_has() -> None:
    assert findings_of(sketch={**PLACES, "Q": [1, 2]}) == {"sketch.unused": "sketch.Q"}


def test_a_start_that_the_sketch_does_not_tell() -> None:
    links = sketched()["links"]
    links["crank"]["points"] = {"A": [0, 0], "B": [40, 0]}
    assert findings_of(links=links)["sketch.no-value"] == "drives.motor.start"


def test_a_sketch_at_a_dead_centre_leaves_the_mode_open() -> None:
    """Coupler and rocker in line: the drawn places say nothing, a rule of the file does."""
    places = {"A": [0, 0], "B": [0, 30], "C": [80, 30], "D": [130, 30]}
    links = {name: link for name, link in sketched()["links"].items() if name != "coupler"}
    links["coupler"] = {"points": ["B", "C"]}
    assert findings_of(sketch=places, links=links) == {"assembly.ambiguous": "sketch.C"}
    assert not findings_of(sketch=places, links=links, assembly={"C": "left of B-D"})


def test_what_is_wrong_with_a_drawn_place_is_told_there() -> None:
    assert findings_of(sketch={**PLACES, "C": ["110 kg", 75]})["expression.units-conflict"] == "sketch.C"
    links = {**sketched()["links"], **FOOT}
    assert findings_of(sketch={**PLACES, "K": ["1/0", 75]}, links=links) == {"value.not-finite": "sketch.K"}


RAM = {"ram": {"from": "K", "to": "C"}}
DRAWN = {**PLACES, "K": [200, 60]}
FOOT = {"frame": {"points": ["A", "D", "K"]}}


@pytest.mark.parametrize(
    ("drive", "value"),
    [
        ({"turns": "crank", "on": "frame", "output": "rocker"}, np.arctan2(75, -20)),
        ({"turns": "crank", "on": "frame", "output": "ram"}, np.hypot(90, 15) / 1000),
        ({"extends": "ram", "output": "crank"}, np.arctan2(35, 20)),
        ({"extends": "ram", "output": "ram_barrel"}, np.pi - np.arctan2(15, 90)),
        ({"turns": "ram_rod", "on": "rocker"}, np.pi - np.arctan2(15, 90) - np.arctan2(75, -20)),
    ],
)
def test_a_law_for_an_output_starts_where_that_is_drawn(drive: dict[str, Any], value: float) -> None:
    """The mechanism starts as drawn whichever drive moves it, and the drive's own value is another one."""
    motor = {"speed": 0, "start": "sketch", **drive}
    data = sketched(sketch=DRAWN, links={**sketched()["links"], **FOOT}, cylinders=RAM, drives={"motor": motor})
    assert np.abs(places_at_start(data, list(DRAWN)) - list(DRAWN.values())).max() < 1e-9
    law = compiled_from(data).laws["motor"](np.zeros(1))
    assert law.d[0][0] == pytest.approx(value, rel=1e-14)


@pytest.mark.parametrize("output", [{}, {"output": "rocker"}, {"output": "ram"}])
def test_what_is_wrong_with_a_cylinder_isn_t_laid_to_the_sketch(output: dict[str, str]) -> None:
    """A misspelled end is one finding, not one more on every `sketch` that hangs on it."""
    drive = {"extends": "ram"} if output.get("output") != "ram" else {"turns": "crank", "on": "frame"}
    motor = {**drive, **output, "speed": 0, "start": "sketch"}
    links = {**sketched()["links"], **FOOT}
    cylinders = {"ram": {"from": "KK", "to": "C"}}
    found = findings_of(sketch=DRAWN, links=links, cylinders=cylinders, drives={"motor": motor})
    assert "sketch.no-value" not in found
    assert found["name.unknown"] == "cylinders.ram.from"


def test_a_start_without_value_isn_t_an_unknown_parameter_too() -> None:
    links = sketched()["links"]
    links["crank"]["points"] = {"A": [0, 0], "B": [40, 0]}
    assert findings_of(links=links) == {"sketch.no-value": "drives.motor.start"}


def test_a_derived_length_is_a_parameter_to_replace() -> None:
    document = Document.model_validate(sketched()).replace(DC=80)
    assert document.parameters["DC"].value.text == "80"
    assert document == Document.model_validate(sketched(parameters={"DC": 80}))
    with pytest.raises(ModelError) as caught:
        Document.model_validate(sketched()).replace(DD=80)
    assert "DC" in caught.value.findings[0].mend


def test_a_length_isn_t_called_like_a_constant() -> None:
    """The points p and i: a parameter can't be called pi."""
    sketch = {"p": [0, 0], "i": [20, 35], **PLACES}
    links = {**sketched()["links"], "crank": {"points": ["p", "i"]}, "coupler": {"points": ["i", "C", "P"]}}
    links["frame"] = {"points": ["p", "D"]}
    del sketch["A"], sketch["B"]
    compiled = compiled_from(sketched(sketch=sketch, links=links))
    assert np.hypot(*compiled.evaluate(["i.x", "i.y"], np.zeros(1))[:, 0]) == pytest.approx(np.hypot(20, 35) / 1000)


def test_a_wrong_place_is_told_once() -> None:
    """And not for every length that is derived from it."""
    drives = {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": 60}}
    data = sketched(sketch={**PLACES, "B": ["C.x", 35], "P": [70, "C.x"]}, drives=drives)
    _, found = examine(Document.model_validate(data))
    assert [(f.code, f.element) for f in found] == [
        ("expression.not-constant", "sketch.B"),
        ("expression.not-constant", "sketch.P"),
    ]
