"""What contradicts a region, as findings: how much, and where."""

from __future__ import annotations

from collections.abc import Iterator

from linkwright.kernels import Compiled
from linkwright.model import units as u
from linkwright.model.findings import Finding
from linkwright.studies.workspace.certificate import Certificate

AREAS, LENGTHS, SHARES = ("area", "open", "left-out", "too-much"), ("cut", "dangle", "ring"), ("back", "unsettled")


def doubts(compiled: Compiled, where: tuple[str, ...], mode: str, certificate: Certificate) -> Iterator[Finding]:
    """A finding for each fault of a mode's certificate, in the file's units."""
    unit, size = compiled.quantities.unit_of(u.LENGTH)
    for fault in certificate.faults:
        x, y = (f"{v / size:.6g}" for v in fault.at)
        data = {"mode": mode or "-", "at": f"({x}, {y}) {unit}".rstrip()}
        data["size"] = _told(fault.kind, fault.size, unit, size)
        yield Finding(f"workspace.doubt-{fault.kind}", where, data)


def _told(kind: str, value: float, unit: str, size: float) -> str:
    if kind in AREAS:
        return f"{value / size**2:.3g} {unit}\N{SUPERSCRIPT TWO}" if unit else f"{value / size**2:.3g}"
    if kind in LENGTHS:
        return f"{value / size:.3g} {unit}".rstrip()
    return f"{100 * value:.3g} %" if kind in SHARES else f"{value:.0f}"
