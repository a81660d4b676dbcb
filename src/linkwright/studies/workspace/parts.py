"""What a workspace study may be asked besides its regions: sections of its options, each of which makes a part of the
outcome."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, Protocol

from linkwright.findings import Finding
from linkwright.kernels import Compiled
from linkwright.studies.site import Site

if TYPE_CHECKING:
    from linkwright.studies.workspace.options import WorkspaceOptions
    from linkwright.studies.workspace.outcome import WorkspaceOutcome

SECTIONS: tuple[str, ...] = ("trajectories", "quality", "errors", "paths", "fits")
"""The keys of the sections among the study's options, in the order in which they are performed and shown."""


class Section(Protocol):
    """A section of the options: a pydantic model that checks itself against the mechanism, and performs itself."""

    def check(self, compiled: Compiled, options: WorkspaceOptions) -> Iterator[Finding]:
        """What is wrong with it; ``options`` are those of the whole study."""

    def perform(self, outcome: WorkspaceOutcome, site: Site) -> Any:
        """The part: it has ``as_dict()``, its entry in the summary. The outcome has its workspaces; findings go to its
        failures and warnings. ``outcome.compiled.folder`` is where the files lie that the
        section names."""


def sections(options: WorkspaceOptions) -> list[tuple[str, Section]]:
    """The sections that are given, by key."""
    return [(key, section) for key in SECTIONS if (section := getattr(options, key)) is not None]
