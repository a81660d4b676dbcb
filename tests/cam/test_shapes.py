"""Drawing and solid read back by ezdxf, Shapely and Open CASCADE; areas."""

from __future__ import annotations

import io
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.cam.lifts import HEAT_SEAL, harmonic, heat_seal

from linkwright.cam.contour import area, contour
from linkwright.cam.disc import Disc
from linkwright.cam.drawing import dxf
from linkwright.cam.followers import SwingingRoller, TranslatingFlat
from linkwright.cam.solid import Blank, solid, step
from linkwright.cam.splines import splines

DISC = Disc(SwingingRoller(0.039, 0.020, 0.085, 0.090), heat_seal, -1, HEAT_SEAL)


def off(places: Any) -> float:
    """How far places (n, 2), mm, lie from the exact profile (mm), along its normals."""
    from scipy.spatial import KDTree

    look = DISC.look(np.linspace(0, 2 * np.pi, 80_000))
    profile, normal = 1e3 * look.offset(-0.02), look.offset(1.0) - look.offset(0.0)
    which = KDTree(profile.T).query(places)[1]
    return float(np.abs(((np.asarray(places).T - profile[:, which]) * normal[:, which]).sum(axis=0)).max())


def places(line: Any, count: int) -> list[tuple[float, float]]:
    """Places along a polyline, ``count`` on each arc: as it is, ezdxf's paths are Bezier curves, some 1e-2 mm off."""
    found: list[Any] = []
    for part in line.virtual_entities():
        if part.dxftype() == "LINE":
            found += [part.dxf.start, part.dxf.end]
        else:
            low, high = part.dxf.start_angle, part.dxf.end_angle
            found += part.vertices(low + np.linspace(0, 1, count) * ((high - low) % 360))
    return [(p[0], p[1]) for p in found]


def test_areas() -> None:
    """A circle in closed form, the heat-seal cam against Shapely."""
    import shapely

    assert area(Disc(TranslatingFlat(25.0), harmonic(25.0))) == pytest.approx(math.pi * 2500, rel=1e-13)
    corners = DISC.look(np.linspace(0, 2 * np.pi, 200_000, endpoint=False)).offset(-0.02).T
    assert area(DISC) == pytest.approx(shapely.Polygon(corners).area, rel=1e-8)


@pytest.mark.parametrize("tolerance", [1e-6, 1e-8])
def test_the_drawing_is_within_its_tolerance(tolerance: float) -> None:
    ezdxf = pytest.importorskip("ezdxf")
    text = dxf({"PROFILE": contour(DISC, tolerance)}, {"BORE": [(0.0, 0.0, 10.0)]})
    drawing = ezdxf.read(io.StringIO(text))
    assert not drawing.audit().errors
    (line,) = drawing.modelspace().query("LWPOLYLINE")
    assert line.closed
    assert line.dxf.layer == "PROFILE"
    assert off(places(line, 40)) < 1e3 * tolerance * 1.01
    (circle,) = drawing.modelspace().query("CIRCLE")
    assert circle.dxf.radius == 10.0


@pytest.mark.parametrize("tolerance", [1e-6, 1e-8])
def test_the_drawing_by_splines(tolerance: float) -> None:
    """One spline from join to join, evaluated by SciPy from what the drawing holds."""
    from scipy.interpolate import BSpline

    ezdxf = pytest.importorskip("ezdxf")
    drawing = ezdxf.read(io.StringIO(dxf({}, {}, {"PROFILE": splines(DISC, tolerance)})))
    assert not drawing.audit().errors
    found = [
        BSpline(np.array(one.knots), np.array(one.control_points)[:, :2], one.dxf.degree)
        for one in drawing.modelspace().query("SPLINE")
    ]
    assert len(found) == len(HEAT_SEAL)
    places = [made(np.linspace(made.t[0], made.t[-1], 500)) for made in found]
    assert off(np.concatenate(places)) < 1e3 * tolerance * 1.01
    for before, after in zip(places, [*places[1:], places[0]], strict=True):
        assert np.hypot(*(before[-1] - after[0])) < 1e-9


@pytest.mark.parametrize("by", [-0.02, 0.02])
def test_both_flanks_are_offsets_of_the_pitch_curve(by: float) -> None:
    """By Shapely's offset of the pitch curve as a polygon; GEOS smooths what it offsets by some 1e-5 of the offset."""
    import shapely

    corners = DISC.look(np.linspace(0, 2 * np.pi, 20_000, endpoint=False)).offset(0.0).T
    drawn = shapely.buffer(shapely.Polygon(corners), by, quad_segs=5000)
    flank = shapely.Polygon([e.start for e in contour(DISC, 1e-8, by)])
    assert drawn.area == pytest.approx(area(DISC, by), rel=1e-5)
    places = shapely.points(shapely.get_coordinates(flank) / 1e3)
    assert shapely.distance(drawn.exterior, places).max() < 1e-6


