"""Recorded code as JavaScript: expressions, functions, the words of the primitive operations.

JavaScript's numbers are doubles, and it neither fuses nor reorders operations. Of ``Math`` only what IEEE 754 fixes to
the last bit is used; its other functions differ between browsers.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import groupby

from linkwright.data_classes import dataclass
from linkwright.kernels.recorded_code import ARGUMENT, ENTRY, NUMBER, Named, RecordedCode, Stored, decimal


@dataclass(frozen=True)
class Word:
    """How a primitive operation is written: its text, how tightly it binds, and how tightly its operands have to."""

    text: str
    binds: int
    operands: tuple[int, ...]


ATOM = 9
WORDS: dict[str, Word] = {
    "add": Word("{}+{}", 6, (6, 7)),
    "subtract": Word("{}-{}", 6, (6, 7)),
    "multiply": Word("{}*{}", 7, (7, 8)),
    "divide": Word("{}/{}", 7, (7, 8)),
    "negative": Word("-{}", 8, (ATOM,)),
    "sqrt": Word("Q({})", ATOM, (0,)),
    "fabs": Word("Z({})", ATOM, (0,)),
    "floor": Word("Y({})", ATOM, (0,)),
    "less": Word("{}<{}", 5, (6, 6)),
    "less_equal": Word("{}<={}", 5, (6, 6)),
    "greater": Word("{}>{}", 5, (6, 6)),
    "greater_equal": Word("{}>={}", 5, (6, 6)),
    "equal": Word("{}=={}", 4, (5, 5)),
    "not_equal": Word("{}!={}", 4, (5, 5)),
    "and": Word("{}&&{}", 3, (3, 3)),
    "or": Word("{}||{}", 2, (2, 2)),
    "select": Word("{}?{}:{}", 1, (2, 1, 1)),
    "power_of_two": Word("T({})", ATOM, (0,)),
    "binary_exponent": Word("E({})", ATOM, (0,)),
    "binary_fraction": Word("R({})", ATOM, (0,)),
}
"""The primitive operations (:data:`straight_line.PRIMITIVES`), by functions of :data:`SUPPORT`."""
BITS = ("power_of_two", "binary_exponent", "binary_fraction")
MATH = "const{sqrt:Q,abs:Z,floor:Y}=Math;"
SUPPORT: dict[str, str] = {
    "": "const B=new Float64Array([1]),U=new Uint32Array(B.buffer),H=U[1]?1:0,L=1-H;",
    "power_of_two": "function T(x){B[0]=x;U[H]=U[L]+1023<<20;U[L]=0;return B[0]}",
    "binary_exponent": ("function E(x){B[0]=x;return(U[H]+0x95f61+(U[L]+0x9980c433>0xffffffff?1:0)>>>20)-1023}"),
    "binary_fraction": (
        "function R(x){B[0]=x;let l=U[L]+0x9980c433,h=U[H]+0x95f61;if(l>0xffffffff){l-=0x100000000;h++}"
        "l+=0x667f3bcd;h=(h&0xfffff)+0x3fe6a09e;if(l>0xffffffff)h++;U[L]=l;U[H]=h;return B[0]-1}"
    ),
}
"""The three that look at a number's bits: its two halves, whose order in memory is the machine's; a sum of the lower
halves carries into the upper ones."""
_LETTERS = "abdefghijklmnqrstuvz"
"""Those of values; c, o, p, w, x and y are arrays and arguments. No word of the language is a letter and digits."""


def function(code: RecordedCode, name: str, arguments: str, called: Mapping[str, str], before: str = "") -> str:
    """A function's text. ``called`` gives the names of elementary functions."""
    names: dict[str, str] = {}
    parts, open_ = [before], False
    for value, same in groupby(code.statements(), key=lambda statement: statement.value):
        text = _expression(code, value, names, called)[0]
        stored = [*same]
        if named := isinstance(stored[0], Named):
            names[value] = name_of(len(names))
            parts.append(f"{',' if open_ else 'const '}{names[value]}=")
        elif open_:
            parts.append(";")
        parts += [f"{one.array}[{one.row}]=" for one in stored if isinstance(one, Stored)]
        parts.append(text if named else f"{text};")
        open_ = named
    if open_:
        parts.append(";")
    if code.result is not None:
        parts.append(f"return {_expression(code, code.result, names, called)[0]}")
    return f"function {name}({arguments}){{{''.join(parts).removesuffix(';')}}}"


def name_of(k: int) -> str:
    """The name of a function's value by its number."""
    return _LETTERS[k % len(_LETTERS)] + (str(k // len(_LETTERS)) if k >= len(_LETTERS) else "")


def _expression(code: RecordedCode, value: str, names: Mapping[str, str], called: Mapping[str, str]) -> tuple[str, int]:
    """The text of a value, and how tightly it binds."""
    if value in names:
        return names[value], ATOM
    node = code.of(value)
    if node.word == NUMBER:
        text = decimal(node.number)
        return text, 7 if "/" in text else 8 if text.startswith("-") else ATOM
    if node.word == ENTRY:
        return f"{node.array}[{node.row}]", ATOM
    if node.word == ARGUMENT:
        return "xy"[node.row], ATOM
    word = WORDS.get(node.word) or Word(f"{called[node.word]}({','.join(['{}'] * len(node.operands))})", ATOM, (0, 0))
    texts = []
    for operand, least in zip(node.operands, word.operands, strict=False):
        text, binds = _expression(code, operand, names, called)
        texts.append(text if binds >= least else f"({text})")
    if node.word == "subtract" and texts[1].startswith("-"):
        texts[1] = f"({texts[1]})"
    return word.text.format(*texts), word.binds
