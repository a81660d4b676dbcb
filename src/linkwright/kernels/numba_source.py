"""The text of a compiled kernel: a program as Python functions that Numba turns into machine code.

A function runs over a block of some :data:`LANES` poses, whose rows (inputs, values that pass from one function to the
next, outputs) lie in one array ``w`` at places known when it is compiled; so the compiler sees that no two overlap, and
the loop over lanes becomes vector instructions. A program's number of lanes never varies, so every pose goes through
the same instructions, wherever it stands. What is the same for all poses of a sample is computed once a sample, into
``c``; in the ``over`` form what is the same for all samples once a pose.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field

from linkwright.graph.program import ACCEPTED, MOST_STEPS, SOLVED, NewtonStage, Program
from linkwright.kernels.elementary import source as functions_text
from linkwright.kernels.listing import Listing, P, Value, X, number_text
from linkwright.kernels.operations import operation

LANES = (128, 64, 32)
CACHED = 6000
"""Numbers for which a core's first cache has room: the more rows a program has, the fewer lanes a block gets."""
LONGEST = 400
"""The most instructions of one function: the compiler's time grows with the square of its length."""

SCALAR, SHARED, OWN = "scalar", "shared", "own"
FORMS = {
    "apart": {0: SCALAR, X: OWN, P: SCALAR, X | P: OWN},
    "each": {0: SCALAR, X: OWN, P: OWN, X | P: OWN},
    "over": {0: SCALAR, X: SHARED, P: SCALAR, X | P: OWN},
}
"""Where a value is computed, by what it depends on: once a sample; for each pose, once for all samples; for both.

apart: inputs of each sample and pose, parameters of each sample; each: both of each pose; over: inputs of each pose,
parameters of each sample."""

OPERATORS: dict[str, str] = {
    "add": "{0} + {1}", "subtract": "{0} - {1}", "multiply": "{0} * {1}", "divide": "{0} / {1}",
    "negative": "-{0}", "square": "{0} * {0}", "twice": "2.0 * {0}", "reciprocal": "1.0 / {0}", "positive": "{0}",
    "sqrt": "math.sqrt({0})", "fabs": "math.fabs({0})", "floor": "np.floor({0})", "power": "{0} ** {1}",
    "less": "pick({0} < {1}, 1.0, 0.0)", "less_equal": "pick({0} <= {1}, 1.0, 0.0)",
    "equal": "pick({0} == {1}, 1.0, 0.0)", "not_equal": "pick({0} != {1}, 1.0, 0.0)",
    "logical_not": "pick({0} == 0.0, 1.0, 0.0)", "logical_and": "pick(({0} != 0.0) & ({1} != 0.0), 1.0, 0.0)",
    "logical_or": "pick(({0} != 0.0) | ({1} != 0.0), 1.0, 0.0)", "if_else_zero": "pick({0} != 0.0, {1}, 0.0)",
}  # fmt: skip
"""Operations as text of their operands, by name."""
CALLS: dict[str, str] = {
    "sin": "sin", "cos": "cos", "tan": "tan", "arcsin": "asin", "arccos": "acos", "arctan": "atan", "arctan2": "atan2",
    "exp": "exp", "log": "log", "sign": "sign", "copysign": "copysign", "fmin": "fmin", "fmax": "fmax",
    "hypot": "hypot",
}  # fmt: skip
"""Those that are calls of :mod:`linkwright.kernels.elementary`, by name."""
Key = tuple[str, int] | tuple[str, str, int]


@dataclass
class _Rows:
    """Numbered places of rows or scalars; those given back are used again."""

    places: dict[Key, int] = field(default_factory=dict)
    free: list[int] = field(default_factory=list)
    count: int = 0

    def __getitem__(self, key: Key) -> int:
        if key not in self.places:
            if not self.free:
                self.free.append(self.count)
                self.count += 1
            self.places[key] = self.free.pop()
        return self.places[key]

    def run(self, keys: Iterable[Key]) -> int:
        """New places for some keys, side by side; the first of them."""
        first = self.count
        for key in keys:
            self.places[key], self.count = self.count, self.count + 1
        return first

    def release(self, key: Key) -> None:
        self.free.append(self.places.pop(key))


