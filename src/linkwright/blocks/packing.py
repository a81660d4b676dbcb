"""Values packed as named arrays, and unpacked to equal ones, bit by bit: what a checkpoint keeps of a result.

A value is a tree of dataclasses, tuples, lists and dicts with text keys. Its leaves are numbers, text, ``None``, NumPy
arrays and scalars, and Shapely geometries. Arrays and geometries (as WKB) become entries ``0``, ``1`` ... of the packed
arrays; the entry ``tree`` describes the rest as JSON, floats by their bits. Nothing is pickled: reading such arrays
makes dataclasses of one package and runs no code of theirs.

Fields of a dataclass are packed and restored by their names, whatever they are, so a class may gain a field without
an edit here; what was packed before that is then refused. Arrays keep their shape, type and order of axes in memory,
as the order in which sums run may depend on it.
"""

from __future__ import annotations

import json
import struct
from collections.abc import Callable, Mapping
from dataclasses import fields, is_dataclass
from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.blocks.work import Arrays

TREE = "tree"
"""The entry that describes the value; all others are numbered."""
PLAIN = (type(None), bool, int, str)
"""What JSON gives back as it was."""
NOTHING: Mapping[Any, Any] = {}


class UnpackError(ValueError):
    """The arrays aren't what :func:`pack` made, or their dataclasses have changed since."""


def pack(value: Any, outside: Mapping[type, str] = NOTHING) -> Arrays:
    """The arrays of a value. Objects of the types ``outside`` aren't packed, only named: whoever unpacks it gives them.

    Raises :class:`TypeError`, with its place in the tree, for an object of a kind that can't be packed.
    """
    packer = _Packer(outside)
    tree = packer.node(value, "value")
    text = json.dumps(tree, separators=(",", ":")).encode("ascii")
    return {TREE: np.frombuffer(text, dtype=np.uint8)} | packer.arrays


def unpack(arrays: Mapping[str, NDArray[Any]], package: str, outside: Mapping[str, Any] = NOTHING) -> Any:
    """The value that was packed; ``outside`` gives by name what wasn't. Its dataclasses come from ``package`` alone.

    Raises :class:`UnpackError`.
    """
    try:
        return _Unpacker(arrays, package, outside).value(json.loads(np.asarray(arrays[TREE]).tobytes()))
    except UnpackError:
        raise
    except Exception as error:  # whatever may be wrong with a file's content
        raise UnpackError(f"not a packed value: {error!r}") from error


class _Packer:
    """Makes the nodes of a tree, and numbers the arrays on its way. A node is a plain value, or [kind, ...]."""

    def __init__(self, outside: Mapping[type, str]) -> None:
        self.arrays: Arrays = {}
        self._outside = outside
        self._kinds: dict[type, Callable[[Any, str], list[Any]]] = {
            float: lambda value, place: ["float", struct.pack(">d", value).hex()],
            tuple: lambda value, place: ["tuple", *self._entries(value, place)],
            list: lambda value, place: ["list", *self._entries(value, place)],
            dict: self._dict,
            np.ndarray: self._array,
        }

    def node(self, value: Any, place: str) -> Any:
        """The node of a value at a ``place`` of the tree."""
        kind = type(value)
        if kind in PLAIN:
            return value
        if kind in self._outside:
            return ["outside", self._outside[kind]]
        if kind in self._kinds:
            return self._kinds[kind](value, place)
        return self._object(value, place)

    def _entries(self, values: Any, place: str) -> list[Any]:
        return [self.node(value, f"{place}[{i}]") for i, value in enumerate(values)]

    def _dict(self, value: dict[Any, Any], place: str) -> list[Any]:
        if not all(type(key) is str for key in value):
            raise TypeError(f"{place}: a dict with keys that aren't text can't be packed")
        return ["dict", *([key, self.node(entry, f"{place}[{key!r}]")] for key, entry in value.items())]

    def _array(self, value: NDArray[Any], place: str) -> list[Any]:
        """Stored with its axes in the order of memory; the node says how to get back."""
        if value.dtype.hasobject:
            raise TypeError(f"{place}: an array of objects can't be packed")
        order = list(range(value.ndim))
        if value.size and not value.flags.c_contiguous:
            order.sort(key=lambda axis: -abs(value.strides[axis]))
        return ["array", self._numbered(np.array(value.transpose(order), order="C")), *np.argsort(order).tolist()]

    def _object(self, value: Any, place: str) -> list[Any]:
        """Dataclasses, NumPy's scalars and geometries: kinds of many types."""
        import shapely

        kind = type(value)
        if is_dataclass(kind) and "<locals>" not in kind.__qualname__:
            entries = {f.name: self.node(getattr(value, f.name), f"{place}.{f.name}") for f in fields(value)}
            return ["dataclass", f"{kind.__module__}:{kind.__qualname__}", entries]
        if isinstance(value, np.generic) and not np.asarray(value).dtype.hasobject:
            return ["scalar", self._numbered(np.asarray(value))]
        if isinstance(value, shapely.Geometry):
            content = shapely.to_wkb(value, include_srid=True)
            return ["geometry", value.geom_type, self._numbered(np.frombuffer(content, dtype=np.uint8))]
        raise TypeError(f"{place}: a {kind.__name__} can't be packed")

    def _numbered(self, array: NDArray[Any]) -> str:
        number = str(len(self.arrays))
        self.arrays[number] = array
        return number


class _Unpacker:
    """Makes values of the nodes of a tree."""

    def __init__(self, arrays: Mapping[str, NDArray[Any]], package: str, outside: Mapping[str, Any]) -> None:
        self._arrays, self._package, self._outside = arrays, package, outside
        self._kinds: dict[str, Callable[..., Any]] = {
            "float": lambda bits: struct.unpack(">d", bytes.fromhex(bits))[0],
            "tuple": lambda *nodes: tuple(self.value(node) for node in nodes),
            "list": lambda *nodes: [self.value(node) for node in nodes],
            "dict": lambda *entries: {key: self.value(node) for key, node in entries},
            "array": lambda number, *axes: self._arrays[number].transpose(axes),
            "scalar": lambda number: self._arrays[number][()],
            "outside": lambda name: self._outside[name],
            "dataclass": self._dataclass,
            "geometry": self._geometry,
        }

    def value(self, node: Any) -> Any:
        """The value of a node."""
        return self._kinds[node[0]](*node[1:]) if isinstance(node, list) else node

    def _dataclass(self, name: str, entries: dict[str, Any]) -> Any:
        """An object with the fields as they were, without the checks of its making: they passed then."""
        module, _, path = name.partition(":")
        if module.partition(".")[0] != self._package:
            raise UnpackError(f"{name} isn't of {self._package}")
        kind: Any = import_module(module)
        for step in path.split("."):
            kind = getattr(kind, step)
        if not (isinstance(kind, type) and is_dataclass(kind)) or {f.name for f in fields(kind)} != entries.keys():
            raise UnpackError(f"{name} is no dataclass with the fields {', '.join(entries)}")
        made = object.__new__(kind)
        for field, entry in entries.items():
            object.__setattr__(made, field, self.value(entry))  # frozen ones too
        return made

    def _geometry(self, kind: str, number: str) -> Any:
        import shapely

        made = shapely.from_wkb(self._arrays[number].tobytes())
        return shapely.LinearRing(made.coords) if kind == "LinearRing" else made  # which WKB has as a line
