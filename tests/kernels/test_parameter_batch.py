"""Many parameter sets at once against each of them compiled on its own from a file with those values."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from helpers.examples import four_bar
from linkwright.compilation import compile_mechanism
from linkwright.findings import ModelError
from linkwright.kernels import KERNELS, Compiled, continuation_batch, continuation_paths, parameter_batch
from linkwright.kernels.change_points import Passage, Passages
from linkwright.kernels.continuation_batch import Pursued, Pursuit
from linkwright.kernels.continuation_paths import SamplePaths
from linkwright.kernels.parameter_batch import Varied
from linkwright.model.document import Document, load, parse_document, plain, replaced

Array = NDArray[np.float64]
EXAMPLES = Path(__file__).parents[2] / "examples"
SPRUNG = Path(__file__).parents[1] / "model" / "data" / "sprung.yaml"
ROUND_OFF = 1e-12


def document(data: Mapping[str, Any]) -> Document:
    made = parse_document(dict(data))
    assert made is not None
    return made


def edited(path: Path, parameters: Mapping[str, Any], edit: Callable[[dict[str, Any]], None]) -> Document:
    """A file with further parameters and an edit that uses them."""
    data = plain(load(path))
    data.setdefault("parameters", {}).update(parameters)
    edit(data)
    return document(data)


def spread(varied: Varied, share: float, samples: int = 5, seed: int = 1) -> Array:
    """Values round the nominal ones: (names, samples)."""
    nominal = np.array([varied.compiled.quantities.parameters[name] for name in varied.names])
    shares = np.random.default_rng(seed).uniform(-share, share, (nominal.size, samples))
    return np.asarray(nominal[:, None] * (1 + shares))


def alone(made: Document, values: Array, units: Mapping[str, str]) -> Compiled:
    """The mechanism compiled from a file with these values (SI)."""
    texts = {
        name: f"{float(value)!r} {unit}".strip() for (name, unit), value in zip(units.items(), values, strict=True)
    }
    return compile_mechanism(replaced(made, texts), EXAMPLES)


def assert_same(
    made: Document,
    units: Mapping[str, str],
    signals: Sequence[str],
    t: Array,
    share: float = 0.02,
    tolerance: float = ROUND_OFF,
) -> None:
    """Both ways to ask give, with rates, what each sample alone gives: to a share of each row's size."""
    varied = Varied(compile_mechanism(made, EXAMPLES), list(units))
    values = spread(varied, share)
    p = varied.parameters(values)
    found = varied.evaluate(signals, p, t, rates=True)
    own = varied.signals_at(signals, p, np.tile(t, (values.shape[1], 1)), rates=True).reshape(found.shape)
    assert not np.isfinite(varied.failures(p, t).time).any()
    for i, of_sample in enumerate(values.T):
        expected = alone(made, of_sample, units).evaluate(signals, t, rates=True).reshape(-1, t.size)
        scale = np.abs(expected).max(axis=1, keepdims=True) + 1e-9
        assert np.isfinite(expected).all()
        for given in (found, own):
            assert (np.abs(given[:, i] - expected) / scale).max() < tolerance


def test_four_bar() -> None:
    signals = ["P.x", "P.ay", "rocker.angle", "motor.torque", "force(coupler, rocker).x"]
    assert_same(load(EXAMPLES / "four_bar.yaml"), dict.fromkeys("abcd", "m"), signals, np.linspace(0, 0.5, 40))


def test_feeder_with_its_lengths_and_masses() -> None:
    def edit(data: dict[str, Any]) -> None:
        data["links"]["coupler"]["mass"] = "mc"
        data["links"]["guide"]["mass"] = "2*mc"

    made = edited(EXAMPLES / "paper_feeder.yaml", {"mc": "1.5 kg"}, edit)
    units = dict.fromkeys(["AB", "BC", "CD", "DE", "AD", "AH"], "m") | {"mc": "kg"}
    signals = ["E.x", "E.vx", "motor.torque", "shaking.x", "motor.angle"]
    assert_same(made, units, signals, np.linspace(0, 1.5, 40), share=0.01)


