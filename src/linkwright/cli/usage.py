"""Commands and options, whose help is a key of the catalogue; of those that don't exist, which may be meant."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import Any

import click

from linkwright.cli.language import use_language
from linkwright.words import LANGUAGES, say


class TranslatedHelp:
    """Has a help text in the language of the moment; it is set by its key of the catalogue."""

    _help: str | None = None

    @property
    def help(self) -> str | None:
        """The text."""
        return self._help and say(self._help)

    @help.setter
    def help(self, key: str | None) -> None:
        self._help = key


class Option(TranslatedHelp, click.Option):
    """An option."""


class Whole(click.IntRange):
    """A whole number in a range, which has a name in each language."""

    @property
    def name(self) -> str:  # type: ignore[override]
        """What it is called."""
        return say("click.whole")


option = partial(click.option, cls=Option)
"""Declares an option; ``help`` is a key of the catalogue."""


LANGUAGE = Option(
    ["--lang"], type=click.Choice(LANGUAGES), expose_value=False, is_eager=True, callback=use_language, help="cli.lang"
)
"""Of every command: the language of what it shows and writes."""


class TranslatedCommand(TranslatedHelp, click.Command):
    """What all commands have in common."""

    def get_params(self, ctx: click.Context) -> list[click.Parameter]:
        """Its arguments and options, the language before ``--help``."""
        *own, help_option = super().get_params(ctx)
        return [*own, LANGUAGE, help_option]

    def get_short_help_str(self, limit: int = 45) -> str:
        """The first sentence of its help."""
        first, stop, _ = (self.help or "").partition("。")
        return f"{first}{stop}" if stop else super().get_short_help_str(limit)


_DASHES = ("－", "—", "–", "―", "−")
"""What Chinese keyboards and word processors write for the hyphens of an option."""


class SuggestingCommand(TranslatedCommand):
    """A command that names the option that may be meant."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Parse the arguments. Raises :class:`click.UsageError`."""
        if (word := next((word for word in args if word.startswith(_DASHES)), None)) and not Path(word).exists():
            raise click.UsageError(say("cli.dashes", given=word, meant=f"--{word.lstrip(''.join(_DASHES))}"), ctx)
        try:
            return super().parse_args(ctx, args)
        except click.NoSuchOption as error:
            from linkwright.expressions.unknown import near

            known = [name for option in self.get_params(ctx) for name in option.opts if name.startswith("--")]
            hint = near(error.option_name, known, listed=True)
            text = say("cli.no-option", command=ctx.command_path, name=error.option_name, near=hint)
            raise click.UsageError(text, ctx) from None


class CommandGroup(TranslatedCommand, click.Group):
    """Commands of which one that isn't there is told with those that may be meant."""

    command_class = SuggestingCommand

    def resolve_command(self, ctx: click.Context, args: list[str]) -> Any:
        """The command that is asked for. Raises :class:`click.UsageError`."""
        name = args[0]
        if self.get_command(ctx, name) is None and not name.startswith("-") and not ctx.resilient_parsing:
            raise click.UsageError(_no_command(name, self.list_commands(ctx)), ctx)
        return super().resolve_command(ctx, args)


def _no_command(name: str, commands: list[str]) -> str:
    """What is said of a word at the place of a command."""
    from linkwright import gallery
    from linkwright.exports import TARGETS
    from linkwright.expressions.unknown import near
    from linkwright.studies import STUDIES

    if Path(name).is_file() or name.endswith((".yaml", ".yml")):
        return say("cli.file-alone", name=name)
    if name in STUDIES:
        return say("cli.study-alone", name=name, example=STUDIES[name].example)
    if name in TARGETS:
        return say("cli.target-alone", name=name)
    if name in gallery.names():
        return say("cli.gallery-alone", name=name)
    return say("cli.no-command", name=name, near=near(name, commands, listed=True))
