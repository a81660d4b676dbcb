"""Arrays over axes with names and units, and what is made of them: CSV in the file's units, netCDF and xarray in SI.

The netCDF files have the classic format (64-bit offset), are written by SciPy, and have attributes after the CF
conventions.
"""

from __future__ import annotations

import io
import re
from collections.abc import Mapping, Sequence
from dataclasses import field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions.units import TIME, Dimension
from linkwright.model.csv_text import head, numbers_text

if TYPE_CHECKING:
    from linkwright.findings import Finding
    from linkwright.kernels import Compiled
    from linkwright.model.quantities import Quantities

Array = NDArray[np.float64]

_UNFIT = re.compile(r"""[^A-Za-z0-9_.@+\- !"#$%&\\()*,:;<=>?\[\]^`{|}~']""")


@dataclass(frozen=True)
class Variable:
    """An array over one axis, in SI; NaN where there is no value.

    ``unit`` of size ``size`` (SI) is that of tables, ``si`` the SI unit ("" for none; ``None`` where it differs from
    value to value). Tables call the variable ``column`` where that isn't its ``name``. Whole numbers and truth values
    are written as such in tables.
    """

    name: str
    over: str
    values: NDArray[Any]
    unit: str = ""
    size: float = 1.0
    si: str | None = ""
    column: str = ""

    @property
    def head(self) -> str:
        """The head of its column."""
        return head(self.column or self.name, self.unit)

    @property
    def tabulated(self) -> NDArray[Any]:
        """Its values in tables."""
        return self.values / self.size if self.values.dtype == float else self.values.astype(np.int64)


@dataclass(frozen=True)
class Dataset:
    """Variables, and facts about them as a whole by name."""

    variables: Sequence[Variable]
    facts: Mapping[str, Any] = field(default_factory=dict)

    def over(self, axis: str) -> list[Variable]:
        """The variables over an axis."""
        return [variable for variable in self.variables if variable.over == axis]

    def csv(self, axis: str) -> str | None:
        """The variables over an axis as a table, a row for each value; ``None`` where there are none."""
        some = self.over(axis)
        return numbers_text([one.head for one in some], (one.tabulated for one in some)) if some else None

    def netcdf(self) -> bytes:
        """All of it as a netCDF file.

        A variable is named as here where the format allows it (``force(frame, crank).x`` is allowed, Chinese letters
        and ``/`` are not, and are spelled ``_u66f2``); its ``long_name`` is always the name given here.
        """
        from scipy.io import netcdf_file

        stream = io.BytesIO()
        file = netcdf_file(stream, "w", version=2)
        for key, value in self.facts.items():
            setattr(file, key, _stored(value))
        for axis in dict.fromkeys(variable.over for variable in self.variables):
            file.createDimension(axis, self.over(axis)[0].values.size)
        for variable in self.variables:
            name = variable_name(variable.name)
            while name in file.variables:  # as a parameter "failed" would be
                name += "_"
            made = file.createVariable(name, "d", (variable.over,))
            made[:] = variable.values
            made.long_name = _stored(variable.name)
            if variable.si is not None:
                made.units = _stored(variable.si or "1")
            if variable.name == "time":
                made.axis = "T"
            elif variable.values.dtype == float:
                made._FillValue = np.float64(np.nan)
        file.flush()
        return stream.getvalue()

    def xarray(self, library: Any) -> Any:
        """All of it as a Dataset of the package xarray; a variable named as its axis is a coordinate."""
        made = {v.name: (v.over, v.values, {} if v.si is None else {"units": v.si}) for v in self.variables}
        axes = {variable.over for variable in self.variables} & made.keys()
        rest = {name: array for name, array in made.items() if name not in axes}
        return library.Dataset(rest, {axis: made[axis] for axis in axes}, dict(self.facts))


def variable_of(
    quantities: Quantities, name: str, over: str, values: Array, dimension: Dimension, column: str = ""
) -> Variable:
    """A variable of a dimension, in the file's unit for it."""
    unit, size = quantities.unit_of(dimension)
    return Variable(name, over, values, unit, size, si_unit(dimension), column)


def times(quantities: Quantities, t: Array) -> Variable:
    """The axis ``time`` (s)."""
    return variable_of(quantities, "time", "time", t, TIME, column="t")


def described(compiled: Compiled, findings: Sequence[Finding]) -> dict[str, str]:
    """Title, source and findings."""
    from linkwright import _version

    return {
        "Conventions": "CF-1.11",
        "title": compiled.mechanism.title,
        "source": f"linkwright {_version.__version__}",
        "findings": "\n".join(f"{f.code}: {f.what}" for f in findings) or "none",
    }


def variable_name(name: str) -> str:
    """The name that a variable has in a netCDF file."""
    return _UNFIT.sub(lambda match: f"_u{ord(match[0]):04x}", name.strip())


def si_unit(dimension: Dimension) -> str:
    """The SI unit of a dimension."""
    from linkwright.expressions.units import PURE, UnitError, unit_text

    try:
        return unit_text(dimension, {}, strict=False)
    except UnitError:
        return "" if dimension.physical == PURE else "SI"


def _stored(value: Any) -> Any:
    """An attribute as the format keeps it: texts as UTF-8, whole numbers in 32 bits."""
    if isinstance(value, str):
        return value.encode()
    return np.int32(value) if isinstance(value, int) else np.float64(value)
