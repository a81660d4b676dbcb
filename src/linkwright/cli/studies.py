"""The commands that perform one study alone: what each takes is asked of the study where the command is used."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from linkwright.cli import execution
from linkwright.cli.execution import Telling
from linkwright.cli.usage import SuggestingCommand, Whole, option
from linkwright.words import catalogue

if TYPE_CHECKING:
    from linkwright.findings import Finding
    from linkwright.studies.registry import Command, Study

PREFIX = "cli.study."
"""Under it the catalogue says what the command of a study does."""


def names() -> list[str]:
    """The studies that have a command, those of other packages among them."""
    from linkwright.plugins import named

    if named("studies"):
        _known()
    return [key.removeprefix(PREFIX) for key in catalogue() if key.startswith(PREFIX)]


def _known() -> Mapping[str, Study]:
    """All studies."""
    from linkwright.plugins import load
    from linkwright.studies import STUDIES

    load("studies")
    return STUDIES


class StudyCommand(SuggestingCommand):
    """The command of a study. Its options are made where they are asked for: studies are slow imports."""

    def __init__(self, study: str) -> None:
        super().__init__(study, help=f"{PREFIX}{study}", callback=self.perform)
        self.study = study

    def get_params(self, ctx: click.Context) -> list[click.Parameter]:
        """Its argument and options, made first where they aren't yet."""
        if not self.params:
            study = _known()[self.study]
            assert study.command is not None
            self.params = _params(study, study.command)
        return super().get_params(ctx)

    def perform(self, file: Path, **given: Any) -> None:
        """Perform the study of a file, with the values given in place of its own."""
        from linkwright import app
        from linkwright.cli import show

        study = _known()[self.study]
        command, telling = study.command, Telling(**{key.name: given.get(key.name, False) for key in fields(Telling)})
        assert command is not None
        settings = {s.place: given[s.name] for s in command.settings if given[s.name] not in (None, ())}
        examined = app.examine_alone(file, self.study, app.placed(file, self.study, settings))
        if not command.writes:
            with show.working(file, self.study, quiet=telling.as_json):
                job = app.perform(examined)
            execution.end_of_job(job, file, telling)
        asked = [name for name in _file_options(study) if given[name]]
        examined.findings += _lacking(study, asked)
        how = app.Writing(asked, force=given["force"], comments=given["comments"], excel=given["excel"])
        with app.runner_of(given.get("workers"), given.get("cluster")) as runner:
            execution.carry_out(
                examined, file, self.study, given["out"], telling, how, runner, given.get("fresh", False)
            )


def _file_options(study: Study) -> list[str]:
    """The options that speak of files."""
    return [*dict.fromkeys(file.option for file in study.files.values() if file.option)]


def _lacking(study: Study, asked: list[str]) -> list[Finding]:
    """What is missing on this machine for files that are asked for."""
    from linkwright._machine import needed
    from linkwright.findings import ModelError

    found: list[Finding] = []
    for needs in dict.fromkeys(file.needs for file in study.files.values() if file.needs and file.option in asked):
        try:
            needed(*needs)
        except ModelError as error:
            found += error.findings
    return found


def _params(study: Study, command: Command) -> list[click.Parameter]:
    """What a command takes."""
    flags: list[Any] = []
    for setting in command.settings:
        kind = Whole(setting.low, setting.high) if setting.low is not None else None
        more = {"type": kind} if kind else {"metavar": "NAME"}
        flags.append(option(f"--{setting.name}", multiple=setting.several, help=f"cli.{setting.name}", **more))
    if command.writes:
        flags += [execution.OUT, execution.OPEN, execution.FORCE, execution.COMMENTS, execution.EXCEL]
        flags += [option(f"--{name}", is_flag=True, help=f"cli.{name}") for name in _file_options(study)]
    if command.fresh:
        flags.append(option("--fresh", is_flag=True, help="cli.fresh"))
    if command.work:
        flags.append(option("--workers", type=Whole(1, 1024), help="cli.workers"))
        flags.append(option("--cluster", metavar="ADDRESS", help="cli.cluster"))
    flags += [execution.QUIET, execution.VERBOSE, execution.JSON]

    @execution.options(execution.FILE, *flags)
    def taken() -> None:
        """Bears the parameters alone."""

    made: list[click.Parameter] = taken.__click_params__  # type: ignore[attr-defined]
    return [*reversed(made)]
