"""Registries: things by name, loud on duplicates."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping, MutableMapping
from importlib import import_module
from types import ModuleType
from typing import TypeVar

T = TypeVar("T")


class Registry(MutableMapping[str, T]):
    """A mapping in which a name is set once; a second thing of the same name is a ValueError.

    ``modules`` are those that register the things of some names, which are so imported only when first asked for. The
    import of a module may be interrupted after it has registered a thing. Python forgets such a module, and what it
    registers when it is imported again takes the place of that.
    """

    def __init__(self, modules: Mapping[str, str] | None = None) -> None:
        self.modules = dict(modules or {})
        self._things: dict[str, T] = {}
        self._origins: dict[str, ModuleType | None] = {}

    def __getitem__(self, name: str) -> T:
        if name not in self._things and name in self.modules:
            import_module(self.modules[name])
        return self._things[name]

    def __setitem__(self, name: str, thing: T) -> None:
        module = self.modules.get(name)
        if module is not None and module not in sys.modules:  # another one registers under its name
            import_module(module)
        if name in self._things and not self._comes_again(name, thing):
            raise ValueError(f"{name} is registered twice")
        self._things[name], self._origins[name] = thing, sys.modules.get(_module_of(thing))

    def _comes_again(self, name: str, thing: T) -> bool:
        """Whether a thing is of the module of the one that has its name, which was imported anew since."""
        module = _module_of(thing)
        return module == _module_of(self._things[name]) and self._origins[name] is not sys.modules.get(module)

    def __delitem__(self, name: str) -> None:
        del self._things[name], self._origins[name]

    def __contains__(self, name: object) -> bool:
        return name in self.modules or name in self._things

    def __iter__(self) -> Iterator[str]:
        return iter(dict.fromkeys((*self.modules, *self._things)))

    def __len__(self) -> int:
        return len({*self.modules, *self._things})

    def __repr__(self) -> str:
        return f"Registry({', '.join(self)})"


def _module_of(thing: object) -> str:
    """The module in which a thing, or its class, is defined."""
    return str(getattr(thing, "__module__", ""))
