"""Regions that are searched for between curves: slivers, what is planted among the curves, and what is said of them."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import shapely

import linkwright as lw
from helpers.compiled import compiled_from
from helpers.shown import blocks, heads, rows
from linkwright.model.document import parse_document
from linkwright.presentation.blocks import Table
from linkwright.studies.workspace import region_search as module
from linkwright.studies.workspace.certificate import SEARCHED
from linkwright.studies.workspace.curves import Segments, smooth, traced
from linkwright.studies.workspace.mesh import DriveBox, Mesh, found_pits, mesh
from linkwright.studies.workspace.region_search import ROUGH, _with_slivers, reached, searched
from linkwright.studies.workspace.report import report, workspace_entry, workspace_sentences
from linkwright.studies.workspace.sheet import ModeSheet
from linkwright.words import say
from studies.workspace.models import arm, triad_turned_round

CHORD = 1e-5
PART = DriveBox((0.3, 0.4), (1.7, 2.0))


class Traced:
    """An arm's curves with both drives in ranges."""

    def __init__(self) -> None:
        self.sheet = ModeSheet(arm(1.0, 0.6), "P", ("shoulder", "elbow"), ())
        self.mesh: Mesh = mesh(self.sheet, PART, 64, found_pits(self.sheet, PART))
        self.segments: list[Segments] = smooth(self.sheet, traced(self.sheet, self.mesh), CHORD)

    def told(self, segments: list[Segments]) -> tuple[Any, dict[str, float]]:
        shape, faults = reached(self.sheet, PART, self.mesh, segments, CHORD)
        return shape, {fault.kind: fault.size for fault in faults}


@pytest.fixture(scope="module")
def curves() -> Traced:
    return Traced()


def area() -> float:
    """The arm's region: between the radii at both ends of the elbow's range, over the shoulder's."""
    squares = [1 + 0.36 + 1.2 * np.cos(elbow) for elbow in (PART.low[1], PART.high[1])]
    return float((PART.high[0] - PART.low[0]) / 2 * (squares[0] - squares[1]))


def test_what_is_between_all_curves_has_no_fault(curves: Traced) -> None:
    shape, faults = curves.told(curves.segments)
    assert not faults
    assert shape.area == pytest.approx(area(), rel=1e-4)


def parted(one: Segments, kept: Any) -> Segments:
    return Segments(one.kind, one.a[:, kept], one.b[:, kept], one.off[kept])


def longest(segments: list[Segments]) -> int:
    return int(np.argmax([one.a.shape[1] for one in segments]))


