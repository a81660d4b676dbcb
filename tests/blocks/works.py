"""Works to carry in tests: small, random by unit, with gaps, slow or faulty where asked."""

from __future__ import annotations

import hashlib
import os
import signal
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from linkwright.blocks import UNIT, Cut, Folding, Histogram, Moments, Tallies, generator
from linkwright.blocks.checkpoint import Checkpoint
from linkwright.blocks.store import Stored, Variable

CUT = Cut(3 * UNIT + 77, 70)
"""Four units in three ranges of poses: twelve atoms."""
REDUCTIONS = {"m": Moments(), "h": Histogram([[-1.0, 0.0, 0.5, 2.0]] * 2)}


@dataclass(frozen=True)
class Noise:
    """Two outputs of two random dimensions at each pose; some can't be assembled.

    ``pause`` seconds are slept at each atom. A file ``fault`` makes the process die (once, or ``always``) at ``at``.
    """

    seed: int = 1
    cut: Cut = CUT
    pause: float = 0.0
    fault: Path | None = None
    at: int = -1
    always: bool = False

    @property
    def key(self) -> str:
        return hashlib.sha256(repr(self).encode()).hexdigest()

    def open(self) -> NoiseTask:
        return NoiseTask(self)


@dataclass(frozen=True)
class NoiseTask:
    """The work, opened."""

    work: Noise

    @property
    def atoms(self) -> int:
        return self.work.cut.atoms

    def poses(self, atom: int) -> int:
        return self.work.cut.size(atom)

    def perform(self, atom: int) -> dict[str, Any]:
        time.sleep(self.work.pause)
        fault = self.work.fault
        if atom == self.work.at and fault is not None and fault.exists():
            if not self.work.always:
                fault.unlink()
            os.kill(os.getpid(), signal.SIGKILL)
        y = values(self.work, atom)
        tallies = Tallies(REDUCTIONS, 2, y.shape[2])
        tallies.add(y, self.work.cut.sample_slice(atom).start)
        return {**tallies.state(), "a": y[0], "b": y[1]}


def values(work: Noise, atom: int) -> Any:
    """The outputs (2, samples, poses) of an atom."""
    samples, poses = work.cut.sample_slice(atom), work.cut.pose_slice(atom)
    p = generator(work.seed, work.cut.unit(atom)).standard_normal((2, samples.stop - samples.start))
    x = np.arange(poses.start, poses.stop) / 10
    y = p[:, :, None] + np.array([np.sin(x), np.cos(x)])[:, None]
    y[:, p[0] > 1.5] = np.nan
    return y


def folding(work: Noise, path: Path | None = None) -> Folding:
    """A sink for the work, with or without a checkpoint."""
    return Folding(work.cut, REDUCTIONS, None if path is None else Checkpoint(path, work.key))


def bits(results: Any) -> dict[str, bytes]:
    """All figures as bytes."""
    return {f"{name}.{key}": value.tobytes() for name, figures in results.items() for key, value in figures.items()}


def storing(work: Noise, path: Path, **options: Any) -> Stored:
    """A store for the work."""
    angles = np.arange(work.cut.poses) / 10
    variables = [
        Variable("a", unit="mm"),
        Variable("b"),
        Variable("pose", ("pose",), "rad", coordinate=True),
    ]
    return Stored(path, work.key, work.cut, variables, {"pose": angles}, **options)


def files(path: Path) -> dict[str, bytes]:
    """All files of a store with their bytes."""
    return {str(p.relative_to(path)): p.read_bytes() for p in sorted(path.rglob("*")) if p.is_file()}
