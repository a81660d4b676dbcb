"""Programs as JAX sees them: the instruction list and Newton's method, on whatever arrays they are traced with.

Rows of inputs and parameters may have any shapes that broadcast together: what depends on one of them alone keeps its
shape, and is computed once.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce
from typing import Any

from linkwright.graph.program import ACCEPTED, MOST_STEPS, SOLVED, NewtonStage, Program
from linkwright.symbols import CONSTANT, INPUT, OPERATIONS, OUTPUT, ExpressionStage

NAMES = {name: name for name in OPERATIONS if name not in ("twice", "if_else_zero")} | {"fabs": "abs"}
"""What ``jax.numpy`` calls the operations that it has, by name; those two are written out."""


def outputs(jax: Any, program: Program, x: Any, p: Any) -> list[Any]:
    """The program's outputs from the rows of inputs ``x`` and parameters ``p``; each has the shape that it needs."""
    rows = list(x)
    for stage in program.solves:
        for row, solved in zip(stage.rows, _solve(jax, stage, rows, p), strict=True):
            rows[row] = solved
    return _rows(jax.numpy, program.block, rows, p)


def _rows(jnp: Any, stage: ExpressionStage, x: Sequence[Any], p: Any) -> list[Any]:
    """The rows of a block."""
    holds: dict[int, Any] = {}
    found: list[Any] = [None] * stage.rows
    for i in stage.instructions:
        if i.op == CONSTANT:
            holds[i.out] = jnp.float64(i.value)
        elif i.op == INPUT:
            holds[i.out] = (x, p)[i.args[0]][i.args[1]]
        elif i.op == OUTPUT:
            found[i.out] = holds[i.args[0]]
        else:
            holds[i.out] = _computed(jnp, i.op, [holds[a] for a in i.args]).astype(float)
    return found


def _computed(jnp: Any, op: str, operands: list[Any]) -> Any:
    if op == "twice":
        return 2.0 * operands[0]
    if op == "if_else_zero":
        return jnp.where(operands[0] != 0, operands[1], 0.0)
    return getattr(jnp, NAMES[op])(*operands)


def _solve(jax: Any, stage: NewtonStage, x: Sequence[Any], p: Any) -> list[Any]:
    """The rows of a stage solved, by the rules of :mod:`linkwright.kernels.newton`: a solved pose is left alone."""
    jnp, n = jax.numpy, len(stage.rows)
    shape = jnp.broadcast_shapes(*(row.shape for row in x), *(row.shape for row in p))

    def step(state: tuple[Any, Any, Any]) -> tuple[Any, Any, Any]:
        count, u, moved = state
        rows = list(x)
        for row, value in zip(stage.rows, u, strict=True):
            rows[row] = value
        y = [jnp.broadcast_to(row, shape) for row in _rows(jnp, stage.closure, rows, p)]
        steps = _steps(jnp, jnp.stack(y[n:]).reshape(n, n, *shape), jnp.stack(y[:n]))
        new = u - steps
        reach = [jnp.abs(steps[i]) / jnp.maximum(stage.scale[i], jnp.abs(new[i]) * stage.sliding[i]) for i in range(n)]
        still = moved >= SOLVED  # NaN is as good as solved: it stays
        return count + 1, jnp.where(still, new, u), jnp.where(still, reduce(jnp.maximum, reach), moved)

    def unsolved(state: tuple[Any, Any, Any]) -> Any:
        return (state[0] < MOST_STEPS) & (state[2] >= SOLVED).any()

    start = jnp.stack([jnp.broadcast_to(x[row], shape) for row in stage.rows])
    _, u, moved = jax.lax.while_loop(unsolved, step, (0, start, jnp.full(shape, jnp.inf)))
    return list(jnp.where(moved < ACCEPTED, u, jnp.nan))


def _steps(jnp: Any, slope: Any, gap: Any) -> Any:
    """Newton's step at each pose, (n, ...), by elimination with row pivots; NaN where the slopes are singular or
    unknown. Written out, number by number: a batch of small systems is no work for a library of large ones."""
    n = len(gap)
    known = jnp.isfinite(slope).all(axis=(0, 1)) & jnp.isfinite(gap).all(axis=0)
    rows = [[*slope[i], gap[i]] for i in range(n)]
    done = []
    for _ in range(n):
        first, rest = rows[0], []
        for row in rows[1:]:
            larger = jnp.abs(row[0]) > jnp.abs(first[0])
            rest.append([jnp.where(larger, a, b) for a, b in zip(first, row, strict=True)])
            first = [jnp.where(larger, b, a) for a, b in zip(first, row, strict=True)]
        pivot, tail = jnp.where(first[0] == 0, jnp.nan, first[0]), first[1:]
        rows = [[b - row[0] / pivot * a for a, b in zip(tail, row[1:], strict=True)] for row in rest]
        done.append((pivot, tail))
    step: list[Any] = []
    for pivot, tail in reversed(done):
        value = tail[-1]
        for a, b in zip(tail[:-1], step, strict=True):
            value = value - a * b
        step.insert(0, value / pivot)
    return jnp.where(known, jnp.stack(step), jnp.nan)
