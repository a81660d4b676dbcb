"""The text of a compiled kernel: a program in LLVM's intermediate language.

A function runs over a block of some :data:`LANES` poses, one vector of lanes after another. What passes from one
function to the next (inputs, values, outputs) lies in rows of one array ``w``, at places known when the text is
written; what is the same for all poses of a sample is computed once a sample, into ``c``. A program's number of lanes
never varies.

No pass of LLVM's optimiser is needed: what is written once is used again, a row is loaded where it is first used and
stored where it is known; instructions and registers are all that is left to choose.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from linkwright.graph.program import ACCEPTED, MOST_STEPS, SOLVED, NewtonStage, Program
from linkwright.kernels.division import FORMS, ORDER, OWN, SCALAR, SHARED, Division, Rows
from linkwright.kernels.listing import Listing, P, Value, X
from linkwright.kernels.llvm_code import LlvmCode
from linkwright.kernels.machine_code import Machine
from linkwright.kernels.straight_line import newton_step

LANES = (64, 32)
CACHED = 6000
"""Numbers for which a core's first cache has room: the more rows a program has, the fewer lanes a block gets."""
LONGEST = 400
"""The most instructions of one function: the compiler's time grows faster than its length."""


class KernelSource:
    """The text of a program in one of the :data:`FORMS`, with what its caller has to know: how many ``rows`` and
    ``scalars`` it needs room for, and how many ``lanes`` a row has."""

    def __init__(self, program: Program, form: str, machine: Machine, lanes: int = LANES[0]) -> None:
        self.program, self.form, self.machine, self.lanes = program, FORMS[form], machine, lanes
        solved = frozenset(row for stage in program.solves for row in stage.rows)
        main = Listing(program.block, solved)
        listings = [Listing(stage.closure, solved) for stage in program.solves]
        self.rows, self.scalars = Rows(), Rows()
        self.text: list[str] = []
        inputs, parameters = program.used
        # What samples share first, so that it can be loaded apart from the starts of Newton.
        split = sorted(inputs - solved) if self.form[X] == SHARED else sorted(inputs)
        self.x_rows, self.start_rows = split, sorted(inputs - set(split))
        self.p_rows = sorted(parameters) if self.form[P] == OWN else []
        self.rows.run(("x", row) for row in [*self.x_rows, *self.start_rows])
        self.rows.run(("p", row) for row in self.p_rows)
        self.out = self.rows.run(("out", k) for k in range(len(main.outputs)))
        steps: dict[str, list[str]] = {SCALAR: [], SHARED: [], OWN: []}
        for k, (stage, listing) in enumerate(zip(program.solves, listings, strict=True)):
            misses = self.rows.run((f"y{k}", i) for i in range(len(listing.outputs)))
            made = _Block(self, f"closure{k}_", listing, f"y{k}").write()
            steps[SCALAR] += made[SCALAR]
            steps[SHARED] += made[SHARED]
            steps[OWN].append(self._newton(k, stage, made[OWN], misses))
        made = _Block(self, "block_", main, "out").write()
        for place, names in made.items():
            steps[place] += names
        self.steps = steps

    @classmethod
    def fitting(cls, program: Program, form: str, machine: Machine) -> KernelSource:
        """The text with as many lanes as a core's first cache has room for. A short program takes two vectors at once:
        one's operations are done while the other's wait for theirs; in a long one other operations are at hand."""
        if program.size <= LONGEST:
            machine = replace(machine, width=2 * machine.width)
        for lanes in LANES:
            source = cls(program, form, machine, lanes)
            if source.rows.count * lanes <= CACHED:
                break
        return source

    @property
    def vectors(self) -> int:
        """The vectors of a row."""
        return self.lanes // self.machine.width

    def loop(self, code: LlvmCode) -> str:
        """Lines that run over the vectors of a block; in them ``%wi`` points to the vector of the first row."""
        head = [
            f"%wv = bitcast {code.pd} %w to {code.pt}",
            "br label %loop",
            "loop:",
            "%i = phi i64 [0, %entry], [%next, %loop]",
            f"%wi = getelementptr {code.t}, {code.pt} %wv, i64 %i",
        ]
        tail = [
            "%next = add i64 %i, 1",
            f"%more = icmp ult i64 %next, {self.vectors}",
            "br i1 %more, label %loop, label %done",
            "done:",
        ]
        return "\n".join([*head, *code.lines, *tail])

    def function(self, name: str, body: str) -> None:
        """Write a function over a block, whose first label is ``entry``."""
        pd = self.machine.code().pd
        self.text.append(
            f"define internal void @{name}({pd} noalias %w, {pd} noalias readonly %c) {{\nentry:\n{body}\nret void\n}}"
        )

    def _newton(self, k: int, stage: NewtonStage, closure: Sequence[str], misses: int) -> str:
        """Write the functions that solve a stage in its rows; the name of the one that calls the others."""
        state = self.rows.run([(f"newton{k}", 0), (f"newton{k}", 1)])
        solved, moved = state, state + 1
        rows = [self.rows["x", row] for row in stage.rows]
        n, at = len(rows), self.vectors
        begin = self.machine.code()
        begin.store(begin.number(0.0), "%wi", solved * at)
        begin.store(begin.number(float("inf")), "%wi", moved * at)
        self.function(f"newton{k}_begin", self.loop(begin))
        step = self.machine.code()
        u = [step.load("%wi", row * at) for row in rows]
        y = [step.load("%wi", (misses + i) * at) for i in range(n + n * n)]
        new, far = newton_step(step, stage, u, y[:n], [y[n + r * n : n + (r + 1) * n] for r in range(n)])
        open_ = step.do("equal", step.load("%wi", solved * at), step.number(0.0))
        for row, was, now in zip(rows, u, new, strict=True):
            step.store(step.do("select", open_, now, was), "%wi", row * at)
        far = step.do("select", open_, far, step.load("%wi", moved * at))
        step.store(far, "%wi", moved * at)
        # NaN is as good as solved: it stays.
        left = step.do("greater_equal", far, step.number(SOLVED))
        flag = step.do("select", left, step.number(0.0), step.number(1.0))
        step.store(flag, "%wi", solved * at)
        self.function(f"newton{k}_step", self.loop(step))
        end = self.machine.code()
        good = end.do("less", end.load("%wi", moved * at), end.number(ACCEPTED))
        for row in rows:
            end.store(end.do("select", good, end.load("%wi", row * at), end.number(float("nan"))), "%wi", row * at)
        self.function(f"newton{k}_end", self.loop(end))
        self.function(f"newton{k}", _SOLVE.format(
            k=k, pd=step.pd, calls="\n".join(f"call void @{name}({step.pd} %w, {step.pd} %c)" for name in closure),
            steps=MOST_STEPS, flags=solved * self.lanes, lanes=self.lanes,
        ))  # fmt: skip
        return f"newton{k}"


