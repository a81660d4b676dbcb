"""What a page needs to compute the motion of a mechanism itself, with parameters that its reader moves: programs, and
the plain data that join them.

The page does what :class:`linkwright.kernels.parameter_batch.Varied` does for one sample: parameters from the free
ones, drives from the time, coordinates of higher groups by continuation, whole turns, tables, ratios of followers, and
then all signals. How it joins the programs: ``web/src/program/``.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from itertools import chain
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions.typed_fields import Sign
from linkwright.findings import Finding
from linkwright.graph.program import Program
from linkwright.graph.rows import Named, ReachRow, reaches
from linkwright.graph.tangent import tangent
from linkwright.kernels.compiled import Compiled
from linkwright.kernels.javascript_source import javascript_array
from linkwright.kernels.page_inputs import (
    UNSTATED,
    Length,
    constants_program,
    derived_parameters,
    fixed_parameters,
    law_program,
    law_slopes_program,
    locked_parameters,
    number_conditions,
    ratio_program,
    shape_program,
    shaping,
    table_pieces,
)
from linkwright.model.conditions import Condition
from linkwright.model.quantities import LARGEST

Array = NDArray[np.float64]

SIGNS = {Sign.ANY: 0, Sign.NOT_NEGATIVE: 1, Sign.POSITIVE: 2}
"""What a number that is checked must be: have a value at all, not be negative, be positive."""


@dataclass(frozen=True)
class PagePrograms:
    """A compiled mechanism's ``rows`` as a page computes them, and the ``measured`` ones with their rates in time, with
    all parameters but the ``locked`` ones free; programs of ``outlines`` give places of lines on links,
    ``length`` how long the run is. Parameters that a sketch stands for (``drawn``) follow from it until they are
    stated.

    A locked parameter has a finding that says why: what depends on it is no expression.
    """

    compiled: Compiled
    rows: tuple[Named, ...]
    measured: tuple[Named, ...] = ()
    outlines: tuple[Program, ...] = ()
    length: Length | None = None
    drawn: tuple[str, ...] = ()

    @cached_property
    def locked(self) -> dict[str, Finding]:
        """The parameters that can't be moved, among the free ones."""
        return locked_parameters(self.compiled, self.derived.inputs)

    @cached_property
    def derived(self) -> Program:
        """All parameters (SI) from the free ones: those that depend on no other, and those of the sketch."""
        return derived_parameters(self.compiled.quantities, drawn=self.drawn)

    @cached_property
    def values(self) -> tuple[float, ...]:
        """The nominal values (SI) of the free ones; nothing states those of the sketch."""
        nominal = self.compiled.quantities.parameters
        return tuple(UNSTATED if name in self.drawn else nominal[name] for name in self.derived.inputs)

    @cached_property
    def fixed(self) -> frozenset[str]:
        """The parameters that follow from locked ones alone."""
        return fixed_parameters(self.compiled.quantities, self.derived.inputs, self.locked)

    @cached_property
    def signals(self) -> Program:
        """The rows, then the reaches of all dyads with two modes, then the measured rows with their rates, from inputs
        that are all known."""
        return self.compiled.graph.with_rates([*self.rows, *self.reaches], self.measured)

    @cached_property
    def reaches(self) -> list[ReachRow]:
        """The rows whose signs say which dyads can't close."""
        return reaches(self.compiled.structure)

    @cached_property
    def conditions(self) -> list[Condition]:
        """The conditions on numbers that the page checks, in their order."""
        return number_conditions(self.compiled, length=self.length)

    @cached_property
    def points(self) -> tuple[str, ...]:
        """All points of links and of the frame: those that a reader may drag."""
        return tuple(self.compiled.quantities.signals.links_of_points)

    @cached_property
    def dragged(self) -> Program:
        """The places of all points and the reaches, each with its derivative along a direction of the parameters and
        the drives."""
        places = [f"{point}.{axis}" for point in self.points for axis in "xy"]
        return tangent(self.compiled.graph, [*places, *self.reaches])

    @cached_property
    def programs(self) -> dict[str, list[Program]]:
        """All programs, by what they are for."""
        compiled, supply = self.compiled, self.compiled.supply
        graph = compiled.graph
        used = self.signals.used[0]
        turns = [supply.turns[name].kernel.program for name in graph.actions.turning]
        return {
            "derived": [self.derived],
            "constants": [constants_program(compiled, self.length)],
            "laws": [law_program(compiled, self.fixed)],
            "law_slopes": [law_slopes_program(compiled, self.fixed)],
            "closures": [graph.program(graph.closure(group)) for group in compiled.structure.higher_groups],
            "turns": turns,
            "lookups": [kernel.program for _, kernel in supply.levels],
            "ratios": [ratio_program(compiled, self.fixed)] if supply.followers and max(used) >= supply.first else [],
            "signals": [self.signals],
            "nearest": [graph.nearest_poses],
            "dragged": [self.dragged],
            "slopes": [derived_parameters(compiled.quantities, True, self.drawn)],
            "shape": [shape_program(compiled)],
            "outlines": [*self.outlines],
        }

    def code(self) -> str:
        """All programs as one JavaScript expression, an array: nothing of it comes from a name."""
        return javascript_array(chain.from_iterable(self.programs.values()))

    def data(self) -> dict[str, Any]:
        """All else, to be written as JSON. Rows are those of the inputs of a pose; numbers are in SI.

        ``programs``: how many there are of each kind, in the order of the array. ``higher``: of each higher group its
        rows, the scale of each coordinate, which of them slide, their start at the nominal parameters. ``turns``,
        ``lookups``, ``ratios``, ``totals``: the rows that are put in place before the signals. ``conditions``: what
        each number that is checked must be, a digit each, by :data:`SIGNS`; ``figures``: of which condition each
        further figure is that its sentence has, with the SI value of its unit; ``largest``: below which values are.
        """
        compiled, graph, supply = self.compiled, self.compiled.graph, self.compiled.supply
        rows, width = supply.rows, graph.width
        size = compiled.assembly.size()
        actions = graph.actions
        return {
            "programs": {kind: len(programs) for kind, programs in self.programs.items()},
            "free": list(self.derived.inputs),
            "values": list(self.values),
            "parameters": len(graph.parameters),
            "locked": sorted(self.locked),
            "inputs": len(graph.inputs),
            "drives": {"count": len(graph.drives), "width": width},
            "branches": [compiled.assembly.branches[group] for group in graph.branched],
            "groups": [row.group for row in self.reaches],
            "size": size,
            "higher": [
                {
                    "group": group.label,
                    "rows": graph.coordinates(group),
                    "scale": list(group.units(size)),
                    "slides": [not turning for turning in group.turning],
                    "start": list(compiled.assembly.starts[group]),
                }
                for group in compiled.structure.higher_groups
            ],
            "time": rows.get("t"),
            "turns": [
                {"row": rows[f"turns/{name}"], "started": supply.start_angle(name) is not None}
                for name in actions.turning
            ],
            "tables": [table_pieces(compiled.tables[name]) for name in self._tables],
            "lookups": [[self._lookup(index) for index in which] for which, _ in supply.levels],
            "ratios": [
                {"rows": [rows[f"ratio/{name}/{k}"] for k in (0, 1)], "motor": supply.motor(law)}
                for name, law in supply.followers.items()
            ]
            if self.programs["ratios"]
            else [],
            "totals": [
                [rows[f"total/{name}"], law.total] for name, law in supply.followers.items() if f"total/{name}" in rows
            ],
            "outputs": len(self.rows),
            "measured": len(self.measured),
            "shape": len(self.programs["shape"][0].outputs),
            "shaping": shaping(compiled, self.derived, self.programs["shape"][0]),
            "points": list(self.points),
            "links": list(compiled.structure.topology.moving),
            "conditions": "".join(str(SIGNS[one.sign]) for one in self.conditions),
            "figures": [[k, one.size] for k, each in enumerate(self.conditions) for one in each.figures],
            "largest": LARGEST,
        }

    @cached_property
    def _tables(self) -> list[str]:
        """The tables that are asked."""
        return [*dict.fromkeys(lookup.table for lookup in self.compiled.graph.actions.lookups)]

    def _lookup(self, index: int) -> dict[str, Any]:
        """A lookup by its number: the row of its answer, whose rate follows, and of which table it is."""
        lookup = self.compiled.graph.actions.lookups[index]
        row = self.compiled.supply.rows[f"table/{index}/0"]
        return {"row": row, "table": self._tables.index(lookup.table), "integral": lookup.integral}


def page_programs(
    compiled: Compiled,
    rows: Sequence[Named],
    measured: Sequence[Named] = (),
    outlines: Sequence[Program] = (),
    length: Length | None = None,
    drawn: Sequence[str] = (),
) -> PagePrograms:
    """Rows of a mechanism as a page can compute them; those ``measured`` with their rates. Programs of ``outlines``
    have the mechanism's parameters; the ``length`` of the run follows them too, where it is given.
    Those of the sketch (``drawn``) may be stated."""
    return PagePrograms(compiled, tuple(rows), tuple(measured), tuple(outlines), length, tuple(drawn))