class KernelSource:
    """The generated text of a program in one of the :data:`FORMS`, with what its caller has to know."""

    def __init__(self, program: Program, form: str, lanes: int = LANES[0]) -> None:
        self.program, self.form, self.lanes = program, FORMS[form], lanes
        solved = frozenset(row for stage in program.solves for row in stage.rows)
        main = Listing(program.block, solved)
        listings = [Listing(stage.closure, solved) for stage in program.solves]
        self.rows, self.scalars, self.calls = _Rows(), _Rows(), set[str]()
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
        self.text.append(self._entry(steps))

    @classmethod
    def fitting(cls, program: Program, form: str) -> KernelSource:
        """The text with as many lanes as a core's first cache has room for."""
        for lanes in LANES:
            source = cls(program, form, lanes)
            if source.rows.count * lanes <= CACHED:
                break
        return source

    def __str__(self) -> str:
        head = _HEAD.format(lanes=self.lanes, width=max(self.rows.count, 1), scalars=max(self.scalars.count, 1))
        return (
            "\n\n".join([head, functions_text(sorted(self.calls), "@njit(forceinline=True, **FLAGS)"), *self.text])
            + "\n"
        )

    def _newton(self, k: int, stage: NewtonStage, closure: Sequence[str], misses: int) -> str:
        """Write the function that solves a stage in its rows; its name."""
        state = self.rows.run([(f"newton{k}", 0), (f"newton{k}", 1)])
        rows = [self.rows["x", row] * self.lanes for row in stage.rows]
        self.text.append(
            _NEWTON.format(
                name=f"newton{k}",
                closed=state * self.lanes,
                moved=(state + 1) * self.lanes,
                closure="\n        ".join(f"{name}(w, c)" for name in closure) or "pass",
                step="\n            ".join(_step(stage, rows, misses, state, self.lanes)),
                lost="\n        ".join(f"w[{row} + i] = pick(solved, w[{row} + i], nan)" for row in rows),
                steps=MOST_STEPS,
                solved=SOLVED,
                accepted=ACCEPTED,
            )
        )
        return f"newton{k}"

    def _entry(self, steps: dict[str, list[str]]) -> str:
        def calls(names: Sequence[str], arguments: str, indent: int) -> str:
            return ("\n" + " " * indent).join(f"{name}({arguments})" for name in names) or "pass"

        def load(first: int, array: str, rows: Sequence[int], stride: str, place: str) -> str:
            return f"load(w, {first}, {array}, {_tuple(rows)}, {stride}, {place}, m)" if rows else "pass"

        shared = self.form[X] == SHARED
        starts = len(self.x_rows)
        return (_OVER if shared else _APART).format(
            scalars=calls(steps[SCALAR], "p, pr, s, c[s]", 8),
            shared=calls(steps[SHARED], "w, c[0]", 8),
            own=calls(steps[OWN], "w, c[s]", 12),
            load_x=load(0, "x", self.x_rows, "xr", "b" if shared else "s * xs + b"),
            load_start=load(starts, "x", self.start_rows, "xr", "b"),
            load_p=load(starts, "p", self.p_rows, "pr", "b"),
            out=self.out,
            rows=len(self.program.outputs),
        )


