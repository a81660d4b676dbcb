"""The section ``errors`` of a workspace study's options: what the file's tolerances and clearances do to the point, and
leave of each region. What deviates, and how, is stated as for the accuracy study: in the parameters, and in that study
if there is one."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Annotated, ClassVar, Self

from pydantic import Field, PrivateAttr, ValidationError, ValidationInfo, model_validator

from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Text
from linkwright.expressions.typed_fields import Quantity
from linkwright.expressions.unknown import unknown
from linkwright.findings import Finding, Term
from linkwright.kernels import Compiled
from linkwright.model.mechanism import Mechanism
from linkwright.studies.accuracy.clearance import PATH as CLEARANCES
from linkwright.studies.accuracy.clearance_contacts import loose_joints
from linkwright.studies.accuracy.clearance_options import check_clearances
from linkwright.studies.accuracy.stated_contributors import check_contributors, contributors
from linkwright.studies.accuracy.stated_options import DeviationOptions
from linkwright.studies.accuracy.tolerance_reader import PATH as ACCURACY
from linkwright.studies.workspace.causes import Causes
from linkwright.studies.workspace.errors import KINDS
from linkwright.studies.workspace.maps_options import MapsAsked, limit

if TYPE_CHECKING:
    from linkwright.studies.workspace.options import WorkspaceOptions


class ErrorsOptions(MapsAsked):
    """The working point's errors, and the part of each region that is sure."""

    section: ClassVar[str] = "errors"

    limit: Annotated[Expression | None, Quantity(u.LENGTH)] = None
    contributors: tuple[Text, ...] | None = Field(None, min_length=1, max_length=1000)
    _stated: DeviationOptions | None = PrivateAttr(None)

    @model_validator(mode="after")
    def _beside(self, info: ValidationInfo) -> Self:
        """The accuracy study of the file says more of deviations; of a wrong one it tells itself."""
        given = (info.context or {}).get("accuracy") or {}
        own = {key: given[key] for key in DeviationOptions.model_fields if key in given}
        try:
            self._stated = DeviationOptions.model_validate(own)
        except ValidationError:
            self._stated = None
        return self

    @property
    def deviation_options(self) -> DeviationOptions | None:
        """What the file says of deviations and clearances, ``None`` where that is wrong."""
        return self._stated

    def kinds_in(self, mechanism: Mechanism) -> Mapping[str, u.Dimension]:
        return KINDS

    def check(self, compiled: Compiled, options: WorkspaceOptions) -> Iterator[Finding]:
        """What is wrong with what deviates, the limit, the maps' names."""
        yield from self.check_drives(compiled)
        if len(compiled.graph.drives) != 2 or self._stated is None:
            return
        if self.limit is not None:
            yield from limit(compiled, self.limit, u.LENGTH, (*self.path, "limit"), Term("limit-error"))[1]
        yield from self.check_maps(compiled, KINDS)
        wrong = [*_deviation_faults(compiled, self._stated)]
        yield from (self._as_own_finding(finding) for finding in wrong)
        if not wrong:
            known = causes(compiled, self._stated).names
            for i, name in enumerate(self.contributors or ()):
                if name not in known:
                    yield unknown("contributor", (*self.path, "contributors", i), name, known)

    def _as_own_finding(self, finding: Finding) -> Finding:
        """That nothing deviates is told of this section."""
        return Finding(finding.code, self.path, finding.data) if finding.path == ACCURACY else finding


def _deviation_faults(compiled: Compiled, stated: DeviationOptions) -> Iterator[Finding]:
    """What is wrong with tolerances and clearances."""
    yield from check_contributors(compiled, stated)
    yield from check_clearances(compiled, stated.clearances, CLEARANCES)


def causes(compiled: Compiled, stated: DeviationOptions) -> Causes:
    """All that deviates, and the joints with clearance, where nothing is wrong with them."""
    return Causes(contributors(compiled, stated), tuple(loose_joints(compiled, stated.clearances)))
