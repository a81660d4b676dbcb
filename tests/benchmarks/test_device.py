"""The device's benchmark runs small and gives every figure; how fast is not asked here."""

from __future__ import annotations

import json
import math
import sys

import pytest

from linkwright.kernels.jax_kernel import JaxKernel

if not JaxKernel.available():
    pytest.skip("JAX is missing", allow_module_level=True)

import device as script


def test_figures(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(sys, "argv", ["device.py", "--json", "--poses", "1e4", "--peak", "1e12", "1e11"])
    script.main()
    figures = json.loads(capsys.readouterr().out)
    assert figures["poses"] == 28 * 360
    assert 0 < figures["operations_per_pose"] < figures["instructions"]
    rate = figures["poses"] / figures["seconds"]
    assert figures["arithmetic_share"] == pytest.approx(rate * figures["operations_per_pose"] / 1e12)
    assert figures["bandwidth_share"] == pytest.approx(rate * 8 * figures["outputs"] / 1e11)
    assert figures["ns_per_pose"] == pytest.approx(1e9 / rate)
    assert figures["closed"] == 1
    # The rocker's ends are where crank and coupler lie in line: 80 and 160 mm, by the law of cosines.
    ends = [math.acos((80**2 + 100**2 - reach**2) / (2 * 80 * 100)) for reach in (80, 160)]
    assert figures["stroke_deg"] == pytest.approx(math.degrees(ends[1] - ends[0]), abs=0.02)


def test_the_longer_name_of_a_device_counts() -> None:
    assert script.peaks("NVIDIA L40S") == script.PEAKS["L40"]
    assert script.peaks("NVIDIA L4") == script.PEAKS["L4"]
    assert script.peaks("NVIDIA H100 80GB HBM3") == script.PEAKS["H100"]
    assert script.peaks("cpu") is None
