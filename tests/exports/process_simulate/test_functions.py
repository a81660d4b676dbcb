"""Joint functions are held, as text, against the solver: examples, random mechanisms, names, signs, zero poses."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from helpers.compiled import compiled_from, compiled_of
from helpers.plain import document_of
from helpers.random_mechanisms import Seeded, build, driven_elsewhere, sketched
from linkwright.compilation import compile_mechanism
from linkwright.exports.process_simulate import evaluator
from linkwright.exports.process_simulate.functions import JointFunctions, Wish, make
from linkwright.exports.process_simulate.linkage import Refused
from linkwright.kernels import Compiled
from linkwright.model.document import load
from linkwright.results import Run
from linkwright.studies.drive_sweep import sweeping

EXAMPLES = Path(__file__).parents[3] / "examples"
DIALECTS = ("seed", "wizard")


def example(name: str) -> Compiled:
    return compile_mechanism(load(EXAMPLES / f"{name}.yaml"), EXAMPLES)


def made(compiled: Compiled, **wish: object) -> JointFunctions:
    return make(compiled, Wish(compiled.graph.drives[0], **wish))  # type: ignore[arg-type]


def own_error(compiled: Compiled, found: JointFunctions, steps: int = 777) -> float:
    """The largest error of the texts (rad or mm) by what the solver says of links and slides, read here anew."""
    drive, every = compiled.graph.drives[0], (found.driving, *found.functions)
    low, high = min(found.range[0], found.zero), max(found.range[1], found.zero)
    moving = sweeping(compiled, drive)
    start = float(compiled.laws[drive](np.zeros(1)).d[0][0])
    run = Run(moving, low - start, high - start, 720)
    t = np.append(np.linspace(low, high, steps), found.zero) - start
    kinds = {f.name: f.kind for f in every}
    rows = {"frame": np.zeros(t.size)}
    links = [*compiled.structure.topology.moving]
    rows |= dict(zip(links, run.evaluate([f"{link}.angle" for link in links], t), strict=True))

    def value(f: object) -> np.ndarray:
        if f.kind == "T":  # type: ignore[attr-defined]
            raw = rows[f.child] - rows[f.parent]  # type: ignore[attr-defined]
        else:
            forward = compiled.mechanism.joints[f.joint].links[0] == f.parent  # type: ignore[attr-defined]
            raw = run.evaluate([f"{f.joint}.s"], t)[0] * (1000 if forward else -1000)  # type: ignore[attr-defined]
        return f.sign * (raw - raw[-1])  # type: ignore[attr-defined,no-any-return]

    listed = [(f.name, f.text) for f in found.functions]
    got = evaluator.evaluate(listed, found.dialect, kinds, found.driving.name, value(found.driving))
    told = [(row, value(f)) for f, row in zip(found.functions, got, strict=True) if not f.helper]
    return max(float(np.abs(row - wanted).max()) for row, wanted in told)


@pytest.mark.parametrize("dialect", DIALECTS)
@pytest.mark.parametrize(
    ("name", "joints"),
    [("four_bar", 3), ("slider_crank", 3), ("boom_cylinder", 3), ("paper_feeder", 6), ("quick_return", 6)],
)
def test_examples_agree_with_the_solver(name: str, joints: int, dialect: str) -> None:
    compiled = example(name)
    found = made(compiled, dialect=dialect)
    assert len(found.functions) == joints
    assert found.max_error < 1e-8
    assert own_error(compiled, found) < 1e-8
    if name != "boom_cylinder":
        assert found.range[1] - found.range[0] == pytest.approx(2 * math.pi)


@pytest.mark.parametrize(
    ("seed", "elsewhere"), [*((k, False) for k in range(8)), *((k, True) for k in (1, 3, 4, 6, 7))]
)
def test_random_six_bars_of_all_dyads_agree(seed: int, elsewhere: bool) -> None:
    """The drive on the frame, or in a loop, where links that it holds on each other make one side of a dyad."""
    plain = build("six_bar", Seeded(seed))
    if elsewhere:
        plain = driven_elsewhere(plain, Seeded(seed + 999))
        plain = sketched(plain, [link for link in plain.links if link != "frame"])
    compiled = compiled_from(document_of(plain))
    assert not compiled.structure.higher_groups
    far = max(1e-8, 1e-8 * compiled.assembly.size())
    for dialect in DIALECTS:
        assert own_error(compiled, made(compiled, dialect=dialect)) < far


def test_a_pin_of_three_links_gives_two_joints() -> None:
    drawn = (build("six_bar", Seeded(seed)) for seed in range(100))
    shared = [plain for plain in drawn if any(len(members) > 2 for members in plain.pins.values())][:4]
    for plain in shared:
        compiled = compiled_of(plain)
        for dialect in DIALECTS:
            found = made(compiled, dialect=dialect)
            pin, members = next((pin, m) for pin, m in plain.pins.items() if len(m) > 2)
            every = (found.driving, *found.functions)
            assert sum(f.name.startswith(f"{pin}_") for f in every) == len(members) - 1
            assert own_error(compiled, found) < 1e-7
    assert len(shared) == 4


def test_names_flipped_axes_and_left_out_joints() -> None:
    compiled = example("four_bar")
    names = {"O2": "j2", "A": "j3", "B": "j4"}
    plain = made(compiled, names=names)
    found = made(compiled, names=names, flipped=("B", "O2"), left_out=("O4",))
    assert [f.name for f in found.functions] == ["j4", "j3"]
    assert not any("O4" in f.text for f in found.functions)
    assert found.driving.limits == pytest.approx((-2 * math.pi, 0))
    j4, j3 = found.functions
    assert j4.limits == pytest.approx([-v for v in plain.functions[0].limits[::-1]])
    assert j3.limits == pytest.approx(plain.functions[1].limits)
    assert own_error(compiled, found) < 1e-8
    # Without the inner joint nothing may ask for it.
    for dialect in DIALECTS:
        rest = made(compiled, names=names, left_out=("B",), dialect=dialect)
        assert {f.name for f in rest.functions} == {"j3", "O4"}
        assert own_error(compiled, rest) < 1e-8


def test_the_papers_shape_in_the_seed_dialect() -> None:
    """The inner joint of a four-bar is one arccosine of a cosine, its neighbour two over roots, as (15) and (13)."""
    inner, outer, last = made(example("four_bar")).functions
    assert inner.text == "acos(0.479166667-0.416666667*cos(T(O2)-2.443460953))-0.646243015"
    assert outer.text.count("acos(") == 2
    assert outer.text.count("sqrt(8000*cos(T(O2)-2.443460953)+11600)") == 2
    assert last.text == "T(O2)+T(A)+T(B)"


def test_functions_are_zero_at_a_zero_pose_of_ones_own() -> None:
    compiled = example("boom_cylinder")
    zero, window = 1.3, (1.0, 1.4)
    for dialect in DIALECTS:
        found = made(compiled, zero=zero, window=window, dialect=dialect)
        assert found.driving.limits == pytest.approx((-300, 100))
        listed = [(f.name, f.text) for f in found.functions]
        kinds = {f.name: f.kind for f in (found.driving, *found.functions)}
        assert np.abs(evaluator.evaluate(listed, dialect, kinds, "lift", np.zeros(1))).max() < 1e-8
        assert own_error(compiled, found) < 1e-8


def test_the_limits_hold_the_motion_and_no_more() -> None:
    """A crank-rocker's rocker swings between two angles given in closed form: both links in line."""
    found = made(example("four_bar"))
    a, b, c, d = 40.0, 120.0, 80.0, 100.0
    ends = [math.acos((c * c + d * d - (b + s * a) ** 2) / (2 * c * d)) for s in (1, -1)]
    swing = found.functions[-1]
    assert swing.limits[1] - swing.limits[0] == pytest.approx(ends[0] - ends[1], abs=1e-8)