def test_two_drives_and_a_law_with_parameters() -> None:
    def edit(data: dict[str, Any]) -> None:
        data["drives"]["servo"]["position"] = "90 deg + swing*sin(pi*1 rad*t/half)"
        data["drives"]["motor"]["speed"] = "n"

    made = edited(EXAMPLES / "five_bar.yaml", {"swing": "20 deg", "half": "1 s", "n": "30 rpm"}, edit)
    units = {"l1": "m", "l3": "m", "alpha": "rad", "swing": "rad", "half": "s", "n": "rad/s"}
    assert_same(made, units, ["P.x", "P.ay", "servo.torque", "motor.angle"], np.linspace(0, 2, 40))


LAWS = [
    "min(a*t/(1 s), 0.3*a) + max(t/(1 s), a)",
    "step5(t, 0.1 s, 0.2, b, a)",
    "a*(t/(1 s))^e + 2^(e*t/(1 s))",
    "abs(a - 1) + atan2(t/(1 s) - 0.2, a)",
    "curve(a*t/(1 s)) + curve(0.1*a)",
    "a",
]


@pytest.mark.parametrize("position", LAWS)
def test_functions_of_a_law(position: str) -> None:
    """Each function on arrays of parameters; powers of whole and other exponents, with a base of 0."""
    parameters = {"a": 0.9, "b": "0.7 s", "e": 3}
    tables = {"curve": {"points": [[-0.1, 0.1], [0.3, 0.2], [0.5, 0.4], [0.8, 0.5], [2, 0.9]]}}
    motor = {"turns": "crank", "on": "frame", "position": position}
    made = document(four_bar(parameters=parameters, tables=tables, drives={"motor": motor}))
    units = {"a": "", "b": "s", "e": ""}
    assert_same(made, units, ["C.x", "rocker.alpha", "motor.jerk"], np.linspace(0.02, 0.8, 31), share=0.1)


def test_a_power_that_is_whole_in_some_samples() -> None:
    motor = {"turns": "crank", "on": "frame", "position": "(t/(1 s))^e"}
    varied = Varied(compile_mechanism(document(four_bar(parameters={"e": 2}, drives={"motor": motor}))), ["e"])
    t = np.array([0.0, 0.5, 1.0])
    found = varied.evaluate(
        ["motor.angle", "motor.omega", "motor.alpha"], varied.parameters(np.array([[1, 2, 3.5]])), t
    )
    e = np.array([[1], [2], [3.5]])
    assert found[0] == pytest.approx(t**e, abs=1e-14)
    assert found[1] == pytest.approx(e * t ** (e - 1), abs=1e-14)
    assert found[2][1:] == pytest.approx((e * (e - 1))[1:] * t ** (e[1:] - 2), abs=1e-14)
    assert found[2][0] == pytest.approx(0, abs=1e-14)


def test_derived_parameters_follow_and_may_be_varied_themselves() -> None:
    made = document(four_bar(a="r", c="3*r", parameters={"r": 1, "unused": "r^0.5", "s": "2*r"}))
    signals = ["C.x", "rocker.omega"]
    assert_same(made, {"r": "m"}, signals, np.linspace(0, 6, 20))
    assert_same(made, {"r": "m", "s": "m"}, signals, np.linspace(0, 6, 20))


def test_a_drive_with_an_output() -> None:
    made = load(EXAMPLES / "press_law.yaml")
    names = list(made.parameters)
    varied = Varied(compile_mechanism(made, EXAMPLES), names)
    signals = [f"{drive}.{effort}" for drive in made.drives for effort in ("angle", "omega", "torque", "power")]
    t = np.linspace(0.01, 0.9, 30)
    assert_same(made, units_of(varied), signals, t, share=1e-3, tolerance=1e-9)


