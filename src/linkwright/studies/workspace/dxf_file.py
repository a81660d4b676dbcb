"""The one curve of a DXF drawing. Every number is looked at before ezdxf sees it: its compiled code never ends on some
that aren't finite."""

from __future__ import annotations

import io
import logging
from codecs import BOM_UTF8
from collections.abc import Callable, Iterator
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright._machine import needed
from linkwright.expressions.written import NO_TEXT
from linkwright.findings import Finding, ModelError, Term
from linkwright.model.csv_file import MAX_TOLD, finite
from linkwright.model.input_files import read_beside
from linkwright.model.quantities import LARGEST

Array = NDArray[np.float64]
Path_ = tuple[str | int, ...]

KINDS = "LWPOLYLINE POLYLINE LINE ARC CIRCLE ELLIPSE SPLINE"
CHORD = 1e-4
"""Arcs and splines become chords that lie within this share of the drawing's extent."""
FARTHEST = 1e9
"""So many times its extent a curve may lie from the origin; farther off its places have too few digits left."""
MAX_POINTS = 100_000
MAX_DEGREE = 25

logging.getLogger("ezdxf").addHandler(logging.NullHandler())  # it notes oddities, which else reach the terminal

_BINARY = b"AutoCAD Binary DXF"
_FLOATS = [(10, 59), (110, 149), (210, 239), (460, 469), (1010, 1059)]
_INTEGERS = [(60, 79), (90, 99), (160, 179), (270, 289), (290, 299), (370, 389), (400, 409), (420, 429), (440, 459)]
_INTEGERS += [(1060, 1071)]
_LIMITS = {
    **{code: LARGEST for first, last in _FLOATS for code in range(first, last + 1)},
    **{code: 2.0**63 for first, last in _INTEGERS for code in range(first, last + 1)},
}
"""Of each group code that holds numbers, the size that they stay below."""


def read_curve(name: str, folder: Path | None, layer: str | None, path: Path_) -> Array:
    """The points (n, 2) of the one curve of a drawing (of a layer) beside the model, in the drawing's unit; ``path`` is
    the place of its name in the model. Raises :class:`ModelError`."""
    needed("ezdxf", "cad")
    content = read_beside(name, folder, path).removeprefix(BOM_UTF8)
    try:
        drawing = _binary(content, name, path) if content.startswith(_BINARY) else _text(content, name, path)
        every = [entity for entity in drawing.modelspace().query(KINDS) if layer in (None, entity.dxf.layer)]
    except ModelError:
        raise
    except Exception as error:  # whatever a file from elsewhere makes a library stumble over
        raise ModelError([Finding("drawing.unreadable", path, {"file": name, "reason": _reason(error)})]) from None
    if len(every) != 1:
        raise ModelError([Finding("workspace.path-drawing", path, {"file": name, "count": len(every)})])
    return _points(every[0], name, path)


def _reason(error: Exception) -> Term | str:
    """Why ezdxf gives up, as far as it says so."""
    told = isinstance(error, (needed("ezdxf", "cad").DXFError, OSError, ValueError))
    return _printable(str(error).replace("(#None)", "")) if told else Term("drawn-inconsistent")


def _printable(text: str) -> str:
    """What a file holds, without what a terminal would obey."""
    return NO_TEXT.sub("?", " ".join(text.split()))[:100].rstrip(".")


def _text(content: bytes, name: str, path: Path_) -> Any:
    """A drawing of text."""
    ezdxf = needed("ezdxf", "cad")
    lines = io.StringIO(content.decode("latin-1"), newline=None).read().split("\n")
    groups = ((2 * i + 1, code, value) for i, (code, value) in enumerate(zip(lines[::2], lines[1::2], strict=False)))
    _refuse(name, path, "line", _faulty_groups(groups))
    heads = needed("ezdxf.filemanagement", "cad").dxf_stream_info(io.StringIO(content.decode("utf-8", "ignore")))
    return ezdxf.read(io.StringIO(content.decode(heads.encoding, "surrogateescape"), newline=None))


