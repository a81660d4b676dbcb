"""What a study of many samples keeps while it runs: its sinks, and the files from which an interrupted one goes on."""

from __future__ import annotations

from dataclasses import field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from linkwright._machine import memory_to_keep
from linkwright.blocks import Checkpoint, Cut, Folding, Reduction, Sink, Together
from linkwright.blocks.checkpoint import unsaved
from linkwright.blocks.store import Stored, Variable
from linkwright.blocks.work import Arrays
from linkwright.data_classes import dataclass
from linkwright.findings import Finding, ModelError
from linkwright.studies.kept_values import too_many
from linkwright.studies.run_context import RunContext
from linkwright.studies.sampling_output import Samples
from linkwright.studies.sampling_task import SampleTask, SampleWork

Array = NDArray[np.float64]

ROWS = 1_000_000
"""The most samples of which a row each is kept."""

ONE = 8
"""Bytes of a value."""


def tabled(samples: int) -> bool:
    """Whether a row is kept of each of so many samples."""
    return samples <= ROWS


def store(study: str) -> str:
    """The name of the Zarr store of a study's values."""
    return f"{study}.zarr"


class SignalMemory:
    """A sink that holds all values of signals in memory: ``values`` (signals, samples, poses)."""

    def __init__(self, cut: Cut, texts: tuple[str, ...]) -> None:
        self.next = 0
        self._cut, self._texts = cut, texts
        self.values = np.full((len(texts), cut.samples, cut.poses), np.nan)

    def take(self, atom: int, result: Arrays) -> None:
        """Take the values of atom ``next``."""
        for row, text in zip(self.values, self._texts, strict=True):
            row[self._cut.sample_slice(atom), self._cut.pose_slice(atom)] = result[text]
        self.next = atom + 1

    def save(self) -> None:
        """Nothing outlasts the process."""


@dataclass
class Kept:
    """The sinks of a study; ``files`` hold their state, of no use once its outcome is written."""

    samples: Samples
    signals: Folding
    stored: Stored | None = None
    held: SignalMemory | None = None
    files: list[Path] = field(default_factory=list)

    @classmethod
    def open(cls, task: SampleTask, work: SampleWork, site: RunContext) -> Kept:
        """Sinks that go on where the site's folder has them. Raises :class:`ModelError`."""
        files: list[Path] = []
        study, key = task.options.study, work.content

        def checkpoint_of(name: str) -> Checkpoint | None:
            if site.out is None:
                return None
            try:
                site.out.mkdir(parents=True, exist_ok=True)
            except OSError as error:
                raise unsaved(site.out, error) from None
            files.append(site.out / f"{study}-{key[:12]}.{name}")
            site.keep(files[-1], study)
            return Checkpoint(files[-1], key, site.fresh, work.versions)

        rows = len(task.figures.columns) + len(task.figures.required)
        tallied: dict[str, Reduction] = task.tallied if rows else {}
        if tabled(task.plan.samples) and (faults := too_many(study, "samples", task.plan.samples, rows)):
            raise ModelError(faults)
        samples = Samples(
            task.cut, rows, len(task.varied.causes), tallied, tabled(task.plan.samples), checkpoint_of("samples")
        )
        made = cls(samples, Folding(task.cut, task.reductions, checkpoint_of("signals")), files=files)
        if task.options.keeps_signals and task.signals.texts:
            if site.out is not None:
                files.append(site.out / f"{store(study)}.checkpoint")
                for path in (files[-1], site.out / store(study)):
                    site.keep(path, study)
                made.stored = _stored(task, work, site.out, site.fresh)
            elif len(task.signals.texts) * task.cut.samples * task.cut.poses * ONE > memory_to_keep():
                limit = f"{memory_to_keep() // ONE:,}"
                raise ModelError([Finding("study.no-folder", ("studies", study, "keep"), {"limit": limit})])
            else:
                made.held = SignalMemory(task.cut, task.signals.texts)
        return made

    @property
    def sink(self) -> Sink:
        """All of them."""
        return Together([sink for sink in (self.samples, self.signals, self.stored, self.held) if sink is not None])

    def close(self) -> None:
        """Let other processes write to the store."""
        if self.stored is not None:
            self.stored.close()


def _stored(task: SampleTask, work: SampleWork, out: Path, fresh: bool) -> Stored:
    """The store of all values. One without a checkpoint beside it is the result of an earlier study: it is replaced."""
    path = out / store(task.options.study)
    anew = fresh or not path.with_name(f"{path.name}.checkpoint").exists()
    time = Variable("t", ("pose",), "s", coordinate=True)
    attributes = {"title": task.compiled.mechanism.title, "source": "linkwright", "plan": task.plan.name}
    variables = [time, *task.of_samples(), *task.of_signals()]
    return Stored(path, work.content, task.cut, variables, {"t": task.run.t}, attributes, anew, work.versions)
