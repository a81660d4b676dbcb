"""The work of a study of many samples: what a process needs to perform it, and what comes of each of its atoms."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping, Sequence
from contextlib import nullcontext
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.blocks import Cut, Fourth, Histogram, Moments, Reduction, Tallies
from linkwright.blocks.store import Variable
from linkwright.blocks.work import Arrays
from linkwright.compilation import examine
from linkwright.data_classes import dataclass
from linkwright.expressions.language import Call, Name, Node, evaluate, is_signal, parse
from linkwright.findings import raise_errors
from linkwright.kernels import Compiled, machine_code
from linkwright.kernels.parameter_batch import Varied
from linkwright.kernels.versions import versions
from linkwright.measures import BoundMeasure, bound_measures
from linkwright.model.document import Document, plain
from linkwright.model.places import ExpressionPlace
from linkwright.model.temporary import temporary_folder
from linkwright.notation.angles import whole_turns
from linkwright.results import Run
from linkwright.results.dataset import si_unit
from linkwright.studies.cycle.options import span
from linkwright.studies.figures import SampleFigures
from linkwright.studies.histograms import fine
from linkwright.studies.registry import read_studies
from linkwright.studies.sampled_study import sampled_study
from linkwright.studies.sampling_options import Sampling

Array = NDArray[np.float64]

FINE, NO_CAUSE = -2, -1
STRIP = 1 << 18
"""Values of signals that are computed at a time: they stay in the cache until they are tallied."""


@dataclass(frozen=True)
class SampleWork:
    """A ``study`` of many samples that any process can perform: the file's document and the content of its tables.

    ``more`` are measures besides those that the options ask for. ``reach`` (figures, 2) are the least and largest edges
    of the histograms that atoms make, in SI; none of them where the figures of all samples are kept. ``uses`` are
    those of the nominal :class:`Quantities`.
    """

    document: Document
    files: tuple[tuple[str, bytes], ...]
    kernel: str
    study: str
    more: tuple[BoundMeasure, ...] = ()
    reach: tuple[tuple[float, float], ...] = ()
    uses: tuple[ExpressionPlace, ...] = ()

    @cached_property
    def versions(self) -> dict[str, str]:
        """Those of all that computes the figures."""
        return versions(self.kernel)

    @property
    def key(self) -> str:
        """A hash of all that the figures depend on."""
        said = json.dumps([self.content, self.versions], sort_keys=True)
        return hashlib.sha256(said.encode()).hexdigest()

    @cached_property
    def content(self) -> str:
        """A hash of what is to be computed, whatever computes it."""
        data = plain(self.document)
        data["studies"] = {name: data["studies"][name] for name in ("cycle", self.study)}
        data["studies"][self.study].pop("kernel", None)
        said = json.dumps([data, self.reach, [measure.content for measure in self.more]], sort_keys=True)
        sums = [f"{name} {hashlib.sha256(content).hexdigest()}" for name, content in self.files]
        return hashlib.sha256("\n".join([said, *sums]).encode()).hexdigest()

    def open(self) -> SampleTask:
        """Compile the mechanism."""
        with temporary_folder() if self.files else nullcontext(Path()) as folder:
            for name, content in self.files:
                path = folder / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(content)
            compiled, findings = examine(self.document, folder, self.uses)
        raise_errors(findings)
        assert compiled is not None
        studies = {name: self.document.studies[name] for name in ("cycle", self.study)}
        tasks, findings = read_studies(studies)
        raise_errors(findings)
        options = next(task.options for task in tasks if task.study.name == self.study)
        return SampleTask(
            sampled_study(options).sampled_mechanism(compiled), options, self.kernel, self.more, self.reach
        )


class SampleTask:
    """Many samples in one process.

    An atom gives the states of the signals' reductions (``moments.…``); of each sample (samples,) the ``cause`` why it
    lacks a value, one of :attr:`Varied.causes`, -1 for none of these or -2 where it lacks none, and the time (s)
    ``since`` when, NaN where that isn't known; that of a unit's first poses the measures' ``figures`` (figures,
    samples) in SI with their ``verdicts``. Where all values are kept also every value by its variable's name.
    """

    def __init__(
        self,
        compiled: Compiled,
        options: Sampling,
        kernel: str,
        more: Sequence[BoundMeasure] = (),
        reach: Sequence[tuple[float, float]] = (),
    ) -> None:
        self.compiled, self.options, self.kernel, self.reach = compiled, options, kernel, reach
        self.plan = sampled_study(options).draws(compiled, options)
        self.varied = Varied(compiled, self.plan.names)
        stop = span(compiled, options.cycle)[0]
        self.run = Run(compiled, 0.0, stop, options.steps)
        self.signals = SampledSignals(self.run, self.varied, [s.text for s in options.signals(compiled)], kernel)
        measures = [*bound_measures(compiled.quantities, options.measures(compiled)), *more]
        self.figures = SampleFigures(self.run, self.varied, measures, kernel)
        self.cut = Cut(self.plan.samples, self.run.t.size if self.signals.texts else 1)

    @property
    def atoms(self) -> int:
        """How many atoms there are."""
        return self.cut.atoms

    def poses(self, atom: int) -> int:
        """Samples x poses of an atom; where there are only measures, of their unit."""
        return self.cut.size(atom) * (1 if self.signals.texts else self.run.t.size)

    @cached_property
    def reductions(self) -> dict[str, Reduction]:
        """The reductions of signals; where a kernel is compiled, by their compiled twins, to the same bits."""
        fast = self.kernel != "numpy" and machine_code.available()
        return {"moments": Moments(fast)} if self.signals.texts else {}

    @cached_property
    def tallied(self) -> dict[str, Reduction]:
        """The reductions of figures and verdicts."""
        made: dict[str, Reduction] = {"moments": Moments()}
        if self.reach:
            made["histogram"] = Histogram([tuple(fine(*ends, self.options.histogram).tolist()) for ends in self.reach])
            made["fourth"] = Fourth()
        return made

    def perform(self, atom: int) -> Arrays:
        """What comes of an atom."""
        values = self.plan.values(self.cut.unit(atom))
        p = self.varied.parameters(values)
        result: Arrays = {}
        since = np.full(p.shape[1], np.inf)
        if self.signals.texts:
            since = self._signals(atom, p, result)
        bad = since < np.inf
        if self.cut.range(atom) == 0:
            result["figures"], result["verdicts"] = self.figures.evaluate(p)
            bad |= ~np.isfinite(result["figures"]).all(axis=0)
            if self.options.keeps_signals:
                rows = np.concatenate([values, result["figures"]])
                result |= {v.name: row for v, row in zip(self.of_samples(), rows, strict=True)}
        return result | self._causes(p, bad, since)

    def _causes(self, p: Array, bad: NDArray[np.bool_], since: Array) -> Arrays:
        """Why samples lack a value, and since when."""
        cause = np.where(bad, NO_CAUSE, FINE)
        if bad.any():
            failures = self.varied.failures(p[:, bad], self.run.t)
            cause[bad] = failures.cause
            since[bad] = np.where(failures.cause >= 0, failures.time, since[bad])
        return {"cause": cause, "since": np.where(np.isfinite(since), since, np.nan)}

    def _signals(self, atom: int, p: Array, result: Arrays) -> Array:
        """Put the signals of an atom into its result; gives the time (s) at which a sample first lacks one."""
        first, poses = self.cut.sample_slice(atom).start, self.cut.pose_slice(atom)
        count, samples, width = len(self.signals.texts), p.shape[1], poses.stop - poses.start
        since, t = np.full(samples, np.inf), self.run.t[poses]
        tallies = Tallies(self.reductions, count, width)
        kept = np.empty((count, samples, width)) if self.options.keeps_signals else None
        strip = max(1, STRIP // (count * width))
        for start in range(0, samples, strip):
            some = slice(start, min(start + strip, samples))
            y = self.signals.values(p[:, some], poses)
            tallies.add(y, first + start)
            missing = np.logical_not(np.isfinite(y)).any(axis=0)
            since[some] = np.where(np.any(missing, axis=1), t[np.argmax(missing, axis=1)], np.inf)
            if kept is not None:
                kept[:, some] = y
        result |= tallies.state()
        if kept is not None:
            result |= dict(zip(self.signals.texts, kept, strict=True))
        return since

    def of_samples(self) -> list[Variable]:
        """The varied parameters and the figures, as variables of a store: (samples,) in SI."""
        quantities, names = self.compiled.quantities, list(self.plan.names)
        columns = self.figures.columns
        return [
            *(Variable(name, ("sample",), si_unit(quantities.dimensions.of(name)), True) for name in names),
            *(
                Variable(f"{c.name} (measure)" if c.name in names else c.name, ("sample",), si_unit(c.dimension))
                for c in columns
            ),
        ]

    def of_signals(self) -> list[Variable]:
        """The signals likewise: (samples, poses)."""
        dimension = self.compiled.quantities.dimensions.dimension
        return [Variable(text, unit=si_unit(dimension(parse(text)))) for text in self.signals.texts]


class SampledSignals:
    """Signals and expressions of them over many samples, at the poses of a run."""

    def __init__(self, run: Run, varied: Varied, texts: Sequence[str], kernel: str) -> None:
        quantities = run.compiled.quantities
        self.run, self.varied, self.texts, self.kernel = run, varied, tuple(texts), kernel
        parsed = [quantities.dimensions.bind(parse(text), None) for text in texts]
        self.trees: list[Node] = parsed
        self.names = run.signals_of(parsed)
        self._turning = [i for i, name in enumerate(self.names) if run.compiled.graph.wrapped(name)]
        self._plain = [_canonical(run, tree) for tree in parsed] == self.names

    @cached_property
    def _near(self) -> Array:
        """The angles of the nominal motion at all poses, 0 where it has none: (angles, poses)."""
        names = [self.names[i] for i in self._turning]
        return np.nan_to_num(self.run.evaluate(names, self.run.t))

    def values(self, p: Array, poses: slice) -> Array:
        """(expressions, samples, poses) in SI. Angles of links are within half a turn of the nominal motion's."""
        t = self.run.t[poses]
        rows = self.varied.evaluate(self.names, p, t, kernel=self.kernel)
        for i, near in zip(self._turning, self._near[:, poses] if self._turning else (), strict=True):
            rows[i] += 2 * np.pi * whole_turns(rows[i], near)
        if self._plain:
            return rows
        row = dict(zip(self.names, rows, strict=True))
        shape = (p.shape[1], t.size)
        with np.errstate(all="ignore"):
            made = [np.broadcast_to(self._value(tree, row, p, t), shape) for tree in self.trees]
        return np.stack(made) if made else np.empty((0, *shape))

    def _value(self, tree: Node, row: Mapping[str, Array], p: Array, t: Array) -> Any:
        def named(name: Name) -> Any:
            if is_signal(name):
                return row[self.run.canonical(name)]
            return t if name.text == "t" else p[self.varied.row[name.text], :, None]

        return evaluate(tree, named, lambda call: row[self.run.canonical(call)])


def _canonical(run: Run, tree: Node) -> str | None:
    """The name of an expression that is a lone signal."""
    return run.canonical(tree) if isinstance(tree, Name | Call) and is_signal(tree) else None
