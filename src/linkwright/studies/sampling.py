"""A study of many samples of the parameters, carried through its work."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from linkwright.blocks import UNIT, Carried, Threads, carry
from linkwright.blocks.runners import opened
from linkwright.data_classes import dataclass
from linkwright.findings import Finding, Joined, ModelError, Term
from linkwright.kernels import KERNELS
from linkwright.kernels.kernel_selection import KernelChoice, choose
from linkwright.measures import BoundMeasure, bound_measures
from linkwright.model.origin import table_files
from linkwright.results import Run
from linkwright.studies.assembly_checks import singular, unassembled
from linkwright.studies.change_point_carry import carry_through_change_points
from linkwright.studies.follower_locking import locked
from linkwright.studies.histograms import coarse, fine, histogram, histogram_range
from linkwright.studies.run_context import RunContext
from linkwright.studies.sampled_study import sampled_study
from linkwright.studies.sampling_options import Sampling
from linkwright.studies.sampling_state import Kept, tabled
from linkwright.studies.sampling_task import SampleTask, SampleWork

Array = NDArray[np.float64]


class Interrupted(KeyboardInterrupt):
    """A study was interrupted; what is finished is saved in ``out`` where there is one."""

    def __init__(self, carried: Carried, out: Path | None) -> None:
        super().__init__()
        self.carried, self.out = carried, out

    @property
    def what(self) -> Term:
        """How far it came, and how to go on."""
        rest = Term("interrupted-lost") if self.out is None else Term("interrupted-kept", folder=self.out)
        return Term("interrupted", atoms=self.carried.atoms, total=self.carried.total, rest=rest)


@dataclass(frozen=True)
class Counted:
    """A histogram: ``counts`` between the ``edges``, ``under`` and ``over`` them."""

    edges: Array
    counts: NDArray[np.int64]
    under: int = 0
    over: int = 0


@dataclass(frozen=True)
class Performed:
    """All samples of a study; ``poses`` of them were computed in ``seconds`` this time."""

    task: SampleTask
    kept: Kept
    poses: int
    seconds: float

    @property
    def failed(self) -> int:
        """How many samples lack a value."""
        return int(self.kept.samples.failed[:, 0].sum())

    def counted(self, i: int, whole: bool = False) -> Counted:
        """The histogram of a figure, of the bins asked for; with ``whole`` of as many as there are."""
        task, rows, bins = self.task, self.kept.samples.rows, self.task.options.histogram
        if rows is not None:
            return Counted(*histogram(rows[i], bins))
        found = self.kept.samples.results()["histogram"]
        edges, counts = fine(*task.reach[i], bins), found["counts"][i]
        if not whole:
            edges, counts = coarse(edges, counts, bins)
        return Counted(edges, counts, int(found["under"][i]), int(found["over"][i]))

    def findings(self) -> Iterator[Finding]:
        """Why samples lack values: a finding for each cause, with the first of its samples."""
        task, plan = self.task, self.task.plan
        for cause, (count, first, time) in enumerate(self.kept.samples.failed.tolist()):
            sample = int(first)
            if not count:
                continue
            if cause < len(task.varied.causes):
                values = plan.values(sample // UNIT)[:, sample % UNIT]
                yield task.varied.finding(cause, int(count), plan.samples, sample, time, values)
            else:
                data = {"count": int(count), "samples": plan.samples, "sample": sample}
                code = "study.never-a-value" if count == plan.samples else "study.no-value"
                yield Finding(code, ("studies", task.options.study), data)


def refused(nominal: Run, options: Sampling, names: Iterable[str]) -> list[Finding]:
    """Why nothing can be compared with the nominal motion: it can't be followed, or meets a change point. ``names`` are
    what varies."""
    found = unassembled(nominal) or singular(nominal)
    if found and options.cycle.through == "keep":
        path, data = ("studies", options.study), {"names": Joined(names)}
        return carry_through_change_points(nominal)[1] or [Finding("varied.passage", path, data)]
    return found or locked(nominal)


def choose_kernel(nominal: Run, options: Sampling, more: Sequence[BoundMeasure] = ()) -> KernelChoice:
    """The kernel that computes it with ``more`` measures, and why. That doesn't depend on the runner, which may change
    no figure."""
    samples = sampled_study(options).draws(nominal.compiled, options).samples
    compiled, poses = nominal.compiled, samples * nominal.t.size
    quantities = compiled.quantities
    trees = [quantities.dimensions.bind(signal.node, None) for signal in options.signals(compiled)]
    measures = [*bound_measures(quantities, options.measures(compiled)), *more]
    trees += [tree for measure in measures for tree in measure.trees.values()]
    program = compiled.graph.program(nominal.signals_of(trees), rates=bool(measures))
    return choose(program, poses, wish=options.kernel)


def perform(
    nominal: Run, options: Sampling, kernel: str, site: RunContext, more: tuple[BoundMeasure, ...] = ()
) -> Performed:
    """Compute all samples, with ``more`` measures than the options ask for, going on with an interrupted study in the
    site's folder.

    Raises :class:`Interrupted`, and :class:`ModelError` where it can't be carried on.
    """
    assert site.document is not None, "samples need the file's document"
    files = tuple(table_files(nominal.compiled.mechanism, site.folder).items())
    work = SampleWork(site.document, files, kernel, options.study, more, uses=nominal.compiled.quantities.uses)
    task = opened(work)
    assert isinstance(task, SampleTask)
    if not tabled(task.plan.samples) and task.figures.columns:
        # The ends of histograms come from the figures of the first samples: a function of the file alone.
        figures, _ = task.figures.evaluate(task.varied.parameters(task.plan.values(0)))
        work = replace(work, reach=tuple(histogram_range(row) for row in figures))
        task = opened(work)
        assert isinstance(task, SampleTask)
    runner = site.runner or Threads(None if KERNELS[kernel].scales else 1)
    with closing(Kept.open(task, work, site)) as kept:
        result = carry(work, kept.sink, runner, site.progress)
    if result.error is not None:
        raise ModelError([result.error])
    if result.interrupted:
        raise Interrupted(result, site.out)
    return Performed(task, kept, result.poses, result.seconds)
