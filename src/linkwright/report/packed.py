"""The data of a live report as its page has them: what recurs stands once, what a page can find is left out.

``web/src/live/packed.ts`` is the other side of it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import islice
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.report.data import LiveData, Plot, Scene

Array = NDArray[np.float64]


APART = {"code", "owners", "groups", "gap"}
"""What stands elsewhere in a page: programs as a script, words with the words."""


def packed_live(live: LiveData) -> dict[str, object]:
    """All but the programs."""
    own: dict[str, object] = {
        key: value for key, value in live.items() if key not in ("code", "owners", "groups", "gap")
    }
    sizes, of_conditions = _unit_sizes(live), [one["size"] or 1.0 for one in live["conditions"]]
    plain = ({key: value for key, value in number.items() if key != "called"} for number in live["numbers"])
    numbers = [{**number, "locked": bool(str(number["locked"]))} for number in plain]
    return {
        **own,
        "times": even(live["times"]),
        "signals": _signals_by_owner(live),
        "sizes": packed(live["sizes"]),
        "units": packed(live["units"]),
        "conditions": {
            "places": [one["place"] for one in live["conditions"]],
            "sizes": packed(of_conditions if {*of_conditions} != {1.0} else []),
        },
        "unit_sizes": sizes,
        "measures": _without_sizes(live["measures"], sizes),
        "numbers": pruned(_without_sizes(numbers, sizes)),
    }


def rounded(times: Sequence[float] | Array) -> Array:
    """Times (s) of few digits, that are the same in a page."""
    return np.array([float(f"{time:.13g}") for time in times])


def pruned(value: Any) -> Any:
    """Plain data without what is empty or false, and without dimensions, which a page doesn't ask."""
    if isinstance(value, Mapping):
        parts = {key: pruned(one) for key, one in value.items() if key != "dimension"}
        return {
            key: one for key, one in parts.items() if one is not None and one is not False and one not in ([], {}, "")
        }
    return [pruned(one) for one in value] if isinstance(value, list) else value


def even(times: Sequence[float]) -> object:
    """Times (s) as their ends and number, where a page finds just these from that; else as they are."""
    first, last, count = times[0], times[-1], len(times)
    found = [first + (last - first) * k / max(count - 1, 1) for k in range(count)]
    return {"from": first, "to": last, "count": count} if rounded(found).tolist() == [*times] else times


def _signals_by_owner(live: LiveData) -> dict[str, object]:
    """The signals of each element: what their names have in common, and which of the lists of endings follows."""
    endings: dict[tuple[str, ...], int] = {}
    owners, rest = [], iter(live["signals"])
    for owner in live["owners"]:
        parts = [name.rpartition(".") for name in islice(rest, owner["count"])]
        stems = {stem for stem, _, _ in parts}
        whole = len(stems) > 1
        own = tuple("".join(part) if whole else part[2] for part in parts)
        stem = "" if whole else stems.pop()
        owners.append([owner["kind"], owner["of"], stem, endings.setdefault(own, len(endings))])
    return {"owners": owners, "endings": [*endings]}


def _unit_sizes(live: LiveData) -> dict[str, float]:
    """The SI sizes of units in which numbers and measures are given; a unit that has several isn't among them."""
    found: dict[str, set[float]] = {}
    sized: list[Mapping[str, Any]] = [*live["numbers"], *live["measures"]]
    for one in sized:
        found.setdefault(one.get("unit", ""), set()).add(float(one["size"]))
    return {unit: sizes.pop() for unit, sizes in found.items() if len(sizes) == 1}


def _without_sizes(parts: Sequence[Mapping[str, Any]], sizes: Mapping[str, float]) -> list[dict[str, Any]]:
    """Numbers or measures without the size of their unit, where that stands among the sizes."""
    return [{k: v for k, v in one.items() if k != "size" or one.get("unit", "") not in sizes} for one in parts]


def packed(values: Sequence[object]) -> dict[str, object]:
    """A list in which few values recur: these, and the number of each entry's."""
    found = list(dict.fromkeys(values))
    return {"of": found, "at": [found.index(value) for value in values]}


def without_values(scene: Scene) -> dict[str, object]:
    """A scene whose values the page computes."""
    links = [{key: value for key, value in link.items() if key != "pose"} for link in scene["links"]]
    traces = [{"name": trace["name"]} for trace in scene["traces"]]
    rolling = [{"link": one["link"], "point": one["point"]} for one in scene.get("centrodes", ())]
    arrows = [{**arrow, "rows": [*map(_without(arrow["name"]), arrow["rows"])]} for arrow in scene.get("arrows", ())]
    return {**scene, "time": [], "links": links, "traces": traces, "centrodes": rolling, "arrows": arrows}


def _without(name: str) -> Callable[[str], str]:
    """What drops the name with which a signal begins."""
    return lambda row: row[len(name) :] if row.startswith(f"{name}.") else row


def without_series(plots: Sequence[Plot]) -> list[dict[str, object]]:
    """Plots whose values the page computes; their titles are words."""
    return [
        {
            "group": plot["group"],
            "unit": plot["unit"],
            "series": [{"name": series["name"]} for series in plot["series"]],
        }
        for plot in plots
    ]
