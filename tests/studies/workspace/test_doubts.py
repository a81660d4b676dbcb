"""What contradicts a region is told in whole sentences, with how much and where, in the file's units."""

from __future__ import annotations

import re

import pytest

from helpers.compiled import compiled_from
from linkwright.studies.workspace.certificate import SEARCHED, Contradiction, RegionCertificate
from linkwright.studies.workspace.doubts import doubts, sized
from studies.workspace.made_up import document
from studies.workspace.test_places import FIVE_BAR

SIZES = {  # m2, m, shares, numbers: as they are told in mm
    "area": (2.5e-6, "2.5 mm\N{SUPERSCRIPT TWO}"),
    "open": (1e-5, "10 mm\N{SUPERSCRIPT TWO}"),
    "left-out": (3.25e-7, "0.325 mm\N{SUPERSCRIPT TWO}"),
    "too-much": (1e-6, "1 mm\N{SUPERSCRIPT TWO}"),
    "edge": (12.0, "12"),
    "count": (0.002, "2 mm"),
    "back": (0.015, "1.5 %"),
    "unsettled": (0.002, "0.2 %"),
    "cut": (0.0123, "12.3 mm"),
    "dangle": (4e-4, "0.4 mm"),
    "ring": (0.1, "100 mm"),
    "rough": (2500.0, "2500"),
    "nowhere": (3.0, "3"),
}


@pytest.mark.parametrize("kind", SIZES)
def test_each_kind_of_fault_is_told(kind: str) -> None:
    size, told = SIZES[kind]
    compiled = compiled_from(document(FIVE_BAR))
    certificate = RegionCertificate(SEARCHED, faults=(Contradiction(kind, size, (0.0125, -0.003)),))
    (finding,) = doubts(compiled, ("studies", "workspace"), "C: left of B-D", certificate)
    assert finding.code == f"workspace.doubt-{kind}"
    assert finding.path == ("studies", "workspace")
    assert finding.data == {"mode": "C: left of B-D", "at": "(12.5, -3) mm", "size": told}
    for text in (finding.what, finding.mend):
        assert re.fullmatch(r"[A-Z].*\.", text, re.DOTALL) and "{" not in text
    assert "C: left of B-D" in finding.what and "isn't certified" in finding.what
    said = finding.what + finding.mend
    assert told in said or kind == "unsettled"
    assert "(12.5, -3) mm" in said or kind == "unsettled"


def test_a_mechanism_of_one_mode_has_a_dash_for_it_and_a_finding_for_each_fault() -> None:
    compiled = compiled_from(document(FIVE_BAR))
    faults = (Contradiction("edge", 2.0, (0.0, 0.0)), Contradiction("open", 1e-6, (0.001, 0.0)))
    found = [*doubts(compiled, (), "", RegionCertificate(SEARCHED, faults=faults))]
    assert [one.code for one in found] == ["workspace.doubt-edge", "workspace.doubt-open"]
    assert all(one.data["mode"] == "-" for one in found)


def test_what_has_no_fault_has_no_finding() -> None:
    assert not [*doubts(compiled_from(document(FIVE_BAR)), (), "", RegionCertificate(SEARCHED))]


def test_sizes_are_in_the_units_of_the_file() -> None:
    assert sized(Contradiction("area", 2.5e-6, (0.0, 0.0)), 1e-3) == pytest.approx(2.5)
    assert sized(Contradiction("cut", 2.5e-3, (0.0, 0.0)), 1e-3) == pytest.approx(2.5)
    assert sized(Contradiction("back", 0.25, (0.0, 0.0)), 1e-3) == 0.25
