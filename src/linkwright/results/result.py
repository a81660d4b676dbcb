"""Results: named arrays of a run with their units, reached by signal name or expression."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import field
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright._machine import needed
from linkwright.compilation.undetermined_uses import undetermined_in
from linkwright.data_classes import dataclass
from linkwright.expressions.dimensions import DimensionError
from linkwright.expressions.language import Call, ExpressionError, Name, parse
from linkwright.expressions.units import Dimension
from linkwright.findings import Finding, ModelError, Term
from linkwright.model.output_files import write_aside
from linkwright.results.certificate import Certificate
from linkwright.results.dataset import Dataset, Variable, described, si_unit, times, variable_of
from linkwright.results.run import Run

Array = NDArray[np.float64]

NO_FORCE = 1e-9
"""Below this share of its largest normal force a slide has no line of action."""


@dataclass
class Result:
    """A run's signals at its sampled times.

    ``result["E.x"]`` is the array of a signal or of any expression of signals, in SI, shape (times,);
    ``result.shown("E.x")`` the same in the model's own unit with that unit; a name or expression that can't be
    read raises :class:`ModelError`. ``failures`` says where the motion
    can't be followed; there the arrays hold NaN. ``certificate`` is ``None`` only then.
    """

    run: Run
    failures: list[Finding] = field(default_factory=list)
    certificate: Certificate | None = None

    @property
    def t(self) -> Array:
        """The sampled times (s)."""
        return self.run.t

    def thinned(self, steps: int) -> Result:
        """The same run looked at on at most ``steps`` steps, for a drawing."""
        if self.run.steps <= steps:
            return self
        run = Run(self.run.compiled, self.run.start, self.run.stop, steps)
        return Result(run, self.failures, self.certificate)

    def at(self, times: Array) -> Result:
        """The same run looked at at other times (s), ascending from its start to its end."""
        run = Run(self.run.compiled, self.run.start, self.run.stop, times.size - 1)
        run.t = times
        return Result(run, self.failures, self.certificate)

    @cached_property
    def names(self) -> tuple[str, ...]:
        """All signals of the mechanism."""
        return tuple(self.run.compiled.quantities.signals.by_text)

    @cached_property
    def _values(self) -> dict[str, Array]:
        values = dict(zip(self.names, self.run.evaluate(self.names, self.t), strict=True))
        for name in self.names:
            if name.endswith(").arm"):  # of a reaction
                normal = np.abs(values[name[: -len("arm")] + "normal"])
                values[name] = np.where(normal > NO_FORCE * np.fmax.reduce(normal, initial=0.0), values[name], np.nan)
        return values

    def __getitem__(self, text: str) -> Array:
        if text in self._values:
            return self._values[text]
        with _read(text):
            node = self.run.compiled.quantities.dimensions.bind(parse(text), None)
        if (name := undetermined_in(self.run.compiled, parse(text))) is not None:
            raise ModelError([Finding("stiffness.undetermined", (text[:60],), {"signal": name})])
        return np.asarray(self.run.jets(node, self.t).d[0])

    def dimension(self, text: str) -> Dimension:
        """The dimension of a signal or expression. Raises :class:`ModelError` for what isn't one."""
        if (signal := self.run.compiled.quantities.signals.by_text.get(text)) is not None:
            return signal.dimension
        with _read(text):
            return self.run.compiled.quantities.dimensions.dimension(parse(text))

    def shown(self, text: str) -> tuple[Array, str]:
        """A signal or expression in the model's declared unit, and that unit (arrays of shape (times,))."""
        unit, size = self.run.compiled.quantities.unit_of(self.dimension(text))
        return self[text] / size, unit

    def element(self, name: str) -> dict[str, Array]:
        """All signals of one element by attribute, in SI: ``result.element("E")["vx"]``, of ``force(a, b)`` too.

        Raises :class:`ModelError` for a name that no element has.
        """
        signals = self.run.compiled.quantities.signals
        with _read(name):
            node = parse(name)
            if not isinstance(node, Name | Call):
                raise DimensionError("signal.unknown", name=name, hint=Term("signal-forms"))
            _, _, attributes = signals.element(node)
        return {attribute: self[f"{name}.{attribute}"] for attribute in attributes}

    def si(self, text: str) -> tuple[Array, str]:
        """A signal or expression in SI with its SI unit ("" for a plain number)."""
        return self[text], si_unit(self.dimension(text))

    def dataset(self, more: Sequence[str] = (), warnings: Sequence[Finding] = ()) -> Dataset:
        """All signals over the time, and ``more``: further signals (those of poles) or expressions.

        Among its facts are the certificate's figures and all findings: the failures and ``warnings``, such as those of
        a cycle.
        """
        return Dataset(self._variables(more), self._facts(warnings))

    def to_csv(self, path: str | Path | None = None, more: Sequence[str] = ()) -> str:
        """:meth:`dataset` as a table in the model's units, one row a time; blank where nothing is known."""
        text = Dataset(self._variables(more)).csv("time")
        assert text is not None
        if path is not None:
            write_aside(Path(path), text)
        return text

    def to_netcdf(self, path: str | Path, more: Sequence[str] = (), warnings: Sequence[Finding] = ()) -> None:
        """:meth:`dataset` as a netCDF file in SI."""
        write_aside(Path(path), self.dataset(more, warnings).netcdf())

    def to_xarray(self, more: Sequence[str] = ()) -> Any:
        """:meth:`dataset` as an xarray Dataset over ``time`` (s), in SI, with units as attributes.

        Raises :class:`ModelError` where xarray isn't installed.
        """
        return self.dataset(more).xarray(needed("xarray", "xarray"))

    def _variables(self, more: Sequence[str]) -> list[Variable]:
        quantities, names = self.run.compiled.quantities, (*self.names, *more)
        made = [variable_of(quantities, name, "time", self[name], self.dimension(name)) for name in names]
        return [times(quantities, self.t), *made]

    def _facts(self, warnings: Sequence[Finding]) -> dict[str, Any]:
        facts: dict[str, Any] = {**described(self.run.compiled, (*self.failures, *warnings))}
        c = self.certificate
        if c is None:
            return facts
        figures = {**c.residuals, "mobility": c.mobility, "gruebler": c.gruebler, "rank": c.rank, "poses": c.poses}
        if c.nearest is not None:
            figures |= {"smallest_determinant": c.nearest.determinant, "smallest_determinant_time": c.nearest.time}
            facts["certificate_smallest_determinant_group"] = c.nearest.group
        facts |= {f"certificate_{name}": figure for name, figure in figures.items()}
        facts["certificate_branches"] = "; ".join(str(rule) for rule in c.branches.values() if rule) or "none"
        return facts


@contextmanager
def _read(text: str) -> Iterator[None]:
    """What is wrong with an expression, as a finding."""
    try:
        yield
    except DimensionError as error:
        raise ModelError([Finding(error.key, (text,), error.data)]) from None
    except ExpressionError as error:
        from linkwright.expressions.respelled import syntax_fault

        code, data = syntax_fault(text, error.reason)
        raise ModelError([Finding(code, (text,), data)]) from None
