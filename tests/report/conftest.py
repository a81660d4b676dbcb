"""A paper feeder by hand: crank, coupler plate, rocker, and a slider that pushes a guide along a rail."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

from helpers.browsers import chromium
from linkwright.presentation.blocks import Check, Checks, Measure, Measures, MeasureValue, Section
from linkwright.report import LinkData, Plot, ReportData, Scene

AB, BC, CD, DE, AD, AH = 155.0, 395.0, 300.0, 500.0, 300.0, 580.0  # mm
PERIOD = 1.5  # s


class Feeder:
    """Closed-form positions (mm) of the feeder's points at times ``t`` (s), C left of B-D."""

    def __init__(self, samples: int = 201) -> None:
        self.t = np.linspace(0.0, PERIOD, samples)
        self.crank = np.arctan2(61.78, 142.16) - 2 * np.pi * self.t / PERIOD
        a, d = 0j, complex(AD)
        b = a + AB * np.exp(1j * self.crank)
        reach = np.abs(d - b)
        along = (BC**2 - CD**2 + reach**2) / (2 * reach)
        c = b + (d - b) / reach * (along + 1j * np.sqrt(BC**2 - along**2))
        self.coupler, self.rocker = np.angle(c - b), np.angle(c - d)
        e = d + DE * np.exp(1j * self.rocker)
        self.points = {"A": a + 0 * b, "B": b, "C": c, "D": d + 0 * b, "E": e, "G": e.real + 1j * AH}


def pose(origin: Any, angle: Any) -> Any:
    origin, angle = np.broadcast_arrays(np.atleast_1d(origin), np.atleast_1d(angle))
    return {
        "x": origin.real.tolist(),
        "y": origin.imag.tolist(),
        "c": np.cos(angle).tolist(),
        "s": np.sin(angle).tolist(),
    }


def scene_of(feeder: Feeder) -> Scene:
    p = feeder.points

    def link(name: str, points: dict[str, list[float]], origin: Any, angle: Any, fixed: bool = False) -> LinkData:
        return {"name": name, "fixed": fixed, "points": points, "pose": pose(origin, angle)}

    pins = {"A": ("frame", "crank"), "B": ("crank", "coupler"), "C": ("coupler", "rocker")}
    pins |= {"D": ("frame", "rocker"), "E": ("rocker", "slider")}
    return {
        "length_unit": "mm",
        "time": feeder.t.tolist(),
        "links": [
            link("frame", {"A": [0, 0], "D": [AD, 0], "H": [0, AH]}, 0j, 0.0, fixed=True),
            link("crank", {"A": [0, 0], "B": [AB, 0]}, p["A"], feeder.crank),
            link("coupler", {"B": [0, 0], "C": [BC, 0], "P": [200, 120]}, p["B"], feeder.coupler),
            link("rocker", {"D": [0, 0], "C": [CD, 0], "E": [DE, 0]}, p["D"], feeder.rocker),
            link("slider", {"E": [0, 0]}, p["E"], 0.0 * feeder.t),
            link("guide", {"G": [0, 0]}, p["G"], 0.0 * feeder.t),
        ],
        "joints": [
            *({"name": k, "kind": "revolute", "links": v, "points": (k, k)} for k, v in pins.items()),
            {
                "name": "rail",
                "kind": "prismatic",
                "links": ["frame", "guide"],
                "points": ["H", "G"],
                "angles": [0.0, 0.0],
            },
            {
                "name": "slide",
                "kind": "prismatic",
                "links": ["guide", "slider"],
                "points": ["G", "E"],
                "angles": [np.pi / 2, np.pi / 2],
            },
        ],
        "traces": [
            {"name": "E", "x": p["E"].real.tolist(), "y": p["E"].imag.tolist()},
            {
                "name": "P",
                "x": (p["B"] + (200 + 120j) * np.exp(1j * feeder.coupler)).real.tolist(),
                "y": (p["B"] + (200 + 120j) * np.exp(1j * feeder.coupler)).imag.tolist(),
            },
        ],
    }


