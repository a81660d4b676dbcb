"""Sections ``quality`` and ``errors``: closed forms of an arm, direct calls, the accuracy study, what is wrong."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import shapely

from helpers.workspaces import arm, findings, five_bar, four_bar, performed
from linkwright.app.job import Job
from linkwright.studies.workspace.coverage import covered
from linkwright.studies.workspace.errors_outcome import ErrorsPart
from linkwright.studies.workspace.maps_report import errors_sentences
from linkwright.studies.workspace.quality import QualityTask, quality
from linkwright.studies.workspace.quality_outcome import QualityPart
from linkwright.studies.workspace.raster import raster

A, B = 40.0, 30.0


def toleranced(tolerance: Any = 0.1, **options: Any) -> dict[str, Any]:
    """The arm with a tolerance of both its lengths (mm)."""
    data = arm(A, B, chord=1e-5, **options)
    data["parameters"] = {name: {"value": v, "tolerance": tolerance} for name, v in (("a", A), ("b", B))}
    return data


@pytest.fixture(scope="module")
def whole() -> Job:
    task = {"speeds": {"shoulder": "60 rpm", "elbow": "60 rpm"}, "force": "10 N", "steps": 60}
    return performed(toleranced(quality=task, errors={"limit": "0.17 mm"}))


def test_the_arms_quality(whole: Job) -> None:
    """det J = a b sin(elbow). With both speeds alike, the tip is fastest stretched out."""
    (entry,) = whole.summary["workspace"]["quality"]
    maps = entry["maps"]
    most = maps["manipulability"]["greatest"]
    assert most["value"] == pytest.approx(A * B, rel=1e-9) and maps["manipulability"]["unit"] == "mm^2"
    assert abs(most["drives"]["elbow"] % 180 - 90) < 1e-4
    assert np.hypot(*most["at"]) == pytest.approx(np.hypot(A, B), rel=1e-9)
    assert maps["manipulability"]["least"]["value"] == 0
    assert maps["condition"]["greatest"]["value"] is None and maps["condition"]["greatest"]["unbounded"]
    assert maps["speed"]["greatest"]["value"] == pytest.approx(2 * np.pi * (A + 2 * B))
    assert maps["effort shoulder"]["greatest"]["value"] == pytest.approx(10 * (A + B) * 1e-3)  # N*m: torques go out so
    assert (entry["mode"], entry["steps"]) == ("", 60)
    dead, uncertain = entry["loci"]
    assert (dead["kind"], dead["determinant"]) == ("limit-position", "d(E.x, E.y)/d(shoulder, elbow)")
    assert dead["curves"] == 2 and dead["length"] == pytest.approx(2 * np.pi * (A + B + A - B), rel=1e-3)
    assert (uncertain["kind"], uncertain["curves"]) == ("uncertain", 0)


def test_the_arms_errors(whole: Job) -> None:
    """Stretched out or folded both deviations add up; square to each other they are the legs of a triangle. Of its
    annulus a ring of 0.2 mm is lost on either side."""
    (entry,) = whole.summary["workspace"]["errors"]
    worst, kept, precise = entry["maps"]["error worst"], entry["guaranteed"], entry["precise"]
    assert entry["contributors"] == ["a", "b"]
    assert worst["greatest"]["value"] == pytest.approx(0.2, rel=1e-9)
    assert worst["least"]["value"] == pytest.approx(0.1 * np.sqrt(2), rel=1e-6)
    assert kept["inward"] == pytest.approx([0.2, 0.2], rel=1e-6)
    area = np.pi * ((A + B - 0.2) ** 2 - (A - B + 0.2) ** 2)
    assert 0.9995 * area < kept["area"] < area * 1.00001
    assert kept["share"] == pytest.approx(kept["area"] / whole.summary["workspace"]["regions"][0]["area"])
    cosine = (0.17 / 0.1) ** 2 / 2 - 1  # of the elbow, up to which the error stays within 0.17 mm
    assert precise["limit"] == pytest.approx(0.17)
    assert precise["area"] == pytest.approx(np.pi * 4 * A * B * cosine, rel=2e-3)


def test_guaranteed_parts_lie_within(whole: Job) -> None:
    part = whole.outcomes["workspace"].parts["errors"]
    assert isinstance(part, ErrorsPart)
    (one,) = part.regions
    assert one.reached.shape.buffer(1e-9).contains(one.sure.shape)
    assert one.sure.shape.buffer(1e-9).contains(one.sure.precise)


def test_all_modes_and_values_as_by_direct_calls() -> None:
    data = five_bar(
        drives={"motor": [80, 120], "servo": [40, 100]},
        chord=1e-3,
        **{"for": {"base": [10, 11]}},
        quality={"steps": 20, "force": [0, "-5 N"]},
        errors={"steps": 20},
    )
    data["parameters"] = {"l": {"value": 12, "tolerance": "base/200"}, "base": 10}
    job = performed(data)
    outcome = job.workspace
    assert outcome is not None and outcome.box is not None and outcome.done
    entries, part = job.summary["workspace"]["quality"], outcome.parts["quality"]
    assert isinstance(part, QualityPart)
    assert [(e["mode"], e["base"]) for e in entries] == [
        (r["mode"], r["base"]) for r in job.summary["workspace"]["regions"]
    ]
    for entry, one in zip(entries, part.regions, strict=True):
        direct = quality(one.reached.region.sheet, outcome.box, QualityTask(force=(0.0, -5.0)), 20).maps
        for name in ("condition", "transmission", "effort servo"):
            found = direct.greatest(name)
            assert found is not None
            value = found.value / direct.maps[name].size
            assert entry["maps"][name]["greatest"]["value"] == pytest.approx(value)
    # The tolerance follows the base, and with it the errors of both modes.
    worst = [e["maps"]["error x most"]["greatest"]["value"] for e in job.summary["workspace"]["errors"]]
    assert worst[0] == pytest.approx(worst[1]) and worst[2] == pytest.approx(worst[3])
    data["studies"]["workspace"]["for"] = {"base": [11]}
    data["parameters"]["l"] = {"value": 12, "tolerance": 0.055}
    alike = performed(data).summary["workspace"]["errors"][0]["maps"]["error x most"]["greatest"]["value"]
    assert worst[2] == pytest.approx(alike) and worst[0] != pytest.approx(worst[2], rel=0.05)


def test_error_maps_are_those_of_the_accuracy_study() -> None:
    """Of the same file, at the poses of its cycle; correlated, and with a change of temperature."""
    data = toleranced(errors={"steps": 10})
    data["studies"] |= {
        "cycle": {"duration": "0.2 s", "samples": 12},
        "accuracy": {
            "outputs": ["E.x", "E.y"],
            "samples": 0,
            "correlations": [{"of": ["a", "b"], "is": 0.5}],
            "thermal": {"room": {"change": [-10, 30], "material": "steel"}},
        },
    }
    job = performed(data)
    part, accuracy = job.outcomes["workspace"].parts["errors"], job.outcomes["accuracy"]
    (one,) = part.regions
    assert one.contributors == ["a", "b", "room"]
    for axis in "xy":
        curve = accuracy.curves[f"E.{axis}"]
        q = np.stack([accuracy.compiled.laws[drive](curve.t).d[0] for drive in ("shoulder", "elbow")])
        found = one.maps.figures(q)
        np.testing.assert_allclose(found[f"error {axis} least"], curve.worst[0], rtol=1e-9, atol=1e-12)
        np.testing.assert_allclose(found[f"error {axis} most"], curve.worst[1], rtol=1e-9, atol=1e-12)
        np.testing.assert_allclose(found[f"spread {axis}"], 3 * curve.sigma, rtol=1e-9)


def played(clearances: dict[str, Any], tolerance: Any = 0.1, **options: Any) -> dict[str, Any]:
    """The arm with clearances that its accuracy study states."""
    data = toleranced(tolerance, errors={"steps": 20} | options)
    accuracy = {"outputs": ["E.x", "E.y"], "samples": 0, "clearances": clearances}
    data["studies"] |= {"cycle": {"duration": "0.2 s", "samples": 12}, "accuracy": accuracy}
    return data


def test_clearances_of_the_accuracy_study_count() -> None:
    """A pin's clearance displaces the arm's tip by as much wherever it stands; so much more of its annulus is lost."""
    job = performed(played({"A": 0.05, "B": 0.02}, limit="0.24 mm", steps=200))
    (entry,) = job.summary["workspace"]["errors"]
    worst, kept = entry["maps"]["error worst"], entry["guaranteed"]
    assert entry["contributors"] == ["a", "b", "A", "B"]
    assert entry["clearances"] == pytest.approx({"A": 0.05, "B": 0.02})
    assert worst["greatest"]["value"] == pytest.approx(0.27, rel=1e-9)
    assert worst["least"]["value"] == pytest.approx(0.1 * np.sqrt(2) + 0.07, rel=1e-6)
    assert kept["inward"] == pytest.approx([0.27, 0.27], rel=1e-6)
    area = np.pi * ((A + B - 0.27) ** 2 - (A - B + 0.27) ** 2)
    assert 0.9995 * area < kept["area"] < area * 1.00001
    cosine = 1.7**2 / 2 - 1
    assert entry["precise"]["area"] == pytest.approx(np.pi * 4 * A * B * cosine, rel=2e-3)
    told = " ".join(map(str, errors_sentences(job.workspace))) if job.workspace else ""
    assert "a, b deviates within its limits" in told and "A 0.05 mm, B 0.02 mm" in told
    assert "any direction" in told and "radial clearance" in told and "guide" not in told
    # The worst case of the accuracy study itself: with tolerances and all joints in their worst directions.
    (one,) = job.outcomes["workspace"].parts["errors"].regions
    curve = job.outcomes["accuracy"].curves["E.x"]
    q = np.stack([job.outcomes["accuracy"].compiled.laws[drive](curve.t).d[0] for drive in ("shoulder", "elbow")])
    np.testing.assert_allclose(one.maps.figures(q)["error x most"], curve.worst[1] + curve.play[1], rtol=1e-9)


def test_some_clearances_and_clearances_alone() -> None:
    (entry,) = performed(played({"A": 0.05, "B": 0.02}, contributors=["b", "B"])).summary["workspace"]["errors"]
    assert entry["contributors"] == ["b", "B"] and entry["clearances"] == pytest.approx({"B": 0.02})
    assert entry["maps"]["error worst"]["greatest"]["value"] == pytest.approx(0.12)
    data = played({"A": "0.05 mm"})
    data["parameters"] = {"a": A, "b": B}
    job = performed(data)
    (entry,) = job.summary["workspace"]["errors"]
    ends = [entry["maps"]["error worst"][end]["value"] for end in ("least", "greatest")]
    assert ends == pytest.approx([0.05, 0.05]) and entry["contributors"] == ["A"]
    assert job.workspace is not None and "no dimension deviates" in " ".join(map(str, errors_sentences(job.workspace)))


def test_clearances_stated_wrongly() -> None:
    """Told once, though both studies look at them."""
    for clearances, code in (({"C": 0.1}, "clearance.no-joint"), ({"B": -0.1}, "clearance.not-positive")):
        assert [found.code for found in findings(played(clearances))] == [code]
    (found,) = findings(played({"B": 0.1}, contributors=["A"]))
    assert found.code == "name.unknown" and found.data["near"]


def test_a_clearance_that_a_varied_length_makes_impossible() -> None:
    data = played({"B": "(a - 39 mm)/100"})
    data["studies"]["workspace"]["for"] = {"a": [40, 38]}
    job = performed(data)
    assert [one.code for one in job.outcomes["workspace"].failures] == ["clearance.not-positive"]
    assert len(job.outcomes["workspace"].parts["errors"].regions) == 1


def test_some_contributors_and_a_general_class() -> None:
    data = arm(A, B, chord=1e-4, errors={"steps": 10, "contributors": ["b"]})
    data["studies"] |= {"cycle": {"duration": "1 s"}, "accuracy": {"general": "ISO 2768-m", "outputs": ["E.x"]}}
    job = performed(data)
    (entry,) = job.summary["workspace"]["errors"]
    assert entry["contributors"] == ["b"]
    assert entry["maps"]["error worst"]["greatest"]["value"] == pytest.approx(0.2)  # 6 .. 30 mm: plus and minus 0.2


def test_over_the_plane_both_elbows_come_to_each_place(whole: Job) -> None:
    part = whole.outcomes["workspace"].parts["quality"]
    (one,) = part.regions
    found = raster(one.reached.region, one.maps, 60)
    places = np.stack([found.x[found.cells % found.x.size], found.y[found.cells // found.x.size]])
    far = np.hypot(*places)
    inner = (far > 1.05 * (A - B) / 1e3) & (far < 0.97 * (A + B) / 1e3)
    np.testing.assert_allclose([found.figures["x"][inner], found.figures["y"][inner]], places[:, inner], atol=1e-6)
    grid = np.hypot(*np.meshgrid(found.x, found.y)) * 1e3
    known = (grid > 1.05 * (A - B)) & (grid < 0.97 * (A + B))
    elbows = np.round(np.degrees(found.q[1]) % 360, 3)
    for cell in np.flatnonzero(known.ravel())[::37]:
        both = np.unique(elbows[found.cells == cell])
        assert both.size == 2 and both.sum() == pytest.approx(360, abs=0.01)
    cosine = (grid[known] ** 2 - A**2 - B**2) / (2 * A * B)
    shown = found.map("manipulability", lambda values: values)
    np.testing.assert_allclose(shown[known] * 1e6, A * B * np.sqrt(1 - cosine**2), rtol=1e-3)


def test_what_folded_triangles_cover() -> None:
    rng = np.random.default_rng(1)
    for _ in range(5):
        at, triangles = rng.normal(size=(2, 9)), np.array([[0, 1, 2], [1, 2, 3], [2, 3, 4], [5, 6, 7], [6, 7, 8]])
        every = shapely.union_all([shapely.Polygon(at[:, t].T) for t in triangles])
        found = covered(at, triangles)
        assert found.symmetric_difference(every).area < 1e-7 * every.area


WRONG: list[tuple[dict[str, Any], list[str]]] = [
    ({"quality": {"show": ["speed"], "levels": {"beauty": [1]}}}, ["workspace.map-name", "workspace.map-task"]),
    ({"quality": {"levels": {"condition": ["2 mm"]}}}, ["expression.units-conflict"]),
    ({"quality": {"speeds": {"shoulder": "30 mm/s", "knee": 1}}},
     ["expression.units-conflict", "name.unknown", "workspace.limit-missing"]),
    ({"quality": {"efforts": {"shoulder": "-2 N*m", "elbow": "0 N*m"}}}, ["workspace.limit-positive"] * 2),
    ({"quality": {"force": ["1 N", "1 mm"]}}, ["expression.units-conflict"]),
    ({"quality": {"force": "-3 N"}}, ["workspace.limit-positive"]),
    ({"quality": {"force": [1, 2, 3]}, "errors": {"steps": 5}}, ["file.expected", "study.options"]),
    ({"errors": {"limit": "-1 mm", "contributors": ["c"], "show": ["condition"]}},
     ["name.unknown", "workspace.limit-positive", "workspace.map-name"]),
]  # fmt: skip


@pytest.mark.parametrize(("options", "codes"), WRONG)
def test_what_is_asked_wrongly(options: dict[str, Any], codes: list[str]) -> None:
    assert sorted(found.code for found in findings(toleranced(**options))) == codes


def test_nothing_deviates_and_one_drive_only() -> None:
    (found,) = findings(arm(errors={}))
    assert found.code == "tolerance.none" and found.path == ("studies", "workspace", "errors")
    (found,) = findings(four_bar(quality={}))
    assert found.code == "workspace.two-drives"
