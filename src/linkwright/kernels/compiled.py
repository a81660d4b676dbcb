"""A compiled mechanism: graph, branches, drive laws and kernels, ready to run over times."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from linkwright.graph.assembly import Assembly, assemble
from linkwright.graph.graph import Graph
from linkwright.graph.redundant import redundant
from linkwright.kernels.follow import Follower
from linkwright.kernels.laws import Law, drive_laws, values_at
from linkwright.kernels.registry import KERNELS, Kernel
from linkwright.model.check import check_names, check_values
from linkwright.model.findings import Finding, raise_errors
from linkwright.model.mechanism import Mechanism
from linkwright.model.quantities import Quantities
from linkwright.notation import MAX_ORDER
from linkwright.structure import Cluster, Structure, Topology, decompose

Array = NDArray[np.float64]


@dataclass
class Compiled:
    """A mechanism ready to run. ``laws`` gives each drive's value and rates (SI) at an array of times (s)."""

    mechanism: Mechanism
    quantities: Quantities
    structure: Structure
    assembly: Assembly
    laws: dict[str, Law]
    kernel: str = "numpy"
    _kernels: dict[tuple[tuple[str, ...], bool], Kernel] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.graph = Graph(self.quantities, self.structure)
        self.parameters = np.array([self.quantities.parameters[name] for name in self.graph.parameters])
        size = self.assembly.size()
        self.followers = [
            Follower(self.graph, cluster, self.assembly.starts[cluster], size, self.kernel)
            for cluster in self.structure.clusters
        ]

    def inputs(self, t: Array, clusters: int | None = None) -> Array:
        """The per-pose inputs at times ``t`` (s): (inputs, poses), in SI; only the first ``clusters`` in place."""
        width = MAX_ORDER + 2
        x = np.empty((len(self.graph.inputs), t.size))
        for i, drive in enumerate(self.graph.drives):
            x[i * width : (i + 1) * width] = [np.broadcast_to(d, t.shape) for d in self.laws[drive](t).d]
        for i, group in enumerate(self.graph.branched, start=width * len(self.graph.drives)):
            x[i] = self.assembly.branches[group]
        x[self.graph.first_unknown :] = np.nan
        for i, follower in enumerate(self.followers[:clusters]):
            x[follower.rows] = follower.solve(x, t, self.parameters, partial(self.inputs, clusters=i))
        return x

    def unknowns(self, time: float) -> dict[Cluster, list[float]]:
        """The coordinates of every cluster at a time."""
        x = self.inputs(np.array([time]))[:, 0]
        return {follower.cluster: x[follower.rows].tolist() for follower in self.followers}

    def evaluate(self, names: Sequence[str], t: Array, rates: bool = False) -> Array:
        """The named rows at times ``t``: (names, poses) in SI, or (names, 2, poses) with their rates.

        Angles of links come out in -pi..pi where the graph doesn't know them exactly; see
        :class:`linkwright.results.Run` for continuous ones.
        """
        key = (tuple(names), rates)
        if key not in self._kernels:
            self._kernels[key] = KERNELS[self.kernel](self.graph.program(*key))
        y = self._kernels[key].run(self.inputs(t), self.parameters)
        return y.reshape(len(names), 2, t.size) if rates else y


@dataclass
class Prepared:
    """A mechanism as far as it is known before its assembly modes are settled."""

    quantities: Quantities
    structure: Structure
    laws: dict[str, Law]
    findings: list[Finding]


def prepare(mechanism: Mechanism, folder: Path | None = None) -> Prepared:
    """Dimensions, structure and drive laws of a mechanism, with all findings on them."""
    names, quantities = check_names(mechanism), Quantities(mechanism)
    findings = [*names, *(f for f in quantities.findings if not _said(f, names))]
    laws: dict[str, Law] = {}
    if not quantities.findings:
        laws, faults = drive_laws(quantities, folder)
        findings += [*check_values(quantities), *faults]
    structure = decompose(mechanism) if not names else Structure(Topology(mechanism), ())
    if not findings:
        findings = redundant(quantities, structure, values_at(laws, 0.0))
    else:
        findings += structure.findings
    return Prepared(quantities, structure, laws, findings)


def examine(mechanism: Mechanism, folder: Path | None = None) -> tuple[Compiled | None, list[Finding]]:
    """Compile a mechanism as far as it goes, with all findings; ``folder`` is where its table files lie.

    The result is ``None`` where an error stops it.
    """
    made = prepare(mechanism, folder)
    if made.findings:
        return None, made.findings
    assembly = assemble(made.quantities, made.structure, values_at(made.laws, 0.0))
    if assembly.findings:
        return None, list(assembly.findings)
    return Compiled(mechanism, made.quantities, made.structure, assembly, made.laws), []


def _said(finding: Finding, others: list[Finding]) -> bool:
    return any(other.path == finding.path and other.code == finding.code for other in others)


def compile_mechanism(mechanism: Mechanism, folder: str | Path | None = None) -> Compiled:
    """A mechanism ready to run. Raises :class:`ModelError` with every finding when it can't be."""
    compiled, findings = examine(mechanism, Path(folder) if folder else None)
    raise_errors(findings)
    assert compiled is not None
    return compiled