def _binary(content: bytes, name: str, path: Path_) -> Any:
    """A binary drawing, of which the groups have numbers instead of lines."""
    tags = list(needed("ezdxf.lldxf.tagger", "cad").binary_tags_loader(content))
    _refuse(name, path, "group", _faulty_groups((i, str(tag.code), str(tag.value)) for i, tag in enumerate(tags)))
    return needed("ezdxf.document", "cad").Drawing.load(iter(tags))


def _faulty_groups(groups: Iterator[tuple[int, str, str]]) -> Iterator[tuple[int, str, str]]:
    """Groups without a code, and those without the finite number that their code asks for: line, code, value."""
    for line, code, value in groups:
        try:
            limit = _LIMITS.get(int(code))
        except ValueError:
            yield line, "", _printable(code)
            return  # what follows is out of step
        if limit is not None and not abs(finite(value.strip())) < limit:
            yield line + 1, code.strip(), _printable(value)
        if value.strip() == "EOF" and int(code) == 0:
            return


def _refuse(name: str, path: Path_, of: str, wrong: Iterator[tuple[int, str, str]]) -> None:
    found = [
        Finding(
            "drawing.number" if code else "drawing.code",
            path,
            {"file": name, "place": Term(f"drawn-{of}", at=at), "code": code, "given": given[:40]},
        )
        for at, code, given in islice(wrong, MAX_TOLD)
    ]
    if found:
        raise ModelError(found)


def _points(entity: Any, name: str, path: Path_) -> Array:
    paths = needed("ezdxf.path", "cad")
    kind = entity.dxftype()

    def refused(reason: Term | str) -> ModelError:
        data = {"file": name, "kind": kind, "handle": _printable(entity.dxf.handle or "-"), "reason": reason}
        return ModelError([Finding("drawing.entity", path, data)])

    try:
        if (reason := SHAPES.get(kind, _any_shape)(entity)) is not None:
            raise refused(Term(f"drawn-{reason}"))
        drawn = paths.make_path(entity)
        places = np.array([(p.x, p.y, p.z) for p in drawn.control_vertices()]).reshape(-1, 3)
        if not (np.abs(places) < LARGEST).all():
            raise refused(Term("drawn-large"))
        extent = max(paths.bbox([drawn]).size) if len(places) else 0.0
        if extent == 0:
            return places[:1, :2]
        if np.abs(places).max() > FARTHEST * extent:
            raise refused(Term("drawn-far", limit=f"{FARTHEST:.0e}"))
        points = [(p.x, p.y) for p in islice(drawn.flattening(CHORD * extent), MAX_POINTS + 1)]
    except ModelError:
        raise
    except Exception as error:  # as above
        raise refused(_reason(error)) from None
    if len(points) > MAX_POINTS:
        raise refused(Term("drawn-long", limit=f"{MAX_POINTS:,}"))
    return np.array(points)


def _any_shape(entity: Any) -> str | None:
    return None


def _arc(entity: Any) -> str | None:
    return None if entity.dxf.radius > 0 else "radius"


def _ellipse(entity: Any) -> str | None:
    if not entity.dxf.major_axis.magnitude > 0:
        return "axis"
    return None if 0 < abs(entity.dxf.ratio) <= 1 else "ratio"


def _spline(entity: Any) -> str | None:
    """ezdxf itself tells of wrong counts."""
    if not 1 <= entity.dxf.degree <= MAX_DEGREE:
        return "degree"
    if (np.diff(entity.knots) < 0).any():
        return "knots"
    return None if all(weight > 0 for weight in entity.weights) else "weights"


SHAPES: dict[str, Callable[[Any], str | None]] = {
    "ARC": _arc,
    "CIRCLE": _arc,
    "ELLIPSE": _ellipse,
    "SPLINE": _spline,
}
"""Of a kind of entity, what would make no curve of it: the phrase that says so."""
