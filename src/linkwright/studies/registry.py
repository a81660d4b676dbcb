"""The studies by name; each registers its options, which become part of the file's schema."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar, Protocol, runtime_checkable

from pydantic import BaseModel

from linkwright.compilation import Uses
from linkwright.findings import Finding
from linkwright.kernels import Compiled
from linkwright.model.mechanism import Mechanism
from linkwright.notation.registry import Registry
from linkwright.studies.sections import read_section
from linkwright.studies.site import Site


class Study(Protocol):
    """What a study gives: its name in the file, its options (``example`` as a file has them), and a run that makes an
    outcome."""

    name: ClassVar[str]
    example: ClassVar[str]
    options: ClassVar[type[BaseModel]]

    def check(self, compiled: Compiled, options: Any) -> list[Finding]:
        """What is wrong with options that are well-formed."""

    def run(self, compiled: Compiled, options: Any, site: Site) -> Any:
        """The study's outcome, performed where ``site`` says."""


@runtime_checkable
class OfStructures(Protocol):
    """A study of mechanisms that aren't driven: it stands alone in its file and brings its own way of compiling one, in
    place of :func:`linkwright.compilation.examine`."""

    def examine(
        self, mechanism: Mechanism, folder: Path | None = None, uses: Uses = ()
    ) -> tuple[Compiled | None, list[Finding]]:
        """Compile a mechanism as far as it goes, with all findings."""


STUDIES: Registry[Study] = Registry()


def register(cls: type) -> type:
    """Register a study under its name; a second one of the same name is an error."""
    study = cls()
    STUDIES[study.name] = study
    return cls


@dataclass(frozen=True)
class Task:
    """One study of a file with its parsed options."""

    study: Study
    options: Any


def read_studies(raw: Mapping[str, Mapping[str, Any]]) -> tuple[list[Task], list[Finding]]:
    """The studies that a file names, and what is wrong with their options."""
    read, findings = read_section("studies", raw, STUDIES, "study.unknown", "study.options")
    return [Task(study, options) for study, options in read], findings