def read_back(text: bytes, folder: Path) -> Any:
    """The one valid solid of a STEP file."""
    (folder / "cam.step").write_bytes(text)
    (found,) = pytest.importorskip("build123d").import_step(str(folder / "cam.step")).solids()
    assert found.is_valid
    return found


def test_a_groove_in_a_plate_read_back(tmp_path: Path) -> None:
    """Volume against the exact areas; the floor of the groove lies between its flanks, at its depth below the face."""
    blank = Blank(20.0, bore=10.0, hub=15.0, height=6.0, radius=100.0, groove=9.0)
    found = read_back(step(solid(contour(DISC, 1e-6), blank, contour(DISC, 1e-6, 0.02))), tmp_path)
    inner, outer = (1e6 * area(DISC, by) for by in (-0.02, 0.02))
    assert found.volume == pytest.approx(blank.volume(inner, outer), rel=1e-5)
    (floor,) = [face for face in found.faces() if abs(face.center().Z - 11.0) < 1e-6 and abs(face.normal_at().Z) > 0.99]
    assert floor.area == pytest.approx(outer - inner, rel=1e-4)


def test_the_solid_read_back(tmp_path: Path) -> None:
    """Volume against the exact area, to 1e-6, at a tolerance of 1e-5 mm; the contour within it; one valid solid."""
    blank = Blank(12.0, bore=10.0, hub=18.0, height=8.0, key_width=6.0, key_depth=2.8, key_angle=0.3)
    found = read_back(step(solid(contour(DISC, 1e-8), blank)), tmp_path)
    assert found.volume == pytest.approx(blank.volume(1e6 * area(DISC)), rel=1e-6)
    bottom = min(found.faces(), key=lambda face: face.center().Z)
    places = [p for edge in bottom.outer_wire().edges() for p in (edge @ 0.0, edge @ 0.3, edge @ 0.8)]
    assert off([(p.X, p.Y) for p in places]) < 1.1e-5
    box = found.bounding_box()
    assert (pytest.approx(0.0, abs=1e-6), pytest.approx(20.0, abs=1e-6)) == (box.min.Z, box.max.Z)


@pytest.mark.parametrize("angle", [0.0, 0.3, -2.0])
def test_the_keyway_of_the_drawing_is_that_of_the_solid(angle: float, tmp_path: Path) -> None:
    """Bore and keyway, one closed contour: its area in closed form, its shape by Shapely, the section of the solid."""
    import shapely

    ezdxf = pytest.importorskip("ezdxf")
    blank = Blank(12.0, bore=10.0, key_width=6.0, key_depth=2.8, key_angle=angle)
    drawing = ezdxf.read(io.StringIO(dxf({"PROFILE": contour(DISC, 1e-6), "BORE": blank.keyed_bore}, {})))
    assert not drawing.audit().errors
    (line,) = drawing.modelspace().query('LWPOLYLINE[layer=="BORE"]')
    assert line.closed and not drawing.modelspace().query("CIRCLE")
    drawn = shapely.set_precision(shapely.Polygon(places(line, 2000)), 1e-9)  # joins apart by round-off
    assert drawn.is_valid and drawn.area == pytest.approx(blank.hollow, rel=1e-6)
    key = shapely.affinity.rotate(shapely.box(0, -3, 12.8, 3), angle, origin=(0, 0), use_radians=True)
    wanted = shapely.Point(0, 0).buffer(10.0, quad_segs=2000).union(key)
    assert drawn.symmetric_difference(wanted).area < 1e-5 * wanted.area
    bottom = min(read_back(step(solid(contour(DISC, 1e-6), blank)), tmp_path).faces(), key=lambda face: face.center().Z)
    assert bottom.area == pytest.approx(1e6 * area(DISC) - drawn.area, rel=1e-6)
    (hole,) = bottom.inner_wires()
    found = shapely.Polygon([((hole @ u).X, (hole @ u).Y) for u in np.linspace(0, 1, 4000)])
    assert found.symmetric_difference(drawn).area < 1e-3 * drawn.area


def test_a_bore_without_a_keyway_stays_a_circle() -> None:
    assert Blank(12.0, bore=10.0).keyed_bore == [] and Blank(12.0, key_width=6.0).keyed_bore == []


def test_bore_and_keyway() -> None:
    """By a sum over small squares."""
    blank = Blank(1.0, bore=10.0, key_width=6.0, key_depth=2.8)
    x, y = np.meshgrid(np.arange(-15, 15, 0.01) + 0.005, np.arange(-15, 15, 0.01) + 0.005)
    inside = (np.hypot(x, y) < 10) | ((x > 0) & (x < 12.8) & (np.abs(y) < 3))
    assert blank.hollow == pytest.approx(inside.sum() * 1e-4, rel=1e-4)