def units_of(varied: Varied) -> dict[str, str]:
    """The SI units of the varied parameters."""
    from linkwright.expressions.units import si_text

    quantities = varied.compiled.quantities
    return {name: si_text(quantities.dimensions.of(name)) for name in varied.names}


def sprung() -> Document:
    def edit(data: dict[str, Any]) -> None:
        data["links"]["crank"]["points"]["B"] = ["r", 0]
        data["links"]["rocker"]["points"]["C"] = ["c", 0]
        data["springs"]["hold"]["free"] = "f"
        data["counterweights"]["cw"]["mass"] = "m"
        data["drives"]["motor"]["speed"] = "fast"

    return edited(SPRUNG, {"r": 60, "c": 120, "f": "30 deg", "m": "0.4 kg", "fast": "2 r/s"}, edit)


SPRUNG_UNITS = {"k": "N/m", "n": "", "fast": "rad/s", "r": "m", "c": "m", "f": "rad", "m": "kg"}


def test_springs_tables_and_whole_turns() -> None:
    """Two turns of the crank: the load on the rocker's angle, springs wound on, windows, tables of all kinds."""
    signals = ["motor.torque", "wound.torque", "wound.angle", "hold.torque", "lift.force", "pull.energy", "wire.force"]
    assert_same(sprung(), SPRUNG_UNITS, signals, np.linspace(0.003, 0.79, 37), share=0.01, tolerance=1e-10)


def test_whole_turns_of_free_angles() -> None:
    """A load that grows with the angle of a link that turns three times; each sample at its own speed."""
    load_ = {"load": {"on": "rocker", "torque": "1 N*m*rocker.angle/(1 rad)"}}
    drag = {"a": 3, "b": 3.2, "c": "c", "d": 1}
    motor = {"motor": {"turns": "crank", "on": "frame", "speed": "n", "start": 0.5}}
    made = document(four_bar(**drag, loads=load_, drives=motor, parameters={"c": 3.4, "n": "1 rad/s"}))
    t = np.random.default_rng(1).uniform(0, 6 * np.pi, 50)
    assert_same(made, {"c": "m", "n": "rad/s"}, ["motor.power", "rocker.angle"], np.sort(t), tolerance=1e-11)


def platform() -> Document:
    def edit(data: dict[str, Any]) -> None:
        links = data["links"]
        links["crank"]["points"]["A1"] = ["r", 0]
        links["leg1"]["points"]["B1"] = ["p", 0]
        links["leg3"]["points"]["B3"] = ["q", 0]
        links["plate"]["points"]["B2"] = ["w", 0]

    return edited(EXAMPLES / "platform.yaml", {"r": 20, "p": 143, "q": 180, "w": 209}, edit)


def class_four() -> Document:
    def edit(data: dict[str, Any]) -> None:
        links = data["links"]
        links["crank"]["points"]["A"] = ["r", 0]
        links["leg2"]["points"]["P"] = ["p", 0]
        links["leg4"]["points"]["Q"] = ["q", 0]
        links["top"]["points"]["E"] = ["w", 0]

    return edited(EXAMPLES / "class_four.yaml", {"r": 30, "p": 130, "q": 151, "w": 152}, edit)


CLUSTERS = [
    (platform, ["plate.angle", "B3.x", "B3.vy", "motor.torque"], 0.005),
    (class_four, ["top.angle", "E.y", "E.vx", "motor.torque"], 0.02),
]


@pytest.mark.parametrize(("made", "signals", "share"), CLUSTERS)
def test_higher_groups_followed_a_full_turn(made: Callable[[], Document], signals: list[str], share: float) -> None:
    """Each sample alone is assembled from the sketch and followed by the path of the single mechanism."""
    assert_same(made(), dict.fromkeys("rpqw", "m"), signals, np.linspace(0, 1, 61), share=share, tolerance=1e-9)


