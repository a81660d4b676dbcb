"""Samples reduced where they are computed: what comes back from the device is a few figures a pose."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.kernels.jax_kernel import JaxKernel, padded
from linkwright.kernels.jax_trace import outputs

Array = NDArray[np.float64]

FIGURES = "count", "mean", "squares", "least", "most"
"""Of the values of an output at a pose: how many aren't NaN, their mean, the sum of the squares of their deviations
from it, the least and the greatest."""


class DeviceReduction:
    """Reduces a kernel's outputs over samples on its device. ``tile`` is the (samples, poses) of a block; what is
    held on the device grows with the block and not with the number of samples."""

    def __init__(self, kernel: JaxKernel, tile: tuple[int, int] | None = None) -> None:
        self.kernel, self.tile = kernel, tile or kernel.tile
        self.fold = kernel.jit(self._fold)

    def __call__(self, x: Array, p: Array) -> dict[str, Array]:
        """The :data:`FIGURES` by name, each (outputs, poses), in SI: from inputs ``x`` (inputs, poses) and parameters
        ``p`` (parameters, samples). Where every value is NaN the count is 0, and mean, least and most are NaN."""
        (samples, poses), (height, width) = (p.shape[1], x.shape[1]), self.tile
        parts = range(0, poses, width)
        empty = np.zeros((5, len(self.kernel.program.outputs), width))
        empty[3], empty[4] = np.inf, -np.inf
        states: list[Any] = [empty for _ in parts]
        inputs = [self._on_device(padded(x[:, None, start : start + width], width)) for start in parts]
        for first in range(0, samples, height):
            given = self._on_device(padded(p[:, first : first + height, None], height, axis=1))
            count = np.int64(samples - first)
            states = [self.kernel.call(self.fold, *each, given, count) for each in zip(states, inputs, strict=True)]
        whole = np.concatenate([empty[..., :0], *map(np.asarray, states)], axis=2)[..., :poses]
        whole[1:, whole[0] == 0] = np.array([np.nan, 0.0, np.nan, np.nan])[:, None]
        return dict(zip(FIGURES, whole, strict=True))

    def _on_device(self, values: Array) -> Any:
        return self.kernel.call(self.kernel.jax.device_put, values)

    def _fold(self, state: Any, x: Any, p: Any, count: Any) -> Any:
        """The state with the first ``count`` samples of a block taken in (Chan, Golub, LeVeque 1983)."""
        jnp = self.kernel.jax.numpy
        shape = jnp.broadcast_shapes(x.shape[1:], p.shape[1:])
        inside = jnp.arange(shape[0])[:, None] < count
        values = [jnp.broadcast_to(y, shape) for y in outputs(self.kernel.jax, self.kernel.program, x, p)]
        rows = []
        for y in self.kernel.jax.lax.optimization_barrier(values):  # else each sum may compute its values anew
            counts = inside & ~jnp.isnan(y)
            n = counts.sum(axis=0).astype(float)
            mean = jnp.where(counts, y, 0.0).sum(axis=0) / jnp.maximum(n, 1.0)
            squares = jnp.where(counts, (y - mean) ** 2, 0.0).sum(axis=0)
            least, most = (jnp.where(counts, y, end) for end in (jnp.inf, -jnp.inf))
            rows.append(jnp.stack([n, mean, squares, least.min(axis=0), most.max(axis=0)]))
        n, mean, squares, least, most = jnp.stack(rows, axis=1)
        before, mean0, squares0, least0, most0 = state
        all_ = jnp.maximum(before + n, 1.0)
        off = mean - mean0
        return jnp.stack(
            [
                before + n,
                mean0 + off * n / all_,
                squares0 + squares + off**2 * before * n / all_,
                jnp.minimum(least0, least),
                jnp.maximum(most0, most),
            ]
        )