class _Block:
    """The functions of one block of expressions, whose outputs go to the rows ``out``."""

    def __init__(self, source: KernelSource, tag: str, listing: Listing, out: str) -> None:
        self.source, self.tag, self.listing, self.out = source, tag, listing, out
        self.places = [source.form[needs] for needs in listing.needs]
        self.chunks: dict[str, list[list[int]]] = {SCALAR: [], SHARED: [], OWN: []}
        self.chunk_of: dict[int, tuple[str, int]] = {}
        for i, value in enumerate(listing.values):
            if value.source is None if self.places[i] != SCALAR else not value.constant:
                chunks = self.chunks[self.places[i]]
                if not chunks or len(chunks[-1]) >= LONGEST:
                    chunks.append([])
                chunks[-1].append(i)
                self.chunk_of[i] = self.places[i], len(chunks) - 1
        # Outputs that are inputs, constants or scalars are written in a chunk of their place.
        self.writes: dict[tuple[str, int], list[tuple[int, int]]] = {}
        for k, i in enumerate(listing.outputs):
            place = OWN if self.places[i] == SCALAR else self.places[i]
            if not self.chunks[place]:
                self.chunks[place].append([])
            at = self.chunk_of.get(i, (place, 0))
            self.writes.setdefault(at if at[0] == place else (place, 0), []).append((k, i))
        order = {SCALAR: 0, SHARED: 1, OWN: 2}
        self.last: dict[int, tuple[int, int]] = {}
        self.users: dict[int, set[tuple[str, int]]] = {}
        for i, at in self.chunk_of.items():
            for arg in _operands(listing.values[i]):
                self.users.setdefault(arg, set()).add(at)
        for at, written in self.writes.items():
            for _, i in written:
                self.users.setdefault(i, set()).add(at)
        for i, users in self.users.items():
            self.last[i] = max((order[place], n) for place, n in users)

    def write(self) -> dict[str, list[str]]:
        """Write them; their names by place."""
        made: dict[str, list[str]] = {}
        for rank, place in enumerate((SCALAR, SHARED, OWN)):
            made[place] = []
            for n, chunk in enumerate(self.chunks[place]):
                name = f"{self.tag}{place}{n}"
                made[place].append(name)
                self.source.text.append(self._function(name, place, n, chunk))
                for i, last in self.last.items():
                    key = ("v", self.tag, i)
                    if place == OWN and last == (rank, n) and self.places[i] == OWN and key in self.source.rows.places:
                        self.source.rows.release(key)
        return made

    def _function(self, name: str, place: str, n: int, chunk: list[int]) -> str:
        lanes = self.source.lanes
        reads: dict[int, str] = {}
        heads: dict[int, str] = {}

        def operand(i: int) -> str:
            value = self.listing.values[i]
            if value.constant:
                return number_text(value.number)
            if self.chunk_of.get(i) != (place, n):
                if place == SCALAR or self.places[i] == SCALAR:
                    heads[i] = f"c[{self.source.scalars['v', self.tag, i]}]"
                else:
                    reads[i] = f"w[{self._row(i, value) * lanes} + i]"
            return f"v{i}"

        body, ends = [], []
        for i in chunk:
            body.append(f"v{i} = {self._expression(self.listing.values[i], operand)}")
            if self.users.get(i, set()) - {(place, n)}:
                if place == SCALAR:
                    ends.append(f"c[{self.source.scalars['v', self.tag, i]}] = v{i}")
                else:
                    ends.append(f"w[{self.source.rows['v', self.tag, i] * lanes} + i] = v{i}")
        for k, i in self.writes.get((place, n), []):
            ends.append(f"w[{self.source.rows[self.out, k] * lanes} + i] = {operand(i)}")
        first = [f"v{i} = {text}" for i, text in heads.items()]
        lines = [*(f"v{i} = {text}" for i, text in reads.items()), *body, *ends]
        if place == SCALAR:
            return f"@njit(**FLAGS)\ndef {name}(p, pr, s, c):\n    " + "\n    ".join([*first, *lines] or ["pass"])
        return f"@njit(**FLAGS)\ndef {name}(w, c):\n    " + "\n    ".join(
            [*first, "for i in range(LANES):", *(f"    {line}" for line in lines)]
        )

    def _row(self, i: int, value: Value) -> int:
        if value.source is not None:
            which, row = value.source
            return self.source.rows["p" if which else "x", row]
        return self.source.rows["v", self.tag, i]

    def _expression(self, value: Value, operand: Callable[[int], str]) -> str:
        if value.source is not None:  # a parameter of the sample
            return f"p[{value.source[1]} * pr + s]"
        name, args = operation(value.op).name, [operand(i) for i in _operands(value)]
        if name == "power" and (power := _integer_power(self.listing.values[value.args[1]])) is not None:
            args[1] = power  # a whole power is multiplied out
        if name in OPERATORS:
            return OPERATORS[name].format(*args)
        self.source.calls.add(CALLS[name])
        return f"{CALLS[name]}({', '.join(args)})"


def _integer_power(value: Value) -> str | None:
    """A whole power of few factors as text."""
    known = value.constant and value.number.is_integer() and 0 < value.number <= 32
    return str(int(value.number)) if known else None


def _operands(value: Value) -> tuple[int, ...]:
    """The values that an operation takes; constants and inputs take none."""
    return value.args[: operation(value.op).operands] if value.args else ()


