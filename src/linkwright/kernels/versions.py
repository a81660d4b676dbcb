"""What decides, besides a model and its studies, on the bits of results: versions of all that computes them."""

from __future__ import annotations

from importlib.metadata import version

from linkwright import _version
from linkwright.kernels.registry import KERNELS

LIBRARIES = ("numpy", "scipy")
"""They make, order or evaluate the instructions of every program."""


def versions(kernel: str, *libraries: str) -> dict[str, str]:
    """The versions of linkwright, of libraries and of a kernel, by name. The code that a kernel emits follows from
    them; the processor isn't among them, on which the last bits may depend too."""
    emitted = [kernel, *(f"{package} {version(package)}" for package in KERNELS[kernel].packages)]
    found = {name: version(name) for name in (*LIBRARIES, *libraries)}
    return {"linkwright": _version.__version__, "kernel": " ".join(emitted), **found}
