"""The section ``errors`` of a workspace study's options: what the file's tolerances and clearances do to the point, and
leave of each region. What deviates, and how, is stated as for the accuracy study: in the parameters, and in that study
if there is one."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from copy import copy
from typing import TYPE_CHECKING, Annotated, ClassVar, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, PrivateAttr, ValidationError, ValidationInfo, model_validator

from linkwright.findings import Finding, ModelError, Term, raise_errors
from linkwright.kernels import Compiled
from linkwright.model import units as u
from linkwright.model.fields import Expression, Text
from linkwright.model.mechanism import Mechanism
from linkwright.model.typed_fields import Quantity
from linkwright.model.unknown import unknown
from linkwright.studies.accuracy.clearance import PATH as CLEARANCES
from linkwright.studies.accuracy.clearance_options import check_clearances
from linkwright.studies.accuracy.contributors import Contributors
from linkwright.studies.accuracy.options import AccuracyOptions
from linkwright.studies.accuracy.reader import PATH as ACCURACY
from linkwright.studies.accuracy.seats import held
from linkwright.studies.accuracy.stated import check_contributors, contributors
from linkwright.studies.site import Site
from linkwright.studies.workspace.causes import Causes
from linkwright.studies.workspace.errors import KINDS, errors
from linkwright.studies.workspace.errors_part import ErrorsPart, RegionErrors
from linkwright.studies.workspace.guaranteed import guaranteed
from linkwright.studies.workspace.maps_asked import MapsAsked, positive
from linkwright.studies.workspace.outcome import Workspace

if TYPE_CHECKING:
    from linkwright.studies.workspace.options import WorkspaceOptions
    from linkwright.studies.workspace.outcome import WorkspaceOutcome

Array = NDArray[np.float64]

USUAL = ("error worst",)
STATED = ("parameters", "general", "distribution", "cp", "correlations", "thermal", "clearances")
"""What the accuracy study says of deviations and clearances."""


class ErrorsOptions(MapsAsked):
    """The working point's errors, and the part of each region that is sure."""

    section: ClassVar[str] = "errors"

    limit: Annotated[Expression | None, Quantity(u.LENGTH)] = Field(
        None, description="the error up to which a place counts as precise"
    )
    contributors: tuple[Text, ...] | None = Field(
        None,
        min_length=1,
        max_length=1000,
        description="what deviates; all with a tolerance, and all joints with a clearance, by default",
    )
    _stated: AccuracyOptions | None = PrivateAttr(None)

    @model_validator(mode="after")
    def _beside(self, info: ValidationInfo) -> Self:
        """The accuracy study of the file says more of deviations; of a wrong one it tells itself."""
        given = (info.context or {}).get("accuracy") or {}
        own = {key: given[key] for key in STATED if key in given}
        try:
            self._stated = AccuracyOptions.model_validate(own, context={"cycle": {"period": "1 s"}})
        except ValidationError:
            self._stated = None
        return self

    def kinds_in(self, mechanism: Mechanism) -> Mapping[str, u.Dimension]:
        return KINDS

    def check(self, compiled: Compiled, options: WorkspaceOptions) -> Iterator[Finding]:
        """What is wrong with what deviates, the limit, the maps' names."""
        yield from self.check_drives(compiled)
        if len(compiled.graph.drives) != 2 or self._stated is None:
            return
        if self.limit is not None:
            found = positive(compiled, self.limit, u.LENGTH, (*self.path, "limit"), Term("limit-error"))
            yield from [found] if isinstance(found, Finding) else []
        yield from self.check_maps(compiled, KINDS)
        wrong = [*_wrong(compiled, self._stated)]
        yield from (self._own(finding) for finding in wrong)
        if not wrong:
            known = causes(compiled, self._stated).names
            for i, name in enumerate(self.contributors or ()):
                if name not in known:
                    yield unknown("contributor", (*self.path, "contributors", i), name, known)

    def _own(self, finding: Finding) -> Finding:
        """That nothing deviates is told of this section."""
        return Finding(finding.code, self.path, finding.data) if finding.path == ACCURACY else finding

    def perform(self, outcome: WorkspaceOutcome, site: Site) -> ErrorsPart:
        """The error maps of each region, and its guaranteed part."""
        compiled = outcome.compiled
        limit = None if self.limit is None else compiled.quantities.value(self.limit, u.LENGTH)
        part = ErrorsPart(outcome, self.steps, self.shown(USUAL), self.lines(compiled, KINDS), limit)
        assert outcome.box is not None
        for workspace in outcome.workspaces:
            try:
                who = self._causes(compiled, workspace)
            except ModelError as error:  # a class may have no tolerance for a length that is varied
                outcome.failures += error.findings
                continue
            for reached in workspace.regions:
                maps = errors(reached.region.sheet, outcome.box, who, self.steps)
                sure = guaranteed(reached.region, who, limit, self.steps)
                part.regions.append(RegionErrors(workspace, reached, maps, maps.ends(), who, sure))
        return part

    def _causes(self, compiled: Compiled, workspace: Workspace) -> Causes:
        """What deviates where parameters have the values of a workspace."""
        assert self._stated is not None
        if workspace.regions:
            compiled = at_values(compiled, workspace.regions[0].region.sheet.parameters)
            raise_errors([*check_clearances(compiled, self._stated.clearances, CLEARANCES)])
        return chosen(causes(compiled, self._stated), self.contributors)


def at_values(compiled: Compiled, parameters: Array) -> Compiled:
    """A mechanism whose numbers are read at other values of its parameters; not one to run."""
    other, quantities = copy(compiled), copy(compiled.quantities)
    quantities.parameters = dict(zip(compiled.graph.parameters, parameters.tolist(), strict=True))
    other.quantities = quantities
    return other


def _wrong(compiled: Compiled, stated: AccuracyOptions) -> Iterator[Finding]:
    """What is wrong with tolerances and clearances."""
    yield from check_contributors(compiled, stated)
    yield from check_clearances(compiled, stated.clearances, CLEARANCES)


def causes(compiled: Compiled, stated: AccuracyOptions) -> Causes:
    """All that deviates, and the joints with clearance, where nothing is wrong with them."""
    return Causes(contributors(compiled, stated), tuple(held(compiled, stated.clearances)))


def chosen(every: Causes, names: Sequence[str] | None) -> Causes:
    """Some of them by name, with the correlations between contributors."""
    if names is None:
        return every
    known = every.contributors
    rows = [i for i, name in enumerate(known.names) if name in names]
    some = Contributors(tuple(known.every[i] for i in rows), known.correlation[np.ix_(rows, rows)], known.parameters)
    return Causes(some, tuple(one for one in every.held if one.joint in names))
