"""netCDF files read back by SciPy and xarray: equal arrays, units, certificate, findings; whole or not at all."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.io import netcdf_file

import linkwright as lw
from linkwright import _machine as machine
from linkwright.results.dataset import variable_name
from studies.models import cycle_of, slider_crank

POLE = "pole(rod, frame).x"


@pytest.fixture(scope="module")
def result() -> lw.Result:
    return cycle_of({"name": "曲柄滑块", **slider_crank()}).result


def test_read_back_equal(result: lw.Result, tmp_path: Path) -> None:
    xarray = pytest.importorskip("xarray")
    more = [POLE, "B.x/C.x", "hypot(B.vx, B.vy)"]
    result.to_netcdf(tmp_path / "run.nc", more)
    with xarray.open_dataset(tmp_path / "run.nc") as data:
        assert len(data.data_vars) == len(result.names) + 3
        assert np.array_equal(data["time"].values, result.t)
        assert data["time"].attrs["units"] == "s"
        for name in (*result.names, *more):
            variable = data[variable_name(name)]
            assert np.array_equal(variable.values, result[name], equal_nan=True), name
            assert variable.dtype == np.float64
            assert variable.attrs["long_name"] == name
        units = {name: data[name].attrs["units"] for name in ("B.ax", "rod.omega", "motor.torque", "energy.kinetic")}
        assert units == {"B.ax": "m/s^2", "rod.omega": "rad/s", "motor.torque": "N*m", "energy.kinetic": "J"}
        assert data["B.x_u002fC.x"].attrs["units"] == "1"
        assert data.attrs["title"] == "曲柄滑块"
        assert data.attrs["Conventions"].startswith("CF-")
        assert data.attrs["source"] == f"linkwright {lw.__version__}"
        assert data.attrs["findings"] == "none"
        certificate = result.certificate
        assert certificate is not None
        assert data.attrs["certificate_closure"] == certificate.closure
        assert data.attrs["certificate_work"] == certificate.work
        assert data.attrs["certificate_mobility"] == 1
        assert data.attrs["certificate_smallest_determinant"] == certificate.nearest.determinant  # type: ignore[union-attr]
        assert data.attrs["certificate_branches"] == "C: ahead of B along guide"


def test_the_same_as_xarray_writes(result: lw.Result, tmp_path: Path) -> None:
    """Against another writer of the format: xarray's dataset of the same run, saved by its own SciPy backend."""
    xarray = pytest.importorskip("xarray")
    result.to_netcdf(tmp_path / "a.nc")
    result.to_xarray().to_netcdf(tmp_path / "b.nc", engine="scipy")
    with xarray.open_dataset(tmp_path / "a.nc") as a, xarray.open_dataset(tmp_path / "b.nc") as b:
        assert set(a.data_vars) == set(b.data_vars)
        assert all(np.array_equal(a[name].values, b[name].values, equal_nan=True) for name in a.data_vars)
        assert all(a[name].attrs["units"] == (b[name].attrs["units"] or "1") for name in a.data_vars)


def test_a_run_that_stops_has_holes_and_findings(tmp_path: Path) -> None:
    result = cycle_of(slider_crank(r=50, l=60)).result
    assert result.failures
    result.to_netcdf(tmp_path / "run.nc")
    with netcdf_file(tmp_path / "run.nc", mmap=False) as file:
        assert np.isnan(file.variables["C.x"][:]).any()
        assert np.isnan(file.variables["C.x"]._FillValue)
        assert file.findings.decode().startswith("motion.cannot-assemble: ")
        assert not hasattr(file, "certificate_closure")


def test_names_that_the_format_allows(result: lw.Result) -> None:
    assert all(variable_name(name) == name for name in (*result.names, POLE))
    assert variable_name("曲柄.x") == "_u66f2_u67c4.x"


def test_an_old_file_stays_where_a_new_one_fails(result: lw.Result, tmp_path: Path) -> None:
    path = tmp_path / "run.nc"
    path.write_text("old", "utf-8")
    with pytest.raises(lw.ModelError):
        result.to_netcdf(path, ["nobody.x"])
    assert path.read_text("utf-8") == "old"
    assert [each.name for each in tmp_path.iterdir()] == ["run.nc"]


def test_without_xarray_a_finding_says_what_to_install(result: lw.Result, monkeypatch: pytest.MonkeyPatch) -> None:
    def missing(name: str) -> Any:
        raise ImportError(name)

    monkeypatch.setattr(machine, "import_module", missing)
    with pytest.raises(lw.ModelError) as caught:
        result.to_xarray()
    assert [f.code for f in caught.value.findings] == ["file.needs-package"]
    assert 'pip install "linkwright[xarray]"' in str(caught.value)
