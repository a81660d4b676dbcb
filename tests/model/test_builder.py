"""The builder makes the same object as the file, by the same validation."""

from __future__ import annotations

import textwrap

import numpy as np
import pytest

import linkwright as lw
from linkwright.findings import ModelError
from linkwright.model.builder import Builder
from linkwright.model.document import dump, load, read_document
from model.given import DATA


def paper_feeder() -> Builder:
    builder = Builder("Packaging paper feeder").gravity(0, "-9.80665 m/s^2")
    for name, value in {"AB": 155, "BC": 395, "CD": 300, "DE": 500, "AD": 300, "AH": 580}.items():
        builder.parameter(name, value)
    return (
        builder.frame(A=[0, 0], D=["AD", 0], H=[0, "AH"])
        .link("crank", A=[0, 0], B=["AB", 0], mass=0.6, shape="rod A-B")
        .link("coupler", B=[0, 0], C=["BC", 0], mass=1.5, shape="rod B-C")
        .link("rocker", D=[0, 0], C=["CD", 0], E=["DE", 0], mass=2, shape="rod D-E")
        .link("slider", {"E": [0, 0]}, mass=1, shape="point E")
        .link("guide", {"G": [0, 0]}, mass=3, shape="point G")
        .prismatic("rail", ("frame", "H at 0 deg"), ("guide", "G at 0 deg"))
        .prismatic("slide", ("guide", "G at 90 deg"), ("slider", "E at 90 deg"))
        .assembly("C", "left of B-D")
        .drive("motor", turns="crank", speed="-40 rpm", start="atan2(61.78, 142.16)")
        .window("return", "0 s", "0.6 s")
        .window("feed", "0.6 s", "1.5 s")
        .measure("stroke", span="E.x")
        .measure("right_limit_angle", value="crank.angle", where="max E.x", wrap=[0, 360])
        .measure("left_limit_angle", value="crank.angle", where="min E.x", wrap=[0, 360])
        .measure("feed_speed_max", max="abs(E.vx)", window="feed")
        .measure("FAx_return", extremes="force(frame, crank).x", window="return")
        .measure("couple_return", extremes="-motor.torque", window="return")
        .study("cycle", period="1.5 s", samples=200)
    )


def test_the_paper_feeder_is_the_one_of_the_file() -> None:
    assert paper_feeder().build() == load(DATA / "paper_feeder.yaml")


def test_the_five_bar_is_the_one_of_the_file() -> None:
    builder = Builder("Hybrid-driven five-bar", mass=None, force=None, torque=None)
    for name, value in {"l1": 8, "l2": 26, "l3": 28, "l4": 10, "l5": 30, "r2": 20, "alpha": "60 deg"}.items():
        builder.parameter(name, value)
    built = (
        builder.frame({"O1": [0, 0], "O4": ["l5", 0]})
        .link("crank1", O1=[0, 0], B=["l1", 0])
        .link("link2", B=[0, 0], C=["l2", 0])
        .link("link3", D=[0, 0], C=["l3", 0], P="r2 at -alpha")
        .link("crank4", O4=[0, 0], D=["l4", 0])
        .assembly("C", "left of B-D")
        .drive("motor", turns="crank1", speed="30 rpm", start="0 deg")
        .drive("servo", turns="crank4", position="90 deg + 20 deg*sin(180 deg*t/(1 s))")
        .study("cycle", period="2 s", samples=360)
        .study("workspace", point="P", modes="all", **{"for": {"alpha": [0, 60, 90]}})
        .build()
    )
    assert built == load(DATA / "five_bar.yaml")


def test_the_slider_crank_is_the_one_of_the_file() -> None:
    builder = Builder("Slider-crank with gas force", torque=None, pressure="bar")
    for name, value in {"r": 45, "l": 140, "e": 0, "bore": 86}.items():
        builder.parameter(name, value)
    built = (
        builder.frame(A=[0, 0], F=[0, "e"])
        .link("crank", A=[0, 0], B=["r", 0], mass=2.0, com=[0, 0], inertia=8000)
        .link("rod", B=[0, 0], C=["l", 0], mass=0.6, shape="rod B-C")
        .link("piston", C=[0, 0], mass=0.5, shape="point C")
        .prismatic("bore_line", ("frame", "F at 0 deg"), ("piston", "C at 0 deg"))
        .assembly("C", "ahead of B along bore_line")
        .drive("engine", turns="crank", speed="3000 rpm", start=0)
        .table("gas", file="gas.csv", x="angle deg", y="pressure bar", period=720, between="linear")
        .load("gas", "piston", at="C", along="bore_line", force="-gas(engine.angle)*pi/4*bore^2")
        .study("cycle", turns="2 engine", samples=720)
        .build()
    )
    assert built == load(DATA / "slider_crank_gas.yaml")


