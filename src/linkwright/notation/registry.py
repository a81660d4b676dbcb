"""Registries: things by name, loud on duplicates."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, MutableMapping
from importlib import import_module
from typing import TypeVar

T = TypeVar("T")


class Registry(MutableMapping[str, T]):
    """A mapping in which a name is set once; a second thing of the same name is a ValueError.

    ``modules`` are those that register the things of some names, which are so imported only when first asked for.
    """

    def __init__(self, modules: Mapping[str, str] | None = None) -> None:
        self.modules = dict(modules or {})
        self._things: dict[str, T] = {}

    def __getitem__(self, name: str) -> T:
        if name not in self._things and name in self.modules:
            import_module(self.modules[name])
        return self._things[name]

    def __setitem__(self, name: str, thing: T) -> None:
        if name in self._things:
            raise ValueError(f"{name} is registered twice")
        self._things[name] = thing

    def __delitem__(self, name: str) -> None:
        del self._things[name]

    def __contains__(self, name: object) -> bool:
        return name in self.modules or name in self._things

    def __iter__(self) -> Iterator[str]:
        return iter(dict.fromkeys((*self.modules, *self._things)))

    def __len__(self) -> int:
        return len({*self.modules, *self._things})

    def __repr__(self) -> str:
        return f"Registry({', '.join(self)})"
