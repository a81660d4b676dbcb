"""How the sections of a workspace study's options are performed: of each section its function, in one table.

Options are data and know nothing of this. A section is made into a part of the outcome once the workspaces are found;
findings go to the outcome's failures and warnings.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Protocol

from linkwright.studies.workspace.errors_outcome import errors_part
from linkwright.studies.workspace.fits_outcome import required
from linkwright.studies.workspace.options import sections
from linkwright.studies.workspace.outcome import WorkspaceOutcome
from linkwright.studies.workspace.path_outcome import follow
from linkwright.studies.workspace.quality_outcome import quality_part
from linkwright.studies.workspace.trajectories_outcome import trajectories_part


class SectionOutcome(Protocol):
    """What comes of a section."""

    def as_dict(self) -> Any:
        """Its entry in the summary."""


PERFORMERS: Mapping[str, Callable[[Any, WorkspaceOutcome], SectionOutcome]] = {
    "trajectories": trajectories_part,
    "quality": quality_part,
    "errors": errors_part,
    "paths": follow,
    "fits": required,
}
"""By the section's key, what makes its part from the section and the outcome with its workspaces. Files that a section
names lie in ``outcome.compiled.folder``."""


def perform(outcome: WorkspaceOutcome) -> None:
    """Put the parts that are asked for into the outcome, one after the other."""
    for key, section in sections(outcome.options):
        outcome.parts[key] = PERFORMERS[key](section, outcome)
