"""The studies by name; each registers its options, which become part of the file's schema."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Protocol

from pydantic import BaseModel, ValidationError

from linkwright.kernels import Compiled
from linkwright.model.faults import written
from linkwright.model.findings import Finding
from linkwright.model.unknown import near
from linkwright.notation.registry import Registry
from linkwright.studies.site import Site


class Study(Protocol):
    """What a study gives: its name in the file, its options, and a run that makes an outcome."""

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
    """The studies that a file names, and what is wrong with their options.

    Options may look at those of the other studies: these are the context of their validation.
    """
    tasks, findings = [], []
    for name, entry in raw.items():
        study = STUDIES.get(name)
        if study is None:
            findings.append(Finding("study.unknown", ("studies", name), {"name": name, "near": near(name, [*STUDIES])}))
            continue
        try:
            tasks.append(Task(study, study.options.model_validate(entry, context=raw)))
        except ValidationError as error:
            findings += [_wrong_option(name, entry, fault) for fault in error.errors(include_url=False)]
    return tasks, findings


def _wrong_option(study: str, entry: Mapping[str, Any], fault: Any) -> Finding:
    """A fault of an option as a finding: its own where the option has one, else what the type wants."""
    missing = fault["loc"][-1:] if fault["type"] == "missing" else ()
    path = ("studies", study, *written(fault["loc"], entry), *missing)
    if fault["type"] == "finding":
        context = dict(fault["ctx"])
        return Finding(context.pop("code"), path, context)
    key = ".".join(map(str, path[2:]))
    return Finding("study.options", path, {"study": study, "key": key, "reason": fault["msg"]})
