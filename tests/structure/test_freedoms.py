"""The orientation of freedoms against the rank of a Jacobian at random places, and mechanisms of many links."""

from __future__ import annotations

import random
from typing import Any

import numpy as np
import pytest
from large_models import CLASSES, FAULTS

from linkwright.compilation import examine
from linkwright.findings import Joined
from linkwright.model.document import Document
from linkwright.structure import HigherGroup, Topology, decompose
from linkwright.structure.freedoms import Freedoms
from linkwright.structure.orientation import Orientation

MANY = 60


def rank(rows: list[tuple[int, int, list[float]]], links: int) -> int:
    """The rank of rows that each tie two bodies by the motion of one place in one direction, all at random."""
    jacobian = np.zeros((len(rows), 3 * links))
    for i, (a, b, slopes) in enumerate(rows):
        jacobian[i, 3 * a : 3 * a + 3] = slopes
        jacobian[i, 3 * b : 3 * b + 3] -= slopes
    return int(np.linalg.matrix_rank(jacobian, tol=1e-9))


@pytest.mark.parametrize("seed", range(40))
def test_independent_rows_are_those_that_raise_the_rank(seed: int) -> None:
    """Pins between random bodies, any number of them: each row is laid where the rank at random places grows by it."""
    random_ = random.Random(seed)
    links = random_.randint(2, 7)
    laid: Orientation[int] = Orientation(dict.fromkeys(range(links), 3))
    rows: list[tuple[int, int, list[float]]] = []
    for _ in range(random_.randint(1, 2 * links)):
        a, b = random_.sample(range(links), 2)
        x, y = random_.uniform(-1, 1), random_.uniform(-1, 1)
        for slopes in ([1.0, 0.0, -y], [0.0, 1.0, x]):
            before, rows = rank(rows, links), [*rows, (a, b, slopes)]
            rigid = laid.lay(a, b)
            assert bool(rigid) == (rank(rows, links) == before)
            assert not rigid or {a, b} <= rigid
    assert sum(laid.free.values()) == 3 * links - rank(rows, links)


def model(kind: str, fault: str, links: int = MANY, seed: int = 1) -> dict[str, Any]:
    return FAULTS[fault](CLASSES[kind](links, seed), seed)


@pytest.mark.parametrize("kind", CLASSES)
def test_many_links_are_placed(kind: str) -> None:
    structure = decompose(Document.model_validate(model(kind, "sound")))
    assert not structure.findings
    assert {link for step in structure.steps for link in step.links} == {*structure.topology.moving}


def test_a_ring_is_one_group_whatever_its_size() -> None:
    compiled, findings = examine(Document.model_validate(model("ring", "sound", 30)))
    assert compiled is not None
    assert not findings
    (group,) = [step for step in compiled.structure.steps if isinstance(step, HigherGroup)]
    assert len(group.links) == 30


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("kind", CLASSES)
def test_a_misspelled_pin_among_many_links_is_told(kind: str, seed: int) -> None:
    findings = decompose(Document.model_validate(model(kind, "misspelled", seed=seed))).findings
    assert 1 <= len(findings) <= 2
    pairs = [(finding.data["point"], finding.data["other"]) for finding in findings if "point" in finding.data]
    assert any(a == f"{b}x" or b == f"{a}x" for a, b in pairs)


@pytest.mark.parametrize("kind", ["chain", "grid", "two_tree"])
def test_one_bar_too_many_among_many_links_is_named(kind: str) -> None:
    (finding,) = decompose(Document.model_validate(model(kind, "held"))).findings
    assert finding.code == "structure.overconstrained"
    assert finding.data["excess"] == 1


def test_links_apart_are_named() -> None:
    (finding,) = decompose(Document.model_validate(model("chain", "apart"))).findings
    assert (finding.code, str(finding.data["links"])) == ("structure.loose", "z0, z1, z2, z3")


def test_two_pins_between_the_same_loose_links_are_told_beside_what_is_loose() -> None:
    """A four-bar apart whose first two links are one body by a second pin: a rigid triangle, loose."""
    data = model("chain", "apart")
    data["sketch"]["Y"] = [10, -300]
    data["links"]["z0"]["points"].append("Y")
    data["links"]["z1"]["points"].append("Y")
    found = {finding.code: finding for finding in decompose(Document.model_validate(data)).findings}
    assert {*found} == {"structure.overconstrained", "structure.loose"}
    assert found["structure.overconstrained"].data == {"links": Joined(["z0", "z1"]), "excess": 1}
    assert found["structure.loose"].data["freedom"] == 3


def test_alike_points_are_told_as_a_pin_that_may_be_meant() -> None:
    finding = decompose(Document.model_validate(model("chain", "misspelled"))).findings[0]
    assert finding.code == "structure.unpinned"
    assert finding.data["point"] == f"{finding.data['other']}x"


def test_a_name_with_another_letter_is_told_where_one_pin_is_lacking() -> None:
    """Half of C4 and CX is enough where two freedoms are left over, as a pin takes; not where more are."""
    data = model("chain", "sound")
    data["sketch"]["CX"] = data["sketch"]["C4"]
    rocker = next(link for link in list(data["links"])[::-1] if "C4" in data["links"][link]["points"])
    points = data["links"][rocker]["points"]
    points[points.index("C4")] = "CX"
    (finding,) = decompose(Document.model_validate(data)).findings
    assert finding.code == "structure.unpinned"
    assert {finding.data["point"], finding.data["other"]} == {"C4", "CX"}
    data["links"] |= {"z": {"points": ["Z0", "Z1"]}}
    data["sketch"] |= {"Z0": [0, 0], "Z1": [9, 9]}
    assert "structure.unpinned" not in {finding.code for finding in decompose(Document.model_validate(data)).findings}


def test_the_links_that_one_hangs_on_come_with_it() -> None:
    document = Document.model_validate(model("chain", "sound", 8))
    together = Freedoms(Topology(document), ["frame", "crank"], {}).supporting_links
    assert together["l0"] == together["l1"] == {"l0", "l1"}
    assert together["l2"] == {"l0", "l1", "l2", "l3"}
