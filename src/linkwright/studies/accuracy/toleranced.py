"""The deviation of a parameter from its tolerance, its own or the general one."""

from __future__ import annotations

import numpy as np

from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression
from linkwright.findings import Term
from linkwright.model.tolerances import ClassName
from linkwright.studies.accuracy.tolerance_reader import Moving, Path, ToleranceReader
from linkwright.tolerances import Limits, NoTolerance

Numbers = tuple[Expression, Expression] | Expression


def toleranced(reader: ToleranceReader, name: str) -> Moving | None:
    """The deviation of a parameter, which states limits or has the general ones."""
    path: Path = ("parameters", name, "tolerance")
    if name not in reader.independent:
        reader.of_derived(name, path)
        return None
    entry, dimension = reader.tolerances[name], reader.quantities.dimensions.of(name)
    stated = entry.limits if entry.limits is not None else reader.options.general
    assert stated is not None
    nominal = reader.quantities.parameters[name]
    if isinstance(stated, ClassName):
        limits = _of_class(reader, name, stated, path)
    else:
        limits = _of_numbers(reader, name, stated, path)
    spread = reader.spread(path, entry, reader.options.distribution, limits or (-1.0, 1.0), dimension)
    if limits is not None and dimension in (u.LENGTH, u.MASS) and 0 < abs(nominal) <= max(map(abs, limits)):
        unit, size = reader.quantities.unit_of(dimension)
        data = {"limit": f"{max(limits, key=abs) / size:.6g}", "nominal": f"{nominal / size:.6g}", "unit": unit}
        reader.note_fault("tolerance.too-large", path, **data)
    if limits is None or spread is None:
        return None
    return Moving(name, nominal, limits, *spread, dimension, _text(stated), (name,), np.ones(1))


def _of_numbers(reader: ToleranceReader, name: str, stated: Numbers, path: Path) -> Limits | None:
    q, dimension = reader.quantities, reader.quantities.dimensions.of(name)
    if isinstance(stated, tuple):
        low, high = (q.value(part, dimension) for part in stated)
    else:
        high = q.value(stated, dimension)
        low = -high
    if low < high:
        return low, high
    reader.note_fault("tolerance.limits", path, given=_text(stated)[:60])
    return None


def _of_class(reader: ToleranceReader, name: str, stated: ClassName, path: Path) -> Limits | None:
    q, found, side = reader.quantities, stated.found, reader.tolerances[name].side
    dimension, (unit, size) = q.dimensions.of(name), q.unit_of(u.LENGTH)
    asked = abs(q.parameters[name])
    try:
        if dimension == u.LENGTH:
            return found.limits(asked)
        if dimension != u.ANGLE:
            raise NoTolerance("angle")
        if side is None:
            found.angular(1.0)  # none at all where the class has none of angles
            reader.note_fault("tolerance.side", path, given=found.text)
            return None
        if (length := q.value(side, u.LENGTH)) <= 0:
            data = {"what": Term("side"), "value": f"{length / size:.6g}", "unit": unit}
            reader.note_fault("value.too-small", (*path, "side"), **data)
            return None
        return found.angular(length)
    except NoTolerance as error:
        if error.reason == "size":
            ends = {end: f"{error.data[end] / size:g}" for end in ("low", "high")}
            reader.note_fault("tolerance.size", path, given=found.text, asked=f"{asked / size:.6g}", unit=unit, **ends)
        else:
            reader.note_fault("tolerance.class-dimension", path, given=found.text, name=name)
        return None


def _text(stated: Numbers | ClassName) -> str:
    """Limits as the file states them."""
    return f"[{stated[0].text}, {stated[1].text}]" if isinstance(stated, tuple) else str(stated.raw)
