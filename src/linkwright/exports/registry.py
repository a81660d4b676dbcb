"""The targets by name: what a mechanism can be written for; each registers its options."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from typing import Any, ClassVar, Protocol

from pydantic import BaseModel

from linkwright.data_classes import dataclass
from linkwright.findings import Finding
from linkwright.kernels import Compiled
from linkwright.notation.registry import Registry
from linkwright.studies import RunContext
from linkwright.studies.sections import read_section


@dataclass(frozen=True)
class Exported:
    """What a target gives: contents of files by name, plain values for JSON, and sentences for the terminal.

    Where there are ``failures``, it isn't what was asked; ``files`` may then be missing.
    """

    files: Mapping[str, str | bytes] = field(default_factory=dict)
    summary: Mapping[str, Any] = field(default_factory=dict)
    sentences: Sequence[str] = ()
    failures: list[Finding] = field(default_factory=list)
    warnings: list[Finding] = field(default_factory=list)

    @property
    def done(self) -> bool:
        """Whether the export is what was asked."""
        return not self.failures


class Target(Protocol):
    """A format: its name in ``exports``, the options under it (``example`` as a file has them), and an export that
    makes the contents of its files."""

    name: ClassVar[str]
    example: ClassVar[str]
    options: ClassVar[type[BaseModel]]

    def check(self, compiled: Compiled, options: Any) -> list[Finding]:
        """What is wrong with options that are well-formed, and what of the mechanism the format can't hold."""

    def export(self, compiled: Compiled, options: Any, site: RunContext) -> Exported:
        """The contents of its files. ``site.document`` is the model file, with the options of its studies."""


TARGETS: Registry[Target] = Registry(
    {
        "mjcf": "linkwright.exports.mjcf",
        "motor-expressions": "linkwright.exports.motors",
        "process-simulate": "linkwright.exports.process_simulate",
    }
)


def register(cls: type) -> type:
    """Register a target under its name; a second one of the same name is an error."""
    target = cls()
    TARGETS[target.name] = target
    return cls


@dataclass(frozen=True)
class Order:
    """One export of a file with its parsed options."""

    target: Target
    options: Any


def read_exports(raw: Mapping[str, Mapping[str, Any]]) -> tuple[list[Order], list[Finding]]:
    """The exports that a file names, and what is wrong with their options."""
    read, findings = read_section("exports", raw, TARGETS, "export.unknown", "export.options")
    return [Order(target, options) for target, options in read], findings
