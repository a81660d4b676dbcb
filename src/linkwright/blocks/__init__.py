"""Large work in fixed atoms: carried by threads or a cluster, reduced or stored, interrupted and resumed.

Knows nothing of mechanisms. A :class:`Work` opens as a :class:`Task`, whose atoms a runner performs in any order and
a :class:`Sink` takes in theirs; so no runner and no size of block changes a bit of what comes out.
"""

from typing import TYPE_CHECKING

from linkwright._lazy import names_of

if TYPE_CHECKING:
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

_PLACES = {
    "Carried": "linkwright.blocks.loop.Carried",
    "Checkpoint": "linkwright.blocks.checkpoint.Checkpoint",
    "Cluster": "linkwright.blocks.cluster.Cluster",
    "Cut": "linkwright.blocks.work.Cut",
    "Folding": "linkwright.blocks.sinks.Folding",
    "Fourth": "linkwright.blocks.kurtosis.Fourth",
    "Histogram": "linkwright.blocks.histogram.Histogram",
    "Moments": "linkwright.blocks.moments.Moments",
    "Progress": "linkwright.blocks.loop.Progress",
    "RUNNERS": "linkwright.blocks.runners.RUNNERS",
    "Reduction": "linkwright.blocks.reductions.Reduction",
    "Runner": "linkwright.blocks.runners.Runner",
    "Sink": "linkwright.blocks.work.Sink",
    "Tallies": "linkwright.blocks.reductions.Tallies",
    "Task": "linkwright.blocks.work.Task",
    "Threads": "linkwright.blocks.runners.Threads",
    "Together": "linkwright.blocks.sinks.Together",
    "UNIT": "linkwright.blocks.work.UNIT",
    "Work": "linkwright.blocks.work.Work",
    "carry": "linkwright.blocks.loop.carry",
    "generator": "linkwright.blocks.streams.generator",
}

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

__getattr__ = names_of(__name__, _PLACES)
