"""Pictures of few colours as PNG (ISO/IEC 15948)."""

from __future__ import annotations

import struct
import zlib

import numpy as np
from numpy.typing import NDArray


def png(colours: NDArray[np.uint8], palette: NDArray[np.uint8]) -> bytes:
    """The file: ``colours`` (rows, columns) number those of the ``palette`` (colours, 3), red, green, blue; the first
    row is on top."""
    rows, columns = colours.shape
    lines = np.concatenate([np.zeros((rows, 1), dtype=np.uint8), colours], axis=1)  # none of the filters
    head = struct.pack(">IIBBBBB", columns, rows, 8, 3, 0, 0, 0)
    body = zlib.compress(lines.tobytes())
    chunks = ((b"IHDR", head), (b"PLTE", palette.tobytes()), (b"IDAT", body), (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(_chunk(*chunk) for chunk in chunks)


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
