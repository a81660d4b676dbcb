"""Recorded code as WebAssembly: the body of a function in its binary form (WebAssembly Core Specification 1.0, 5).

Operations are those of IEEE 754 and exact ones on whole numbers, the same on every machine.
"""

from __future__ import annotations

import struct
from collections.abc import Mapping, Sequence

from linkwright.kernels.recorded_code import ARGUMENT, CONDITIONS, ENTRY, NUMBER, Named, RecordedCode
from linkwright.kernels.straight_line import BITS

I32, I64, F64 = 0x7F, 0x7E, 0x7C
"""Types of values."""
WORDS: dict[str, int] = {
    "add": 0xA0, "subtract": 0xA1, "multiply": 0xA2, "divide": 0xA3, "negative": 0x9A, "sqrt": 0x9F, "fabs": 0x99,
    "floor": 0x9C, "less": 0x63, "less_equal": 0x65, "greater": 0x64, "greater_equal": 0x66, "equal": 0x61,
    "not_equal": 0x62, "and": 0x71, "or": 0x72, "select": 0x1B,
}  # fmt: skip
"""The primitive operations that are one instruction; conditions are whole numbers, 1 or 0."""
BIT_WORDS = {"add": 0x7C, "and": 0x83, "or": 0x84, "shift left": 0x86, "shift right": 0x88}
"""The operations of :data:`straight_line.BITS`."""
GET, SET, CALL, LOAD, STORE, END = 0x20, 0x21, 0x10, 0x2B, 0x39, 0x0B
WHOLE, LONG, DOUBLE = 0x41, 0x42, 0x44
"""Constants of 32 and 64 bits, and numbers."""
TO_BITS, FROM_BITS = 0xBD, 0xBF


def unsigned(number: int) -> bytes:
    """A whole number in groups of seven bits (LEB128)."""
    made = bytearray()
    while number > 0x7F:
        made.append(number & 0x7F | 0x80)
        number >>= 7
    return bytes([*made, number])


def signed(number: int) -> bytes:
    """A whole number with a sign in groups of seven bits; the highest bit of the last is the sign."""
    made = bytearray()
    while not -0x40 <= number < 0x40:
        made.append(number & 0x7F | 0x80)
        number >>= 7
    return bytes([*made, number & 0x7F])


def vector(items: Sequence[bytes]) -> bytes:
    """Items after their count."""
    return unsigned(len(items)) + b"".join(items)


def body(locals_: Sequence[tuple[int, int]], code: bytes) -> bytes:
    """A function's body after its length: counts and types of locals, instructions."""
    made = vector([unsigned(count) + bytes([kind]) for count, kind in locals_ if count]) + code + bytes([END])
    return unsigned(len(made)) + made


def number(value: float) -> bytes:
    """A number onto the stack."""
    return bytes([DOUBLE]) + struct.pack("<d", value)


def double(operation: int, address: int) -> bytes:
    """A load or a store of a number, so many bytes after the address that lies on the stack."""
    return bytes([operation, 3]) + unsigned(address)


class FunctionBody:
    """The body of one recorded function. ``bases`` gives each array's base: a local that holds its address, or ``None``
    for an absolute one, and the bytes of the array's start from there. ``called`` gives the functions' numbers."""

    def __init__(
        self,
        code: RecordedCode,
        arguments: int,
        bases: Mapping[str, tuple[int | None, int]],
        called: Mapping[str, int],
    ) -> None:
        self.code, self.bases, self.called = code, bases, called
        statements = list(code.statements())
        named = [statement.value for statement in statements if isinstance(statement, Named)]
        numbers = [value for value in named if code.of(value).word not in CONDITIONS]
        conditions = [value for value in named if code.of(value).word in CONDITIONS]
        places = {value: arguments + k for k, value in enumerate([*numbers, *conditions])}
        self.places: dict[str, int] = {}
        self.made = bytearray()
        for statement in statements:
            if isinstance(statement, Named):
                self._value(statement.value)
                self.places[statement.value] = places[statement.value]
                self._instruction(SET, places[statement.value])
            else:
                address = self._base(statement.array, statement.row)
                self._value(statement.value)
                self.made += double(STORE, address)
        if code.result is not None:
            self._value(code.result)
        self.body = body([(len(numbers), F64), (len(conditions), I32)], bytes(self.made))

    def _instruction(self, operation: int, number: int) -> None:
        self.made += bytes([operation]) + unsigned(number)

    def _base(self, array: str, row: int) -> int:
        """Put an array's base onto the stack; how far from it a row is."""
        local, start = self.bases[array]
        if local is None:
            self.made += bytes([WHOLE]) + signed(0)
        else:
            self._instruction(GET, local)
        return start + 8 * row

    def _value(self, value: str) -> None:
        """Put a value onto the stack."""
        if value in self.places:
            self._instruction(GET, self.places[value])
            return
        node = self.code.of(value)
        if node.word == NUMBER:
            self.made += number(node.number)
        elif node.word == ARGUMENT:
            self._instruction(GET, node.row)
        elif node.word == ENTRY:
            address = self._base(node.array, node.row)
            self.made += double(LOAD, address)
        else:
            # select takes its condition last.
            for operand in (*node.operands[1:], node.operands[0]) if node.word == "select" else node.operands:
                self._value(operand)
            self._operation(node.word)

    def _operation(self, word: str) -> None:
        if word in BITS:
            changes, taken = BITS[word]
            self.made.append(TO_BITS)
            for change, by in changes:
                self.made += bytes([LONG]) + signed(by) + bytes([BIT_WORDS[change]])
            self.made.append(FROM_BITS)
            if taken:
                self.made += number(taken) + bytes([WORDS["subtract"]])
        elif word in WORDS:
            self.made.append(WORDS[word])
        else:
            self._instruction(CALL, self.called[word])
