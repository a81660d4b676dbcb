"""Linear systems written out in a program against a library's solver: ``python benchmarks/linear.py [--json]``.

A dense system of n unknowns, its matrix and right side made from 2 n inputs of each pose so that nothing can be folded:
instructions of the orthogonal factors, their time a pose by each kernel and as an array solve (LAPACK), and the digits
kept.
"""

from __future__ import annotations

import json
import time
from functools import partial

import numpy as np
from figures import parser
from numpy.typing import NDArray

from linkwright.app.bench import median
from linkwright.graph.program import Program
from linkwright.groups.linear import Factor
from linkwright.kernels import KERNELS
from linkwright.symbols import ExpressionStage, Symbol

Array = NDArray[np.float64]


def system(n: int, u: Array) -> tuple[Array, Array]:
    """Matrices (poses, n, n) and right sides (poses, n) from inputs u (2 n, poses)."""
    a = np.sin(u[:n, None] * (1.0 + np.arange(n)[None, :, None])) + np.eye(n)[:, :, None]
    return a.transpose(2, 0, 1), np.ascontiguousarray(u[n:].T)


def program(n: int) -> Program:
    """The same system solved by a program."""
    x = Symbol.several("x", 2 * n)
    rows = [[(x[i] * (1.0 + j)).do("sin") + (1.0 if i == j else 0.0) for j in range(n)] for i in range(n)]
    y = Factor(rows).solve([x[n + i] for i in range(n)])
    block = ExpressionStage(x, [], y)
    return Program((), block, tuple(f"x{i}" for i in range(2 * n)), (), tuple(f"y{i}" for i in range(n)))


spent = partial(median, times=5, clock=time.process_time)


def measure(n: int, poses: int) -> dict[str, float]:
    """Figures of one size; times in ns a pose of one thread."""
    u = np.random.default_rng(n).uniform(0.1, 1.5, (2 * n, poses))
    a, b = system(n, u)
    exact = np.linalg.solve(a, b[..., None])[..., 0].T
    bound = np.linalg.cond(a) * np.abs(exact).max(axis=0)
    made = program(n)
    found = {"unknowns": n, "instructions": float(made.size)}
    found["lapack"] = 1e9 / poses * spent(lambda: np.linalg.solve(*(lambda a, b: (a, b[..., None]))(*system(n, u))))
    for name in ("numpy", "llvm"):
        if not KERNELS[name].available():
            continue
        kernel, out = KERNELS[name](made), np.empty((n, poses))
        found[name] = 1e9 / poses * spent(lambda kernel=kernel, out=out: kernel.run(u, np.empty(0), out))  # type: ignore[misc]
        found[f"{name}_error_over_bound"] = float((np.abs(out - exact).max(axis=0) / bound).max() / 2.0**-53)
    return found


def main() -> None:
    """Print the figures."""
    arguments = parser(__doc__)
    arguments.add_argument("--poses", type=int, default=20_000)
    arguments.add_argument("--sizes", type=int, nargs="+", default=[2, 4, 6, 9, 12])
    options = arguments.parse_args()
    rows = [measure(n, options.poses) for n in options.sizes]
    if options.json:
        print(json.dumps(rows, indent=2))
        return
    for row in rows:
        print("  ".join(f"{name} {value:.4g}" for name, value in row.items()))


if __name__ == "__main__":
    main()
