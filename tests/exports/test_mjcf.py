"""Models for MuJoCo, posed by MuJoCo itself: loops are closed, points and energies are those of the mechanism."""

from __future__ import annotations

import csv
import io
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import linkwright as lw
from app.models import SOUND
from linkwright.exports import Exported
from linkwright.exports.mjcf import target
from linkwright.model.document import read_document

EXAMPLES = Path(__file__).parents[2] / "examples"
SHOWN = ["four_bar", "slider_crank", "paper_feeder", "boom_cylinder", "press_law", "gallery/loader"]
BARE = """\
linkwright: 1
units: {length: mm, angle: deg, time: s}
links:
  frame: {points: {O: [0, 0], R: [0, 0]}}
  world: {points: {O: [0, 0], 铰: [40, 0]}}
  连杆:  {points: {铰: [0, 0], B: [120, 0]}}
  other: {points: {铰: [0, 0], C: [90, 0]}}
  a: {points: {B: [0, 0]}}
  c: {points: {C: [0, 0]}}
joints:
  rail: {prismatic: [a, frame], line: [B at 0 deg, R at 0 deg]}
  post: {prismatic: [frame, c], line: [R at 90 deg, C at 90 deg]}
assembly: {B: ahead of 铰 along rail, C: behind 铰 along post}
drives:
  motor: {turns: frame, on: world, speed: 60 rpm, start: 400 deg}
"""


def loaded(exported: Exported) -> tuple[Any, Any]:
    mujoco = pytest.importorskip("mujoco")
    model = mujoco.MjModel.from_xml_string(exported.files["mechanism.xml"])
    return model, mujoco.MjData(model)


def table(exported: Exported) -> tuple[list[str], NDArray[np.float64]]:
    text = exported.files["positions.csv"]
    assert isinstance(text, str)
    heads, *rows = csv.reader(io.StringIO(text))
    return heads, np.array(rows, dtype=float)


def document(text: str) -> lw.Document:
    read, source = read_document(text.encode())
    assert read is not None, source.findings
    return read


def posed(exported: Exported, compiled: lw.Compiled) -> float:
    """The largest residual of a loop, or distance of a point from where the mechanism has it (m)."""
    import mujoco

    model, data = loaded(exported)
    heads, rows = table(exported)
    assert [head.split(" [")[0] for head in heads[1 : 1 + model.nq]] == [model.joint(i).name for i in range(model.njnt)]
    places = {p: f"{link}:{p}" for link, entry in compiled.mechanism.links.items() for p in entry.points}
    links_of_points = compiled.quantities.signals.links_of_points
    names = [f"{p}.{axis}" for p in links_of_points for axis in "xy"]
    wanted = compiled.evaluate(names, rows[:, 0]).reshape(len(links_of_points), 2, -1)
    worst = 0.0
    for i, row in enumerate(rows):
        data.qpos[:] = row[1 : 1 + model.nq]
        mujoco.mj_forward(model, data)
        assert data.ne == 3 * model.neq
        found = np.array([data.site(places[point]).xpos for point in links_of_points])
        gaps = [data.efc_pos[: data.ne], (found[:, :2] - wanted[:, :, i]).ravel(), found[:, 2]]
        worst = max(worst, *(float(np.abs(gap).max(initial=0)) for gap in gaps))
    return worst


@pytest.mark.parametrize("name", SHOWN)
def test_loops_are_closed_and_points_where_they_belong(name: str) -> None:
    file = (Path(lw.__file__).parent if "/" in name else EXAMPLES) / f"{name}.yaml"
    exported = lw.export(file, "mjcf", samples=36)
    assert exported.done and exported.summary["max_error"] < 1e-12
    assert posed(exported, lw.compile(lw.load(file))) < 1e-9


@pytest.mark.parametrize("name", ["four_bar", "boom_cylinder", "loader"])
def test_masses_and_rates_give_the_energies(name: str) -> None:
    """Of rigid links in the plane both are one number each, to which every mass, centre and rate contributes."""
    import mujoco

    exported = lw.export(EXAMPLES / f"{name}.yaml", "mjcf")
    model, data = loaded(exported)
    model.dof_armature[:] = 0
    model.opt.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY
    mujoco.mj_resetDataKeyframe(model, data, 0)
    mujoco.mj_forward(model, data)
    compiled = lw.compile(lw.load(EXAMPLES / f"{name}.yaml"))
    potential, kinetic = compiled.evaluate(["energy.potential", "energy.kinetic"], np.zeros(1))[:, 0]
    assert data.energy == pytest.approx([potential, kinetic], rel=1e-9)


