"""A program as short functions of one pose, for emitters that print them: what depends on the parameters alone first,
once; then the pose, Newton's stages in it.

Functions read and write arrays by rows known beforehand: ``x`` the pose's inputs, ``o`` its outputs, ``p`` the
parameters, ``c`` what was computed of them, ``w`` what passes from one function of a pose to the next. Elementary
functions are called. No name of an input, parameter or output comes into it.
"""

from __future__ import annotations

from dataclasses import field
from functools import cache

from linkwright.data_classes import dataclass
from linkwright.graph.program import NewtonStage, Program
from linkwright.kernels.division import FORMS, OWN, SCALAR, Division, Rows
from linkwright.kernels.listing import Listing
from linkwright.kernels.recorded_code import RecordedCode
from linkwright.kernels.straight_line import newton_step, written_out


@dataclass
class Solve:
    """A Newton stage: its unknowns stand in the rows ``unknown`` of w, and begin with the rows ``starts`` of x. A round
    is ``closure``, then ``step``, which returns how far it went (see :mod:`linkwright.graph.program` for when to stop).
    """

    unknown: list[int]
    starts: list[int]
    closure: list[RecordedCode]
    step: RecordedCode


@dataclass
class PoseFunctions:
    """The functions of a program, of at most ``longest`` instructions each: those run ``once``, those of ``each`` pose;
    ``library``: the elementary functions that they call, by name. ``rows`` of w and ``scalars`` of c are needed."""

    program: Program
    longest: int
    once: list[RecordedCode] = field(default_factory=list)
    each: list[RecordedCode | Solve] = field(default_factory=list)
    library: dict[str, RecordedCode] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self._rows, self._scalars = Rows(), Rows()
        solved = frozenset(row for stage in self.program.solves for row in stage.rows)
        for row in sorted(solved):
            self._rows["x", row]
        self._solved = solved
        for k, stage in enumerate(self.program.solves):
            self.each.append(self._solve(k, stage))
        self.each += self._block("block", Listing(self.program.block, solved), "")

    @property
    def rows(self) -> int:
        return self._rows.count

    @property
    def scalars(self) -> int:
        return self._scalars.count

    def _solve(self, k: int, stage: NewtonStage) -> Solve:
        n, out = len(stage.rows), f"y{k}"
        misses = self._rows.run((out, i) for i in range(n + n * n))
        closure = self._block(f"closure{k}", Listing(stage.closure, self._solved), out)
        step, unknown = RecordedCode(), [self._rows["x", row] for row in stage.rows]
        u = [step.entry("w", row, held=True) for row in unknown]
        y = [step.entry("w", misses + i) for i in range(n + n * n)]
        new, step.result = newton_step(step, stage, u, y[:n], [y[n + r * n : n + (r + 1) * n] for r in range(n)])
        for row, value in zip(unknown, new, strict=True):
            step.store(value, "w", row)
        return Solve(unknown, list(stage.rows), closure, step)

    def _block(self, tag: str, listing: Listing, out: str) -> list[RecordedCode]:
        """The functions of a block whose outputs go to the rows ``out`` of w, or if that is empty to o; those of
        parameters alone are added to ``once``."""
        division = Division(listing, FORMS["apart"], self.longest)
        self.once += [self._chunk(tag, division, SCALAR, n, out) for n in range(len(division.chunks[SCALAR]))]
        return [self._chunk(tag, division, OWN, n, out) for n in range(len(division.chunks[OWN]))]

    def _chunk(self, tag: str, division: Division, place: str, n: int, out: str) -> RecordedCode:
        code, values, at = RecordedCode(), division.listing.values, (place, n)
        outputs = division.outputs(at)
        holds: dict[int, str] = {}

        def known(i: int) -> str:
            """A value as an operand: a number, what was computed here, or what another function stored."""
            value = values[i]
            if value.constant:
                return code.number(value.number)
            if i not in holds:
                key = "v", tag, i
                if division.places[i] == SCALAR:
                    holds[i] = code.entry("c", self._scalars[key])
                elif value.source is None:
                    holds[i] = code.entry("w", self._rows[key])
                elif (row := value.source[1]) in self._solved:
                    holds[i] = code.entry("w", self._rows["x", row])
                else:
                    holds[i] = code.entry("x", row)
            return holds[i]

        def write(i: int) -> None:
            for k in outputs.pop(i, []):
                code.store(known(i), "w" if out else "o", self._rows[out, k] if out else k)

        for i in division.chunks[place][n]:
            source = values[i].source
            holds[i] = code.entry("p", source[1]) if source else division.computed(code, values[i], known)
            if division.passed_on(i, at):
                rows = self._scalars if place == SCALAR else self._rows
                code.store(holds[i], "c" if place == SCALAR else "w", rows["v", tag, i])
            write(i)
        for i in list(outputs):
            write(i)
        for i in division.last_used(at):
            if place == division.places[i] == OWN and ("v", tag, i) in self._rows.places:
                self._rows.release(("v", tag, i))
        self._called(code)
        return code

    def _called(self, code: RecordedCode) -> None:
        """Add the elementary functions that a function calls to the library."""
        for name, operands in code.calls.items():
            if name not in self.library:
                self.library[name] = _elementary(name, operands)


@cache
def _elementary(name: str, operands: int) -> RecordedCode:
    """An elementary function, which is the same wherever it is called."""
    function = RecordedCode()
    function.result = written_out(function, name, [function.argument(k) for k in range(operands)])
    return function
