"""A result as a netCDF file: classic format (64-bit offset), written by SciPy, attributes after the CF conventions."""

from __future__ import annotations

import io
import re
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from linkwright.findings import Finding
    from linkwright.kernels import Compiled
    from linkwright.results.result import Result

_UNFIT = re.compile(r"""[^A-Za-z0-9_.@+\- !"#$%&\\()*,:;<=>?\[\]^`{|}~']""")


def netcdf_bytes(result: Result, names: Sequence[str], warnings: Sequence[Finding] = ()) -> bytes:
    """The named signals or expressions over ``time``, in SI; NaN is the missing value.

    A variable is named as its signal where the format allows it (``force(frame, crank).x`` is allowed, Chinese
    letters and ``/`` are not, and are spelled ``_u66f2``); its ``long_name`` is always the signal's own name.
    """
    from scipy.io import netcdf_file

    stream = io.BytesIO()
    file = netcdf_file(stream, "w", version=2)
    for key, value in attributes(result, warnings).items():
        setattr(file, key, stored(value))
    file.createDimension("time", result.t.size)
    _variable(file, "time", "time", "s", result.t).axis = "T"
    for name in names:
        values, unit = result.si(name)
        _variable(file, variable_name(name), name, unit, values)._FillValue = np.float64(np.nan)
    file.flush()
    return stream.getvalue()


def variable_name(name: str) -> str:
    """The name that a signal or expression has in a netCDF file."""
    return _UNFIT.sub(lambda match: f"_u{ord(match[0]):04x}", name.strip())


def described(compiled: Compiled, findings: Sequence[Finding]) -> dict[str, str]:
    """Title, source and findings."""
    from linkwright import _version

    return {
        "Conventions": "CF-1.11",
        "title": compiled.mechanism.title,
        "source": f"linkwright {_version.__version__}",
        "findings": "\n".join(f"{f.code}: {f.what}" for f in findings) or "none",
    }


def attributes(result: Result, warnings: Sequence[Finding] = ()) -> dict[str, Any]:
    """Title, source, the certificate's figures and all findings, as numbers and texts."""
    c = result.certificate
    data: dict[str, Any] = described(result.run.compiled, (*result.failures, *warnings))
    if c is None:
        return data
    figures = {**c.residuals, "mobility": c.mobility, "gruebler": c.gruebler, "rank": c.rank, "poses": c.poses}
    if c.nearest is not None:
        figures |= {"smallest_determinant": c.nearest.determinant, "smallest_determinant_time": c.nearest.time}
        data["certificate_smallest_determinant_group"] = c.nearest.group
    data |= {f"certificate_{name}": figure for name, figure in figures.items()}
    data["certificate_branches"] = "; ".join(str(rule) for rule in c.branches.values() if rule) or "none"
    return data


def _variable(file: Any, name: str, long_name: str, unit: str, values: Any) -> Any:
    variable = file.createVariable(name, "d", ("time",))
    variable[:] = values
    variable.long_name, variable.units = stored(long_name), stored(unit or "1")
    return variable


def stored(value: Any) -> Any:
    """An attribute as the format keeps it: texts as UTF-8, whole numbers in 32 bits."""
    if isinstance(value, str):
        return value.encode()
    return np.int32(value) if isinstance(value, int) else np.float64(value)
