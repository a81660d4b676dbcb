"""The gallery: commented model files of well-known linkages, which ``linkwright new`` hands out.

One YAML file each beside this module; a file more is an entry more. Nothing of linkwright is needed to read them.
"""

from __future__ import annotations

from importlib.resources import files


def names() -> list[str]:
    """The names of all models, in alphabetical order."""
    every = (entry.name for entry in files(__name__).iterdir())
    return sorted(name.removesuffix(".yaml") for name in every if name.endswith(".yaml"))


def text(name: str) -> str:
    """A model's file as it is shipped. Raises :class:`KeyError` for a name that isn't in the gallery."""
    if name not in names():
        raise KeyError(name)
    return (files(__name__) / f"{name}.yaml").read_text(encoding="utf-8")


def title(name: str) -> str:
    """What a model is, in a line: the comment that its file starts with."""
    return text(name).split("\n", 1)[0].removeprefix("# ")
