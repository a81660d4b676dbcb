"""Why samples of a varied mechanism fail: the causes in the order in which they are met."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.findings import Finding
from linkwright.graph.assembly import shortfall_at, shortfall_data
from linkwright.graph.graph import Graph
from linkwright.structure import Group, HigherGroup, Structure

if TYPE_CHECKING:
    from linkwright.kernels.parameter_batch import Varied

Array = NDArray[np.float64]
Bad = NDArray[np.bool_]


@dataclass(frozen=True)
class Failures:
    """Of each sample, the ``time`` (s) from which it fails, infinite where it doesn't, and the number of the ``cause``
    among :attr:`Varied.causes`, -1 where there is none: both (samples,)."""

    time: Array
    cause: NDArray[np.intp]


class Cause:
    """Values that the model's own checks refuse."""

    of: Any = None

    def fails(self, graph: Graph, x: Array, reach: Mapping[str, Array]) -> Bad:
        """Where samples fail: (samples, times), from the inputs and the groups' reaches."""
        raise NotImplementedError

    def finding(self, varied: Varied, data: dict[str, Any], time: float, values: Array) -> Finding:
        """The finding on the first sample that fails."""
        faults = varied.faults(values[:, None])
        what = " ".join(fault.what for fault in faults[:1]) or "-"
        return Finding("varied.values", faults[0].path if faults else (), data | {"what": what})


class OfDrive(Cause):
    """A drive's law without a finite value, speed or acceleration."""

    def __init__(self, name: str) -> None:
        self.of = name

    def fails(self, graph: Graph, x: Array, reach: Mapping[str, Array]) -> Bad:
        first = graph.drives.index(self.of) * graph.width
        return np.asarray(~np.isfinite(x[first : first + 3]).all(axis=0))

    def finding(self, varied: Varied, data: dict[str, Any], time: float, values: Array) -> Finding:
        return Finding("varied.drive", varied.compiled.mechanism.path_of(self.of), data | {"drive": self.of})


class OfGroup(Cause):
    """A dyad that can't close."""

    def __init__(self, group: Group) -> None:
        self.of = group

    def fails(self, graph: Graph, x: Array, reach: Mapping[str, Array]) -> Bad:
        return np.asarray(reach[self.of.label] < 0)

    def finding(self, varied: Varied, data: dict[str, Any], time: float, values: Array) -> Finding:
        compiled, graph, p = varied.compiled, varied.graph, varied.parameters(values[:, None])
        x = varied.inputs(p, np.array([time]), frozenset(range(len(graph.motion_inputs))), "numpy")[:, 0, 0]
        drives = {name: float(x[i * graph.width]) for i, name in enumerate(graph.drives)}
        distance, limit = shortfall_at(
            compiled.quantities,
            compiled.structure,
            compiled.assembly.branches,
            drives,
            self.of,
            lambda higher_group: [float(x[row]) for row in graph.coordinates(higher_group)],
            dict(zip(graph.parameters, map(float, p[:, 0]), strict=True)),
        )
        short = shortfall_data(compiled.quantities, self.of, distance, limit)
        return Finding("varied.cannot-assemble", ("links", self.of.links[0]), short | data)


class OfHigherGroup(Cause):
    """A group beyond the dyads that can't be brought to its start pose or followed."""

    def __init__(self, higher_group: HigherGroup) -> None:
        self.of = higher_group

    def fails(self, graph: Graph, x: Array, reach: Mapping[str, Array]) -> Bad:
        return np.asarray(np.isnan(x[graph.coordinates(self.of)]).any(axis=0))

    def finding(self, varied: Varied, data: dict[str, Any], time: float, values: Array) -> Finding:
        return Finding("varied.stuck", ("links", self.of.links[0]), data | {"group": self.of.label})


def causes(structure: Structure) -> tuple[Cause, ...]:
    """All causes for which samples of a mechanism can fail, what comes first on a pose's way first."""
    drives = [OfDrive(name) for name in structure.topology.mechanism.movers]
    return (Cause(), *drives, *(OfGroup(s) if isinstance(s, Group) else OfHigherGroup(s) for s in structure.choices))