class _Block:
    """The functions of one block of expressions, whose outputs go to the rows ``out``."""

    def __init__(self, source: KernelSource, tag: str, listing: Listing, out: str) -> None:
        self.source, self.tag, self.listing, self.out = source, tag, listing, out
        self.division = Division(listing, source.form, LONGEST)

    def write(self) -> dict[str, list[str]]:
        """Write them; their names by place."""
        made: dict[str, list[str]] = {}
        for place in ORDER:
            made[place] = []
            for n, chunk in enumerate(self.division.chunks[place]):
                name = f"{self.tag}{place}{n}"
                made[place].append(name)
                if place == SCALAR:
                    self._once_a_sample(name, n, chunk)
                else:
                    self._over_poses(name, place, n, chunk)
                for i in self.division.last_used((place, n)):
                    key = ("v", self.tag, i)
                    if place == OWN and self.division.places[i] == OWN and key in self.source.rows.places:
                        self.source.rows.release(key)
        return made

    def _once_a_sample(self, name: str, n: int, chunk: list[int]) -> None:
        """Write a function of what is the same for all poses of a sample: from its column of ``p`` to ``c``."""
        code, scalars = self.source.machine.code(1), self.source.scalars
        holds: dict[int, str] = {}

        def known(i: int) -> str:
            return self._known(code, i, holds)

        for i in chunk:
            value = self.listing.values[i]
            if value.source is not None:
                at = code.name(f"mul i64 %pr, {value.source[1]}")
                at = code.name(f"getelementptr double, {code.pd} %p, i64 {at}")
                holds[i] = code.name(f"load double, {code.pd} {at}, align 8")
            else:
                holds[i] = self.division.computed(code, value, known)
            if self.division.passed_on(i, (SCALAR, n)):
                code.store(holds[i], "%c", scalars["v", self.tag, i])
        self.source.text.append(
            f"define internal void @{name}({code.pd} noalias readonly %p, i64 %pr, {code.pd} noalias %c) {{\n"
            + "\n".join([*code.lines, "ret void", "}"])
        )

    def _over_poses(self, name: str, place: str, n: int, chunk: list[int]) -> None:
        """Write a function over a block of poses."""
        code, at, rows = self.source.machine.code(), self.source.vectors, self.source.rows
        holds: dict[int, str] = {}
        outputs = self.division.outputs((place, n))

        def known(i: int) -> str:
            return self._known(code, i, holds)

        def store(i: int) -> None:
            for k in outputs.pop(i, []):
                code.store(known(i), "%wi", rows[self.out, k] * at)

        for i in chunk:
            holds[i] = self.division.computed(code, self.listing.values[i], known)
            if self.division.passed_on(i, (place, n)):
                code.store(holds[i], "%wi", rows["v", self.tag, i] * at)
            store(i)
        for i in list(outputs):
            store(i)
        self.source.function(name, self.source.loop(code))

    def _known(self, code: LlvmCode, i: int, holds: dict[int, str]) -> str:
        """A value as an operand: a number, what was computed here, or what was stored by another function."""
        value = self.listing.values[i]
        if value.constant:
            return code.number(value.number)
        if i not in holds:
            if self.division.places[i] == SCALAR:
                holds[i] = code.spread("%c", self.source.scalars["v", self.tag, i])
            else:
                holds[i] = code.load("%wi", self._row(i, value) * self.source.vectors)
        return holds[i]

    def _row(self, i: int, value: Value) -> int:
        if value.source is not None:
            which, row = value.source
            return self.source.rows["p" if which else "x", row]
        return self.source.rows["v", self.tag, i]


_SOLVE = """call void @newton{k}_begin({pd} %w, {pd} %c)
br label %step
step:
%n = phi i64 [0, %entry], [%n1, %again]
{calls}
call void @newton{k}_step({pd} %w, {pd} %c)
%n1 = add i64 %n, 1
%some = icmp ult i64 %n1, {steps}
br label %look
look:
%i = phi i64 [0, %step], [%i1, %further]
%place = add i64 %i, {flags}
%at = getelementptr double, {pd} %w, i64 %place
%flag = load double, {pd} %at, align 8
%open = fcmp oeq double %flag, 0.0
br i1 %open, label %again, label %further
further:
%i1 = add i64 %i, 1
%left = icmp ult i64 %i1, {lanes}
br i1 %left, label %look, label %end
again:
br i1 %some, label %step, label %end
end:
call void @newton{k}_end({pd} %w, {pd} %c)"""