@pytest.mark.parametrize("poses", [20, 61])
def test_higher_groups_do_not_jump(poses: int) -> None:
    """Over wide ranges some samples meet singular poses: each follows the path of the single mechanism, to its end."""
    made, signals = platform(), ["plate.angle", "B3.x"]
    units, t = dict.fromkeys("rpqw", "m"), np.linspace(0, 1, poses)
    varied = Varied(compile_mechanism(made), list(units))
    values = spread(varied, 0.05, samples=12, seed=4)
    found = varied.evaluate(signals, varied.parameters(values), t)
    failures = varied.failures(varied.parameters(values), t)
    lost = np.isnan(found).any(axis=(0, 2))
    assert np.array_equal(lost, np.isfinite(failures.time))
    assert 0 < lost.sum() < lost.size
    followed = 0
    for i, of_sample in enumerate(values.T):
        try:
            expected = alone(made, of_sample, units).evaluate(signals, t)
        except ModelError:
            assert np.isnan(found[:, i]).all()
            continue
        assert np.array_equal(np.isnan(found[:, i]), np.isnan(expected))
        assert np.nanmax(np.abs(found[:, i] - expected)) < 1e-7
        followed += 1
    assert followed > 6


NARROW = [0.030962952337340865, 0.1449854480452313, 0.17424971721174706, 0.17169816544048153]


def test_a_singular_pose_is_not_stepped_over() -> None:
    """At t = 0.4268 this sample's mode ends, and 1e-5 s later another one begins, 0.05 rad away with its determinant of
    the same sign: whatever the poses asked for, no step leads across."""
    varied = Varied(compile_mechanism(class_four()), list("rpqw"))
    p = varied.parameters(np.array([NARROW]).T)
    for poses in (10, 50, 361, 721):
        t = np.linspace(0, 1, poses)
        found = varied.evaluate(["E.x"], p, t)[0, 0]
        assert np.array_equal(np.isfinite(found), t < 0.4268)


