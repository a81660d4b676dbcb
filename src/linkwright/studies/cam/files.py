"""The files of a cam study: the profile as CSV, DXF, SVG and STEP, NC code, the follower's motion as formulas."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.disc import TURN
from linkwright.cam.drawing import Circle, dxf
from linkwright.cam.nc.path import Element
from linkwright.cam.nc.posts import POSTS
from linkwright.cam.solid import solid, step
from linkwright.cam.splines import Spline
from linkwright.expressions import units as u
from linkwright.expressions.language import Binary, Call, Number
from linkwright.findings import Said
from linkwright.formulas.functions import OfMotion
from linkwright.formulas.motor import motor, unit_of
from linkwright.formulas.pieces import TooManyError, Unfolding
from linkwright.formulas.terms import T, number
from linkwright.model.csv_text import cell, head, table_text
from linkwright.presentation.blocks import FileOf
from linkwright.studies.cam.outcome import CamOutcome
from linkwright.studies.cam.picture import still
from linkwright.studies.cam.plate import Plate

Array = NDArray[np.float64]


Content = str | bytes | None
OfPlate = Callable[[CamOutcome, Plate], Content]


def profile_csv(outcome: CamOutcome, plate: Plate) -> str:
    """A disc over a turn: lift, pitch curve and profile about the cam's centre in directions of its link's axes,
    their normal, radii of curvature (negative where hollow), pressure angle."""
    header, columns = zip(*_columns(outcome, plate), strict=True)
    rows = ([cell(value) for value in row] for row in np.array(columns).T.tolist())
    return table_text(list(header), rows)


def _columns(outcome: CamOutcome, plate: Plate) -> Iterator[tuple[str, Array]]:
    quantities, look, count = outcome.compiled.quantities, plate.look, plate.theta.size
    length, mm = quantities.unit_of(u.LENGTH)
    angle, deg = quantities.unit_of(u.ANGLE)
    lift, size = quantities.unit_of(outcome.lift_dimension)
    radius = plate.disc.follower.radius
    yield head("theta", angle), plate.theta / deg
    yield head("lift", lift), np.broadcast_to(look.lift.d[0], count) / size
    if radius:
        x, y = plate.points_along_link(look.offset(0.0)) / mm
        yield head("pitch x", length), x
        yield head("pitch y", length), y
    if plate.has_profile:
        x, y = plate.points_along_link(look.offset(-radius)) / mm
        yield head("profile x", length), x
        yield head("profile y", length), y
    x, y = plate.points_along_link(look.offset(1.0) - look.offset(0.0))
    yield "normal x", x
    yield "normal y", y
    if radius:
        yield head("pitch radius", length), look.radius() / mm
    if plate.has_profile:
        yield head("profile radius", length), look.radius(-radius) / mm
    yield head("pressure angle", angle), np.broadcast_to(look.pressure.d[0], count) / deg


def has_drawing(outcome: CamOutcome) -> bool:
    """Whether there is a profile to draw."""
    return any(plate.has_profile for plate in outcome.plates)


def has_solid(outcome: CamOutcome, plate: Plate) -> bool:
    """Whether a disc has a blank that it can be made of."""
    return outcome.stated.blank is not None and plate.volume is not None and plate.fits


def cam_dxf(outcome: CamOutcome) -> str | None:
    """The drawing in mm, of both discs where there are two; nothing where there is no profile."""
    if not has_drawing(outcome):
        return None
    made = [plate for plate in outcome.plates if plate.has_profile]
    blank = outcome.stated.blank
    circles: dict[str, list[Circle]] = {}
    bores: dict[str, Sequence[Element]] = {}
    if blank is not None and blank.keyed_bore:
        bores["BORE"] = blank.keyed_bore
    elif blank is not None and blank.bore:
        circles["BORE"] = [(0.0, 0.0, blank.bore)]
    if blank is not None and blank.hub:
        circles["HUB"] = [(0.0, 0.0, blank.hub)]
    if blank is not None and blank.radius:
        circles["PLATE"] = [(0.0, 0.0, blank.radius)]
    layers: dict[str, Sequence[Element]] = {}
    curves: dict[str, Sequence[Spline]] = {}
    for plate in made:
        own = {"SECOND" if plate.second else "PROFILE": plate.contour} | ({"FLANK": plate.flank} if plate.flank else {})
        layers |= own
        curves |= zip(own, plate.splines, strict=False)
    return dxf(layers | bores, circles) if outcome.options.drawing == "arcs" else dxf(bores, circles, curves)


def cam_step(outcome: CamOutcome, plate: Plate) -> bytes | None:
    """The solid in mm; nothing where no blank is stated, or it doesn't fit."""
    blank = outcome.stated.blank
    if blank is None or not has_solid(outcome, plate):
        return None
    return step(solid(plate.contour, blank, plate.flank))


def motion_text(outcome: CamOutcome) -> str | None:
    """The follower's motion over a turn as formulas in t for the motor of Creo Mechanism, which counts in degrees: each
    line a domain and its formula. Nothing of a law of more pieces than anyone types."""
    period = outcome.stated.period
    asked = Binary("*", Number(TURN / period), T)
    try:
        pieces = Unfolding(period, {}, {"law": OfMotion(outcome.law)}).pieces(Call("law", (asked,)))
    except TooManyError:
        return None
    unit = unit_of(outcome.compiled.quantities, outcome.lift_dimension)
    made = motor(pieces, unit, lambda t: outcome.law.at(TURN / period * t), "creo", period)
    about = {"name": outcome.name, "unit": made.unit, "period": number(period), "error": f"{made.error:.1e}"}
    return "\n".join([str(Said("cam.motion", **about)), str(Said("motors.dialect.creo")), "", *made.lines]) + "\n"


def nc(post: str) -> OfPlate:
    """The file for a control: only one that is proven."""
    return lambda _, plate: next((one.text for one in plate.milled if one.post.name == post and one.proven), None)


def _first(made: OfPlate) -> Callable[[CamOutcome], Content]:
    return lambda outcome: made(outcome, outcome.first)


def _second(made: OfPlate) -> Callable[[CamOutcome], Content]:
    return lambda outcome: None if outcome.second is None else made(outcome, outcome.second)


def _first_solid(outcome: CamOutcome) -> bool:
    return has_solid(outcome, outcome.first)


def _second_solid(outcome: CamOutcome) -> bool:
    return outcome.second is not None and has_solid(outcome, outcome.second)


_EZDXF, _BUILD123D = ("ezdxf", "cad"), ("build123d", "cad")

FILES: dict[str, FileOf] = {
    "cam_profile.csv": FileOf(_first(profile_csv)),
    "cam.svg": FileOf(still),
    "cam.dxf": FileOf(cam_dxf, "dxf", needs=_EZDXF, due=has_drawing),
    "cam.step": FileOf(_first(cam_step), "step", needs=_BUILD123D, due=_first_solid),
    "cam_motion.txt": FileOf(motion_text),
    **{f"cam_{name}.{post.suffix}": FileOf(_first(nc(name))) for name, post in POSTS.items()},
    "cam_second_profile.csv": FileOf(_second(profile_csv)),
    "cam_second.step": FileOf(_second(cam_step), "step", needs=_BUILD123D, due=_second_solid),
    **{f"cam_second_{name}.{post.suffix}": FileOf(_second(nc(name))) for name, post in POSTS.items()},
}
"""By name."""