def test_driven_it_moves_like_the_mechanism() -> None:
    """Soft loops and a drive that lags: within 2 mm of 100 over a half turn."""
    import mujoco

    exported = lw.export(EXAMPLES / "four_bar.yaml", "mjcf", duration="0.25 s", samples=250, timestep="1 ms")
    model, data = loaded(exported)
    _, rows = table(exported)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    assert data.qpos == pytest.approx(rows[0, 1 : 1 + model.nq])
    for row in rows[:-1]:
        data.ctrl[:] = row[1 + model.nq :]
        mujoco.mj_step(model, data)
        assert np.abs(data.efc_pos[: data.ne]).max() < 1e-3
    turned = rows[-1, 1 : 1 + model.nq] - rows[0, 1 : 1 + model.nq]
    assert np.abs(turned).max() > 1
    assert data.qpos == pytest.approx(rows[-1, 1 : 1 + model.nq], abs=0.1)


def test_a_bare_mechanism_of_any_names() -> None:
    """A link called world, a pin of three links, a drive that turns the frame, slides either way round; no mass."""
    exported = lw.export(document(BARE), "mjcf", duration="0.2 s", samples=10)
    assert [finding.code for finding in exported.warnings] == ["export.no-mass"]
    compiled = lw.compile(document(BARE))
    assert posed(exported, compiled) < 1e-9
    heads, rows = table(exported)
    assert {"铰", "铰:other", "rail", "post", "O"} <= {head.split(" [")[0] for head in heads}
    control = rows[:, heads.index("ctrl motor [rad]")]
    assert control == pytest.approx(np.deg2rad(400) + 2 * np.pi * rows[:, 0])
    assert rows[:, heads.index("O [rad]")] == pytest.approx(-control)
    assert rows[:, heads.index("rail [m]")] == pytest.approx(compiled.evaluate(["rail.s"], rows[:, 0])[0])
    model, _ = loaded(exported)
    assert model.body_mass[1:] == pytest.approx(1e-3)
    heavy = lw.export(document(BARE), "mjcf", tiny_mass="2 kg")
    assert loaded(heavy)[0].body_mass[1:] == pytest.approx(2)
    assert len(table(heavy)[1]) == 1  # nobody says how long: its start alone


def test_what_is_left_out_is_told() -> None:
    exported = lw.export(EXAMPLES / "tailgate.yaml", "mjcf")
    assert exported.done and [f.code for f in exported.warnings] == ["export.left-out"]
    exported = lw.export(EXAMPLES / "paper_feeder.yaml", "mjcf")
    assert [(f.code, str(f.data["links"])) for f in exported.warnings] == [("export.no-inertia", "slider, guide")]


def test_followers_of_cams_have_actuators_of_their_own() -> None:
    exported = lw.export(EXAMPLES / "cam_linkage.yaml", "mjcf", samples=20)
    assert exported.done and "export.followers" in [f.code for f in exported.warnings]
    heads, rows = table(exported)
    wanted = lw.compile(lw.load(EXAMPLES / "cam_linkage.yaml")).evaluate(["pushing.angle", "crank.angle"], rows[:, 0])
    assert rows[:, heads.index("ctrl pushing [rad]")] == pytest.approx(wanted[0], abs=1e-12)
    assert rows[:, heads.index("A [rad]")] == pytest.approx(wanted[1], abs=1e-12)


def test_what_is_not_proven_is_not_given(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(target, "PROVEN", 0.0)
    exported = lw.export(EXAMPLES / "four_bar.yaml", "mjcf")
    assert [finding.code for finding in exported.failures] == ["export.unproven"] and not exported.files


def test_a_motion_that_cannot_be_followed_is_refused() -> None:
    stuck = SOUND.replace("{a: 40, b: 120, c: 80, d: 100}", "{a: 60, b: 70, c: 50, d: 100}")
    exported = lw.export(document(stuck), "mjcf")
    assert not exported.done and not exported.files
    assert {finding.code.split(".")[0] for finding in exported.failures} == {"motion"}


def test_a_motion_too_long_for_continuous_angles_is_refused() -> None:
    exported = lw.export(EXAMPLES / "two_cylinder_workspace.yaml", "mjcf", duration="3.53e10 s")
    (finding,) = exported.failures
    assert finding.code == "export.too-long"
    assert "left, B, right" in finding.what


@pytest.mark.parametrize("options", [{"tiny_mass": 0}, {"tiny_mass": "3 mm"}, {"timestep": "-1 ms"}, {"duration": "a"}])
def test_wrong_options(options: dict[str, Any]) -> None:
    with pytest.raises(lw.ModelError) as raised:
        lw.export(document(SOUND), "mjcf", **options)
    (finding,) = raised.value.findings
    assert finding.path == ("exports", "mjcf", *options)
