"""Changes of temperature: lengths that expand together, as one deviation."""

from __future__ import annotations

import numpy as np

from linkwright.expressions import units as u
from linkwright.expressions.unknown import near
from linkwright.studies.accuracy.stated_options import Thermal
from linkwright.studies.accuracy.tolerance_reader import PATH, Moving, Path, ToleranceReader
from linkwright.studies.numbers import interval
from linkwright.tolerances import EXPANSION


def thermal(reader: ToleranceReader, name: str, entry: Thermal) -> Moving | None:
    """The change of temperature (K); each length L follows it by alpha L."""
    path = (*PATH, "thermal", name)
    if name in reader.tolerances:
        reader.note_fault("tolerance.thermal-name", path, name=name)
    limits, wrong = interval(reader.quantities, entry.change, u.PURE, (*path, "change"))
    reader.findings += wrong
    alpha, moved = _expansion(reader, entry, path), _lengths(reader, entry, path)
    spread = reader.spread(path, entry, "uniform", limits or (-1.0, 1.0), u.PURE)
    if limits is None or alpha is None or spread is None:
        return None
    weights = alpha * 1e-6 * np.array([reader.quantities.parameters[length] for length in moved])
    text = f"{limits[0]:g} .. {limits[1]:g} K, {entry.material or f'{alpha:g} 1e-6/K'}"
    return Moving(name, 0.0, limits, *spread, u.PURE, text, tuple(moved), weights, "K")


def _expansion(reader: ToleranceReader, entry: Thermal, path: Path) -> float | None:
    """The coefficient of linear expansion in 1e-6/K."""
    if entry.expansion is not None:
        return reader.value(entry.expansion, u.PURE, (*path, "expansion"))
    material = (entry.material or "").strip().lower()
    if material not in EXPANSION:
        data = {"given": material[:40], "near": near(material, [*EXPANSION])}
        reader.note_fault("tolerance.material", (*path, "material"), **data)
    return EXPANSION.get(material)


def _lengths(reader: ToleranceReader, entry: Thermal, path: Path) -> list[str]:
    """The lengths that expand."""
    lengths = [name for name in reader.independent if reader.quantities.dimensions.of(name) == u.LENGTH]
    if entry.parameters is None:
        if not lengths:
            reader.note_fault("tolerance.no-length", path)
        return lengths
    for i, name in enumerate(entry.parameters):
        at = (*path, "parameters", i)
        if name not in reader.tolerances:  # told as a name
            continue
        if name not in reader.independent:
            reader.of_derived(name, at)
        elif name not in lengths:
            reader.note_fault("tolerance.not-a-length", at, name=name)
    return [name for name in dict.fromkeys(entry.parameters) if name in lengths]
