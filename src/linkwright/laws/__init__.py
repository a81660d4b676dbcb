"""Motion laws, shared by drives and cams: normalised laws by name, segments, motions; tables."""

from linkwright.laws.curve import Curve, Extreme, Join
from linkwright.laws.harmonics import series
from linkwright.laws.motion import Motion, motion
from linkwright.laws.pieces import Formula, Piece, Wave
from linkwright.laws.polynomials import of_powers, polynomial
from linkwright.laws.registry import LAWS, Law
from linkwright.laws.scca import scca, scca_by_widths
from linkwright.laws.segments import Blend, Dwell, MotionError, MotionFault, Rise, Segment, Shape
from linkwright.laws.splines import b_spline, spline
from linkwright.laws.step import step5
from linkwright.laws.table import DEGREES, OutsideTable, TableLaw

__all__ = [
    "DEGREES",
    "LAWS",
    "Blend",
    "Curve",
    "Dwell",
    "Extreme",
    "Formula",
    "Join",
    "Law",
    "Motion",
    "MotionError",
    "MotionFault",
    "OutsideTable",
    "Piece",
    "Rise",
    "Segment",
    "Shape",
    "TableLaw",
    "Wave",
    "b_spline",
    "motion",
    "of_powers",
    "polynomial",
    "scca",
    "scca_by_widths",
    "series",
    "spline",
    "step5",
]
