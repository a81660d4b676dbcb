"""Enclosures of the examples' measures hold what their runs compute at random times."""

from pathlib import Path

import numpy as np
import pytest

from helpers.runs import EXAMPLES, edges, example_run, trees
from linkwright.enclosures import Enclosure
from linkwright.enclosures.bounds import evaluated

NAMES = sorted(
    path.name for path in EXAMPLES.glob("*.yaml") if "measures:" in path.read_text() and "  cycle:" in path.read_text()
)
SAMPLES = 50


@pytest.mark.parametrize("name", NAMES)
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
    for measure, (node, model) in zip(nodes, zip(nodes.values(), models, strict=True), strict=True):
        value = np.asarray(run.jets(node, t).d[0]).reshape(h.shape)
        middle = evaluated(model.c[:, None, :], h)
        size = np.nanmax(np.abs(value))
        with np.errstate(invalid="ignore"):
            away = np.where(clear & np.isfinite(model.r), np.abs(value - middle) - model.r, -np.inf)
        assert away.max() <= 1e-11 * size, measure
        assert np.isfinite(model.r).mean() > (0.5 if name != "parallelogram.yaml" else 0.0), measure


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
    node = run.compiled.quantities.dimensions.bind(_parsed("crank.angle"), None)
    enclosure = Enclosure(run, [node])
    ends = np.linspace(run.start, run.stop, 21)
    (model,) = enclosure(enclosure.panels(ends[:-1], ends[1:]))
    assert model.c[0, -1] - model.c[0, 0] == pytest.approx(2 * np.pi * 0.95)


def _parsed(text: str):  # type: ignore[no-untyped-def]
    from linkwright.model.expressions import parse

    return parse(text)


def test_the_files_are_there() -> None:
    assert len(NAMES) > 25
    assert Path(EXAMPLES).is_dir()
