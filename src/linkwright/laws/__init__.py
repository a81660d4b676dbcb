"""Motion laws, shared by drives and (later) cams."""

from linkwright.laws.step import step5
from linkwright.laws.table import DEGREES, OutsideTable, TableLaw

__all__ = ["DEGREES", "OutsideTable", "TableLaw", "step5"]
