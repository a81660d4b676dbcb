"""The studies by name; each registers its options, which become part of the file's schema."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, ClassVar, Protocol, runtime_checkable

from pydantic import BaseModel

from linkwright.compilation import Uses
from linkwright.data_classes import dataclass
from linkwright.findings import Finding
from linkwright.kernels import Compiled
from linkwright.model.mechanism import Mechanism
from linkwright.notation.registry import Registry
from linkwright.plugins import load
from linkwright.presentation.blocks import FileOf, StudyReport
from linkwright.results import Result
from linkwright.studies.run_context import RunContext
from linkwright.studies.sections import read_section
from linkwright.words import add


class Outcome(Protocol):
    """What a study's run gives."""

    @property
    def done(self) -> bool:
        """Whether it is all that was asked: it decides the exit code."""

    @property
    def failures(self) -> Sequence[Finding]:
        """Why it isn't."""

    @property
    def warnings(self) -> Sequence[Finding]:
        """What else was found."""

    @property
    def result(self) -> Result | None:
        """The motion that the drawing of a report shows."""


@dataclass(frozen=True)
class Setting:
    """What the command of a study takes as ``--NAME`` in place of what the file says at ``place`` of its options; its
    help is ``cli.NAME`` of the catalogue. Whole numbers have a range from ``low`` on, texts have none."""

    name: str
    place: tuple[str, ...]
    low: int | None = None
    high: int = 10**9
    several: bool = False


@dataclass(frozen=True)
class Command:
    """How a study is performed alone from the command line; ``cli.study.NAME`` of the catalogue says what that does.
    ``work`` is large and can be shared out, ``fresh`` begins anew what was interrupted; without ``writes``, nothing is
    written."""

    settings: Sequence[Setting] = ()
    work: bool = False
    fresh: bool = False
    writes: bool = True


class Study(ABC):
    """A study: its name in the file, its options (``example`` as a file has them), a run that makes an outcome, and
    what the outcome shows."""

    name: ClassVar[str]
    example: ClassVar[str]
    options: ClassVar[type[BaseModel]]
    rank: ClassVar[int] = 100
    """Where it stands among the others in report and summary."""
    files: ClassVar[Mapping[str, FileOf]] = {}
    """What it writes besides, by name."""
    command: ClassVar[Command | None] = None
    """The command that performs it alone, where there is one."""
    words: ClassVar[Mapping[str, Mapping[str, str]]] = {}
    """Texts that the catalogue lacks, by language and key."""
    redundant: ClassVar[bool] = False
    """Whether it takes redundant mechanisms, of which some joints aren't kept by the groups that are solved."""

    def check(self, compiled: Compiled, options: Any) -> list[Finding]:
        """What is wrong with options that are well-formed."""
        return []

    @abstractmethod
    def run(self, compiled: Compiled, options: Any, site: RunContext) -> Any:
        """The study's :class:`Outcome`, performed where ``site`` says."""

    @abstractmethod
    def report(self, outcome: Any) -> StudyReport:
        """What an outcome shows."""

    def stores(self, options: Any) -> Sequence[str]:
        """The names of the folders (Zarr stores, parts of an interrupted study) that it fills while it runs."""
        return ()

    def settle(self, outcome: Any) -> None:
        """All is written."""
        return


@runtime_checkable
class OfStructures(Protocol):
    """A study of mechanisms that aren't driven: it stands alone in its file and brings its own way of compiling one, in
    place of :func:`linkwright.compilation.examine`."""

    def examine(
        self, mechanism: Mechanism, folder: Path | None = None, uses: Uses = ()
    ) -> tuple[Compiled | None, list[Finding]]:
        """Compile a mechanism as far as it goes, with all findings."""


STUDIES: Registry[Study] = Registry(
    {
        "accuracy": "linkwright.studies.accuracy.study",
        "cam": "linkwright.studies.cam.study",
        "cycle": "linkwright.studies.cycle.study",
        "limits": "linkwright.studies.limits.study",
        "modes": "linkwright.studies.modes.study",
        "reactions": "linkwright.studies.reactions.study",
        "sweep": "linkwright.studies.sweep.study",
        "workspace": "linkwright.studies.workspace.study",
    }
)


def register(cls: type) -> type:
    """Register a study under its name; a second one of the same name is an error."""
    study = cls()
    STUDIES[study.name] = study
    for language, texts in study.words.items():
        add(language, texts)
    return cls


@dataclass(frozen=True)
class StudyTask:
    """One study of a file with its parsed options."""

    study: Study
    options: Any


def read_studies(raw: Mapping[str, Mapping[str, Any]]) -> tuple[list[StudyTask], list[Finding]]:
    """The studies that a file names, and what is wrong with their options."""
    if raw.keys() - STUDIES.keys():
        load("studies")
    read, findings = read_section("studies", raw, STUDIES, "study.unknown", "study.options")
    return [StudyTask(study, options) for study, options in read], findings


class Outcomes(dict[str, Any]):
    """Outcomes by the names of their studies. What each shows is made once, for page, summary and terminal alike."""

    def __init__(self, *outcomes: Any, **named: Any) -> None:
        super().__init__(*outcomes, **named)
        self._reports: dict[str, tuple[Any, StudyReport]] = {}

    def ranked(self) -> list[str]:
        """Their names in the order in which report and summary have them."""
        return sorted(self, key=lambda name: STUDIES[name].rank)

    def reports(self) -> list[StudyReport]:
        """What they show, in that order."""
        return [self._report(name) for name in self.ranked()]

    def _report(self, name: str) -> StudyReport:
        outcome, report = self._reports.get(name, (None, None))
        if report is None or outcome is not self[name]:
            report = STUDIES[name].report(self[name])
            self._reports[name] = self[name], report
        return report