def _step(stage: NewtonStage, rows: Sequence[int], misses: int, closed: int, lanes: int) -> list[str]:
    """The lines of one of Newton's steps at a pose: elimination with the largest pivots, without a branch, so that
    it runs over all lanes at once. ``rows``, ``misses`` and ``closed`` say where in w the coordinates, the closures'
    figures and what is solved lie."""
    n = len(rows)
    lines = []
    for r in range(n):
        lines.append(f"a{r}_{n} = w[{(misses + r) * lanes} + i]")
        lines += [f"a{r}_{q} = w[{(misses + n + r * n + q) * lanes} + i]" for q in range(n)]
    for k in range(n):
        for r in range(k + 1, n):
            lines.append(f"less = math.fabs(a{k}_{k}) < math.fabs(a{r}_{k})")
            for q in range(k, n + 1):
                lines.append(f"high = pick(less, a{r}_{q}, a{k}_{q})")
                lines.append(f"a{r}_{q} = pick(less, a{k}_{q}, a{r}_{q})")
                lines.append(f"a{k}_{q} = high")
        for r in range(k + 1, n):
            lines.append(f"f = a{r}_{k} / a{k}_{k}")
            lines += [f"a{r}_{q} = a{r}_{q} - f * a{k}_{q}" for q in range(k + 1, n + 1)]
    for k in reversed(range(n)):
        known = "".join(f" - a{k}_{q} * s{q}" for q in range(k + 1, n))
        lines.append(f"s{k} = (a{k}_{n}{known}) / a{k}_{k}")
    lines += [f"u{k} = w[{row} + i]" for k, row in enumerate(rows)]
    lines.append(f"open = w[{closed * lanes} + i] == 0.0")
    lines.append("moved = 0.0")
    for k, (row, scale, slides) in enumerate(zip(rows, stage.scale, stage.sliding, strict=True)):
        lines.append(f"n{k} = u{k} - s{k}")
        size = f"pick(math.fabs(n{k}) < {scale}, {scale}, math.fabs(n{k}))" if slides else f"{scale}"
        lines.append(f"share = math.fabs(s{k}) / {size}")
        lines.append("moved = pick((share != share) | (share > moved), share, moved)")
        lines.append(f"w[{row} + i] = pick(open, n{k}, u{k})")
    return lines


def _tuple(values: Sequence[float | int]) -> str:
    return "(" + ", ".join(map(repr, values)) + ("," if len(values) == 1 else "") + ")"


_HEAD = '''"""Written by linkwright; see linkwright.kernels.numba_source."""
import math
import numpy as np
from numba import njit
from linkwright.kernels.nontemporal_stores import WIDTH, fence, pick, stream

CACHE = "CACHE" not in globals()
LANES, ROWS, SCALARS = {lanes}, {width}, {scalars}
FLAGS = dict(nogil=True, error_model="numpy", fastmath={{"contract", "arcp", "nsz"}})
inf, nan = math.inf, math.nan


@njit(**FLAGS)
def load(w, first, x, rows, stride, place, m):
    for k in range(len(rows)):
        start = rows[k] * stride + place
        row = x[start : start + m]
        to = w[(first + k) * LANES : (first + k + 1) * LANES]
        for i in range(m):
            to[i] = row[i]
        for i in range(m, LANES):
            to[i] = row[0]


@njit(**FLAGS)
def store(w, first, rows, out, stride, place, m, past):
    for k in range(rows):
        start = k * stride + place
        to = out[start : start + m]
        row = w[(first + k) * LANES : (first + k + 1) * LANES]
        if past and m == LANES:
            for i in range(0, LANES, WIDTH):
                stream(to, i, row, i)
        else:
            for i in range(m):
                to[i] = row[i]'''

_NEWTON = """@njit(**FLAGS)
def {name}(w, c):
    for i in range(LANES):
        w[{closed} + i] = 0.0
        w[{moved} + i] = inf
    for _ in range({steps}):
        {closure}
        for i in range(LANES):
            {step}
            w[{moved} + i] = pick(open, moved, w[{moved} + i])
            w[{closed} + i] = pick(open & (moved >= {solved}), 0.0, 1.0)
        left = False
        for i in range(LANES):
            left |= w[{closed} + i] == 0.0
        if not left:
            break
    for i in range(LANES):
        solved = w[{moved} + i] < {accepted}
        {lost}"""

_SIGNATURE = (
    "void(float64[::1], int64, int64, float64[::1], int64, float64[::1], int64, int64, int64, int64, int64, boolean)"
)
_APART = f'''@njit("{_SIGNATURE}", cache=CACHE, **FLAGS)
def run(x, xr, xs, p, pr, out, orow, os, samples, poses, lead, past):
    w = np.zeros(ROWS * LANES)
    c = np.zeros((samples, SCALARS))
    for s in range(samples):
        {{scalars}}
        b = 0
        while b < poses:
            m = min(LANES, poses - b) if b or not lead else lead
            {{load_x}}
            {{load_p}}
            {{own}}
            store(w, {{out}}, {{rows}}, out, orow, s * os + b, m, past)
            b += m
    fence()'''
_OVER = f'''@njit("{_SIGNATURE}", cache=CACHE, **FLAGS)
def run(x, xr, xs, p, pr, out, orow, os, samples, poses, lead, past):
    w = np.zeros(ROWS * LANES)
    c = np.zeros((samples, SCALARS))
    for s in range(samples):
        {{scalars}}
    for b in range(0, poses, LANES):
        m = min(LANES, poses - b)
        {{load_x}}
        {{shared}}
        for s in range(samples):
            {{load_start}}
            {{own}}
            store(w, {{out}}, {{rows}}, out, orow, s * os + b, m, past)
    fence()'''
