"""A still drawing of a mechanism as SVG, for pages without script: the looks of ``web/src/drawing/``."""

from linkwright.report.mechanism_drawing.picture import drawing

__all__ = ["drawing"]