def plots_of(feeder: Feeder) -> list[Plot]:
    out: list[Plot] = []
    for name in "BCEG":
        jet, unit, names = feeder.points[name], "mm", ("x", "y")
        for kind in ("position", "velocity", "acceleration"):
            series = [
                {"name": f"{name}.{names[0]}", "values": jet.real.tolist()},
                {"name": f"{name}.{names[1]}", "values": jet.imag.tolist()},
            ]
            out.append({"title": f"Point {name}: {kind}", "group": "motion", "unit": unit, "series": series})
            jet, unit = np.gradient(jet, feeder.t), {"mm": "mm/s"}.get(unit, "mm/s^2")
            names = tuple("v" + n if len(n) == 1 else "a" + n[1:] for n in names)
    for pair in ("frame, crank", "crank, coupler", "coupler, rocker", "frame, rocker"):
        force = np.exp(2j * feeder.crank) * (40 + 25 * np.cos(3 * feeder.rocker))
        series = [
            {"name": f"force({pair}).x", "values": force.real.tolist()},
            {"name": f"force({pair}).y", "values": force.imag.tolist()},
            {"name": f"|force({pair})|", "values": np.abs(force).tolist()},
        ]
        out.append({"title": f"Force of {pair.split(', ')[0]} on {pair.split(', ')[1]}", "group": "force",
                    "unit": "N", "series": series})  # fmt: skip
    return out


MEASURES = Measures(
    [
        Measure(
            "stroke",
            "span of E.x",
            [MeasureValue(value=680.2777, at="t = 0.5711 s", grade="sampled")],
            "mm",
            ">= 680 mm",
            verdict=True,
        ),
        Measure(
            "FAx_return",
            "extremes of force(frame, crank).x",
            [
                MeasureValue("min", -41.23456, at="t = 0.3125 s", grade="sampled"),
                MeasureValue("max", 97.5, at="t = 0.0975 s", grade="sampled"),
            ],
            "N",
            "<= 90 N",
            verdict=False,
        ),
        Measure(
            "feed_speed_max",
            "largest |E.vx| in feed",
            [MeasureValue(value=1204.118, at="t = 1.012 s", grade="sampled")],
            "mm/s",
            None,
            None,
        ),
    ]
)
CHECKS = Checks(
    [
        Check("closure", "3.1e-16", "No loop is open by more than 1.8e-13 mm.", ok=True),
        Check(
            "conditioning",
            "0.031",
            "The transmission angle at C falls to 1.8 deg at t = 0.42 s: near a dead centre.",
            ok=False,
        ),
    ],
    ["201 poses computed with the numpy kernel: little work."],
)


@pytest.fixture(scope="package")
def browser() -> Iterator[Any]:
    """One for all tests of this folder; each opens its pages in a context of its own. Playwright's loop would be in the
    way of tests elsewhere."""
    yield from chromium()


@pytest.fixture(scope="session")
def feeder() -> Feeder:
    return Feeder()


@pytest.fixture
def coarse() -> tuple[Feeder, Scene]:
    """The feeder in so few poses that chords between them are far from its circles."""
    feeder = Feeder(26)
    return feeder, scene_of(feeder)


@pytest.fixture
def report(feeder: Feeder) -> ReportData:
    """The whole report of the feeder; tests may change their copy."""
    return {
        "title": "Packaging paper feeder",
        "subtitle": "Cycle of 1.5 s, 201 poses, crank at -40 rpm",
        "source": "Source: Tang, Deng, Xin <2022>",
        "title_block": [
            {"name": "File", "sentence": "model.yaml"},
            {"name": "SHA-256", "sentence": "0123456789ab"},
            {"name": "Date", "sentence": "2026-01-01 12:00 +00:00"},
            {"name": "Author", "sentence": "Tang"},
            {"name": "Revision", "sentence": "B"},
            {"name": "linkwright version", "sentence": "0.1.0"},
        ],
        "version": "0.1.0",
        "time": {"values": feeder.t.tolist(), "unit": "s", "label": "time"},
        "scene": scene_of(feeder),
        "plots": plots_of(feeder),
        "sections": [Section("measures", [MEASURES]), Section("certificate", [CHECKS])],
        "structure": [
            {"name": "Mobility", "sentence": "1 (Gruebler 1, rank 1)"},
            {"name": "Groups", "sentence": "crank; RRR dyad B-C-D; RPP dyad E-G"},
        ],
        "problems": [],
        "model_text": "linkwright: 1\nname: Packaging paper feeder\nparameters: {AB: 155, BC: 395}\n",
    }