def test_every_part_survives_a_file() -> None:
    document = (
        Builder("all parts", note="a note")
        .parameter("AB", 40, tolerance=0.1, note="turned")
        .parameter("BC", "120 mm", tolerance=[-0.1, 0.2])
        .frame(A=[0, 0], D=[100, 0])
        .link("crank", A=[0, 0], B=["AB", 0])
        .link("coupler", B=[0, 0], C=["BC", 0], mass=1, com=[60, 0], inertia=1000)
        .link("rocker", D=[0, 0], K=[80, 0])
        .revolute("J", ("coupler", "C"), ("rocker", "K"))
        .assembly("J", [90, 90])
        .drive("motor", turns="crank", position="rise(t)")
        .table("rise", [[0, 0], [0.5, 30], [1, 60], [1.5, 90]], between="quintic")
        .load("push", "coupler", at=[10, 5], force=[0, -5], in_="coupler")
        .load("brake", "rocker", torque="-2 N*m*rise(t)/(1 deg)", window="early")
        .spring("pull", "A", "C", in_=("frame", "coupler"), stiffness=2, free=80, damping=0.5)
        .spring("hold", turns="crank", on="frame", stiffness="5 N*m/rad", free="30 deg")
        .counterweight("cw", "crank", mass=1.2, at="60 at 180 deg", inertia=100)
        .window("early", 0, 30, of="motor.angle")
        .measure("reach", max="C.x", unit="m")
        .require("reach", "<= 200 mm")
        .study("cycle", duration="1.5 s")
        .build()
    )
    read, source = read_document(dump(document).encode())
    assert not source.findings
    assert read == document


def test_numpy_s_numbers_are_numbers() -> None:
    points = {"A": np.array([0.0, 0.0]), "B": [np.float64(40), np.int64(0)]}
    built = Builder().frame(points).parameter("n", np.float32(0.5)).build()
    assert built == Builder().frame({"A": [0, 0], "B": [40, 0]}).parameter("n", 0.5).build()
    assert read_document(dump(built).encode())[0] == built


def test_faults_are_told_all_at_once_by_element() -> None:
    builder = Builder(length=None).link("crank", A=[0], mass=1).drive("m", speed=3).parameter("a", None)
    with pytest.raises(ModelError) as caught:
        builder.parameter("a", 1).window("w", 0, 1, of="motor").build()
    assert [(f.code, f.element) for f in caught.value.findings] == [
        ("builder.twice", "parameters.a"),
        ("drive.start", "drives.m"),
        ("mass.incomplete", "links.crank"),
        ("file.expected", "links.crank.points.A"),
        ("drive.kind", "drives.m"),
        ("window.signal", "windows.w.motor"),
    ]


def test_a_builder_may_go_on_after_it_has_built() -> None:
    builder = paper_feeder()
    first = builder.build()
    second = builder.measure("lift", span="E.y").build()
    assert "lift" not in first.measures
    assert "lift" in second.measures


def test_what_is_built_runs() -> None:
    compiled = lw.compile(paper_feeder().build())
    assert compiled.structure.groups


def test_a_sketch_with_all_that_acts_on_it_is_the_file_s() -> None:
    """Every section that the short forms meet in, built and read back."""
    built = (
        Builder("boom")
        .sketch({"O": [0, 0], "K": [300, -900]}, M=[1300, -100], tip="2600 at -5 deg")
        .frame(["O", "K"])
        .link("boom", ("O", "M", "tip"), mass=420, com=[1200, 0], inertia=3.1e8, N=[350, 250])
        .cylinder("lift", "K", "M", length=[900, 1500], barrel={"mass": 40, "com": 300})
        .drive("raise", extends="lift", output="boom", speed=2, acceleration=1, start="sketch")
        .spring("help", "O", "M", in_=("frame", "boom"), stiffness=2, free=1200)
        .counterweight("cw", "boom", 10, [-300, 0])
        .window("far", 1250, 1400, of="lift.s")
        .load("payload", "boom", at="tip", force=[0, -15], window="far")
        .study("cycle", duration="1 s")
        .build()
    )
    text = """
        linkwright: 1
        name: boom
        units: {length: mm, angle: deg, mass: kg, time: s, force: N, torque: N*m}
        sketch: {O: [0, 0], K: [300, -900], M: [1300, -100], tip: 2600 at -5 deg}
        links:
          frame: {points: [O, K]}
          boom: {points: {O: sketch, M: sketch, tip: sketch, N: [350, 250]}, mass: 420, com: [1200, 0], inertia: 3.1e8}
        cylinders:
          lift: {from: K, to: M, length: [900, 1500], barrel: {mass: 40, com: 300}}
        drives:
          raise: {extends: lift, output: boom, speed: 2, acceleration: 1, start: sketch}
        springs: {help: {from: O, to: M, in: [frame, boom], stiffness: 2, free: 1200}}
        counterweights: {cw: {on: boom, mass: 10, at: [-300, 0]}}
        windows: {far: {lift.s: [1250, 1400]}}
        loads: {payload: {on: boom, at: tip, force: [0, -15], window: far}}
        studies: {cycle: {duration: 1 s}}
        """
    read, _ = read_document(textwrap.dedent(text).encode())
    assert built == read
    assert read_document(dump(built).encode())[0] == built
    assert lw.check(built) == []
    assert lw.run(built).exit_code == 0


def test_a_pin_in_a_slot() -> None:
    document = (
        Builder("yoke")
        .frame(O=[0, 0], G=[0, 0])
        .link("crank", O=[0, 0], B=[40, 0])
        .link("yoke", H=[0, 0])
        .prismatic("guide", ("frame", "G at 0 deg"), ("yoke", "H at 0 deg"))
        .pin_in_slot("slot", ("crank", "B"), "yoke", straight="H at 90 deg", travel=[-45, 45])
        .drive("motor", turns="crank", speed="60 rpm", start=0)
        .build()
    )
    assert document.joints["slot"].links == ("crank", "yoke")
    assert document.joints["slot"].limits is not None
