"""Large work in fixed atoms: carried by threads or a cluster, reduced or stored, interrupted and resumed.

Knows nothing of mechanisms. A :class:`Work` opens as a :class:`Task`, whose atoms a runner performs in any order and
a :class:`Sink` takes in theirs; so no runner and no size of block changes a bit of what comes out.
"""

from linkwright.blocks.reductions import Reduction, Tallies
from linkwright.blocks.streams import generator
from linkwright.blocks.work import UNIT, Cut, Sink, Task, Work

__all__ = ["UNIT", "Cut", "Reduction", "Sink", "Tallies", "Task", "Work", "generator"]
