"""Registries: things by name, loud on duplicates."""

from __future__ import annotations

from typing import TypeVar

T = TypeVar("T")


class Registry(dict[str, T]):
    """A mapping in which a name is set once; a second thing of the same name is a ValueError."""

    def __setitem__(self, name: str, thing: T) -> None:
        if name in self:
            raise ValueError(f"{name} is registered twice")
        super().__setitem__(name, thing)
