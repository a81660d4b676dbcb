"""The studies by name; each registers its options, which become part of the file's schema."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Protocol

from pydantic import BaseModel

from linkwright.kernels import Compiled
from linkwright.model.findings import Finding
from linkwright.notation.registry import Registry
from linkwright.studies.sections import read_section
from linkwright.studies.site import Site


class Study(Protocol):
    """What a study gives: its name in the file, its options, and a run that makes an outcome.

    One that is about another kind of mechanism than one that is driven brings an ``examine`` of its own, in place of
    :func:`linkwright.kernels.examine`; then it stands alone in its file.
    """

    name: ClassVar[str]
    options: ClassVar[type[BaseModel]]

    def check(self, compiled: Compiled, options: Any) -> list[Finding]:
        """What is wrong with options that are well-formed."""

    def run(self, compiled: Compiled, options: Any, site: Site) -> Any:
        """The study's outcome, performed where ``site`` says."""


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
