"""A thousand million poses on JAX's device: ``python benchmarks/device.py [--poses N] [--json]``.

A four-bar all of whose lengths vary: samples x 360 poses, computed and reduced on the device (count, mean, squares,
extremes of each output at each pose). Parameters come from the host. The shares say how much of the device's peaks
the work is worth: the arithmetic counts each instruction that runs at every pose as one operation, sines and roots
too; the bandwidth counts each output's value as written once, which a reduction needn't do.
"""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import numpy as np
from figures import parser, tell

import linkwright as lw
from linkwright.graph.program import Program
from linkwright.kernels import Compiled
from linkwright.kernels.jax_kernel import JaxKernel
from linkwright.kernels.jax_reduction import DeviceReduction
from linkwright.symbols import CONSTANT, INPUT, OUTPUT

MODEL = Path(__file__).resolve().parent.parent / "examples" / "four_bar.yaml"
LENGTHS = "a", "b", "c", "d"
OUTPUTS = "B.x", "B.y", "P.x", "P.y", "rocker.angle", "rocker.omega", "rocker.alpha", "motor.torque"
POSES = 360
DEVIATION = 1e-3
"""Of each length, as a share of it."""

PEAKS: dict[str, tuple[float, float]] = {
    "H200": (34e12, 4.8e12), "H100": (34e12, 3.35e12), "A100": (9.7e12, 2.0e12), "V100": (7.8e12, 0.9e12),
    "L40": (1.4e12, 0.864e12), "L4": (0.47e12, 0.3e12), "T4": (0.25e12, 0.32e12),
}  # fmt: skip
"""Operations in float64 outside tensor cores and bytes of memory a second, by a part of the device's name: from the
vendor's data sheets, those of the fastest version (SXM); float64 of L4, L40 and T4 is 1/64, 1/64, 1/32 of float32."""


def peaks(device: str) -> tuple[float, float] | None:
    """Those of the first name in the table that the device's name has; longer names stand before their parts."""
    return next((figures for name, figures in PEAKS.items() if name in device), None)


def arithmetic(program: Program) -> int:
    """The operations at every pose of every sample: those that depend on both."""
    depends: dict[int, set[int]] = {}
    count = 0
    for i in program.block.instructions:
        if i.op == CONSTANT:
            depends[i.out] = set()
        elif i.op == INPUT:
            depends[i.out] = {i.args[0]}
        elif i.op != OUTPUT:
            depends[i.out] = set().union(*(depends[a] for a in i.args))
            count += len(depends[i.out]) == 2
    return count


def lengths(compiled: Compiled, samples: int) -> np.ndarray:
    """Parameters (parameters, samples), the four lengths spread about their values."""
    p = np.repeat(compiled.parameters[:, None], samples, axis=1)
    for k, row in enumerate([compiled.graph.parameters.index(name) for name in LENGTHS]):
        draws = np.random.default_rng(np.random.SeedSequence(1, spawn_key=(k,))).standard_normal(samples)
        p[row] *= 1 + DEVIATION * draws
    return p


def measure(
    poses: int, tile: tuple[int, int] | None = None, given: tuple[float, float] | None = None
) -> dict[str, Any]:
    """All figures by name; ``given`` are peaks that stand in for those of the table."""
    compiled = lw.compile(lw.load(MODEL))
    x = compiled.inputs(np.linspace(0.0, 0.5, POSES, endpoint=False))
    samples = -(-poses // POSES)
    p = lengths(compiled, samples)
    kernel = JaxKernel(compiled.graph.program(OUTPUTS))
    reduction = DeviceReduction(kernel, tile)
    start = time.perf_counter()
    reduction(x, p[:, :1])
    compiling = time.perf_counter() - start
    start = time.perf_counter()
    found = reduction(x, p)
    seconds = time.perf_counter() - start
    device = kernel.jax.devices()[0].device_kind
    operations = arithmetic(kernel.program)
    figures = {
        "device": device,
        "poses": samples * POSES,
        "outputs": len(OUTPUTS),
        "instructions": kernel.program.size,
        "operations_per_pose": operations,
        "first_call_s": compiling,
        "seconds": seconds,
        "ns_per_pose": 1e9 * seconds / (samples * POSES),
        "closed": float(found["count"].min() / samples),
        "stroke_deg": float(np.degrees(np.ptp(found["mean"][OUTPUTS.index("rocker.angle")]))),
    }
    known = given or peaks(device)
    if known:
        rate = samples * POSES / seconds
        figures["arithmetic_share"] = rate * operations / known[0]
        figures["bandwidth_share"] = rate * 8 * len(OUTPUTS) / known[1]
    return figures


def main() -> None:
    """Print the figures, as a table or as JSON."""
    arguments = parser(__doc__)
    arguments.add_argument("--poses", type=float, default=1e9, help="poses, rounded up to whole turns of 360")
    arguments.add_argument("--tile", type=int, nargs=2, metavar=("SAMPLES", "POSES"), help="the block on the device")
    arguments.add_argument(
        "--peak", type=float, nargs=2, metavar=("FLOPS", "BYTES"), help="the device's peaks a second"
    )
    options = arguments.parse_args()
    tile, peak = (tuple(pair) if pair else None for pair in (options.tile, options.peak))
    tell(measure(int(options.poses), tile, peak), options.json)


if __name__ == "__main__":
    main()
