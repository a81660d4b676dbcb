"""Enclosures of the examples' measures hold what their runs compute at random times."""

from pathlib import Path

import exact
import numpy as np
import pytest
from hypothesis import given, settings

from helpers.compiled import compiled_of, regular
from helpers.longer import mostly_long
from helpers.random_mechanisms import DURATION, mechanisms
from helpers.runs import EXAMPLES, edges, example_run, trees
from linkwright.enclosures import Enclosure
from linkwright.enclosures.bounds import evaluated
from linkwright.expressions.language import parse
from linkwright.results import Run

NAMES = sorted(
    path.name for path in EXAMPLES.glob("*.yaml") if "measures:" in path.read_text() and "  cycle:" in path.read_text()
)
SAMPLES = 50
WITHOUT_BOUNDS = {
    "lifting_crank.yaml",
    "parallelogram.yaml",
    "scotch_yoke_friction.yaml",
    "slider_crank_friction.yaml",
    "wedge_lift.yaml",
}
"""Change points; friction, whose solution isn't enclosed."""


@pytest.mark.parametrize("name", mostly_long(NAMES, lambda name: name in WITHOUT_BOUNDS or name in NAMES[::3]))
def test_samples_lie_inside(name: str) -> None:
    run = example_run(name)
    nodes = trees(run)
    enclosure = Enclosure(run, list(nodes.values()))
    ends = edges(run, 60)
    on = enclosure.panels(ends[:-1], ends[1:])
    models = enclosure(on)
    rng = np.random.default_rng(1)
    h = rng.uniform(-0.999999, 0.999999, (SAMPLES, on.count))
    t = (on.mid + on.half * h).ravel()
    clear = run.compiled.passages.outside(t).reshape(h.shape)
    # Panels are a little wider than asked for; past an edge where a load begins, its other side is computed.
    clear &= (t.reshape(h.shape) >= ends[:-1]) & (t.reshape(h.shape) <= ends[1:])
    for measure, (node, model) in zip(nodes, zip(nodes.values(), models, strict=True), strict=True):
        value = np.asarray(run.jets(node, t).d[0]).reshape(h.shape)
        middle = evaluated(model.c[:, None, :], h)
        size = np.nanmax(np.abs(value))
        with np.errstate(invalid="ignore"):
            away = np.where(clear & np.isfinite(model.r), np.abs(value - middle) - model.r, -np.inf)
        assert away.max() <= 1e-11 * size, measure
        assert np.isfinite(model.r).mean() > 0.5 or name in WITHOUT_BOUNDS, measure


def test_the_paper_feeder_in_50_digits() -> None:
    """Enclosures hold what a formulation of its own gives in 50 digits, its decimals against their doubles apart."""
    run = example_run("paper_feeder.yaml")
    names = ["motor.torque", "force(frame, crank).x", "force(rocker, coupler).y", "E.x", "E.vx", "rocker.alpha"]
    swapped = [name.replace("rocker, coupler", "coupler, rocker") for name in names]
    enclosure = Enclosure(run, [run.compiled.quantities.dimensions.bind(parse(name), None) for name in names])
    ends = np.linspace(run.start, run.stop, 401)
    on = enclosure.panels(ends[:-1], ends[1:])
    models = enclosure(on)
    some = np.arange(3, 400, 23)
    h = np.linspace(-1, 1, some.size)
    t = on.mid[some] + on.half[some] * h
    true = exact.reference(exact.feeder, swapped, t)
    for name, model, value in zip(names, models, true, strict=True):
        value = -value if "rocker, coupler" in name else value
        away = np.abs(evaluated(model.c[:, some], h) - value) - model.r[some]
        assert away.max() <= 3e-15 * np.abs(value).max(), name
        assert model.r.max() < 1e-9 * np.abs(value).max(), name


@settings(max_examples=40)
@given(plain=mechanisms())
def test_random_mechanisms_lie_inside(plain) -> None:  # type: ignore[no-untyped-def]
    compiled = compiled_of(plain)
    t = np.linspace(0.0, DURATION, 401)
    regular(compiled, t)
    run = Run(compiled, 0.0, DURATION, 100)
    names = [f"{drive}.power" for drive in compiled.graph.drives]
    names += [f"{link}.{row}" for link in compiled.structure.topology.moving for row in ("angle", "alpha")]
    nodes = [compiled.quantities.dimensions.bind(parse(name), None) for name in names]
    enclosure = Enclosure(run, nodes)
    ends = np.linspace(0.0, DURATION, 81)
    on = enclosure.panels(ends[:-1], ends[1:])
    panel = np.minimum((t / DURATION * 80).astype(int), 79)
    h = (t - on.mid[panel]) / on.half[panel]
    for name, node, model in zip(names, nodes, enclosure(on), strict=True):
        value = np.asarray(run.jets(node, t).d[0])
        away = np.abs(evaluated(model.c[:, panel], h) - value) - model.r[panel]
        assert away.max() <= 1e-11 * np.abs(value).max() + 1e-13, name
        assert np.isfinite(model.r).all()


def test_halved_panels_are_enclosed_more_closely_by_the_order() -> None:
    run = example_run("paper_feeder.yaml")
    enclosure = Enclosure(run, [trees(run)["M0_feed"]])
    bounds = []
    for panels in (100, 200):
        ends = np.linspace(run.start, run.stop, panels + 1)
        (model,) = enclosure(enclosure.panels(ends[:-1], ends[1:]))
        bounds.append(np.max(model.r))
    assert bounds[1] < bounds[0] / 100


def test_turns_of_angles_are_counted() -> None:
    """An angle that the graph knows from its axis alone runs on over whole turns."""
    run = example_run("jansen_leg.yaml")
    node = run.compiled.quantities.dimensions.bind(parse("crank.angle"), None)
    enclosure = Enclosure(run, [node])
    ends = np.linspace(run.start, run.stop, 21)
    (model,) = enclosure(enclosure.panels(ends[:-1], ends[1:]))
    assert model.c[0, -1] - model.c[0, 0] == pytest.approx(2 * np.pi * 0.95)


def test_the_files_are_there() -> None:
    assert len(NAMES) > 25
    assert Path(EXAMPLES).is_dir()
