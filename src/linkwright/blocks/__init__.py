"""Large work in fixed atoms: carried by threads or a cluster, reduced or stored, interrupted and resumed.

Knows nothing of mechanisms. A :class:`Work` opens as a :class:`Task`, whose atoms a runner performs in any order and
a :class:`Sink` takes in theirs; so no runner and no size of block changes a bit of what comes out.
"""

from linkwright.blocks.checkpoint import Checkpoint
from linkwright.blocks.cluster import Cluster
from linkwright.blocks.histogram import Histogram
from linkwright.blocks.kurtosis import Fourth
from linkwright.blocks.loop import Carried, Progress, carry
from linkwright.blocks.moments import Moments
from linkwright.blocks.reductions import Reduction, Tallies
from linkwright.blocks.runners import RUNNERS, Runner, Threads
from linkwright.blocks.sinks import Folding, Together
from linkwright.blocks.streams import generator
from linkwright.blocks.work import UNIT, Cut, Sink, Task, Work

__all__ = [
    "RUNNERS",
    "UNIT",
    "Carried",
    "Checkpoint",
    "Cluster",
    "Cut",
    "Folding",
    "Fourth",
    "Histogram",
    "Moments",
    "Progress",
    "Reduction",
    "Runner",
    "Sink",
    "Tallies",
    "Task",
    "Threads",
    "Together",
    "Work",
    "carry",
    "generator",
]
