"""Straight-line code in LLVM's intermediate language, over single numbers or vectors of them.

No flag lets the compiler fuse, reorder or approximate: the figures of a lane are the same at any width.
"""

from __future__ import annotations

import struct
from collections.abc import Sequence

from linkwright.kernels.straight_line import BITS, written_out

_INTRINSIC = "call {t} @llvm.{name}.{suffix}({t} {0})"
_WORDS: dict[str, str] = {
    "add": "fadd {t} {0}, {1}", "subtract": "fsub {t} {0}, {1}", "multiply": "fmul {t} {0}, {1}",
    "divide": "fdiv {t} {0}, {1}", "negative": "fneg {t} {0}", "sqrt": _INTRINSIC, "fabs": _INTRINSIC,
    "floor": _INTRINSIC, "less": "fcmp olt {t} {0}, {1}", "less_equal": "fcmp ole {t} {0}, {1}",
    "greater": "fcmp ogt {t} {0}, {1}", "greater_equal": "fcmp oge {t} {0}, {1}", "equal": "fcmp oeq {t} {0}, {1}",
    "not_equal": "fcmp une {t} {0}, {1}", "and": "and {b} {0}, {1}", "or": "or {b} {0}, {1}",
    "select": "select {b} {0}, {t} {1}, {t} {2}",
}  # fmt: skip
"""The primitive operations that are one instruction, of a type t of numbers and b of conditions."""
_BIT_WORDS = {"add": "add", "and": "and", "or": "or", "shift left": "shl", "shift right": "lshr"}
"""The operations of :data:`straight_line.BITS`."""
INTRINSICS = ("sqrt", "fabs", "floor")


def constant(number: float) -> str:
    """A number to the last bit."""
    (bits,) = struct.unpack("<Q", struct.pack("<d", number))
    return f"0x{bits:016X}"


class LlvmCode:
    """The lines of a function's block, over ``width`` lanes. ``typed`` pointers are those of LLVM before 17."""

    def __init__(self, width: int, typed: bool) -> None:
        self.width, self.lines = width, list[str]()
        vector = "{}" if width == 1 else f"<{width} x {{}}>"
        self.t, self.b, self.i = (vector.format(kind) for kind in ("double", "i1", "i64"))
        self.suffix = "f64" if width == 1 else f"v{width}f64"
        self.pd, self.pt = ("double*", f"{self.t}*") if typed else ("ptr", "ptr")
        self._known: dict[tuple[str, ...], str] = {}
        self._count = 0

    def number(self, value: float) -> str:
        """A number, the same in all lanes."""
        text = constant(value)
        return text if self.width == 1 else "<" + ", ".join([f"double {text}"] * self.width) + ">"

    def do(self, primitive: str, *operands: str) -> str:
        key = primitive, *operands
        if key not in self._known:
            self._known[key] = self._bits(primitive, *operands) if primitive in BITS else self._one(primitive, operands)
        return self._known[key]

    def function(self, name: str, operands: Sequence[str]) -> str:
        return written_out(self, name, operands)

    def name(self, text: str) -> str:
        """Write an instruction under a new name."""
        name = f"%v{self._count}"
        self._count += 1
        self.lines.append(f"{name} = {text}")
        return name

    def load(self, base: str, row: int) -> str:
        """A vector of a row: ``row`` vectors from the pointer ``base`` on."""
        place = self.name(f"getelementptr {self.t}, {self.pt} {base}, i64 {row}")
        return self.name(f"load {self.t}, {self.pt} {place}, align {min(8 * self.width, 64)}")

    def store(self, value: str, base: str, row: int) -> None:
        place = self.name(f"getelementptr {self.t}, {self.pt} {base}, i64 {row}")
        self.lines.append(f"store {self.t} {value}, {self.pt} {place}, align {min(8 * self.width, 64)}")

    def spread(self, base: str, place: int) -> str:
        """A number of an array in all lanes."""
        at = self.name(f"getelementptr double, {self.pd} {base}, i64 {place}")
        one = self.name(f"load double, {self.pd} {at}, align 8")
        if self.width == 1:
            return one
        first = self.name(f"insertelement {self.t} undef, double {one}, i32 0")
        return self.name(f"shufflevector {self.t} {first}, {self.t} undef, <{self.width} x i32> zeroinitializer")

    def _one(self, primitive: str, operands: tuple[str, ...]) -> str:
        text = _WORDS[primitive]
        return self.name(text.format(*operands, t=self.t, b=self.b, name=primitive, suffix=self.suffix))

    def _bits(self, primitive: str, operand: str) -> str:
        held = self.name(f"bitcast {self.t} {operand} to {self.i}")
        changes, taken = BITS[primitive]
        for change, by in changes:
            other = str(by) if self.width == 1 else "<" + ", ".join([f"i64 {by}"] * self.width) + ">"
            held = self.name(f"{_BIT_WORDS[change]} {self.i} {held}, {other}")
        made = self.name(f"bitcast {self.i} {held} to {self.t}")
        return self.do("subtract", made, self.number(taken)) if taken else made
