"""The keys that may stand at a place of a file, read off the types of its parts."""

from __future__ import annotations

import types
from collections.abc import Iterable, Iterator, Mapping
from typing import Annotated, Any, Union, get_args, get_origin

from pydantic import BaseModel


def keys_at(owner: Any, path: Iterable[str | int], data: Any = None) -> list[str]:
    """The keys of what stands at a path within a part of the type ``owner``; of several kinds that may stand there,
    those of all, or with the part's ``data`` of the one that is meant. Empty where names are free."""
    kinds = [*_kinds(owner, data)]
    for key in path:
        data = data.get(key) if isinstance(data, Mapping) else None
        kinds = [inner for kind in kinds for inner in _inside(kind, key, data)]
    parts = [_fields(kind) for kind in kinds if _is_part(kind)]
    # Of elements those by which a kind is chosen come first, after those of the usual one: a list may be cut short.
    chosen = (kind.kind for kind in kinds if isinstance(getattr(kind, "kind", None), str))
    usual, named = [*parts[:1]], [key for key in chosen if any(key in part for part in parts)]
    return [*dict.fromkeys(key for keys in (*usual, named, *parts) for key in keys)]


def _kinds(annotation: Any, value: Any) -> Iterator[Any]:
    """The types that an annotation allows for a value."""
    origin = get_origin(annotation)
    if origin is Annotated:
        first, *said = get_args(annotation)
        chosen = next((one.kinds(value) for one in said if hasattr(one, "kinds")), None)
        yield from _kinds(first, value) if chosen is None else chosen
    elif origin in (Union, types.UnionType):
        for kind in get_args(annotation):
            yield from _kinds(kind, value)
    else:
        yield annotation


def _inside(kind: Any, key: str | int, value: Any) -> Iterator[Any]:
    """The types of a value that stands under a key of a type."""
    if _is_part(kind):
        if (annotation := _fields(kind).get(str(key))) is not None:
            yield from _kinds(annotation, value)
    elif args := get_args(kind):
        for part in args[1:] if get_origin(kind) is dict else args:
            yield from _kinds(part, value)


def _is_part(kind: Any) -> bool:
    return isinstance(kind, type) and issubclass(kind, BaseModel)


def _fields(kind: type[BaseModel]) -> dict[str, Any]:
    """The annotations of a part's keys, by the names that a file has."""
    return {field.alias or name: field.annotation for name, field in kind.model_fields.items()}
