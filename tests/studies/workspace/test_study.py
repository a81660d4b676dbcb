"""The workspace study: closed forms of small mechanisms, modes and values apart, and all that can be asked wrongly."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad

import linkwright as lw
from helpers.workspaces import arm, findings, five_bar, four_bar, performed, polar
from linkwright.app.job import examine_document
from linkwright.app.single_study import altered
from linkwright.blocks import Threads
from linkwright.model.document import parse_document
from linkwright.studies.interruption import Stopped
from linkwright.studies.run_context import RunContext
from linkwright.studies.workspace import study
from linkwright.studies.workspace.options import WorkspaceOptions
from linkwright.studies.workspace.regions import Region
from linkwright.studies.workspace.study import WorkspaceStudy

MM2 = 1e6
EXAMPLES = Path(__file__).parents[3] / "examples"


def test_an_arm_reaches_an_annulus_for_each_value() -> None:
    outcome = performed(arm(**{"for": {"b": [30, 40]}})).workspace
    assert outcome is not None and outcome.done
    assert [one.values["b"] for one in outcome.workspaces] == pytest.approx([0.03, 0.04])
    (holed,), (whole,) = (one.regions for one in outcome.workspaces)
    for region, b, holes in ((holed, 30, 1), (whole, 40, 0)):
        found = region.figures
        assert found.area * MM2 == pytest.approx(np.pi * ((40 + b) ** 2 - (40 - b) ** 2), rel=3e-4)
        assert (found.holes, found.parts) == (holes, 1)
        assert np.array(found.bounds) * 1e3 == pytest.approx((40 + b) * np.array([-1, -1, 1, 1]), abs=0.01)
    assert holed.mode == ""  # there is one only


def test_limits_of_drives_bound_a_sector() -> None:
    data = polar(drives={"elbow": ["50 mm", "80 mm"], "shoulder": [0, 90]})
    outcome = performed(data).workspace
    assert outcome is not None
    (region,) = outcome.regions
    assert region.figures.area * MM2 == pytest.approx(np.pi / 4 * (80**2 - 50**2), rel=1e-4)
    assert region.figures.perimeter * 1e3 == pytest.approx(60 + np.pi / 2 * 130, rel=1e-4)
    assert {one.kind for one in region.region.segments if one.a.size} == {"limit"}


def test_modes_are_told_apart_and_their_overlap_is_found() -> None:
    """Far from singular poses: each mode maps the rectangle of the drives one to one, so its area is an integral."""
    data = five_bar(drives={"motor": [80, 120], "servo": [40, 100]})
    outcome = performed(data).workspace
    assert outcome is not None and outcome.done
    one = outcome.workspaces[0]
    assert [region.mode for region in one.regions] == ["C: right of B-D", "C: left of B-D"]
    for region in one.regions:
        sheet, box = region.region.sheet, region.region.box
        nodes, weights = np.polynomial.legendre.leggauss(24)
        half = box.size / 2
        axes = [low + h * (1 + nodes) for low, h in zip(box.low, half, strict=True)]
        q = np.stack(np.meshgrid(*axes, indexing="ij")).reshape(2, -1)
        share = np.abs(sheet.look(q).determinant) * np.outer(weights, weights).ravel() * half.prod()
        assert region.figures.area == pytest.approx(share.sum(), rel=1e-4)
    (overlap,) = one.overlaps
    both = sum(region.figures.area for region in one.regions) - overlap.shape.area
    assert one.union.area == pytest.approx(both, rel=1e-6)
    own = performed(five_bar(modes="own", drives={"motor": [80, 120], "servo": [40, 100]})).workspace
    assert own is not None and [r.mode for r in own.regions] == [one.regions[0].mode]


def test_one_drive_gives_the_points_curve() -> None:
    outcome = performed(four_bar()).workspace
    assert outcome is not None and outcome.done and not outcome.regions
    own, other = outcome.workspaces[0].curves
    assert own.mode == "C: left of B-D" and own.stretches[0].closed

    def place(angle: float) -> complex:
        """B, then C by the cosine rule on the triangle B-C-D, then P on the coupler."""
        b = 15 * np.exp(1j * angle)
        to_d = 50 - b
        d = abs(to_d)
        corner = np.arccos((d**2 + 40**2 - 35**2) / (2 * d * 40))
        return complex(b + (20 + 20j) * to_d / d * np.exp(1j * corner))

    def speed(angle: float) -> float:
        h = 1e-5
        return abs(place(angle + h) - place(angle - h)) / (2 * h)

    assert own.length * 1e3 == pytest.approx(quad(speed, 0, 2 * np.pi)[0], rel=1e-5)
    assert other.length != pytest.approx(own.length, rel=1e-2)


def test_a_rocker_driven_through_its_range_stops_at_its_ends() -> None:
    data = four_bar()
    data["drives"]["motor"] |= {"turns": "rocker", "start": "110 deg"}
    data["assembly"] = {"B": "left of C-A"}
    outcome = performed(data | {"studies": {"workspace": {"point": "B"}}}).workspace
    assert outcome is not None
    for curve in outcome.workspaces[0].curves:
        assert not any(one.closed for one in curve.stretches)
        assert all(np.allclose(np.hypot(*one.at), 0.015) for one in curve.stretches)


def test_lengths_that_never_close_tell_by_how_much() -> None:
    outcome = performed(five_bar(**{"for": {"base": [50]}})).workspace
    assert outcome is not None and not outcome.done and not outcome.workspaces
    (found,) = outcome.failures
    assert found.code == "workspace.never-closes"
    # Cranks towards each other leave 50 - 20 mm between the pins, and the couplers span 24.
    assert found.data["by"] == "6" and found.data["distance"] == "30"
    assert "at any pose for base = 50 mm: " in found.what and "6 mm more than the links can span" in found.what


def test_a_point_that_one_drive_moves_has_no_area() -> None:
    outcome = performed(arm(point="B")).workspace
    assert outcome is not None and [f.code for f in outcome.failures] == ["workspace.no-area"]


def codes(data: dict[str, Any]) -> list[str]:
    return [found.code for found in findings(data)]


def test_what_is_wrong_is_told_at_once() -> None:
    wrong = arm(point="A", drives={"elbow": [90, 10], "knee": [0, 1]}, **{"for": {"c": [1], "b": [], "a": ["1 kg"]}})
    assert sorted(codes(wrong)) == [
        "expression.units-conflict",
        "name.unknown",
        "name.unknown-parameter",
        "value.not-rising",
        "workspace.fixed-point",
        "workspace.no-values",
    ]


@pytest.mark.parametrize(
    ("options", "code"),
    [
        ({"point": "X"}, "name.unknown"),
        ({"modes": "some"}, "study.choice"),
        ({"for": {"a": ["1/0"]}}, "value.not-finite"),
        ({"for": {"a": 4}}, "study.options"),
        ({"chord": 0}, "study.options"),
        ({"drives": {"elbow": [0, 400]}}, "study.wide-range"),
        ({"for": {"a": [*range(1, 30)], "b": [*range(1, 30)]}}, "workspace.too-many"),
    ],
)
def test_options_that_cant_be(options: dict[str, Any], code: str) -> None:
    assert codes(arm(**options)) == [code]


def test_a_slide_needs_a_range() -> None:
    assert codes(polar()) == ["workspace.no-range"]


def test_other_numbers_of_drives_and_higher_groups_are_refused() -> None:
    three = arm()
    three["links"]["hand"] = {"points": {"E": [0, 0], "G": [10, 0]}}
    three["drives"]["wrist"] = {"turns": "hand", "on": "fore", "speed": "10 rpm", "start": "0 deg"}
    assert codes(three) == ["workspace.drives"]
    triad = examine_document(
        altered(lw.load(EXAMPLES / "platform.yaml"), "workspace", {"point": "B1"}), only="workspace"
    )
    assert [found.code for found in triad.findings] == ["workspace.cluster"]


def test_an_interrupt_keeps_what_is_done() -> None:
    document = parse_document(arm())
    assert document is not None
    compiled = lw.compile(document)
    options = WorkspaceOptions.model_validate({"point": "E", "chord": 1e-3, "for": {"b": [30, 35, 20]}})

    def told(done: int, total: int) -> None:
        assert total == 3
        if done:
            raise KeyboardInterrupt

    with pytest.raises(Stopped) as stopped:
        WorkspaceStudy().run(compiled, options, RunContext(runner=Threads(1), progress=told))
    outcome = stopped.value.outcome
    assert not outcome.done and [f.code for f in outcome.failures] == ["workspace.stopped"]
    done = len(outcome.workspaces)  # the one told of, and one that was at work by then
    assert 1 <= done <= 2 and f"{done} of 3 regions" in stopped.value.what
    assert outcome.workspaces[0].regions[0].figures.area * MM2 == pytest.approx(np.pi * (70**2 - 10**2), rel=3e-3)


def test_threads_change_nothing() -> None:
    """Both modes for two lengths, to the last bit."""
    data = five_bar(chord=1e-3, drives={"motor": [80, 120], "servo": [40, 100]}, **{"for": {"base": [9, 10]}})
    document = parse_document(data)
    assert document is not None
    options = WorkspaceOptions.model_validate(data["studies"]["workspace"])
    one, two = (
        [
            region.shape.wkb
            for region in WorkspaceStudy()
            .run(lw.compile(document), options, RunContext(runner=Threads(workers)))
            .regions
        ]
        for workers in (1, 3)
    )
    assert len(one) == 4 and one == two


def test_nothing_is_missed_around_a_pit() -> None:
    """Both pins of the couplers meet within the drives' ranges, where two singular curves pass as well. The area is
    that of the places of a grid of 2400 x 2400 for which the two dyads, solved backwards, have such drive values."""
    data = five_bar(modes="own", drives={"motor": [0, 200]})
    data["parameters"]["base"] = 6
    outcome = performed(data).workspace
    assert outcome is not None and not outcome.warnings
    (region,) = outcome.regions
    assert region.region.segments[2].a.size  # the rings around pits
    assert region.figures.area * MM2 == pytest.approx(892.456, abs=0.02)


def test_a_region_that_lacks_a_part_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    """Half of the annulus taken away from each region that is made."""
    import shapely

    made = study.region

    def halved(*given: Any, **more: Any) -> Region:
        whole = made(*given, **more)
        return replace(whole, shape=whole.shape.intersection(shapely.box(0, -1, 1, 1)))

    monkeypatch.setattr(study, "region", halved)
    outcome = performed(arm()).workspace
    assert outcome is not None
    (found,) = outcome.failures
    assert found.code == "workspace.incomplete" and float(found.data["share"]) == pytest.approx(50, abs=1.5)


def test_what_is_sampled_lies_inside_where_a_dead_position_meets_a_limit() -> None:
    """The arm is straight inside of the elbow's range, so that the singular curve ends on the limits."""
    import shapely

    outcome = performed(arm(drives={"shoulder": [10, 100], "elbow": [-50, 95]})).workspace
    assert outcome is not None
    (reached,) = outcome.regions
    shoulder, elbow = np.radians(np.random.default_rng(1).uniform([[10], [-50]], [[100], [95]], (2, 20_000)))
    tip = 0.04 * np.exp(1j * shoulder) + 0.03 * np.exp(1j * (shoulder + elbow))
    shape = reached.shape.buffer(2 * outcome.chord)
    assert shapely.contains_xy(shape, tip.real, tip.imag).all()
    assert reached.figures.bounds[3] == pytest.approx(0.07, abs=2 * outcome.chord)
