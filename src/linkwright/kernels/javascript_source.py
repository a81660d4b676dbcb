"""The JavaScript text of a program: it solves a pose in a page, by the arithmetic of the other emitters, to their bits.

The text is an expression whose value has two functions: ``parameters(p)`` computes what depends on the parameters
alone, ``pose(x, out)`` a pose from its inputs to its outputs (arrays of 64-bit numbers, SI). Rows are known by number:
what a model calls them is no part of the text, and goes beside it as data (:func:`labels`).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from linkwright.graph.program import ACCEPTED, MOST_STEPS, SOLVED, Program
from linkwright.kernels.javascript_code import BITS, MATH, SUPPORT, function
from linkwright.kernels.pose_functions import PoseFunctions, Solve
from linkwright.kernels.recorded_code import RecordedCode, decimal

LONGEST = 400
"""The most instructions of one function: engines leave very long ones uncompiled."""


def javascript(program: Program) -> str:
    """The text of a program."""
    return f"{javascript_array([program])}[0]"


def javascript_array(programs: Iterable[Program]) -> str:
    """The text of an array of programs; what elementary functions they share stands there once."""
    return "".join(_parts([PoseFunctions(program, LONGEST) for program in programs]))


def labels(program: Program) -> dict[str, list[str]]:
    """What the rows of inputs, parameters and outputs are called, to be written as JSON."""
    return {key: list(getattr(program, key)) for key in ("inputs", "parameters", "outputs")}


def _parts(every: Sequence[PoseFunctions]) -> Iterator[str]:
    yield "(()=>{" + MATH
    library = {name: code for made in every for name, code in made.library.items()}
    bits = {node.word for code in library.values() for node in code.nodes} & {*BITS}
    for name in ("", *BITS) if bits else ():
        if not name or name in bits:
            yield SUPPORT[name]
    called = {name: f"F{k}" for k, name in enumerate(library)}
    yield from (function(code, called[name], "x,y"[: 2 * _operands(code) - 1], {}) for name, code in library.items())
    yield f"return[{','.join(''.join(_program(made, called)) for made in every)}]}})()"


def _program(made: PoseFunctions, called: Mapping[str, str]) -> Iterator[str]:
    """A program, within the functions that it calls."""
    yield f"(()=>{{const c=new Float64Array({made.scalars}),w=new Float64Array({made.rows});"
    once = [f"C{k}" for k in range(len(made.once))]
    yield from (function(code, name, "p", called) for name, code in zip(once, made.once, strict=True))
    each: list[str] = []
    for k, step in enumerate(made.each):
        if isinstance(step, Solve):
            yield from _solve(step, k, called)
            each.append(f"S{k}(x)")
        else:
            yield function(step, f"P{k}", "x,o", called)
            each.append(f"P{k}(x,o)")
    yield f"return{{parameters(p){{{';'.join(f'{name}(p)' for name in once)}}},pose(x,o){{{';'.join(each)}}}}}}})()"


def _operands(code: RecordedCode) -> int:
    """The number of arguments of an elementary function."""
    return sum(node.word == "argument" for node in code.nodes)


def _solve(solve: Solve, k: int, called: Mapping[str, str]) -> Iterator[str]:
    """The functions of a Newton stage."""
    names = [f"S{k}_{n}" for n in range(len(solve.closure))]
    yield from (function(code, name, "x", called) for name, code in zip(names, solve.closure, strict=True))
    yield function(solve.step, f"S{k}s", "", called)
    begin = ";".join(f"w[{row}]=x[{start}]" for row, start in zip(solve.unknown, solve.starts, strict=True))
    calls = ";".join(f"{name}(x)" for name in names)
    # NaN is as good as solved: it stays.
    loop = f"for(let k=0;k<{MOST_STEPS};k++){{{calls};m=S{k}s();if(!(m>={decimal(SOLVED)}))break}}"
    lost = "=".join(f"w[{row}]" for row in solve.unknown)
    yield f"function S{k}(x){{let m;{begin};{loop}if(!(m<{decimal(ACCEPTED)})){lost}=NaN}}"