def test_curves_with_a_gap_dangle(curves: Traced) -> None:
    """Ten pieces dropped from the middle of the rim."""
    segments, k = [*curves.segments], longest(curves.segments)
    count = segments[k].a.shape[1]
    segments[k] = parted(segments[k], np.abs(np.arange(count) - count // 3) > 5)
    shape, faults = curves.told(segments)
    assert set(faults) & {"dangle", "cut"} and max(faults.values()) > 0.1
    assert shape.area < 0.5 * area()


def test_a_piece_by_itself_across_a_face_dangles(curves: Traced) -> None:
    q = np.stack([np.linspace(0.8, 1.2, 41), np.full(41, 1.2)])
    extra = Segments("limit", q[:, :-1], q[:, 1:], np.zeros(40))
    _, faults = curves.told([*curves.segments, extra])
    long = 0.4 * float(np.sqrt(1.36 + 1.2 * np.cos(1.2)))  # an arc about the shoulder
    assert faults["dangle"] == pytest.approx(long, rel=1e-3)


def test_a_bridge_between_two_faces_is_a_cut(curves: Traced) -> None:
    """From a small ring within the region to its outer edge: neither dangles, nor does it bound a face."""
    turn = np.linspace(0, 2 * np.pi, 121)
    ring = np.array([[1.0], [1.2]]) + 0.1 * np.stack([np.cos(turn), np.sin(turn)])
    edge = next(one for one in curves.segments if one.a.size)
    start, stop = ring[:, 0], edge.a[:, np.hypot(*(edge.a - ring[:, :1])).argmin()]
    way = start[:, None] + np.linspace(0, 1, 60) * (stop - start)[:, None]
    extra = [Segments("limit", one[:, :-1], one[:, 1:], np.zeros(one.shape[1] - 1)) for one in (ring, way)]
    shape, faults = curves.told([*curves.segments, *extra])
    assert faults["cut"] > 0.1
    assert shape.area == pytest.approx(area(), rel=1e-3)


def test_pieces_that_have_no_place_are_told(curves: Traced) -> None:
    segments, k = [*curves.segments], longest(curves.segments)
    one = segments[k]
    a = one.a.copy()
    a[:, 3:6] = np.nan
    segments[k] = Segments(one.kind, a, one.b, np.full(one.off.shape, 1.0))
    _, faults = curves.told(segments)
    assert faults["nowhere"] == 3


def test_no_curves_bound_nothing(curves: Traced) -> None:
    shape, faults = curves.told([parted(one, slice(0, 0)) for one in curves.segments])
    assert shape.is_empty and not faults


def test_slivers_go_with_the_neighbour_of_the_longest_common_edge() -> None:
    """A sliver with 1 m in common with a face that isn't reached, 3 m with one that is; and one beside that sliver."""
    faces = np.array(
        [
            shapely.box(0, 1, 3, 2),  # reached
            shapely.box(0, -1, 1, 0.9),  # not
            shapely.box(0, 0.9, 3, 1),  # the sliver
            shapely.box(1, 0.8, 3, 0.9),  # one that meets reached faces through the first only
            shapely.box(9, 9, 10, 9.1),  # by itself
        ]
    )
    hit = np.array([1, -1, 0, 0, 0])
    assert _with_slivers(faces, hit).tolist() == [1, -1, 1, -1, 0]
    assert hit.tolist() == [1, -1, 0, 0, 0]
    assert _with_slivers(faces, np.array([-1, 1, 0, 0, 0])).tolist() == [-1, 1, -1, 1, 0]


def test_an_area_that_does_not_settle_is_a_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    """Held to no change at all, on meshes that never have the same curves."""
    monkeypatch.setattr(module, "MESHES", ((16, 16, False),))
    sheet = ModeSheet(arm(1.0, 0.6), "P", ("shoulder", "elbow"), ())
    found = searched(sheet, PART, CHORD)
    assert [fault.kind for fault in found.faults] == ["unsettled"]
    x, y = found.faults[0].at
    assert found.shape.contains(shapely.Point(x, y)) and found.shape.area == pytest.approx(area(), rel=1e-3)


def test_the_meshes_with_the_least_faults_are_taken(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "MESHES", ((16, 16, False), (32, 64, False)))
    sheet = ModeSheet(arm(1.0, 0.6), "P", ("shoulder", "elbow"), ())
    found = searched(sheet, PART, CHORD)
    assert not found.faults and found.steps == 64 and found.change < 1e-3


def asked() -> dict[str, Any]:
    data = triad_turned_round()
    limits = {"motor": [1.8, 2.2], "servo": [0.8, 1.2]}
    return data | {"studies": {"workspace": {"point": "P", "chord": 1e-4, "modes": "own", "drives": limits}}}


def test_what_has_no_inverse_in_closed_form_is_searched_for_and_says_so() -> None:
    outcome = lw.workspace(parse_document(asked()))
    (one,) = outcome.regions
    certificate = one.region.certificate
    assert certificate.grade == SEARCHED and certificate.area is None and not certificate.certified
    assert not certificate.parts and not certificate.holes
    entry = workspace_entry(outcome)["workspace"]["regions"][0]["certificate"]
    assert entry["grade"] == SEARCHED and entry["area"] is None and entry["certified"] is False
    sentences = [*map(str, workspace_sentences(outcome))]
    assert say("workspace.searched", count=1) in sentences and say("workspace.certified") not in sentences
    table = next(one for one in blocks(report(outcome), Table) if one.name == "regions")
    row = dict(zip(heads(table), rows(table)[0], strict=True))
    assert row[say("workspace.column.within")] == "–" and row[say("workspace.column.grade")] == "searched"
    assert held(one.region.sheet, one.region.shape) > 0.999


def held(sheet: ModeSheet, shape: Any) -> float:
    """The share of places that values of the drives lead to that lie in a shape."""
    at = sheet.place(np.random.default_rng(0).uniform([[1.8], [0.8]], [[2.2], [1.2]], (2, 3000)))[0]
    return float(shapely.contains_xy(shape, *at).mean())


def test_curves_that_cannot_be_followed_are_a_finding_and_soon() -> None:
    """In this mode M and K meet all along a curve of the drives' values, where the hand may point anywhere."""
    compiled = compiled_from(triad_turned_round())
    whole = DriveBox((0.0, 0.0), (2 * np.pi, 2 * np.pi), (True, True)).askew()
    found = searched(ModeSheet(compiled, "P", ("motor", "servo"), (-1.0, 1.0)), whole, CHORD)
    assert [fault.kind for fault in found.faults] == ["rough"] and found.shape.is_empty
    assert found.faults[0].size > ROUGH
