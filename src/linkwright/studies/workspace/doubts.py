"""What contradicts a region, as findings: how much, and where."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from linkwright.data_classes import dataclass
from linkwright.expressions import units as u
from linkwright.findings import Finding
from linkwright.kernels import Compiled
from linkwright.studies.workspace.certificate import Contradiction, RegionCertificate


@dataclass(frozen=True)
class Told:
    """How the sizes of a kind of fault are told: ``power`` is that of the unit of lengths, ``text`` takes the value in
    the file's units and the unit of lengths."""

    power: int
    text: Callable[[float, str], str]


AREA = Told(2, lambda value, unit: f"{value:.3g} {u.squared(unit)}".rstrip())
LENGTH = Told(1, lambda value, unit: f"{value:.3g} {unit}".rstrip())
SHARE = Told(0, lambda value, unit: f"{100 * value:.3g} %")
COUNT = Told(0, lambda value, unit: f"{value:.0f}")

KINDS: dict[str, tuple[str, Told]] = {
    "area": ("workspace.doubt-area", AREA),
    "open": ("workspace.doubt-open", AREA),
    "left-out": ("workspace.doubt-left-out", AREA),
    "too-much": ("workspace.doubt-too-much", AREA),
    "edge": ("workspace.doubt-edge", COUNT),
    "count": ("workspace.doubt-count", LENGTH),
    "back": ("workspace.doubt-back", SHARE),
    "unsettled": ("workspace.doubt-unsettled", SHARE),
    "cut": ("workspace.doubt-cut", LENGTH),
    "dangle": ("workspace.doubt-dangle", LENGTH),
    "ring": ("workspace.doubt-ring", LENGTH),
    "rough": ("workspace.doubt-rough", COUNT),
    "nowhere": ("workspace.doubt-nowhere", COUNT),
}
"""Of each kind of fault its finding, and how its size is told."""


def sized(fault: Contradiction, size: float) -> float:
    """The size of a fault with lengths in units of ``size`` m."""
    return fault.size / size ** KINDS[fault.kind][1].power


def doubts(compiled: Compiled, where: tuple[str, ...], mode: str, certificate: RegionCertificate) -> Iterator[Finding]:
    """A finding for each fault of a mode's certificate, in the file's units."""
    unit, size = compiled.quantities.unit_of(u.LENGTH)
    for fault in certificate.faults:
        code, told = KINDS[fault.kind]
        value = told.text(sized(fault, size), unit)
        x, y = (f"{v / size:.6g}" for v in fault.at)
        data = {"mode": mode or "-", "at": f"({x}, {y}) {unit}".rstrip(), "size": value}
        yield Finding(code, where, data)
