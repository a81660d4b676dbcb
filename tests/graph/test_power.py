"""Power of elements: drives' power less the rate of all stored energy is what elements take, in every example."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from helpers.compiled import compiled_from
from helpers.longer import mostly_long
from linkwright.compilation import compile_mechanism
from linkwright.findings import ModelError
from linkwright.model.document import load
from studies.models import slider_crank

EXAMPLES = sorted((Path(__file__).parents[2] / "examples").glob("*.yaml"))
TIMES = np.linspace(0.013, 1.1, 37)


@pytest.mark.parametrize("path", mostly_long(EXAMPLES, EXAMPLES[::3].__contains__), ids=lambda path: path.stem)
def test_nothing_is_lost(path: Path) -> None:
    """The energies are sums over links, the powers over what acts: nothing in common but the motion."""
    try:
        compiled = compile_mechanism(load(path), path.parent)
    except ModelError:
        pytest.skip("it has no drive")
    values, rates = compiled.rates(["energy.supplied", "energy.dissipated", "energy.stored"], TIMES)
    terms = np.array([values[0], -values[1], -rates[2]])
    known = np.isfinite(terms).all(axis=0)
    assert known.any()
    powers = [f"{name}.power" for name in compiled.mechanism.drives]
    size = np.abs(compiled.evaluate([*powers, *powers], TIMES)[:, known]).max(initial=0.0)
    size = max(size, np.abs(terms[:, known]).max(initial=0.0), 1e-9)
    assert np.abs(terms.sum(axis=0)[known]).max() <= 1e-8 * size


def test_each_kind() -> None:
    """A load's force times velocity; a spring's power, and what its damper takes; friction; a drive."""
    data = slider_crank(
        loads={
            "press": {"on": "slider", "at": "C", "force": ["-30 N", "5 N"], "torque": "3 N*m"},
            "pair": {"on": "rod", "against": "crank", "at": "B", "torque": "2 N*m"},
        },
        springs={"pull": {"from": "F", "to": "C", "stiffness": "2 N/mm", "free": "50 mm", "damping": "7 N*s/m"}},
        friction={"rail": {"slide": "guide", "coefficient": 0.1, "length": "40 mm"}},
    )
    names = ["power(press).supplied", "power(pair).supplied", "power(pull).supplied", "power(pull).dissipated"]
    names += ["power(rail).dissipated", "power(motor).supplied"]
    names += ["C.vx", "rod.omega", "crank.omega", "pull.power", "pull.v", "rail.power", "motor.power"]
    found = dict(zip(names, compiled_from(data).evaluate(names, TIMES), strict=True))
    expected = [
        -30 * found["C.vx"],
        2 * (found["rod.omega"] - found["crank.omega"]),
        found["pull.power"],
        7 * found["pull.v"] ** 2,
        -found["rail.power"],
        found["motor.power"],
    ]
    for name, one in zip(names, expected, strict=False):
        np.testing.assert_allclose(found[name], one, rtol=1e-11, atol=1e-11, err_msg=name)