def test_more_decimals_where_the_error_wants_them() -> None:
    found = made(example("paper_feeder"))
    assert found.decimals > 9
    assert all("e" not in f.text.replace("acos", "") for f in found.functions)


def test_a_toggle_bounds_the_range_and_offers_the_largest() -> None:
    """The triple-rocker's crank angles end where coupler and rocker are in line: cos = (a2 + d2 - (b + c)2)/(2 a d)."""
    data = load(EXAMPLES / "four_bar.yaml").replace(a=100, b=60, c=70, d=110)
    compiled = compile_mechanism(data)
    end = math.acos((100**2 + 110**2 - 130**2) / (2 * 100 * 110))
    found = made(compiled)
    assert found.range[0] > 0
    assert end * (1 - 3e-3) < found.range[1] < end
    assert own_error(compiled, found) < 1e-8
    with pytest.raises(Refused) as refused:
        made(compiled, window=(0.5, end + 0.1))
    data = refused.value.finding.data
    assert refused.value.finding.code == "functions.toggle"
    low, high = (math.radians(float(data[key])) for key in ("low", "high"))
    assert end * (1 - 3e-3) < high < end
    offered = made(compiled, window=(low, high))
    assert own_error(compiled, offered) < 1e-8


def test_change_points_bound_the_range_of_a_parallelogram() -> None:
    found = made(example("parallelogram"))
    assert 0 < found.range[0] < found.range[1] < math.pi
    assert found.range[1] - found.range[0] > 0.99 * math.pi


