"""What the benchmarks share: their common option, and how figures are told."""

from __future__ import annotations

import argparse
import json
from collections.abc import Mapping


def parser(about: str | None) -> argparse.ArgumentParser:
    """A parser with ``--json``, described by a script's docstring."""
    made = argparse.ArgumentParser(description=about)
    made.add_argument("--json", action="store_true", help="print JSON")
    return made


def tell(figures: Mapping[str, float | str], as_json: bool) -> None:
    """Print figures by name, as a table or as JSON."""
    if as_json:
        print(json.dumps(figures, indent=2))
        return
    width = max(map(len, figures))
    for name, value in figures.items():
        print(f"{name:{width}s} {value if isinstance(value, str) else format(value, '.4g'):>12s}")
