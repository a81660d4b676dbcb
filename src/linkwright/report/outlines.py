"""Lines that are drawn on links: recorded, and as programs by which a page finds them at other numbers of the file."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from linkwright.graph.geometry import Geometry
from linkwright.graph.program import Program
from linkwright.kernels import Compiled
from linkwright.notation import Scalar
from linkwright.report.data import LiveOutline as LiveOutlineData
from linkwright.symbols import ExpressionStage, Symbol

Array = NDArray[np.float64]

Shapes = dict[str, list[list[list[float]]]]
"""Closed lines by link: points in the link's axes."""


class LiveOutline(NamedTuple):
    """Lines on a link as a page computes them: the program's inputs at each place (places, inputs); its outputs are the
    places of all lines (m), two a line.

    With the name of a signal as ``travel`` two inputs follow, its lowest and highest value. A line with a ``width`` (m)
    is open, and drawn as a slot.
    """

    link: str
    program: Program
    inputs: Array
    travel: str = ""
    width: float = 0.0

    def data(self) -> LiveOutlineData:
        """What the page gets of it, besides its program."""
        inputs = [[float(f"{value:.15g}") for value in at] for at in self.inputs.tolist()]
        found: LiveOutlineData = {"link": self.link, "lines": len(self.program.outputs) // 2, "inputs": inputs}
        if self.travel:
            found["travel"] = self.travel
        if self.width:
            found["width"] = float(f"{self.width:.6g}")
        return found


def outline_program(
    compiled: Compiled, count: int, places: Callable[[Geometry, list[Symbol]], Sequence[tuple[Scalar, Scalar]]]
) -> Program:
    """The program of lines at any parameters: their ``places`` by the dimensions and by so many inputs."""
    names = compiled.graph.parameters
    symbols = [Symbol.named(each) for each in names]
    geometry, x = Geometry(compiled.quantities, dict(zip(names, symbols, strict=True))), Symbol.several("x", count)
    rows = [coordinate for place in places(geometry, x) for coordinate in place]
    inputs, outputs = (tuple(map(str, range(size))) for size in (count, len(rows)))
    return Program((), ExpressionStage(x, symbols, rows), inputs, names, outputs)