def test_a_direction_that_turns_too_far_for_one_arccosine_is_refused() -> None:
    """A coupler's point goes round a frame's pin the other way than the crank: no link sees it within half a turn."""
    crank = {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": 0.3}
    data = {
        "linkwright": 1,
        "units": {"length": "mm", "angle": "rad"},
        "links": {
            "frame": {"points": {"O": [0, 0], "D": [100, 0], "F": [120, 46.6]}},
            "crank": {"points": {"O": [0, 0], "B": [40, 0]}},
            "coupler": {"points": {"B": [0, 0], "C": [120, 0], "E": [116.5, -45.4]}},
            "rocker": {"points": {"D": [0, 0], "C": [80, 0]}},
            "arm": {"points": {"E": [0, 0]}},
            "block": {"points": {"F": [0, 0]}},
        },
        "joints": {"slot": {"prismatic": ["arm", "block"], "line": ["E at 0", "F at 0"]}},
        "assembly": {"C": "left of B-D", "F": "ahead of E along slot"},
        "drives": {"motor": crank},
    }
    compiled = compiled_from(data)
    for dialect in DIALECTS:
        with pytest.raises(Refused) as refused:
            made(compiled, dialect=dialect)
        assert refused.value.finding.code == "functions.sweep"
    # Over a part of the turn, one arccosine still doesn't hold it, but atan2 does.
    part = (-3.5, 0.5)
    found = made(compiled, dialect="wizard", window=part)
    block = next(f for f in found.functions if f.joint == "F")
    assert math.pi < block.limits[1] - block.limits[0] < 2 * math.pi
    assert own_error(compiled, found) < 1e-8
    with pytest.raises(Refused):
        made(compiled, dialect="seed", window=part)


@pytest.mark.parametrize("dialect", DIALECTS)
def test_long_texts_are_split_over_helpers(dialect: str) -> None:
    compiled = example("four_bar")
    found = made(compiled, dialect=dialect, longest=80)
    assert max(len(f.text) for f in found.functions) <= 80
    assert any(f.helper for f in found.functions)
    assert own_error(compiled, found) < 1e-8
    with pytest.raises(Refused) as refused:
        made(compiled, dialect=dialect, longest=20)
    least = refused.value.finding.data["least"]
    assert max(len(f.text) for f in made(compiled, dialect=dialect, longest=least).functions) == least
    with pytest.raises(Refused):
        made(compiled, dialect=dialect, longest=least - 1)


def test_a_group_without_a_closed_form_is_named_and_fitted_on_demand() -> None:
    compiled, window = example("class_four"), (-0.05, 0.05)
    with pytest.raises(Refused) as refused:
        made(compiled, window=window)
    finding = refused.value.finding
    assert finding.code == "functions.no-closed-form"
    assert "leg2" in str(finding.data["links"])
    with pytest.raises(Refused):
        made(compiled, window=window, approximate=1e-17)
    approximate = float(finding.data["approximate"])
    found = made(compiled, window=window, dialect="wizard", approximate=approximate)
    assert found.fitted
    assert found.max_error <= approximate
    assert not any(word in f.text for f in found.functions for word in ("acos", "sin", "sqrt", "/"))
    assert own_error(compiled, found) < 1.1 * found.max_error