@contextmanager
def without_paths(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Every sample is followed from pose to pose, from its start on."""
    with monkeypatch.context() as patch:
        patch.setattr(SamplePaths, "extend", lambda self, to: None)
        yield


ON_A_PLATFORM, IN_CLASS_FOUR = (platform, ["plate.angle", "B3.x"]), (class_four, ["top.angle", "E.y"])


@pytest.mark.parametrize("share", [0.1, 0.3])
@pytest.mark.parametrize(
    ("made", "signals", "kernel"),
    [
        (*ON_A_PLATFORM, "numpy"),
        pytest.param(*IN_CLASS_FOUR, "numpy", marks=pytest.mark.long),
        pytest.param(*ON_A_PLATFORM, "llvm", marks=pytest.mark.long),
        (*IN_CLASS_FOUR, "llvm"),
    ],
)
def test_poses_foretold_by_paths_are_those_followed_one_by_one(
    made: Callable[[], Document], signals: list[str], share: float, kernel: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Over ranges so wide that up to half of the samples end on the way: figures, and where there are none."""
    compiled, t = compile_mechanism(made()), np.linspace(0, 1, 361)
    varied = Varied(compiled, list("rpqw"))
    p = varied.parameters(spread(varied, share, samples=200, seed=7))
    found, failures = varied.evaluate(signals, p, t, kernel=kernel), varied.failures(p, t, kernel)
    own = varied.signals_at(signals, p[:, :20], np.tile(t[::-3], (20, 1)), kernel=kernel)
    with without_paths(monkeypatch):
        expected = Varied(compiled, list("rpqw")).evaluate(signals, p, t)
    assert np.array_equal(np.isnan(found), np.isnan(expected))
    assert np.nanmax(np.abs(found - expected)) < 1e-11
    assert np.array_equal(np.isnan(own), np.isnan(expected[:, :20, ::-3]))
    assert np.nanmax(np.abs(own - expected[:, :20, ::-3])) < 1e-11
    ends = np.where(np.isnan(expected[0]).any(axis=1), t[np.isnan(expected[0]).argmax(axis=1)], np.inf)
    assert np.array_equal(failures.time, ends)


def test_most_poses_are_not_followed_one_by_one(monkeypatch: pytest.MonkeyPatch) -> None:
    """Neither start poses nor paths hand a regular sample on."""
    varied = Varied(compile_mechanism(class_four()), list("rpqw"))
    p = varied.parameters(spread(varied, 0.1, samples=20))
    handed: list[tuple[int, ...]] = []
    reach = Pursuit.advance_to

    def counted(self: Pursuit, place: Any, u: Array, now: Array, targets: Array, least: Array) -> Array:
        handed.append(targets.shape)
        return reach(self, place, u, now, targets, least)

    monkeypatch.setattr(Pursuit, "advance_to", counted)
    assert np.isfinite(varied.evaluate(["E.x"], p, np.linspace(0, 1, 361))).all()
    assert handed == [(20, 1)]


@pytest.mark.parametrize("shortest", [continuation_paths.SHORTEST, 2.0**-10])
@pytest.mark.parametrize("exponent", [0.4, 2.0])
def test_a_path_that_gives_up_is_followed_from_pose_to_pose(
    exponent: float, shortest: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The crank turns back at t = 0.31, without a stop if the exponent is under 1, so that short steps are needed. The
    same crank angles are met by a crank that runs on."""
    top, data, signals = 0.31**exponent, plain(class_four()), ["E.x", "top.angle"]
    position = f"{top} - abs(t/(1 s) - 0.31)^{exponent}"
    data["drives"]["motor"] = {"turns": "crank", "on": "frame", "position": position}
    back, on = (Varied(compile_mechanism(made), list("rpqw")) for made in (document(data), class_four()))
    values, t = spread(back, 0.02), np.linspace(0, 0.6, 40)
    handed: list[int] = []
    along = Pursued._along
    monkeypatch.setattr(continuation_paths, "SHORTEST", shortest)
    monkeypatch.setattr(Pursued, "_along", lambda self, p, *rest: (handed.append(p.shape[1]), along(self, p, *rest))[1])
    found = back.evaluate(signals, back.parameters(values), t)
    assert handed == ([5] if exponent < 1 and shortest > 1e-6 else [])
    met = np.tile((top - np.abs(t - 0.31) ** exponent) / (2 * np.pi), (5, 1))
    expected = on.signals_at(signals, on.parameters(values), np.maximum(met, 0))
    assert np.abs(found - expected).max() < 1e-12


def test_figures_of_a_pose_do_not_depend_on_the_times_before() -> None:
    """Ranges of poses one after the other lay paths further, where all poses at once lay them in one go."""
    varied, t = Varied(compile_mechanism(class_four()), list("rpqw")), np.linspace(0, 1, 61)
    p = varied.parameters(spread(varied, 0.1))
    whole = varied.evaluate(["E.x"], p, t)
    other = Varied(varied.compiled, list("rpqw"))
    parts = [other.evaluate(["E.x"], p, t[some]) for some in (slice(32, 45), slice(45, 61))]
    assert np.array_equal(np.concatenate(parts, axis=2), whole[..., 32:])


def test_paths_are_laid_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Parts of the samples, their own times and their failures use the paths that are there; doubles share one."""
    monkeypatch.setattr(parameter_batch, "CHUNK", 200)
    made = Varied(compile_mechanism(platform()), list("rpqw"))
    p, t = made.parameters(spread(made, 0.1, samples=30)), np.linspace(0, 1, 61)
    found = made.evaluate(["B3.x"], p, t)
    bad = np.isnan(found[0]).any(axis=1)
    with monkeypatch.context() as patch:
        patch.setattr(SamplePaths, "_advance", lambda *_: pytest.fail("a path is laid"))
        patch.setattr(Pursued, "_started", lambda *_: pytest.fail("samples are started"))
        assert np.isfinite(made.failures(p[:, bad], t).time).all()
        some = np.array([3, 1, 3, 20])
        own = np.array([0.9, 0.6, 1.0, 0.7])[:, None]
        assert np.isfinite(made.signals_at(["B3.x"], p[:, some], own)[0, ~bad[some]]).all()
    fresh = Varied(made.compiled, list("rpqw"))
    expected = np.concatenate(
        [fresh.signals_at(["B3.x"], p[:, [i]], at[None]) for i, at in zip(some, own, strict=True)], axis=1
    )
    assert np.array_equal(made.signals_at(["B3.x"], p[:, some], own), expected, equal_nan=True)


CUT = [
    (lambda: load(EXAMPLES / "four_bar.yaml"), ["a", "b"], ["P.x", "motor.torque"]),
    (sprung, [*SPRUNG_UNITS], ["motor.torque", "wound.angle"]),
    (class_four, ["r", "p", "w"], ["E.x", "motor.torque"]),
]


A_TRIAD = (class_four, ["r", "w"], ["E.x", "E.vx"])
"""JAX compiles its Newton steps for seconds; they are tested in ``test_jax_kernel.py`` too."""


@pytest.mark.parametrize(
    ("made", "names", "signals", "kernel"),
    [
        pytest.param(*case, kernel, marks=[pytest.mark.long] if case is A_TRIAD and kernel == "jax" else [])
        for case in (CUT[0], A_TRIAD)
        for kernel in sorted(KERNELS)
    ],
)
def test_kernels_agree(made: Callable[[], Document], names: list[str], signals: list[str], kernel: str) -> None:
    varied = Varied(compile_mechanism(made()), names)
    p, t = varied.parameters(spread(varied, 0.02)), np.linspace(0, 0.5, 12)
    expected = varied.evaluate(signals, p, t)
    own = varied.signals_at(signals, p, np.tile(t, (5, 1)), kernel=kernel)
    for found in (own, varied.evaluate(signals, p, t, kernel=kernel)):
        assert np.abs(found - expected).max() <= 1e-10 * np.abs(expected).max()
    assert np.array_equal(varied.failures(p, t, kernel).cause, np.full(5, -1))


@pytest.mark.parametrize(("made", "names", "signals"), CUT)
def test_a_time_that_is_no_number_gives_no_figure(
    made: Callable[[], Document], names: list[str], signals: list[str]
) -> None:
    """Whoever looks for the times of some samples need not leave the others out."""
    varied = Varied(compile_mechanism(made(), EXAMPLES), names)
    p, t = varied.parameters(spread(varied, 0.01, samples=3)), np.array([[0.1, np.nan], [0.2, 0.3], [np.nan, np.nan]])
    found = varied.signals_at(signals, p, t)
    assert np.array_equal(np.isnan(found), np.broadcast_to(np.isnan(t), found.shape))
    assert np.array_equal(varied.signals_at(signals, p[:, :1], t[:1, :1]), found[:, :1, :1])


def test_poses_in_any_order() -> None:
    varied = Varied(compile_mechanism(class_four()), ["r", "w"])
    p, t = varied.parameters(spread(varied, 0.05)), np.linspace(0, 1, 13)
    order = np.random.default_rng(3).permutation(t.size)
    signals = ["E.x", "top.angle"]
    assert np.array_equal(varied.evaluate(signals, p, t[order]), varied.evaluate(signals, p, t)[..., order])


@pytest.mark.parametrize(("made", "names", "signals"), CUT)
def test_a_sample_does_not_depend_on_the_others(
    made: Callable[[], Document], names: list[str], signals: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """To the last bit: samples alone, in other company, in chunks, at once from several threads."""
    varied_, t = Varied(compile_mechanism(made(), EXAMPLES), names), np.linspace(0, 0.7, 23)
    p = varied_.parameters(spread(varied_, 0.1, samples=19))
    own = np.sort(np.random.default_rng(2).uniform(0, 0.7, (19, 5)))
    whole, whole_own = varied_.evaluate(signals, p, t, rates=True), varied_.signals_at(signals, p, own)
    assert np.isfinite(whole).all(axis=(0, 2)).sum() > 5

    def cut(some: slice, of: Varied = varied_) -> None:
        assert np.array_equal(of.evaluate(signals, p[:, some], t, rates=True), whole[:, some], equal_nan=True)
        assert np.array_equal(of.signals_at(signals, p[:, some], own[some]), whole_own[:, some], equal_nan=True)

    parts = [slice(0, 1), slice(12, 19), slice(3, 11), slice(18, 19)]
    for part in parts:
        cut(part)
        cut(part, Varied(varied_.compiled, names))
    with ThreadPoolExecutor(3) as pool:
        list(pool.map(cut, parts * 2))
    monkeypatch.setattr(parameter_batch, "CHUNK", 100)
    monkeypatch.setattr(continuation_batch, "HELD", 50)
    cut(slice(0, 19), Varied(varied_.compiled, names))
    monkeypatch.setattr(continuation_batch, "MOST", 2)
    cut(slice(0, 19), Varied(varied_.compiled, names))


def test_samples_that_cannot_be_assembled_are_told() -> None:
    """A four-bar whose rocker is too short to be reached: at crank angle 0.5 + t the pins B and D come
    sqrt(a^2 + d^2 - 2 a d cos) apart, which must not exceed b + c."""
    made = document(four_bar(1, 3, "c", 4, parameters={"c": 3}))
    varied = Varied(compile_mechanism(made), ["c"])
    c = np.array([[3.0, 1.0, 1.5, 2.5, 0.2]])
    t = np.linspace(0, 6, 200)
    p = varied.parameters(c)
    apart = np.sqrt(1 + 16 - 8 * np.cos(0.5 + t))
    closes = (apart <= 3 + c.T) & (apart >= np.abs(3 - c.T))
    found = varied.evaluate(["C.x"], p, t)[0]
    assert np.array_equal(np.isfinite(found), closes)
    failures = varied.failures(p, t)
    assert np.array_equal(failures.time, [np.inf if row.all() else t[row.argmin()] for row in closes])
    assert np.array_equal(failures.cause >= 0, ~closes.all(axis=1))
    finding = varied.finding(int(failures.cause[1]), 3, 5, 1, float(failures.time[1]), c[:, 1])
    assert finding.code == "varied.cannot-assemble"
    assert finding.data["count"] == 3
    short = np.interp(failures.time[1], t, apart)
    assert float(finding.data["distance"]) == pytest.approx(short, rel=1e-5)
    assert float(finding.data["limit"]) == pytest.approx(4.0, rel=1e-5)
    assert "3 of 5 samples" in str(finding)


def test_higher_groups_that_cannot_be_followed_are_told() -> None:
    varied = Varied(compile_mechanism(platform()), ["r"])
    values = np.array([[0.02, 0.06]])
    failures = varied.failures(varied.parameters(values), np.linspace(0, 1, 30))
    assert failures.time[0] == np.inf
    assert 0 <= failures.time[1] < 1
    finding = varied.finding(int(failures.cause[1]), 1, 2, 1, float(failures.time[1]), values[:, 1])
    assert finding.code == "varied.stuck"
    assert "plate" in finding.what


def test_values_that_make_no_sense_give_no_figures() -> None:
    """The model's own checks, on each sample: a negative mass, a rod of no length, a parameter without a value."""
    made = document(
        four_bar(a="r", parameters={"r": "1 m", "m": "2 kg", "q": "1 m/(m/(1 kg) + 3)"})
        | {"gravity": [0, -9.81]}
        | {"counterweights": {"w": {"on": "crank", "mass": "m", "at": "B"}}}
    )
    varied = Varied(compile_mechanism(made), ["r", "m"])
    values = np.array([[1.0, 1.0, 1.0, np.nan, 1.0], [2.0, -0.5, -3.0, 1.0, 2.0]])
    p, t = varied.parameters(values), np.linspace(0, 1, 3)
    found = varied.evaluate(["C.x", "motor.angle", "motor.torque"], p, t)
    assert np.array_equal(np.isnan(found).all(axis=(0, 2)), [False, True, True, True, False])
    assert np.array_equal(np.isnan(found).any(axis=(0, 2)), [False, True, True, True, False])
    failures = varied.failures(p, t)
    assert np.array_equal(failures.cause, [-1, 0, 0, 0, -1])
    finding = varied.finding(0, 3, 5, 1, 0.0, values[:, 1])
    assert finding.code == "varied.values"
    assert "-0.5" in finding.what
    assert {fault.code for fault in varied.faults(values)} == {
        "parameters.value",
        "value.not-finite",
        "value.too-small",
    }
    assert [fault.code for fault in varied.faults(values[:, [0, 1]])] == ["value.too-small"]


@pytest.mark.parametrize(("position", "until"), [("sqrt(a - t/(1 s))", 1), ("curve(t/(1 s)/a)", 2)])
def test_a_law_without_a_value_is_told(position: str, until: float) -> None:
    """A root of something negative; a table asked beyond its end at 2."""
    tables = {"curve": {"points": [[0, 0.1], [0.3, 0.2], [0.5, 0.4], [0.8, 0.5], [2, 0.9]]}}
    motor = {"turns": "crank", "on": "frame", "position": position}
    made = document(four_bar(parameters={"a": 3}, tables=tables, drives={"motor": motor}))
    varied = Varied(compile_mechanism(made), ["a"])
    p, t = varied.parameters(np.array([[3.0, 1.0]])), np.linspace(0.05, 2.55, 26)
    failures = varied.failures(p, t)
    assert failures.time[0] == np.inf
    assert failures.time[1] == t[t > until][0]
    assert np.array_equal(np.isnan(varied.evaluate(["C.x"], p, t)[0, 1]), t > until)
    assert varied.finding(int(failures.cause[1]), 1, 2, 1, 1.0, np.array([1.0])).code == "varied.drive"


def test_parameters_that_cannot_be_varied_are_refused() -> None:
    compiled = compile_mechanism(load(EXAMPLES / "four_bar.yaml"))
    with pytest.raises(ModelError, match="unknown-parameter"):
        Varied(compiled, ["a", "e"])
    carried = replace(compiled, passages=Passages((Passage(0.1, ("coupler-rocker",), 0.01),)))
    with pytest.raises(ModelError, match=r"varied\.passage"):
        Varied(carried, ["a"])
    tables = {"curve": {"points": [[0, 0], ["s", 0.2], [1, 0.5], [2, 1]]}}
    motor = {"turns": "crank", "on": "frame", "position": "curve(t/(1 s))"}
    made = document(four_bar(parameters={"r": 0.2, "s": "r"}, tables=tables, drives={"motor": motor}))
    with pytest.raises(ModelError, match=r"varied\.table"):
        Varied(compile_mechanism(made), ["r"])


def test_no_samples_and_no_poses() -> None:
    varied = Varied(compile_mechanism(load(EXAMPLES / "four_bar.yaml")), ["a"])
    p = varied.parameters(np.empty((1, 0)))
    assert varied.evaluate(["P.x"], p, np.linspace(0, 1, 3)).shape == (1, 0, 3)
    p = varied.parameters(np.array([[0.04, 0.041]]))
    assert varied.evaluate(["P.x"], p, np.empty(0)).shape == (1, 2, 0)
    assert np.isinf(varied.failures(p, np.empty(0)).time).all()


def test_out_is_written_and_returned() -> None:
    varied = Varied(compile_mechanism(load(EXAMPLES / "four_bar.yaml")), ["a"])
    p, t = varied.parameters(np.array([[0.04, 0.041]])), np.linspace(0, 1, 3)
    out = np.empty((1, 2, 3))
    assert varied.evaluate(["P.x"], p, t, out=out) is out
    assert np.array_equal(out, varied.evaluate(["P.x"], p, t))
