"""A program as a WebAssembly module, written byte by byte: the same functions as in JavaScript, to the same bits.

The module imports nothing. It exports its ``memory``; the address ``free`` of the first byte there that it leaves to
its caller; ``parameters(p)``, which computes what depends on the parameters alone; ``pose(x, out)``; and
``poses(count, x, out)`` for poses one after the other, all inputs of a pose side by side. Arguments are addresses of
64-bit numbers in SI. A caller that needs more memory has it grow.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field

from linkwright.data_classes import dataclass
from linkwright.graph.program import ACCEPTED, MOST_STEPS, SOLVED, Program
from linkwright.kernels.pose_functions import PoseFunctions, Solve
from linkwright.kernels.recorded_code import ARGUMENT, RecordedCode
from linkwright.kernels.webassembly_code import (
    CALL,
    END,
    F64,
    GET,
    I32,
    LOAD,
    SET,
    STORE,
    WHOLE,
    WORDS,
    FunctionBody,
    body,
    double,
    number,
    signed,
    unsigned,
    vector,
)

LONGEST = 2000
"""The most instructions of one function."""
PAGE = 1 << 16
"""Bytes of a page of memory."""
BLOCK, LOOP, IF, BREAK, BREAK_IF, ADD, SUBTRACT, LESS, NOT, EMPTY = (
    0x02, 0x03, 0x04, 0x0C, 0x0D, 0x6A, 0x6B, 0x48, 0x45, 0x40,
)  # fmt: skip
"""Instructions of control, and of whole numbers."""
Signature = tuple[tuple[int, ...], tuple[int, ...]]


def webassembly(program: Program) -> bytes:
    """The module of a program."""
    made = PoseFunctions(program, LONGEST)
    functions = _Functions(8 * made.scalars)
    for name, code in made.library.items():
        operands = sum(node.word == ARGUMENT for node in code.nodes)
        functions.called[name] = functions.recorded(code, (F64,) * operands, (F64,))
    once = [functions.recorded(code, (I32,), (), {"p": (0, 0)}) for code in made.once]
    each = [
        functions.solve(step) if isinstance(step, Solve) else functions.over(step, (I32, I32)) for step in made.each
    ]
    exported = {
        "parameters": functions.sequence(once, (I32,)),
        "pose": functions.sequence(each, (I32, I32)),
    }
    exported["poses"] = functions.poses(exported["pose"], len(program.inputs), len(program.outputs))
    free = 8 * (made.scalars + made.rows)
    needed = free + 8 * (len(program.parameters) + len(program.inputs) + len(program.outputs))
    return functions.module(exported, free, -(-needed // PAGE) or 1)


@dataclass
class _Functions:
    """The functions of a module by number: their signatures and bodies. The arrays c and w lie at the start of memory;
    w at the byte ``w``."""

    w: int
    signatures: list[Signature] = field(default_factory=list)
    bodies: list[bytes] = field(default_factory=list)
    called: dict[str, int] = field(default_factory=dict)

    def add(self, made: bytes, takes: tuple[int, ...], gives: tuple[int, ...] = ()) -> int:
        self.signatures.append((takes, gives))
        self.bodies.append(made)
        return len(self.bodies) - 1

    def recorded(
        self,
        code: RecordedCode,
        takes: tuple[int, ...],
        gives: tuple[int, ...] = (),
        bases: Mapping[str, tuple[int | None, int]] = {},
    ) -> int:
        """Add a recorded function."""
        arrays = {"c": (None, 0), "w": (None, self.w), **bases}
        return self.add(FunctionBody(code, len(takes), arrays, self.called).body, takes, gives)

    def over(self, code: RecordedCode, takes: tuple[int, ...]) -> int:
        """Add a function of a pose: of the address of its inputs, and for some of that of its outputs."""
        return self.recorded(code, takes, (), {"x": (0, 0), "o": (1, 0)})

    def sequence(self, functions: Sequence[int], takes: tuple[int, ...]) -> int:
        """Add a function that calls others with its own arguments, as many as each takes."""
        return self.add(body([], b"".join(map(self._call, functions))), takes)

    def _call(self, function: int) -> bytes:
        arguments = range(len(self.signatures[function][0]))
        return b"".join(bytes([GET]) + unsigned(k) for k in arguments) + bytes([CALL]) + unsigned(function)

    def solve(self, solve: Solve) -> int:
        """Add a Newton stage. Locals: 0 the address of x, 1 how far the last step went, 2 the rounds that are left."""
        calls = b"".join(self._call(self.over(code, (I32,))) for code in solve.closure)
        step = self.recorded(solve.step, (), (F64,))
        made = bytearray()
        for row, start in zip(solve.unknown, solve.starts, strict=True):
            made += self._zero() + bytes([GET, 0]) + double(LOAD, 8 * start) + double(STORE, self.w + 8 * row)
        made += bytes([WHOLE]) + signed(MOST_STEPS) + bytes([SET, 2])
        # NaN is as good as solved: it stays.
        made += bytes([BLOCK, EMPTY, LOOP, EMPTY]) + calls + bytes([CALL]) + unsigned(step) + bytes([SET, 1, GET, 1])
        made += number(SOLVED) + bytes([WORDS["greater_equal"], NOT, BREAK_IF, 1])
        made += bytes([GET, 2, WHOLE, 1, SUBTRACT, SET, 2, GET, 2, BREAK_IF, 0, END, END])
        made += bytes([GET, 1]) + number(ACCEPTED) + bytes([WORDS["less"], NOT, IF, EMPTY])
        for row in solve.unknown:
            made += self._zero() + number(float("nan")) + double(STORE, self.w + 8 * row)
        made.append(END)
        return self.add(body([(1, F64), (1, I32)], bytes(made)), (I32,))

    def _zero(self) -> bytes:
        return bytes([WHOLE, 0])

    def poses(self, pose: int, inputs: int, outputs: int) -> int:
        """Add the loop over poses: their count, addresses of inputs and outputs."""
        made = bytearray([BLOCK, EMPTY, LOOP, EMPTY, WHOLE, 0, GET, 0, LESS, NOT, BREAK_IF, 1, GET, 1, GET, 2, CALL])
        made += unsigned(pose)
        for local, step in ((0, -1), (1, 8 * inputs), (2, 8 * outputs)):
            made += bytes([GET, local, WHOLE]) + signed(step) + bytes([ADD, SET, local])
        made += bytes([BREAK, 0, END, END])
        return self.add(body([], bytes(made)), (I32, I32, I32))

    def module(self, exported: Mapping[str, int], free: int, pages: int) -> bytes:
        """The whole module: what the functions take and give, which has which, memory, exports, bodies."""
        kinds = list(dict.fromkeys(self.signatures))
        types = [
            b"\x60" + vector([bytes([t]) for t in takes]) + vector([bytes([t]) for t in gives])
            for takes, gives in kinds
        ]
        exports = [(name, 0, k) for name, k in exported.items()] + [("memory", 2, 0), ("free", 3, 0)]
        sections = {
            1: vector(types),
            3: vector([unsigned(kinds.index(signature)) for signature in self.signatures]),
            5: vector([b"\x00" + unsigned(pages)]),
            6: vector([bytes([I32, 0, WHOLE]) + signed(free) + bytes([END])]),
            7: vector(
                [vector([bytes([c]) for c in name.encode()]) + bytes([kind]) + unsigned(k) for name, kind, k in exports]
            ),
            10: vector(self.bodies),
        }
        return b"\x00asm\x01\x00\x00\x00" + b"".join(
            bytes([number_]) + unsigned(len(content)) + content for number_, content in sections.items()
        )
