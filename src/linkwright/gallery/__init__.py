"""The gallery: commented model files of well-known linkages, which ``linkwright new`` hands out.

One YAML file each beside this module, with English comments; a file more is an entry more. A folder named after another
language, such as ``zh``, holds the same models with comments, name, note and source in that language. Nothing of
linkwright is needed to read them.
"""

from __future__ import annotations

from importlib.resources import files


def names() -> list[str]:
    """The names of all models, in alphabetical order."""
    every = (entry.name for entry in files(__name__).iterdir())
    return sorted(name.removesuffix(".yaml") for name in every if name.endswith(".yaml"))


def text(name: str, language: str = "en") -> str:
    """A model's file as it is shipped, in a language; in English where there is none in that language.

    Raises :class:`KeyError` for a name that isn't in the gallery.
    """
    if name not in names():
        raise KeyError(name)
    file = files(__name__) / language / f"{name}.yaml"
    return (file if file.is_file() else files(__name__) / f"{name}.yaml").read_text(encoding="utf-8")


def title(name: str, language: str = "en") -> str:
    """What a model is, in a line: the comment that its file starts with."""
    return text(name, language).split("\n", 1)[0].removeprefix("# ")
