"""The JAX emitter: a program traced in float64 and compiled by XLA, for the device that JAX has.

Calls have one shape of block each, padded by repeating the last pose, whatever the number of poses: XLA compiles once
for each shape, and its digits may differ from shape to shape.
"""

from __future__ import annotations

from importlib.util import find_spec
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from linkwright._machine import needed
from linkwright.graph.program import Program
from linkwright.kernels.jax_trace import outputs
from linkwright.kernels.registry import register

Array = NDArray[np.float64]

TILES: dict[str, tuple[int, int]] = {"cpu": (256, 32)}
"""Samples and poses of a block by platform; their product is the number of poses where there are no samples."""
TILE = 8192, 64
"""The same of accelerators, whose blocks are to be large."""
OPTIONS: dict[str, dict[str, Any]] = {
    # Fused loops compute shared parts once for each output: on a CPU, twice the time or more (docs/performance.md).
    "cpu": {"xla_disable_hlo_passes": "fusion,cpu-instruction-fusion"}
}
"""How XLA compiles, by platform."""


@register
class JaxKernel:
    """Runs a program on JAX's default device. float64 holds inside its calls alone: JAX's own setting stays."""

    name: ClassVar[str] = "jax"
    packages: ClassVar[tuple[str, ...]] = ("jax", "jaxlib")
    scales: ClassVar[bool] = True

    def __init__(self, program: Program) -> None:
        self.program = program
        self.jax = needed("jax", "gpu")
        platform = self.jax.default_backend()
        self.tile, self.options = TILES.get(platform, TILE), OPTIONS.get(platform)
        self.compiled = self.jit(self._stacked)

    @classmethod
    def available(cls) -> bool:
        """Whether JAX is installed."""
        return find_spec("jax") is not None

    def run(self, x: Array, p: Array, out: Array | None = None) -> Array:
        """All outputs at all poses, (outputs, poses), in SI: from the per-pose inputs ``x`` (inputs, poses) and the
        parameters ``p``, (parameters,) or (parameters, poses). NaN where a group can't close."""
        if out is None:
            out = np.empty((len(self.program.outputs), x.shape[1]))
        width = self.tile[0] * self.tile[1]
        for start in range(0, x.shape[1], width):
            part = slice(start, start + width)
            parameters = p if p.ndim == 1 else padded(p[:, part], width)
            found = self.call(self.compiled, padded(x[:, part], width), parameters)
            out[:, part] = np.asarray(found)[:, : x.shape[1] - start]
        return out

    def over(self, x: Array, p: Array, out: Array | None = None) -> Array:
        """All outputs of all samples at all poses, (outputs, samples, poses), in SI: from inputs ``x`` that samples
        share, (inputs, poses), or have each, (inputs, samples, poses), and parameters ``p`` (parameters, samples).
        What depends on the pose or on the sample alone is computed once in a block."""
        if out is None:
            out = np.empty((len(self.program.outputs), p.shape[1], x.shape[-1]))
        samples, poses = out.shape[1:]
        height, width = self.tile
        for first in range(0, samples, height):
            some = slice(first, first + height)
            parameters = padded(p[:, some, None], height, axis=1)
            for start in range(0, poses, width):
                part = slice(start, start + width)
                inputs = padded(x[:, None, part] if x.ndim == 2 else padded(x[:, some, part], height, axis=1), width)
                found = self.call(self.compiled, inputs, parameters)
                out[:, some, part] = np.asarray(found)[:, : samples - first, : poses - start]
        return out

    def jit(self, function: Any) -> Any:
        """A function compiled for the device when it is called."""
        return self.jax.jit(function, compiler_options=self.options)

    def call(self, function: Any, *args: Any) -> Any:
        """A compiled function's result, in float64; it may still be under way on the device."""
        with self.jax.enable_x64(True):
            return function(*args)

    def _stacked(self, x: Any, p: Any) -> Any:
        jnp = self.jax.numpy
        shape = jnp.broadcast_shapes(x.shape[1:], p.shape[1:])
        return jnp.stack([jnp.broadcast_to(row, shape) for row in outputs(self.jax, self.program, x, p)])


def padded(values: Array, size: int, axis: int = -1) -> Array:
    """The values with the last one along an axis repeated up to a size."""
    missing = size - values.shape[axis]
    if not missing:
        return values
    last = np.take(values, [-1], axis=axis)
    return np.concatenate([values, np.repeat(last, missing, axis=axis)], axis=axis)
