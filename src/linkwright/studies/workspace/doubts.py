"""What contradicts a region, as findings: how much, and where."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from linkwright.kernels import Compiled
from linkwright.model import units as u
from linkwright.model.findings import Finding
from linkwright.studies.workspace.certificate import Certificate

Told = Callable[[float, str, float], str]


def _area(value: float, unit: str, size: float) -> str:
    return f"{value / size**2:.3g} {u.squared(unit)}".rstrip()


def _length(value: float, unit: str, size: float) -> str:
    return f"{value / size:.3g} {unit}".rstrip()


def _share(value: float, unit: str, size: float) -> str:
    return f"{100 * value:.3g} %"


def _count(value: float, unit: str, size: float) -> str:
    return f"{value:.0f}"


KINDS: dict[str, tuple[str, Told]] = {
    "area": ("workspace.doubt-area", _area),
    "open": ("workspace.doubt-open", _area),
    "left-out": ("workspace.doubt-left-out", _area),
    "too-much": ("workspace.doubt-too-much", _area),
    "edge": ("workspace.doubt-edge", _count),
    "count": ("workspace.doubt-count", _length),
    "back": ("workspace.doubt-back", _share),
    "unsettled": ("workspace.doubt-unsettled", _share),
    "cut": ("workspace.doubt-cut", _length),
    "dangle": ("workspace.doubt-dangle", _length),
    "ring": ("workspace.doubt-ring", _length),
    "rough": ("workspace.doubt-rough", _count),
    "nowhere": ("workspace.doubt-nowhere", _count),
}
"""Of each kind of fault its finding, and how its size is told."""


def doubts(compiled: Compiled, where: tuple[str, ...], mode: str, certificate: Certificate) -> Iterator[Finding]:
    """A finding for each fault of a mode's certificate, in the file's units."""
    unit, size = compiled.quantities.unit_of(u.LENGTH)
    for fault in certificate.faults:
        code, told = KINDS[fault.kind]
        x, y = (f"{v / size:.6g}" for v in fault.at)
        data = {"mode": mode or "-", "at": f"({x}, {y}) {unit}".rstrip(), "size": told(fault.size, unit, size)}
        yield Finding(code, where, data)
